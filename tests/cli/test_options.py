"""Commands, options and their values."""

from harness import check

UNUSABLE = {  # option and value, and what the text has to say
    ("--size", "0x0"): "is not a size from 1x1 to 16384x16384",
    ("--size", "100000x100000"): "is not a size from 1x1 to 16384x16384",
    ("--size", "1280"): "is not a size like 1280x800",
    ("--size", "-5x10"): "is not a size from 1x1 to 16384x16384",
    ("--field-size", "0x10"): "is not a size from 1x1",
    ("--alpha", "nan"): "is not a number from 0.01 to 10000",
    ("--alpha", "inf"): "is not a number",
    ("--alpha", "-3"): "is not a number",
    ("--alpha", "ten"): "is not a number",
    ("--alpha", "3,5"): "is not a number",
    ("--iterations", "2.5"): "is not a whole number",
    ("--threshold", "256"): "is not a whole number from 0 to 255",
    ("--start", "soon"): "is not a time like 12.5s, 1h30m, 00:00:12.5 or 250f, a frame",
    ("--start", "250"): "'250' has no unit: write 250f for frames or 250s for seconds",
    ("--start", "-1s"): "is not a time",
    ("--start", "00:99:00"): "is not a time",
    ("--brick", "0"): "length must be greater than 0",
    ("--window", "0"): "is not a whole number from 1 to 256",
    ("--radius", "1:0.5"): "the outer radius has to be larger",
    ("--radius", "1"): "two numbers with ':' between them",
    ("--camera", "10"): "two numbers with ',' between them",
    ("--camera", "0,91"): "the second from -90 to 90",
    ("--height", "0"): "is not a number",
    ("--fov", "180"): "is not a number from 0 to 150",
    ("--filter", "diference"): "did you mean 'difference'?",
    ("--flow", "horn"): "did you mean 'horn-schunck'?",
    ("--reference", "medain"): "medain",
    ("--roi", "1,2 3"): "--roi",
    ("--seed-select", "some"): "some",
    ("--layout", "horsehoe"): "did you mean 'horseshoe'?",
    ("--backend", "softwar"): "did you mean 'software'?",
    ("--show", "volume,arows"): "did you mean 'arrows'?",
    ("--samples", "0"): "is not a whole number from 1 to 64",
    ("--samples", "65"): "is not a whole number from 1 to 64",
    ("--samples", "two"): "is not a whole number",
    ("--slices", "-1"): "is not a whole number from 0",
    ("--device", "-2"): "is not a whole number from -1",
}


def test_unusable_values(t):
    t.clip()
    for (option, value), text in UNUSABLE.items():
        t.render("clip.avi", option, value).expect(1, f"vvr: {option}: ", text)
    t.expect_files("clip.avi")


def test_unknown_command(t):
    t.vvr("rendr").expect(1, "there is no command 'rendr' (did you mean 'render'?); `vvr --help` lists them")
    t.vvr("xyzzy").expect(1, "there is no command 'xyzzy'; `vvr --help`")
    t.vvr().expect(1, "no command; there are render, watch, extract,", "`vvr --help` says what they do")
    # What people type first.
    t.clip()
    for name in ("clip.avi", "none.mp4", "rtsp://camera/stream"):
        t.vvr(name).expect(1, f"there is no command '{name}'; to draw it: vvr render '{name}' -o picture.png")
    t.vvr("render", "clip.avi", "out.png").expect(1, "no output, and there is no input 'out.png'; if that is where the picture goes: -o 'out.png'")
    t.expect_files("clip.avi")


def test_unknown_option(t):
    t.vvr("render", "--szie", "3x3").expect(1, "there is no option '--szie' (did you mean '--size'?)", "`vvr render --help`")
    t.vvr("render", "--xyzzy=1", "a.avi").expect(1, "there is no option '--xyzzy';")
    t.vvr("doctor", "-z").expect(1, "there is no option '-z'")
    for option, text in (("-i", "an input has no option"), ("-ss", "--start TIME"), ("-y", "outputs are replaced"), ("-to", "--end TIME"),
                         ("--add-region", "--roi AREA"), ("--resolution", "--size WxH")):
        t.vvr("render", option, "clip.avi", "-o", "out.png").expect(1, f"there is no option '{option}': ", text)


def test_two_dashes_end_the_options(t):
    t.clip()
    t.path("clip.avi").rename(t.path("-clip.avi"))
    t.vvr("render", "-o", "out.png", "--size", "160x100", "--", "-clip.avi").expect(0)
    t.vvr("render", "--", "-clip.avi", "-o", "out.png").expect(1)
    t.vvr("render", "-o", "out.png", "--", "--no-such.avi").expect(2, "cannot read '--no-such.avi'")
    t.vvr("info", "--", "--config").expect(2, "cannot read '--config'")


def test_missing_or_too_many_arguments(t):
    t.vvr("render", "-o", "out.png").expect(1, "no INPUT")
    t.vvr("render", "clip.avi").expect(1, "no output", "-o FILE")
    t.vvr("render", "a.avi", "b.avi", "-o", "out.png").expect(2, "cannot read 'a.avi': No such file")
    t.vvr("render", "a.avi", "-o").expect(1, "-o", "`vvr render --help`")
    t.vvr("info").expect(1, "no INPUT")


def test_options_that_exclude_each_other(t):
    t.clip()
    t.render("clip.avi", "--brick", "5f", "--window", "2").expect(1, "--brick excludes --window")
    t.render("clip.avi", "--quiet", "--verbose").expect(1, "--verbose", "--quiet")


def test_negative_values_are_values(t):
    t.clip()
    t.render("clip.avi", "--camera", "-30,25", "--layout", "box").expect(0)
    t.render("clip.avi", "--camera=-30,-25").expect(0)


def test_the_last_of_two_counts(t):
    t.clip()
    t.render("clip.avi", "--size", "40x30").expect(0)
    t.expect_picture(size=(40, 30))


def test_help_and_version(t):
    for arguments in (["--help"], ["-h"], ["help"]):
        text = t.vvr(*arguments).expect(0, out=None)
        check("vvr render" in text.out and text.err == "", str(text))
    for command in ("render", "info", "doctor"):
        text = t.vvr(command, "--help").expect(0, out=None)
        check(f"Usage: vvr {command}" in text.out and text.err == "", str(text))
        check(t.vvr("help", command).expect(0, out=None).out == text.out, f"vvr help {command}")
    t.vvr("help", "rendr").expect(1, "there is no command 'rendr'")
    for other in ("-V", "version"):
        check(t.vvr(other).expect(0, out=None).out == t.vvr("--version").out, other)
    version = t.vvr("--version").expect(0, out=None).out.splitlines()
    names = [line.split()[0] for line in version]
    check(names == ["vvr", "FFmpeg", "OpenImageIO", "OpenCV", "OpenGL:"], str(version))
    for line in version[:-1]:
        check(line.split()[1][0].isdigit(), line)


def test_config_file(t):
    t.clip()
    t.write("vvr.conf", "# for all commands\nsize = 40x30\nshow = volume,arrows\n[render]\nfov = 20\n[info]\nthreshold = 9\n")
    t.vvr("render", "clip.avi", "-o", "out.png", "--config", "vvr.conf").expect(0)
    t.expect_picture(size=(40, 30))
    t.vvr("render", "clip.avi", "-o", "out.png", "--config", "vvr.conf", "--size", "50x30").expect(0)
    t.expect_picture(size=(50, 30))


def test_config_file_with_errors(t):
    t.clip()
    t.write("typo.conf", "szie = 40x30\n")
    t.render("clip.avi", "--config", "typo.conf").expect(1, "config file 'typo.conf' sets 'szie'", "did you mean 'size'?")
    t.write("value.conf", "alpha = lots\n")
    t.render("clip.avi", "--config", "value.conf").expect(1, "--alpha: 'lots' is not a number", "; the config file 'value.conf' sets it")
    t.render("clip.avi", "--config", "none.conf").expect(2, "cannot read config file 'none.conf', named by --config")
    t.expect_files("clip.avi", "typo.conf", "value.conf")
