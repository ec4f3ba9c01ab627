"""--skip-idle and --preset day: a recording of many hours in which little happens."""

import json

from harness import check


def recording(t, name="day.mkv"):
    """Forty minutes at a frame a second; a square crosses the scene in minutes 5, 6, 24 and 25."""
    moving = "between(mod(t,1140),300,420)"
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=96x64:rate=1:duration=2400", "-f", "lavfi", "-i",
             "color=white:size=24x24:rate=1:duration=2400", "-filter_complex",
             f"[0][1]overlay=x='if({moving},mod(0.8*t,96),-50)':y=20:eval=frame", "-c:v", "ffv1", name)
    return name


def test_idle_time_is_left_out(t):
    recording(t)
    t.render("day.mkv", "--report", "all.json", output="all.png").expect(0, "'all.png': 2400 frames")
    done = t.render("day.mkv", "--skip-idle", "20", "--size", "640x400", "--report", "busy.json", output="busy.png").expect(0)
    report = json.loads(t.path("busy.json").read_text(encoding="utf-8"))
    texts = [label["text"] for label in report["labels"]]
    check(any("without motion left out" in text for text in texts), f"{texts}")
    frames = int(done.err.split("'busy.png': ")[1].split()[0])
    check(240 <= frames <= 240 + 6 * 25, f"{frames} frames for four minutes of motion: {done}")
    # A click tells the frame of the recording, not of what is left of it.
    t.render("day.mkv", "--skip-idle", "20", output="busy.exr").expect(0)
    t.render("day.mkv", "--skip-idle", "20", "--size", "640x400", output="again.png").expect(0)
    check(t.path("again.png").read_bytes() == t.path("busy.png").read_bytes(), "not the same bytes")


def test_preset_of_a_day(t):
    recording(t)
    told = t.render("day.mkv", "--preset", "day", "--brick", "600s", "--start-time", "2026-11-21 07:50:00", "--size", "640x400",
                    "--report", "day.json").expect(0)
    report = json.loads(t.path("day.json").read_text(encoding="utf-8"))
    texts = [label["text"] for label in report["labels"]]
    check("4 bricks" in told.err or "3 bricks" in told.err, f"bricks by the clock: {told}")
    check(any(text.startswith("07:5") or text.startswith("08:") for text in texts), f"{texts}")
    check(any("left out" in text for text in texts), f"{texts}")
    t.render("day.mkv", "--preset", "day", "--show", "volume", output="plain.png").expect(0)
    t.render("day.mkv", "--show", "volume", "--preset=day", output="order.png").expect(0)
    check(t.path("plain.png").read_bytes() == t.path("order.png").read_bytes(), "options beside a preset win, in any order")
    t.render("day.mkv", "--preset", "dya").expect(1, "--preset: there is no 'dya'", "did you mean 'day'?")
    t.render("day.mkv", "--skip-idle", "-1").expect(1, "--skip-idle")
    t.render("day.mkv", "--skip-idle", "5", output="s.{brick}.png").expect(1, "--skip-idle is for one picture of a clip")


def test_idle_time_of_extracted_data(t):
    recording(t)
    t.vvr("extract", "day.mkv", "-o", "data").expect(0)
    look = ("--skip-idle", "20", "--show", "volume,outline,ruler")
    t.render("day.mkv", *look, output="clip.png").expect(0)
    t.render("data", *look, "--title", "day.mkv", output="data.png").expect(0)
    one, other = (t.run(["bash", "-c", f"ffmpeg -v error -i {name} -f rawvideo -pix_fmt rgb24 - | sha256sum"]).out
                  for name in ("clip.png", "data.png"))
    check(one == other, "data files make another picture")
