"""Series: a picture for each brick, while a window slides over the clip."""

import pytest
from harness import check, moving_clip

ALL = ("--show", "volume,arrows,tracelines,outline,frames", "--backend", "software")


def pixels(t, name):
    return t.raw(name, "rgb48")


def test_a_picture_for_each_brick(t):
    moving_clip(t)
    for name, files in (("a.{brick:4}.png", "a.%04d.png"), ("b###.png", "b%03d.png"), ("c%d.png", "c%d.png")):
        t.render("clip.mkv", "--brick", "7f", "--window", "3", output=name).expect(
            0, f"vvr: '{name}': 6 pictures of 40 frames")
        for i in range(6):
            t.expect_picture(files % i)
            check(t.path(files % i).read_bytes() == t.path(f"a.{i:04}.png").read_bytes(), f"{files % i} is another")
    check(len(t.files()) == 1 + 3 * 6, f"{t.files()}")
    check(len({pixels(t, f"c{i}.png") for i in range(6)}) == 6, "pictures of the series are the same")
    data = t.path("c5.png").read_bytes()
    for text in (b"vvr:brick\x007", b"vvr:window\x003", b"vvr:first-frame\x0021", b"vvr:frames\x0019",
                 b"vvr:seconds\x002.100 to 3.900"):
        check(text in data, f"{text} is not in the last picture")


def crossing_clip(t):
    """Somebody in red puts a bag down at 13.0 s; somebody in blue appears at 13.2 s, before the bag can be called left."""
    square = lambda colour, size: ("-f", "lavfi", "-i", f"color={colour}:s={size}:r=10:d=40,noise=alls=20")
    t.make("clip.mp4", "crossing", how=lambda: t.ffmpeg(
        "-f", "lavfi", "-i", "color=0x707070:s=320x240:r=10:d=40,noise=alls=4", *square("0xc83030", "24x60"), *square("0x20b050", "18x16"),
        *square("0x3040c0", "26x64"), "-filter_complex",
        "[0][1]overlay=x='(t-13)*20+150':y=100[a];[a][2]overlay=x=150:y=146:enable='gte(t,13)'[b];[b][3]overlay=x='320-(t-13.2)*24':y=20",
        "-t", "40", "-c:v", "libx264", "-crf", "14", "-pix_fmt", "yuv420p", "clip.mp4"))


def test_the_report_of_a_series_has_the_numbers_of_its_pictures(t):
    """The pictures number objects in the order in which they show them, and a bag is shown when it has stayed for a while."""
    crossing_clip(t)
    t.render("clip.mp4", "--brick", "3s", "--window", "4", "--report", "r.json", "--events-csv", "e.csv", output="{brick}.png").expect(0)
    events = {event["number"]: event for event in t.json("r.json")["events"]}
    check([events[number]["kind"] for number in (1, 2, 3)] == ["moved", "moved", "left"], f"{events.keys()}")
    check(events[3]["by"] == 1 and events[3]["first"]["seconds"] < events[2]["first"]["seconds"], f"{events[3]}")
    names, *lines = [line.split(",") for line in t.path("e.csv").read_text().splitlines()]
    rows = [[line[names.index(name)] for name in ("number", "kind")] for line in lines]
    check(rows == [["1", "moved"], ["3", "left"], ["2", "moved"]], f"{rows}")
    t.vvr("cut", "clip.mp4", "--event", "2", "--report", "r.json", "--evidence", "case", "--camera-name", "gate").expect(0)
    (piece,) = t.json("case/evidence.json")["pieces"]
    begin, end = (piece[side]["offset"] for side in ("first", "last"))
    check(begin <= events[2]["first"]["seconds"] and end >= events[2]["last"]["seconds"], f"{piece}")
    check([event["number"] for event in piece["events"]] == [1, 3, 2], f"all that is in the piece: {piece}")


@pytest.mark.nightly
def test_a_window_that_moved_is_a_window_rendered_afresh(t):
    # Seeds of every second frame, as 160 frames are visible at a time.
    moving_clip(t, frames=320)
    t.render("clip.mkv", "--brick", "40f", "--window", "4", *ALL, output="moved.{brick}.png").expect(0, "8 pictures")
    for moved in (0, 3):
        begin, end = 40 * moved, 40 * (moved + 4)
        start = ("--start", f"{begin / 10}s") if moved else ()
        t.vvr("extract", "clip.mkv", "-o", f"part{moved}", *start, "--end", f"{end}f", "--flow-every", "1").expect(
            0, "160 frames")
        # Stripes run on by an eighth from picture to picture.
        t.render(f"part{moved}", "--brick", "40f", *ALL, "--animate", "8", output=f"fresh{moved}.{{frame}}.png").expect(0, "160 layers and 4 bricks")
        fresh = pixels(t, f"fresh{moved}.{(moved + 3) % 8}.png")
        check(fresh == pixels(t, f"moved.{moved + 3}.png"), f"moved by {moved} bricks")
    check(pixels(t, "moved.3.png") != pixels(t, "moved.4.png"), "moving makes no difference")
    check(len({pixels(t, f"fresh0.{i}.png") for i in range(8)}) == 8, "the stripes stand still")


@pytest.mark.nightly
def test_a_series_of_layers_that_hold_several_frames(t):
    moving_clip(t, frames=60)
    t.render("clip.mkv", "--brick", "9f", "--window", "3", "--step", "3", *ALL, output="moved.{brick}.png").expect(0)
    t.vvr("extract", "clip.mkv", "-o", "part", "--start", "1.8s", "--end", "45f", "--flow-every", "1").expect(0, "27 frames")
    t.render("part", "--brick", "9f", "--step", "3", *ALL, "--animate", "8", output="fresh.{frame}.png").expect(0, "9 layers and 3 bricks")
    check(pixels(t, "fresh.4.png") == pixels(t, "moved.4.png"), "three frames a layer")


def test_a_film_of_the_window(t):
    moving_clip(t)
    look = ("--brick", "10f", "--window", "2", "--show", "tracelines,outline", "--backend", "software", "--grid", "8",
            "--size", "480x300")
    t.render("clip.mkv", *look, "--slide", "3", output="window.mp4").expect(0, "'window.mp4': 12 pictures of 40 frames")
    check(t.frames_in("window.mp4") == 12, f"{t.frames_in('window.mp4')} pictures")
    t.ffmpeg("-i", "window.mp4", "f%02d.png")

    def changed(a, b):
        pairs = zip(t.rgb(f"f{a:02}.png"), t.rgb(f"f{b:02}.png"))
        return sum(max(abs(x - y) for x, y in zip(one, other)) > 30 for rows in pairs for one, other in zip(*rows))
    check(changed(7, 9) > 50, f"in a brick the stripes don't run: {changed(7, 9)} pixels change")
    check(changed(9, 10) > 2 * changed(7, 9), f"the window does not move: {changed(9, 10)} pixels change")
    t.render("clip.mkv", *look, "--slide", "1", output="window.gif").expect(0, "'window.gif': 4 pictures")
    for arguments, output, code, *facts in [
        (("--slide", "3"), "a.png", "options-conflict", "--slide", "'a.png'"),
        (("--slide", "3"), "a.{brick}.png", "options-conflict", "--slide", "'a.{brick}.png'"),
        (("--slide", "3", "--animate", "3"), "a.mp4", "options-conflict", "--slide", "--animate"),
        (("--slide", "3", "--golden", "g.png"), "a.mp4", "options-conflict", "--golden", "--slide"),
        (("--slide", "0"), "a.mp4", "option-value-out-of-range", "--slide", "'0'", "1 to 1000"),
        (("--slide", "3", "--time", "busy"), "a.mp4", "options-conflict", "--time busy"),
    ]:
        t.render("clip.mkv", *look, *arguments, output=output).expect(1, *facts, code=code)


@pytest.mark.nightly
def test_a_series_in_the_colours_of_the_video(t):
    t.ffmpeg("-i", moving_clip(t), "-frames:v", "1", "empty.png")
    for backend in ("software", "osmesa"):
        look = ("--brick", "10f", "--reference", "empty.png", "--color", "video", "--show", "volume,frames", "--backend",
                backend)
        t.render("clip.mkv", *look, "--window", "2", output=f"{backend}.{{brick}}.png").expect(0, "4 pictures")
        t.render("clip.mkv", *look, "--end", "20f", output="begin.png").expect(0, "2 bricks")
        check(pixels(t, "begin.png") == pixels(t, f"{backend}.1.png"), f"{backend}: the first full window")


@pytest.mark.nightly
def test_a_series_of_extracted_data(t):
    t.vvr("extract", moving_clip(t), "-o", "data", "--flow-every", "1").expect(0)
    look = ("--show", "volume,arrows,tracelines,outline", "--brick", "10f", "--window", "2", "--backend", "software")
    t.render("clip.mkv", *look, output="clip.{brick}.png").expect(0)
    t.render("data", *look, output="data.{brick}.png").expect(0, "4 pictures of 40 frames")
    for i in range(4):
        check(pixels(t, f"clip.{i}.png") == pixels(t, f"data.{i}.png"), f"picture {i}")


@pytest.mark.nightly
def test_a_clip_shorter_than_the_window(t):
    moving_clip(t)
    t.render("clip.mkv", "--brick", "2s", "--window", "8", output="s.{brick}.png").expect(0, "2 pictures of 40 frames")
    # Without a length of bricks the clip is cut for the window.
    # Before the clip has ended nobody knows which tracks are one object, so pictures of a series have other colours.
    alike = ("--window", "4", "--backend", "software", "--show", "volume,arrows,outline,frames,floor,ruler,legend,title")
    t.render("clip.mkv", *alike, output="t.{brick}.png").expect(0, "4 pictures")
    t.render("clip.mkv", *alike).expect(0)
    check(pixels(t, "out.png") == pixels(t, "t.3.png"), "the last one shows the whole clip")
    t.ffmpeg("-i", "clip.mkv", "-frames:v", "1", "-c:v", "ffv1", "one.mkv")
    t.render("one.mkv", output="one.{brick}.png").expect(0, "1 picture of 1 frame")
    t.expect_picture("one.0.png")


def test_series_that_cannot_be(t):
    t.clip()
    t.render("clip.avi", "--animate", "3", "--show", "volume,tracelines", output="a.{brick}.png").expect(
        1, "'a.{brick}.png'", "--animate", "{frame}", code="options-conflict")
    t.render("clip.avi", output="a.{frame}.png").expect(1, "'a.{frame}.png'", "--animate", "{brick}", code="option-needs-another")
    t.render("clip.avi", output="a.{brik}.png").expect(1, "{brik}", "'a.{brik}.png'", "'brick'", code="name-pattern-invalid")
    t.render("clip.avi", output="a.{brick}.gif").expect(1, "'a.{brick}.gif'", code="name-pattern-invalid")
    t.render("clip.avi", output="none/a.{brick}.png").expect(2, "'none'", code="file-not-found")
    t.expect_files("clip.avi")


def test_a_series_that_fails_half_way_leaves_whole_pictures(t):
    moving_clip(t)
    t.path("a.2.png").mkdir()
    t.render("clip.mkv", "--brick", "10f", output="a.{brick}.png").expect(2, "'a.2.png'", "Is a directory", code="not-a-file")
    t.expect_files("a.0.png", "a.1.png", "a.2.png", "clip.mkv")
    for i in range(2):
        t.expect_picture(f"a.{i}.png")


@pytest.mark.slow
def test_memory_of_a_series_depends_on_the_window(t):
    size = "320x240"
    t.clip("short.avi", seconds=10, size=size)
    t.clip("long.avi", seconds=60, size=size)
    few, many = (t.peak_memory("render", clip, "-o", "s.{brick}.png", "--size", "160x100", "--brick", "1s", "--window",
                             "4", "--show", "volume", "--quiet") for clip in ("short.avi", "long.avi"))
    volume = 500 * 320 * 240  # the difference between the clips, a byte a voxel
    check(many - few < volume / 2, f"{few / 1e6:.0f} MB and {many / 1e6:.0f} MB")


def colours_of(t, name):
    """Which of the three colours a picture shows."""
    pixels = [pixel for row in t.rgb(name) for pixel in row]
    return {colour for k, colour in enumerate(("red", "lime", "blue"))
            if any(pixel[k] > 150 and max(pixel[:k] + pixel[k + 1:]) < 90 for pixel in pixels)}


@pytest.mark.nightly
def test_a_series_shows_every_frame_before_a_gap(t):
    """Files of 4 s, a minute apart: no brick is whole, and each has frames that nobody else shows."""
    for i, colour in enumerate(("red", "lime", "blue")):
        t.ffmpeg("-f", "lavfi", "-i", "color=c=0x808080:size=160x120:rate=5:duration=4", "-f", "lavfi", "-i",
                 f"color=c={colour}:size=20x30:rate=5:duration=4", "-filter_complex",
                 f"[0][1]overlay=x=t*35:y={20 + i * 28},format=yuv420p", "-c:v", "mpeg4", "-q:v", "2", f"day/2026-11-21_10-0{i}-00.avi")
    look = ("--size", "640x400", "--reference", "first", "--color", "video", "--show", "volume,frames", "--backend", "software")
    for brick, window in (("10s", "4"), ("10s", "1"), ("3s", "2"), ("10s", "16")):
        for old in t.path(".").glob("s.*"):
            old.unlink()
        done = t.vvr("render", "day", "-o", "s.{brick:3}.png", "--brick", brick, "--window", window, *look, "--report", "r.json").expect(0)
        report = t.json("r.json")
        names = sorted(path.name for path in t.path(".").glob("s.*.png"))
        check(report["frames"]["used"] == 60 and f"{len(names)} pictures of 60 frames" in done.err, str(done))
        shown = set().union(*(colours_of(t, name) for name in names))
        check(shown == {"red", "lime", "blue"}, f"--brick {brick} --window {window}: only {shown} in {names}")
    # The picture before the gap tells its own time, not that of the gap's end.
    t.vvr("render", "day", "-o", "s.{brick:3}.png", "--brick", "10s", "--window", "2", *look).expect(0)
    data = t.path("s.000.png").read_bytes()
    check(b"vvr:seconds\x000.000 to 3.800" in data and b"vvr:frames\x0020" in data, "the first brick is another")
