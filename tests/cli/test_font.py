"""The font of a picture's text is an input: --font names it, and files say which one it was."""

import json
import os
import re

import pytest
from harness import check

DEJAVU = "/usr/share/fonts/truetype/dejavu"


@pytest.fixture(name="fonts")
def two_fonts(t):
    """Two fonts, as files of the test's folder."""
    for name in ("DejaVuSans.ttf", "DejaVuSerif-Bold.ttf"):
        if not os.path.exists(f"{DEJAVU}/{name}"):
            pytest.skip("fonts-dejavu-core is not installed")
        t.write(name, open(f"{DEJAVU}/{name}", "rb").read())
    t.clip(seconds=4)
    return ("DejaVuSans.ttf", "DejaVuSerif-Bold.ttf")


def recorded_font(t, picture):
    """What a PNG says of its font; nothing if it says nothing."""
    found = re.search(rb"vvr:font\0([\w. -]+\.\w{3})", t.path(picture).read_bytes())
    return found and found[1].decode()


def test_font_draws_text_and_is_recorded(t, fonts):
    pictures = []
    for font in fonts:
        t.render("clip.avi", "--font", font, "--size", "320x200", "--report", "report.json", output=f"{font}.png").expect(0)
        check(recorded_font(t, f"{font}.png") == font, f"{font} is not in the picture")
        check(json.loads(t.path("report.json").read_text())["settings"]["font"] == font, "the report does not name it")
        pictures.append(t.rgb(f"{font}.png"))
    check(pictures[0] != pictures[1], "the font makes no difference")
    t.vvr("inspect", "clip.avi", "--frame", "1s", "-o", "sans.png", "--font", fonts[0]).expect(0)
    t.vvr("inspect", "clip.avi", "--frame", "1s", "-o", "serif.png", "--font", fonts[1]).expect(0)
    check(t.rgb("sans.png") != t.rgb("serif.png"), "the font makes no difference to captions")


def test_font_of_the_machine_is_recorded_where_there_is_text(t, fonts):
    sans = json.loads(t.vvr("doctor", "--json").expect(0, out=None).out)["font"]
    t.render("clip.avi", "--size", "320x200").expect(0)
    check(recorded_font(t, "out.png") == sans, f"{recorded_font(t, 'out.png')} is not {sans}")
    t.render("clip.avi", "--size", "320x200", "--show", "volume,arrows,outline", output="bare.png").expect(0)
    check(recorded_font(t, "bare.png") is None, "a picture without text names a font")
    # So the fonts of a machine don't matter to it.
    t.write("fonts.conf", f"<?xml version='1.0'?><!DOCTYPE fontconfig SYSTEM 'fonts.dtd'><fontconfig><dir>{t.folder}</dir></fontconfig>")
    t.path(fonts[0]).unlink()
    for name, options in (("other.png", ("--show", "volume,arrows,outline")), ("text.png", ())):
        t.vvr("render", "clip.avi", "-o", name, "--size", "320x200", *options,
              env=os.environ | {"FONTCONFIG_FILE": str(t.path("fonts.conf"))}).expect(0)
    check(t.path("other.png").read_bytes() == t.path("bare.png").read_bytes(), "another font, other bytes without text")
    check(recorded_font(t, "text.png") == fonts[1], f"{recorded_font(t, 'text.png')}")


def test_golden_of_another_font_says_so(t, fonts):
    t.vvr("render", "clip.avi", "--size", "320x200", "--golden", "golden.png", "--bless", "--font", fonts[0]).expect(0)
    t.vvr("render", "clip.avi", "--size", "320x200", "--golden", "golden.png", "--font", fonts[0]).expect(0)
    t.vvr("render", "clip.avi", "--size", "320x200", "--golden", "golden.png", "--font", fonts[1]).expect(
        7, "'golden.png'", fonts[0], fonts[1], code="picture-differs")


def test_font_that_is_none(t):
    t.clip()
    t.write("words.ttf", "no letters")
    for font, code, *facts in [("none.ttf", "file-not-found", "--font", "'none.ttf'", "No such file or directory"),
                               ("words.ttf", "file-invalid", "--font", "'words.ttf'", ".ttf", ".otf"),
                               ("/dev/zero", "not-a-file", "'/dev/zero'")]:
        t.render("clip.avi", "--font", font).expect(2, *facts, code=code)
        t.vvr("inspect", "clip.avi", "--frame", "1s", "-o", "out.png", "--font", font).expect(2, *facts, code=code)
        t.vvr("watch", "clip.avi", "-o", "out.png", "--font", font).expect(2, *facts, code=code)
        t.archive(".", "-o", "pictures", "--font", font).expect(2, *facts, code=code)
    t.expect_files("clip.avi", "words.ttf")


def test_font_is_not_overwritten(t, fonts):
    t.render("clip.avi", "--font", fonts[0], "--report", fonts[0]).expect(1, f"--report '{fonts[0]}'", code="output-replaces-input")


def test_archive_draws_again_with_another_font(t, fonts):
    t.path("in").mkdir()
    t.path("clip.avi").rename(t.path("in/clip.avi"))

    def archive():
        return t.archive("in", "-o", "out", "--no-pages", "--font", fonts[0], "--size", "320x200")

    archive().expect(0, "1 clip drawn")
    archive().expect(0, "nothing to do")
    t.path(fonts[0]).write_bytes(t.path(fonts[1]).read_bytes())  # the same name, other letters
    archive().expect(0, "1 clip drawn")


def test_golden_of_other_settings_says_so(t):
    t.clip()
    options = ("render", "clip.avi", "--size", "160x100", "--show", "volume", "--golden", "golden.png")
    t.vvr(*options, "--bless").expect(0)
    done = t.vvr(*options).expect(0)
    check("other settings" not in done.err, str(done))
    t.vvr(*options, "--threshold", "25", "--tolerance", "100").expect(
        0, "'golden.png' was drawn with other settings: threshold was 24, now 25")
    t.vvr(*options, "--opacity", "0.1").expect(7, "'golden.png'", "opacity", "1", "0.1", code="picture-differs")
