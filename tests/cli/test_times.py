"""Times that can hardly be true are said, with the option that mends them; clean clips cause no such word."""

import datetime
import os

import pytest
from harness import check

LOOK = ("-o", "x.png", "--size", "160x100", "--backend", "software", "--report", "r.json")
H264 = ("-c:v", "libx264", "-preset", "ultrafast", "-pix_fmt", "yuv420p")


def source(seconds, rate=10):
    return ("-f", "lavfi", "-i", f"testsrc2=size=64x48:rate={rate}:duration={seconds}")


def restamp(t, clip, out, expression):
    """A copy of a clip whose video has other timestamps."""
    t.ffmpeg("-i", clip, "-c", "copy", "-bsf:v", f"setts={expression}", out)


def last_time(t):
    return t.json("r.json")["span"]["last"]


def test_sound_of_another_length(t):
    t.ffmpeg(*source(20), "-f", "lavfi", "-i", "sine=300:d=20", *H264, "-c:a", "aac", "true.mp4")
    restamp(t, "true.mp4", "fast.mp4", "ts=TS/1.42")
    restamp(t, "true.mp4", "call.mp4", "ts=TS/40")
    t.vvr("render", "fast.mp4", *LOOK).expect(0, "sound is 1.42 times as long", "--rate 10")
    t.vvr("render", "call.mp4", *LOOK).expect(0, "sound is", "times as long", "--rate")
    said = t.vvr("render", "fast.mp4", "--rate", "10", *LOOK).expect(0, out=None).err
    check("sound" not in said and abs(last_time(t) - 19.9) < 0.05, f"{said} {last_time(t)}")
    # Sound that begins later or ends a little earlier is no reason to doubt, nor is a frame rate that varies.
    t.ffmpeg(*source(20), "-itsoffset", "8", "-f", "lavfi", "-i", "sine=300:d=12", *H264, "-c:a", "aac", "later.mp4")
    t.ffmpeg(*source(20), "-f", "lavfi", "-i", "sine=300:d=17.5", *H264, "-c:a", "aac", "shorter.mp4")
    t.ffmpeg(*source(20), "-f", "lavfi", "-i", "sine=300:d=20", "-vf", "select='lt(n,20)+not(mod(n,9))'", "-vsync", "0",
             *H264, "-c:a", "aac", "varied.mp4")
    for clip in ("true.mp4", "later.mp4", "shorter.mp4", "varied.mp4"):
        t.vvr("render", clip, *LOOK, "--quiet").expect(0, err="")


def test_a_rate_that_no_camera_has(t):
    t.ffmpeg(*source(20), *H264, "plain.mp4")
    restamp(t, "plain.mp4", "call.mp4", "ts=TS/40")
    t.vvr("render", "call.mp4", *LOOK).expect(0, "frames per second, more than cameras have", "--rate")


@pytest.mark.parametrize("ending", ["mp4", "mkv"])
def test_frames_a_tick_apart_get_the_usual_distance(t, ending):
    t.ffmpeg(*source(20), *H264, "true.mp4")
    expression = "if(lt(N,80),{0},PREV_OUT{0}+1)"
    restamp(t, "true.mp4", f"jumped.{ending}", f"pts='{expression.format('PTS')}':dts='{expression.format('DTS')}'")
    t.vvr("render", f"jumped.{ending}", *LOOK).expect(0, "frames from 8.0 s on have almost the same time")
    check(abs(last_time(t) - 19.9) < 0.15, f"{last_time(t)}")
    unseen = t.json("r.json")["unseen"]
    told = [(one["kind"], one["begin"]["seconds"], one["end"]["seconds"]) for one in unseen["intervals"]]
    check(unseen["gaps"] == [] and len(told) == 1 and told[0][0] == "times_doubtful", f"{unseen}")
    check(abs(told[0][1] - 7.9) < 0.15 and told[0][2] == last_time(t), f"{told}")
    # A piece of the clip has its part of the interval; one before it has none.
    t.vvr("render", f"jumped.{ending}", "--end", "12s", *LOOK).expect(0)
    check(t.json("r.json")["unseen"]["intervals"][0]["end"]["seconds"] == last_time(t), f"{t.json('r.json')['unseen']}")
    t.vvr("render", f"jumped.{ending}", "--end", "6s", *LOOK).expect(0, out=None)
    check(t.json("r.json")["unseen"]["intervals"] == [], f"{t.json('r.json')['unseen']}")
    t.vvr("cut", f"jumped.{ending}", "--start", "12s", "--end", "14s", "-o", "piece.mkv").expect(0, out=None)


def test_a_time_lapse_has_a_frame_each_24_s(t):
    t.ffmpeg(*source(2, 30), *H264, "lapse.mp4")
    t.vvr("render", "lapse.mp4", "--rate", "1/24s", *LOOK).expect(0, out=None)
    check(abs(last_time(t) - 59 * 24) < 1, f"{last_time(t)}")


def stuttering(t, folder, files=6, real=10, stated=12, every=12):
    """Files of a recorder that states more frames per second than it gets. They begin `every` seconds."""
    t.zone("UTC")
    t.ffmpeg(*source(files * 10, stated), *H264, "-g", str(stated), "long.mp4")
    begin = datetime.datetime(2026, 8, 14, 13, 0, 0)
    for number in range(files):
        at = begin + datetime.timedelta(seconds=number * every)
        name = f"{folder}/gate_{at:%Y-%m-%d_%H-%M-%S}.mp4"
        t.ffmpeg("-ss", str(number * 10), "-i", "long.mp4", "-t", "10", "-c", "copy", name)
    return [t.path(folder) / name for name in sorted(os.listdir(t.path(folder)))]


def test_a_stuttering_recording_is_one_recording(t):
    stuttering(t, "day")
    t.vvr("render", "day", *LOOK).expect(0, "10 frames per second, not the 12", "--rate 12")
    report = t.json("r.json")
    check(report["unseen"]["gaps"] == [] and abs(last_time(t) - 71.9) < 0.2, f"{report['unseen']} {last_time(t)}")
    # A piece has what is shown there: the last second of the second file.
    t.vvr("cut", "day", "--start", "23s", "--end", "23.8s", "-o", "piece.mkv").expect(0, "gate_2026-08-14_13-00-12.mp4")
    # The stated rate is kept if it is asked for.
    said = t.vvr("render", "day", "--rate", "12", *LOOK).expect(0, out=None).err
    check("not the 12" not in said and len(t.json("r.json")["unseen"]["gaps"]) == 5, said)


def test_true_pauses_stay(t):
    # Each file was finished before the next began.
    for number, file in enumerate(stuttering(t, "closed")):
        t.stamp(file, 1786712400 + 12 * number + 10)
    said = t.vvr("render", "closed", *LOOK).expect(0, out=None).err
    check("frames per second" not in said and len(t.json("r.json")["unseen"]["gaps"]) == 5, said)
    # Clips of motion begin at any time.
    files = stuttering(t, "motion")
    for number, file in enumerate(files):
        at = datetime.datetime(2026, 8, 14, 15, 0, 0) + datetime.timedelta(seconds=(12, 40, 52, 90, 200, 212)[number])
        file.rename(file.with_name(f"gate_{at:%Y-%m-%d_%H-%M-%S}.mp4"))
    said = t.vvr("render", "motion", *LOOK).expect(0, out=None).err
    check("frames per second" not in said, said)


def snapshots(t, folder, minutes, name="gate_{:%Y-%m-%d_%H-%M-%S}.jpg"):
    t.zone("UTC")
    t.ffmpeg(*source(len(minutes), 1), "-q:v", "4", f"{folder}/%03d.jpg")
    for number, minute in enumerate(minutes):
        at = datetime.datetime(2026, 11, 21) + datetime.timedelta(minutes=minute)
        t.path(f"{folder}/{number + 1:03d}.jpg").rename(t.path(f"{folder}/{name.format(at)}"))


def test_snapshots_have_the_times_of_their_names(t):
    snapshots(t, "gate", [*range(0, 600, 15), *range(720, 960, 15)])
    t.vvr("render", "gate", *LOOK).expect(0, "pictures are 900 s apart", "guesses")
    report = t.json("r.json")
    check(last_time(t) == 945 * 60 and report["frames"]["used"] == 56, f"{report['span']} {report['frames']}")
    gaps = [(gap["begin"], gap["end"]) for gap in report["unseen"]["gaps"]]
    check(len(gaps) == 1 and report["unseen"]["gaps"][0]["frames"] == 8, f"{gaps}")
    check(report["clock"]["first"].startswith("2026-11-21T00:00:00") and report["input"]["camera"] == "gate", f"{report['clock']}")
    # A part of the day; a pattern of names; the rate that is asked for; pictures without a time.
    t.vvr("render", "gate", "--start", "@12:00", "--end", "@13:00", *LOOK).expect(0, out=None)
    check(t.json("r.json")["frames"]["used"] == 4, f"{t.json('r.json')['frames']}")
    t.vvr("render", "gate", "--rate", "1/10s", *LOOK).expect(0, out=None)
    check(last_time(t) == 550 and t.json("r.json")["clock"]["first"].startswith("2026-11-21T00:00:00"), f"{last_time(t)}")
    snapshots(t, "own", range(3), name="yard {:%H-%M on %d.%m.%Y}.jpg")
    t.copy("own/yard 00-00 on 21.11.2026.jpg", "own/latest.jpg")
    t.vvr("render", "own", "--names", "{camera} %H-%M on %d.%m.%Y", *LOOK).expect(0, "1 picture whose name has no time", "latest.jpg")
    check(last_time(t) == 120 and t.json("r.json")["input"]["camera"] == "yard", f"{t.json('r.json')['input']}")
    t.vvr("render", "own", "--names", "{camera}_%s", *LOOK).expect(0, "most names of its pictures give no time")


def test_an_archive_draws_days_of_snapshots(t):
    snapshots(t, "in/gate", [*range(0, 600, 60), *range(1500, 1800, 60)])
    snapshots(t, "in/yard", range(3), name="{:%Y%m%d_%H%M%S}.jpg")
    t.copy("in/yard/20261121_000000.jpg", "in/yard/logo.jpg", "in/door/2026-11-21_10-00-05.jpg")
    t.ffmpeg(*source(1), *H264, "in/door/2026-11-21_10-00-00.mp4")
    t.archive("in", "-o", "out").expect(0, "1 clip drawn", out=None)
    done = t.archive("in", "-o", "days", "--per", "day").expect(0, "4 clips drawn", out=None)
    for name in ("gate/2026-11-21", "gate/2026-11-22", "yard/2026-11-21", "door/2026-11-21"):
        check(t.path(f"days/{name}.png").exists(), f"{name}: {done}")
    t.archive("in", "-o", "days", "--per", "day").expect(0, "nothing to do", out=None)
    t.path("none").mkdir()
    t.archive("none", "-o", "out2").expect(0, "no clips found", "--per day", out=None)
