"""What `vvr COMMAND --help` says is so: width, options, values and examples."""

import os
import pathlib
import re
import shlex

import jsonschema
import pytest
from harness import check, nightly_except
from schemas import closed, follows, schema_of

TABLE = pathlib.Path(__file__).resolve().parents[2] / "cli" / "commands" / "command.h"
COMMANDS = re.findall(r'CommandRow\{"(\w+)"', TABLE.read_text(encoding="utf-8"))


def help_of(t, command, columns="100"):
    return t.vvr(command, "--help", env=os.environ | {"COLUMNS": columns}).expect(0, out=None).out


def test_help_lists_every_command(t):
    check(re.findall(r"^  vvr (\w+)", t.vvr("--help").out, flags=re.MULTILINE) == COMMANDS, "other commands than the table")
    check(list(t.help()) == COMMANDS, "other commands than the table")


def test_help_as_json_follows_its_schema(t):
    schema = closed(schema_of(t, "help"))
    found = t.vvr("help", "--json").expect(0, out=None).json()
    follows(found, schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({**found, "commands": []}, schema)
    check(f"vvr {found['vvr']}" == t.vvr("--version").out.splitlines()[0], found["vvr"])
    check({option["group"] for command in found["commands"] for option in command["options"]} <= set(found["groups"]), "groups")
    for wrong in (["help", "--jason"], ["help", "render", "--json"], ["help", "--json", "render"]):
        t.vvr(*wrong).expect(1)


def shown(option):
    """An option as --help shows it, without spaces: names, help, range, default, choices."""
    text = (f"-{option['short']}," if option["short"] else "") + f"--{option['name']}" + (option["value"] or "") + option["help"]
    if option["range"]:
        unit = "s" if option["value"] == "TIME" else ""
        text += f"({option['range']['low']}{unit}to{option['range']['high']}{unit})"
    text += f"[{option['default']}]" if option["default"] else ""
    return re.sub(r"\s", "", text + "".join(choice["name"] + choice["help"] for choice in option["choices"]))


@pytest.mark.parametrize("command", COMMANDS)
def test_help_and_its_json_have_the_same_options(t, command):
    text = help_of(t, command).partition("\nDefaults are in brackets")[0]
    blocks = re.split(r"\n(?:\n[A-Z][A-Za-z ]*:\n)?(?=  -)", text)[1:]  # one per option
    found = [re.sub(r"\s", "", block) for block in blocks]
    expected = [shown(option) for option in t.help()[command]["options"]]
    check(len(expected) > 5 and found == expected, f"{set(found) ^ set(expected)}")


@pytest.mark.nightly
def test_help_is_as_wide_as_the_terminal(t):
    for command in COMMANDS:
        for columns in (72, 120):
            text, examples, _ = help_of(t, command, str(columns)).partition("\nExamples:")
            long = [line for line in text.splitlines() if len(line) > columns]
            check(examples and not long, f"{command}, {columns} columns: {long}")


def sample(option):
    """Values that the help says an option takes."""
    if option["choices"]:
        return [choice["name"] for choice in option["choices"]]
    if option["range"] and option["value"] not in ("IN:OUT", "WxH"):
        return [str(option["range"][end]) + ("s" if option["value"] == "TIME" else "") for end in ("low", "high")]
    return {
        None: [None], "TIME": ["1s"], "TIME-TIME": ["02:00-05:00"], "WxH": ["64x48"], "W:H": ["16:9"], "IN:OUT": ["0.4:1"], "AZIMUTH,ELEVATION": ["0,46"], "COLOR": ["#ffffff"],
        "TEXT": ["Hall"], "DATETIME": ["2026-11-21 08:00:00"], "AREA": ["0,0 9,0 9,9"], "HOW": ["first:2"], "DIGITS": ["10"],
        "PATTERN": ["{camera}-%s"], "GLOB": ["*.mp4"], "I/N": ["1/2"], "BYTES": ["2G"], "COUNT": ["2"], "PATH": [], "HH:MM": ["12:00"], "AGE": ["30d"],
        "FILE": [], "DIR": [], "MODEL": [],  # have to be there
    }[option["value"]]


# Options that exclude some of the others: each is given alone.
APART = ("--verbose", "--animate", "--slide", "--end", "--window", "--log-format")

TOGETHER = {  # options that are for other outputs, or go with others
    "--animate": ["-o", "out.mp4", "--show", "volume,tracelines"], "--slide": ["-o", "out.mp4"], "--bless": ["--golden", "golden.png"],
    "--write": ["-o", "out"], "--day-begins": ["--per", "day"],
    "--filter": ["--color", "transfer"], "--filter=given": ["--color", "transfer", "--field", "fields"],
    "--color": ["--flow", "dis"], "--reference": [],
}


def what_it_needs(t, command):
    """What gets a command as far as its input, as its first example has it: all behind the input. None: it takes none."""
    words = next(shlex.split(example["command"]) for example in t.help()[command]["examples"]
                 if example["command"].startswith(f"vvr {command}"))
    return words[3:] if len(words) > 2 else None


@pytest.mark.parametrize("command", nightly_except(COMMANDS, "golden"))
def test_help_lists_only_what_the_command_accepts(t, command):
    example = what_it_needs(t, command)
    if example is None:
        return
    t.clip()
    t.path("fields").mkdir()
    t.write("fields/000000.png", "")
    missing = "missing" if command == "archive" else "missing.avi"
    # What render has in the same words is looked at there.
    commands = t.help()
    shared = [] if command in ("render", "watch") else commands["render"]["options"]
    # Golden compares always; what the margin of an archive is added to are pieces.
    together = TOGETHER | {"golden": {"--bless": []}, "archive": {"--margin": ["--keep-events"]}}.get(command, {})
    rounds = []  # of options that are given together, each with one value
    for option in commands[command]["options"]:
        name = option["name"]
        if option in shared or name in ("help", "version", "config", "camera-name", "log-file"):
            continue
        for number, value in enumerate(sample(option)):
            if number == len(rounds):
                rounds.append([])
            rounds[number].append([f"--{name}" if value is None else f"--{name}={value}"])

    def check_accepted(options):
        """All at once, or, as some exclude each other, one half after the other."""
        beside = [word for option, in options for word in together.get(option, together.get(option.partition("=")[0], []))]
        needs = [] if "-o" in beside else example  # a run has one -o
        done = t.vvr(command, missing, *needs, *beside, *(option for option, in options))
        # --write index reads no clips.
        if done.status == 0 or (done.status == 2 and "missing" in done.err):
            return
        check(len(options) > 1, f"{done}\nthe help lists what is refused")
        check_accepted(options[:len(options) // 2])
        check_accepted(options[len(options) // 2:])

    for options in rounds:
        alone = [[option] for option in options if option[0].partition("=")[0] in APART]
        for some in (*alone, [option for option in options if [option] not in alone]):
            if some:
                check_accepted(some)


def test_watch_help_has_no_options_that_need_an_end(t):
    options = {option["name"]: option for option in t.help()["watch"]["options"]}
    check(not options.keys() & {"start", "end", "time"}, f"{options.keys()}")
    choices = {name: [choice["name"] for choice in options[name]["choices"]] for name in ("preset", "reference")}
    check(choices == {"preset": ["paper"], "reference": ["first", "running"]}, f"{choices}")
    check("recorded" not in options["start-time"]["help"], str(options["start-time"]))
    for arguments, text in [
        (["--start", "3s"], "--start: a stream begins now"), (["--end=3s"], "--end: --duration ends a stream"),
        (["--time", "busy"], "--time: the pictures of a stream share one scale of time"),
        (["--preset", "day"], "--preset: 'day' is unknown"),
    ]:
        t.vvr("watch", "clip.avi", "-o", "out.png", *arguments).expect(1, text)


HERE = {"rtsp://camera/stream": "live.avi", "--duration 8h": "--duration 9s"}


@pytest.mark.parametrize("command", nightly_except(COMMANDS, "render"))
def test_examples_of_help_run(t, command):
    t.clip("clip.avi", seconds=3)
    if command in ("cut", "watch") or "bag.y4m" in str(t.help()[command]["examples"]):
        t.scene("left_bag", "bag.y4m", "--size", "96x72", "--frames", "400")
    for place in ("clips/door.avi", "recordings/2026-11-21/08/gate/00.10.avi"):
        t.clip(place, seconds=1)
    if command == "cut":
        t.ffmpeg("-i", "bag.y4m", "-c:v", "mpeg4", "-g", "25", "clip.avi")
    if command == "watch":
        t.ffmpeg("-i", "bag.y4m", "-c:v", "mpeg4", "-g", "25", "live.avi")
    if command == "compare":
        for picture in ("golden.png", "out.png"):
            t.render("clip.avi", output=picture).expect(0)
    if command == "golden":
        t.write("tests/golden/golden.toml", '[hall]\ninput = "../../clip.avi"\nsize = "160x100"\n')
        t.vvr("golden", "tests/golden", "--bless").expect(0)
    t.write("small.toml", 'size = "160x100"\n')
    environment = t.put_on_path() | {"VVR_CONFIG": str(t.path("small.toml"))}
    examples = t.help()[command]["examples"]
    check(examples, f"vvr {command} --help has no examples")
    for line in (example["command"] for example in examples):
        for there, here in HERE.items():
            line = line.replace(there, here)
        t.run(["bash", "-euc", line], env=environment).expect(0, out=None)
