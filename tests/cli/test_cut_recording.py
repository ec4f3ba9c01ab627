"""vvr cut of a recording of several files: the right footage, with its camera, day and time, or none."""

import datetime
import json
import re

import pytest
from harness import check
from test_cut import H264, KEYS, RATE, bag, packets
from test_recording import cut as recorded

BEGIN = datetime.datetime(2026, 11, 21, 7, 59, 50)
SECONDS = 3 * KEYS / RATE  # 4.8, of a file


def segments(t, ending=".mp4"):
    """The clip with the bag as files of a recorder."""
    bag(t)
    names = recorded(t, "bag.mp4", SECONDS, BEGIN, "day/%Y-%m-%d/%H/gate/%M.%S" + ending, SECONDS - 0.5)
    check(len(names) == 4, f"{names}")
    return names


def pictures(t, *inputs):
    """A hash of each frame."""
    done = t.run(["ffmpeg", "-v", "error", *inputs, "-map", "0:v", "-fps_mode", "passthrough", "-f", "framemd5", "-"])
    done.expect(0, out=None, err="")
    return [line.split(",")[-1].strip() for line in done.out.splitlines() if not line.startswith("#")]


def tags(t, name):
    probe = t.run(["ffprobe", "-v", "error", "-show_entries", "format_tags", "-of", "json", name])
    return {key.lower(): value for key, value in probe.json()["format"].get("tags", {}).items()}


def times(t, name):
    return sorted(packet[0] for packet in packets(t, name))


def report(t, *inputs):
    t.vvr("render", *inputs, "--report", "r.json").expect(0)
    return t.json("r.json")


def test_cut_joins_the_files_of_a_recording(t):
    names = segments(t)
    t.write("day/all.txt", "\n".join(name.removeprefix("day/") for name in names) + "\n")
    whole = pictures(t, "-i", "bag.mp4")
    first = b""
    for number, given in enumerate((["day"], ["day/*/*/gate"], ["day/*/*/*/*.mp4"], ["day/all.txt"])):
        for ending in (".mp4", ".mkv") if number == 0 else (".mp4",):
            t.vvr("cut", *given, "--start", "3s", "--end", "12s", "-o", "piece" + ending).expect(
                0, f"frames copied, 1.600 s of '{names[0]}' to ", f" of '{names[2]}', which is ", "; it begins at a key frame 1.400 s before the piece")
            if number > 0:
                check(t.path("piece.mp4").read_bytes() == first, f"{given} make another piece")
                continue
            made = pictures(t, "-i", "piece" + ending)
            check(300 - KEYS <= len(made) <= 303 - KEYS and made == whole[KEYS:KEYS + len(made)], f"{given}: {len(made)} other pictures")
            shown = times(t, "piece" + ending)
            apart = [b - a for a, b in zip(shown, shown[1:])]
            check(all(abs(seconds - 1 / RATE) < 0.002 for seconds in apart), f"{given}: {apart}")
        first = first or t.path("piece.mp4").read_bytes()
    sound = packets(t, "piece.mkv", "a")
    known = {packet[2] for packet in packets(t, "bag.mp4", "a")}
    check(all(packet[2] in known for packet in sound) and len(sound) > 10 / 1024 * 44100 * 0.98, "sound is missing")


def test_cut_joins_matroska_files_with_reordered_frames(t):
    """Matroska has no decoding times for the first packets of a file."""
    names = segments(t, ending=".mkv")
    whole = pictures(t, "-i", "bag.mp4")
    for ending in (".mkv", ".mp4", ".mov"):
        t.vvr("cut", "day", "--start", "3s", "--end", "12s", "-o", "piece" + ending).expect(0, "frames copied, 1.600 s of ")
        made = pictures(t, "-i", "piece" + ending)
        check(300 - KEYS <= len(made) <= 303 - KEYS and made == whole[KEYS:KEYS + len(made)], f"{len(made)} other pictures")
        shown = times(t, "piece" + ending)
        apart = [b - a for a, b in zip(shown, shown[1:])]
        check(all(abs(seconds - 1 / RATE) < 0.002 for seconds in apart), f"{ending}: {apart}")
    # After a gap, too.
    t.path(names[1]).unlink()
    t.vvr("cut", "day", "--start", "3.2s", "--end", "10s", "-o", "gap.mp4").expect(0, "keeps this gap")
    shown = times(t, "gap.mp4")
    check(abs(max(b - a for a, b in zip(shown, shown[1:])) - 4.2 - 1 / RATE) < 0.002, f"{shown}")


def test_cut_keeps_gaps_and_says_them(t):
    names = segments(t)
    t.path(names[1]).unlink()
    whole = pictures(t, "-i", "bag.mp4")
    for ending in (".mp4", ".mkv"):
        # By their names the third file begins 9 s after the first: the names tell whole seconds.
        t.vvr("cut", "day", "--start", "3.2s", "--end", "10s", "-o", "piece" + ending).expect(
            0, f"warning: 'day' has no frames from 4.760 s of '{names[0]}' to 0.000 s of '{names[2]}', where 105 are missing; the piece keeps this gap")
        shown = times(t, "piece" + ending)
        gap = max(b - a for a, b in zip(shown, shown[1:]))
        check(abs(gap - 4.2 - 1 / RATE) < 0.002, f"the gap lasts {gap}")
        made = pictures(t, "-i", "piece" + ending)
        wanted = whole[80:120] + whole[240:]
        check(65 <= len(made) <= 68 and made == wanted[:len(made)], f"{len(made)} other pictures")


def test_cut_says_where_the_footage_of_a_piece_begins_and_ends(t):
    t.clip("gap/gate_20261121_080000.mp4", seconds=6)
    t.copy("gap/gate_20261121_080000.mp4", "gap/gate_20261121_080010.mp4", "gap/gate_20261121_080016.mp4", "one/a.mp4")
    cut = lambda *span, of="gap": t.vvr("cut", of, *span, "-o", "x.mp4")
    pause = "warning: 'gap' has no frames from "
    kept = f"{pause}5.900 s of 'gap/gate_20261121_080000.mp4' to 0.000 s of 'gap/gate_20261121_080010.mp4', where 40 are missing; the piece keeps this gap\n"
    for start, end, said in (("7s", "12s", f"{pause}7.000 s to 10.000 s; the piece begins after that\n"),
                             ("4s", "9s", "warning: 'gap' ends at 5.900 s, earlier than the requested end of the piece\n"),
                             ("3s", "12s", kept),
                             ("12s", "99s", "warning: 'gap' ends at 21.900 s, earlier than the requested end of the piece\n"),
                             ("12s", "20s", None), ("12s", "22s", None)):
        done = cut("--start", start, "--end", end).expect(0, said or "")
        check(done.err.count("warning") == (said is not None), str(done))
    for start, end, said in (("7s", "9s", "from 7 s to 9 s; it has none from 6.000 s to 10.000 s;"), ("50s", "60s", "; it ends at 22.000 s;"),
                             ("5.95s", "9s", "; the last frame before that is at 5.900 s;"), ("21.95s", "60s", "; the last frame before that is at 21.900 s;")):
        cut("--start", start, "--end", end).expect(1, "'gap' has no frame ", said, code="span-empty")
    # Who asks by the clock is answered by the clock.
    t.zone("UTC")
    cut("--start", "@08:00:07", "--end", "@08:00:09").expect(
        1, "'gap' has no frame from 2026-11-21T08:00:07+00:00 to 2026-11-21T08:00:09+00:00; it has none from 2026-11-21T08:00:06+00:00 to 2026-11-21T08:00:10+00:00;",
        code="span-empty")
    cut("--start", "@08:00:04", "--end", "@08:00:09").expect(
        0, "warning: 'gap' ends at 2026-11-21T08:00:05+00:00, earlier than the requested end of the piece\n")
    cut("--start", "2026-11-21 08:00:04", "--end", "2026-11-21 08:00:03").expect(
        1, "end: 2026-11-21 08:00:03 is not after the start, 2026-11-21 08:00:04", code="span-empty")
    # Of a recording with one file, a frame number is known.
    cut("--start", "5f", "--end", "15f", of="one").expect(0, "frames copied", "0.500 s to 1.400 s of 'one/a.mp4'")


def test_cut_keeps_the_margin_of_a_search_that_ended_early(t):
    """A search that ends within a file knows neither how long that is nor what comes next; the margin reaches into both."""
    names = segments(t)
    t.vvr("render", "day", "--end", "6s", "--report", "r.json").expect(0)
    number, event = list(enumerate(t.json("r.json")["events"], 1))[-1]
    last = event["last"]["seconds"]
    check(5 < last < 6, f"{event}")
    def end_of(*how):
        """In seconds of the recording."""
        said = t.vvr("cut", "day", "--event", str(number), "-o", "x.mp4", *how).expect(0, "frames copied").err
        offset, name = re.search(r"to ([\d.]+) s of '([^']*)', which", said).groups()
        return float(offset) + SECONDS * names.index(name)

    for margin in (2, 5):  # to the second and to the third file
        check(-0.001 <= end_of("--end", "6s", "--margin", str(margin)) - last - margin < 4 / RATE, f"a margin of {margin} s")
    # A report does not name the third file.
    for margin, end in ((2, last + 2), (5, 9.56)):
        check(-0.001 <= end_of("--report", "r.json", "--margin", str(margin)) - end < 4 / RATE, f"a margin of {margin} s")


def test_cut_of_files_that_overlap(t):
    names = segments(t)
    # The third file is the second one as well: it begins before that has ended.
    t.ffmpeg("-i", "bag.mp4", "-ss", "4.8", "-t", "9.5", "-c", "copy", "long.mp4")
    t.path("long.mp4").rename(t.path(names[1]))
    t.vvr("cut", "day", "--start", "6s", "--end", "14s", "-o", "x.mp4").expect(1, f"'{names[2]}'", "cut each file by itself", code="input-unsuitable")
    t.vvr("cut", names[1], "--start", "1.2s", "--end", "9.2s", "-o", "x.mp4").expect(0, "frames copied, 0.000 s to ")


def test_cut_knows_the_footage_of_a_file_whose_clock_goes_back(t):
    names = segments(t, ending=".ts")
    t.ffmpeg("-i", names[1], "-c", "copy", "-f", "segment", "-segment_time", "1.5", "-reset_timestamps", "1", "part%d.ts")
    t.path(names[1]).write_bytes(b"".join(t.path(f"part{k}.ts").read_bytes() for k in range(3)))
    t.vvr("cut", "day", "--start", "6s", "--end", "8s", "-o", "x.mp4").expect(3, f"'{names[1]}'", "1.", "ffmpeg -ss", code="copy-impossible")


def test_cut_refuses_to_join_what_differs(t):
    names = segments(t)
    t.ffmpeg("-i", names[1], "-vf", "scale=96:72", *H264, "-c:a", "copy", "small.mp4")
    t.path("small.mp4").rename(t.path(names[1]))
    t.vvr("cut", "day", "--start", "1s", "--end", "8s", "-o", "x.mp4").expect(
        1, f"'{names[1]}'", "h264 96x72", "h264 192x144", "cut each file by itself", code="input-unsuitable")
    check(not t.path("x.mp4").exists(), "something was written")
    t.ffmpeg("-i", "bag.mp4", "-ss", "4.8", "-t", "4.8", "-c:v", "libx264", "-crf", "40", "-bf", "0", "-c:a", "copy", "other.mp4")
    t.path("other.mp4").rename(t.path(names[1]))
    t.vvr("cut", "day", "--start", "1s", "--end", "8s", "-o", "y.mp4").expect(
        1, f"'{names[1]}'", "h264 192x144", "with other settings", code="input-unsuitable")
    t.vvr("cut", "day", "--start", "5f", "--end", "9s", "-o", "y.mp4").expect(1, "--start 5", "12.5s", code="option-value")


@pytest.mark.nightly
def test_cut_takes_an_event_of_a_recordings_report(t):
    names = segments(t)
    events = report(t, "day")["events"]
    whole = pictures(t, "-i", "bag.mp4")
    long = max(events, key=lambda event: event["seconds"])
    number, first, last = str(long["number"]), long["first"]["frame"], long["last"]["frame"]
    needed = names[names.index(long["first"]["file"]):names.index(long["last"]["file"]) + 1]
    check(len(needed) > 1, f"the event lies in {needed}")
    t.vvr("cut", "day", "--event", number, "--report", "r.json", "-o", "a.mp4").expect(0, "frames copied")
    made = pictures(t, "-i", "a.mp4")
    begin = first // KEYS * KEYS
    check(made == whole[begin:begin + len(made)] and last + 1 <= begin + len(made) <= last + 5, f"{len(made)} frames for {first}..{last}")
    # Found anew, or out of those files alone, whatever they are called: the same pictures.
    t.vvr("cut", "day", "--event", number, "-o", "b.mp4").expect(0, "frames copied")
    check(pictures(t, "-i", "b.mp4") == made, "a search finds another piece")
    for i, name in enumerate(needed):
        t.copy(name, f"other/{i}.mp4")
    t.vvr("cut", "other", "--event", number, "--report", "r.json", "-o", "c.mp4").expect(0, "frames copied")
    check(pictures(t, "-i", "c.mp4") == made, "files of other names make another piece")
    # One of them is not enough, and the right ones are named.
    quoted = "', '".join(needed)
    t.vvr("cut", needed[0], "--event", number, "--report", "r.json", "-o", "d.mp4").expect(
        1, f"event {number}", "'r.json'", f"'{quoted}'", f"'{needed[0]}'", code="input-unsuitable")
    check(not t.path("d.mp4").exists(), "something was written")


@pytest.mark.nightly
def test_cut_of_one_file_by_a_recordings_report_is_at_the_right_place(t):
    """Times of a report are those of the recording; of a file they are others."""
    names = segments(t)
    told = report(t, "day")
    inside = [event for event in told["events"] if event["first"]["file"] == event["last"]["file"] != names[0]]
    if not inside:  # an event that ends in the file in which it began
        event = told["events"][-1]
        last = event["last"]
        event["first"] = last | {"seconds": last["seconds"] - 0.2, "frame": last["frame"] - RATE // 5, "offset": last["offset"] - 0.2}
        t.write("r.json", json.dumps(told))
        inside = [event]
    event = inside[0]
    place = names.index(event["first"]["file"])
    whole = pictures(t, "-i", "bag.mp4")
    first, last = event["first"]["frame"], event["last"]["frame"]
    t.vvr("cut", names[place], "--event", str(event["number"]), "--report", "r.json", "-o", "a.mp4").expect(0, "frames copied")
    made = pictures(t, "-i", "a.mp4")
    begin = first // KEYS * KEYS
    check(made == whole[begin:begin + len(made)] and last < begin + len(made), f"other pictures than {first}..{last}")
    t.vvr("cut", names[place - 1], "--event", str(event["number"]), "--report", "r.json", "-o", "b.mp4").expect(
        1, f"'{names[place]}'", f"'{names[place - 1]}'", code="input-unsuitable")
    check(not t.path("b.mp4").exists(), "something was written")


def test_cut_refuses_a_report_of_another_file(t):
    bag(t)
    t.ffmpeg("-i", "bag.mp4", "-c:v", "libx264", "-crf", "30", "-c:a", "copy", "other.mp4")
    report(t, "bag.mp4")
    cut = lambda name: t.vvr("cut", name, "--event", "1", "--report", "r.json", "-o", "x.mp4")
    cut("other.mp4").expect(1, "event 1", "'r.json'", "'bag.mp4'", "'other.mp4'", code="input-unsuitable")
    # The name is the same, and a byte of the middle is not: so is the size. Its ends are.
    t.copy("bag.mp4", "moved/bag.mp4", "moved/renamed.mp4")
    with open(t.path("moved/bag.mp4"), "r+b") as file:
        file.seek(1000)
        file.write(b"\x5a\xa5")
    cut("moved/bag.mp4").expect(1, "event 1", "'r.json'", "'bag.mp4'", "'moved/bag.mp4'", "--report", code="input-unsuitable")
    check(not t.path("x.mp4").exists(), "something was written")
    cut("moved/renamed.mp4").expect(0, "frames copied")
    old = t.json("r.json")
    del old["input"]["digest"]
    t.write("r.json", json.dumps(old))
    cut("bag.mp4").expect(1, "--report 'r.json'", "vvr render CLIP --report", code="input-unsuitable")


def test_report_has_the_digests_that_the_docs_describe(t):
    import hashlib
    names = segments(t)
    end = 64 * 1024
    for reported, name in [(report(t, "bag.mp4")["input"], "bag.mp4")] + list(zip(report(t, "day")["segments"], names)):
        data = t.path(name).read_bytes()
        sampled = data if len(data) <= 2 * end else data[:end] + data[-end:]
        check(reported["bytes"] == len(data) and reported["digest"] == hashlib.sha256(sampled).hexdigest(), f"{name}: {reported}")
    check(report(t, "day")["input"]["digest"] is None, "a folder has a digest")


def test_cut_keeps_camera_date_and_time(t):
    names = segments(t)
    t.zone("Europe/Berlin")  # Frigate's names are in UTC
    # Into MP4 here, into Matroska below.
    t.vvr("cut", "day", "--start", "8s", "--end", "12s", "-o", "a.mp4").expect(
        0, "frames copied, 3.200 s of ", "of 'day/2026-11-21/07/gate/59.59.mp4', which is 2026-11-21T08:59:58+01:00 to 2026-11-21T09:00:0")
    told = tags(t, "a.mp4")
    check(told["creation_time"].startswith("2026-11-21T07:59:58"), f"{told}")
    check(told["title"] == "gate" and told["comment"].startswith("gate; 2026-11-21T08:59:58+01:00 to 2026-11-21T09:00:0"), f"{told}")
    check("cut by vvr from 59.54.mp4, 59.59.mp4" in told["comment"], f"{told}")
    t.vvr("cut", names[1], "--start", "1.6s", "--end", "2s", "-o", "b.mp4").expect(0, "which is 2026-11-21T08:59:55+01:00 to")
    check(tags(t, "b.mp4")["creation_time"].startswith("2026-11-21T07:59:55"), f"{tags(t, 'b.mp4')}")
    # Who knows better says so.
    t.vvr("cut", "bag.mp4", "--start", "8s", "--start-time", "2026-06-01 12:00:00", "-o", "c.mkv").expect(
        0, "which is 2026-06-01T12:00:08 to ")
    check(tags(t, "c.mkv")["creation_time"].startswith("2026-06-01T10:00:08"), f"{tags(t, 'c.mkv')}")
    t.vvr("cut", "day", "--start", "8s", "--start-time", "none", "-o", "d.mkv").expect(0)
    check("creation_time" not in tags(t, "d.mkv") and tags(t, "d.mkv")["title"] == "gate", f"{tags(t, 'd.mkv')}")
    t.copy("bag.mp4", "till__20261121_0930.mp4")
    t.vvr("cut", "till__20261121_0930.mp4", "--names", "{camera}__%Y%m%d_%H%M", "--start", "8s", "-o", "e.mkv").expect(
        0, "which is 2026-11-21T09:30:08+01:00")
    told = tags(t, "e.mkv")
    check(told["title"] == "till" and told["creation_time"].startswith("2026-11-21T08:30:08"), f"{told}")
    check(told["comment"].startswith("till; 2026-11-21T09:30:08+01:00"), f"{told}")
    t.vvr("cut", "bag.mp4", "--start", "8s", "-o", "f.mp4").expect(0)
    check("creation_time" not in tags(t, "f.mp4") and "title" not in tags(t, "f.mp4"), "a time or a camera that nobody told")


def test_cut_tells_when_the_last_frame_was(t):
    bag(t)
    t.zone("UTC")
    clip = "gate_20261121_080000.mp4"
    t.copy("bag.mp4", clip)
    for span, begin, end in ((("--start", "12s"), 11, 15), (("--start", "12s", "--end", "10m"), 11, 15), (("--start", "50f", "--end", "100f"), 1, 3)):
        day = f"2026-11-21T08:00:{begin:02}+00:00 to 2026-11-21T08:00:{end:02}+00:00"
        t.vvr("cut", clip, *span, "-o", "x.mp4").expect(0, f"which is {day}; it begins at")
        check(tags(t, "x.mp4")["comment"] == f"gate; {day}; cut by vvr from {clip}", f"{tags(t, 'x.mp4')}")


def test_cut_of_an_avi_keeps_the_day(t):
    t.clip("gate_2026-11-21_07-12-00.avi", seconds=4)
    t.zone("UTC")
    t.vvr("cut", "gate_2026-11-21_07-12-00.avi", "--names", "{camera}_%Y-%m-%d_%H-%M-%S", "--start", "2s", "-o", "x.avi").expect(0, "which is 2026-11-21T07:12:02+00:00")
    check("2026-11-21T07:12:02" in json.dumps(tags(t, "x.avi")), f"{tags(t, 'x.avi')}")


@pytest.mark.nightly
def test_cut_chooses_the_ending(t):
    bag(t)
    t.clip("old.avi", codec=("-c:v", "msmpeg4"))
    cut = lambda name, to, *more: t.vvr("cut", name, "--start", "1s", "-o", to, *more)
    cut("old.avi", "x.mp4").expect(1, ".mp4", "msmpeg4v3", ".avi", code="options-conflict")
    cut("old.avi", "x").expect(0, "'x.avi': ")
    cut("bag.mp4", "x").expect(0, "'x.mp4': ")
    t.path("to").mkdir()
    cut("old.avi", "to").expect(0, "'to/old-1.000s.avi': ")
    t.vvr("cut", "bag.mp4", "--event", "1", "-o", "to/").expect(0, "'to/bag-event-1.mp4': ")
    cut("old.avi", "none/").expect(2, "'none'", code="file-not-found")
    t.expect_files("bag.mp4", "old.avi", "to", "to/bag-event-1.mp4", "to/old-1.000s.avi", "x.avi", "x.mp4")


def test_cut_by_the_clock_on_the_wall(t):
    names = segments(t)
    t.zone("UTC")
    for name, first, last in (("a.mkv", "2026-11-21 07:59:58", "2026-11-21 08:00:02"), ("b.mkv", "@07:59:58", "@08:00:02")):
        t.vvr("cut", "day", "--start", first, "--end", last, "-o", name).expect(
            0, f"100 frames copied, 3.200 s of '{names[1]}' to 2.360 s of '{names[2]}', which is 2026-11-21T07:59:58+00:00 to 2026-11-21T08:00:01+00:00")
    check(pictures(t, "-i", "a.mkv") == pictures(t, "-i", "bag.mp4")[200:300], "other pictures")
    check(t.path("a.mkv").read_bytes() == t.path("b.mkv").read_bytes(), "another piece by the time of day alone")
    t.vvr("cut", "bag.mp4", "--start", "@08:00", "-o", "b.mkv").expect(1, "@08:00", "'bag.mp4'", "--start-time", code="time-of-day-unknown")
    t.vvr("cut", "bag.mp4", "--start", "@08:00:02", "--start-time", "2026-11-21 08:00:00", "-o", "c.mp4").expect(
        0, "frames copied, 1.600 s to 15.960 s of 'bag.mp4'")
    t.vvr("cut", "day", "--start", "2026-11-21 07:00", "--end", "@08:00:02", "-o", "d.mkv").expect(
        0, "warning: 'day' begins at 2026-11-21T07:59:50+00:00, later than the requested start", "0.000 s of ")
    # An offset stays one, and the log says which time of day that is.
    t.vvr("cut", "day", "--start", "00:00:08", "-o", "e.mkv").expect(0, "which is 2026-11-21T07:59:58+00:00 to ")
