"""How often `vvr render` finds a bag that was left or taken: bags are pasted into real footage.

Each bag appears at the feet of a person whom `vvr` follows, behind them, and stays until the end. Whatever is in front of it hides
it. With --backwards the video runs backwards, and the bag is taken. events.py says when a claim is true; the bag begins when
less than a tenth of it is hidden.
Claims that `vvr` makes about the clip itself don't count. The whole clip is kept in memory, uncompressed.

Usage: pasted_bags.py VVR CLIP [--bags 12] [--seed 1] [--backwards]"""
import argparse
import json
import pathlib
import random
import subprocess
import sys
import tempfile
from dataclasses import dataclass

import numpy as np

from events import box_of, is_true, same_place

SHADE = 28  # grey levels: what differs by more from the median of the frames is a person, or another object


@dataclass
class Clip:
    frames: np.ndarray  # number, height, width, 3
    rate: str  # frames per second, as a fraction
    scene: np.ndarray  # the median of some frames

    @property
    def fps(self):
        numerator, denominator = self.rate.split("/")
        return int(numerator) / int(denominator)

    @property
    def seconds(self):
        return len(self.frames) / self.fps


@dataclass
class Bag:
    box: tuple  # x, y, width, height
    seconds: float  # when it appears
    picture: np.ndarray
    opacity: np.ndarray


def read(name):
    probe = subprocess.run(["ffprobe", "-v", "error", "-select_streams", "v:0", "-show_entries", "stream=width,height,r_frame_rate",
                            "-of", "csv=p=0", name], check=True, capture_output=True, text=True).stdout
    width, height, rate = probe.strip().split(",")[:3]
    raw = subprocess.run(["ffmpeg", "-v", "error", "-i", name, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"], check=True,
                         capture_output=True).stdout
    frames = np.frombuffer(raw, np.uint8).reshape(-1, int(height), int(width), 3)
    some = frames[np.linspace(0, len(frames) - 1, 25).astype(int)]
    return Clip(frames, rate, np.median(some, 0).astype(np.float32))


def write(name, clip, frames):
    height, width = clip.frames.shape[1:3]
    command = ["ffmpeg", "-v", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}", "-r", clip.rate, "-i",
               "-", "-c:v", "libx264", "-preset", "ultrafast", "-crf", "18", "-g", "100", "-pix_fmt", "yuv420p", name]
    with subprocess.Popen(command, stdin=subprocess.PIPE) as child:
        for frame in frames:
            child.stdin.write(frame.tobytes())
    if child.returncode != 0:
        sys.exit(f"pasted_bags.py: {' '.join(command)} ended with {child.returncode}")


def report_of(vvr, name, *options):
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "report.json"
        subprocess.run([vvr, "render", name, "--report", report, "--quiet", *options], check=True)
        return json.loads(report.read_text())


def people_of(vvr, name):
    """[(frame, from 0; the frames of the track: first, last; (x, y, width, height))] of all that moves, frame by frame"""
    with tempfile.TemporaryDirectory() as folder:
        tracks = pathlib.Path(folder) / "tracks.txt"
        events = report_of(vvr, name, "--tracks", tracks)["events"]
        lines = [[float(value) for value in line.split(",")[:6]] for line in tracks.read_text().splitlines()]
    spans = {event["number"]: (event["first"]["frame"], event["last"]["frame"]) for event in events if event["kind"] in ("moved", "stood")}
    return [(int(frame) - 1, spans[number], box) for frame, number, *box in lines if number in spans]


def blurred(mask, reach):
    """The mean of the square of `reach` pixels around each pixel."""
    side = 2 * reach + 1
    windows = np.lib.stride_tricks.sliding_window_view(np.pad(mask.astype(np.float32), reach, mode="edge"), (side, side))
    return windows.mean((2, 3))


def make_bag(clip, person, dice):
    """A bag at the feet of somebody; None if it would be too small, or would not be alone for long."""
    frame, (first, last), (x, y, across, tall) = person
    seconds = frame / clip.fps
    goes_on = frame >= first + clip.fps and frame + 1.5 * clip.fps <= last
    if not goes_on or not 3 <= seconds <= clip.seconds - 16 or not 20 <= tall <= 0.85 * clip.scene.shape[0]:
        return None
    size = tall * dice.uniform(0.2, 0.33)
    width, height = max(7, int(size * dice.uniform(0.7, 1.2))), max(7, int(size * dice.uniform(0.6, 1)))
    left, top = int(x + across / 2 + width * (dice.uniform(-0.3, 0.3) - 0.5)), int(y + tall - height)
    if left < 4 or top < 4 or left + width > clip.scene.shape[1] - 4 or top + height > clip.scene.shape[0] - 4:
        return None
    behind = clip.scene[top:top + height, left:left + width].mean((0, 1))
    while True:
        grey = dice.uniform(5, 220)
        colour = np.clip(grey + dice.choice([0.2, 0.5, 1]) * np.array([dice.uniform(-110, 110) for _ in range(3)]), 0, 255)
        if np.abs(colour - behind).max() > 40:
            break
    v, u = np.mgrid[-1:1:height * 1j, -1:1:width * 1j]
    folds = 1 + 0.18 * np.sin(5 * u + dice.uniform(0, 6)) + 0.15 * (v < -0.3) - 0.2 * (np.abs(v) < 0.12) + 0.1 * u
    return Bag((left, top, width, height), seconds, np.clip(colour * folds[..., None], 0, 255), blurred(u**4 + v**4 < 1, 1))


def paste(clip, bag):
    """The frames with the bag, and the second from which less than a tenth of it is hidden; None if it never is."""
    left, top, width, height = bag.box
    part = np.s_[top:top + height, left:left + width]
    noise = np.random.default_rng(1)
    frames, seen = list(clip.frames), None
    for number in range(int(bag.seconds * clip.fps), len(frames)):
        behind = frames[number][part].astype(np.float32)
        differs = blurred(np.abs(behind - clip.scene[part]).max(2), 1) > 0.8 * SHADE
        hidden = np.clip(2.5 * blurred(differs, 2), 0, 1)
        if seen is None and hidden.mean() < 0.1:
            seen = number / clip.fps
        opacity = (bag.opacity * (1 - hidden))[..., None]
        picture = bag.picture + noise.normal(0, 2, (height, width, 1))
        frames[number] = frames[number].copy()
        frames[number][part] = np.clip(behind * (1 - opacity) + picture * opacity, 0, 255).astype(np.uint8)
    return frames, seen


def claims_of(report, kind):
    return [event for event in report["events"] if event["kind"] == kind]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("vvr")
    parser.add_argument("clip")
    parser.add_argument("--bags", type=int, default=12)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--backwards", action="store_true")
    options = parser.parse_args()
    kind = "taken" if options.backwards else "left"
    step = -1 if options.backwards else 1
    clip, dice = read(options.clip), random.Random(options.seed)
    people = people_of(options.vvr, options.clip)
    dice.shuffle(people)
    found = claims = pasted = 0
    with tempfile.TemporaryDirectory() as folder:
        name = str(pathlib.Path(folder) / "clip.mp4")
        write(name, clip, clip.frames[::step])
        own = [box_of(event) for event in claims_of(report_of(options.vvr, name), kind)]
        for person in people:
            if pasted == options.bags:
                break
            bag = make_bag(clip, person, dice)
            frames, seen = paste(clip, bag) if bag else (None, None)
            if seen is None or seen > clip.seconds - 12:
                continue
            pasted += 1
            write(name, clip, frames[::step])
            told = [event for event in claims_of(report_of(options.vvr, name), kind)
                    if not any(same_place(event, box) for box in own)]
            since = clip.seconds - seen if options.backwards else seen
            true = [event for event in told if is_true(event, bag.box, since, clip.seconds)]
            found += bool(true)
            claims += len(told)
            print(f"{kind} at {since:5.1f} s, {bag.box[2]:3}x{bag.box[3]:<3} at {bag.box[0]},{bag.box[1]}: "
                  f"{'found' if true else 'not found'}, {len(told) - len(true)} other claims", flush=True)
    print(f"{found} of {pasted} found; of {claims} claims {found} true")


if __name__ == "__main__":
    main()
