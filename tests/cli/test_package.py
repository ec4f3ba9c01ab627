"""The Debian package, and what an install puts beside the program."""

import gzip
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
    done = t.run(["cpack", "--config", f"{BUILD}/CPackConfig.cmake", "-G", "DEB", "-B", str(t.path("made"))])
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
