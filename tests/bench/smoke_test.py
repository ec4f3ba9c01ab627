"""Runs one part of the benchmark once on something small, and looks at its report: smoke_test.py BUILD PART."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).parent
CLIPS = ("left_bag.mp4", "vtest_h264.mp4", "camera.mp4", "camera_h265.mp4", "recorder.mp4", "camera_4k.mp4", "camera_4k_h265.mp4",
         "camera_file.mp4", "camera_h265_file.mp4", "recorder_file.mp4", "camera_4k_file.mp4",
         "minute.mp4", "three_minutes.mp4", "minutes.mp4", "ten_frames.mkv")


def check(condition, text):
    if not condition:
        sys.exit(f"smoke_test.py: {text}")


def make_clips(build, folder):
    """One short clip under all the names that the parts know."""
    clip = folder / "clip.y4m"
    subprocess.run([build / "tests/scene/vvr-scene", "left_bag", clip, "--frames", "40", "--size", "96x72"], check=True)
    for name in CLIPS:
        subprocess.run(["ffmpeg", "-v", "error", "-i", clip, "-c:v", "mpeg4", folder / name], check=True)
    (folder / "many").mkdir()
    for number in range(10):
        copy = shutil.copyfile(folder / CLIPS[0], folder / f"many/{number}.mp4")
        os.utime(copy, (time.time() - 3600,) * 2)  # an archive leaves what may still be written
    return clip


def check_events(build, folder, clip):
    """Of somebody who walks all the time, and puts something down."""
    (folder / "truth.json").write_text(json.dumps([{"clip": clip.name, "visits": [["person", 0, 1.6]], "left": [[60, 40, 8, 8, .5, 1]]}]))
    (folder / "gt.txt").write_text("".join(f"{frame},1,10,10,20,40\n" for frame in range(1, 41)))
    text = subprocess.run([sys.executable, "-B", HERE / "events.py", build, "--visits", folder / "truth.json", "--people", clip,
                           folder / "gt.txt", "--leave-out", "--fit", "--sensitivity"], check=True, stdout=subprocess.PIPE, text=True).stdout
    check(text.count("| all | ") == 3 and "bias" in text and "| event.probability | " in text, f"it says:\n{text}")


def main():
    build, part = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    with tempfile.TemporaryDirectory(prefix="vvr-bench-") as name:
        folder = pathlib.Path(name)
        clip = make_clips(build, folder)
        if part == "events":
            check_events(build, folder, clip)
            return
        subprocess.run([sys.executable, "-B", HERE / "report.py", "--clip", clip, "--runs", "1", "--scale", "0.2", "--build", build,
                        "--clips", folder, "--out", folder, part], check=True, stdin=subprocess.DEVNULL)
        text = (folder / "report.md").read_text()
        numbers = json.loads((folder / "report.json").read_text())
        check("\n## " in text and "not found" not in text, f"the report says:\n{text}")
        check(part in numbers and numbers["machine"]["versions"]["renderer"], f"the numbers are {sorted(numbers)}")


if __name__ == "__main__":
    main()
