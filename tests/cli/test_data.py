"""Data files: extract, render of what it wrote, lists of seeds, inspect."""

import contextlib
import json
import shutil
import signal
import struct
import subprocess
import time

import pytest
from harness import check, moving_clip, part_name, without_colours


def same(t, one, other):
    check(t.path(one).read_bytes() == t.path(other).read_bytes(), f"{one} and {other} differ")


@pytest.mark.nightly
def test_parts_by_number_make_the_picture_of_the_whole(t):
    moving_clip(t, frames=41)
    t.render("clip.mkv", output="whole.png").expect(0)
    for i in (1, 2, 3):
        t.vvr("extract", "clip.mkv", "-o", f"part{i}", "--part", f"{i}/3").expect(0, "frames of 96x64")
    t.render("part1", "part2", "part3", output="parts.png").expect(0, "41 frames")
    check(t.path("parts.png").read_bytes() == t.path("whole.png").read_bytes(), "the parts make another picture")
    t.render("part1", "part2", "part3", output="parts.html").expect(0)
    check("<title>clip.mkv</title>" in t.path("parts.html").read_text(encoding="utf-8"), "the page has another title")
    t.vvr("extract", "clip.mkv", "-o", "none", "--part", "4/3").expect(1, "--part", "'4/3'", "2/8", code="option-value")
    t.vvr("extract", "clip.mkv", "-o", "none", "--part", "2/42").expect(
        1, "--part 2/42", "'clip.mkv'", "41 frames", code="option-value-out-of-range")
    t.vvr("extract", "clip.mkv", "-o", "none", "--part", "1/2", "--end", "5f").expect(1, "--start", "--end", code="options-conflict")
    check(not t.path("none").exists(), "a folder was made")


@pytest.mark.nightly
def test_the_cameras_clock_is_in_no_field(t):
    t.scene("clock", "clock.y4m", "--size", "192x144", "--frames", "750")
    t.vvr("extract", "clock.y4m", "-o", "data", "--flow", "none").expect(0, "clock")
    fields = {picture.read_bytes() for picture in t.path("data/scalar").iterdir()}
    check(len(fields) == 1, f"{len(fields)} fields differ: they have digits")
    t.render("clock.y4m", "--report", "report.json").expect(0, "nothing moves")
    overlays = t.json("report.json")["overlays"]
    check(len(overlays) == 1 and overlays[0]["box"]["y"] < 15, str(overlays))


def test_extract_writes_the_data_files(t):
    t.vvr("extract", moving_clip(t), "-o", "data", "--flow-every", "4").expect(0, "'data': 40 frames of 96x64")
    told = t.json("data/manifest.json")
    check((told["field_width"], told["field_height"], len(told["frames"])) == (96, 64, 40), str(told))
    check([frame["pts"] for frame in told["frames"][:3]] == [0, 0.1, 0.2], str(told["frames"][:3]))
    names = [f"{n:06}" for n in range(40)]
    check(sorted(p.stem for p in t.path("data/scalar").iterdir()) == names, "not a scalar picture a frame")
    check(sorted(p.stem for p in t.path("data/flow").iterdir()) == names[::4], "not a flow every 4 frames")
    check(sorted(p.stem for p in t.path("data/seeds").iterdir()) == names[::4], "not a list of seeds every 4 frames")
    flow = t.path("data/flow/000020.flo").read_bytes()
    u = struct.unpack(f"<{96 * 64 * 2}f", flow[12:])[2 * (32 * 96 + 44)]
    check(0.5 < u < 3, f"the square moves 1.5 pixels per frame, the flow says {u}")
    check(t.probe("data/scalar/000020.png", "stream=pix_fmt") == "gray", "a scalar picture is not grey")
    for name in ("reference", "first", "last"):
        t.expect_picture(f"data/{name}.png", (96, 64))


def test_colour_of_the_video_needs_extracted_frames(t):
    t.vvr("extract", moving_clip(t), "-o", "data").expect(0)
    check(len(list(t.path("data/color").iterdir())) == 40, "not a picture a frame")
    without_colours(t, "data")
    t.render("data", "--color", "video").expect(1, "'data'", code="extraction-unsuitable")
    check(not t.path("out.png").exists(), "a picture was written")


@pytest.mark.parametrize("extracted, drawn", [
    (("--threshold", "30", "--grid", "8"), ("--show", "volume,arrows,tracelines,frames", "--window", "4")),
    ((), ("--color", "video")), pytest.param((), ("--color", "direction", "--show", "volume"), marks=pytest.mark.nightly),
    pytest.param(("--start", "17f"), (), marks=pytest.mark.nightly),
    pytest.param(("--start", "1.5s", "--end", "2.05s"), (), marks=pytest.mark.nightly)])
def test_extracted_data_give_the_picture_of_the_clip(t, extracted, drawn):
    t.vvr("extract", moving_clip(t), "-o", "data", *extracted).expect(0)
    t.render("clip.mkv", *extracted, *drawn, output="clip.png").expect(0)
    # What an extraction was made with may be said again.
    for options in {(), extracted}:
        t.render("data", *drawn, *options, output="data.png").expect(0)
        same(t, "clip.png", "data.png")


@pytest.mark.nightly
def test_parts_by_time_fit_together_or_not(t):
    t.vvr("extract", moving_clip(t), "-o", "whole").expect(0)
    for part, *span in (("part0", "--end", "10f"), ("part10", "--start", "1s", "--end", "20f"),
                        ("part20", "--start", "2s")):
        t.vvr("extract", "clip.mkv", "-o", part, *span).expect(0)
        same(t, "whole/reference.png", f"{part}/reference.png")
    for name in ("scalar/000015.png", "flow/000015.flo", "seeds/000015.txt", "color/000015.png"):
        same(t, f"whole/{name}", f"part10/{name}")
    t.render("whole", "--backend", "software", output="whole.png").expect(0)
    t.render("part0", "part10", "part20", "--backend", "software", output="parts.png").expect(0, "40 frames")
    same(t, "whole.png", "parts.png")
    t.render("part0", "part20").expect(1, "frame 9", "frame 20", code="extraction-unsuitable")
    t.render("part10", "part0").expect(1, "'part10'", "'part0'", code="extraction-unsuitable")
    t.render("part0", "clip.mkv").expect(1, "'part0'", code="input-unsuitable")
    t.vvr("extract", "clip.mkv", "-o", "part10", "--start", "10f", "--grid", "9").expect(0)
    t.render("part0", "part10").expect(1, "grid", "'14'", "'9'", code="extraction-unsuitable")


def test_extraction_of_a_recording_with_a_gap_gives_its_picture(t):
    moving_clip(t, frames=60)
    for name, begin in (("gate_20261121_080000", 0), ("gate_20261121_080004", 4)):
        t.ffmpeg("-ss", f"{begin}", "-t", "2", "-i", "clip.mkv", "-c:v", "ffv1", f"day/{name}.mkv")
    look = ("--title", "gate")  # the time of day is that of the names
    t.render("day", *look, output="right.png").expect(0, "40 frames in 60 layers")
    t.vvr("extract", "day", "-o", "data").expect(0, "40 frames")
    t.render("data", *look, output="data.png").expect(0, "40 frames in 60 layers")
    same(t, "right.png", "data.png")
    for part in ("1", "2"):  # the second begins in the gap, with frame 30
        t.vvr("extract", "day", "-o", part, "--part", f"{part}/2").expect(0, "20 frames")
    t.render("1", "2", *look, output="parts.png").expect(0, "40 frames in 60 layers")
    same(t, "right.png", "parts.png")


def test_extract_takes_pictures_at_full_size(t):
    t.clip("frames/%03d.png", seconds=0.5, size="500x40", codec=())
    t.vvr("extract", "frames", "-o", "data", "--field-size", "source").expect(0, "5 frames of 500x40")
    check(t.path("data/flow/000002.flo").read_bytes()[4:12] == struct.pack("<ii", 500, 40), "not the full size")


def test_extract_goes_on_where_a_run_was_killed_at_its_first_file(t):
    t.clip(seconds=0.5)
    t.write(f"data/{part_name('manifest.json')}", "half")
    t.vvr("extract", "clip.avi", "-o", "data").expect(0, "5 frames")
    check(not list(t.path("data").glob(".*")), "it left the file of the killed run")
    t.write(f"mine/{part_name('manifest.json')}", "half")
    t.write("mine/.notes", "keep me")
    t.vvr("extract", "clip.avi", "-o", "mine").expect(2, "'mine'", code="folder-not-empty")


@contextlib.contextmanager
def extracting(t, clip):
    """A run of `vvr extract` that is writing to the folder `data`, and is stopped there."""
    run = subprocess.Popen([t.vvr_path, "extract", clip, "-o", "data"], cwd=t.folder, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL)
    try:
        until = time.monotonic() + 60
        while not t.path("data/first.png").exists():
            check(run.poll() is None and time.monotonic() < until, "it wrote no frame, or all of them")
            time.sleep(0.001)
        run.send_signal(signal.SIGSTOP)
        yield run
    finally:
        run.kill()
        run.wait()


def test_extract_writes_a_folder_once_at_a_time(t):
    t.clip("long.avi", seconds=60)
    t.clip("short.avi", seconds=1)
    with extracting(t, "long.avi") as first:
        t.vvr("extract", "short.avi", "-o", "data").expect(2, "'data'", "another `vvr extract`", code="file-locked")
        first.send_signal(signal.SIGCONT)
        check(first.wait(timeout=120) == 0, f"the second run broke the first: status {first.returncode}")
    check(len(list(t.path("data/scalar").iterdir())) == 600, "frames of the first run are lost")
    # A run that was killed holds nothing up.
    shutil.rmtree(t.path("data"))
    with extracting(t, "long.avi"):
        pass
    t.vvr("extract", "short.avi", "-o", "data").expect(0, "10 frames")
    check(not list(t.path("data").glob(".*")), "a lock stays")


def test_extract_replaces_only_its_own(t):
    moving_clip(t)
    t.write("mine/notes.txt", "keep me")
    t.vvr("extract", "clip.mkv", "-o", "mine").expect(2, "'mine'", "`vvr extract`", code="folder-not-empty")
    t.vvr("extract", "clip.mkv", "-o", "mine/notes.txt").expect(2, "'mine/notes.txt'", code="not-a-folder")
    t.vvr("extract", "clip.mkv", "-o", "none/data").expect(2, "'none/data'", "mkdir -p 'none'", code="file-not-found")
    t.vvr("extract", "clip.mkv").expect(1, "-o DIR", code="output-missing")
    t.vvr("extract", "-o", "data").expect(1, "INPUT", code="input-missing")
    t.vvr("extract", "clip.mkv", "-o", "data", "--start", "736.40199999999999s", "--end", "750.4019999999999s").expect(
        1, "'clip.mkv'", "736.402 s", "750.402 s", code="span-empty")
    t.vvr("extract", "clip.mkv", "-o", "data", "--start", "40f").expect(
        1, "'clip.mkv'", "frame 40", "40 frames", "3.900 s", code="span-empty")
    t.expect_files("clip.mkv", "mine", "mine/notes.txt")
    t.vvr("extract", "clip.mkv", "-o", "data").expect(0)
    t.vvr("extract", "clip.mkv", "-o", "data", "--end", "5f", "--flow", "none").expect(0, "5 frames")
    check(len(list(t.path("data/scalar").iterdir())) == 5, "the older extraction was not replaced")
    t.render("data", "--show", "arrows").expect(1, "'data'", "--show", code="extraction-unsuitable")
    t.render("data", "--show", "volume").expect(0)


def test_an_older_extraction_stays_until_the_new_one_is_complete(t):
    t.clip("clip.avi", seconds=1)
    t.clip("long.avi", seconds=60)
    t.vvr("extract", "clip.avi", "-o", "data").expect(0)
    t.write("data/notes.txt", "mine")

    def content():
        return {path: path.read_bytes() for path in t.path("data").rglob("*") if path.is_file()}

    before = content()
    t.run(["bash", "-c", f'ulimit -f 4; "{t.vvr_path}" extract long.avi -o data --field-size source']).expect(
        2, "'data/", "File too large", "free some space", code="disk-full")
    check(content() == before, "the older extraction has changed")
    run = t.start("extract", "long.avi", "-o", "data")
    while not t.path("data/.vvr-new/first.png").exists():
        check(run.poll() is None, "it wrote no frame")
        time.sleep(0.001)
    run.kill()
    run.wait()
    t.render("data").expect(0, "10 frames")
    t.vvr("extract", "clip.avi", "-o", "data", "--end", "5f").expect(0, "5 frames")
    check(len(list(t.path("data/scalar").iterdir())) == 5 and not list(t.path("data").glob(".*")), f"{t.files()}")
    check(t.path("data/notes.txt").read_text() == "mine", "somebody else's file has changed")


def test_options_that_an_extraction_decided(t):
    t.vvr("extract", moving_clip(t), "-o", "data").expect(0)
    t.render("data", "--filter", "edges").expect(1, "--filter edges", "'data'", "difference", code="extraction-unsuitable")
    t.render("data", "--grid", "9").expect(1, "--grid 9", "'data'", "14", "`vvr seeds`", code="extraction-unsuitable")
    t.render("data", "--end", "9f").expect(1, "--end 9f", "'data'", "vvr extract", code="extraction-unsuitable")


def test_manifest_that_lies(t):
    t.vvr("extract", moving_clip(t, frames=12), "-o", "good").expect(0)

    def change(status, code, edit, *facts, file="manifest.json"):
        shutil.rmtree(t.path("bad"), ignore_errors=True)
        shutil.copytree(t.path("good"), t.path("bad"))
        told = t.json("bad/manifest.json")
        edit(told)
        t.write("bad/manifest.json", json.dumps(told))
        t.render("bad", "--show", "volume,arrows").expect(status, f"'bad/{file}'", *facts, code=code)

    change(2, "file-not-found", lambda m: m["frames"].append({"index": 12, "pts": 9, "seeds": 0}), file="scalar/000012.png")
    change(2, "file-invalid", lambda m: m.update(field_width=97), "96x64", "97x64", file="reference.png")
    change(2, "file-invalid", lambda m: m["frames"][3].update(seeds=99), "99", file="seeds/000003.txt")
    shutil.copytree(t.path("good"), t.path("cut"))
    t.path("cut/flow/000004.flo").write_bytes(b"PIEH")
    t.render("cut", "--show", "tracelines").expect(2, "cut/flow/000004.flo", "4 bytes", "12", code="file-invalid")
    check(not t.path("out.png").exists(), "a picture of bad data")


def test_seeds_from_lists(t):
    t.vvr("extract", moving_clip(t), "-o", "data").expect(0)
    t.render("clip.mkv", "--backend", "software", "--show", "volume,arrows", output="own.png").expect(0)
    t.render("clip.mkv", "--backend", "software", "--show", "volume,arrows", "--seeds", "data/seeds", output="listed.png").expect(0)
    check(t.raw("own.png") == t.raw("listed.png"), "the lists make another picture")
    t.write("one/000007.txt", "vvr-seeds 1\nframe 7\nsize 96 64\npoints 1\n40 30 2 0 1\n")
    t.render("clip.mkv", "--seeds", "one", "--show", "volume", "--verbose").expect(0, " 1 arrows")
    t.render("clip.mkv", "--seeds", "data").expect(2, "--seeds", "'data'", code="file-not-found")


def test_inspect_shows_one_frame(t):
    moving_clip(t)
    t.vvr("inspect", "clip.mkv", "--frame", "20f", "-o", "a.png").expect(0, "frame 20 at 2.000 s")
    t.vvr("inspect", "clip.mkv", "--frame", "2.05s", "-o", "b.png").expect(0, "frame 20 at 2.000 s")
    same(t, "a.png", "b.png")
    check(t.picture_size("a.png")[0] == 1280, f"{t.picture_size('a.png')}")
    t.vvr("inspect", "clip.mkv", "--frame", "40f", "-o", "c.png").expect(
        1, "--frame", "'clip.mkv'", "40 frames", "3.900 s", code="option-value-out-of-range")
    t.vvr("inspect", "clip.mkv", "--frame", "00:01:00", "-o", "c.png").expect(1, "--frame", "40 frames", code="option-value-out-of-range")
    t.vvr("inspect", "clip.mkv", "-o", "c.png").expect(0, "frame 20 at 2.000 s; --frame TIME chooses another")
    t.path("c.png").unlink()
    t.vvr("inspect", "clip.mkv", "--frame", "3f").expect(1, "-o FILE", code="output-missing")
    t.expect_files("a.png", "b.png", "clip.mkv")
