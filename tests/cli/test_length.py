"""Long clips: a picture of them is to take no more than one of a short clip."""

import pytest
from harness import check, moving_clip


def looped(t, clip, times, name):
    t.ffmpeg("-stream_loop", str(times - 1), "-i", clip, "-c", "copy", name)
    return name


FIELD = (192, 144)
FRAMES = 400  # of the scene; looped, both clips are beyond the two minutes of even time
FEW, MANY = 8, 24


def growth(t, *options):
    """Bytes of the peak per pixel of the fields and per frame by which a clip is longer."""
    t.scene("left_bag", "bag.y4m", "--frames", str(FRAMES))
    t.ffmpeg("-i", "bag.y4m", "-c:v", "mpeg4", "-q:v", "4", "short.mkv")
    few, many = (t.peak_memory("render", looped(t, "short.mkv", times, "looped.mkv"), "-o", "out.png", "--backend", "software",
                               "--field-size", f"{FIELD[0]}x{FIELD[1]}", "--size", "320x200", "--quiet", *options)
                 for times in (FEW, MANY))
    return (many - few) / ((MANY - FEW) * FRAMES * FIELD[0] * FIELD[1])


# By chance one run's peak is some MB above another's: how far threads are ahead of each other decides it. Two bits per pixel
# and frame would be 44 MB here.
LIMIT = 0.25


@pytest.mark.slow
def test_a_long_clip_takes_the_memory_of_a_short_one(t):
    found = growth(t)
    check(found < LIMIT, f"{found:.3f} bytes per pixel and frame, {found * FIELD[0] * FIELD[1] / 1e3:.1f} kB per frame")


@pytest.mark.slow
def test_memory_that_grows_with_a_clip_is_seen(t):
    """Where every frame is asked to have a layer of its own, and all of it is seen, each pixel of each frame is kept."""
    found = growth(t, "--layers", str(MANY * FRAMES), "--step", "1", "--time", "even", "--filter", "luminance", "--flow", "none",
                   "--show", "volume")
    check(found > 2 * LIMIT, f"{found:.3f} bytes per pixel and frame")


def test_the_number_of_layers(t):
    moving_clip(t, frames=900, step=0.08)
    t.render("clip.mkv", output="default.png").expect(0, "900 frames in 450 layers", "each layer merges 2 frames")
    t.render("clip.mkv", "--layers", "1").expect(1, "--layers", "'1'", "2 to 100000", code="option-value-out-of-range")
    # Planned against memory before a frame is read.
    t.render("clip.mkv", "--layers", "900", "--field-size", "9000x9000", output="no.png").expect(5, "--layers", code="memory-too-small")
    check(not t.path("no.png").exists(), "a picture was written")


@pytest.mark.slow
def test_a_clip_of_more_than_100_000_frames(t):
    """Of which the renderer is made at the end, not while they are read."""
    moving_clip(t, frames=40)
    looped(t, "clip.mkv", 2501, "long.mkv")
    t.render("long.mkv", "--time", "even", "--show", "volume,outline", "--color", "transfer").expect(0, "100040 frames in 794 layers")
    t.expect_picture()
