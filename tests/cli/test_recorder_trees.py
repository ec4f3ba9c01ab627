"""Trees of files as recorders write them: camera, begin and order are those of the names, wherever one stands."""

import datetime
import re

import pytest
from harness import check

UTC = datetime.timezone.utc
# Two days; a second is only told where the layout has one.
BEGINS = [datetime.datetime(2026, 11, day, hour, minute, 7, tzinfo=UTC) for day, hour, minute in
          ((21, 8, 10), (21, 19, 45), (22, 7, 5), (22, 23, 50))]
CAMERAS = ("back-door", "front-door")

# Layouts in the words of strftime; {c} is the camera, {end} the time five minutes later in the form that follows it.
# tests/unit/footage/recorder_names_test.cpp has all of them.
TREES = {
    "hours": "{c}/%Y%m%d/%H/%M",
    "start and end": "{c}/%Y-%m-%d/%H-%M-%S_{end:%H-%M-%S}",
    "Frigate": "%Y-%m-%d/%H/{c}/%M.%S",
    "prefix in a folder": "recordings/{c} %Y-%m-%d %H.%M.%S",
}


def make_tree(t, tree):
    """By camera, the names of its files in the order of time, and when each begins."""
    files = {}
    for camera in CAMERAS:
        files[camera] = []
        for begin in BEGINS:
            begin = begin if "%S" in TREES[tree] else begin.replace(second=0)
            end = begin + datetime.timedelta(minutes=5)
            form = re.sub(r"\{end:(.*?)\}", lambda found, end=end: end.strftime(found[1]), TREES[tree])
            path = f"{tree}/{begin.strftime(form.replace('{c}', camera))}.avi"
            t.copy("clip.avi", path)
            files[camera].append((path, begin.strftime("%Y-%m-%d %H:%M:%S")))
    return files


def little_clip(t, name="clip.avi", size="32x24", rate=5, seconds=1):
    t.ffmpeg("-f", "lavfi", "-i", f"testsrc=size={size}:rate={rate}:duration={seconds}", "-c:v", "mjpeg", name)
    return name


def told(t, *names):
    """What `vvr info` says of each file."""
    return t.vvr("info", *names, "--json").expect(0, out=None).json()["files"]


def test_tree_tells_camera_begin_and_order(t):
    t.zone("UTC")
    little_clip(t)
    for tree in TREES:
        files = make_tree(t, tree)
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


def test_cameras_of_one_folder_are_several_days(t):
    t.zone("UTC")
    little_clip(t, seconds=2)
    t.copy("clip.avi", *[f"in/{camera}_2026-11-21_20-00-00.avi" for camera in CAMERAS])
    for command in (["render", "in", "-o", "x.png"], ["extract", "in", "-o", "data"], ["inspect", "in", "--frame", "0", "-o", "i.png"]):
        t.vvr(*command).expect(1, "'in'", "2 cameras", "back-door, front-door", "'in/back-door*.avi'", "--join", code="recording-mixed")
    out = t.archive("in", "-o", "out", "--per", "day", "--dry-run").expect(0, out=None).out
    for camera in CAMERAS:
        check(f"new             {camera}/2026-11-21\n                  {camera}_2026-11-21_20-00-00.avi  camera {camera}, "
              "2026-11-21 20:00:00 by file name (a date and a time)\n" in out, out)
    # All the same as one: then what is dropped is named.
    t.vvr("render", "in", "--join", "-o", "x.png", "--size", "160x100").expect(
        6, "1 file", "'in/front-door_2026-11-21_20-00-00.avi'", "10 frames", "2.0 s", code="partial")


@pytest.mark.nightly
def test_numbered_cameras(t):
    """Cameras that are named by a number or an address are several, and a count of files is none."""
    t.zone("UTC")
    little_clip(t, seconds=2)
    moments = ("20-00-00", "20-00-02")
    for cameras in (("video1", "video2"), ("192.168.1.10_01", "192.168.1.11_01"), ("01", "02")):
        folder = cameras[0]
        t.copy("clip.avi", *[f"{folder}/{camera}_2026-11-21_{moment}.avi" for camera in cameras for moment in moments])
        t.vvr("render", folder, "-o", "x.png").expect(1, f"2 cameras: {', '.join(cameras)}", code="recording-mixed")
        out = t.archive(folder, "-o", "out", "--per", "day", "--dry-run").expect(0, out=None).out
        days = [line.split()[1] for line in out.splitlines() if line.startswith("new")]
        check(sorted(days) == [f"{camera}/2026-11-21" for camera in cameras], out)
    # A day that was drawn before a second file showed the cameras goes with --prune.
    look = ("--size", "160x100", "--backend", "software", "--write", "pictures,index")
    for number, moment in (("01", moments[0]), ("02", "20-01-00")):
        t.copy("clip.avi", f"grows/{number}_2026-11-21_{moment}.avi")
    t.age("grows")
    t.archive("grows", "-o", "days", "--per", "day", *look).expect(0, "2026-11-21: ")
    t.copy("clip.avi", "grows/01_2026-11-21_20-02-00.avi")
    t.age("grows")
    t.archive("grows", "-o", "days", "--per", "day", "--prune", *look).expect(
        0, "01/2026-11-21: ", "02/2026-11-21: ", "2026-11-21: its clips belong to other days now, so its picture was removed")
    check(not t.path("days/2026-11-21.png").exists() and t.path("days/01/2026-11-21.png").exists(), "the day of no camera")
    t.copy("clip.avi", "01_20261121200000.avi")
    check("camera not known (--camera-name names it)" in t.vvr("info", "01_20261121200000.avi", "--quick").expect(0, out=None).out, "no next step")
    check(t.vvr("info", "01_20261121200000.avi", "--camera-name", "01", "--json").expect(0, out=None).json()["files"][0]["camera"] == "01", "named")
    t.copy("clip.avi", *[f"counted/clip{n}_2026-11-21_20-00-0{2 * n}.avi" for n in range(4)])
    check({clip["camera"] for clip in told(t, "counted")} == {None}, f"{told(t, 'counted')}")


@pytest.mark.nightly
def test_files_of_the_same_second_are_named(t):
    little_clip(t, seconds=2)
    t.copy("clip.avi", *[f"d/2026-11-21_10-00-00_{number}.avi" for number in range(9)])
    # The first; as much of the second as comes after it; nothing of the others.
    done = t.vvr("render", "d", "-o", "o.png", "--report", "r.json", "--size", "160x100", "--backend", "software").expect(
        6, "8 files", "'d/2026-11-21_10-00-00_1.avi'", "3 more", "80 frames", "16.0 s", code="partial")
    report = t.json("r.json")
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
    t.copy("door.avi", "gate_2026-11-21_20-00-00.avi")
    t.vvr("render", "gate_2026-11-21_20-00-00.avi", "slow.avi", *look).expect(
        1, "2 cameras", "'slow.avi'", "gate_2026-11-21_20-00-00.avi'", code="recording-mixed")
    t.vvr("render", "door.avi", "phone.avi", "--join", *look).expect(0, "10 frames")
    # Beside pictures a clip is not drawn, and that is said.
    t.ffmpeg("-i", "door.avi", "mixed/%d.png")
    t.copy("door.avi", "mixed/clip.avi")
    t.vvr("render", "mixed", *look).expect(0, "warning: 'mixed'", "1 video in it is ignored: 'mixed/clip.avi'")


def test_dry_run_shows_what_names_hide(t):
    little_clip(t)
    t.copy("clip.avi", "in/a\u202eiva.\n.avi")
    out = t.archive("in", "-o", "out", "--dry-run").expect(0, out=None).out
    check("\u202e" not in out and len(out.splitlines()) == 1 and "\\u202e" in out, repr(out))
    check(out.endswith("camera not known, time of day not known\n"), repr(out))


LOOK = ("-o", "x.png", "--size", "160x100", "--backend", "software", "--report", "r.json")


def size_of(t):
    field = t.json("r.json")["field"]
    return [field["width"], field["height"]]


def test_streams_and_times_that_recorders_confuse(t):
    t.zone("UTC")
    little_clip(t, seconds=2)
    little_clip(t, "small.avi", size="16x12", seconds=2)
    # Of a camera's two streams the large one is drawn, and that is said, without a status.
    for moment in ("080007_080009", "080009_080011"):
        t.copy("clip.avi", f"yard/RecM01_20261121_{moment}_1.avi")
        t.copy("small.avi", f"yard/RecS01_20261121_{moment}_2.avi")
    t.vvr("render", "yard", *LOOK).expect(0, "2 files", "small stream are not drawn")
    check(t.json("r.json")["left_out"]["files"] == 0, "left out")
    # One alone is drawn.
    t.copy("small.avi", *[f"sub/RecS01_20261121_08000{n}_1.avi" for n in (1, 3)])
    check("small stream" not in t.vvr("render", "sub", *LOOK).expect(0, out=None).err, "the small stream is all there is")
    # A camera that had no clock has no times.
    t.copy("clip.avi", *[f"gate/1970-01-01/02-0{n}-36.avi" for n in (0, 1)], "gate/2026-11-21/14-02-10.avi")
    t.vvr("render", "gate", *LOOK).expect(0, "2 files are dated 1970")
    t.vvr("render", "gate/1970-01-01/02-00-36.avi", *LOOK).expect(0, "1 file is dated 1970")
    done = t.archive("gate", "-o", "days", "--per", "day", "--dry-run").expect(0, "2 files are dated 1970", out=None)
    check("/1970-" not in done.out.replace("1970-01-01/02", "") and "time of day not known: the camera did not know it" in done.out, done.out)


def test_size_is_that_of_the_first_file_that_is_drawn(t):
    t.zone("UTC")
    little_clip(t, "day.avi", size="64x36", seconds=2)
    little_clip(t, "night.avi", size="48x54", seconds=2)
    t.copy("day.avi", "in/2026-11-21_08-00-00.avi")
    t.copy("night.avi", "in/2026-11-21_20-00-00.avi")
    t.vvr("render", "in", *LOOK).expect(0, out=None)
    check(size_of(t) == [64, 36], f"{t.json('r.json')['field']}")
    t.vvr("render", "in", "--start", "@19:00", *LOOK).expect(0, out=None)
    check(size_of(t) == [48, 54], f"{t.json('r.json')['field']}")


def test_rate_aspect_and_track_hold_or_say_why_not(t):
    little_clip(t, "ten.avi", rate=10, seconds=2)
    t.ffmpeg("-i", "ten.avi", "-c:v", "libx264", "-r", "10", "in/hour002.h264")
    t.ffmpeg("-i", "ten.avi", "-c:v", "mpeg4", "-r", "20", "in/hour001.m4v")
    shown = t.vvr("info", "ten.avi", "--rate", "2", "--quick").expect(0, out=None).out
    check("2 frames per second" in shown and "10.000 s" in shown, shown)
    t.vvr("render", "in/hour002.h264", *LOOK).expect(0, "no timestamps", "--rate")
    check("no timestamps" not in t.vvr("render", "in/hour002.h264", "--rate", "40", *LOOK).expect(0, out=None).err, "asked")
    check(abs(t.json("r.json")["span"]["last"] - 19 / 40) < 0.01, f"{t.json('r.json')['span']}")
    # A recording of two that state different rates.
    t.vvr("render", "in", *LOOK).expect(1, code="recording-mixed")
    t.vvr("render", "in", "--rate", "40", "--join", *LOOK).expect(0, out=None)
    # Seeking and sampling use the same clock.
    t.vvr("render", "ten.avi", "--rate", "1", "--start", "5s", "--end", "15s", *LOOK).expect(0, out=None)
    check(t.json("r.json")["frames"]["used"] == 10, f"{t.json('r.json')['frames']}")
    t.vvr("cut", "ten.avi", "--rate", "1", "--start", "5s", "--end", "15s", "-o", "piece.avi").expect(0, out=None)
    # Half of the width.
    little_clip(t, "half.avi", size="48x54")
    t.vvr("render", "half.avi", "--aspect", "16:9", *LOOK).expect(0, out=None)
    check(size_of(t) == [96, 54], f"{t.json('r.json')['field']}")
    t.vvr("render", "half.avi", "--aspect", "16", *LOOK).expect(1, "'16'", code="option-value")
    # Two tracks.
    t.ffmpeg("-i", "ten.avi", "-i", "half.avi", "-map", "0:v", "-map", "1:v", "-c", "copy", "two.mkv")
    t.vvr("render", "two.mkv", *LOOK).expect(0, "2 video tracks", "--track")
    for track, size in ((1, [32, 24]), (2, [48, 54])):
        said = t.vvr("render", "two.mkv", "--track", str(track), *LOOK).expect(0, out=None).err
        check("video tracks" not in said and size_of(t) == size, f"{said} {t.json('r.json')['field']}")
    t.vvr("render", "two.mkv", "--track", "3", *LOOK).expect(3, "track 3", "2 video tracks", code="no-video-stream")
    # Pictures.
    t.ffmpeg("-i", "half.avi", "pictures/%d.png")
    t.vvr("render", "pictures", "--aspect", "16:9", *LOOK).expect(0, "track and aspect have no effect", "25 frames per second")
