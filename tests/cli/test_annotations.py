"""What is written on a picture: read back from the report, and options that are refused."""

import collections
import re

import pytest
from harness import check, page_data, page_data

NO_FONTS = "<?xml version='1.0'?><!DOCTYPE fontconfig SYSTEM 'fonts.dtd'><fontconfig></fontconfig>"


def labels_of(t, clip, *options, size="640x480"):
    t.vvr("render", clip, "-o", "out.png", "--size", size, "--report", "report.json", "--quiet", *options).expect(0)
    return t.json("report.json")["labels"]


def texts_of(labels):
    return [label["text"] for label in labels]


def test_labels_tell_clip_span_times_and_colours(t):
    t.clip("a door's \"clip\".avi", seconds=12)
    labels = labels_of(t, "a door's \"clip\".avi", "--color", "transfer")
    texts = texts_of(labels)
    check(texts[:2] == ["a door's \"clip\".avi", "120 frames, 0.0 s to 11.9 s"], str(texts))
    check({"0:00", "0:02", "0:04", "0:06", "0:08", "0:10"} <= set(texts), str(texts))
    colours = {"what differs from the empty scene: little to much", "which way it went: slow to fast"}
    check(len(colours & set(texts)) == 1, str(texts))
    with_arrows = labels_of(t, "a door's \"clip\".avi", "--color", "transfer", "--show", "volume,directions,legend")
    check(colours <= set(texts_of(with_arrows)), str(with_arrows))
    at = {label["text"]: label for label in labels}
    check(texts.count("seen from behind") == 1 and at["seen from behind"]["x"] > 320, "the frame at the right end is as in a mirror")
    check(at["0:00"]["x"] < at["0:04"]["x"] < at["0:08"]["x"], "time runs from left to right")
    check(at["0:04"]["y"] < at["0:00"]["y"] and at["0:04"]["y"] < at["0:10"]["y"], "around the arc")
    for label in labels:
        check(label["x"] >= 0 and label["y"] >= 0 and label["x"] + label["width"] <= 640
              and label["y"] + label["height"] <= 480, f"{label} leaves the picture")


def test_labels_with_the_clock_of_the_recording(t):
    t.clip("2026-11-21T07-30-00Z.mp4", seconds=12, codec=("-c:v", "mpeg4"))
    t.zone("Europe/Berlin")
    for options in ((), ("--start-time", "recorded")):
        texts = texts_of(labels_of(t, "2026-11-21T07-30-00Z.mp4", *options))
        check("120 frames, 2026-11-21 08:30:00 to 08:30:11 (CET, UTC+1; by file name)" in texts, str(texts))
    texts = texts_of(labels_of(t, "2026-11-21T07-30-00Z.mp4", "--start-time", "none"))
    check("120 frames, 0.0 s to 11.9 s" in texts and "0:00" in texts, str(texts))
    told = t.vvr("info", "2026-11-21T07-30-00Z.mp4")
    check("recorded 2026-11-21 07:30:00 UTC, by file name" in told.out, str(told))
    t.clip()
    t.render("clip.avi", "--start-time", "recorded").expect(1, "--start-time", "'clip.avi'", code="time-of-day-unknown")
    t.render("clip.avi", "--start-time", "container").expect(1, "--start-time", "'clip.avi'", code="time-of-day-unknown")


@pytest.mark.nightly
def test_when_a_file_was_written_is_no_time_of_day(t):
    """A container's creation_time and a file's modification time are shown by whom they are asked for, as what they are."""
    t.clip("dated.mp4", seconds=12, codec=("-c:v", "mpeg4", "-metadata", "creation_time=2026-11-21T07:30:00Z"))
    t.stamp("dated.mp4", 1795300012)  # 2026-11-21 22:26:52
    t.zone("UTC")
    t.vvr("render", "dated.mp4", "-o", "out.png", "--page", "out.html", "--size", "640x480", "--report",
          "report.json", "--quiet").expect(0)
    report = t.json("report.json")
    texts = texts_of(report["labels"])
    check("120 frames, 0.0 s to 11.9 s" in texts, str(texts))
    check(not re.search(r"\d\d:\d\d:\d\d|20\d\d-\d\d-\d\d", " ".join(texts)), str(texts))
    check(report["clock"] is None and report["input"]["recorded"] is None and report["input"]["recorded_by"] is None, str(report["input"]))
    check(report["input"]["written"] == "2026-11-21 07:30:00", str(report["input"]))
    check(all("time" not in event["first"] for event in report["events"]), str(report["events"]))
    page = t.path("out.html").read_text(encoding="utf-8")
    check(page_data(page)["clock"] is None, page[-3000:])
    check(re.search(r'<p id="summary">0:00 to 0:12, \d+ events?; time of day not known</p>', page), page[:3000])

    told = t.vvr("info", "dated.mp4")
    check("written  2026-11-21 07:30:00 UTC, from the container; it may have been recorded at another time" in told.out, str(told))
    check("recorded 2" not in told.out and "22:26" not in told.out, str(told))
    told = t.vvr("info", "dated.mp4", "--json").json()
    check(told["recorded"] is None and told["recorded_by"] is None and told["written"] == "2026-11-21 07:30:00", str(told))

    for asked, first, words in [("container", "07:30:00", "when the container was written"), ("modified", "22:26:40", "by when the file was last written")]:
        t.vvr("render", "dated.mp4", "-o", "out.png", "--page", "out.html", "--size", "640x480", "--report", "report.json", "--quiet",
              "--start-time", asked).expect(0)
        report = t.json("report.json")
        texts = texts_of(report["labels"])
        check(any(text.startswith(f"120 frames, 2026-11-21 {first}") and text.endswith(f"(UTC; {words})") for text in texts), str(texts))
        check(report["clock"]["source"] == asked and report["clock"]["first"] == f"2026-11-21T{first}+00:00", str(report["clock"]))
        check(report["input"]["recorded_by"] == asked and report["input"]["recorded"] == f"2026-11-21 {first}", str(report["input"]))
        page = t.path("out.html").read_text(encoding="utf-8")
        check(page_data(page)["clock"]["by"] == words and re.search(rf"\d+ events?; times of day {words}</p>", page), page[-3000:])


@pytest.mark.nightly
def test_parts_of_a_clip_by_the_clock(t):
    t.clip("gate_2026-11-21_23-59-50.avi", seconds=20)
    name = "gate_2026-11-21_23-59-50.avi"
    t.zone("UTC")
    for options, frames, says in [
        (("--start", "@23:59:55", "--end", "@00:00:02"), (50, 120), "2026-11-21 23:59:55 to 2026-11-22 00:00:02 (UTC; by file name)"),
        (("--start", "2026-11-21 23:59:55", "--end", "2026-11-22T00:00:02"), (50, 120), "2026-11-21 23:59:55 to 2026-11-22 00:00:02"),
        (("--between", "23:59:55-00:00:02"), (50, 120), "2026-11-21 23:59:55 to 2026-11-22 00:00:02"),
        (("--start", "00:00:05"), (50, 200), f"'{name}': 2026-11-21 23:59:55 to the end at 2026-11-22 00:00:10 (UTC; by file name)"),
        (("--end", "2s"), (0, 20), "2026-11-21 23:59:50 to 2026-11-21 23:59:52"),
    ]:
        done = t.render(name, *options, "--report", "r.json").expect(0, says)
        is_offset = not any("@" in option or "-" in option[2:] for option in options)
        check(("--start and --end count from the first frame; for a time of day, write @02:00" in done.err) == is_offset, str(done))
        report = t.json("r.json")
        first, stop = frames
        check(report["frames"]["used"] == stop - first and report["span"]["first"] == first / 10, f"{done} {report['span']}")
    t.scene("left_bag", "hall_2026-11-21_07-12-00.y4m", "--size", "192x144", "--frames", "400")
    t.vvr("render", "hall_2026-11-21_07-12-00.y4m", "--report", "r.json").expect(0, "; the longest from 2026-11-21 07:12:")
    t.vvr("extract", name, "-o", "data", "--start", "@00:00:00").expect(0, "2026-11-22 00:00:00 to the end at", "100 frames")
    t.vvr("extract", name, "-o", "data2", "--start", "@02:00", "--start-time", "2026-11-22 01:59:55").expect(
        0, "2026-11-22 02:00:00 to the end", "(as given)", "150 frames")
    t.render("data", "--start", "@00:00:00").expect(1, "'data'", "--start", code="extraction-unsuitable")
    t.render(name, "--start", "@12:00").expect(
        1, "--start", "@12:00", f"'{name}'", "2026-11-21 23:59:50", "2026-11-22 00:00:10", code="span-empty")
    t.render(name, "--between", "12:00-13:00").expect(1, "--between", "12:00-13:00", code="span-empty")
    t.render(name, "--start", "2026-11-22").expect(
        1, "--start", "'2026-11-22'", "2026-11-22 02:00", "@02:00", code="option-value")
    t.render(name, "--end", "2026-11-21 23:00").expect(1, "--end", "2026-11-21 23:00", code="span-empty")
    t.clip()
    for option, value in (("--start", "@02:00"), ("--end", "2026-11-22 02:00"), ("--between", "02:00-05:00")):
        t.render("clip.avi", option, value).expect(1, f"{option} {value}", "'clip.avi'", "--start-time", code="time-of-day-unknown")


def test_parts_of_each_night(t):
    """A recording of two evenings: what lies between the parts is left out, not lost."""
    t.clip("2026-11-20_22-00-00.avi", seconds=20)
    t.copy("2026-11-20_22-00-00.avi", "2026-11-21_21-59-50.avi", "2026-11-21_22-00-10.avi", "2026-11-22_12-00-00.avi")
    t.zone("UTC")
    files = sorted(path.name for path in t.path(".").glob("*.avi"))
    t.vvr("render", *files, "-o", "out.png", "--size", "900x700", "--show", "volume,outline,ruler", "--between", "22:00-05:00", "--report", "r.json").expect(0, "in 2 parts")
    report = t.json("r.json")
    check(report["frames"]["used"] == 200 + 100 + 200, f"{report['frames']}")
    check("left out, no footage" in texts_of(report["labels"]), f"{texts_of(report['labels'])}")
    # The page says the same, of the times that it has and along the axis.
    t.vvr("render", *files, "-o", "out.html", "--size", "1000x700", "--between", "22:00-05:00").expect(0)
    page = page_data(t.path("out.html").read_text(encoding="utf-8"))
    check(page["gaps"] == ["left out, no footage"], f"{page['gaps']}")
    notes = [note["text"] for note in page["overlay"]["notes"]]
    check("left out, no footage" in notes and "no footage" not in notes, f"{notes}")
    t.vvr("extract", *files, "-o", "data", "--between", "22:00-05:00").expect(
        1, "--between", "'2026-11-20_22-00-00.avi'", "2 parts", "--start and --end", code="options-conflict")


def test_labels_and_captions_need_a_font(t):
    t.clip()
    t.write("fonts.conf", NO_FONTS)
    environment = {"PATH": "/usr/bin:/bin", "HOME": str(t.folder), "FONTCONFIG_FILE": str(t.path("fonts.conf"))}
    t.vvr("render", "clip.avi", "-o", "out.png", "--size", "640x480", env=environment).expect(
        0, "warning: fontconfig found no font, so the picture has no text; install one")
    t.expect_picture("out.png", (640, 480))
    t.vvr("inspect", "clip.avi", "--frame", "3f", "-o", "frame.png", env=environment).expect(
        0, "fontconfig found no font, so 'frame.png' has no captions; install one, such as fonts-dejavu-core")


@pytest.mark.nightly
def test_keyframes_need_the_clips_length(t):
    t.scene("walkers", "walkers.y4m", "--size", "160x120", "--frames", "40")
    t.render("walkers.y4m", "--keyframes", "3", "--show", "frames").expect(0)
    told = t.render("walkers.y4m", "--keyframes", "3", "--quiet").expect(0)
    check("key frames" not in told.err, str(told))
    # A stream that was written without a way back does not tell its length.
    t.ffmpeg("-i", "walkers.y4m", "-c:v", "ffv1", "-live", "1", "-f", "matroska", "unfinished.mkv")
    t.render("unfinished.mkv", "--keyframes", "3", "--show", "frames").expect(0, "only 0 of 3 key frames are shown")


def test_keyframes_of_a_series_stand_in_each_brick(t):
    # A grey scene that gets lighter: each frame has a level of its own.
    t.ffmpeg("-f", "lavfi", "-i", "color=black:size=64x48:rate=10:duration=4", "-vf", "geq=lum='80+4*N':cb=128:cr=128",
             "-c:v", "ffv1", "levels.mkv")
    look = ("--backend", "software", "--layout", "box", "--camera", "-60,20", "--size", "640x300", "--show", "frames",
            "--brick", "10f", "--window", "2", "--filter", "edges")

    def levels(name):
        pixels = [pixel[0] for row in t.rgb(name) for pixel in row if pixel != (255, 255, 255)]
        return {level for level, count in collections.Counter(pixels).items() if count > 1500}
    t.render("levels.mkv", *look, output="ends.{brick}.png").expect(0, "4 pictures")
    for count in (1, 2):
        said = t.render("levels.mkv", *look, "--keyframes", str(count), output=f"k{count}.{{brick}}.png").expect(0, "4 pictures")
        check("key frame" not in said.err, "a warning about key frames")
        for brick in (1, 2, 3):
            more = len(levels(f"k{count}.{brick}.png")) - len(levels(f"ends.{brick}.png"))
            check(more >= 2 * count - 1, f"window {brick} with {count} key frames per brick has {more} more levels")
    moved = levels("k1.3.png")
    t.vvr("extract", "levels.mkv", "-o", "end", "--start", "20f", "--filter", "edges").expect(0)
    t.render("end", *look, "--keyframes", "1", output="f.{brick}.png").expect(0)
    check(levels("f.1.png") == moved, "a window that moved shows other key frames than a fresh one")


def test_annotations_that_are_refused(t):
    t.clip()
    for options, code, *texts in [
        (("--theme", "lihgt"), "choice-unknown", "--theme", "'lihgt'", "'light'"),
        (("--background", "red"), "option-value", "--background", "'red'", "#rrggbb"),
        (("--start-time", "yesterday"), "option-value", "--start-time", "'yesterday'", "2026-11-21 08:00:00"),
        (("--show", "volume,rulre"), "choice-unknown", "--show", "'rulre'", "'ruler'"),
    ]:
        t.render("clip.avi", *options).expect(1, *texts, code=code)
    t.expect_files("clip.avi")


def test_events_that_are_not_chosen_were_found(t):
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=192x144:rate=10:duration=12", "-f", "lavfi", "-i",
             "testsrc2=size=30x40:rate=10:duration=12", "-filter_complex",
             "[0][1]overlay=x='if(between(t,4,7),60*(t-4),-100)':y=50:eval=frame", "-c:v", "mpeg4", "-q:v", "2", "walk.avi")
    texts = texts_of(labels_of(t, "walk.avi", "--events", "left", size="1280x800"))
    check("1 object found, but none that --events chooses" in texts, f"{texts}")
    check(not any("could be identified" in text for text in texts), f"{texts}")
    t.render("walk.avi", "--events", "left", "--report", "r.json", output="out.html").expect(0, "no event that --events chooses, of 1 event")
    check(page_data(t.path("out.html").read_text())["unchosen"] == 1, "the page does not know of it")
