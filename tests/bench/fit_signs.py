"""Fits the weights by which the signs of an object decide whether it is an event (core/tracking/signs.h).

Truth is what you have: a list of clips as JSON, [{"clip": "gate.mp4", "visits": [[who, first second, last second], ...]}],
where drawn scenes may have a "weight" below 1, and those without anybody have no visits,
and clips with a path per person in the format of the MOT challenge (frame,id,x,y,width,height,...). An event or change of
the report is a visit's if their times overlap by half of both together, each used once, best first; others that overlap
as much are left out. Prints the weights, and what is kept in each clip by the weights that the other clips give.

Usage: fit_signs.py VVR [--people CLIP GT]... [--visits TRUTH.json]..."""
import argparse
import json
import os
import subprocess
import tempfile

import numpy as np

PRIOR = 1  # of the squared weights of signs in units of their standard deviation: fewer clips give smaller weights


def report_of(program, clip):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "report.json")
        subprocess.run([program, "render", clip, "--report", path, "--quiet"], check=True)
        return json.load(open(path))


def visits_of_people(name, seconds_per_frame):
    times = {}
    for line in open(name):
        frame, identity = line.split(",")[:2]
        times.setdefault(identity, []).append((float(frame) - 1) * seconds_per_frame)
    return [[who, min(at), max(at)] for who, at in times.items()]


def labels(objects, visits):
    """1 = a visit's, 0 = nobody's, None = another one's part."""
    pairs = []
    for place, one in enumerate(objects):
        first, last = one["first"]["seconds"], one["last"]["seconds"]
        for visit, (_, begin, end) in enumerate(visits):
            share = (min(last, end) - max(first, begin)) / max(1e-6, max(last, end) - min(first, begin))
            if share >= .5:
                pairs.append((share, place, visit))
    found = [0] * len(objects)
    met = set()
    for _, place, visit in sorted(pairs, reverse=True):
        if found[place] != 1 and visit not in met:
            found[place] = 1
            met.add(visit)
        elif found[place] == 0:
            found[place] = None
    return found


def fit(signs, truth, weights):
    """Weighted logistic regression, by Newton's method: bias and weights."""
    mean, spread = signs.mean(0), signs.std(0) + 1e-9
    rows = np.c_[np.ones(len(signs)), (signs - mean) / spread]
    prior = PRIOR * np.eye(rows.shape[1])
    prior[0, 0] = 0
    found = np.zeros(rows.shape[1])
    for _ in range(30):
        chance = 1 / (1 + np.exp(-rows @ found))
        curve = (rows * (weights * chance * (1 - chance))[:, None]).T @ rows + prior
        found += np.linalg.solve(curve, rows.T @ (weights * (truth - chance)) - prior @ found)
    slopes = found[1:] / spread
    return found[0] - slopes @ mean, slopes


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("vvr")
    parser.add_argument("--people", nargs=2, action="append", default=[], metavar=("CLIP", "GT"))
    parser.add_argument("--visits", action="append", default=[], metavar="TRUTH.json")
    parser.add_argument("--least", type=float, default=.35, help="probability of an event, as thresholds.event")
    arguments = parser.parse_args()
    clips = []
    weight_of = {}
    for clip, truth in arguments.people:
        report = report_of(arguments.vvr, clip)
        seconds = report["span"]["last"] / max(1, report["frames"]["used"] - 1)
        clips.append((clip, report, visits_of_people(truth, seconds)))
    for name in arguments.visits:
        for one in json.load(open(name)):
            if one.get("visits") is not None:
                clip = os.path.join(os.path.dirname(name), one["clip"])
                clips.append((clip, report_of(arguments.vvr, clip), one["visits"]))
                weight_of[len(clips) - 1] = one.get("weight", 1)
    signs, truth, clip_of = [], [], []
    for number, (_, report, visits) in enumerate(clips):
        # What was left or taken is decided by its evidence.
        objects = [one for one in report["events"] + report["changes"] if one.get("kind") not in ("left", "taken")]
        for one, label in zip(objects, labels(objects, visits)):
            if label is None:
                continue
            signs.append(list(one["signs"].values()))
            names = list(one["signs"])
            truth.append(label)
            clip_of.append(number)
    signs, truth, clip_of = np.array(signs, float), np.array(truth), np.array(clip_of)
    # A clip counts as the root of its number of objects: one with much foliage doesn't outvote the others.
    weights = 1 / np.sqrt(np.bincount(clip_of, minlength=len(clips))[clip_of])
    weights *= np.array([weight_of.get(number, 1) for number in clip_of])
    weights /= weights.mean()
    bias, slopes = fit(signs, truth, weights)
    print("bias %.2f, " % bias + ", ".join("%s %.2f" % pair for pair in zip(names, slopes)))
    kept = np.zeros(len(truth), bool)
    for number, (clip, _, _) in enumerate(clips):
        rest = clip_of != number
        bias, slopes = fit(signs[rest], truth[rest], weights[rest])
        kept[~rest] = 1 / (1 + np.exp(-bias - signs[~rest] @ slopes)) >= arguments.least
        visits = [(kept & ~rest & (truth == label)).sum() for label in (1, 0)]
        of = [(~rest & (truth == label)).sum() for label in (1, 0)]
        print("%s: %d of %d visits kept, %d of %d others" % (os.path.basename(clip), visits[0], of[0], visits[1], of[1]))
    print("left out in turn: %d of %d visits kept, %d of %d others" % (
        (kept & (truth == 1)).sum(), (truth == 1).sum(), (kept & (truth == 0)).sum(), (truth == 0).sum()))


if __name__ == "__main__":
    main()
