"""Runs programs in turn and times them."""

import json
import os
import statistics
import subprocess
import sys
import time
from dataclasses import dataclass


@dataclass
class Run:
    seconds: float
    megabytes: float  # the most that it held
    processor: float  # seconds of all cores, its children's too


def run(command):
    begin = time.monotonic()
    child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        sys.exit(f"bench: {' '.join(command)} ended with {child.returncode}")
    return Run(time.monotonic() - begin, usage.ru_maxrss / 1024, usage.ru_utime + usage.ru_stime)


def in_turn(commands, runs):
    """All commands once for the caches, then in turn. Returns lists of Runs by the commands' names."""
    for command in commands.values():
        run(command)
    results = {name: [] for name in commands}
    for _ in range(runs):
        for name, command in commands.items():
            results[name].append(run(command))
    return results


def output_of(command):
    """The JSON that a program prints."""
    return json.loads(subprocess.run(command, check=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE).stdout)


def median(values):
    return statistics.median(values)


def spread(values, digits=2):
    """Median and range, for people."""
    return f"{median(values):.{digits}f} ({min(values):.{digits}f} to {max(values):.{digits}f})"


def ratios(ones, others):
    """Of what ran in turn, turn by turn: what slows one turn slows both sides of it."""
    return [one / other for one, other in zip(ones, others)]


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines) + "\n"
