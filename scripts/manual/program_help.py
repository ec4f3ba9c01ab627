"""The help of the program, as `vvr help --json` prints it; docs/help.schema.json describes it."""

import json
import subprocess


def read_help(vvr):
    return json.loads(subprocess.run([vvr, "help", "--json"], stdout=subprocess.PIPE, check=True).stdout)


def names_of(option):
    return ([f"-{option['short']}"] if option["short"] else []) + [f"--{option['name']}"]


def text_of(option):
    """The help of an option with its range and default."""
    text = option["help"]
    if option["range"]:
        unit = "s" if option["value"] == "TIME" else ""
        text += f" ({option['range']['low']}{unit} to {option['range']['high']}{unit})"
    return text + (f" [{option['default']}]" if option["default"] else "")


def usage_of(command):
    return " ".join(["vvr", command["name"]] + ([command["arguments"]["name"]] if command["arguments"] else []) + ["[OPTIONS]"])


def by_group(options):
    """The options of each group, by its title."""
    groups = {}
    for option in options:
        groups.setdefault(option["group"], []).append(option)
    return groups
