"""What docs/reading.md says helps, on generated clips."""

import pytest
from harness import check

NOISE = ("--noise", "2", "--detail", "4")
SMALL = ("--size", "192x144")


def scene(t, name, *options):
    return t.scene(name, f"{name}.y4m", *NOISE, *options)


def filtered(t, clip, *filters):
    t.ffmpeg("-i", clip, *filters, "-c:v", "ffv1", "filtered.mkv")
    return "filtered.mkv"


def report(t, clip, *options):
    t.vvr("render", clip, "--report", "r.json", "--flow", "none", *options).expect(0)
    return t.json("r.json")


def kinds(t, clip, *options):
    return [event["kind"] for event in report(t, clip, *options)["events"] or []]


def test_reading_a_clock_is_left_out(t):
    check(report(t, scene(t, "clock", *SMALL))["volume"]["still"], "the clock is in the picture")


@pytest.mark.nightly
def test_reading_a_train_is_masked(t):
    clip = scene(t, "train", *SMALL)
    check(kinds(t, clip) == ["stood", "moved"], str(kinds(t, clip)))
    check(kinds(t, clip, "--mask", "0,30 192,30 192,95 0,95") == ["moved"], "the mask does not hide the train")


@pytest.mark.nightly
def test_reading_a_shaking_camera(t):
    clip = scene(t, "walks_by_shaken")
    check(kinds(t, clip) == ["moved"], str(kinds(t, clip)))
    check(len(kinds(t, clip, "--stabilize", "off")) > 1, "it makes no difference")


@pytest.mark.nightly
def test_reading_flicker(t):
    clip = filtered(t, scene(t, "walks_by", *SMALL), "-vf", "eq=brightness='0.3*sin(2*PI*t*3)':eval=frame")
    check(kinds(t, clip) == ["moved"], str(kinds(t, clip)))
    check(kinds(t, clip, "--illumination", "none") == [], "it makes no difference")


@pytest.mark.nightly
def test_reading_somebody_who_was_always_there(t):
    clip = scene(t, "stands", *SMALL)
    t.ffmpeg("-i", clip, "-frames:v", "1", "empty.png")
    piece = ("--start", "4s", "--end", "11s")
    check(kinds(t, clip, *piece) == [], str(kinds(t, clip, *piece)))
    check(len(kinds(t, clip, *piece, "--reference", "empty.png")) == 1, "the empty scene's picture does not help")


def lit(t, clip, *options):
    """How much of the frames the volume shows, on the disk of an extraction."""
    t.vvr("extract", clip, "-o", "data", "--flow", "none", "--end", "3s", *options).expect(0)
    return sum(file.stat().st_size for file in t.path("data/scalar").iterdir())


@pytest.mark.nightly
def test_reading_rain_and_trees(t):
    rain = scene(t, "rain")
    check(kinds(t, rain, "--min-area", "60") == ["moved"], str(kinds(t, rain, "--min-area", "60")))
    check(lit(t, rain, "--min-area", "60") < 0.8 * lit(t, rain), "rain is as much as before")
    sway = ("[0:v]split[a][b];[b]crop=150:130:230:5[p];"
            "[a][p]overlay=x='230+5*sin(2*PI*t*1.3)':y='5+3*sin(2*PI*t*0.9)'")
    tree = filtered(t, scene(t, "walks_by"), "-filter_complex", sway)
    check(kinds(t, tree, "--mask", "220,0 384,0 384,145 220,145") == ["moved"], "nobody walks beside the tree")
    check(lit(t, tree, "--mask", "220,0 384,0 384,145 220,145") < 0.8 * lit(t, tree), "the tree is as much as before")


@pytest.mark.nightly
def test_reading_colours_of_objects(t):
    clip = scene(t, "walks_by")
    legend = {}
    for name, options in {"default": [], "blue": ["--transfer", "blue"], "both": ["--transfer", "blue", "--color", "object"],
                          "temporal": ["--filter", "temporal"]}.items():
        done = report(t, clip, "-o", "p.png", "--size", "640x440", *options)
        legend[name] = any("colour for each object" in label["text"] for label in done["labels"])
    check(legend == {"default": True, "blue": False, "both": True, "temporal": False}, str(legend))
