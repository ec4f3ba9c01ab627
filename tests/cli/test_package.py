"""The Debian package, and what an install puts beside the program."""

import gzip
import hashlib
import json
import os
import re
import shutil
import subprocess

import pytest
from harness import check

BUILD = os.path.dirname(os.path.dirname(os.environ["VVR"]))


def needs(*programs):
    for program in programs:
        if not shutil.which(program):
            pytest.skip(f"needs {program}")


def test_installed_services_name_the_installed_program(t):
    prefix = t.path("there")
    done = t.run(["cmake", "--install", BUILD, "--prefix", str(prefix)])
    check(done.status == 0, str(done))
    units = prefix / "lib/systemd/system"
    names = ["vvr-archive.service", "vvr-archive.timer", "vvr-watch@.service"]
    check(sorted(unit.name for unit in units.iterdir()) == names, f"{list(units.iterdir())}")
    for name in names[::2]:
        found = re.search(r"^ExecStart=(\S+) (\S+) ", (units / name).read_text(), flags=re.MULTILINE)
        check(found[1] == str(prefix / "bin/vvr") and found[2] in name, found[0])
    check((prefix / "lib/sysusers.d/vvr.conf").read_text().startswith("u vvr - "), "the services' user")
    if shutil.which("systemd-analyze"):
        # A template is checked as one of its instances.
        (units / names[2]).rename(units / "vvr-watch@gate.service")
        done = t.run(["systemd-analyze", "verify", "--man=no", units / names[1], units / "vvr-watch@gate.service"])
        check("vvr-" not in done.err, str(done))


@pytest.fixture(name="package")
def made_package(t):
    """The package, unpacked: its control file, and the folder of its files."""
    needs("cpack", "dpkg-deb", "dpkg-shlibdeps")
    done = t.run(["cpack", "--config", f"{BUILD}/CPackConfig.cmake", "-G", "DEB", "-B", str(t.path("made"))], timeout=600)
    check(done.status == 0, str(done))
    (deb,) = t.path("made").glob("*.deb")
    subprocess.run(["dpkg-deb", "-R", deb, t.path("tree")], check=True)
    return deb, t.path("tree")


@pytest.mark.slow
def test_package_holds_what_debian_wants(t, package):
    deb, tree = package
    control = (tree / "DEBIAN/control").read_text()
    depends = re.search(r"^Depends: (.*)", control, flags=re.MULTILINE)[1]
    opened = re.findall(r"^run: (\S+)", (t.source / "scripts/packages.txt").read_text(), flags=re.MULTILINE)
    check(len(opened) == 5, f"{opened}")
    # Of what is linked: a library of the program, and one that its plugin alone has.
    for name in [*opened, "libavformat", "libopenimageio"]:
        check(name in depends, f"{name} is not in {depends}")
    docs = tree / "usr/share/doc/vvr"
    for name in ("usr/bin/vvr", "usr/lib/vvr/libvvr_pictures.so", "usr/share/doc/vvr/docs/cli.md",
                 "usr/share/man/man1/vvr-render.1.gz", "usr/share/bash-completion/completions/vvr",
                 "usr/share/zsh/vendor-completions/_vvr", "usr/share/fish/vendor_completions.d/vvr.fish"):
        check((tree / name).is_file(), f"{name} is not in the package")
    check("Redistribution and use" in (docs / "copyright").read_text(), "the license")
    check(b"vvr (" in gzip.decompress((docs / "changelog.Debian.gz").read_bytes()), "Debian's changelog")
    check("ExecStart=/usr/bin/vvr " in (tree / "usr/lib/systemd/system/vvr-archive.service").read_text(), "the unit")
    if shutil.which("lintian"):
        done = t.run([t.source / "scripts/package", "--lint", deb])
        check(done.status == 0, str(done))
        (tree / "usr/share/doc/vvr/copyright").unlink()
        subprocess.run(["dpkg-deb", "-b", tree, t.path("bad.deb")], check=True)
        done = t.run([t.source / "scripts/package", "--lint", t.path("bad.deb")])
        check(done.status != 0 and "no-copyright-file" in done.out, str(done))


@pytest.mark.slow
def test_unpacked_package_draws(t, package):
    _, tree = package
    t.clip()
    done = t.run([tree / "usr/bin/vvr", "render", "clip.avi", "-o", "out.png", "--size", "160x100"])
    check(done.status == 0, str(done))
    t.expect_picture()


SPDX = {  # the parts of SPDX 2.3 that scripts/sbom uses, as its specification has them
    "type": "object",
    "required": ["spdxVersion", "dataLicense", "SPDXID", "name", "documentNamespace", "creationInfo", "packages", "files", "relationships"],
    "additionalProperties": False,
    "properties": {
        "spdxVersion": {"const": "SPDX-2.3"},
        "dataLicense": {"const": "CC0-1.0"},
        "SPDXID": {"const": "SPDXRef-DOCUMENT"},
        "name": {"type": "string", "minLength": 1},
        "documentNamespace": {"type": "string", "pattern": r"^https://[^#\s]+$"},
        "creationInfo": {
            "type": "object", "required": ["created", "creators"], "additionalProperties": False,
            "properties": {
                "created": {"type": "string", "pattern": r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$"},
                "creators": {"type": "array", "minItems": 1, "items": {"type": "string", "pattern": "^(Person|Organization|Tool): "}}}},
        "packages": {"type": "array", "minItems": 10, "items": {
            "type": "object", "required": ["SPDXID", "name", "versionInfo", "downloadLocation", "licenseDeclared"],
            "additionalProperties": False,
            "properties": {
                "SPDXID": {"type": "string", "pattern": r"^SPDXRef-[A-Za-z0-9.-]+$"},
                "supplier": {"type": "string", "pattern": "^(NOASSERTION|Organization: .+)$"},
                "filesAnalyzed": {"type": "boolean"},
                "packageVerificationCode": {
                    "type": "object", "required": ["packageVerificationCodeValue"],
                    "properties": {"packageVerificationCodeValue": {"type": "string", "pattern": "^[0-9a-f]{40}$"}}},
                "licenseDeclared": {"type": "string", "pattern": r"^[A-Za-z0-9.-]+$"},
                "externalRefs": {"type": "array", "items": {
                    "type": "object", "required": ["referenceCategory", "referenceType", "referenceLocator"],
                    "properties": {"referenceCategory": {"const": "PACKAGE-MANAGER"}, "referenceType": {"const": "purl"},
                                   "referenceLocator": {"type": "string", "pattern": r"^pkg:deb/[a-z]+/[^@+]+@[^+:]+\?arch=\w+$"}}}},
                **{name: {"type": "string"} for name in ("name", "versionInfo", "downloadLocation", "licenseConcluded", "copyrightText",
                                                         "homepage", "sourceInfo", "licenseComments")}}}},
        "files": {"type": "array", "minItems": 10, "items": {
            "type": "object", "required": ["SPDXID", "fileName", "checksums"],
            "properties": {"fileName": {"type": "string", "pattern": r"^\./"},
                           "checksums": {"type": "array", "contains": {"type": "object", "properties": {"algorithm": {"const": "SHA1"}}}}}}},
        "relationships": {"type": "array", "items": {
            "type": "object", "required": ["spdxElementId", "relationshipType", "relatedSpdxElement"], "additionalProperties": False,
            "properties": {"spdxElementId": {"type": "string"}, "relatedSpdxElement": {"type": "string"},
                           "relationshipType": {"enum": ["DESCRIBES", "CONTAINS", "DYNAMIC_LINK", "RUNTIME_DEPENDENCY_OF", "BUILD_DEPENDENCY_OF"]}}}},
    },
}


@pytest.mark.slow
def test_bill_of_materials_tells_what_is_in_the_package(t, package):
    _, tree = package
    jsonschema = pytest.importorskip("jsonschema")
    bill = json.loads((tree / "usr/share/doc/vvr/vvr.spdx.json").read_text())
    jsonschema.validate(bill, SPDX)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({**bill, "spdxVersion": "SPDX-2.2"}, SPDX)

    told = {each["fileName"]: {sum["algorithm"]: sum["checksumValue"] for sum in each["checksums"]} for each in bill["files"]}
    there = [file for file in tree.rglob("*") if file.is_file() and "DEBIAN" not in file.parts and file.name != "vvr.spdx.json"]
    check(sorted(told) == sorted(f"./{file.relative_to(tree)}" for file in there), "other files than the package's")
    for file in there:
        data = file.read_bytes()
        check(told[f"./{file.relative_to(tree)}"] == {"SHA1": hashlib.sha1(data).hexdigest(), "SHA256": hashlib.sha256(data).hexdigest()}, file)

    ids = [each["SPDXID"] for each in [bill, *bill["packages"], *bill["files"]]]
    check(len(ids) == len(set(ids)), "two things with one name")
    for relationship in bill["relationships"]:
        check({relationship["spdxElementId"], relationship["relatedSpdxElement"]} <= set(ids), f"{relationship}")
    control = (tree / "DEBIAN/control").read_text()
    names = {each["name"]: each for each in bill["packages"]}
    check(names["vvr"]["versionInfo"] == re.search(r"^Version: (.*)", control, flags=re.MULTILINE)[1], f"{names['vvr']}")
    check(names["vvr"]["licenseDeclared"] == "BSD-3-Clause", f"{names['vvr']}")
    # All that apt brings with it, but what only others of them need.
    provides = subprocess.run(["dpkg-query", "-W", "-f", "${Provides} ", *sorted(names.keys() - {"vvr"})], check=True, capture_output=True, text=True)
    known = {*names, *re.findall(r"[a-z][a-z0-9.+-]+", provides.stdout)}
    for dependency in re.search(r"^Depends: (.*)", control, flags=re.MULTILINE)[1].split(","):
        check(any(each.split()[0] in known for each in dependency.split("|")), f"{dependency} is not in the list")
    for name in ("libcli11-dev", "libglm-dev"):
        check(names[name]["licenseDeclared"] in ("BSD-3-Clause", "MIT"), f"compiled in: {names[name]}")
