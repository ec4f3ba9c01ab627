#!/usr/bin/env python3
"""Puts one bug of breaks.py at a time into the sources, and reports which test notices it.

    tests/mutation/mutate.py              # all of them: hours
    tests/mutation/mutate.py --list       # the bugs and their numbers
    tests/mutation/mutate.py --units 1 7  # bugs 1 and 7, against the unit tests of their modules only

Unit tests of the module run first, then those of all modules, then the default set of pytest until the first failure.
A bug whose text is no longer in the sources is an error of breaks.py. Exits with 1 if a bug survives or does not build.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys

from breaks import BREAKS

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PYTEST = ("/usr/bin/python3", "-m", "pytest", "-q", "-x", "-p", "timeout", "-p", "xdist", "-n", "2", "-m",
          "not slow and not alone and not browser", "tests/cli", "tests/rules")


class DoesNotBuild(Exception):
    pass


def run(*command):
    environment = os.environ | {"VVR_BUILD": str(BUILD), "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1", "PYTHONDONTWRITEBYTECODE": "1",
                                "GTEST_FAIL_FAST": "1"}
    return subprocess.run(command, cwd=SOURCE, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False,
                          encoding="utf-8", errors="replace")


def build(*targets):
    done = run("cmake", "--build", BUILD, "--target", *targets)
    if done.returncode != 0:
        raise DoesNotBuild(done.stdout[-3000:])


def units_of(file):
    """The names of the unit test programs of the module that a file belongs to."""
    room = file.split("/")[-2] if file.startswith("core/") else file.split("/")[1] if file.startswith("cli/") else "gl"
    if room == "gl":
        return re.findall(r"foreach\(name ([\w ]+)\)", (SOURCE / "tests/gl/CMakeLists.txt").read_text())[0].split() + ["layers", "objects"]
    return [room if (SOURCE / "tests" / "unit" / room).is_dir() else "cli"]


def failure_of_units(names):
    """The first failing test of these programs."""
    build(*(f"test_{name}" for name in names))
    done = run("ctest", "--test-dir", BUILD, "--output-on-failure", "--stop-on-failure", "--no-tests=error", "-R", rf"^unit\.({'|'.join(names)})$")
    if done.returncode == 0:
        return None
    named = re.findall(r"\[  FAILED  \] ([\w./]+)", done.stdout) or re.findall(r"(unit\.\w+) \(?\w*", done.stdout)
    return f"unit: {named[0]}"


def all_units():
    return sorted({name.removeprefix("unit.") for name in re.findall(r"unit\.\w+", run("ctest", "--test-dir", BUILD, "-N", "-L", "unit").stdout)})


def failure_of_pytest():
    build("all")
    done = run(*PYTEST)
    if done.returncode == 0:
        return None
    named = re.findall(r"^FAILED (\S+)", done.stdout, flags=re.MULTILINE)
    return f"pytest: {named[0]}" if named else f"pytest: {done.stdout[-300:]}"


def noticed_by(bug, units_only):
    own = units_of(bug.file)
    found = failure_of_units(own)
    if found or units_only:
        return found
    return failure_of_units([name for name in all_units() if name not in own]) or failure_of_pytest()


def with_bug(bug, action):
    """Runs an action while the bug is in the sources."""
    path = SOURCE / bug.file
    text = path.read_text()
    if text.count(bug.old) != 1:
        raise SystemExit(f"mutate.py: {bug.file} has this text {text.count(bug.old)} times: {bug.old}")
    path.write_text(text.replace(bug.old, bug.new))
    try:
        return action()
    finally:
        path.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("numbers", type=int, nargs="*", help="which bugs; all if none is given")
    parser.add_argument("--list", action="store_true", help="print the bugs and their numbers")
    parser.add_argument("--units", action="store_true", help="run only the unit tests of the bug's module")
    arguments = parser.parse_args()
    wrong = 0
    for number in arguments.numbers or range(1, len(BREAKS) + 1):
        bug = BREAKS[number - 1]
        try:
            found = "" if arguments.list else with_bug(bug, lambda: noticed_by(bug, arguments.units)) or "SURVIVED"
        except DoesNotBuild as error:
            found = "DOES NOT BUILD"
            print(error, file=sys.stderr)
        wrong += found.isupper()
        print(f"| {number} | {bug.file} | `{bug.old}` -> `{bug.new}` | {found} |", flush=True)
    return 1 if wrong else 0


BUILD = SOURCE / os.environ.get("VVR_BUILD", "build/release")
if __name__ == "__main__":
    sys.exit(main())
