"""What pytest needs for the tests of the command line: the folder of each test, and what a skipped test means.

VVR_BUILD says which build to test, build/release by default:

    VVR_BUILD=build/debug python3 -m pytest tests/cli -k golden
"""

import os
import pathlib
import shutil
import signal

import pytest
from harness import Bench

SOURCE = pathlib.Path(__file__).resolve().parents[2]
BUILD = SOURCE / os.environ.get("VVR_BUILD", "build/release")
os.environ.setdefault("VVR", str(BUILD / "cli" / "vvr"))
os.environ.setdefault("VVR_SCENE", str(BUILD / "tests" / "scene" / "vvr-scene"))
os.environ.setdefault("VVR_WITHHOLD", str(BUILD / "tests" / "support" / "vvr-withhold"))
os.environ.setdefault("VVR_HIJACK", str(BUILD / "tests" / "support" / "libvvr_hijack.so"))

PASSED = pytest.StashKey[bool]()

signal.signal(signal.SIGINT, signal.default_int_handler)  # vvr inherits that a shell's background job ignores it
os.environ["VVR_CONFIG"] = ""  # what the machine's own config file says shall decide nothing here


@pytest.fixture(scope="session")
def made(tmp_path_factory):
    """Clips that several tests need; all processes of a run share them."""
    base = tmp_path_factory.getbasetemp()
    folder = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "made"
    folder.mkdir(exist_ok=True)
    return folder


@pytest.fixture
def t(request, tmp_path, monkeypatch, made):
    """The folder of one test, with ways to run vvr in it; it goes when the test has passed."""
    yield Bench(os.environ["VVR"], SOURCE, tmp_path, monkeypatch, made)
    if request.node.stash.get(PASSED, False):
        shutil.rmtree(tmp_path, ignore_errors=True)


def pytest_collection_modifyitems(items):
    for item in items:
        for marker, seconds in (("slow", 1800), ("browser", 600)):
            if item.get_closest_marker(marker) and not item.get_closest_marker("timeout"):
                item.add_marker(pytest.mark.timeout(seconds))


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item, call):
    """Where everything is required (scripts/test --all) a skipped test is a failed one."""
    report = (yield).get_result()
    if call.when == "call":
        item.stash[PASSED] = report.passed
    if report.skipped and os.environ.get("VVR_ALL_REQUIRED") == "1":
        report.outcome = "failed"

