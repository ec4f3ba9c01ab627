"""What is found of the visits, of the things left and taken, and of people's paths, in clips of which it is known: a table.

Truth is what you have. Lists of clips noted by eye, relative to the list, with times in seconds; visits may be null if nobody noted
them, and what was left or taken may have no last second:
[{"clip": "gate.mp4", "visits": [[who, first, last], ...], "left": [[x, y, width, height, first, last]], "taken": [...]}].
And clips with a path per person in the format of the MOT challenge (frame,id,x,y,width,height,...). Scenes of rain and balloons are
drawn; they help to fit, at half weight.

An event is a visit's if their times overlap by half of both together, each used once, best first. An event that is neither a visit's
nor a true claim is extra. "all" is of the clips noted by eye.

--leave-out prints the same with the weights of signs (core/tracking/signs.h) that the other clips give, --fit those that all clips
give and what they find. --sensitivity prints what a quarter less and more of each threshold changes in all; "!" marks more than a
twentieth of the visits or of IDF1.

Usage: events.py BUILD [--visits TRUTH.json]... [--people CLIP GT]... [--leave-out] [--fit] [--sensitivity]"""
import argparse
import json
import os
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from scipy.optimize import linear_sum_assignment, minimize

from measure import table
from threshold_table import numbers

HEADER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../core/tracking/event_options.h")
PRIOR = 1  # of the squared weights of signs in units of their standard deviation: fewer clips give smaller weights
DRAWN = [("rain", seed, [["person", .8, 7.9]]) for seed in range(1, 6)] + [("balloons", seed, []) for seed in (1, 2)]
FOUND = ["met", "of", "extra", "told", "true", "found", "of things", "IDF1"]


def box_of(event):
    return [event["box"][key] for key in ("x", "y", "width", "height")]


def same_place(event, box):
    """Whether both share a third of the smaller box."""
    a, b = box_of(event), box
    width = min(a[0] + a[2], b[0] + b[2]) - max(a[0], b[0])
    height = min(a[1] + a[3], b[1] + b[3]) - max(a[1], b[1])
    return 3 * max(width, 0) * max(height, 0) >= max(min(a[2] * a[3], b[2] * b[3]), 1)


def is_true(event, box, begin, length):
    """Whether the event has the thing's place, and begins within 4 s or a tenth of the clip of it. In seconds."""
    return same_place(event, box) and abs(event["first"]["seconds"] - begin) <= max(4, length / 10)


def labels(clip, objects):
    """For each object: 1 = a visit's, 0 = nobody's, None = another one's part."""
    pairs = []
    for place, one in enumerate(objects):
        first, last = (one[end][clip.get("unit", "seconds")] for end in ("first", "last"))
        for visit, (_, begin, end) in enumerate(clip.get("visits") or []):
            share = (min(last, end) - max(first, begin)) / max(1e-6, max(last, end) - min(first, begin))
            if share >= .5:
                pairs.append((share, place, visit))
    found, met = [0] * len(objects), set()
    for _, place, visit in sorted(pairs, reverse=True):
        if found[place] != 1:
            found[place] = None if visit in met else 1
            met.add(visit)
    return found


def idf1(events, truth):
    """IDF1 [Ristani et al. 2016]; a frame counts where the event's path is in the identity's box, grown by a fifth."""
    hits, frames_of_events = np.zeros((len(truth), len(events))), 0
    for column, event in enumerate(events):
        known = [point["frame"] for point in event["path"]]
        frames = range(event["first"]["frame"], event["last"]["frame"] + 1)
        frames_of_events += len(frames)
        along = [np.interp(frames, known, [point["place"][axis] for point in event["path"]]) for axis in "xy"]
        for frame, x, y in zip(frames, *along):
            for row, boxes in enumerate(truth.values()):
                left, top, width, height = boxes.get(frame, (0, 0, -1, -1))
                hits[row, column] += abs(x - left - width / 2) <= .7 * width and abs(y - top - height / 2) <= .7 * height
    true = hits[linear_sum_assignment(hits, maximize=True)].sum()
    return 2 * true / max(1, frames_of_events + sum(map(len, truth.values())))


def measure(clip, found):
    """The numbers of FOUND."""
    things = [(kind, *thing) for kind in ("left", "taken") for thing in clip.get(kind, [])]
    told = [event for event in found["events"] if event["kind"] in ("left", "taken")]
    true = [[event["kind"] == kind and is_true(event, place, begin, found["span"]["last"]) for kind, *place, begin, _ in things]
            for event in told]
    good = [event for event, right in zip(told, true) if any(right)]
    others = [event for event in found["events"] if event not in good]
    visits = clip.get("visits")
    met = labels(clip, others).count(1)
    return np.array([met, len(visits or []), 0 if visits is None else len(others) - met, len(told), len(good),
                     sum(map(any, zip(*true))), len(things), idf1(found["events"], clip["paths"]) if "paths" in clip else np.nan])


def read_people(name, gt):
    """A clip with {identity: {frame, from 0: (x, y, width, height)}}."""
    paths = {}
    for line in open(gt):
        frame, identity, *box = map(float, line.split(",")[:6])
        paths.setdefault(identity, {})[int(frame) - 1] = box
    return {"clip": name, "paths": paths, "visits": [[who, min(at), max(at)] for who, at in paths.items()], "unit": "frame"}


def read_clips(options, folder):
    clips = [{**one, "clip": os.path.join(os.path.dirname(name), one["clip"]), "noted": True}
             for name in options.visits for one in json.load(open(name))]
    clips += [read_people(*one) for one in options.people]
    for scene, seed, visits in DRAWN:
        name = f"{folder}/{scene}{seed}.y4m"
        subprocess.run([f"{options.build}/tests/scene/vvr-scene", scene, name, "--size", "192x144", "--seed", str(seed),
                        "--noise", "5" if scene == "rain" else "0"], check=True)
        clips.append({"clip": name, "visits": visits, "weight": .5})
    return clips


def fit(samples):
    """Bias and weights of a logistic regression of (signs, truth, weight)."""
    signs, truth, weights = map(np.array, zip(*samples))
    mean, spread = signs.mean(0), signs.std(0) + 1e-9
    rows, weights = (signs - mean) / spread, weights / weights.mean()

    def loss(found):
        sums = found[0] + rows @ found[1:]
        return weights @ (np.logaddexp(0, sums) - truth * sums) + PRIOR / 2 * found[1:] @ found[1:]
    found = minimize(loss, np.zeros(1 + rows.shape[1])).x
    slopes = found[1:] / spread
    return [found[0] - slopes @ mean, *slopes]


def samples_of(clip, found):
    """What was left or taken is decided by its evidence. A clip counts as the root of its number of objects: one with much foliage
    doesn't outvote the others."""
    if clip.get("visits") is None:
        return []
    objects = [one for one in found["events"] + found["changes"] if one.get("kind") not in ("left", "taken")]
    known = [(list(one["signs"].values()), label) for one, label in zip(objects, labels(clip, objects)) if label is not None]
    return [(signs, label, clip.get("weight", 1) / np.sqrt(len(known))) for signs, label in known]


def total(clips, measured):
    """Of the clips noted by eye, and the mean IDF1."""
    counts = sum((one[:-1] for clip, one in zip(clips, measured) if "noted" in clip), np.zeros(len(FOUND) - 1))
    return np.append(counts, np.mean([one[-1] for clip, one in zip(clips, measured) if "paths" in clip] or np.nan))


def table_of(clips, measured):
    rows = [*zip([os.path.basename(clip["clip"]) for clip in clips], measured), ("all", total(clips, measured))]
    return table(("clip", "visits met", "extra", "told", "true", "things found", "IDF1"),
                 [(name, "%d of %d" % (met, of), "%d" % extra, "%d" % told, "%d" % true, "%d of %d" % (things, of_things),
                   "" if np.isnan(score) else "%.3f" % score)
                  for name, (met, of, extra, told, true, things, of_things, score) in rows])


def sensitivity(clips, run):
    clips = [clip for clip in clips if "weight" not in clip]
    trials = [{}] + [{"thresholds": {name: factor}} for name, _ in numbers(HEADER) for factor in (.75, 1.25)]
    found = run(clips, [trials] * len(clips))
    base, *others = [total(clips, [measure(clip, of_clip[k]) for clip, of_clip in zip(clips, found)]) for k in range(len(trials))]

    def change(now):
        moved = now - base
        parts = [f"{name} {value:+.3g}" for name, value in zip(FOUND, moved) if abs(value) >= .0005]
        return "! " * any(20 * abs(moved[k]) > base[k] for k in (0, -1)) + (", ".join(parts) or "=")
    return table(("threshold", "at 3/4", "at 5/4", "what it is"),
                 [(name, change(less), change(more), comment)
                  for (name, comment), less, more in zip(numbers(HEADER), others[::2], others[1::2])])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("--visits", action="append", default=[], metavar="TRUTH.json")
    parser.add_argument("--people", nargs=2, action="append", default=[], metavar=("CLIP", "GT"))
    for flag in ("--leave-out", "--fit", "--sensitivity"):
        parser.add_argument(flag, action="store_true")
    options = parser.parse_args()

    def find(clip, trials):
        lines = subprocess.run([f"{options.build}/tests/bench/events", clip["clip"]], input="\n".join(map(json.dumps, trials)),
                               check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
        return list(map(json.loads, lines))

    def run(clips, trials):
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            return list(pool.map(find, clips, trials))

    with tempfile.TemporaryDirectory() as folder:
        clips = read_clips(options, folder)
        def show(title, trials):
            found = [one for one, in run(clips, [[trial] for trial in trials])]
            print(title + "\n\n" + table_of(clips, list(map(measure, clips, found))), flush=True)
            return found
        found = show("As it is:", [{}] * len(clips))
        samples = list(map(samples_of, clips, found))
        if options.leave_out:
            show("Each with the weights that the others give:",
                 [{"weights": fit(sum(samples[:k] + samples[k + 1:], []))} for k in range(len(clips))])
        if options.fit:
            weights = fit(sum(samples, []))
            names = next(iter(one["signs"] for of_clip in found for one in of_clip["events"] + of_clip["changes"]))
            show(", ".join(f"{name} {weight:.2f}" for name, weight in zip(["bias", *names], weights)) + ":",
                 [{"weights": weights}] * len(clips))
        if options.sensitivity:
            print(sensitivity(clips, run))


if __name__ == "__main__":
    main()
