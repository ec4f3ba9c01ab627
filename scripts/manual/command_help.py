"""A command's options, as `vvr COMMAND --help` lists them: what manual pages and completions are made of.

A line of the help that is not understood is an error, so that nothing of it is lost.
"""

import re
import subprocess
from dataclasses import dataclass, field

COLUMN = 36  # where the help of an option begins
OPTION = re.compile(r"(?:-(?P<letter>\w),)?--(?P<name>[a-z][a-z-]*)(?: (?P<unit>[^ \[]+))?(?: \[(?P<bracket>.*)\])?")
FOLDERS = {"DIR"}
FILES = {"FILE", "PATH", "AREA"}


@dataclass
class Option:
    name: str
    letter: str
    unit: str  # what it takes; empty for a flag
    bracket: str  # default and range; empty if there is neither
    help: str
    values: list = field(default_factory=list)  # of (name, help); the help may be empty

    @property
    def takes_folder(self):
        return self.unit in FOLDERS

    @property
    def takes_file(self):
        return self.unit in FILES or bool(self.values and re.search(r"\bor a (picture )?file\b", self.help))

    @property
    def takes_list(self):
        return self.unit == "LIST"


@dataclass
class Command:
    name: str
    help: str
    usage: str
    arguments: list = field(default_factory=list)  # of (name, help)
    groups: dict = field(default_factory=dict)  # title: options

    def options(self):
        return [option for options in self.groups.values() for option in options]


def read_commands(vvr):
    """Every command of the program."""
    rows = re.findall(r"^  vvr (\S+) +(\S.*)$", say(vvr, "--help"), flags=re.MULTILINE)
    if not rows:
        raise ValueError("`vvr --help` lists no commands")
    return [parse(name, say(vvr, name, "--help")) for name, _ in rows]


def read_version(vvr):
    return say(vvr, "--version").split()[1]


def say(*words):
    return subprocess.run(words, stdout=subprocess.PIPE, check=True, encoding="utf-8").stdout


def parse(name, text):
    """The help of one command."""
    lines = text.splitlines()
    command = Command(name, lines[0], lines[1].removeprefix("Usage: "))
    target = None  # where the next lines belong: arguments, a group's options, or an option's values
    rest = lines[2:]
    while rest:
        line = rest.pop(0)
        if not line:
            continue
        if line == "Positionals:":
            target = command.arguments
        elif heading := re.fullmatch(r"([A-Z][A-Za-z ]*):", line):
            target = command.groups.setdefault(heading[1], [])
        elif value_of := re.fullmatch(r"--([a-z-]+)", line):
            target = next(option for option in command.options() if option.name == value_of[1]).values
        elif line.startswith("  --") or re.match(r"  -\w,--", line):
            target.append(parse_option(line, rest))
        elif target is command.arguments and line[2] != " ":
            command.arguments.append((line[:COLUMN].strip(), line[COLUMN:]))
        elif target is not None and (row := re.fullmatch(r"  (\S+) +(\S.*)", line)):
            target.append((row[1], row[2]))
        else:
            raise ValueError(f"the help of `vvr {name}` has a line that is none of an option: {line!r}")
    for option in command.options():
        add_listed_values(option)
    return command


def parse_option(line, rest):
    """One option; takes the next line too where its help stands there."""
    named, explained = line[:COLUMN], line[COLUMN:]
    if rest and rest[0].startswith(" " * COLUMN):
        named, explained = line, rest.pop(0).strip()
    found = OPTION.fullmatch(named.strip())
    if not found or not explained:
        raise ValueError(f"not understood as an option with its help: {line!r}")
    return Option(found["name"], found["letter"] or "", found["unit"] or "", found["bracket"] or "", explained)


def add_listed_values(option):
    """The values that no table explains stand at the end of the help, as `: text, json`."""
    if option.values or option.unit not in ("NAME", "LIST"):
        return
    found = re.search(r": ((?:[a-z][a-z0-9-]*, )+[a-z][a-z0-9-]*)(?:, or a file[a-z ]*)?$", option.help)
    if not found:
        raise ValueError(f"the help of --{option.name} does not list its values: {option.help!r}")
    option.values = [(name, "") for name in found[1].split(", ")]
