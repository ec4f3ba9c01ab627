#!/usr/bin/env python3
"""Puts one bug of breaks.py at a time into a copy of the sources, and prints a table of the tests that notice them.

    tests/mutation/mutate.py              # all of them, after the default set without any bug
    tests/mutation/mutate.py --list       # the bugs and their numbers
    tests/mutation/mutate.py 1 7          # bugs 1 and 7

The copy is a worktree of git in build/mutation, with what git tracks as it is now. Without numbers, the default set must
pass there first. The test that breaks.py names runs first: the one that noticed the bug before. If it passes, the unit tests
of the module run, those of the others, and the rest of the default set until the first failure.
Exits with 1 if a bug survives or does not build. A bug whose text is no longer in the sources is an error of breaks.py.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import time

from breaks import BREAKS

SOURCE = pathlib.Path(__file__).resolve().parents[2]
COPY = SOURCE / "build" / "mutation"
BUILD = COPY / "build" / "release"
COMMANDS = ("vvr", "vvr_library", "vvr-scene", "vvr-withhold", "vvr_hijack")
ENVIRONMENT = os.environ | {"VVR_BUILD": str(BUILD), "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1", "PYTHONDONTWRITEBYTECODE": "1",
                            "GTEST_FAIL_FAST": "1", "GTEST_BRIEF": "1"}


class DoesNotBuild(Exception):
    pass


def run(*command, folder=COPY):
    return subprocess.run(command, cwd=folder, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False,
                          encoding="utf-8", errors="replace")


def must(*command, folder=COPY):
    done = run(*command, folder=folder)
    if done.returncode != 0:
        sys.exit(f"mutate.py: {' '.join(map(str, command))} fails:\n{done.stdout[-3000:]}")
    return done.stdout.strip()


def make_copy():
    commit = must("git", "stash", "create", folder=SOURCE) or must("git", "rev-parse", "HEAD", folder=SOURCE)
    if COPY.exists():
        must("git", "checkout", "--force", "--detach", commit)
    else:
        must("git", "worktree", "prune", folder=SOURCE)
        must("git", "worktree", "add", "--detach", COPY, commit, folder=SOURCE)
    must("cmake", "--preset", "release", "-DVVR_BENCHMARKS=OFF")


def build(*targets):
    done = run("cmake", "--build", BUILD, "--target", *targets)
    if done.returncode != 0:
        raise DoesNotBuild(done.stdout[-3000:])


def unit_programs():
    return {name.removeprefix("unit.") for name in re.findall(r"\bunit\.\w+", run("ctest", "--test-dir", BUILD, "-N").stdout)}


def programs_of(room):
    """The programs of the unit tests of a module."""
    if room == "gl":
        return {path.name.removesuffix("_test.cpp") for path in (COPY / "tests" / "gl").glob("*_test.cpp")}
    return {room}


def room_of(file):
    folders = file.split("/")
    return folders[1] if folders[0] == "core" else folders[0]


def failure_of_units(names):
    """The first unit test that fails in these programs."""
    if not names:
        return None
    build(*(f"test_{name}" for name in names))
    done = run("ctest", "--test-dir", BUILD, "--output-on-failure", "--stop-on-failure", "-j2", "-R", rf"^unit\.({'|'.join(names)})$")
    if done.returncode == 0:
        return None
    return (re.findall(r"\[  FAILED  \] ([\w./]+)", done.stdout) or re.findall(r"\bunit\.\w+", done.stdout))[0]


def failure_of_unit(name):
    """The test SUITE.NAME, if it fails; of its program nothing else runs."""
    test = re.compile(r"^TEST(_[FP])?\({}, {}\)".format(*name.split(".")), re.MULTILINE)
    (file,) = [path for path in (COPY / "tests").rglob("*_test.cpp") if test.search(path.read_text())]
    folder = BUILD / file.parent.relative_to(COPY)
    program = f"test_{file.parent.name}" if file.parent.parent.name == "unit" else f"test_{file.name.removesuffix('_test.cpp')}"
    build(program)
    return name if run(folder / program, f"--gtest_filter={name}:*/{name}/*").returncode != 0 else None


def failure_of_pytest(*what):
    """The first of pytest's tests that fails."""
    build(*COMMANDS)
    done = run("/usr/bin/python3", "-m", "pytest", "-q", "-x", "-p", "timeout", "-p", "xdist", "-n", "2", *what)
    if done.returncode == 0:
        return None
    named = re.findall(r"^(?:FAILED|ERROR) (\S+)", done.stdout, flags=re.MULTILINE)
    return named[0].removeprefix("tests/") if named else done.stdout[-300:]


def stages(first_test, first_programs):
    """Functions that run the default set in parts. Each returns the name of a test that fails, or None."""
    if first_test:
        yield lambda: failure_of_pytest(f"tests/{first_test}") if "::" in first_test else failure_of_unit(first_test)
    yield lambda: failure_of_units(first_programs)
    yield lambda: failure_of_units(unit_programs() - first_programs)
    yield lambda: failure_of_pytest("-m", "not slow and not nightly and not alone and not browser", "tests/cli", "tests/rules")
    yield lambda: failure_of_pytest("-n0", "-m", "alone and not slow and not nightly and not browser", "tests/cli")


def first_failure(parts):
    return next((found for found in (part() for part in parts) if found), None)


def noticed_by(bug):
    """The first test that fails while the bug is in the sources."""
    own = programs_of(room_of(bug.file)) & unit_programs() or {"cli"}
    path = COPY / bug.file
    text = path.read_text()
    if text.count(bug.old) != 1:
        sys.exit(f"mutate.py: {bug.file} has this text {text.count(bug.old)} times: {bug.old}")
    path.write_text(text.replace(bug.old, bug.new))
    try:
        return first_failure(stages(bug.test, own)) or "SURVIVED"
    except DoesNotBuild as error:
        print(error, file=sys.stderr)
        return "DOES NOT BUILD"
    finally:
        path.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("numbers", type=int, nargs="*", help=f"which bugs, from 1 to {len(BREAKS)}; all if none is given")
    parser.add_argument("--list", action="store_true", help="print the bugs and their numbers")
    arguments = parser.parse_args()
    numbers = arguments.numbers or range(1, len(BREAKS) + 1)
    if not 1 <= min(numbers) <= max(numbers) <= len(BREAKS):
        parser.error(f"there are bugs 1 to {len(BREAKS)}")
    if not arguments.list:
        make_copy()
    if not arguments.list and not arguments.numbers:
        failed = first_failure(stages("", unit_programs()))
        if failed:
            sys.exit(f"mutate.py: without any bug, {failed} fails")
    print("| | break | room | file | noticed by | seconds |\n|---|---|---|---|---|---|")
    unnoticed = 0
    for number in numbers:
        bug = BREAKS[number - 1]
        begin = time.monotonic()
        found = bug.test if arguments.list else noticed_by(bug)
        unnoticed += found in ("SURVIVED", "DOES NOT BUILD")
        change = f"`{bug.old}` -> `{bug.new}`".replace("|", "\\|")
        print(f"| {number} | {change} | {room_of(bug.file)} | {bug.file} | {found} | {time.monotonic() - begin:.0f} |", flush=True)
    if not arguments.list:
        print(f"{len(numbers) - unnoticed} of {len(numbers)} are noticed")
    return 1 if unnoticed else 0


if __name__ == "__main__":
    sys.exit(main())
