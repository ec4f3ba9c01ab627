"""Settings that files record are those that were used, and can be given back: the same picture, byte for byte."""

import pytest
from harness import check, nightly_except

NO_OPTIONS = ("font",)  # recorded beside the settings


def reported(t, clip, *options):
    """The settings of a report, and the options that they are."""
    t.vvr("render", clip, *options, "--report", "report.json").expect(0)
    settings = t.json("report.json")["settings"]
    return settings, {name: value for name, value in settings.items() if name not in NO_OPTIONS}


@pytest.mark.parametrize("options", nightly_except((
    ("--preset", "paper"), ("--brick", "5f"), ("--time", "busy"), ("--preset", "day"), ("--theme", "dark"), ("--color", "hull"),
    ("--transfer", "heat"), ("--color", "signed", "--filter", "edges"), ("--start", "3f", "--end", "1.5s"), ("--flow", "none"),
    ("--field-size", "32x24", "--step", "2"), ("--slices", "40", "--height", "0.4")), ("--preset", "paper")))
def test_settings_of_other_options_can_be_given_back(t, options):
    """The picture that they give is the same."""
    t.clip()
    settings, given = reported(t, "clip.avi", *options, "-o", "a.png", "--size", "160x100")
    t.write("back.toml", "".join(f"{name} = '{value}'\n" for name, value in given.items()))
    for back in ([f"--{name}={value}" for name, value in given.items()], ["--config", "back.toml"]):
        check(reported(t, "clip.avi", "-o", "b.png", *back)[0] == settings, f"other settings than {settings}")
        check(t.path("a.png").read_bytes() == t.path("b.png").read_bytes(), f"{back} draws something else")


def test_settings_of_extractions_are_numbers(t):
    t.clip()
    t.vvr("extract", "clip.avi", "-o", "data", "--filter", "temporal", "--solver", "jacobi").expect(0)
    settings = t.json("data/manifest.json")["settings"]
    check((settings["threshold"], settings["alpha"], settings["iterations"]) == ("16", "10", "60"), f"{settings}")
    # What was used may be said again, and nothing else.
    t.render("data", "--threshold", "16", "--alpha", "10").expect(0)
    t.render("data", "--threshold", "17").expect(1, "--threshold 17", "'data'", "16", "`vvr extract`", code="extraction-unsuitable")


def test_presets_set_what_a_command_has(t):
    t.clip()
    t.vvr("extract", "clip.avi", "-o", "usual").expect(0)
    t.vvr("extract", "clip.avi", "-o", "data", "--preset", "paper").expect(0)
    settings = t.json("data/manifest.json")["settings"]
    check((settings["solver"], settings["illumination"]) == ("jacobi", "none") and "preset" not in settings, f"{settings}")
    look = ("--preset", "paper", "--title", "Hall")
    t.render("clip.avi", *look, output="clip.png").expect(0)
    t.render("data", *look, output="data.png").expect(0)
    check(t.rgb("clip.png") == t.rgb("data.png"), "data of the preset give another picture")
    # One error, of all that is not so.
    said = t.render("usual", *look).expect(
        1, "'usual'", "illumination none (extracted: global)", "solver jacobi (extracted: pyramid)",
        "`vvr extract --preset paper`", code="extraction-unsuitable")
    check("there is no option" not in said.err, str(said))
    for command in (("inspect", "clip.avi", "-o", "frame.png"), ("cut", "clip.avi", "-o", "cut.avi", "--start", "0.5s")):
        t.vvr(*command, "--preset", "paper").expect(0)
    said = t.vvr("config", "render", "--preset", "paper").expect(0, out=None).out
    for line in ("solver               jacobi (preset paper)", "preset               paper (preset paper)",
                 "filter               difference (default)"):
        check(line in said, said)
    t.vvr("config", "--preset", "paper").expect(1, "--preset", "COMMAND", code="option-needs-another")


def test_presets_of_config_files(t):
    """The file wins over its preset, and the command line over both."""
    t.clip()
    t.write("vvr.toml", 'preset = "paper"\nfov = 20\nbackground = "none"\n')
    t.render("clip.avi", "--config", "vvr.toml", "--report", "r.json", output=None).expect(0)
    settings = t.json("r.json")["settings"]
    found = [settings[name] for name in ("preset", "solver", "fov", "background")]
    check(found == ["paper", "jacobi", "20", "none"], f"{settings}")
    t.render("clip.avi", "--config", "vvr.toml", "--solver", "pyramid", "--report", "r.json", output=None).expect(0)
    settings = t.json("r.json")["settings"]
    check((settings["solver"], settings["shadows"]) == ("pyramid", "keep"), f"{settings}")
