"""What pytest needs for the tests of the command line: the folder of each test, and what a skipped test means.

ctest says by environment variables which programs to test; without them it is those of build/release:

    python3 -m pytest tests/cli -k golden
"""

import os
import pathlib

import pytest
from harness import Bench

SOURCE = pathlib.Path(__file__).resolve().parents[2]
BUILD = SOURCE / "build" / "release"
os.environ.setdefault("VVR", str(BUILD / "cli" / "vvr"))
os.environ.setdefault("VVR_SCENE", str(BUILD / "tests" / "scene" / "vvr-scene"))
os.environ.setdefault("VVR_WITHHOLD", str(BUILD / "tests" / "support" / "vvr-withhold"))
os.environ.setdefault("VVR_HIJACK", str(BUILD / "tests" / "support" / "libvvr_hijack.so"))

os.environ["VVR_CONFIG"] = ""  # what the machine's own config file says shall decide nothing here

SKIPPED = 77  # the exit status by which ctest knows that a test was skipped


@pytest.fixture
def t(tmp_path):
    """The folder of one test, with ways to run vvr in it."""
    return Bench(os.environ["VVR"], SOURCE, tmp_path)


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport():
    """Where everything is required (scripts/test --all) a skipped test is a failed one."""
    report = (yield).get_result()
    if report.skipped and os.environ.get("VVR_ALL_REQUIRED") == "1":
        report.outcome = "failed"


def pytest_sessionfinish(session, exitstatus):
    """Tells ctest when all that was asked for was skipped."""
    reporter = session.config.pluginmanager.getplugin("terminalreporter")
    if exitstatus == pytest.ExitCode.OK and "skipped" in reporter.stats and "passed" not in reporter.stats:
        session.exitstatus = SKIPPED
