"""Runs one part of the benchmark once on something small, and looks at its report: smoke_test.py BUILD PART."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

HERE = pathlib.Path(__file__).parent
SKIPPED = 77  # what ctest takes for a test that was skipped
CLIPS = ("left_bag.mp4", "camera.mp4", "minute.mp4", "three_minutes.mp4", "minutes.mp4", "ten_frames.mkv")
LARGEST = 100_000  # bytes of a plot


def check(condition, text):
    if not condition:
        sys.exit(f"smoke_test.py: {text}")


def make_clips(build, folder):
    """One short clip under all the names that the parts know."""
    clip = folder / "clip.y4m"
    subprocess.run([build / "tests/scene/vvr-scene", "left_bag", clip, "--frames", "40", "--size", "96x72"], check=True)
    for name in CLIPS:
        subprocess.run(["ffmpeg", "-v", "error", "-i", clip, "-c:v", "mpeg4", folder / name], check=True)
    return clip


def check_slicing(report):
    """All ways to draw a volume draw the same samples, however one counts."""
    for volume in report["volumes"]:
        counts = {*volume["samples"].values(), volume["by_adding"]}
        check(len(counts) == 1 and min(counts) > 0, f"{volume['filter']}: samples were counted as {sorted(counts)}")


def check_memory(report):
    """Larger frames take more memory, so something is measured."""
    check(report["voxels"][-1]["megabytes"] > report["voxels"][0]["megabytes"], f"memory of larger frames: {report['voxels']}")


CHECKS = {"slicing": check_slicing, "growth": check_memory}


def main():
    build, part = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        print("there is no matplotlib, which scripts/bench installs")
        sys.exit(1 if os.environ.get("VVR_ALL_REQUIRED") == "1" else SKIPPED)
    with tempfile.TemporaryDirectory(prefix="vvr-bench-") as name:
        folder = pathlib.Path(name)
        clip = make_clips(build, folder)
        subprocess.run([sys.executable, "-B", HERE / "report.py", "--clip", clip, "--runs", "1", "--scale", "0.2", "--build", build,
                        "--clips", folder, "--out", folder, part], check=True, stdin=subprocess.DEVNULL)
        text = (folder / "report.md").read_text()
        numbers = json.loads((folder / "report.json").read_text())
        check("\n## " in text and "not found" not in text.replace("VTK not found", ""), f"the report says:\n{text}")
        check(part in numbers and numbers["machine"]["versions"]["renderer"], f"the numbers are {sorted(numbers)}")
        for plot in folder.glob("report-*.svg"):
            check(f"({plot.name})" in text, f"{plot.name} is not in the report")
            check(plot.stat().st_size < LARGEST, f"{plot.name} has {plot.stat().st_size} bytes")
            xml.etree.ElementTree.parse(plot)
        CHECKS.get(part, lambda report: None)(numbers[part])


if __name__ == "__main__":
    main()
