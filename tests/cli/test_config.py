"""Where a config file is found, and what `vvr config` says of it."""

import os
import re
import resource

import pytest
from harness import check


@pytest.fixture(name="places")
def made_places(t):
    """A clip, and config files in the places where they are found; the environment that leads to them."""
    t.clip()
    for name, size in (("home/.config/vvr/vvr.toml", "40x30"), ("xdg/vvr/vvr.toml", "50x30"), ("named.toml", "60x30")):
        t.write(name, f'[render]\nsize = "{size}"\n')
    environment = {name: value for name, value in os.environ.items() if name not in ("VVR_CONFIG", "XDG_CONFIG_HOME")}
    return environment | {"HOME": str(t.path("home"))}


def test_config_file_is_found(t, places):
    # A relative folder of that name is there too, and must not be read.
    xdg = places | {"XDG_CONFIG_HOME": str(t.path("xdg"))}
    named = xdg | {"VVR_CONFIG": "named.toml"}
    t.write("own.toml", '[render]\nsize = "70x30"\n')
    for environment, arguments, expected in [
        (places, [], "40x30"),
        (xdg, [], "50x30"),
        (places | {"XDG_CONFIG_HOME": "xdg"}, [], "40x30"),  # a relative one counts for nothing
        (named, [], "60x30"),
        (named, ["--config", "own.toml"], "70x30"),
        (named, ["--config", "none"], "1280x960"),
        (named | {"VVR_CONFIG": ""}, [], "1280x960"),
    ]:
        said = t.vvr("config", "render", *arguments, env=environment).expect(0, out=None).out
        check(re.search(rf"^size +{expected} ", said, flags=re.MULTILINE), f"{arguments}: not {expected}: {said}")


def test_found_config_file_with_errors(t, places):
    def render(**environment):
        return t.vvr("render", "clip.avi", "-o", "out.png", env=places | environment)

    render(VVR_CONFIG="none.toml").expect(2, "'none.toml'", "VVR_CONFIG", code="io")
    found = t.path("home/.config/vvr/vvr.toml")
    found.write_text("szie = 1\n")
    render().expect(1, f"'{found}'", "'szie'", "'size'", code="config-invalid")
    t.vvr("render", "--help", env=places).expect(0, out=None)
    found.write_text("[render]\nalpha = lots\n")
    render().expect(1, "--alpha", "'lots'", f"'{found}'", code="option-value")
    result = t.vvr("render", "clip.avi", "-o", "out.png", "--alpha", "few", env=places)
    check(str(found) not in result.expect(1, "--alpha", "'few'", code="option-value").err, str(result))
    check(not t.path("out.png").exists(), "a picture all the same")


@pytest.mark.nightly
def test_workers_of_an_archive_read_no_config_file(t, places):
    """What an archive is drawn with stands in its sidecars; a [render] of its own is not among that."""
    t.clip("in/a.avi")
    t.archive("in", "-o", "drawn", "--size", "90x60", env=places).expect(0, "1 clip drawn")
    check(t.picture_size("drawn/a.avi.png") == (90, 60), "the size that archive was given")
    t.path("home/.config/vvr/vvr.toml").write_text("[render]\nfilter = 'nonsense'\n")
    t.archive("in", "-o", "again", "--size", "90x60", env=places).expect(0, "1 clip drawn")


def test_config_says_what_is_in_force(t, places):
    found = t.path("home/.config/vvr/vvr.toml")
    said = t.vvr("config", env=places).expect(0, out=None).out
    check(said == f"config file: {found} (found there)\nvvr render: size = 40x30\n", said)
    said = t.vvr("config", "render", env=places).expect(0, out=None).out
    check(re.search(r"^size +40x30 \(config file\)$", said, flags=re.MULTILINE), said)
    check(re.search(r"^filter +difference \(default\)$", said, flags=re.MULTILINE), said)
    said = t.vvr("config", "--config", "named.toml", env=places).expect(0, out=None).out
    check(said == "config file: named.toml (named by --config)\nvvr render: size = 60x30\n", said)
    t.vvr("config", "--config", "none", env=places).expect(0, out="config file: none (because of --config none)\n")
    t.vvr("config").expect(0, out="config file: none (because VVR_CONFIG is empty)\n")
    # The command's own section takes precedence over the lines above it, for lists too.
    found.write_text("fov = 3\nnames = '{camera}-%s'\n[render]\nfov = 4\nnames = ['%s', '%Y%m%d%H']\n")
    said = t.vvr("config", env=places).expect(0, out=None).out
    check("vvr render: fov = 4\n" in said and "vvr render: names = %s %Y%m%d%H\n" in said and "vvr info: fov = 3\n" in said, said)
    found.write_text("size = 40x30\n")
    said = t.vvr("config", env=places).expect(0, out=None).out
    check("vvr render: size = 40x30\n" in said and "vvr doctor" not in said, said)


def test_top_level_keys_are_for_the_commands_that_have_them(t):
    t.clip()
    t.write("vvr.toml", 'size = "40x30"\nnames = ["{camera}-%s"]\ntolerance = 0.5\nquiet = false\n')
    config = ("--config", "vvr.toml")
    t.vvr("doctor", *config).expect(0, out=None)
    t.vvr("cut", "clip.avi", "--start", "0.5s", "-o", "cut.avi", *config).expect(0)
    t.vvr("extract", "clip.avi", "-o", "data", *config).expect(0)
    t.vvr("seeds", "data", "-o", "lists", *config).expect(0)
    t.vvr("render", "clip.avi", "-o", "a.png", *config).expect(0)
    check(t.picture_size("a.png") == (40, 30), "size counts for render")
    t.vvr("compare", "a.png", "a.png", *config).expect(0, out=None)


def test_names_that_nobody_knows_stop_every_command(t):
    t.clip()
    commands = (["render", "clip.avi", "-o", "out.png"], ["doctor"], ["compare", "a.png", "b.png"], ["config"], ["config", "render"],
                ["info", "clip.avi"])
    for number, (text, *facts) in enumerate((
        ("[redner]\nsize = '40x30'\n", "'vvr.toml'", "[redner]", "'render'"),
        ("[redner]\n", "[redner]"),
        ("[render.look]\nsize = '40x30'\n", "[render.look]"),
        ("szie = '40x30'\n", "'vvr.toml'", "'szie'", "'size'"),
        ("[render]\nszie = '40x30'\n", "'szie'", "`vvr render`", "'size'"),
        ("[info]\ntolerance = 1\n", "'tolerance'", "`vvr info`"),
        ("config = 'other.toml'\n", "'config'"),
        ("[camera.gate]\nthreshhold = 3\n", "'threshhold'", "[camera.gate]", "'threshold'"),
        ("[camera.gate]\njobs = 3\n", "'jobs'", "[camera.gate]"),
        ("[camera]\nthreshold = 3\n", "[camera.NAME]"),
        ("[render]\nfov = 3\n[info]\n[render]\nfov = 4\n", "lines 1 and 4 both begin the section [render]"),
    )):
        t.write("vvr.toml", text)
        for command in commands if number == 0 else commands[number % len(commands):][:1]:  # all read it with the same function
            t.vvr(*command, "--config", "vvr.toml").expect(1, *facts, code="config-invalid")
    t.vvr("render", "--help", env=os.environ | {"VVR_CONFIG": "vvr.toml"}).expect(0, out=None)  # for whoever wants to mend it
    t.expect_files("clip.avi", "vvr.toml")


def test_each_camera_of_an_archive_has_its_settings(t):
    t.old_clips("house/gate/21112026-203000.avi", "house/hall/2026-11-21_20-30-00.avi", "yard/2026-11-21_20-30-00.avi")
    t.write("vvr.toml", """threshold = 20
[archive]
size = "160x100"
flow = "none"
[camera.gate]
threshold = 40
names = ["%d%m%Y-%H%M%S"]
[camera."house/hall"]
threshold = 50
[camera.hall]
threshold = 60
[camera.cellar]
threshold = 70
""")
    config = ("--config", "vvr.toml")
    t.archive("in", "-o", "out", *config).expect(0, "3 clips drawn", "[camera.cellar]", "house/gate, house/hall, yard")

    def known(clip):
        report = t.json(f"out/{clip}.report.json")
        return report["settings"]["threshold"], report["input"]["recorded"]

    evening = "2026-11-21 20:30:00"
    for clip, threshold in (("house/gate/21112026-203000.avi", "40"), ("house/hall/2026-11-21_20-30-00.avi", "50"),
                            ("yard/2026-11-21_20-30-00.avi", "20")):
        check(known(clip) == (threshold, evening), f"{clip}: {known(clip)}")
    # Only the clips of a camera whose section has changed are drawn again. The command line takes precedence.
    t.write("vvr.toml", t.path("vvr.toml").read_text().replace("= 40", "= 41"))
    t.archive("in", "-o", "out", *config).expect(0, "house/gate/21112026-203000.avi: ", "1 clip drawn", "2 done before")
    # One clip has the settings of its camera too, by its folders or by name.
    clip = "in/house/gate/21112026-203000.avi"
    for arguments, expected in (([], "41"), (["--camera-name", "cellar"], "70"), (["--threshold", "33"], "33")):
        t.render(clip, *config, *arguments, "--report", "r.json", output=None).expect(0)
        check(t.json("r.json")["settings"]["threshold"] == expected, f"{arguments}")
    # So has a folder of one camera, whose clips lie deeper.
    t.clip("tree/gate/2026-11-21/20-30-00.avi", seconds=1)
    t.render("tree", *config, "--report", "r.json", output=None).expect(0)
    check(t.json("r.json")["settings"]["threshold"] == "41", "tree")
    t.render(clip, *config, "--camera-name", "gaet").expect(1, "[camera.gaet]", "'gate'", code="option-value")
    # Without sections it only names the camera.
    t.render(clip, "--camera-name", "gate", "--report", "r.json", output=None).expect(0)
    check(t.json("r.json")["input"]["camera"] == "gate", "named")
    # A pattern, a list of files, and a number that only the section says is a camera's.
    t.write("more.toml", "[camera.gate]\nthreshold = 41\n[camera.01]\nthreshold = 42\n")
    t.copy(clip, "many/gate_2026-11-21_20-30-00.avi", "many/gate_2026-11-21_20-30-01.avi", "01_20261121203000.avi")
    for inputs, expected in ((["tree/*/2026-11-21"], ("41", "gate")),
                             (["many/gate_2026-11-21_20-30-00.avi", "many/gate_2026-11-21_20-30-01.avi"], ("41", "gate")),
                             (["01_20261121203000.avi"], ("42", "01"))):
        t.render(*inputs, "--config", "more.toml", "--report", "r.json", output=None).expect(0)
        report = t.json("r.json")
        check((report["settings"]["threshold"], report["input"]["camera"]) == expected, f"{inputs}: {report['input']}")
    said = t.vvr("config", "archive", "--camera-name", "gate", *config).expect(0, out=None).out
    check(re.search(r"^threshold +41 \(config file, \[camera.gate\]\)$", said, flags=re.MULTILINE), said)
    said = t.vvr("config", *config).expect(0, out=None).out
    check("camera gate: threshold = 41\n" in said and "camera house/hall: threshold = 50\n" in said, said)
    t.write("vvr.toml", "[camera.gate]\nalpha = 'lots'\n")
    t.archive("in", "-o", "out", *config).expect(1, "'lots'", "[camera.gate]", code="option-value")


def test_cameras_cost_no_time(t):
    """The file is read and checked once, however many sections it has."""
    t.old_clips("a.avi")

    def seconds(count):
        t.write("vvr.toml", "".join(f"[camera.c{number}]\nthreshold = {number}\n" for number in range(count)))
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        t.archive("in", "-o", "out", "--config", "vvr.toml", "--dry-run").expect(0, out=None)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime - before.ru_utime

    one, many = min(seconds(1) for _ in range(3)), min(seconds(128) for _ in range(3))
    check(many - one < 0.3, f"{many} s of processor time for 128 cameras, {one} s for one")


def test_config_with_errors(t):
    t.vvr("config", "--camera-name", "gate").expect(1, "COMMAND", code="option-needs-another")
    t.vvr("config", "rendr").expect(1, "'rendr'", "'render'", code="command-unknown")
    t.vvr("config", "render", "info").expect(1, "'info'", "`vvr config`", code="input-unsuitable")
    t.vvr("config", "--config", "none.toml").expect(2, "'none.toml'", "--config", code="io")
