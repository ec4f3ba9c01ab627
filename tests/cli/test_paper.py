"""The paper's settings and quantities, through the program and in the picture."""

import struct

import pytest
from harness import check, moving_clip

FRAMES = 24
SPEED = 1.5  # pixels per frame, to the right

# The whole picture moves, which is no shaking of the camera.
MOVES = ("--stabilize", "off")

# Looked at along time, from the clip's beginning: columns are those of the video. Nothing is shown but lines and arrows.
ALONG = ("--backend", "software", "--layout", "box", "--camera", "-90,0", "--fov", "0", "--size", "960x640")
# Time runs from left to right over the whole width.
ASIDE = ("--backend", "software", "--layout", "box", "--camera", "0,40", "--fov", "0", "--size", "960x240")


def texture(t):
    """A texture that moves to the right over the whole frame; its flow is known."""
    return t.scene("shifted_texture", "shift.y4m", "--size", "96x64", "--frames", str(FRAMES), "--velocity", f"{SPEED},0")


def one_seed(t, frame=8, x=20, y=32):
    t.write(f"one/{frame:06}.txt", f"vvr-seeds 1\nframe {frame}\nsize 96 64\npoints 1\n{x} {y} {SPEED} 0 1\n")
    return ("--seeds", "one", *MOVES)


def extent(t, name="out.png"):
    """The columns from the first to the last in which there is something."""
    rows = t.rgb(name)
    columns = {i for row in rows for i, (red, _, blue) in enumerate(row) if red > blue + 40}
    check(columns, f"{name} is empty")
    return max(columns) - min(columns) + 1


def flow_of(t, file):
    raw = t.path(file).read_bytes()
    width, height = struct.unpack("<ii", raw[4:12])
    values = struct.unpack(f"<{2 * width * height}f", raw[12:])
    inner = [2 * (j * width + i) for j in range(20, height - 20) for i in range(20, width - 20)]
    return sum(values[k] for k in inner) / len(inner), sum(values[k + 1] for k in inner) / len(inner)


def test_alpha_of_100_gives_almost_no_flow(t):
    texture(t)
    u = {}
    for alpha in ("10", "100"):
        t.vvr("extract", "shift.y4m", "-o", f"a{alpha}", "--solver", "jacobi", "--iterations", "60", "--alpha", alpha,
              *MOVES, "--end", "12f").expect(0)
        u[alpha] = flow_of(t, f"a{alpha}/flow/000006.flo")[0]
    check(u["10"] > 0.5 * SPEED, f"60 steps with λ = α² = 100 find {u['10']:.2f} of {SPEED} pixels")
    check(u["100"] < 0.25 * SPEED, f"60 steps with α = 100 find {u['100']:.2f} of {SPEED} pixels")


@pytest.mark.nightly
def test_size_of_arrows_and_steps_of_tracelines(t):
    texture(t)
    seed = one_seed(t)

    def length(part, *options):
        t.render("shift.y4m", *ALONG, *seed, "--show", part, *options).expect(0)
        return extent(t)

    check(abs(length("arrows", "--glyph-scale", "2") / length("arrows") - 2) < 0.1,
          "--glyph-scale 2 is not twice as long")
    ten = length("tracelines", "--trace-steps", "10")
    check(abs(length("tracelines", "--trace-steps", "20") / ten - 2) < 0.15, "twice the steps are not twice as long")
    pixels_per_column = 960 / 96  # at most: the frame does not fill the picture
    check(ten < 1.1 * 10 * SPEED * pixels_per_column, f"ten steps are {ten} pixels long")


@pytest.mark.nightly
def test_velocity_along_time(t):
    texture(t)
    seed = one_seed(t)

    def width(part, *options):
        t.render("shift.y4m", *ASIDE, *seed, "--show", part, *options).expect(0)
        return extent(t)

    for part in ("arrows", "tracelines"):
        check(width(part) < 60, f"{part} without v_t leave their frame: {width(part)} pixels")
    check(width("arrows", "--time-velocity", "2") > 2 * width("arrows"), "arrows with v_t don't lean along time")
    # A line that begins in frame 8, and one that goes on to the end of the clip.
    line, whole = (width("tracelines", "--time-velocity", "1", "--trace-steps", steps) for steps in ("10", "100"))
    check(abs(line / whole - 10 / (FRAMES - 8.5)) < 0.06, f"ten frames are {line} of {whole} pixels")


def test_the_preset_is_the_paper(t):
    moving_clip(t)
    look = ("--backend", "software", "--size", "480x300")
    t.render("clip.mkv", *look, "--preset", "paper", output="preset.png").expect(0)
    t.render("clip.mkv", *look, "--solver", "jacobi", "--iterations", "60", "--alpha", "10", "--shadows", "keep",
             "--illumination", "none", "--stabilize", "off", "--color", "transfer", "--transfer", "grey", "--show", "volume,arrows",
             output="said.png").expect(0)
    check(t.rgb("preset.png") == t.rgb("said.png"), "the preset is something else than the paper's settings")
    pixels = [pixel for row in t.rgb("preset.png") for pixel in row]
    check(pixels.count((255, 255, 255)) > len(pixels) / 2, "not on white")
    greys = [pixel for pixel in pixels if max(pixel) - min(pixel) < 6 and max(pixel) < 200]
    check(len(greys) > 100, f"{len(greys)} dark grey pixels")
    check(sum(red > green > blue + 20 for red, green, blue in pixels) > 50, "no arrows from yellow to red")
    t.render("clip.mkv", *look, "--preset", "paper", "--show", "volume", output="alone.png").expect(0)
    check(not any(red > blue + 40 for row in t.rgb("alone.png") for red, _, blue in row), "an option beside the preset does not win")


def test_figure_4_shows_object_flow_and_seeds(t):
    moving_clip(t)
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=96x64", "-frames:v", "1", "empty.png")
    options = ("--grid", "8", "--reference", "empty.png")
    t.vvr("extract", "clip.mkv", "-o", "data", *options).expect(0)
    t.vvr("inspect", "clip.mkv", "--frame", "25f", *options, "-o", "out.png").expect(0)
    rows = t.rgb("out.png")
    gap, width = 14, (1280 - 4 * 14) // 3  # as cli/app/inspect.cpp places them
    scale = width / 96

    def panel(number):
        left = gap + number * (width + gap)
        return [row[left:left + width] for row in rows[gap:gap + round(64 * scale)]]

    def columns(pixels, is_drawn):
        found = [i / scale for row in pixels for i, pixel in enumerate(row) if is_drawn(*pixel)]
        check(len(found) > 50, f"{len(found)} pixels are drawn")
        return min(found), max(found)
    # In frame 25 the square reaches from 39.5 to 63.5.
    low, high = columns(panel(0), lambda r, g, b: r > b + 60)
    check(36 < low < 44 and 59 < high < 67, f"(a) the object reaches from {low:.1f} to {high:.1f}")
    low, high = columns(panel(1), lambda r, g, b: g > r + 60 and g > b + 60)
    check(low < 45 and high > 60, f"(b) lines of flow only from {low:.1f} to {high:.1f}")
    dots = panel(2)
    seeds = [line.split() for line in t.path("data/seeds/000025.txt").read_text().splitlines()[5:]]
    check(len(seeds) > 3, "no seeds")
    for x, y, *_ in seeds:
        red, green, blue = dots[round((float(y) + 0.5) * scale)][round((float(x) + 0.5) * scale)]
        check(red > 150 and blue < 120 and red > green, f"(c) no dot at {x}, {y}: {red}, {green}, {blue}")
    plain = [pixel for row in panel(0)[:20] for pixel in row]
    check(all(max(pixel) - min(pixel) < 20 for pixel in plain), "(a) is not dimmed where nothing is")
