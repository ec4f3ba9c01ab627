"""vvr cut: the piece has the clip's own bytes, from the right frame to the right frame; and what it refuses."""

import os
import signal
import time

import pytest
from harness import check

RATE = 25
KEYS = 40  # frames from one key frame to the next
H264 = ("-c:v", "libx264", "-bf", "2", "-g", str(KEYS), "-keyint_min", str(KEYS), "-sc_threshold", "0", "-pix_fmt", "yuv420p")


def bag(t, name="bag.mp4", *codec):
    """A clip with three events: somebody leaves a bag, and fetches it. With sound."""

    def encode():
        t.scene("left_bag", "bag.y4m", "--size", "192x144", "--frames", "400")
        t.ffmpeg("-i", "bag.y4m", "-f", "lavfi", "-i", "sine=duration=16", *(codec or H264), "-c:a", "aac", "-shortest", name)
        t.path("bag.y4m").unlink()

    return t.make(name, "bag with sound", codec, how=encode)


def events(t, name):
    t.vvr("render", name, "--report", "report.json").expect(0)
    return t.json("report.json")["events"]


def packets(t, name, stream="v"):
    """Of each packet: time, flags, and a hash of its bytes."""
    probe = t.run(["ffprobe", "-v", "error", "-select_streams", stream, "-show_packets", "-show_data_hash", "MD5", "-of", "json", name])
    return [(float(p["pts_time"]), p["flags"][0], p["data_hash"]) for p in probe.json()["packets"]]


def grey_frames(t, name):
    """The mean brightness of each frame in an 8 by 6 grid."""
    raw = t.raw(name, "gray", "-vsync", "passthrough", "-vf", "scale=8:6:flags=area")
    return [raw[k:k + 48] for k in range(0, len(raw), 48)]


def apart(a, b):
    """How far apart two frames are: the largest difference of a cell, grey levels."""
    return max(abs(x - y) for x, y in zip(a, b))


def check_copied(t, clip, piece, first, last):
    """A piece is packets of the clip, from the last key frame at or before the frame `first` to `last` or little later."""
    whole, part = packets(t, clip), packets(t, piece)
    check(part[0][0] == 0 and part[0][1] == "K", f"begins with {part[0]}")
    hashes = [packet[2] for packet in whole]
    begin = hashes.index(part[0][2])
    check([packet[2] for packet in part] == hashes[begin:begin + len(part)], "the packets are not those of the clip")
    key = round(whole[begin][0] * RATE)
    check(key <= first < key + KEYS, f"begins with the key frame {key} for the frame {first}")
    shown = {round((packet[0] + whole[begin][0]) * RATE) for packet in part}
    check(shown == set(range(key, max(shown) + 1)) and last <= max(shown) <= last + 3, f"shows {sorted(shown)} of {key}..{last}")


def test_cut_copies_an_event(t):
    clip = bag(t)
    known = {packet[2] for packet in packets(t, clip, "a")}
    for event in events(t, clip):
        number, first, last = event["number"], event["first"]["frame"], event["last"]["frame"]
        t.vvr("cut", clip, "--event", str(number), "--report", "report.json", "-o", "listed.mp4").expect(
            0, "frames copied", f"s of '{clip}'; it begins at a key frame")
        check_copied(t, clip, "listed.mp4", first, last)
        length = (last - first) / RATE
        sound = packets(t, "listed.mp4", "a")
        check(0 <= sound[0][0] < 0.05 and length <= sound[-1][0] + 0.1, f"sound from {sound[0]} to {sound[-1]}")
        check(all(packet[2] in known for packet in sound), "the sound is not that of the clip")
    t.vvr("cut", clip, "--event", str(number), "-o", "found.mp4").expect(0)
    check(t.path("found.mp4").read_bytes() == t.path("listed.mp4").read_bytes(), "a search leads to another piece than its report")


def test_cut_of_groups_that_lean_on_the_one_before(t):
    """Frames that follow a key frame and are shown before it can't be decoded from there: they stay out, or it begins earlier."""
    t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=160x120:rate=25:duration=8", "-c:v", "libx264", "-pix_fmt", "yuv420p", "-x264-params",
             "open-gop=1:keyint=50:min-keyint=50:scenecut=0:bframes=3", "-bf", "3", "open.mkv")
    t.ffmpeg("-i", "open.mkv", "-c", "copy", "open.ts")
    frames = grey_frames(t, "open.mkv")
    for clip, first, last in (("open.mkv", 100, 110), ("open.mkv", 98, 99), ("open.mkv", 0, 3), ("open.ts", 100, 110), ("open.ts", 126, 180)):
        t.vvr("cut", clip, "--start", f"{first / RATE:.2f}s", "--end", f"{(last + 1) / RATE:.2f}s", "-o", "piece.mp4").expect(0)
        t.run(["ffmpeg", "-v", "error", "-i", "piece.mp4", "-f", "null", "-"]).expect(0, err="")
        part = grey_frames(t, "piece.mp4")
        key = first // 50 * 50
        check(last - key + 1 <= len(part) <= last - key + 5, f"{len(part)} frames for {first}..{last}")
        check(all(apart(a, b) <= 1 for a, b in zip(part, frames[key:])), f"{clip}: other frames for {first}..{last}")


def test_cut_copies_avi(t):
    t.clip("clip.avi", seconds=6)
    t.vvr("cut", "clip.avi", "--start", "33f", "--end", "47f", "-o", "piece.avi").expect(0, "17 frames copied, 3.000 s to 4.600 s of 'clip.avi'; it begins at a key frame 0.300 s before the piece")
    t.vvr("cut", "clip.avi", "--start", "3s", "--end", "47f", "-o", "same.avi").expect(0, "it begins at a key frame\n")
    check(t.path("same.avi").read_bytes() == t.path("piece.avi").read_bytes(), "the same piece by other words")
    whole, part = packets(t, "clip.avi"), packets(t, "piece.avi")
    check([p[2] for p in part] == [p[2] for p in whole[30:47]], "other packets")
    check([round(p[0] * 10) for p in part] == list(range(17)), f"times {part}")


def test_cut_names_pieces_in_a_folder_by_what_was_asked(t):
    t.clip("clip.avi")
    t.path("to").mkdir()
    for start, end in (("5f", "15f"), ("10f", "15f"), ("0.5s", "15f"), ("0f", "15f"), ("0", "1s"), ("0", "0.5s")):
        t.vvr("cut", "clip.avi", "--start", start, "--end", end, "-o", "to").expect(0)
    t.vvr("cut", "clip.avi", "--start", "1s", "-o", "to").expect(0)
    pieces = ["0.000s-0.500s", "0.000s-1.000s", "0.000s-15f", "0.500s-15f", "1.000s", "10f-15f", "5f-15f"]
    t.expect_files("clip.avi", "to", *(f"to/clip-{piece}.avi" for piece in pieces))


def test_cut_with_a_margin(t):
    clip = bag(t)
    came = events(t, clip)[1]
    t.vvr("cut", clip, "--event", "2", "--margin", "1.5", "--report", "report.json", "-o", "wide.mp4").expect(0)
    check_copied(t, clip, "wide.mp4", came["first"]["frame"] - 37, came["last"]["frame"] + 37)
    t.vvr("cut", clip, "--start", "0.5s", "--end", "6s", "--margin", "60", "-o", "wide.mp4").expect(
        0, "ends at 15.960 s, earlier than the requested end", "400 frames copied, 0.000 s to 15.960 s")


def test_cut_says_that_a_clip_ends_early_where_it_does(t):
    t.clip("clip.mkv", seconds=4)
    t.ffmpeg("-i", "clip.mkv", "-vf", "select='not(between(t,1,2.9))'", "-fps_mode", "vfr", "-c:v", "mpeg4", "-g", "5", "pause.mkv")
    for clip, end, is_early in (("clip.mkv", "15f", False), ("clip.mkv", "40f", False), ("clip.mkv", "41f", True),
                                ("clip.mkv", "4s", False), ("clip.mkv", "4.2s", True), ("pause.mkv", "2s", False), ("pause.mkv", "3.5s", False)):
        done = t.vvr("cut", clip, "--start", "5f", "--end", end, "-o", "x.mkv").expect(0)
        check(("ends at 3.900 s, earlier" in done.err) == is_early, str(done))
        check(("has no frames from 0.900 s to 3.000 s of 'pause.mkv', where 20 are missing; the piece keeps this gap" in done.err) == (end == "3.5s"), str(done))


@pytest.mark.nightly
def test_cut_takes_the_searches_options(t):
    clip = bag(t)
    t.vvr("render", clip, "--events", "left", "--report", "left.json").expect(0, "1 event")
    check(t.json("left.json")["settings"]["events"] == "left", "what the picture marks is a setting of it")
    left = t.json("left.json")["events"][0]
    length = left["seconds"]
    for events, count in ((f"left,{length - 1}s", 1), (f"{length + 1}s,left", 0), (f"{length + 1}s", 0)):
        t.vvr("render", clip, "--events", events, "--report", "some.json").expect(0)
        some = t.json("some.json")["events"]
        check(len(some) == count, f"{events}: {some}")
    t.vvr("cut", clip, "--events", "left", "--event", "1", "-o", "left.mp4").expect(0, "frames copied")
    check_copied(t, clip, "left.mp4", left["first"]["frame"], left["last"]["frame"])
    t.vvr("cut", clip, "--events", "left", "--event", "2", "-o", "none.mp4").expect(
        1, "--event", "event 2", "1 event", code="event-unknown")
    t.vvr("cut", clip, "--roi", "0,0 20,0 20,20 0,20", "--event", "1", "-o", "none.mp4").expect(
        1, "--event", "event 1", f"'{clip}'", code="event-unknown")


def test_cut_keeps_when_it_was_recorded_and_how_it_is_turned(t):
    t.clip("plain.mp4", seconds=4, codec=("-c:v", "libx264", "-g", "10", "-pix_fmt", "yuv420p"))
    old = "display_rotation" not in t.run(["ffmpeg", "-h", "full"]).out
    before, after = ((), ("-metadata:s:v", "rotate=90")) if old else (("-display_rotation", "90"), ())
    written = ("-metadata", "creation_time=2026-11-21T07:12:00Z")
    t.ffmpeg(*before, "-i", "plain.mp4", "-c", "copy", *written, *after, "clip.mp4")
    t.vvr("cut", "clip.mp4", "--start", "2s", "-o", "piece.mp4").expect(0)
    whole, piece = (t.vvr("info", "--json", name).json() for name in ("clip.mp4", "piece.mp4"))
    check((whole["width"], whole["height"]) == (48, 64) == (piece["width"], piece["height"]), f"{whole} {piece}")
    check(piece["recorded"] is None and piece["written"] == "2026-11-21 07:12:02" and piece["frames"] == 20, str(piece))


def test_cut_of_a_damaged_clip(t):
    clip = bag(t, "bag.mkv")
    data = bytearray(t.path(clip).read_bytes())
    for k in range(len(data) // 2, len(data) // 2 + 400):
        data[k] ^= 0x5A
    t.write("damaged.mkv", bytes(data))
    t.vvr("cut", "damaged.mkv", "--start", "2s", "-o", "piece.mkv").expect(0, "frames copied, 1.600 s to 15.960 s")
    t.vvr("render", "piece.mkv", "--report", "piece.json").expect(0, "frames in")
    t.write("half.mkv", bytes(data[:len(data) // 3]))
    t.vvr("cut", "half.mkv", "--start", "1s", "--end", "15s", "-o", "piece.mkv").expect(
        0, "warning: 'half.mkv' ends at ", "earlier than the requested end", "frames copied")


@pytest.mark.nightly
def test_cut_refuses_events_that_are_not_there(t):
    clip = bag(t)
    events(t, clip)
    t.vvr("cut", clip, "--event", "4", "-o", "x.mp4").expect(
        1, "--event", "event 4", f"'{clip}'", "3 events", "1 to 3", code="event-unknown")
    t.vvr("cut", clip, "--event", "9", "--report", "report.json", "-o", "x.mp4").expect(
        1, "--event", "event 9", "'report.json'", "3 events", "1 to 3", code="event-unknown")
    t.vvr("cut", clip, "--event", "0", "-o", "x.mp4").expect(1, "--event", "'0'", "1", code="option-value-out-of-range")
    t.vvr("cut", clip, "--event", "1", "--filter", "edges", "-o", "x.mp4").expect(1, "--filter 'edges'", "choose another filter", code="options-conflict")
    t.expect_files(clip, "report.json")


def test_cut_refuses_reports_that_are_none(t):
    clip = bag(t)
    cut = ("cut", clip, "--event", "1", "-o", "x.mp4", "--report")
    for text in ("what is this", "[1, 2]", f'{{"report": 1, "input": {{"name": "{clip}"}}, "events": null}}',
                 f'{{"report": 1, "input": {{"name": "{clip}"}}, "events": [{{"first": 3}}]}}'):
        t.write("odd.json", text)
        t.vvr(*cut, "odd.json").expect(1, "'odd.json'", "vvr render", code="input-unsuitable")
    t.vvr(*cut, "none.json").expect(2, "none.json", "No such file or directory", code="file-not-found")
    events(t, clip)
    os.rename(t.path(clip), t.path("renamed.mp4"))
    t.vvr("cut", "renamed.mp4", "--event", "1", "--report", "report.json", "-o", "x.mp4").expect(
        0, "frames copied")  # the same file, whatever it is called


@pytest.mark.nightly
def test_cut_refuses_pieces_that_are_empty(t):
    t.clip("clip.mkv", seconds=4)
    for start, end, *facts in (("5s", "99s", "'clip.mkv'", "5 s"),
                               ("40f", "90f", "'clip.mkv'", "frame 40", "frame 90"),
                               ("3s", "3s", "3 s", "--start", "--end"), ("20f", "10f", "10", "--start", "--end"),
                               ("3.02s", "3.05s", "'clip.mkv'", "3.02 s", "3.05 s")):
        t.vvr("cut", "clip.mkv", "--start", start, "--end", end, "-o", "x.mkv").expect(1, *facts, code="span-empty")
    t.vvr("cut", "clip.mkv", "--start", "5s", "-o", "x.mkv").expect(1, "'clip.mkv'", "3.900 s", code="span-empty")
    t.vvr("cut", "clip.mkv", "--start", "1s", "--end", "10f", "--margin", "2", "-o", "x.mkv").expect(
        1, "--margin", "10", "12.5s", code="options-conflict")
    t.vvr("cut", "clip.mkv", "--start", "3s", "--end", "9s", "-o", "x.mkv").expect(0, "warning: 'clip.mkv' ends at 3.900 s")


def test_cut_refuses_what_cannot_be_cut(t):
    t.clip("frames/%03d.png", seconds=1, codec=())
    t.clip("clip.avi")
    t.vvr("extract", "clip.avi", "-o", "data").expect(0)
    os.mkfifo(t.path("pipe"))
    cut = lambda name: t.vvr("cut", name, "--start", "0", "-o", "x.mkv", timeout=20)
    cut("frames").expect(1, "'frames'", "pictures", code="input-unsuitable")
    cut("frames/%03d.png").expect(1, "'frames/%03d.png'", "pictures", code="input-unsuitable")
    cut("data").expect(1, "'data'", "`vvr extract`", "name video files", code="input-unsuitable")
    cut("-").expect(1, "'-'", "stdin", code="input-unsuitable")
    cut("rtsp://camera/stream").expect(1, "'rtsp://camera/stream'", "URL", code="input-unsuitable")
    cut("pipe").expect(1, "'pipe'", code="input-unsuitable")
    t.path("empty").mkdir()
    cut("empty").expect(1, "'empty'", code="input-unsuitable")
    cut("none.avi").expect(2, "'none.avi'", "No such file or directory", code="file-not-found")
    t.write("notes.avi", "this is no video\n" * 100)
    cut("notes.avi").expect(3, "'notes.avi' is not a video, but a text file", "give a video", code="not-video")
    t.ffmpeg("-f", "lavfi", "-i", "sine=duration=1", "sound.m4a")
    cut("sound.m4a").expect(3, "'sound.m4a'", "audio", "aac", code="no-video-stream")
    check(not t.path("x.mkv").exists(), "something was written")


def test_cut_needs_a_piece_and_an_output(t):
    t.clip("clip.avi")
    t.vvr("cut", "clip.avi", "--start", "0").expect(1, "-o FILE", code="output-missing")
    t.vvr("cut", "clip.avi", "-o", "x.avi").expect(1, "--event N", "--start TIME and --end TIME", code="usage")
    t.vvr("cut", "clip.avi", "--event", "1", "--report", "clip.avi", "--start", "0", "-o", "x.avi").expect(1, "--start", "--report", code="usage")
    t.vvr("cut", "clip.avi", "--start", "0", "--between", "02:00-05:00", "-o", "x.avi").expect(1, "--between", "--event", code="option-needs-another")
    t.vvr("cut", "clip.avi", "--start", "0", "--threshold=30", "-o", "x.avi").expect(1, "--threshold", "--event", code="option-needs-another")
    for option in (("--events", "left"), ("--threshold", "30")):
        t.vvr("cut", "clip.avi", "--event", "1", "--report", "clip.avi", *option, "-o", "x.avi").expect(1, option[0], "--report", code="options-conflict")
    t.vvr("cut", "clip.avi", "--start", "0", "-o", "x.png").expect(1, "'x.png'", ".mp4, .mov", code="output-format-unknown")
    t.vvr("cut", "clip.avi", "--start", "0", "-o", "x.avi", "--exact").expect(1, "--exact", code="option-unknown")
    t.vvr("cut", "clip.avi", "--start", "0", "-o", "no/x.mkv").expect(2, "'no/x.mkv'", "mkdir -p 'no'", code="file-not-found")
    t.vvr("cut", "-o", "x.avi", "--start", "0").expect(1, "INPUT", code="input-missing")
    t.expect_files("clip.avi")


def test_cut_never_writes_over_its_input(t):
    t.clip("clip.mkv")
    before = t.path("clip.mkv").read_bytes()
    os.link(t.path("clip.mkv"), t.path("hard.mkv"))
    os.symlink("clip.mkv", t.path("soft.mkv"))
    for name in ("clip.mkv", "./clip.mkv", "hard.mkv", "soft.mkv"):
        t.vvr("cut", "clip.mkv", "--start", "1s", "-o", name).expect(1, f"-o '{name}'", "'clip.mkv'", code="output-replaces-input")
    check(t.path("clip.mkv").read_bytes() == before, "the input has changed")


@pytest.mark.nightly
def test_cut_names_containers_that_can_hold_the_codec(t):
    t.clip("clip.mkv", codec=("-c:v", "ffv1"))
    t.vvr("cut", "clip.mkv", "--start", "1s", "-o", "x.mp4").expect(1, "'x.mp4'", "ffv1", "use ", ".mkv", code="options-conflict")
    bag(t)
    t.vvr("cut", "bag.mp4", "--start", "1s", "-o", "x.webm").expect(1, ".webm", "h264", ".mp4, .mov", code="options-conflict")
    t.ffmpeg("-i", "bag.mp4", "-c:v", "copy", "-c:a", "pcm_mulaw", "-ar", "8000", "law.mkv")
    t.vvr("cut", "law.mkv", "--start", "1s", "-o", "x.mp4").expect(1, ".mp4", "pcm_mulaw", ".mov", code="options-conflict")
    t.vvr("cut", "law.mkv", "--start", "1s", "-o", "x.mkv").expect(0, "frames copied")


def test_cut_refuses_to_copy_without_times(t):
    t.clip("clip.mp4", codec=("-c:v", "libx264", "-pix_fmt", "yuv420p"))
    t.ffmpeg("-i", "clip.mp4", "-c", "copy", "-bsf:v", "h264_mp4toannexb", "raw.h264")
    t.vvr("cut", "raw.h264", "--start", "1s", "-o", "x.mp4").expect(3, "'raw.h264'", "ffmpeg -ss", code="copy-impossible")


def test_cut_of_a_full_disk_leaves_nothing(t):
    clip = bag(t)
    t.run(["bash", "-c", f'ulimit -f 4; "{t.vvr_path}" cut {clip} --start 0 -o x.mp4']).expect(2, "'x.mp4'", "File too large", code="disk-full")
    t.expect_files(clip)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_cut_is_stopped_by_signals(t, number):
    t.clip("long.avi", seconds=60, size="640x480", codec=("-c:v", "rawvideo", "-pix_fmt", "yuv420p"))  # 276 MB
    child = t.start("cut", "long.avi", "--start", "0", "-o", "x.avi")
    end = time.monotonic() + 20
    while not any(name.endswith(".part") for name in t.files()):
        check(time.monotonic() < end and child.poll() is None, "nothing is being written")
        time.sleep(0.002)
    child.send_signal(number)
    check(child.wait(timeout=5) == -number, f"status {child.returncode}")
    t.expect_files("long.avi")


def test_cut_of_hostile_names(t):
    for name in ("-x.mkv", "a'b\"<c>.mkv", "ü\u202eivom.mkv", "%03d.mkv"):
        t.clip("clip.mkv")
        os.rename(t.path("clip.mkv"), t.path(name))
        t.vvr("cut", "./" + name, "--start", "1s", "-o", "./piece-" + name).expect(0, "10 frames copied")
        check(t.path("piece-" + name).exists(), f"no piece of {name}")
