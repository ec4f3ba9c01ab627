"""The golden pictures of tests/golden: each is what is drawn now, and none could pass for another.

`VVR_BLESS=1 ctest --test-dir build/release -R cli.golden_picture` draws them anew; look at them before you commit them.

The tolerance is the standard one. It is there for other versions of Mesa, whose edges and rounding differ by a few
levels at single pixels: docs/golden-images.md has the measurements. The same Mesa gives the same bytes.
"""

import itertools
import os

from harness import case, check

SETS = {
    "volume": "volume",
    "arrows": "arrows",
    "volume-arrows": "volume,arrows",
    "tracelines": "tracelines",
    "boxes-slices": "volume,boxes,slices",
}


def meet(t, name):
    t.scene("left_bag", "bag.y4m", "--size", "192x144", "--frames", "200")
    bless = ["--bless"] if os.environ.get("VVR_BLESS") else []
    picture = t.source / "tests" / "golden" / f"{name}.png"
    t.vvr("render", "bag.y4m", "--size", "320x200", "--backend", "software", "--show", SETS[name], "--golden", picture,
          *bless).expect(0)
    check(picture.stat().st_size <= 30_000, f"{picture} is large for a golden picture")


@case
def golden_picture_volume(t):
    meet(t, "volume")


@case
def golden_picture_arrows(t):
    meet(t, "arrows")


@case
def golden_picture_volume_arrows(t):
    meet(t, "volume-arrows")


@case
def golden_picture_tracelines(t):
    meet(t, "tracelines")


@case
def golden_picture_boxes_slices(t):
    meet(t, "boxes-slices")


@case
def golden_pictures_differ_from_each_other(t):
    folder = t.source / "tests" / "golden"
    check({path.stem for path in folder.glob("*.png")} == set(SETS), f"pictures in {folder} that no test draws")
    for one, other in itertools.combinations(SETS, 2):
        t.vvr("compare", folder / f"{one}.png", folder / f"{other}.png", "--quiet").expect(7, out=None)
