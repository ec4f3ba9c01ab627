"""The font of a picture's text is fontconfig's, and files say which one it was."""

import os
import re

import pytest
from harness import check

DEJAVU = "/usr/share/fonts/truetype/dejavu"


@pytest.fixture(name="fonts")
def two_fonts(t):
    """Two fonts, each with the environment in which it is the only one."""
    if not os.path.exists(f"{DEJAVU}/DejaVuSans.ttf"):
        pytest.skip("fonts-dejavu-core is not installed")
    t.clip(seconds=4)
    return {name: fonts_of(t, name) for name in ("DejaVuSans.ttf", "DejaVuSerif-Bold.ttf")}


def recorded_font(t, picture):
    """What a PNG says of its font; nothing if it says nothing."""
    found = re.search(rb"vvr:font\0([\w. -]+\.\w{3})", t.path(picture).read_bytes())
    return found and found[1].decode()


def test_font_draws_text_and_is_recorded(t, fonts):
    pictures, captions = [], []
    for font, environment in fonts.items():
        t.vvr("render", "clip.avi", "-o", f"{font}.png", "--size", "320x200", "--report", "report.json", env=environment).expect(0)
        check(recorded_font(t, f"{font}.png") == font, f"{font} is not in the picture")
        check(t.json("report.json")["settings"]["font"] == font, "the report does not name it")
        pictures.append(t.rgb(f"{font}.png"))
        t.vvr("inspect", "clip.avi", "--frame", "1s", "-o", "frame.png", env=environment).expect(0)
        captions.append(t.rgb("frame.png"))
    check(pictures[0] != pictures[1], "the font makes no difference")
    check(captions[0] != captions[1], "the font makes no difference to captions")


@pytest.mark.nightly
def test_font_of_the_machine_is_recorded_where_there_is_text(t, fonts):
    sans = t.vvr("doctor", "--json").expect(0, out=None).json()["font"]
    t.render("clip.avi", "--size", "320x200").expect(0)
    check(recorded_font(t, "out.png") == sans, f"{recorded_font(t, 'out.png')} is not {sans}")
    bare = []
    for environment in fonts.values():
        t.vvr("render", "clip.avi", "-o", "bare.png", "--size", "320x200", "--show", "volume,arrows,outline", env=environment).expect(0)
        check(recorded_font(t, "bare.png") is None, "a picture without text names a font")
        bare.append(t.path("bare.png").read_bytes())
    check(bare[0] == bare[1], "another font, other bytes without text")


@pytest.mark.nightly
def test_golden_of_another_font_says_so(t, fonts):
    options = ("render", "clip.avi", "--size", "320x200", "--golden", "golden.png")
    one, other = fonts
    t.vvr(*options, "--bless", env=fonts[one]).expect(0)
    t.vvr(*options, env=fonts[one]).expect(0)
    t.vvr(*options, env=fonts[other]).expect(7, "'golden.png'", one, other, code="picture-differs")


@pytest.mark.nightly
def test_golden_of_other_settings_says_so(t):
    t.clip()
    options = ("render", "clip.avi", "--size", "160x100", "--show", "volume", "--golden", "golden.png")
    t.vvr(*options, "--bless").expect(0)
    done = t.vvr(*options).expect(0)
    check("other settings" not in done.err, str(done))
    t.vvr(*options, "--threshold", "25", "--tolerance", "100").expect(
        0, "'golden.png' was drawn with other settings: threshold was 24, now 25")
    t.vvr(*options, "--opacity", "0.1").expect(7, "'golden.png'", "opacity", "1", "0.1", code="picture-differs")


def fonts_of(t, *names):
    """The environment in which a text has these fonts, the first before the others."""
    folder = t.path("fonts-" + "-".join(names))
    for name in names:
        t.copy(f"{DEJAVU}/{name}", folder / name)
    family = {"DejaVuSans.ttf": "DejaVu Sans", "DejaVuSerif-Bold.ttf": "DejaVu Serif"}[names[0]]
    t.write(f"{folder.name}.conf", "<?xml version='1.0'?><!DOCTYPE fontconfig SYSTEM 'fonts.dtd'><fontconfig>"
                                   f"<dir>{folder}</dir><cachedir>{t.folder}/cache</cachedir><alias binding='strong'>"
                                   f"<family>sans</family><prefer><family>{family}</family></prefer></alias></fontconfig>")
    return os.environ | {"FONTCONFIG_FILE": str(t.path(f"{folder.name}.conf"))}


def drawn(t, picture, title, environment):
    done = t.vvr("render", "clip.avi", "-o", picture, "--size", "640x400", "--title", title, env=environment).expect(0)
    return done.err, t.rgb(picture)


@pytest.mark.nightly
def test_letters_that_a_font_lacks_come_from_another(t, fonts):
    err, alone = drawn(t, "alone.png", "مدخل", fonts["DejaVuSerif-Bold.ttf"])
    check("no font has 4 characters" in err, err)
    environment = fonts_of(t, "DejaVuSerif-Bold.ttf", "DejaVuSans.ttf")
    err, both = drawn(t, "both.png", "مدخل", environment)
    check("no font has" not in err, err)
    check(recorded_font(t, "both.png") == "DejaVuSerif-Bold.ttf", "the font of the other text has changed")
    check(both != alone, "the letters are empty boxes")


def test_letters_of_no_font_are_named(t, fonts):
    err, _ = drawn(t, "out.png", "門 gate 門", fonts["DejaVuSans.ttf"])
    check("no font has 1 character of the picture's text: 門" in err, err)
    err, _ = drawn(t, "out.png", "gate\u200b \u202b1", fonts["DejaVuSans.ttf"])
    check("no font has" not in err, err)
