"""Whether anything has become worse. Instructions of four kernels on fixed input, counted by valgrind, and ratios of things
that run in turn: neither depends on what else the machine does. Ends with 1 where something is worse, and says what."""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

from measure import in_turn

BUILD = "build/release"
VVR = f"{BUILD}/cli/vvr"
KNOWN = pathlib.Path(__file__).parent / "known.json"
TOLERANCE = {"instructions": 0.03, "processor time": 0.15}  # compilers and C libraries differ by that much; machines by more


def instructions_of(kernel):
    done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", "--collect-atstart=no",
                           "--toggle-collect=vvr_counted", f"{BUILD}/tests/bench/counted_kernels", kernel],
                          check=True, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
    return int(re.search(r"Collected : (\d+)", done.stderr).group(1))


def instructions():
    if "rdtscp" not in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").split():
        print("left out: instructions. valgrind ends libhwy, which reads the time by RDTSCP, and this processor doesn't have that")
        return {}
    return {f"instructions of {kernel}": instructions_of(kernel) for kernel in ("jacobi", "flow", "fields", "events")}


def least_times(commands, runs=5):
    """The least processor time of each, run in turn."""
    return {name: min(run.processor for run in of) for name, of in in_turn(commands, runs).items()}


def processor_times(clip):
    """Of a picture over FFmpeg's, and of a page over a picture."""
    with tempfile.TemporaryDirectory() as folder:
        render = [VVR, "render", clip, "--backend", "software", "--quiet", "-o"]
        least = least_times({"ffmpeg": ["ffmpeg", "-v", "error", "-i", clip, "-vf", "scale=384:288,format=gray", "-f", "null", "-"],
                             "picture": [*render, f"{folder}/out.png"], "page": [*render, f"{folder}/out.html"]})
    return {"processor time of `vvr render` over FFmpeg's": least["picture"] / least["ffmpeg"],
            "processor time of a page over a picture's": least["page"] / least["picture"]}


def main():
    options = argparse.ArgumentParser(prog="scripts/bench --check", description=__doc__)
    options.add_argument("--clip", required=True)
    options.add_argument("--renew", action="store_true", help="store the numbers of now, after a change that is meant")
    given = options.parse_args()
    numbers = instructions() | processor_times(given.clip)
    known = json.loads(KNOWN.read_text())
    if given.renew:
        known |= {name: round(number, 2) for name, number in numbers.items()}
        KNOWN.write_text(json.dumps(known, indent=1) + "\n")
    worse = []
    for name, number in numbers.items():
        tolerance = next(part for start, part in TOLERANCE.items() if name.startswith(start))
        is_worse = number > known[name] * (1 + tolerance)
        print(f"{'WORSE' if is_worse else 'ok   '} {name}: {number:.2f}, stored {known[name]:.2f}, at most {100 * tolerance:.0f} % more")
        if is_worse:
            worse.append(name)
    if worse:
        sys.exit(f"bench: worse than it was: {', '.join(worse)}")


if __name__ == "__main__":
    main()
