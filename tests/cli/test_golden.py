"""The golden pictures of tests/golden: each is what is drawn now, and none could pass for another.

`VVR_BLESS=1 scripts/test golden_picture` draws them anew; look at them before you commit them.

The tolerance is the default one. It is there for other versions of Mesa, whose edges and rounding differ by a few
levels at single pixels: docs/golden-images.md has the measurements. The same Mesa gives the same bytes.
"""

import itertools
import os

import pytest
from harness import check, nightly_except

# Large enough for portraits, map and strip.
GLANCE = ("--size", "640x480", "--title", "Hall")
EVERYTHING = ("--size", "480x300", "--title", "Hall", "--start-time", "2026-11-21 08:00:00")
PICTURES = {
    "volume-arrows": ("--show", "volume,arrows"),
    "tracelines": ("--show", "tracelines"),
    "boxes-slices": ("--show", "volume,boxes,slices"),
    "floor": ("--show", "floor,outline"),
    "glance": GLANCE,
    "glance-dark": (*GLANCE, "--theme", "dark"),
    "light": EVERYTHING,
    "print": (*EVERYTHING, "--theme", "print"),
    "transparent": ("--show", "volume,outline", "--background", "none"),
    "keyframes": ("--show", "volume,frames,outline", "--keyframes", "2"),
    "relief": ("--show", "volume,outline", "--transfer", "solid", "--shading", "relief"),
    "bands": ("--size", "480x300", "--show", "volume,outline,legend", "--filter", "bands"),
    "hull": ("--show", "volume,outline", "--filter", "hull", "--transfer", "solid", "--shading", "relief", "--layout", "box"),
    "signed": ("--size", "480x300", "--show", "volume,outline,legend", "--filter", "signed"),
    "direction": ("--size", "480x300", "--show", "volume,outline,legend", "--color", "direction"),
    "speed": ("--size", "480x300", "--show", "volume,outline,legend", "--color", "speed"),
    "time": ("--size", "480x300", "--show", "volume,outline,legend", "--color", "time"),
    "second": ("--size", "480x300", "--show", "volume,outline,legend", "--filter", "hull", "--color", "temporal"),
    "paper": ("--preset", "paper", "--glyph-scale", "2"),
    "video": ("--show", "volume,outline", "--color", "video"),
}


@pytest.mark.parametrize("name", PICTURES)
def test_golden_picture(t, name):
    # In 8 s the bag lies too short to be an event.
    frames = "400" if name.startswith("glance") else "200"
    t.scene("left_bag", "bag.y4m", "--size", "192x144", "--frames", frames)
    bless = ["--bless"] if os.environ.get("VVR_BLESS") else []
    picture = t.source / "tests" / "golden" / f"{name}.png"
    drawn = t.vvr("render", "bag.y4m", "--size", "320x200", "--backend", "software", *PICTURES[name], "--golden", picture,
                  *bless, env=os.environ | {"VVR_GL_DEBUG": "1"}).expect(0)
    check("OpenGL" not in drawn.err, f"the driver complains: {drawn}")
    most = 160_000 if name.startswith("glance") else 80_000  # stills take room
    check(picture.stat().st_size <= most, f"{picture} is large for a golden picture")


@pytest.mark.parametrize("name", nightly_except(("volume-arrows", "boxes-slices", "relief", "glance"), "volume-arrows"))
def test_another_rasteriser_draws_it_alike(t, name):
    # Softpipe is Mesa's plain interpreter: it shares no code with llvmpipe that fills triangles or runs shaders. It has
    # no antialiasing.
    frames = "400" if name.startswith("glance") else "200"
    t.scene("left_bag", "bag.y4m", "--size", "192x144", "--frames", frames)
    for driver in ("llvmpipe", "softpipe"):
        drawn = t.vvr("render", "bag.y4m", "--size", "320x200", "--backend", "software", "--samples", "1", *PICTURES[name],
                      "-o", f"{driver}.png", "--verbose", env=os.environ | {"GALLIUM_DRIVER": driver}).expect(0)
        check(f"backend software: {driver}" in drawn.err, f"{drawn}")
    # Without antialiasing the rasterisers may take pixels on either side of an edge: docs/golden-images.md.
    t.vvr("compare", "llvmpipe.png", "softpipe.png", "--tolerance", "1.7", "--quiet").expect(0, out=None)


@pytest.mark.slow
def test_golden_pictures_differ_from_each_other(t):
    folder = t.source / "tests" / "golden"
    check({path.stem for path in folder.glob("*.png")} == set(PICTURES), f"pictures in {folder} that no test draws")
    for one, other in itertools.combinations(PICTURES, 2):
        t.vvr("compare", folder / f"{one}.png", folder / f"{other}.png", "--quiet").expect(7, code="picture-differs", out=None)
