"""What `vvr COMMAND --help` says is so: width, options, values and examples."""

import os
import pathlib
import re
import shlex
import sys

import pytest
from harness import check

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts" / "manual"))
from command_help import parse, read_commands  # noqa: E402

TABLE = pathlib.Path(__file__).resolve().parents[2] / "cli" / "commands" / "command.h"
COMMANDS = re.findall(r'CommandRow\{"(\w+)"', TABLE.read_text(encoding="utf-8"))


def help_of(t, command, columns="100"):
    return t.vvr(command, "--help", env=os.environ | {"COLUMNS": columns}).expect(0, out=None).out


def test_help_lists_every_command(t):
    check([command.name for command in read_commands(t.vvr_path)] == COMMANDS, "the help has other commands than the table")


def test_help_is_as_wide_as_the_terminal(t):
    for columns in ("72", "80", "120"):
        for command in COMMANDS:
            text, examples, _ = help_of(t, command, columns).partition("\nExamples:")
            check(examples, f"vvr {command} --help has no examples")
            long = [line for line in text.splitlines() if len(line) > int(columns)]
            check(not long, f"{command}, {columns} columns: {long}")


def sample(option):
    """Values that the help says an option takes."""
    if option.values:
        return [name for name, _ in option.values]
    found = re.search(r"\(([-\d.]+)s? to ([-\d.]+)s?\)", option.help)
    if found and option.unit not in ("IN:OUT", "WxH"):
        return [end + ("s" if option.unit == "TIME" else "") for end in found.groups()]
    return {
        "": [None], "TIME": ["1s"], "TIME-TIME": ["02:00-05:00"], "WxH": ["64x48"], "IN:OUT": ["0.4:1"], "AZIMUTH,ELEVATION": ["0,46"], "COLOR": ["#ffffff"],
        "TEXT": ["Hall"], "DATETIME": ["2026-11-21 08:00:00"], "AREA": ["0,0 9,0 9,9"], "HOW": ["first:2"], "DIGITS": ["10"],
        "PATTERN": ["{camera}-%s"], "GLOB": ["*.mp4"], "I/N": ["1/2"], "BYTES": ["2G"], "COUNT": ["2"], "PATH": [],
        "FILE": [], "DIR": [], "MODEL": [],  # have to be there
    }[option.unit]


TOGETHER = {  # options that are for other outputs, or go with others
    "--animate": ["-o", "out.mp4", "--show", "volume,tracelines"], "--slide": ["-o", "out.mp4"], "--bless": ["--golden", "golden.png"],
    "--write": ["-o", "out"],
    "--filter": ["--color", "transfer"], "--color": ["--flow", "dis"], "--reference": [],
}


def what_it_needs(t, command):
    """What gets a command as far as its input, as its first example has it: all behind the input. None: it takes none."""
    words = next(shlex.split(line) for line, _ in parse(command, help_of(t, command)).examples if line.startswith(f"vvr {command}"))
    return words[3:] if len(words) > 2 else None


@pytest.mark.parametrize("command", COMMANDS)
def test_help_lists_only_what_the_command_accepts(t, command):
    example = what_it_needs(t, command)
    if example is None:
        return
    t.clip()
    missing = "missing" if command == "archive" else "missing.avi"
    # What render has in the same words is looked at there.
    shared = {} if command in ("render", "watch") else {option.text for option in parse("render", help_of(t, "render")).options()}
    rounds = []  # of options that are given together, each with one value
    for option in parse(command, help_of(t, command)).options():
        if option.text in shared or option.name in ("help", "version", "config", "log-file"):
            continue
        for number, value in enumerate(sample(option)):
            if number == len(rounds):
                rounds.append([])
            rounds[number].append([f"--{option.name}" if value is None else f"--{option.name}={value}"])

    def check_accepted(options):
        """All at once, or, as some exclude each other, one half after the other."""
        beside = [word for option, in options for word in TOGETHER.get(option.partition("=")[0], [])]
        needs = [] if "-o" in beside else example  # a run has one -o
        done = t.vvr(command, missing, *needs, *beside, *(option for option, in options))
        # --write index reads no clips.
        if done.status == 0 or (done.status == 2 and "missing" in done.err):
            return
        check(len(options) > 1, f"{done}\nthe help lists what is refused")
        check_accepted(options[:len(options) // 2])
        check_accepted(options[len(options) // 2:])

    for options in rounds:
        check_accepted(options)


def test_watch_help_has_no_options_that_need_an_end(t):
    options = {option.name: option for option in parse("watch", help_of(t, "watch")).options()}
    check(not options.keys() & {"start", "end", "time"}, f"{options.keys()}")
    check([name for name, _ in options["preset"].values] == ["paper"], str(options["preset"]))
    check([name for name, _ in options["reference"].values] == ["first", "running"], str(options["reference"]))
    check("recorded" not in options["start-time"].help, str(options["start-time"]))


def test_times_are_written_alike_everywhere(t):
    t.clip(seconds=3)
    told = {t.vvr("inspect", "clip.avi", "--frame", time, "-o", "frame.png").expect(0).err for time in ("1s", "10f", "00:00:01", "0m1s")}
    check(len(told) == 1, f"{told}")
    t.vvr("watch", "missing.avi", "-o", "out.png", "--patience", "1m").expect(2, code="file-not-found")
    t.vvr("watch", "missing.avi", "-o", "out.png", "--patience", "2h").expect(1, "--patience", "'2h'", code="option-value-out-of-range")
    t.vvr("watch", "missing.avi", "-o", "out.png", "--patience", "20f").expect(1, "--patience", "'20f'", code="option-value")
    t.vvr("cut", "clip.avi", "-o", "piece.avi", "--start", "5").expect(1, "--start", "5f", "5s", code="option-value")
    t.render("clip.avi", "--start-time", "00:00:01").expect(1, "--start", code="option-value")


HERE = {"rtsp://camera/stream": "live.avi", "--duration 8h": "--duration 9s"}


@pytest.mark.parametrize("command", COMMANDS)
def test_examples_of_help_run(t, command):
    t.clip("clip.avi", seconds=3)
    t.scene("left_bag", "bag.y4m", "--size", "96x72", "--frames", "400")
    for folder in ("clips", "recordings/2026-11-21/08/gate", "bin"):
        t.path(folder).mkdir(parents=True)
    for place in ("clips/door.avi", "recordings/2026-11-21/08/gate/00.10.avi"):
        t.clip(place, seconds=1)
    t.path("bin/vvr").symlink_to(t.vvr_path)
    if command == "cut":
        t.ffmpeg("-i", "bag.y4m", "-c:v", "mpeg4", "-g", "25", "clip.avi")
    if command == "watch":
        t.ffmpeg("-i", "bag.y4m", "-c:v", "mpeg4", "-g", "25", "live.avi")
    if command == "compare":
        for picture in ("golden.png", "out.png"):
            t.render("clip.avi", output=picture).expect(0)
    examples = parse(command, help_of(t, command)).examples
    check(examples, f"vvr {command} --help has no examples")
    for line, _ in examples:
        for there, here in HERE.items():
            line = line.replace(there, here)
        done = t.run(["bash", "-euc", line], env=os.environ | {"PATH": f"{t.path('bin')}:{os.environ['PATH']}"})
        check(done.status == 0, str(done))
