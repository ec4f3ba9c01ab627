"""Commands, options and their values."""

from harness import check

UNUSABLE = {  # one for each type of value; tests/unit has others: option and value, the error's code, what the text says
    ("--size", "0x0"): ("option-value-out-of-range", "1x1 to 16384x16384"),
    ("--size", "1280"): ("option-value", "1280x800"),
    ("--alpha", "nan"): ("option-value-out-of-range", "0.01 to 10000"),
    ("--alpha", "3,5"): ("option-value", "'3,5'"),
    ("--iterations", "2.5"): ("option-value", "'2.5'"),
    ("--threshold", "256"): ("option-value-out-of-range", "0 to 255"),
    ("--start", "250"): ("option-value", "250f", "250s"),
    ("--brick", "0"): ("option-value-out-of-range", "0"),
    ("--radius", "1:0.5"): ("option-value", "'1:0.5'"),
    ("--camera", "0,91"): ("option-value", "-90 to 90"),
    ("--filter", "diference"): ("choice-unknown", "'difference'"),
    ("--reference", "medain"): ("choice-unknown", "'median'"),
    ("--roi", "1,2 3"): ("option-value", "character 6"),
    ("--seed-select", "some"): ("option-value", "'some'"),
    ("--backend", "softwar"): ("choice-unknown", "'software'"),
    ("--show", "volume,arows"): ("choice-unknown", "'arrows'"),
    ("--backend", "egl:256"): ("option-value-out-of-range", "0 to"),
    ("--backend", "auto:1"): ("option-value", "'auto:1'", "egl:1"),
    ("--events", "left,flew"): ("choice-unknown", "'flew'", "5s"),
    ("--events", "left,2d"): ("option-value-out-of-range", "'2d'"),
}


def test_unusable_values(t):
    t.clip()
    for (option, value), (code, *facts) in UNUSABLE.items():
        t.render("clip.avi", option, value).expect(1, option, *facts, code=code)
    t.expect_files("clip.avi")


def test_unknown_command(t):
    t.vvr("rendr").expect(1, "'rendr'", "'render'", "`vvr --help`", code="command-unknown")
    t.vvr("xyzzy").expect(1, "'xyzzy'", "`vvr --help`", code="command-unknown")
    t.vvr().expect(1, "render, watch, extract,", "`vvr --help`", code="command-unknown")
    # What people type first.
    t.clip()
    for name in ("clip.avi", "none.mp4", "rtsp://camera/stream"):
        t.vvr(name).expect(1, f"'{name}'", f"vvr render '{name}' -o picture.png", code="command-unknown")
    t.vvr("render", "clip.avi", "out.png").expect(1, "-o 'out.png'", code="output-missing")
    t.expect_files("clip.avi")


def test_unknown_option(t):
    t.vvr("render", "--szie", "3x3").expect(1, "'--szie'", "'--size'", "`vvr render --help`", code="option-unknown")
    t.vvr("render", "--xyzzy=1", "a.avi").expect(1, "'--xyzzy'", "`vvr render --help`", code="option-unknown")
    t.vvr("doctor", "-z").expect(1, "'-z'", "`vvr doctor --help`", code="option-unknown")


def test_two_dashes_end_the_options(t):
    t.clip()
    t.path("clip.avi").rename(t.path("-clip.avi"))
    t.vvr("render", "-o", "out.png", "--size", "160x100", "--", "-clip.avi").expect(0)
    t.vvr("render", "--", "-clip.avi", "-o", "out.png").expect(1, code="output-missing")
    t.vvr("render", "-o", "out.png", "--", "--no-such.avi").expect(2, "'--no-such.avi'", "No such file or directory", code="file-not-found")
    t.vvr("info", "--", "--config").expect(2, "'--config'", code="file-not-found")


def test_missing_or_too_many_arguments(t):
    t.vvr("render", "-o", "out.png").expect(1, "INPUT", code="input-missing")
    t.vvr("render", "clip.avi").expect(1, "-o FILE", code="output-missing")
    t.vvr("render", "a.avi", "b.avi", "-o", "out.png").expect(2, "'a.avi'", "No such file", code="file-not-found")
    t.vvr("render", "a.avi", "-o").expect(1, "-o", "`vvr render --help`", code="usage")
    t.vvr("info").expect(1, "INPUT", code="input-missing")


def test_options_that_exclude_each_other(t):
    t.clip()
    t.render("clip.avi", "--brick", "5f", "--window", "2").expect(1, "--brick", "--window", code="options-conflict")
    t.render("clip.avi", "--quiet", "--verbose").expect(1, "--verbose", "--quiet", code="usage")


def test_negative_values_are_values_and_the_last_of_two_counts(t):
    t.clip()
    t.render("clip.avi", "--camera", "-30,25", "--camera=-30,-25", "--size", "40x30").expect(0)
    t.expect_picture(size=(40, 30))


def test_help_and_version(t):
    for arguments in (["--help"], ["-h"], ["help"]):
        text = t.vvr(*arguments).expect(0, out=None)
        check("vvr render" in text.out and text.err == "", str(text))
    for command in ("render", "info", "doctor"):
        text = t.vvr(command, "--help").expect(0, out=None)
        check(f"Usage: vvr {command}" in text.out and text.err == "", str(text))
        check(t.vvr("help", command).expect(0, out=None).out == text.out, f"vvr help {command}")
    short = t.vvr("render", "-h").expect(0, out=None).out.splitlines()
    check(len(short) <= 50 and "--output" in " ".join(short), "\n".join(short))
    t.vvr("help", "rendr").expect(1, "'rendr'", code="command-unknown")
    for other in ("-V", "version"):
        check(t.vvr(other).expect(0, out=None).out == t.vvr("--version").out, other)
    version = t.vvr("--version").expect(0, out=None).out.splitlines()
    names = [line.split()[0] for line in version]
    check(names == ["vvr", "FFmpeg", "OpenImageIO", "OpenCV", "OpenGL:"], str(version))
    for line in version[:-1]:
        check(line.split()[1][0].isdigit(), line)
