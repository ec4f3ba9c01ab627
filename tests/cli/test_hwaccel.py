"""Decoding in hardware: what happens without the hardware. Nothing here needs a graphics card."""

import pytest
from harness import check, nightly_except
from test_archive import archive, sidecars

KINDS = ("vaapi", "cuda")


@pytest.fixture(params=nightly_except(KINDS, "vaapi"))
def absent(request, t):
    """A kind of hardware that this machine lacks."""
    found = {row["name"]: row for row in t.vvr("doctor", "--json").expect(0, out=None).json()["hwaccel"]}
    if found[request.param]["works"]:
        pytest.skip(f"this machine has {request.param}")
    return request.param


def test_hardware_that_is_not_there(t, absent):
    t.clip()
    t.render("clip.avi", "--hwaccel", absent).expect(
        4, f"--hwaccel {absent}", "FFmpeg", "processor", code="hwaccel-unavailable")
    t.vvr("watch", "clip.avi", "-o", "live.png", "--hwaccel", absent).expect(4, absent, code="hwaccel-unavailable")
    t.write("vvr.toml", f'hwaccel = "{absent}"\n')
    t.vvr("info", "clip.avi", "--config", "vvr.toml").expect(4, absent, code="hwaccel-unavailable")
    t.expect_files("clip.avi", "vvr.toml")


def test_other_names_of_hardware(t):
    t.clip()
    t.render("clip.avi", "--hwaccel", "vappi").expect(1, "'vappi'", "none", *KINDS, code="choice-unknown")


def test_codec_without_hardware_is_drawn_as_without_the_option(t):
    t.clip("clip.mkv", codec=("-c:v", "ffv1"))
    t.render("clip.mkv", "--quiet", "--report", "plain.json").expect(0, err="")
    plain = t.path("out.png").read_bytes()
    t.render("clip.mkv", "--hwaccel", "vaapi", "--report", "asked.json").expect(0, "vaapi", "ffv1")
    check(t.path("out.png").read_bytes() == plain, "another picture")
    frames = [t.json(name)["frames"]["hwaccel"] for name in ("plain.json", "asked.json")]
    problems = [t.json(name)["problems"] for name in ("plain.json", "asked.json")]
    check(frames == ["none", "none"] and problems[0] == [] and len(problems[1]) == 1, f"{frames} {problems}")


def test_archive_without_hardware_blames_no_clip(t, absent):
    t.old_clips("a.avi", "b.avi")
    archive(t, "--hwaccel", absent).expect(4, f"hwaccel {absent}", code="hwaccel-unavailable")
    check(all(known["tries"] == 0 for known in sidecars(t).values()), "the clips are blamed")
    archive(t).expect(0, "2 clips drawn")
    archive(t, "--hwaccel", absent).expect(0, "2 done before")


def test_doctor_tells_of_hardware(t, absent):
    line = next(line for line in t.vvr("doctor").expect(0, out=None).out.splitlines() if line.startswith("hwaccel "))
    check(f"{absent}: not found" in line, line)
    row = next(row for row in t.vvr("doctor", "--json").expect(0, out=None).json()["hwaccel"] if row["name"] == absent)
    check(not row["works"] and absent in row["reason"], f"{row}")
    t.vvr("doctor", "--hwaccel", absent).expect(4, absent, code="hwaccel-unavailable", out=None)
