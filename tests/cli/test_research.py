"""Scalar fields and flow of another program, seeds that must fit the flow, and the examples with numpy of docs/research.md."""

import importlib.util
import json
import os
import re
import shutil
import struct
import sys

import pytest
from harness import check, moving_clip

VOLUME = ("--backend", "software", "--show", "volume")
ARROWS = ("--backend", "software", "--show", "volume,arrows")


def data(t, *options, folder="data"):
    t.vvr("extract", moving_clip(t), "-o", folder, *options).expect(0)
    return folder


def same_files(t, one, other, count):
    names = sorted(path.name for path in t.path(one).iterdir())
    check(len(names) == count, f"{one}: {names}")
    for name in names:
        check((t.path(one) / name).read_bytes() == (t.path(other) / name).read_bytes(), f"{name} of {one} and of {other} differ")


def same_pixels(t, one, other):
    check(t.rgb(one) == t.rgb(other), f"{one} and {other} differ")


def settings(t, folder):
    return json.loads(t.path(f"{folder}/manifest.json").read_text())["settings"]


def scale_flow(t, folder, factor):
    """Multiplies all vectors of a folder of .flo files."""
    for path in t.path(folder).glob("*.flo"):
        content = path.read_bytes()
        vectors = struct.unpack(f"<{(len(content) - 12) // 4}f", content[12:])
        path.write_bytes(content[:12] + struct.pack(f"<{len(vectors)}f", *(factor * value for value in vectors)))


def points(t, file):
    """The seeds of a list: column, row, u, v."""
    lines = t.path(file).read_text().partition("# x y u v flag\n")[2].splitlines()
    return [tuple(float(word) for word in line.split()[:4]) for line in lines]


def test_fields_of_another_program_are_drawn_as_they_are(t):
    data(t)
    t.render("clip.mkv", *VOLUME, output="own.png").expect(0)
    t.render("clip.mkv", *VOLUME, "--field", "data/scalar", output="given.png").expect(0)
    same_pixels(t, "own.png", "given.png")
    t.vvr("extract", "clip.mkv", "-o", "given", "--field", "data/scalar").expect(0)
    same_files(t, "data/scalar", "given/scalar", 40)
    told = settings(t, "given")
    check((told["filter"], told["field"], told["threshold"]) == ("given", "scalar", "0"), f"{told}")
    t.render("given", *ARROWS, output="extracted.png").expect(0)
    t.render("clip.mkv", *ARROWS, "--field", "data/scalar", output="clip.png").expect(0)
    check(t.path("extracted.png").read_bytes() == t.path("clip.png").read_bytes(), "the extraction gives another picture")
    # Small blobs stay; a threshold, if given, counts.
    t.vvr("extract", "clip.mkv", "-o", "strict", "--field", "data/scalar", "--threshold", "255", "--min-area", "4000").expect(0)
    check(t.rgb("strict/scalar/000020.png") == [[tuple(255 * (value == 255) for value in pixel) for pixel in row]
                                                for row in t.rgb("data/scalar/000020.png")], "not the values of 255")


@pytest.mark.parametrize("ending, pixels", [pytest.param("png", "gray16be", marks=pytest.mark.nightly), ("exr", "grayf32le"),
                                            pytest.param("tif", "gray16le", marks=pytest.mark.nightly)])
def test_deeper_pictures_are_rounded(t, ending, pixels):
    data(t)
    t.path("deep").mkdir()
    t.ffmpeg("-i", "data/scalar/%06d.png", "-pix_fmt", pixels, "-start_number", "0", f"deep/heat_%d.{ending}")
    t.write("deep/notes.txt", "made by a program of mine")
    t.vvr("extract", "clip.mkv", "-o", "given", "--field", "deep").expect(0)
    same_files(t, "data/scalar", "given/scalar", 40)


@pytest.mark.nightly
def test_fields_have_the_numbers_of_the_clips_frames(t):
    data(t)
    t.vvr("extract", "clip.mkv", "-o", "part", "--start", "10f", "--end", "20f").expect(0)
    t.render("clip.mkv", *VOLUME, "--field", "part/scalar", "--start", "10f", "--end", "20f", output="part.png").expect(0)
    t.render("clip.mkv", *VOLUME, "--field", "data/scalar", "--start", "10f", "--end", "20f", output="whole.png").expect(0)
    same_pixels(t, "part.png", "whole.png")
    t.render("clip.mkv", "--field", "part/scalar").expect(2, "of frame", "10", "'000010.png'", "'000019.png'", code="file-not-found")
    t.write("data/scalar/000040.png", t.path("data/scalar/000039.png").read_bytes())
    t.render("clip.mkv", "--field", "data/scalar", "--end", "30f").expect(0)
    t.render("clip.mkv", "--field", "data/scalar", output="none.png").expect(
        2, "--field", "000040.png'", "frame 40", "frame 39", code="file-invalid")
    check(not t.path("none.png").exists(), "a picture was written")


@pytest.mark.nightly
def test_wrong_fields_are_refused(t):
    data(t)
    good = t.path("data/scalar/000017.png").read_bytes()
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=96x64", "-frames:v", "1", "-pix_fmt", "rgb24", "colours.png")
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=40x30", "-frames:v", "1", "-pix_fmt", "gray", "small.png")
    t.ffmpeg("-f", "lavfi", "-i", "color=white:size=96x64,format=grayf32le", "-frames:v", "1", "ones.exr")
    wrong = struct.pack("<f", 3), struct.pack("<f", float("nan"))
    exr = t.path("ones.exr").read_bytes()
    bright, unknown = (exr[:-4] + value for value in wrong)
    for content, ending, facts in [
        (t.path("colours.png").read_bytes(), "png", ("3 channels", "grey")),
        (t.path("small.png").read_bytes(), "png", ("field-size 40x30", "96x64", "--field-size")),
        (good[:60], "png", ()),
        (b"", "png", ("empty",)),
        (b"no picture", "png", ("PNG",)),
        (bright, "exr", ("column 95, row 63", "3", "0 to 1")),
        (unknown, "exr", ("column 95, row 63", "nan", "0 to 1")),
    ]:
        t.path("data/scalar/000017.png").unlink(missing_ok=True)
        t.write(f"data/scalar/000017.{ending}", content)
        t.render("clip.mkv", "--field", "data/scalar").expect(2, f"data/scalar/000017.{ending}'", *facts, code="file-invalid")
        t.path(f"data/scalar/000017.{ending}").unlink()
    t.render("clip.mkv", "--field", "data/scalar").expect(2, "--field", "frame 17", code="file-not-found")
    t.write("data/scalar/000017.png", good)
    t.write("data/scalar/17.exr", exr)
    t.render("clip.mkv", "--field", "data/scalar").expect(2, "17.exr'", "000017.png'", code="file-invalid")
    t.path("data/scalar/17.exr").rename(t.path("data/scalar/heat.exr"))
    t.render("clip.mkv", "--field", "data/scalar").expect(1, "heat.exr'", code="input-unsuitable")


def test_folders_that_are_none(t):
    moving_clip(t)
    t.path("empty").mkdir()
    for option in ("--field", "--flow"):
        t.render("clip.mkv", option, "./nowhere").expect(2, "'./nowhere'", code="file-not-found")
        t.render("clip.mkv", option, "clip.mkv").expect(2, "'clip.mkv'", code="not-a-folder")
        t.render("clip.mkv", option, "empty").expect(2, option, "'empty'", "000000", code="file-not-found")
    t.render("clip.mkv", "--flow", "nowhere").expect(1, "--flow", "'nowhere'", "dis", "folder", code="choice-unknown")
    t.render("clip.mkv", "--field", "empty", "--filter", "hull").expect(1, "--field", "--filter", "hull", code="options-conflict")
    t.render("clip.mkv", "--filter", "given").expect(1, "--field", code="option-needs-another")
    t.vvr("watch", "clip.mkv", "-o", "out.png", "--flow", "./empty").expect(1, "--flow", code="options-conflict")
    t.vvr("watch", "clip.mkv", "-o", "out.png", "--field", "empty").expect(1, "--field", code="option-unknown")


@pytest.mark.nightly
def test_flow_of_another_program(t):
    data(t)
    t.vvr("extract", "clip.mkv", "-o", "again", "--flow", "data/flow").expect(0)
    same_files(t, "data/flow", "again/flow", 40)
    same_files(t, "data/seeds", "again/seeds", 40)
    check(settings(t, "again")["flow"] == "flow", f"{settings(t, 'again')}")
    t.render("clip.mkv", *ARROWS, "--flow", "data/flow", output="given.png").expect(0)
    t.render("clip.mkv", *ARROWS, output="own.png").expect(0)
    same_pixels(t, "given.png", "own.png")
    shutil.copytree(t.path("data/flow"), t.path("double"))
    scale_flow(t, "double", 2)
    t.vvr("extract", "clip.mkv", "-o", "fast", "--flow", "double", "--min-magnitude", "0.6").expect(0)
    slow = points(t, "data/seeds/000020.txt")
    fast = points(t, "fast/seeds/000020.txt")
    check(slow and [seed[:2] for seed in fast] == [seed[:2] for seed in slow], f"{slow} {fast}")
    check(all(abs(a - 2 * b) < 1e-4 for one, other in zip(fast, slow) for a, b in zip(one[2:], other[2:])), f"{slow} {fast}")
    # Between 40 frames there are 39 flows.
    t.path("double/000000.flo").unlink()
    t.path("double/000039.flo").unlink()
    t.vvr("extract", "clip.mkv", "-o", "fast", "--flow", "double").expect(0)
    check(not any(t.path("fast/flow/000000.flo").read_bytes()[12:]), "the first frame has a flow")


@pytest.mark.nightly
def test_wrong_flow_is_refused(t):
    data(t)
    path = t.path("data/flow/000017.flo")
    good = path.read_bytes()
    render = ("clip.mkv", *ARROWS, "--flow", "data/flow")
    for content, facts in [(good[:-1], ("49163", "49164")), (b"", ("0 bytes",)), (b"HEIP" + good[4:], ("PIEH",)),
                           (struct.pack("<fii", 202021.25, 2, 1) + bytes(16), ("2x1", "96x64", "field-size 2x1", "--field-size"))]:
        path.write_bytes(content)
        t.render(*render).expect(2, "data/flow/000017.flo", *facts, code="file-invalid")
    path.write_bytes(good[:12] + struct.pack("<f", 2e9) * (96 * 64 * 2))
    t.vvr("extract", "clip.mkv", "-o", "unknown", "--flow", "data/flow").expect(0)
    check(points(t, "unknown/seeds/000017.txt") == [], "unknown vectors have seeds")
    path.unlink()
    t.render(*render).expect(2, "--flow", "'data/flow'", "frame 17", "39", code="file-not-found")
    path.write_bytes(good)
    t.write("data/flow/000041.flo", good)
    t.render(*render).expect(2, "--flow", "000041.flo'", "frame 41", "frame 39", code="file-invalid")


@pytest.mark.nightly
def test_seeds_of_another_flow_are_refused(t):
    data(t)
    shutil.copytree(t.path("data/seeds"), t.path("old"))
    t.render("data", *ARROWS, "--seeds", "old", output="before.png").expect(0)
    scale_flow(t, "data/flow", 3)
    t.render("data", *ARROWS, output="none.png").expect(1, "data/flow/", "vvr seeds data", code="extraction-unsuitable")
    check(not t.path("none.png").exists(), "a picture was written")
    t.render("data", *VOLUME).expect(0)
    warned = t.render("data", *ARROWS, "--seeds", "old", output="old.png").expect(0, "'old'", "'data'", "vvr seeds data")
    check("WARN" in warned.err.upper(), str(warned))
    same_pixels(t, "before.png", "old.png")
    t.vvr("seeds", "data", "-o", "new").expect(0)
    quiet = t.render("data", *ARROWS, "--seeds", "new", output="new.png").expect(0)
    check("vvr seeds" not in quiet.err, str(quiet))
    check(t.rgb("new.png") != t.rgb("old.png"), "the new flow has the arrows of the old one")


def test_the_paper_extracted_and_drawn(t):
    data(t, "--preset", "paper", folder="paper")
    t.render("paper", "--preset", "paper", output="extracted.png").expect(0)
    t.render("clip.mkv", "--preset", "paper", output="clip.png").expect(0)
    check(t.path("extracted.png").read_bytes() == t.path("clip.png").read_bytes(), "the extraction gives another picture")


@pytest.mark.nightly
def test_settings_are_the_values_that_were_used(t):
    data(t, "--flow", "horn-schunck", "--solver", "jacobi")
    told = settings(t, "data")
    check([told[name] for name in ("threshold", "alpha", "iterations")] == ["24", "10", "60"], f"{told}")
    t.render("clip.mkv", "--filter", "temporal", "--report", "report.json").expect(0)
    told = json.loads(t.path("report.json").read_text())["settings"]
    check([told[name] for name in ("threshold", "alpha", "iterations")] == ["16", "15", "1"], f"{told}")
    tags = t.run(["ffprobe", "-v", "error", "-show_entries", "frame_tags", "out.png"]).out
    check("vvr:threshold=16" in tags and "vvr:iterations=1" in tags, tags)
    # As one would type them: given again, they make the same picture.
    unlike = {"preset", "frames", "renderer", "font"}
    options = {option["name"] for option in t.help()["render"]["options"]} - unlike
    typed = [f"--{name}={value}" for name, value in told.items() if name in options]
    t.render("clip.mkv", *typed, output="again.png").expect(0)
    same_pixels(t, "out.png", "again.png")


# Instead of matplotlib.pyplot, whose calls the examples only need to succeed.
STUB = """
import sys
from unittest.mock import MagicMock
sys.modules[__name__] = MagicMock(subplots=lambda *_: (MagicMock(), (MagicMock(), MagicMock())))
"""


@pytest.mark.nightly
def test_examples_with_numpy(t):
    missing = [name for name in ("numpy", "OpenImageIO") if importlib.util.find_spec(name) is None]
    if missing:
        pytest.skip(f"there is no {' and no '.join(missing)}; scripts/install has them")
    page = (t.source / "docs" / "research.md").read_text()
    blocks = re.findall(r"<!-- test with numpy -->\n+```(sh|python)\n(.*?)```", page, flags=re.DOTALL)
    check(len(blocks) == page.count("<!-- test with numpy -->") > 8, f"{len(blocks)} blocks")
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=192x144:rate=10:duration=8", "-f", "lavfi", "-i",
             "testsrc2=size=30x40:rate=10:duration=8", "-filter_complex",
             "[0][1]overlay=x='if(between(t,2,6),10+30*(t-2),-100)':y=50:eval=frame", "-c:v", "ffv1", "-f", "matroska", "clip.avi")
    t.path("bin").mkdir()
    t.path("bin/vvr").symlink_to(t.vvr_path)
    paths = [os.environ.get("PYTHONPATH", "")]
    if importlib.util.find_spec("matplotlib") is None:
        t.path("stubs/matplotlib").mkdir(parents=True)
        t.write("stubs/matplotlib/__init__.py", "")
        t.write("stubs/matplotlib/pyplot.py", STUB)
        paths.insert(0, str(t.path("stubs")))
    environment = os.environ | {"PATH": f"{t.path('bin')}{os.pathsep}{os.environ['PATH']}", "MPLBACKEND": "agg",
                                "PYTHONPATH": os.pathsep.join(filter(None, paths))}
    told = ""
    for language, block in blocks:
        command = ["bash", "-euc", block] if language == "sh" else [sys.executable, "-W", "error", "-c", block]
        done = t.run(command, env=environment)
        check(done.status == 0, str(done))
        told += done.out
    check("threshold 24\n" in told and "000079.flo fastest: " in told, told)
    check(len(list(t.path("heat").iterdir())) == 80, "not a field a frame")
