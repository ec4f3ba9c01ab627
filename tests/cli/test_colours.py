"""Several fields in one picture: opacity from one, colour from another."""

import colorsys

import pytest
from harness import check, moving_clip

# Time runs from left to right over the whole width.
STRAIGHT = ("--backend", "software", "--layout", "box", "--camera", "0,40", "--fov", "0", "--size", "400x120",
            "--show", "volume", "--reference", "empty.png")


def square(t, x):
    """Makes clip.mkv: a square with a texture that is at `x`, over an empty scene, and a picture of that."""
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=128x64:rate=10:duration=4", "-f", "lavfi", "-i",
             "testsrc2=size=24x24:rate=10:duration=4", "-filter_complex",
             f"[1]loop=-1:1[still];[0][still]overlay=x='{x}':y=20:shortest=1", "-c:v", "ffv1", "clip.mkv")
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=128x64", "-frames:v", "1", "empty.png")


def hue(t, low, high, name="out.png"):
    """The median hue in degrees, red is 0, of what has a colour in some of the columns, from 0 to 1."""
    rows = t.rgb(name)
    width = len(rows[0])
    pixels = [pixel for row in rows for pixel in row[int(low * width):int(high * width)] if max(pixel) - min(pixel) > 60]
    check(len(pixels) > 40, f"{len(pixels)} coloured pixels from {low} to {high}")
    hues = sorted((colorsys.rgb_to_hsv(*(level / 255 for level in pixel))[0] * 360 + 60) % 360 for pixel in pixels)
    return hues[len(hues) // 2] - 60


@pytest.mark.nightly
def test_the_direction_of_motion(t):
    square(t, "if(lt(n,20),5+3*n,62-3*(n-20))")
    t.render("clip.mkv", *STRAIGHT, "--color", "direction").expect(0)
    right = hue(t, 0.1, 0.4)
    left = hue(t, 0.6, 0.9)
    check(-30 < right < 40, f"to the right is red, not of hue {right}")
    check(160 < left < 220, f"to the left is the hue on the other side, not {left}")


def test_the_speed_of_motion(t):
    square(t, "if(lt(n,20),5+0.7*n,19+4*(n-20))")
    t.render("clip.mkv", *STRAIGHT, "--color", "speed").expect(0)
    slow, fast = hue(t, 0.1, 0.4), hue(t, 0.6, 0.9)
    check(slow > fast + 8 and 20 < slow < 60, f"slow is yellow, fast is red: hues {slow} and {fast}")


def test_the_time(t):
    square(t, "20")
    t.render("clip.mkv", *STRAIGHT, "--color", "time").expect(0)
    begin, end = hue(t, 0, 0.2), hue(t, 0.8, 1)
    check(200 < begin < 280 and 10 < end < 60, f"from blue to orange: hues {begin} and {end}")
    t.render("clip.mkv", *STRAIGHT, "--color", "time", "--brick", "10f", "--window", "2", output="w.{brick}.png").expect(0)
    check(abs(hue(t, 0, 0.3, "w.3.png") - begin) < 40, "in a window time begins where the window does")


def test_a_second_filter(t):
    # Black at first, then white: both differ alike from the empty scene.
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=128x64:rate=10:duration=4", "-vf",
             "drawbox=x=30:y=20:w=40:h=24:t=fill:c=black:enable='lt(n,20)',"
             "drawbox=x=30:y=20:w=40:h=24:t=fill:c=white:enable='gte(n,20)'", "-c:v", "ffv1", "clip.mkv")
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=128x64:rate=10:duration=1", "-frames:v", "1", "empty.png")
    t.write("ramp.tf", "0 0 0 1 1\n1 0 0 1 1\n255 1 0 0 1\n")
    t.render("clip.mkv", *STRAIGHT, "--color", "luminance").expect(0)
    check(hue(t, 0.1, 0.45) > 200, "black is violet")
    check(hue(t, 0.55, 0.9) < 90, "white is yellow")
    white = sum(min(pixel) > 250 for row in t.rgb("out.png") for pixel in row)
    check(white > 0.5 * 400 * 120, "where nothing differs from the empty scene something is shown")
    # Both fields have a name: the sign of the difference, as colour of the silhouette.
    t.render("clip.mkv", *STRAIGHT, "--filter", "hull", "--color", "signed").expect(0)
    check(190 < hue(t, 0.1, 0.45) < 260, "darker is blue")
    check(hue(t, 0.55, 0.9) < 40, "brighter is red")
    # The transfer function's colours are those of the second field, its opacity that of the first.
    t.write("ends.tf", "0 0 1 0 0\n60 0 1 0 1\n200 1 0 1 1\n255 1 0 1 1\n")
    t.render("clip.mkv", *STRAIGHT, "--color", "luminance", "--transfer", "ends.tf").expect(0)
    check(100 < hue(t, 0.1, 0.45) < 140, "black is green, as the file says")
    check(280 < hue(t, 0.55, 0.9) % 360 < 320, "white is magenta, as the file says")


def test_colours_that_cannot_be(t):
    moving_clip(t)
    t.vvr("extract", "clip.mkv", "-o", "data").expect(0)
    t.render("clip.mkv", "--color", "directoin").expect(1, "--color", "'directoin'", "'direction'", code="choice-unknown")
    for colour in ("direction", "speed", "flow"):
        t.render("clip.mkv", "--color", colour, "--flow", "none").expect(1, f"{colour}", "none", code="options-conflict")
    t.render("data", "--color", "edges").expect(1, "edges", "'data'", code="extraction-unsuitable")
    t.vvr("extract", "clip.mkv", "-o", "thin", "--flow-every", "2").expect(0)
    t.render("thin", "--color", "direction").expect(1, "'thin'", "--flow-every", code="extraction-unsuitable")
    t.render("clip.mkv", "--color", "object", "--filter", "edges").expect(
        1, "--color object", "'edges'", "--filter", code="options-conflict")
    check(not t.path("out.png").exists(), "a picture was written")


def test_flow_as_a_filter_needs_no_arrows(t):
    moving_clip(t)
    t.render("clip.mkv", "--filter", "flow", "--show", "volume").expect(0)
    coloured = sum(max(pixel) - min(pixel) > 20 for row in t.rgb("out.png") for pixel in row)
    check(coloured > 50, "nothing is shown where no arrows are")
