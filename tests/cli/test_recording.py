"""Many files are one recording: what a recorder writes in segments is drawn as one clip."""

import datetime
import os
import shutil
import subprocess
import time

import pytest
from harness import check, moving_clip, page_data

MIDNIGHT = datetime.datetime(2026, 11, 21, 23, 59, 40)
LOOK = ("--size", "320x200", "--backend", "software", "--title", "gate", "--start-time", "none")


def whole_clip(t, seconds=40):
    """A square that crosses the scene again and again; key frames each second."""
    t.ffmpeg("-f", "lavfi", "-i", f"color=gray:size=96x64:rate=10:duration={seconds}", "-f", "lavfi", "-i",
             f"color=white:size=16x16:rate=10:duration={seconds}", "-filter_complex",
             "[0][1]overlay=x='mod(12*t,120)-20':y=20:eval=frame", "-c:v", "mpeg4", "-g", "10", "-q:v", "3", "whole.mkv")
    return "whole.mkv"


def cut(t, clip="whole.mkv", seconds=10, begin=MIDNIGHT, layout="day/%Y-%m-%d/%H/gate/%M.%S.mkv", least=None):
    """The files that a recorder would have written, each to the first key frame after `least` seconds."""
    t.ffmpeg("-i", clip, "-c", "copy", "-f", "segment", "-segment_time", str(least or seconds),
             "-reset_timestamps", "1", "cut/%04d" + layout[layout.rindex("."):])
    names = []
    for number, piece in enumerate(sorted(t.path("cut").iterdir())):
        names.append((begin + datetime.timedelta(seconds=number * seconds)).strftime(layout))
        t.folder_of(names[-1])
        piece.rename(t.path(names[-1]))
    return names


def report_of(t, *arguments, says=()):
    """That of a picture."""
    t.render(*arguments, "--report", "r.json", output=None).expect(0, *says)
    return t.json("r.json")


def test_recording_of_segments_equals_the_whole_clip(t):
    whole_clip(t)
    t.render("whole.mkv", *LOOK, output="whole.png").expect(0, "400 frames")
    names = cut(t)
    check(len(names) == 4, f"{names}")
    t.write("day/all.txt", "# of the gate\n" + "\n".join(name.removeprefix("day/") for name in reversed(names)) + "\n")
    # Patterns are those of `cut` too (cut_joins_the_files_of_a_recording).
    for number, given in enumerate([["day"], list(reversed(names)), ["day/all.txt"]]):
        t.render(*given, *LOOK, output=f"{number}.png").expect(0, "400 frames")
        check(t.path(f"{number}.png").read_bytes() == t.path("whole.png").read_bytes(), f"{given} make another picture")
    # The reference is learnt of key frames where there are enough of them, else of all frames.
    t.render("whole.mkv", *LOOK, "--end", "20s", output="short.png").expect(0)
    t.render("day", *LOOK, "--end", "20s", output="short day.png").expect(0)
    check(t.path("short.png").read_bytes() == t.path("short day.png").read_bytes(), "another picture of the first 20 s")
    for command in (["extract", "whole.mkv", "-o", "a"], ["extract", "day", "-o", "b"]):
        t.vvr(*command).expect(0, "400 frames")
    files = [name.removeprefix("a/") for name in t.files() if name.startswith("a/scalar/")]
    other = [name for name in files if t.path(f"a/{name}").read_bytes() != t.path(f"b/{name}").read_bytes()]
    check(len(files) == 400 and other == [], f"other values in {other} of {len(files)} files")
    t.vvr("inspect", "day", "--frame", "25s", "-o", "i.png").expect(0, "frame 250 at 25.000 s")
    told = t.vvr("info", "day", "--json").expect(0, out=None).json()
    check(told["frames"] == 400 and told["recorded"] == "2026-11-21 23:59:40", f"{told}")


def test_recording_has_gaps_where_files_are_missing(t):
    whole_clip(t)
    names = cut(t)
    t.path(names[1]).unlink()
    report = report_of(t, "day", *LOOK, says=["300 frames in 400 layers"])
    check(any(label["text"] == "no footage" for label in report["labels"]), f"{report['labels']}")
    check([segment["first_frame"] for segment in report["segments"]] == [0, 200, 300], f"{report['segments']}")
    check(report["problems"] == [], f"{report['problems']}")
    check(report["span"]["last"] == 39.9, f"{report['span']}")
    said = t.vvr("info", "day", "--quick").expect(0, out=None).out
    check("400, from the containers and the gaps between the files" in said, said)


def test_a_hole_in_a_file_is_a_gap(t):
    """Nobody knows what happened in it: it is no footage, no event spans it, and all commands number frames alike."""
    whole_clip(t)
    t.ffmpeg("-i", "whole.mkv", "-c", "copy", "-bsf:v", "setts=ts='if(lt(N,200),N*100,60000+N*100)'", "hole.mkv")
    report = report_of(t, "hole.mkv", *LOOK, says=["400 frames"])
    check(any(label["text"] == "no signal" for label in report["labels"]), f"{report['labels']}")
    check(report["span"]["last"] == 99.9, f"{report['span']}")
    spans = [(event["first"]["seconds"], event["last"]["seconds"]) for event in report["events"]]
    check(spans and all(last < 20 or first >= 80 for first, last in spans), f"{spans}")
    check(all(event["first"]["frame"] == round(10 * event["first"]["seconds"]) for event in report["events"]), f"{report['events']}")
    for moment in ("85s", "850f"):
        t.vvr("inspect", "hole.mkv", "--frame", moment, "-o", "i.png").expect(0, "frame 850 at 85.000 s")
        t.vvr("cut", "hole.mkv", "--start", moment, "--end", "88s", "-o", f"{moment}.mkv").expect(0, "85.000 s to 87.900 s")
    later = report_of(t, "hole.mkv", *LOOK, "--start", "84s")
    check(later["events"][-1]["last"]["frame"] == report["events"][-1]["last"]["frame"], f"{later['events']}")
    # The same in a file of a recording. A low frame rate is no hole.
    names = cut(t)
    t.path("hole.mkv").rename(t.path(names[0]))
    for name in names[1:]:
        t.path(name).unlink()
    t.write("day/all.txt", names[0].removeprefix("day/") + "\n")
    check(any(label["text"] == "no signal" for label in report_of(t, "day/all.txt", *LOOK)["labels"]), "the gap is gone")
    t.ffmpeg("-i", "whole.mkv", "-c", "copy", "-bsf:v", "setts=ts=N*6000", "slow.mkv")
    report = report_of(t, "slow.mkv", *LOOK, says=["400 frames"])
    check(not any(label["text"] == "no signal" for label in report["labels"]), f"{report['labels']}")


def test_recording_of_files_whose_timestamps_go_on(t):
    whole_clip(t)
    t.ffmpeg("-i", "whole.mkv", "-c", "copy", "-f", "segment", "-segment_time", "10", "day/c%d.mkv")
    report = report_of(t, "day", *LOOK)
    check([segment["end"] for segment in report["segments"]] == [10, 20, 30, 40], f"{report['segments']}")
    check(not any("incomplete" in problem for problem in report["problems"]), f"{report['problems']}")
    t.vvr("extract", "day/c3.mkv", "-o", "data", "--part", "2/4").expect(0, "25 frames")


def test_recording_goes_on_past_damaged_files(t):
    whole_clip(t)
    names = cut(t)
    data = t.path(names[2]).read_bytes()
    t.write(names[1], b"no video" * 100)
    t.write(names[2], data[: len(data) // 2])
    report = report_of(t, "day", *LOOK, says=[f"warning: '{names[1]}' is not a video",
                                              f"warning: '{names[2]}' ends after ",
                                              "its header says 10.0 s", "in 400 layers"])
    check(any(names[1] in problem for problem in report["problems"]), f"{report['problems']}")
    check(220 <= report["frames"]["used"] <= 260 and report["span"]["last"] == 39.9,
          f"{report['frames']} {report['span']}")
    for name in names:
        t.write(name, b"")
    t.render("day").expect(3, "4 files", "'day'", code="not-video")


@pytest.mark.parametrize("keys, choices", [
    ("3 6 9", ("key", "reference")), pytest.param("0.5 1 1.5 2", ("key",), marks=pytest.mark.nightly)])
def test_recording_has_the_same_times_of_fewer_frames(t, keys, choices):
    """A file ends where it does, not after its last decoded frame."""
    for number in range(3):
        t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=10:duration=10", "-c:v", "libx264", "-g", "1000", "-bf",
                 "2", "-sc_threshold", "0", "-force_key_frames", keys.replace(" ", ","), f"day/gate_20261121_0800{number}0.mp4")
    right = report_of(t, "day", *LOOK)
    for choice in choices:
        report = report_of(t, "day", *LOOK, "--decode", choice)
        for segment, other in zip(report["segments"], right["segments"], strict=True):
            check((segment["first"], segment["end"]) == (other["first"], other["end"]), f"{choice}: {report['segments']}")
        most = 3 * (1 + len(keys.split())) if choice == "key" else right["frames"]["used"] - 1
        check(report["frames"]["used"] <= most and report["problems"] == [], f"{choice}: {report['frames']} {report['problems']}")


@pytest.mark.nightly
def test_recording_joins_overlaps_and_takes_other_sizes(t):
    whole_clip(t)
    names = cut(t)
    # A recorder that begins each file some seconds before the end of the one before.
    t.ffmpeg("-ss", "16", "-t", "14", "-i", "whole.mkv", "-c:v", "mpeg4", "-q:v", "3", "day/2026-11-21/23/gate/59.56.mkv")
    t.path(names[2]).unlink()
    report = report_of(t, "day", *LOOK, says=["400 frames in 400 layers"])
    check([segment["first_frame"] for segment in report["segments"]] == [0, 100, 200, 300], "overlaps count twice")
    t.ffmpeg("-i", names[1], "-vf", "scale=192:128", "-r", "5", "-frames:v", "50", "-c:v", "ffv1", "other.mkv")
    t.path("other.mkv").rename(t.path(names[1]))
    # Half the frames of that file; the next one begins after its last frame, at 9.8 s.
    check(report_of(t, "day", *LOOK)["frames"]["used"] == 100 + 50 + 101 + 100, "frames of a file at half the rate")


@pytest.mark.nightly
def test_recording_of_copies_leaves_nothing_out(t):
    """Copies have the time of the copy, which is no time at which a recorder wrote them."""
    whole_clip(t)
    for number, (written, name) in enumerate(((1e9, "clip2.avi"), (1e9 + 3, "clip1.avi"), (1e9 + 3.5, "clip10.avi"))):
        t.ffmpeg("-ss", f"{10 * number}", "-t", "10", "-i", "whole.mkv", "-c:v", "mpeg4", f"copies/{name}")
        t.stamp(f"copies/{name}", written)
    segments = report_of(t, "copies", *LOOK, says=["300 frames", "vvr orders them by their names"])["segments"]
    files = [(segment["file"].removeprefix("copies/"), segment["first_frame"]) for segment in segments]
    check(files == [("clip1.avi", 0), ("clip2.avi", 100), ("clip10.avi", 200)], f"{segments}")
    # Other names say nothing of an order.
    t.path("copies/clip2.avi").rename(t.path("copies/door.avi"))
    t.render("copies", *LOOK).expect(1, "'copies/clip1.avi'", "'copies/clip10.avi'", "3 files", "--join", code="recording-mixed")
    t.render("copies", *LOOK, "--join").expect(0, "300 frames", "vvr orders them by their names")


@pytest.mark.nightly
def test_recording_reads_a_repeated_file_once(t):
    whole_clip(t)
    names = cut(t)
    t.path("link").symlink_to("day")
    for more, said in ((names[1], "1 file is"), ("./day", "4 files are"), ("link", "4 files are")):
        report = report_of(t, "day", more, *LOOK, says=["warning: '", f"{said} given more than once", "400 frames"])
        check([segment["file"] for segment in report["segments"]] == names, f"{report['segments']}")


def test_recording_of_one_file_has_no_order(t):
    t.ffmpeg("-f", "lavfi", "-i", "testsrc=size=64x48:rate=10:duration=1", "-c:v", "mpeg4", "door.avi")
    t.path("current.avi").symlink_to("door.avi")
    for names in (("door.avi", "door.avi"), ("door.avi", "./door.avi"), ("current.avi", "door.avi"), (".",)):
        done = t.vvr("info", *names).expect(0, out=None)
        check("1 file\n" in done.out and "door.avi: camera" in done.out and "order" not in done.out, done.out)


def test_recording_names_what_is_no_video(t):
    t.ffmpeg("-f", "lavfi", "-i", "testsrc=size=64x48:rate=10:duration=1", "-c:v", "mpeg4", "door.avi")
    t.write("other/events.csv", b"a,b\n1,2\n")
    t.render("door.avi", "other/events.csv").expect(3, "'other/events.csv' is not a video", code="not-video")


def test_recording_says_what_overlaps(t):
    whole_clip(t)
    cut(t)
    t.ffmpeg("-ss", "10", "-t", "20", "-i", "whole.mkv", "-c:v", "mpeg4", "-q:v", "3", "day/2026-11-21/23/gate/59.52.mkv")
    done = t.render("day", *LOOK, "--report", "r.json").expect(6, "80 frames", "1 file", "5 s", "20 frames, 2.0 s", code="partial")
    check(any("omitted" in problem for problem in t.json("r.json")["problems"]), str(done))


def test_recording_tells_which_file_an_event_is_in(t):
    moving_clip(t, frames=400)
    t.ffmpeg("-i", "clip.mkv", "-c:v", "mpeg4", "-g", "10", "-q:v", "3", "whole.mkv")
    names = cut(t)
    t.render("day", "--page", "day.html", "--report", "r.json").expect(0)
    report = t.json("r.json")
    check(report["events"], "no event")
    places = {segment["file"]: segment for segment in report["segments"]}
    for event in report["events"]:
        for end in ("first", "last"):
            moment = event[end]
            check(moment["file"] in names, f"{moment}")
            check(abs(places[moment["file"]]["first"] + moment["offset"] - moment["seconds"]) < 0.002, f"{moment}")
    data = page_data(t.path("day.html").read_text(encoding="utf-8"))
    check(data["clip"] is None and [row[0] for row in data["segments"]] == [f"./{name}" for name in names], f"{data['segments']}")
    check([row[1:] for row in data["segments"]] == [[0, 10], [10, 10], [20, 10], [30, 10]], f"{data['segments']}")


def test_recording_is_ordered_by_what_tells_the_time(t):
    whole_clip(t)
    names = cut(t, layout="plain/%d-%H.%M.%S.mkv")
    # Names of no known layout, containers without a time: when they were written counts.
    for number, name in enumerate(names):
        t.stamp(name, 1795300000 + 10 * (number + 1))
    report = report_of(t, "plain", *LOOK, says=["warning: 'plain': the names of its files do not say",
                                                "by their modification times", "400 frames"])
    check(report["input"]["recorded"] is None and any("modification times" in problem for problem in report["problems"]), f"{report['problems']}")
    report = report_of(t, "plain", *LOOK, "--start-time", "modified")
    check(report["clock"]["source"] == "modified" and report["input"]["recorded_by"] == "modified", "asked for")
    # All written at once: by their names.
    for name in names:
        t.stamp(name, 1795300000)
    report = report_of(t, "plain", *LOOK, says=["vvr orders them by their names", "400 frames in 400 layers"])
    check([segment["file"] for segment in report["segments"]] == names, "not in order")
    t.render("plain", *LOOK, "--names", "%d-%H.%M.%S").expect(1, "%Y, %m (or %b), %d and %H", code="name-pattern-invalid")
    # What containers tell comes before when they were written.
    for number, name in enumerate(reversed(names)):
        t.ffmpeg("-i", name, "-c", "copy", "-metadata", f"creation_time=2026-11-21T08:00:{number}0Z", "stamped.mkv")
        t.path("stamped.mkv").rename(t.path(name))
    report = report_of(t, "plain", *LOOK, says=["400 frames in 400 layers"])
    check([segment["file"] for segment in report["segments"]] == list(reversed(names)), "containers tell the order")
    check(report["input"]["recorded"] is None and report["input"]["written"] == "2026-11-21 08:00:00", "but not the clock")
    check(any("by the creation times in their containers" in problem for problem in report["problems"]), f"{report['problems']}")


def test_recording_that_cannot_be(t):
    t.clip("a/clip.avi", seconds=1)
    t.clip("b.avi", seconds=1)
    t.path("none").mkdir()
    t.render("b.avi", "none.avi").expect(2, "'none.avi'", "No such file", code="file-not-found")
    t.render("b.avi", "none").expect(1, "'none'", code="input-unsuitable")
    t.render("b.avi", "rtsp://camera/1").expect(1, "'rtsp://camera/1'", code="input-unsuitable")
    t.path("a/link.avi").symlink_to(t.path("b.avi"))
    for name, text, *facts in (("list.txt", "../b.avi\n", "line 1"), ("list.txt", "b.avi\n/etc/passwd\n", "line 2"),
                               ("list.txt", "b.avi\nc.avi\n", "line 2", "'c.avi'"), ("a/list.txt", "link.avi\n",
                                                                                     "line 1"),
                               ("list.txt", "# nothing\n")):
        t.write(name, text)
        t.render(name).expect(2, f"'{name}'", *facts, code="file-invalid")
    t.copy("b.avi", "day/2026-11-21/08/gate/00.00.avi", "day/2026-11-21/08/hall/00.00.avi")
    t.render("day").expect(1, "'day'", "2 cameras", "gate, hall", "'day/2026-11-21/08/gate'", "--join", code="recording-mixed")
    t.render("day/2026-11-21/*/hall").expect(0)


@pytest.mark.nightly
def test_recording_has_the_clock_of_the_day(t):
    whole_clip(t)
    # Across midnight, and in the zone of the machine: Frigate's names are in UTC.
    t.zone("Europe/Berlin")
    cut(t, begin=datetime.datetime(2026, 11, 21, 22, 59, 40))
    look = ("--size", "640x400", "--backend", "software", "-o", "day.png", "--page", "day.html")
    report = report_of(t, "day", *look)
    texts = [label["text"] for label in report["labels"]]
    check("400 frames, 2026-11-21 23:59:40 to 2026-11-22 00:00:19 (CET, UTC+1; by file name)" in texts, f"{texts}")
    check("00:00:00" in texts and "gate" in texts, f"{texts}")
    check(report["clock"] == {"first": "2026-11-21T23:59:40+01:00", "last": "2026-11-22T00:00:19+01:00", "zone": "CET, UTC+1", "source": "file-name"}, f"{report['clock']}")
    for event in report["events"]:
        begin = datetime.datetime.fromisoformat(report["clock"]["first"])
        told = datetime.datetime.fromisoformat(event["first"]["time"])
        check(abs((told - begin).total_seconds() - event["first"]["seconds"]) <= 1, f"{event['first']}")
    data = page_data(t.path("day.html").read_text(encoding="utf-8"))
    check(data["clock"] == {"begin": 1795305580, "leaps": [], "zone": "CET, UTC+1", "by": "by file name"}, f"{data['clock']}")
    # To summer time: names on the local clock leap by an hour, time does not.
    names = []
    for number, piece in enumerate(sorted(t.path("day").rglob("*.mkv"))):
        names.append(f"spring/2026-03-29 {('01-59-40', '01-59-50', '03-00-00', '03-00-10')[number]}.mkv")
        t.folder_of(names[-1])
        piece.rename(t.path(names[-1]))
    report = report_of(t, "spring", *look, says=["400 frames in 400 layers"])
    check([segment["file"] for segment in report["segments"]] == names and report["span"]["last"] == 39.9, f"{report['segments']}")
    check(report["clock"]["first"] == "2026-03-29T01:59:40+01:00" and report["clock"]["last"] == "2026-03-29T03:00:19+02:00", f"{report['clock']}")
    check("03:00:00" in [label["text"] for label in report["labels"]], "no tick on the new clock")


VISITS = 30
FRAME_RATE = 2


def generated_day(t, segments):
    """A day at 2 frames per second in files of ten seconds: an empty scene, and visits of eight seconds at known times."""
    source = ("-f", "lavfi", "-i", f"color=gray:size=96x64:rate={FRAME_RATE}:duration=10")
    codec = ("-c:v", "mpeg4", "-g", "5", "-q:v", "3")
    t.ffmpeg(*source, *codec, "empty.mkv")
    t.ffmpeg(*source, "-f", "lavfi", "-i", f"color=white:size=16x24:rate={FRAME_RATE}:duration=10", "-filter_complex",
             "[0][1]overlay=x='if(between(t,1,9),10*(t-1)-8,-50)':y=20:eval=frame", *codec, "visit.mkv")
    begin = datetime.datetime(2026, 11, 21)
    visited = {segments * (2 * number + 1) // (2 * VISITS) for number in range(VISITS)}
    for number in range(segments):
        at = begin + datetime.timedelta(seconds=10 * number)
        name = t.path(f"day/{at:%Y-%m-%d/%H}/gate/{at:%M.%S}.mkv")
        name.parent.mkdir(parents=True, exist_ok=True)
        os.link(t.path("visit.mkv" if number in visited else "empty.mkv"), name)


def check_day(t, segments):
    t.zone("UTC")
    generated_day(t, segments)
    done = t.start("render", "day", "-o", "day.png", "--size", "320x200", "--backend", "software", "--report",
                   "r.json", stderr=subprocess.PIPE)
    most_open = 0
    while done.poll() is None:
        try:
            most_open = max(most_open, len(os.listdir(f"/proc/{done.pid}/fd")))
        except OSError:
            pass
        time.sleep(0.05)
    check(done.returncode == 0, done.stderr.read().decode())
    report = t.json("r.json")
    check(report["frames"]["used"] == segments * 10 * FRAME_RATE, f"{report['frames']}")
    check(len(report["segments"]) == segments and not report["problems"], "not each file was read once")
    check(len(report["events"]) == VISITS, f"{len(report['events'])} events")
    for event in report["events"]:
        visit = segments * (2 * event["number"] - 1) // (2 * VISITS)
        check(abs(event["first"]["seconds"] - 10 * visit - 1) <= 1, f"{event['first']}")
    check(report["volume"]["compressed"], "nothing is compressed")
    return report["peak_memory_bytes"], most_open


@pytest.mark.slow
def test_recording_of_a_day_of_8640_segments(t):
    hour, hour_open = check_day(t, 360)
    shutil.rmtree(t.path("day"))
    day, day_open = check_day(t, 8640)
    check(day < 1.1 * hour, f"{hour / 1e6:.0f} MB for an hour, {day / 1e6:.0f} MB for a day")
    check(day_open < 16, f"{hour_open} and {day_open} open files")  # looked at now and then
