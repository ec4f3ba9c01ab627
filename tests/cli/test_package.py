"""What an install puts beside the program, and what debian/ repeats. scripts/package --test tests the packages themselves."""

import os
import re
import shutil

from harness import check

BUILD = os.path.dirname(os.path.dirname(os.environ["VVR"]))


def test_installed_services_name_the_installed_program(t):
    prefix = t.path("there")
    t.run(["cmake", "--install", BUILD, "--prefix", str(prefix)]).expect(0, out=None)
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


def fields(paragraph):
    """The fields of a paragraph of debian/control."""
    return {name: text.strip() for name, text in re.findall(r"^(\S+):((?:.|\n )*)", paragraph, flags=re.MULTILINE)}


def names(field):
    """The packages of a list of dependencies, each with its alternatives."""
    return {name for part in field.split(",") for name in re.findall(r"(?:^|\|)\s*([a-z0-9][a-z0-9.+-]+)", part)}


def test_control_names_the_packages_that_the_scripts_install(t):
    """What dpkg-shlibdeps can't see is listed twice: in scripts/packages.txt and in debian/control."""
    listed = re.findall(r"^(?:(\w+): )?([a-z0-9.+-]+)$", (t.source / "scripts/packages.txt").read_text(), flags=re.MULTILINE)
    source, *packages = map(fields, (t.source / "debian/control").read_text().split("\n\n"))
    build = {name for group, name in listed if not group} - {"g++", "ccache"}  # part of build-essential; optional
    check(len(build) > 20 and build <= names(source["Build-Depends"]), f"{build - names(source['Build-Depends'])}")
    (library,) = [package for package in packages if re.fullmatch(r"libvvr[\d.]+", package["Package"])]
    opened = {name for group, name in listed if group == "run"}
    check(len(opened) == 5 and opened <= names(library["Depends"]), f"{opened - names(library['Depends'])}")


def test_debian_copyright_is_the_license(t):
    def words(text):
        return re.sub(r"^ ?\.?$", "", text, flags=re.MULTILINE).split()
    _, text = (t.source / "debian/copyright").read_text().split("License: BSD-3-Clause\n Redistribution")
    license_words = words((t.source / "LICENSE").read_text())
    check(license_words[license_words.index("Redistribution") + 1:] == words(text), "debian/copyright and LICENSE differ")
