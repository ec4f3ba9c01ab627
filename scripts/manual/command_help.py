"""A command's options, as `vvr COMMAND --help` lists them: what docs/cli.md, manual pages and completions are made of.

A line of the help that is not understood is an error, so that nothing of it is lost.
"""

import os
import re
import subprocess
from dataclasses import dataclass, field

COLUMN = 30  # where the help of an option begins
VALUE = COLUMN + 2  # where the name of a value begins
VALUE_HELP = VALUE + 15
OPTION = re.compile(r"(?:-(?P<letter>\w), )?--(?P<name>[a-z][a-z-]*)(?: (?P<unit>\S+))?")
LEGEND = "Defaults are in brackets, ranges in parentheses."
FOLDERS = {"DIR"}
FILES = {"FILE", "PATH", "AREA"}


@dataclass
class Option:
    name: str
    letter: str
    unit: str  # what it takes; empty for a flag
    help: str  # with range and default
    values: list = field(default_factory=list)  # of (name, help); the help may be empty
    text: str = ""  # as the help shows it

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
    help: str = ""
    usage: str = ""
    argument: tuple = ()  # name, help; empty if it takes none
    groups: dict = field(default_factory=dict)  # title: options
    units: dict = field(default_factory=dict)  # name: meaning
    unit_text: dict = field(default_factory=dict)  # name: as the help shows it
    examples: list = field(default_factory=list)  # of (command, what it does)

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
    """What a program prints, in lines of 100 columns."""
    return subprocess.run(words, stdout=subprocess.PIPE, check=True, encoding="utf-8", env=os.environ | {"COLUMNS": "100"}).stdout


def parse(name, text):
    """The help of one command."""
    command = Command(name)
    head, *blocks = text.rstrip("\n").split("\n\n")
    command.help = expect(rf"vvr {name}: (.*)", head.replace("\n", " "))[1]
    command.usage = expect(r"Usage: (.*)", blocks.pop(0))[1]
    for block in blocks:
        first, *lines = block.split("\n")
        if first == "Examples:":
            if len(lines) % 2:
                raise ValueError(f"an example of `vvr {name}` has no text of its own: {block!r}")
            command.examples = [(expect(r"  (vvr .*)", line)[1], expect(r"  # (.*)", what)[1])
                                for what, line in zip(lines[::2], lines[1::2])]
        elif first == LEGEND:
            for row in rows_of(lines):
                command.units[row.name], command.unit_text[row.name] = row.help, row.text
        elif first.startswith("  "):
            (row,) = rows_of(block.split("\n"))
            command.argument = (row.name, row.help)
        else:
            title = expect(r"([A-Z][A-Za-z ]*):", first)[1]
            command.groups[title] = [option_of(row) for row in rows_of(lines)]
    return command


def expect(pattern, line):
    found = re.fullmatch(pattern, line)
    if not found:
        raise ValueError(f"the help has a line that is not understood: {line!r}")
    return found


@dataclass
class Row:
    name: str
    help: str
    values: list
    text: str


def rows_of(lines):
    """Names at the left, what they mean at the right, in as many lines as that takes."""
    rows = []
    for line in lines:
        indent = len(line) - len(line.lstrip(" "))
        if indent == 2:
            name, explained = line[2:COLUMN].rstrip(), line[COLUMN:]
            if line[COLUMN - 2:COLUMN] != "  ":
                name, explained = line[2:], ""
            rows.append(Row(name, explained, [], line))
            continue
        if not rows:
            raise ValueError(f"the help has a line that is none of an option: {line!r}")
        row = rows[-1]
        row.text += "\n" + line
        if indent == COLUMN:
            row.help = f"{row.help} {line.strip()}".strip()
        elif indent == VALUE:
            row.values.append(tuple(expect(r"(\S+) +(\S.*)", line[VALUE:]).groups()))
        elif indent == VALUE_HELP and row.values:
            name, explained = row.values.pop()
            row.values.append((name, f"{explained} {line.strip()}"))
        else:
            raise ValueError(f"the help has a line that is none of an option: {line!r}")
    return rows


def option_of(row):
    found = expect(OPTION, row.name)
    if not row.help:
        raise ValueError(f"the help does not say what this does: {row.name!r}")
    option = Option(found["name"], found["letter"] or "", found["unit"] or "", row.help, row.values, row.text)
    add_listed_values(option)
    return option


def add_listed_values(option):
    """The values that no table explains are at the end of the help, as `: blue, grey`."""
    if option.values or option.unit not in ("NAME", "LIST"):
        return
    found = re.search(r": ((?:[a-z][a-z0-9-]*, )+[a-z][a-z0-9-]*)(?:, or a file[a-z ]*)?(?: \[.*\])?$", option.help)
    if not found:
        raise ValueError(f"the help of --{option.name} does not list its values: {option.help!r}")
    option.values = [(name, "") for name in found[1].split(", ")]
