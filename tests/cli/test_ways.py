"""Page and index ask ways of objects, as which of them crossed a line, with the same functions and the same numbers."""

import json
import os
import re
import shutil
import subprocess

import pytest
from harness import check

SHARED = ("core/page/shared/place.js", "core/page/shared/ways.js", "tests/cli/ways.js")


def test_ways_are_asked_as_by_brute_force(t):
    if shutil.which("node") is None:
        pytest.skip("there is no node; install with: apt-get install nodejs")
    script = "\n".join((t.source / name).read_text() for name in SHARED)
    done = subprocess.run(["node", "-"], input=f"{script}\nconsole.log(JSON.stringify(faultsOfWays()))", text=True,
                          stdout=subprocess.PIPE, check=True, timeout=100)
    faults = json.loads(done.stdout)
    check(faults == [], "\n".join(faults[:5]))


def data_of(page):
    """The data in a page."""
    return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', page.read_text(), re.DOTALL)[1])


def test_ways_are_the_same_in_page_and_index(t):
    t.scene("walkers", "walkers.y4m", "--size", "192x144", "--frames", "300", "--seed", "5")
    t.path("in/gate").mkdir(parents=True)
    t.ffmpeg("-i", "walkers.y4m", "-c:v", "mpeg4", "-q:v", "3", "in/gate/20261117T071500.avi")
    os.utime(t.path("in/gate/20261117T071500.avi"), (1e9, 1e9))
    t.vvr("archive", "in", "-o", "out", "--size", "320x200", "--backend", "software").expect(0)
    events = data_of(t.path("out/gate/20261117T071500.avi.html"))["events"]
    ways = {number: list(way) for _, number, _, *way in json.loads(t.path("out/gate/20261117T071500.avi.json").read_text())["found"]}
    check(len(events) > 3 and sum(len(event["way"]) > 6 for event in events) > 2, f"too little to be a test: {events}")
    check({event.get("number", place + 1): event["way"] for place, event in enumerate(events)} == ways, f"{events}\n{ways}")


def test_times_of_frames_alone_between_gaps(t):
    """How long a page shows a frame: by the next one, by the one before it, or as nothing tells."""
    if shutil.which("node") is None:
        pytest.skip("there is no node; install with: apt-get install nodejs")
    script = (t.source / "core/page/script/times.js").read_text()
    times = [[0, 10, 0, 0.1], [50, 1, 30, 0.1], [90, 2, 60, 0.2]]  # first frame, count, its second, seconds per frame
    stubs = f"""const document = {{documentElement: {{dataset: {{}}}}}}, data = {{times: {times}, clock: null}};
        const clamp = (value, low, high) => Math.min(Math.max(value, low), high);"""
    done = subprocess.run(["node", "-"], input=f"{stubs}\n{script}\nconsole.log(JSON.stringify([0, 9, 50, 90, 91].map(lengthOf)))",
                          text=True, stdout=subprocess.PIPE, check=True, timeout=100)
    lengths = [round(length, 6) for length in json.loads(done.stdout)]
    check(lengths == [0.1, 0.1, 0.04, 0.2, 0.2], f"{lengths}")
