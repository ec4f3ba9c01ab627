"""libvvr, as a program of someone else's finds, links and calls it."""

import filecmp
import os
import pathlib
import re
import shutil
import subprocess

import pytest
from harness import check

BUILD = pathlib.Path(os.environ["VVR"]).parents[1]
SHOWN = {"vvr::Failure::Failure", "vvr::Failure::~Failure", "typeinfo for vvr::Failure", "typeinfo name for vvr::Failure",
         "vtable for vvr::Failure", "vvr::library_version", "vvr::read_clip_info", "vvr::render_image", "vvr::write_image"}


@pytest.fixture(name="prefix")
def installed(t):
    """An installed library, moved to another place than it was installed to."""
    if "VVR_SANITIZE:BOOL=ON" in (BUILD / "CMakeCache.txt").read_text(encoding="utf-8"):
        pytest.skip("a program without sanitizers can't load a library with them")
    done = t.run(["cmake", "--install", BUILD, "--prefix", t.path("made"), "--component", "development"])
    check(done.status == 0, str(done))
    t.path("made").rename(t.path("prefix"))
    return t.path("prefix")


def test_the_library_shows_its_headers_and_nothing_else(t, prefix):
    headers = sorted(file.name for file in (prefix / "include/vvr").iterdir())
    check(headers == ["vvr.h"], f"{headers}")
    for header in headers:  # each stands alone
        done = t.run(["c++", "-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only", "-I", prefix / "include",
                      "-x", "c++", "-include", f"vvr/{header}", "/dev/null"])
        check(done.status == 0, str(done))
    symbols = t.run(["nm", "-DC", "--defined-only", prefix / "lib/libvvr.so"]).out
    names = {re.split(r"[\[(@]", line.split(maxsplit=2)[2])[0] for line in symbols.splitlines()} - {"VVR_0"}
    check(names == SHOWN, f"{names ^ SHOWN}")


def build_by_cmake(t, prefix):
    done = t.run(["cmake", "-G", "Ninja", "-S", t.source / "docs/examples/render_a_clip", "-B", t.path("built"),
                  f"-DCMAKE_PREFIX_PATH={prefix}"])
    check(done.status == 0, str(done))
    done = t.run(["cmake", "--build", t.path("built")])
    check(done.status == 0, str(done))
    return t.path("built") / "render_a_clip"


def build_by_pkg_config(t, prefix):
    if not shutil.which("pkg-config"):
        pytest.skip("needs pkg-config")
    flags = subprocess.run(["pkg-config", "--cflags", "--libs", "vvr"], check=True, capture_output=True, text=True,
                           env=os.environ | {"PKG_CONFIG_PATH": str(prefix / "lib/pkgconfig")}).stdout.split()
    done = t.run(["c++", "-std=c++17", t.source / "docs/examples/render_a_clip/render_a_clip.cpp", "-o", "by_pkg_config", *flags,
                  f"-Wl,-rpath,{prefix}/lib"])
    check(done.status == 0, str(done))
    return t.path("by_pkg_config")


@pytest.mark.parametrize("build", [build_by_cmake, build_by_pkg_config])
def test_the_example_draws_what_the_program_draws(t, prefix, build):
    example = build(t, prefix)
    t.clip()
    done = t.run([example, "clip.avi", "library.png", "160x100"])
    check(done.status == 0 and "20 frames in library.png" in done.out, str(done))
    t.render("clip.avi", output="program.png").expect(0, out=None)
    check(filecmp.cmp(t.path("library.png"), t.path("program.png"), shallow=False), "other bytes than the program's")


def test_errors_are_failures_with_a_kind(t, prefix):
    example = build_by_cmake(t, prefix)
    t.write("noise.avi", os.urandom(5000))
    t.clip()
    for arguments, status, text in [
            (["none.avi", "out.png"], 3, "[file-not-found]"),
            (["noise.avi", "out.png"], 4, "noise.avi"),
            (["clip.avi", "out.png", "160"], 2, "size"),
            (["clip.avi", "out.bmp2", "160x100"], 2, "out.bmp2"),
            (["clip.avi", "no/out.png", "160x100"], 3, "[file-not-found]")]:
        done = t.run([example, *arguments])
        check(done.status == status and text in done.err, str(done))
        check("terminate" not in done.err and not t.path("out.png").exists(), str(done))
    done = t.run([example, "clip.avi", "out.png", "160x100"], env=os.environ | {"VVR_CONFIG": "/none"})
    check(done.status == 0, f"config files count for nothing: {done}")


def test_settings_have_the_programs_names_and_checks(t, prefix):
    t.clip()
    t.write("main.cpp", """
        #include <cstdio>
        #include <vvr/vvr.h>
        int main(int, char** words) {
            try {
                vvr::Rendering done = vvr::render_image("clip.avi", {{"size", "160x100"}, {words[1], words[2]}});
                std::printf("%dx%d %zu", done.image.width, done.image.height, done.image.rgba.size());
                done.image.rgba.pop_back();
                vvr::write_image("short.png", done.image);
            } catch (const vvr::Failure& failure) {
                std::printf(" %d %s: %s", static_cast<int>(failure.kind()), failure.code(), failure.what());
            }
        }""")
    done = t.run(["c++", "-std=c++17", "main.cpp", "-o", "main", f"-I{prefix}/include", f"-L{prefix}/lib", "-lvvr", f"-Wl,-rpath,{prefix}/lib"])
    check(done.status == 0, str(done))
    for name, value, text in [
            ("size", "200x100", "200x100 80000 0 usage: 'short.png': an image of 200x100 pixels needs 4 values per pixel, but has 79999 in total"),
            ("sise", "1x1", " 0 option-unknown: there is no setting 'sise' (did you mean 'size'?)"),
            ("slices", "-1", " 0 option-value-out-of-range: slices: '-1' is not a whole number from 0 to 16384"),
            ("help", "yes", " 0 option-unknown"), ("config", "/nowhere", " 0 option-unknown"),
            ("config=/nowhere", "x", " 0 option-unknown"), ("output", "x.png", " 0 option-unknown")]:
        done = t.run(["./main", name, value])
        check(done.status == 0 and done.out.startswith(text), str(done))
    check(not t.path("short.png").exists(), "a picture of an image that is none")
