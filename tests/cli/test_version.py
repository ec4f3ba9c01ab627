"""The version comes from the tags of a clone, else from CMakeLists.txt: scripts/cmake/Version.cmake."""

import os
import re

import pytest
from harness import check

QUIET = os.environ | {"GIT_CONFIG_GLOBAL": "/dev/null", "GIT_CONFIG_SYSTEM": "/dev/null"}


@pytest.fixture(name="versions")
def fixture_versions(t):
    """Of the sources in a folder: the version, its numbers."""
    def versions(folder="clone"):
        done = t.run(["cmake", f"-DPROJECT_SOURCE_DIR={t.path(folder)}", "-DPROJECT_VERSION=0.7.0", "-P",
                      t.source / "scripts/cmake/Version.cmake"], env=QUIET).expect(0)
        return done.err.splitlines()[-1].split()
    return versions


@pytest.fixture(name="git")
def fixture_git(t):
    t.path("clone").mkdir()

    def git(*arguments, folder="clone"):
        command = ["git", "-c", "user.name=n", "-c", "user.email=n@example.org", *arguments]
        return t.run(command, cwd=t.path(folder), env=QUIET).expect(0, out=None).out.strip()
    git("init", "-q")
    t.write("clone/file", "one")
    git("add", "file")
    git("commit", "-qm", "one")
    return git


def test_a_tag_is_the_version(git, versions):
    check(versions() == ["0.7.0"] * 2, f"without tags: {versions()}")
    git("tag", "v1.2.0-rc.1")
    check(versions() == ["1.2.0-rc.1", "1.2.0"], f"a candidate: {versions()}")
    git("commit", "-q", "--allow-empty", "-m", "two")
    git("tag", "v1.2.0")
    check(versions() == ["1.2.0"] * 2, f"a release: {versions()}")


def test_what_comes_after_a_tag_is_said(t, git, versions):
    git("tag", "v1.2.0")
    git("commit", "-q", "--allow-empty", "-m", "two")
    commit = git("rev-parse", "--short=10", "HEAD")
    check(versions() == [f"1.2.0+1.g{commit}", "1.2.0"], f"{versions()}")
    t.write("clone/file", "changed")
    check(versions()[0] == f"1.2.0+1.g{commit}.dirty", f"{versions()}")


def test_without_tags_of_its_own_it_is_the_projects(t, git, versions):
    git("tag", "v1.2.0")
    git("commit", "-q", "--allow-empty", "-m", "two")
    t.path("clone/unpacked").mkdir()
    check(versions("clone/unpacked") == ["0.7.0"] * 2, "a tarball within a clone of something else")
    t.path("shallow").mkdir()
    git("clone", "-q", "--depth", "1", "--no-tags", f"file://{t.path('clone')}", ".", folder="shallow")
    check(versions("shallow") == ["0.7.0"] * 2, "a shallow clone")
    git("tag", "v3")
    git("commit", "-q", "--allow-empty", "-m", "three")
    check(versions() == ["0.7.0"] * 2, "a tag that is no version")


def test_all_sources_name_the_same_version(t):
    def first(pattern, name):
        return re.search(pattern, (t.source / name).read_text(), flags=re.MULTILINE)[1]
    number = first(r"^project\(vvr VERSION (\S+)", "CMakeLists.txt")
    series = number.rsplit(".", 1)[0]
    check(first(r"^version: (\S+)", "CITATION.cff") == number, "CITATION.cff")
    # A candidate is 1.2.0~rc.1-1, which dpkg sorts before 1.2.0-1.
    check(re.split("[~-]", first(r"^vvr \((.*)\)", "debian/changelog"))[0] == number, "debian/changelog")
    check(first(r"^Package: libvvr(\d.*)", "debian/control") == series, "the library's name in debian/control")
    check((t.source / f"debian/libvvr{series}.install").exists(), "the library's files")
    check(t.vvr("--version").out.split()[1].startswith(series), "the program")
