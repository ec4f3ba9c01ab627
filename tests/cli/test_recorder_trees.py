"""Trees of files as recorders write them: camera, begin and order are those of the names, wherever one stands."""

import datetime
import json
import os
import re

import pytest
from harness import check

UTC = datetime.timezone.utc
# Two days; a second is only told where the layout has one.
BEGINS = [datetime.datetime(2026, 11, day, hour, minute, 7, tzinfo=UTC) for day, hour, minute in
          ((21, 8, 10), (21, 19, 45), (22, 7, 5), (22, 23, 50))]
CAMERAS = ("back-door", "front-door")

# Layouts in the words of strftime; {c} is the camera, {end} the time five minutes later in the form that follows it.
TREES = {
    "plain": "%Y-%m-%d/{c}/%H-%M-%S",
    "dots": "{c}/%Y-%m-%d/%H.%M.%S",
    "folders": "{c}/%Y/%m/%d/%H-%M-%S",
    "hours": "{c}/%Y%m%d/%H/%M",
    "start and end": "{c}/%Y-%m-%d/%H-%M-%S_{end:%H-%M-%S}",
    "whole start and end": "{c}_%Y-%m-%d_%H-%M-%S_{end:%Y-%m-%d_%H-%M-%S}",
    "Frigate": "%Y-%m-%d/%H/{c}/%M.%S",
    "old Frigate": "%Y-%m/%d/%H/{c}/%M.%S",
    "Frigate's clips": "{c}-%s.123456-ab12cd",
    "six digits": "{c}/%Y-%m-%d/%H%M%S",
    "four digits": "{c}/%Y-%m-%d/%H%M",
    "minutes": "{c}/%Y-%m-%d/%H-%M",
    "underscores": "{c}/%Y_%m_%d/%H_%M_%S",
    "hour twice": "{c}/%Y-%m-%d/%H/%H-%M-%S",
    "minutes in hours": "{c}/%Y-%m-%d/%H/%M-%S",
    "hours below cameras": "%Y-%m-%d/{c}/%H/%M",
    "cameras below days": "%Y/%m/%d/{c}/%H%M%S",
    "camera in the name": "%Y-%m-%d/{c}_%H-%M-%S",
    "prefix": "{c}_%Y-%m-%d_%H-%M-%S",
    "prefix with dashes": "{c}-%Y%m%d-%H%M%S",
    "prefix in a folder": "recordings/{c} %Y-%m-%d %H.%M.%S",
    "channels": ("ch01_%Y%m%d%H%M%S", "ch02_%Y%m%d%H%M%S"),
    "ISO 8601": "{c}/%Y-%m-%dT%H-%M-%SZ",
    "phones": "{c}/VID_%Y%m%d_%H%M%S",
    "epoch": "{c}_%s",
    "milliseconds": "{c}/%s000",
    "Dahua": "{c}/%Y-%m-%d/001/dav/%H/%H.%M.%S-{end:%H.%M.%S}[M][0@0][0]",
    "Dahua without channels": "{c}/%Y-%m-%d/%H.%M.%S-{end:%H.%M.%S}[M][0@0][0]",
    "Reolink": "%Y/%m/%d/{c}_00_%Y%m%d%H%M%S",
    "Hikvision": ("192.168.1.64_01_%Y%m%d%H%M%S123", "192.168.1.64_02_%Y%m%d%H%M%S123"),
    "Synology": "%Y%m%dAM/{c}-%Y%m%d-%H%M%S-%s",
    "Blue Iris": "{c}.%Y%m%d_%H%M%S",
    "UniFi": "{c} %-m-%-d-%Y, %-H.%M.%S GMT+0 - %-m-%-d-%Y, %-H.%M.%S GMT+0",
    "ZoneMinder": ("events/1/%y/%m/%d/%H/%M/%S/17-video", "events/2/%y/%m/%d/%H/%M/%S/17-video"),
    "motion": "{c}/01-%Y%m%d%H%M%S",
    "Home Assistant": "{c}/{c}_%Y%m%d-%H%M%S",
    "Tesla": ("%Y-%m-%d_%H-%M-%S-back", "%Y-%m-%d_%H-%M-%S-front"),
    "Xiaomi": "{c}/%Y%m%d%H/%MM%SS_%s",
    "Yi": "{c}/%YY%mM%dD%HH/%MM%SS60",
}
NAMES_OF_CAMERAS = {"channels": ("ch01", "ch02"), "Hikvision": ("192.168.1.64_01", "192.168.1.64_02"),
                    "ZoneMinder": ("1", "2"), "Tesla": ("back", "front")}


def file_name(layout, camera, begin):
    end = begin + datetime.timedelta(minutes=5)
    text = re.sub(r"\{end:(.*?)\}", lambda form: end.strftime(form[1]), layout)
    return begin.strftime(text.replace("%s", str(int(begin.timestamp())))).replace("{c}", camera) + ".avi"


def make_tree(t, tree, folder):
    """By camera, the names of its files in the order of time, and when each begins."""
    layout = TREES[tree]
    layouts = layout if isinstance(layout, tuple) else (layout, layout)
    files = {}
    for camera, form, name in zip(CAMERAS, layouts, NAMES_OF_CAMERAS.get(tree, CAMERAS)):
        exact = "%S" in form or "%s" in form
        files[name] = []
        for begin in BEGINS:
            begin = begin if exact else begin.replace(second=0)
            path = f"{folder}/{file_name(form, camera, begin)}"
            t.path(path).parent.mkdir(parents=True, exist_ok=True)
            os.link(t.path("clip.avi"), t.path(path))
            files[name].append((path, begin.strftime("%Y-%m-%d %H:%M:%S")))
    return files


def little_clip(t, name="clip.avi", size="32x24", rate=5, seconds=1):
    t.ffmpeg("-f", "lavfi", "-i", f"testsrc=size={size}:rate={rate}:duration={seconds}", "-c:v", "mjpeg", name)
    return name


def told(t, *names, folder="."):
    """What `vvr info` says of each file."""
    return json.loads(t.run([t.vvr_path, "info", *names, "--json"], cwd=t.path(folder)).expect(0, out=None).out)["files"]


@pytest.mark.parametrize("part", range(3))
def test_tree_tells_camera_begin_and_order(t, part):
    t.zone("UTC")
    little_clip(t)
    for tree in list(TREES)[part::3]:
        files = make_tree(t, tree, tree)
        # An archive lists each clip with what it takes for true.
        lines = t.archive(tree, "-o", "pictures", "--dry-run").expect(0, out=None).out.splitlines()
        expected = {f"new             {path.removeprefix(tree + '/')}  camera {camera}, {begin} by file name"
                    for camera, clips in files.items() for path, begin in clips}
        check({line.rsplit(" (", 1)[0] for line in lines} == expected, f"{tree}: {lines}\n{expected}")
        # One picture of both cameras is refused, and the example that the error gives means the files of one.
        refusal = t.vvr("info", tree).expect(1, f"'{tree}'", "2 cameras", ", ".join(sorted(files)), code="recording-mixed").err
        example = re.search(r"for example '(.*?)',", refusal)[1]
        first = files[sorted(files)[0]]
        listed = told(t, example)
        check([(clip["file"], clip["begin"]) for clip in listed] == first, f"{tree}: {example} gives {listed}")
        check({clip["recorded_by"] for clip in listed} == {"file-name"}, f"{tree}: {listed}")


def test_tree_says_the_same_wherever_one_stands(t):
    t.zone("UTC")
    little_clip(t)
    path = "recordings/2026-11-21/22/gate/05.00.avi"
    t.path(path).parent.mkdir(parents=True)
    os.link(t.path("clip.avi"), t.path(path))
    folders = path.split("/")[:-1]
    for depth in range(len(folders) + 1):
        here, rest = "/".join(["."] + folders[:depth]), "/".join([*folders[depth:], "05.00.avi"])
        for name in (rest, os.path.dirname(rest) or "."):
            [clip] = told(t, name, folder=here)
            check((clip["camera"], clip["begin"]) == ("gate", "2026-11-21 22:05:00"), f"{name} in {here}: {clip}")
    # Folders that have nothing to do with it are no camera.
    t.path("home/user/videos/2026-11-21").mkdir(parents=True)
    os.link(t.path("clip.avi"), t.path("home/user/videos/2026-11-21/20-00-00.avi"))
    [clip] = told(t, "home/user/videos")
    check((clip["camera"], clip["begin"]) == (None, "2026-11-21 20:00:00"), f"{clip}")
    # Nor is anything told by names like these.
    for name in ("clip1.avi", "1280x720_30fps.avi", "IMG_0001.avi", "v1.20.30.avi", "03-04-2026_20-00-00.avi"):
        os.link(t.path("clip.avi"), t.path(name))
        [clip] = told(t, name)
        check((clip["camera"], clip["begin"], clip["recorded_by"]) == (None, None, "none"), f"{clip}")


def test_cameras_of_one_folder_are_several_days(t):
    t.zone("UTC")
    little_clip(t, seconds=2)
    t.path("in").mkdir()
    for camera in CAMERAS:
        os.link(t.path("clip.avi"), t.path(f"in/{camera}_2026-11-21_20-00-00.avi"))
    for command in (["render", "in", "-o", "x.png"], ["extract", "in", "-o", "data"], ["inspect", "in", "--frame", "0", "-o", "i.png"]):
        t.vvr(*command).expect(1, "'in'", "2 cameras", "back-door, front-door", "'in/back-door*.avi'", "--join", code="recording-mixed")
    out = t.archive("in", "-o", "out", "--per", "day", "--dry-run").expect(0, out=None).out
    check("new             back-door/2026-11-21\n                  back-door_2026-11-21_20-00-00.avi  camera back-door, "
          "2026-11-21 20:00:00 by file name (a date and a time)\nnew             front-door/2026-11-21\n" in out, out)
    # All the same as one: then what is dropped is named.
    t.vvr("render", "in", "--join", "-o", "x.png", "--size", "160x100").expect(
        6, "1 file", "'in/front-door_2026-11-21_20-00-00.avi'", "10 frames", "2.0 s", code="partial")


def test_files_of_the_same_second_are_named(t):
    little_clip(t, seconds=2)
    t.path("d").mkdir()
    for number in range(9):
        os.link(t.path("clip.avi"), t.path(f"d/2026-11-21_10-00-00_{number}.avi"))
    # The first; as much of the second as comes after it; nothing of the others.
    done = t.vvr("render", "d", "-o", "o.png", "--report", "r.json", "--size", "160x100", "--backend", "software").expect(
        6, "8 files", "'d/2026-11-21_10-00-00_1.avi'", "3 more", "80 frames", "16.0 s", code="partial")
    report = json.loads(t.path("r.json").read_text(encoding="utf-8"))
    check(report["left_out"] == {"files": 8, "frames": 80, "seconds": 16}, f"{report['left_out']} {done}")
    check(any("8 files were omitted" in problem for problem in report["problems"]), f"{report['problems']}")
    check(report["frames"]["used"] == 10, f"{report['frames']}")
    t.vvr("extract", "d", "-o", "data").expect(6, "8 files", code="partial")
    t.archive(".", "-o", "out", "--per", "day", "--match", "d/*.avi", "--size", "160x100", "--backend", "software").expect(
        6, "8 files", "1 clip drawn, 0 failed", code="partial")
    t.archive(".", "-o", "out", "--per", "day", "--match", "d/*.avi", "--size", "160x100", "--backend", "software").expect(
        0, "nothing to do; 1 done before")


def test_unrelated_clips_are_refused(t):
    little_clip(t, "phone.avi", size="64x48")
    little_clip(t, "door.avi")
    little_clip(t, "slow.avi", rate=1, seconds=3)
    look = ("-o", "x.png", "--size", "160x100", "--backend", "software")
    t.vvr("render", "door.avi", "phone.avi", *look).expect(
        1, "'door.avi'", "32x24", "'phone.avi'", "64x48", "--join", code="recording-mixed")
    t.vvr("render", "door.avi", "slow.avi", *look).expect(1, "'slow.avi'", "1 frames per second", "--join", code="recording-mixed")
    os.link(t.path("door.avi"), t.path("gate_2026-11-21_20-00-00.avi"))
    t.vvr("render", "gate_2026-11-21_20-00-00.avi", "slow.avi", *look).expect(
        1, "2 cameras", "'slow.avi'", "gate_2026-11-21_20-00-00.avi'", code="recording-mixed")
    t.vvr("render", "door.avi", "phone.avi", "--join", *look).expect(0, "10 frames")
    # Beside pictures a clip is not drawn, and that is said.
    t.path("mixed").mkdir()
    t.ffmpeg("-i", "door.avi", "mixed/%d.png")
    os.link(t.path("door.avi"), t.path("mixed/clip.avi"))
    t.vvr("render", "mixed", *look).expect(0, "warning: 'mixed'", "1 video in it is ignored: 'mixed/clip.avi'")


def test_dry_run_shows_what_names_hide(t):
    little_clip(t)
    t.path("in").mkdir()
    os.link(t.path("clip.avi"), t.path("in/a\u202eiva.\n.avi"))
    out = t.archive("in", "-o", "out", "--dry-run").expect(0, out=None).out
    check("\u202e" not in out and len(out.splitlines()) == 1 and "\\u202e" in out, repr(out))
    check(out.endswith("camera not known, time of day not known\n"), repr(out))
