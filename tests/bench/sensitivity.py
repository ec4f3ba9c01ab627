"""What a change of each threshold of event detection by a quarter does to its results.

Truth is what you have: a clip with a path per person in the format of the MOT challenge (frame,id,x,y,width,height,...),
and a list of clips with what was left and taken in them, as JSON:
[{"clip": "gate.mp4", "left": [[x, y, width, height, first second, last second or null]], "taken": [...]}].

Usage: sensitivity.py PROGRAM [--people CLIP GT]... [--claims TRUTH.json] [-o TABLE.md]
PROGRAM is build/release/tests/bench/sensitivity. Clips are relative to the file that names them."""
import argparse
import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from scipy.optimize import linear_sum_assignment

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from claim_truth import is_true  # noqa: E402
from measure import table  # noqa: E402
from threshold_table import numbers  # noqa: E402

HEADER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../core/tracking/event_options.h")


def variations(program, clip):
    """{(threshold, factor): {"events", "seconds"}} of a clip; ("", 1) is that of today's thresholds."""
    lines = subprocess.run([program, clip], check=True, capture_output=True, text=True).stdout.splitlines()
    return {(one["threshold"], one["factor"]): one for one in map(json.loads, lines)}


def mot_paths(name):
    """{identity: {frame, from 0: (x, y, width, height)}}"""
    paths = {}
    for line in open(name):
        frame, identity, *box = map(float, line.split(",")[:6])
        paths.setdefault(identity, {})[int(frame) - 1] = box
    return paths


def places(event):
    """{frame: (x, y)} on the line between the points of its path."""
    frames = [point["frame"] for point in event["path"]]
    all_frames = range(event["first"]["frame"], event["last"]["frame"] + 1)
    along = [np.interp(all_frames, frames, [point["place"][axis] for point in event["path"]]) for axis in "xy"]
    return dict(zip(all_frames, zip(*along)))


def idf1(events, truth):
    """IDF1 [Ristani et al. 2016]; a frame counts where the event's path is in the identity's box, grown by a fifth."""
    paths = [places(event) for event in events]
    hits = np.zeros((len(truth), len(paths)))
    for row, boxes in enumerate(truth.values()):
        for column, path in enumerate(paths):
            for frame in path.keys() & boxes.keys():
                (x, y), (left, top, width, height) = path[frame], boxes[frame]
                hits[row, column] += (left - .2 * width <= x <= left + 1.2 * width
                                      and top - .2 * height <= y <= top + 1.2 * height)
    true = hits[linear_sum_assignment(hits, maximize=True)].sum()
    return 2 * true / max(1, sum(map(len, truth.values())) + sum(map(len, paths)))


def claims(found, truth):
    """(claims, true ones, real things, found ones) of one clip."""
    told = [event for event in found["events"] if event["kind"] in ("left", "taken")]
    true, met = set(), set()
    for event in told:
        for n, real in enumerate(truth.get(event["kind"], [])):
            if is_true(event, real[:4], real[4], found["seconds"]):
                true.add(event["number"])
                met.add((event["kind"], n))
    return np.array([len(told), len(true), len(truth.get("left", [])) + len(truth.get("taken", [])), len(met)])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--people", nargs=2, action="append", default=[], metavar=("CLIP", "GT"))
    parser.add_argument("--claims", metavar="TRUTH.json")
    parser.add_argument("-o", metavar="TABLE.md")
    options = parser.parse_args()
    things = json.load(open(options.claims)) if options.claims else []
    clips = [os.path.join(os.path.dirname(options.claims), one["clip"]) for one in things]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        of_people = list(pool.map(lambda one: variations(options.program, one[0]), options.people))
        of_things = list(pool.map(lambda clip: variations(options.program, clip), clips))
    truths = [mot_paths(gt) for _, gt in options.people]

    def measure(variation):
        people = [idf1(found[variation]["events"], truth) for found, truth in zip(of_people, truths)]
        told, true, real, met = sum((claims(found[variation], truth) for found, truth in zip(of_things, things)),
                                    np.zeros(4, int))
        return float(np.mean(people)) if people else 0, told, true, real, met

    rows = [("threshold", "", "IDF1 at 3/4", "at 5/4", "told, true, found at 3/4", "at 5/4", "what it is")]
    base = measure(("", 1))
    rows.append(("as they are", "", f"{base[0]:.3f}", "", f"{base[1]}, {base[2]}, {base[4]} of {base[3]}", "", ""))
    for name, _, comment in numbers(HEADER):
        less, more = (measure((name, factor)) for factor in (0.75, 1.25))
        mark = "=" if less == base == more else "" if max(abs(one[0] - base[0]) for one in (less, more)) <= 0.03 else "!"
        told = lambda one: "=" if one[1:] == base[1:] else f"{one[1]}, {one[2]}, {one[4]}"
        change = lambda one: "=" if one[0] == base[0] else f"{one[0] - base[0]:+.3f}"
        rows.append((name, mark, change(less), change(more), told(less), told(more), comment))
    text = table(rows[0], rows[1:])
    if options.o:
        open(options.o, "w").write(text)
    print(text, end="")


if __name__ == "__main__":
    main()
