"""Times `vvr render` against `ffmpeg -f null` in turn, and says how much memory it took. See scripts/bench."""

import os
import statistics
import subprocess
import sys
import tempfile
import time

VVR = "build/release/cli/vvr"


def run(command):
    """Runs a command; its seconds, and the most memory it held in MB."""
    begin = time.monotonic()
    child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        sys.exit(f"bench: {' '.join(command)} ended with {child.returncode}")
    return time.monotonic() - begin, usage.ru_maxrss / 1024


def describe(name, values, unit):
    print(f"{name:<28} median {statistics.median(values):8.2f} {unit}, {min(values):.2f} to {max(values):.2f}")


def main():
    clip, looped, runs = sys.argv[1], sys.argv[2], int(sys.argv[3])
    with tempfile.TemporaryDirectory() as folder:
        picture = os.path.join(folder, "bench.png")
        decode = ["ffmpeg", "-v", "error", "-i", clip, "-f", "null", "-"]

        def render(name):
            return [VVR, "render", name, "-o", picture, "--size", "1280x800", "--backend", "software", "--quiet"]

        run(decode), run(render(clip))  # once for the caches
        decoded, rendered = [], []
        for _ in range(runs):
            decoded.append(run(decode))
            rendered.append(run(render(clip)))
        long = run(render(looped))

    print(f"{clip}, 1280x800, software rasteriser, {os.cpu_count()} cores, {runs} runs in turn")
    describe("ffmpeg -f null", [seconds for seconds, _ in decoded], "s")
    describe("vvr render", [seconds for seconds, _ in rendered], "s")
    ratio = statistics.median(seconds for seconds, _ in rendered) / statistics.median(seconds for seconds, _ in decoded)
    print(f"{'ratio of the medians':<28} {ratio:.2f}")
    describe("peak memory", [memory for _, memory in rendered], "MB")
    share = long[1] / statistics.median(memory for _, memory in rendered)
    print(f"{'the clip ten times over':<28} {long[0]:.2f} s, peak memory {long[1]:.0f} MB, {100 * share:.1f} % of the clip's")


if __name__ == "__main__":
    main()
