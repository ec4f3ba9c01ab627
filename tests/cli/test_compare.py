"""vvr compare, and render --golden: what is the same, what is not, and what is left behind."""

import struct
import zlib

import pytest
from harness import check


def png(t, name, size=(40, 20), value=128, spots=(), alpha=False):
    """An even grey picture but for `spots`: x, y and value."""
    width, height = size
    channels = 4 if alpha else 3
    rows = [bytearray([value] * 3 + [255] * alpha) * width for _ in range(height)]
    for x, y, spot in spots:
        rows[y][x * channels:x * channels + 3] = [spot] * 3

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 6 if alpha else 2, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + bytes(row) for row in rows))
    return t.write(name, b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b""))


def test_compare_allows_rounding_and_single_pixels(t):
    png(t, "a.png", (100, 50))
    png(t, "b.png", (100, 50), 130, [(50, 25, 255), (3, 3, 0)])
    t.vvr("compare", "a.png", "b.png").expect(0, out=None)
    t.vvr("compare", "a.png", "b.png", "--tolerance", "0").expect(7, "0 %", code="picture-differs", out=None)
    t.vvr("compare", "a.png", "b.png", "--tolerance", "0.25").expect(7, "100 %", "0.005", code="picture-differs", out=None)


def test_compare_tells_where_they_differ(t):
    png(t, "a.png", (120, 80))
    png(t, "b.png", (120, 80), 128, [(x, y, 28) for x in range(60, 66) for y in range(40, 46)])
    told = t.vvr("compare", "a.png", "b.png").expect(
        7, "60,40: A 0.5020 0.5020 0.5020 and B 0.1098 0.1098 0.1098", "0.3922", "'a.png'", "'b.png'", "8x8", "0.221", "0.03",
        code="picture-differs", out=None)
    check(told.err.count("vvr: at ") == 10, "not the ten worst pixels")
    rows = [line for line in told.err.splitlines() if line.startswith("vvr: |")]
    check(len(rows) == 20 and all(len(row) == len("vvr: ||") + 60 for row in rows), str(told))
    marked = {(row, column) for row, line in enumerate(rows) for column, mark in enumerate(line[6:66]) if mark != " "}
    check(marked == {(row, column) for row in (10, 11) for column in (30, 31, 32)}, f"{marked}")
    check("max    0.392157\n" in told.out and "off    36 of 9600 pixels, 0.3750 %\n" in told.out, str(told))
    quiet = t.vvr("compare", "a.png", "b.png", "--quiet").expect(7, code="picture-differs", out=None)
    check(quiet.err.count("\n") == 1, str(quiet))


def test_compare_leaves_out_layers(t):
    t.clip()
    t.vvr("render", "clip.avi", "--size", "160x100", "-o", "layers.exr").expect(0)
    t.vvr("compare", "layers.exr", "layers.exr").expect(0, out=None)
    t.vvr("render", "clip.avi", "--size", "160x100", "--golden", "layers.exr").expect(0, "matches")


def test_compare_as_json(t):
    png(t, "a.png")
    png(t, "b.png", (40, 20), 128, [(7, 9, 255)])
    told = t.vvr("compare", "a.png", "b.png", "--json").expect(0, out=None).json()
    check((told["a"], told["b"], told["same"], told["verdict"], told["reason"]) == ("a.png", "b.png", True, "same", ""), str(told))
    check(abs(told["mean"] - 127 / 255 / 800) < 1e-6 and told["pixels_off"] == 1 and told["percent_off"] == 0.125, str(told))
    worst = told["worst"]
    check(len(worst) == 1 and (worst[0]["x"], worst[0]["y"], worst[0]["b"]) == (7, 9, [1, 1, 1]), str(worst))
    png(t, "wide.png", (41, 20))
    told = t.vvr("compare", "a.png", "wide.png", "--json").expect(7, code="picture-differs", out=None).json()
    check((told["same"], told["verdict"], told["mean"], told["worst"]) == (False, "size", None, []), str(told))


def test_compare_refuses(t):
    png(t, "a.png")
    t.write("text.png", "no picture")
    t.vvr("compare", "a.png").expect(1, "1", "vvr compare A B", code="input-unsuitable")
    t.vvr("compare", "a.png", "a.png", "a.png").expect(1, "3", "vvr compare A B", code="input-unsuitable")
    t.vvr("compare", "a.png", "none.png").expect(2, "'none.png'", "No such file or directory", code="file-not-found")
    t.vvr("compare", "text.png", "a.png").expect(2, "'text.png'", "PNG, JPEG, TIFF or OpenEXR", code="file-invalid")
    t.vvr("compare", "a.png", "a.png", "--tolerance", "200").expect(1, "--tolerance", "'200'", "0 to 100", code="option-value-out-of-range")
    t.vvr("compare", "a.png", "a.png", "--diff", "d.pgn").expect(1, "'.pgn'", "'.png'", code="output-format-unknown")
    t.vvr("compare", "a.png", "a.png", "--diff", "none/d.png").expect(2, "'none/d.png'", "mkdir -p 'none'", code="file-not-found")
    t.expect_files("a.png", "text.png")


def golden(t, *arguments, output=()):
    return t.vvr("render", "clip.avi", *output, "--size", "160x100", "--backend", "software", "--golden", "golden.png",
                 *arguments)


def test_golden_that_is_missing_then_blessed_then_met(t):
    t.clip()
    golden(t).expect(7, "'golden.png'", "'golden.candidate.png'", "--bless", code="reference-missing")
    t.expect_files("clip.avi", "golden.candidate.png")
    t.expect_picture("golden.candidate.png")
    golden(t, "--bless", "--diff", "d.png").expect(0, "'golden.png': replaced by the new picture")  # as a workflow has it
    t.expect_files("clip.avi", "golden.png")
    golden(t).expect(0, "'golden.png': matches; 0.0000 % of the pixels differ")
    golden(t, "--quiet").expect(0, err="")
    t.expect_files("clip.avi", "golden.png")


def test_golden_that_differs_keeps_the_candidate_until_it_is_met(t):
    t.clip()
    golden(t, "--bless").expect(0)
    before = t.path("golden.png").read_bytes()
    golden(t, "--camera", "10,46", "--diff", "diff.png").expect(
        7, "vvr: |", "'golden.png'", "'golden.candidate.png'", code="picture-differs")
    t.expect_files("clip.avi", "diff.png", "golden.candidate.png", "golden.png")
    check(t.path("golden.png").read_bytes() == before, "the golden picture was touched")
    golden(t).expect(0)
    t.expect_files("clip.avi", "diff.png", "golden.png")
    golden(t, "--camera", "10,46", "--bless").expect(0)
    golden(t, "--camera", "10,46", output=("-o", "out.png")).expect(0, "'out.png': 20 frames")
    check(t.path("out.png").read_bytes() == t.path("golden.png").read_bytes(), "blessed is not what is drawn")
    golden(t).expect(7, code="picture-differs")


@pytest.mark.nightly
def test_golden_of_another_size_or_renderer(t):
    t.clip()
    golden(t, "--bless").expect(0)
    golden(t, "--size", "161x100").expect(7, "'golden.png'", "160x100", "161x100", code="picture-differs")
    data = t.path("golden.png").read_bytes()
    name = data[data.index(b"vvr:renderer\0"):][13:30]
    at = data.index(b"vvr:renderer\0") + 13
    # Within the chunk only as many bytes, and its checksum made anew.
    begin = data.rindex(b"tEXt", 0, at)
    length = struct.unpack(">I", data[begin - 4:begin])[0]
    chunk = data[begin:begin + 4 + length].replace(name[:4], b"soft")
    t.write("golden.png", data[:begin] + chunk + struct.pack(">I", zlib.crc32(chunk)) + data[begin + 8 + length:])
    golden(t).expect(0)
    golden(t, "--camera", "10,46").expect(7, "'golden.png'", "soft", code="picture-differs")


@pytest.mark.nightly
def test_golden_that_cannot_be_read_or_kept(t):
    t.clip()
    t.write("golden.png", "no picture")
    # Found before anything is drawn, and before the clip is opened.
    t.vvr("render", "none.avi", "--golden", "golden.png").expect(2, "'golden.png'", code="file-invalid")
    golden(t).expect(2, "'golden.png'", code="file-invalid")
    t.vvr("render", "clip.avi", "--golden", "none/golden.png", "--bless").expect(
        2, "'none/golden.png'", "mkdir -p 'none'", code="file-not-found")
    # No one may make files there, not even root; what counts is that there is no golden picture.
    t.vvr("render", "clip.avi", "--golden", "/proc/golden.png").expect(7, "'/proc/golden.png'", "'/proc'", code="reference-missing")
    t.vvr("render", "clip.avi", "--golden", "golden.pgn").expect(1, "'.pgn'", "'.png'", code="output-format-unknown")
    t.expect_files("clip.avi", "golden.png")


def test_golden_options_that_do_not_fit(t):
    t.clip()
    t.render("clip.avi", "--bless").expect(1, "--bless", "--golden FILE", code="option-needs-another")
    t.render("clip.avi", "--diff", "d.png").expect(1, "--diff", "--golden FILE", code="option-needs-another")
    golden(t, "--animate", "3", output=("-o", "a.####.png")).expect(1, "--golden", "--animate", code="options-conflict")
    t.vvr("render", "clip.avi").expect(1, "-o FILE", code="output-missing")
    t.expect_files("clip.avi")


@pytest.mark.nightly
def test_golden_in_every_format(t):
    t.clip()
    for ending in ("png", "exr", "tif", "jpg"):
        arguments = ("--size", "160x100", "--backend", "software", "--golden", f"golden.{ending}")
        t.vvr("render", "clip.avi", *arguments, "--bless").expect(0)
        t.vvr("render", "clip.avi", *arguments).expect(0, "matches; 0.0000 %")
