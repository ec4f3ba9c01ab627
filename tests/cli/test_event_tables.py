"""--events-csv and --tracks: the events of a clip as tables."""

import csv

from harness import check

FAST = ("--flow", "none", "--backend", "software")


def clip(t):
    """A square that crosses a scene of 384x288 pixels: the field is 192x144."""
    t.make("clip.mkv", "tables", how=lambda: t.ffmpeg(
        "-f", "lavfi", "-i", "color=gray:size=384x288:rate=10:duration=8", "-f", "lavfi", "-i",
        "testsrc2=size=60x80:rate=10:duration=8", "-filter_complex",
        "[0][1]overlay=x='if(between(t,2,6),20+60*(t-2),-100)':y=100:eval=frame", "-c:v", "ffv1", "clip.mkv"))


def test_tables_agree_with_the_report(t):
    clip(t)
    t.vvr("render", "clip.mkv", *FAST, "--field-size", "192x144", "--start-time", "2026-11-21 08:00:00", "--report", "r.json",
          "--events-csv", "events.csv", "--tracks", "tracks.txt").expect(0)
    events = t.json("r.json")["events"]
    with open(t.path("events.csv"), encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    check(len(rows) == len(events) == 1, f"{rows}")
    row, event = rows[0], events[0]
    check(row["number"] == "1" and row["kind"] == event["kind"] and row["direction"] == "right" and row["class"] == "", f"{row}")
    check(row["begin"] == event["first"]["time"] and float(row["last"]) == event["last"]["seconds"], f"{row}")
    check((row["camera"], row["clip"], row["file"], row["offset"]) == ("", "clip.mkv", "clip.mkv", row["first"]), f"{row}")
    check({key: int(row[key]) for key in event["box"]} == event["box"], f"{row} {event['box']}")
    tracks = [[int(value) for value in line.split(",")] for line in t.path("tracks.txt").read_text().splitlines()]
    check(all(len(line) == 10 and line[1] == 1 and line[6:] == [1, -1, -1, -1] for line in tracks), f"{tracks[:3]}")
    frames = [line[0] for line in tracks]
    check(frames == sorted(set(frames)) and len(frames) > 30, f"{frames}")
    check(frames[0] == event["first"]["frame"] + 1 and frames[-1] <= event["last"]["frame"] + 1, f"{frames}")
    # In pixels of the video, from 1: where the square was drawn.
    for frame, _, left, top, width, height, *_ in tracks:
        x = 20 + 60 * ((frame - 1) / 10 - 2)
        check(abs(left - 1 - x) < 12 and abs(top - 1 - 100) < 8, f"frame {frame}: {left},{top}, not {x},100")
        check(abs(width - 60) < 16 and abs(height - 80) < 14, f"frame {frame}: {width}x{height}")
    # A series has the same.
    t.vvr("render", "clip.mkv", *FAST, "--field-size", "192x144", "--size", "160x100", "-o", "s.{brick}.png", "--tracks", "series.txt").expect(0)
    check(t.path("series.txt").read_text() == t.path("tracks.txt").read_text(), "another table")


def test_tracks_have_what_the_empty_scene_shows(t):
    t.scene("left_bag", "bag.y4m", "--size", "192x144", "--frames", "400")
    t.ffmpeg("-i", "bag.y4m", "-vf", "select=eq(n\\,220)", "-frames:v", "1", "with_bag.png")
    t.vvr("render", "bag.y4m", *FAST, "--end", "285f", "--reference", "with_bag.png", "--report", "r.json", "--tracks", "tracks.txt").expect(0)
    bag = t.json("r.json")["events"][1]
    lines = [[int(value) for value in line.split(",")[:2]] for line in t.path("tracks.txt").read_text().splitlines()]
    frames = [frame - 1 for frame, number in lines if number == 2]
    check(bag["kind"] == "left" and frames == list(range(bag["first"]["frame"], 285)), f"{bag['first']} {frames}")


def test_tables_without_events(t):
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=96x64:rate=10:duration=3", "-c:v", "ffv1", "still.mkv")
    t.vvr("render", "still.mkv", *FAST, "--events-csv", "events.csv", "--tracks", "tracks.txt").expect(0)
    check(t.path("events.csv").read_text().count("\n") == 1 and t.path("tracks.txt").read_text() == "", "lines")


def test_one_table_of_an_archive(t):
    t.zone("UTC")
    clip(t)
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=96x64:rate=10:duration=3", "-c:v", "ffv1", "still.mkv")
    t.copy("clip.mkv", 'in/the "old", gate/2026-11-21_08-00-00.mkv', "in/hall/2026-11-21_08-00-00.mkv")
    t.copy("still.mkv", "in/hall/2026-11-21_08-01-00.mkv")
    for path in t.path("in").rglob("*.mkv"):
        t.stamp(path, -86400)
    run = ("archive", "in", "-o", "out", *FAST, "--size", "160x100", "--events-csv", "all.csv")

    def rows():
        with open(t.path("all.csv"), encoding="utf-8", newline="") as file:
            return [{key: row[key] for key in ("camera", "clip", "file", "offset", "number")} | {"begin": row["begin"]}
                    for row in csv.DictReader(file)]

    t.vvr(*run).expect(0, "3 clips drawn")
    table = t.path("all.csv").read_bytes()
    still, moved, quoted = sorted(rows(), key=lambda row: (row["number"], row["clip"]))
    check(still == dict.fromkeys(still, "") | {"camera": "hall", "clip": "hall/2026-11-21_08-01-00.mkv", "file": "hall/2026-11-21_08-01-00.mkv"}, f"{still}")
    check(moved["file"] == moved["clip"] == "hall/2026-11-21_08-00-00.mkv" and moved["begin"].startswith("2026-11-21T08:00:0"), f"{moved}")
    check(quoted["camera"] == 'the "old", gate', f"{quoted}")
    t.vvr("render", "clip.mkv", *FAST, "--events-csv", "one.csv").expect(0)
    check(t.path("one.csv").read_text().splitlines()[0] == table.decode().splitlines()[0], "other columns")
    # Nothing to do gives the same table, and so does no drawing at all.
    for again in (run, ("archive", "-o", "out", "--write", "index", "--events-csv", "all.csv")):
        t.path("all.csv").unlink()
        t.vvr(*again).expect(0)
        check(t.path("all.csv").read_bytes() == table, "another table")
    # A day names the files of its events.
    t.vvr(*run, "--per", "day").expect(0, "2 clips drawn")
    check({(row["clip"], row["file"]) for row in rows()} >= {("hall/2026-11-21", "hall/2026-11-21_08-00-00.mkv")}, f"{rows()}")
    t.vvr(*run[:-1], "none/all.csv").expect(2, "none/all.csv", code="file-not-found")


def test_tables_of_one_name(t):
    clip(t)
    t.vvr("render", "clip.mkv", "--events-csv", "x", "--tracks", "x").expect(
        1, "--events-csv and --tracks both name 'x'", code="options-conflict")
    for words, arguments in {
        "-o and --report both name 'p.01.png'": ("render", "clip.mkv", "-o", "p.{brick:2}.png", "--report", "p.01.png"),
        "-o and --log-file both name 'p.png'": ("render", "clip.mkv", "-o", "p.png", "--log-file", "./p.png"),
        "-o and --events-to both name 'p.png'": ("watch", "clip.mkv", "-o", "p.png", "--events-to", "p.png"),
        "-o and --report both write to standard output": ("render", "clip.mkv", "-o", "-", "--report", "-"),
    }.items():
        t.vvr(*arguments).expect(1, words, code="options-conflict")
    t.expect_files("clip.mkv")
    t.vvr("render", "clip.mkv", "--tracks", "none/x").expect(2, "none/x", code="file-not-found")
    t.vvr("render", "clip.mkv", "--tracks", "clip.mkv").expect(1, "would overwrite the input", code="output-replaces-input")
