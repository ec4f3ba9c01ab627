"""--time and --preset day: a recording of many hours in which little happens."""

import base64
import json

import pytest
from harness import check


def recording(t, name="day.mkv"):
    """Forty minutes at a frame a second; a square crosses the scene in minutes 5, 6, 24 and 25."""
    moving = "between(mod(t,1140),300,420)"
    return t.make(name, "day", how=lambda: t.ffmpeg(
        "-f", "lavfi", "-i", "color=gray:size=96x64:rate=1:duration=2400", "-f", "lavfi", "-i",
        "color=white:size=24x24:rate=1:duration=2400", "-filter_complex",
        f"[0][1]overlay=x='if({moving},mod(0.8*t,96),-50)':y=20:eval=frame", "-c:v", "ffv1", name))


def room_of(report, begin, end):
    """Share of the arc that a stretch has in which something moves."""
    idle = sum(stretch["room"] for stretch in report["volume"]["compressed"])
    check(all(stretch["first"] >= end - 4 or stretch["first"] + stretch["seconds"] <= begin + 4 for stretch in report["volume"]["compressed"]),
          f"motion from {begin} to {end} is compressed: {report['volume']['compressed']}")
    return 1 - idle


@pytest.mark.nightly
def test_room_goes_where_something_moves(t):
    recording(t)
    t.render("day.mkv", "--time", "even", "--report", "even.json", output="even.png").expect(0, "each layer merges ")
    check(t.json("even.json")["volume"]["compressed"] == [], "even time is compressed")
    told = t.render("day.mkv", "--size", "640x400", "--report", "busy.json", output="busy.png").expect(
        0, "'busy.png': 2400 frames", "36 min without motion are compressed on the time axis, in 3 places")
    report = t.json("busy.json")
    texts = [label["text"] for label in report["labels"]]
    check(any(text.endswith("36 min without motion are shortened") for text in texts), f"{texts}")
    check(any(text.endswith("min idle") for text in texts), f"{texts}")
    check(room_of(report, 300, 420) > 0.7, f"{report['volume']}")
    check(len(report["events"]) == len(t.json("even.json")["events"]), "other events")
    # By default the header decides: a short clip has even time, and one of more than two minutes has not.
    t.render("day.mkv", "--end", "110s", "--report", "r.json", output=None).expect(0)
    check(t.json("r.json")["volume"]["compressed"] == [], "a short clip is compressed")
    t.clip("busy.avi", seconds=130)
    for name, *options in (("auto.png",), ("busy.png", "--time", "busy"), ("even.png", "--time", "even")):
        t.render("busy.avi", "--reference", "first", "--show", "volume,ruler", *options, output=name).expect(0)
    pixels = [t.raw(name) for name in ("auto.png", "busy.png", "even.png")]
    check(pixels[0] == pixels[1] != pixels[2], "a clip of more than two minutes has even time by default")


@pytest.mark.nightly
def test_pixels_of_busy_time_tell_their_frames(t):
    recording(t)
    t.render("day.mkv", "--time", "busy", "--filter", "difference", "--report", "r.json", output="busy.html").expect(0)
    text = t.path("busy.html").read_text(encoding="utf-8")
    data = json.loads(text.split('id="pixeldata">')[1].split("</script>")[0])
    t.write("pixels.png", base64.b64decode(data["pixels"]["src"].split(",")[1]))
    raw = t.raw("pixels.png")
    frames = {(raw[i] << 16 | raw[i + 1] << 8 | raw[i + 2]) + data["pixels"]["first"] - 1 for i in range(0, len(raw), 3)
              if raw[i:i + 3] != b"\0\0\0"}
    # What stands at both ends of the arc besides are the first and the last frame.
    seen = frames - {0, 2399}
    check(seen, "no pixel tells its frame")
    check(all(298 <= frame <= 424 or 1438 <= frame <= 1564 for frame in seen), f"{sorted(seen)[:3]} to {sorted(seen)[-3:]}")
    check(len(seen) > 60, f"only {len(seen)} of the frames")


def test_a_clock_and_noise_are_no_motion(t):
    """Time goes to objects, not to pixels that change: every camera writes a clock into its pictures."""
    visit = "[0][1]overlay=x='if(between(t,60,72),12*(t-60)-24,-50)':y=20:eval=frame"
    clock = ",drawbox=x=4:y=4:w=20:h=12:color=white:t=fill:enable='lt(mod(t,2),1)',noise=alls=12:allf=t"
    for name, more in (("plain.mkv", ""), ("clock.mkv", clock)):
        t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=96x64:rate=5:duration=660", "-f", "lavfi", "-i",
                 "color=black:size=16x24:rate=5:duration=660", "-filter_complex", visit + more, "-c:v", "ffv1", name)
        told = t.render(name, "--report", "r.json").expect(0, "without motion are compressed on the time axis, in 2 places")
        check("none of the" not in told.err, told.err)
        check(room_of(t.json("r.json"), 60, 72) > 0.7, f"{t.json('r.json')['volume']}")
    t.render("clock.mkv", "--end", "59s", "--time", "busy", "--report", "r.json").expect(0)
    check(t.json("r.json")["volume"]["compressed"] == [], "nothing is there, and yet some of it has less room")


def test_says_why_no_time_is_compressed(t):
    moving = "[0][1]overlay=x='mod(8*t,120)-24':y=20:eval=frame"
    for name, filters, why in (("busy.mkv", moving, "objects move nearly all the time"), ("none.mkv", "[1]nullsink;[0]null", "vvr found no event")):
        t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=96x64:rate=2:duration=660", "-f", "lavfi", "-i",
                 "color=black:size=24x24:rate=2:duration=660", "-filter_complex", filters, "-c:v", "ffv1", name)
        t.render(name, "--report", "r.json").expect(0, f"'{name}': none of the 11 min is compressed, because {why}")
        check(any(why in text for text in t.json("r.json")["advice"]), f"{t.json('r.json')['advice']}")


def test_preset_of_a_day(t):
    recording(t)
    told = t.render("day.mkv", "--preset", "day", "--brick", "600s", "--start-time", "2026-11-21 07:50:00", "--size", "640x400",
                    "--report", "day.json").expect(0)
    report = t.json("day.json")
    texts = [label["text"] for label in report["labels"]]
    check("4 bricks" in told.err or "3 bricks" in told.err, f"bricks by the clock: {told}")
    check(any(text.startswith("07:5") or text.startswith("08:") for text in texts), f"{texts}")
    check(any("min idle" in text for text in texts), f"{texts}")
    t.render("day.mkv", "--preset", "day", "--show", "volume", output="plain.png").expect(0)
    t.render("day.mkv", "--show", "volume", "--preset=day", output="order.png").expect(0)
    check(t.path("plain.png").read_bytes() == t.path("order.png").read_bytes(), "options beside a preset win, in any order")
    t.render("day.mkv", "--preset", "dya").expect(1, "--preset", "'dya'", "'day'", code="choice-unknown")
    t.render("day.mkv", "--time", "busy", output="s.{brick}.png").expect(1, "--time busy", code="options-conflict")


@pytest.mark.nightly
def test_idle_time_of_extracted_data(t):
    recording(t)
    t.vvr("extract", "day.mkv", "-o", "data").expect(0)
    look = ("--time", "busy", "--show", "volume,outline,ruler")
    t.render("day.mkv", *look, output="clip.png").expect(0)
    t.render("data", *look, "--title", "day.mkv", output="data.png").expect(0)
    check(t.raw("clip.png") == t.raw("data.png"), "data files make another picture")


@pytest.mark.parametrize("zone", ["Europe/Berln", "Foo/Bar", "Berlin"])
def test_a_zone_that_does_not_exist_is_refused(t, zone):
    """The C library would use UTC, and the picture would show times that are hours off."""
    t.clip("2026-11-21_20-00-00.avi")
    t.zone(zone)
    t.render("2026-11-21_20-00-00.avi").expect(1, f"TZ: '{zone}' is no time zone", "Europe/Berlin, or install tzdata", code="option-value")


@pytest.mark.parametrize("zone, hour", [("Europe/Berlin", "+01:00"), (":Asia/Kolkata", "+05:30"), ("CET-1CEST,M3.5.0,M10.5.0/3", "+01:00"),
                                        ("<+0330>-3:30", "+03:30"), ("UTC", "+00:00"), ("", "+00:00")])
def test_zones_by_name_and_by_rule(t, zone, hour):
    t.clip("2026-11-21_20-00-00.avi")
    t.zone(zone)
    t.render("2026-11-21_20-00-00.avi", "--report", "r.json").expect(0)
    check(t.json("r.json")["clock"]["first"] == f"2026-11-21T20:00:00{hour}", f"{t.json('r.json')['clock']}")
