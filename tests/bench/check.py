"""Whether anything has become worse. Instructions of three kernels on fixed input, counted by valgrind, and ratios of things
that run in turn: neither depends on what else the machine does. Ends with 1 where something is worse, and says what."""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

from measure import in_turn, median

BUILD = "build/release"
VVR = f"{BUILD}/cli/vvr"
COUNTS = pathlib.Path(__file__).parent / "counts.json"
TOLERANCE = 0.03  # of a count: compilers and C libraries differ by that much


def instructions(kernel):
    done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", "--collect-atstart=no",
                           "--toggle-collect=vvr_counted*", f"{BUILD}/tests/bench/counted_kernels", kernel],
                          check=True, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
    return int(re.search(r"Collected : (\d+)", done.stderr).group(1))


def check_counts(renew):
    known = json.loads(COUNTS.read_text()) if COUNTS.exists() else {}
    counts = {kernel: instructions(kernel) for kernel in ("jacobi", "flow", "fields")}
    if renew:
        COUNTS.write_text(json.dumps(counts, indent=1) + "\n")
        known = counts
    for kernel, count in counts.items():
        yield f"instructions of {kernel}", count / known[kernel], 1 + TOLERANCE


def least_times(commands, runs=5):
    """The least processor time of each, run in turn."""
    return [min(run.processor for run in of) for of in in_turn(dict(enumerate(commands)), runs).values()]


def check_ratios(clip):
    with tempfile.TemporaryDirectory() as folder:
        ours, floor = least_times([[VVR, "render", clip, "-o", f"{folder}/out.png", "--backend", "software", "--quiet"],
                                   ["ffmpeg", "-v", "error", "-i", clip, "-vf", "scale=384:288,format=gray", "-f", "null", "-"]])
    yield "processor time of `vvr render` over FFmpeg's", ours / floor, 3.5
    version, whole = least_times([[VVR, "--version"], [VVR, "--help"]], 9)
    yield "`vvr --version` over `vvr --help`", version / whole, 0.5
    runs = in_turn({"once": [VVR, "--version"]}, 9)["once"]
    yield "milliseconds of `vvr --version`", 1000 * median([run.seconds for run in runs]), 50


def main():
    options = argparse.ArgumentParser(prog="scripts/bench --check", description=__doc__)
    options.add_argument("--clip", required=True)
    options.add_argument("--renew", action="store_true", help="store the counts of now, after a change that is meant")
    given = options.parse_args()
    worse = []
    for checks in (check_counts(given.renew), check_ratios(given.clip)):
        for name, value, limit in checks:
            print(f"{'ok   ' if value <= limit else 'WORSE'} {name}: {value:.3f}, at most {limit:.3f}", flush=True)
            if value > limit:
                worse.append(name)
    if worse:
        sys.exit(f"bench: worse than it was: {', '.join(worse)}")


if __name__ == "__main__":
    main()
