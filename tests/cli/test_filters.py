"""Filters in the picture: bands without shells between them, the hull, the sign of a difference, norms."""

import pytest
from harness import check, moving_clip

# Time runs from left to right over the whole width.
STRAIGHT = ("--backend", "software", "--layout", "box", "--camera", "0,40", "--fov", "0", "--size", "400x120", "--show", "volume")
BANDS = {"uncovered": 85, "still": 170, "newly": 255}


def columns(t):
    """The columns in which something red is, from 0 to 1."""
    return t.columns("out.png", lambda red, green, blue: red > green + 40)


@pytest.mark.nightly
def test_no_shells_between_bands(t):
    # A square that is there from frame 30 of 60 on.
    t.ffmpeg("-f", "lavfi", "-i", "color=0x404040:size=96x64:rate=10:duration=6", "-vf",
             "drawbox=x=30:y=20:w=30:h=24:t=fill:c=white:enable='gte(n,30)'", "-c:v", "ffv1", "lamp.mkv")
    t.ffmpeg("-i", "lamp.mkv", "-frames:v", "1", "empty.png")
    shown = {}
    for band, value in BANDS.items():
        # This value alone, in red.
        points = [(0, 0), (value - 1, 0), (value, 1)] + ([(value + 1, 0)] if value < 255 else [])
        t.write("band.tf", "".join(f"{at} 1 0 0 {opacity}\n" for at, opacity in points))
        t.render("lamp.mkv", "--reference", "empty.png", "--filter", "bands", *STRAIGHT, "--transfer",
                 "band.tf").expect(0)
        shown[band] = columns(t)
    check(shown["uncovered"] == [], "what is never uncovered shows as such: a shell between two other bands")
    check(shown["newly"] and 0.47 < shown["newly"][0] and shown["newly"][-1] < 0.54, f"covered anew: {shown['newly']}")
    check(0.49 < shown["still"][0] < 0.55 and shown["still"][-1] > 0.94, f"still covered: {shown['still'][:1]}")


def test_no_seeds_on_uncovered_background(t):
    t.vvr("extract", moving_clip(t, step=3), "-o", "data", "--filter", "bands", "--grid", "2", "--min-magnitude", "0").expect(0)
    checked = 0
    for frame in (15, 20, 25):
        scalar = t.rgb(f"data/scalar/{frame:06}.png")
        values = {value for row in scalar for value, _, _ in row}
        check(values == {0, 85, 170, 255}, f"frame {frame} has the values {values}")
        for line in t.path(f"data/seeds/{frame:06}.txt").read_text().splitlines()[5:]:
            x, y = (int(float(word)) for word in line.split()[:2])
            check(scalar[y][x][0] in (170, 255), f"frame {frame}: a seed at {x}, {y}, where the value is {scalar[y][x][0]}")
            checked += 1
    check(checked > 50, f"only {checked} seeds")


@pytest.mark.nightly
def test_norms(t):
    # A green square as bright as the grey around it, then a white one.
    t.ffmpeg("-f", "lavfi", "-i", "color=0x787878:size=96x64:rate=10:duration=4", "-vf",
             "format=gbrp,drawbox=x=10:y=20:w=30:h=24:t=fill:c=0x409060:enable='between(n,5,14)',"
             "drawbox=x=50:y=20:w=30:h=24:t=fill:c=white:enable='between(n,25,34)'", "-c:v", "ffv1", "-pix_fmt", "gbrp", "colours.mkv")
    t.write("red.tf", "0 1 0 0 0\n8 1 0 0 1\n255 1 0 0 1\n")
    shown = {}
    for norm in ("channel", "luminance", "hue"):
        t.render("colours.mkv", *STRAIGHT, "--norm", norm, "--shadows", "keep", "--transfer", "red.tf").expect(0)
        found = columns(t)
        shown[norm] = (any(x < 0.45 for x in found), any(x > 0.55 for x in found))
    check(shown == {"channel": (True, True), "luminance": (False, True), "hue": (True, False)},
          f"the green and the white square: {shown}")
    t.render("colours.mkv", "--norm", "colour").expect(1, "--norm", "'colour'", "channel, luminance, hue", code="choice-unknown")


def test_cast_shadows_can_be_kept(t):
    t.ffmpeg("-f", "lavfi", "-i", "color=0xa08060:size=96x64:rate=10:duration=4", "-vf",
             "drawbox=x=10:y=20:w=30:h=24:t=fill:c=0x705a43:enable='between(n,10,29)'", "-c:v", "ffv1", "shadow.mkv")
    t.write("red.tf", "0 1 0 0 0\n8 1 0 0 1\n255 1 0 0 1\n")
    for how, is_shown in (("remove", False), ("keep", True)):
        t.render("shadow.mkv", *STRAIGHT, "--shadows", how, "--transfer", "red.tf").expect(0)
        check((columns(t) != []) == is_shown, f"--shadows {how}: shadows in {columns(t)}")
