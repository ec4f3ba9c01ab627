"""Data files: extract, render of what it wrote, lists of seeds, inspect."""

import json
import shutil
import struct

from harness import check, moving_clip, without_colours


def same(t, one, other):
    check(t.path(one).read_bytes() == t.path(other).read_bytes(), f"{one} and {other} differ")


def manifest(t, folder):
    return json.loads(t.path(f"{folder}/manifest.json").read_text())


def test_parts_by_number_make_the_picture_of_the_whole(t):
    moving_clip(t, frames=41)
    t.render("clip.mkv", output="whole.png").expect(0)
    for i in (1, 2, 3):
        t.vvr("extract", "clip.mkv", "-o", f"part{i}", "--part", f"{i}/3").expect(0, "frames of 96x64")
    t.render("part1", "part2", "part3", output="parts.png").expect(0, "41 frames")
    check(t.path("parts.png").read_bytes() == t.path("whole.png").read_bytes(), "the parts make another picture")
    t.render("part1", "part2", "part3", output="parts.html").expect(0)
    check("<title>clip.mkv</title>" in t.path("parts.html").read_text(encoding="utf-8"), "the page has another title")
    for part, code, *facts in [
        ("4/3", "option-value", "--part", "'4/3'", "2/8"),
        ("0/3", "option-value", "--part", "'0/3'"),
        ("1", "option-value", "--part", "'1'"),
        ("1/x", "option-value", "--part", "'1/x'"),
        ("2/42", "option-value-out-of-range", "--part 2/42", "'clip.mkv'", "41 frames"),
    ]:
        t.vvr("extract", "clip.mkv", "-o", "none", "--part", part).expect(1, *facts, code=code)
    t.vvr("extract", "clip.mkv", "-o", "none", "--part", "1/2", "--end", "5f").expect(1, "--start", "--end", code="options-conflict")
    check(not t.path("none").exists(), "a folder was made")


def test_the_cameras_clock_is_in_no_field(t):
    t.scene("clock", "clock.y4m", "--size", "192x144", "--frames", "750")
    t.vvr("extract", "clock.y4m", "-o", "data", "--flow", "none").expect(0, "clock")
    fields = {picture.read_bytes() for picture in t.path("data/scalar").iterdir()}
    check(len(fields) == 1, f"{len(fields)} fields differ: they have digits")
    t.render("clock.y4m", "--report", "report.json").expect(0, "nothing moves")
    overlays = json.loads(t.path("report.json").read_text())["overlays"]
    check(len(overlays) == 1 and overlays[0]["box"]["y"] < 15, str(overlays))


def test_extract_writes_the_data_files(t):
    t.vvr("extract", moving_clip(t), "-o", "data", "--flow-every", "4").expect(0, "'data': 40 frames of 96x64")
    told = manifest(t, "data")
    check((told["field_width"], told["field_height"], len(told["frames"])) == (96, 64, 40), str(told))
    check([frame["pts"] for frame in told["frames"][:3]] == [0, 0.1, 0.2], str(told["frames"][:3]))
    names = [f"{n:06}" for n in range(40)]
    check(sorted(p.stem for p in t.path("data/scalar").iterdir()) == names, "not a scalar picture a frame")
    check(sorted(p.stem for p in t.path("data/flow").iterdir()) == names[::4], "not a flow every 4 frames")
    check(sorted(p.stem for p in t.path("data/seeds").iterdir()) == names[::4], "not a list of seeds every 4 frames")
    flow = t.path("data/flow/000020.flo").read_bytes()
    check(struct.unpack("<fii", flow[:12]) == (202021.25, 96, 64), f"header of the flow: {flow[:12]}")
    check(len(flow) == 12 + 96 * 64 * 8, f"{len(flow)} bytes of flow")
    u = struct.unpack(f"<{96 * 64 * 2}f", flow[12:])[2 * (32 * 96 + 44)]
    check(0.5 < u < 3, f"the square moves 1.5 pixels per frame, the flow says {u}")
    probe = t.run(["ffprobe", "-v", "error", "-show_entries", "stream=pix_fmt", "-of", "csv=p=0", "data/scalar/000020.png"])
    check(probe.out.strip() == "gray", f"a scalar picture is {probe.out}")
    for name in ("reference", "first", "last"):
        t.expect_picture(f"data/{name}.png", (96, 64))


def test_colour_of_the_video_needs_extracted_frames(t):
    clip = moving_clip(t)
    look = ("--backend", "software", "--color", "video")
    t.vvr("extract", clip, "-o", "data").expect(0)
    without_colours(t, "data")
    t.render("data", *look, output="no.png").expect(1, "'data'", code="extraction-unsuitable")
    check(not t.path("no.png").exists(), "a picture was written")
    t.vvr("extract", clip, "-o", "data").expect(0)
    check(len(list(t.path("data/color").iterdir())) == 40, "not a picture a frame")
    t.render(clip, *look, output="clip.png").expect(0)
    t.render("data", *look, output="data.png").expect(0)
    same(t, "clip.png", "data.png")


def test_extracted_data_give_the_same_picture(t):
    options = ("--threshold", "30", "--grid", "8")
    t.vvr("extract", moving_clip(t), "-o", "data", *options).expect(0)
    look = ("--backend", "software", "--show", "volume,arrows,tracelines,frames", "--window", "4")
    t.render("clip.mkv", *options, *look, output="clip.png").expect(0)
    t.render("data", *look, output="data.png").expect(0, "40 frames")
    same(t, "clip.png", "data.png")
    t.render("data", *look, *options, output="again.png").expect(0)
    same(t, "clip.png", "again.png")
    t.render("clip.mkv", *look, "--grid", "16", output="other.png").expect(0)
    check(t.path("other.png").read_bytes() != t.path("clip.png").read_bytes(), "the grid of seeds makes no difference")


def test_four_parts_are_one_whole(t):
    t.vvr("extract", moving_clip(t), "-o", "whole").expect(0)
    parts = []
    for begin in range(0, 40, 10):
        parts.append(f"part{begin}")
        end = () if begin == 30 else ("--end", f"{begin + 10}f")
        start = ("--start", f"{begin / 10}s") if begin else ()
        t.vvr("extract", "clip.mkv", "-o", parts[-1], *start, *end).expect(0, "10 frames")
    files = [p.relative_to(t.path("whole")) for p in t.path("whole").rglob("0*")]
    check(len(files) == 160, f"{len(files)} files")
    for file in files:
        same(t, f"whole/{file}", f"part{int(file.stem) // 10 * 10}/{file}")
    for part in parts:
        same(t, "whole/reference.png", f"{part}/reference.png")
    t.render("whole", "--backend", "software", output="whole.png").expect(0)
    t.render(*parts, "--backend", "software", output="parts.png").expect(0, "40 frames")
    same(t, "whole.png", "parts.png")
    t.render("part0", "part20").expect(1, "frame 9", "frame 20", code="extraction-unsuitable")
    t.render("part10", "part0").expect(1, "'part10'", "'part0'", code="extraction-unsuitable")
    t.render("part0", "clip.mkv").expect(1, "'part0'", code="input-unsuitable")
    t.vvr("extract", "clip.mkv", "-o", "part10", "--start", "10f", "--grid", "9").expect(0)
    t.render("part0", "part10").expect(1, "grid", "'14'", "'9'", code="extraction-unsuitable")


def test_part_gives_the_picture_that_the_clip_gives(t):
    moving_clip(t, frames=60)
    for span in (("--start", "17f"), ("--start", "1.5s", "--end", "2.05s")):
        t.vvr("extract", "clip.mkv", "-o", "data", *span).expect(0)
        for options in ((), span):
            t.render("data", "--backend", "software", *options, output="data.png").expect(0)
            t.render("clip.mkv", "--backend", "software", *span, output="clip.png").expect(0)
            same(t, "clip.png", "data.png")


def test_extract_takes_pictures_at_full_size(t):
    t.path("frames").mkdir()
    t.clip("frames/%03d.png", seconds=0.5, size="500x40", codec=())
    t.vvr("extract", "frames", "-o", "data", "--field-size", "source").expect(0, "5 frames of 500x40")
    check(t.path("data/flow/000002.flo").read_bytes()[4:12] == struct.pack("<ii", 500, 40), "not the full size")


def test_extract_replaces_only_its_own(t):
    moving_clip(t)
    t.path("mine").mkdir()
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
        told = manifest(t, "bad")
        edit(told)
        t.write("bad/manifest.json", json.dumps(told))
        t.render("bad", "--show", "volume,arrows").expect(status, f"'bad/{file}'", *facts, code=code)

    change(2, "file-invalid", lambda m: m["frames"][3].update(pts=float("nan")), "JSON")
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
    t.run(["ffmpeg", "-v", "error", "-i", "own.png", "-f", "rawvideo", "own.raw"])
    t.run(["ffmpeg", "-v", "error", "-i", "listed.png", "-f", "rawvideo", "listed.raw"])
    same(t, "own.raw", "listed.raw")
    t.path("one").mkdir()
    t.write("one/000007.txt", "vvr-seeds 1\nframe 7\nsize 96 64\npoints 1\n40 30 2 0 1\n")
    t.render("clip.mkv", "--seeds", "one", "--show", "volume", "--verbose").expect(0, " 1 arrows")
    t.write("one/000007.txt", "vvr-seeds 1\nframe 7\nsize 90 64\npoints 0\n")
    t.render("clip.mkv", "--seeds", "one").expect(2, "90x64", "96x64", code="file-invalid")
    t.render("clip.mkv", "--seeds", "none").expect(2, "--seeds", "'none'", code="file-not-found")
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
