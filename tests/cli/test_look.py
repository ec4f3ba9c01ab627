"""Animations, transfer functions and colours."""

import pytest
from harness import check

LINES = ("--show", "volume,tracelines")


def test_a_series_of_pictures(t):
    t.clip()
    t.render("clip.avi", "--animate", "3", *LINES, output="a.{frame:4}.png").expect(0)
    t.expect_files("clip.avi", *[f"a.000{i}.png" for i in range(3)])
    pictures = {t.path(f"a.000{i}.png").read_bytes() for i in range(3)}
    check(len(pictures) == 3, "pictures of the series are the same")


@pytest.mark.nightly
def test_animated_files(t):
    t.clip()
    for ending in ("gif", "mp4", "webm"):
        result = t.render("clip.avi", "--animate", "5", *LINES, output=f"out.{ending}").expect(0, out="")
        check(result.err.count("\n") == 1, f"an encoder talks: {result}")
        t.expect_picture(f"out.{ending}")
        check(t.frames_in(f"out.{ending}") == 5, f"out.{ending} has {t.frames_in(f'out.{ending}')} pictures")
    t.render("clip.avi", *LINES, output="standard.gif").expect(0)
    check(t.frames_in("standard.gif") == 24, "pictures if not told how many")


def test_animations_that_cannot_be(t):
    t.clip()
    t.render("clip.avi", "--animate", "3", *LINES).expect(1, "--animate", "3 pictures", "'out.png'", code="options-conflict")
    t.render("clip.avi", *LINES, output="a.{frame}.png").expect(1, "'a.{frame}.png'", "--animate", code="option-needs-another")
    t.render("clip.avi", "--animate", "3", output="a.gif").expect(1, "--show volume,tracelines", code="option-needs-another")
    t.render("clip.avi", "--animate", "3", *LINES, output="a.##.gif").expect(1, "'a.##.gif'", code="name-pattern-invalid")
    t.render("clip.avi", "--animate", "3", *LINES, output="none/a.gif").expect(2, "'none/a.gif'", "mkdir -p 'none'", code="file-not-found")
    t.render("clip.avi", "--animate", "1", *LINES, output="a.gif").expect(1, "--animate", "'1'", code="option-value-out-of-range")
    t.expect_files("clip.avi")


@pytest.mark.nightly
def test_samples_smooth_edges(t):
    t.clip()
    for samples in ("1", "4"):
        t.render("clip.avi", "--samples", samples, "--show", "outline", "--backend", "software",
                 output=f"{samples}.png").expect(0)
    t.render("clip.avi", "--show", "outline", "--backend", "software").expect(0)

    def greys(name):
        return len(set(t.raw(name, "gray")))

    check(greys("1.png") == 2, f"one sample: {greys('1.png')} shades, not that of the paper and that of the line")
    check(greys("4.png") > 3, f"four samples: {greys('4.png')} shades")
    check(greys("out.png") == greys("4.png"), "four is what it is without the option")
    t.render("clip.avi", "--samples", "64", "--backend", "software", output="no.png").expect(5, "--samples 64", code="limit")
    check(not t.path("no.png").exists(), "a picture all the same")


def test_transfer_functions(t):
    t.clip()
    t.write("mine.tf", "0 0 0 0 0\n255, 1, 0, 0, 1  # red\n")
    t.render("clip.avi", "--transfer", "mine.tf", "--show", "volume").expect(0)
    t.render("clip.avi", "--transfer", "heat", "--show", "volume", output="heat.png").expect(0)
    check(t.path("out.png").read_bytes() != t.path("heat.png").read_bytes(), "the transfer function changes nothing")
    t.write("wrong.tf", "0 0 0 0 0\n9 1 0 red 1\n")
    t.render("clip.avi", "--transfer", "wrong.tf", output="no.png").expect(
        1, "--transfer", "wrong.tf:2", "blue", "'red'", "0 to 1", code="option-value")
    t.expect_files("clip.avi", "heat.png", "mine.tf", "out.png", "wrong.tf")
