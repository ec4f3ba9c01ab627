"""The program and its libraries are built so that a hostile clip finds little to use: readelf says so."""

import os
import pathlib
import platform
import re
import shutil
import subprocess

import pytest
from harness import check, nightly_except

VVR = pathlib.Path(os.environ["VVR"])
BUILD = VVR.parents[1]
PLUGIN = max(BUILD.glob("lib/vvr-*/libvvr_pictures.so"), key=os.path.getmtime, default=BUILD / "no plugin")
OURS = {"program": VVR, "library": BUILD / "lib/libvvr.so", "plugin": PLUGIN}


def read(option, file):
    return subprocess.run(["readelf", "-W", option, file], check=True, capture_output=True, text=True).stdout


def complaints(file, program):
    """What is missing, a sentence each."""
    said = []
    if not re.search(r"Type:\s+DYN", read("-h", file)):
        said.append("it has a fixed address")
    dynamic = read("-d", file)
    if program and not re.search(r"FLAGS_1.*\bPIE\b", dynamic):
        said.append("it is no PIE")
    if not re.search(r"BIND_NOW|FLAGS_1.*\bNOW\b", dynamic):
        said.append("symbols are bound late")
    if "TEXTREL" in dynamic:
        said.append("its code is relocated")
    for place in re.findall(r"(?:RPATH|RUNPATH).*\[(.*)\]", dynamic):
        said += [f"libraries are looked for in '{each}'" for each in place.split(":") if not each.startswith("$ORIGIN")]
    segments = re.findall(r"^\s+(\w+)\s+0x\w+ 0x\w+ 0x\w+ 0x\w+ 0x\w+ (...) ", read("-l", file), flags=re.MULTILINE)
    kinds = [kind for kind, _ in segments]
    check("LOAD" in kinds, f"{segments}")
    if "GNU_RELRO" not in kinds:
        said.append("its tables stay writable")
    said += [f"a segment {kind} is writable and runs" for kind, flags in segments if "W" in flags and "E" in flags]
    if "GNU_STACK" not in kinds:
        said.append("its stack may run")
    symbols = read("--dyn-syms", file)
    if "__stack_chk_fail" not in symbols:
        said.append("no function looks after its stack")
    if not re.search(r"UND __(?!stack)\w+_chk\b", symbols):
        said.append("no call looks after its buffer")
    return said


@pytest.fixture(name="hardened", autouse=True)
def only_releases():
    if not shutil.which("readelf"):
        pytest.skip("needs readelf of binutils")
    cache = (BUILD / "CMakeCache.txt").read_text(encoding="utf-8")
    if "VVR_SANITIZE:BOOL=ON" in cache or "CMAKE_BUILD_TYPE:STRING=Debug" in cache:
        pytest.skip("sanitizers and debuggers want it otherwise")


@pytest.mark.parametrize("name", OURS)
def test_a_release_is_hardened(name):
    check(complaints(OURS[name], name == "program") == [], f"{OURS[name]}: {complaints(OURS[name], name == 'program')}")


def test_jumps_and_returns_of_our_code_are_marked():
    """The program's own note needs the system's start files to have it too, so this looks at each of our objects."""
    if platform.machine() != "x86_64":
        pytest.skip("only x86 has these marks")
    made = (BUILD / "build.ninja").read_text(encoding="utf-8")  # others are of an older layout of the sources
    archives = [archive for archive in sorted(BUILD.glob("*/**/libvvr_*.a")) if f"build {archive.relative_to(BUILD)}:" in made]
    check(len(archives) > 15, f"{archives}")
    for archive in archives:
        for member in read("-n", archive).split("\nFile: ")[1:]:
            check("x86 feature: IBT, SHSTK" in member, f"{archive}: {member}")


SOFT = [  # options of a compiler, and what they take away
    (["-no-pie"], "it has a fixed address"),
    (["-Wl,-z,lazy"], "symbols are bound late"),
    (["-Wl,-z,norelro"], "its tables stay writable"),
    (["-Wl,-z,execstack"], "a segment GNU_STACK is writable and runs"),
    (["-Wl,-rpath,/tmp"], "libraries are looked for in '/tmp'"),
    (["-fno-stack-protector"], "no function looks after its stack"),
    (["-U_FORTIFY_SOURCE"], "no call looks after its buffer"),
]


@pytest.mark.parametrize("soft", nightly_except(SOFT, SOFT[0], SOFT[-1]), ids=[complaint for _, complaint in SOFT])
def test_what_is_not_hardened_is_found(t, soft):
    flags, complaint = soft
    t.write("echo.c", """
        #include <stdio.h>
        #include <string.h>
        int main(int count, char** words) {
            char text[16];
            strcpy(text, words[count - 1]);
            return puts(text);
        }""")
    hard = ["-O2", "-pie", "-fPIE", "-fstack-protector-strong", "-U_FORTIFY_SOURCE", "-D_FORTIFY_SOURCE=2", "-Wl,-z,relro", "-Wl,-z,now"]
    for name, more, expected in (("hard", [], []), ("soft", flags, [complaint])):
        t.run(["cc", *hard, *more, "echo.c", "-o", name]).expect(0)
        check(set(expected) <= set(complaints(t.path(name), True)), f"{name}: {complaints(t.path(name), True)}")
        check(expected or complaints(t.path(name), True) == [], f"{name}: {complaints(t.path(name), True)}")
