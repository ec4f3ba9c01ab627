"""Writes bench/report.md, bench/report.json and the plots beside them. See scripts/bench, which makes the clips."""

import argparse
import datetime
import json
import os
import pathlib
import platform
import subprocess
import tempfile

import parts

HERE = pathlib.Path(__file__).parent


def machine():
    """What it ran on."""
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        names = [line.split(":")[1].strip() for line in file if line.startswith("model name")]
    version = subprocess.run(["build/release/cli/vvr", "--version"], check=True, stdout=subprocess.PIPE, text=True)
    return {
        "date": datetime.date.today().isoformat(),
        "vvr": version.stdout.splitlines()[0],
        "processor": names[0] if names else platform.machine(),
        "cores": os.cpu_count(),
        "system": platform.platform(),
        "load": os.getloadavg()[0],
    }


def introduction(about, runs):
    return (
        "# Benchmark\n\n"
        f"{about['vvr']}, {about['date']}, on {about['cores']} cores of {about['processor']}, {about['system']}; the load "
        f"before it began was {about['load']:.1f}.\n\n"
        f"`scripts/bench` makes this. What is compared runs in turn, {runs} times after a first time that isn't counted, so "
        "that what else the machine does meets all alike. Numbers are medians, with the least and the greatest in "
        "brackets. Where a ratio is given, trust it more than the times.\n"
    )


def main():
    options = argparse.ArgumentParser(prog="scripts/bench", description=__doc__)
    options.add_argument("parts", nargs="*", metavar="PART", help=f"of {', '.join(parts.PARTS)}; all if none is given")
    options.add_argument("--clip", required=True, help="footage")
    options.add_argument("--runs", type=int, default=5)
    options.add_argument("--long", action="store_true", help="the clip of 6 hours too")
    options.add_argument("--backend", default="software", help="auto takes a GPU where there is one")
    given = options.parse_args()
    unknown = [name for name in given.parts if name not in parts.PARTS]
    if unknown:
        options.error(f"there is no part '{unknown[0]}'; there are {', '.join(parts.PARTS)}")

    about = machine()
    sections, numbers = [introduction(about, given.runs)], {"machine": about}
    with tempfile.TemporaryDirectory() as folder:
        setting = parts.Setting(given.clip, given.runs, given.backend, pathlib.Path(folder), HERE, given.long)
        for name in given.parts or parts.PARTS:
            print(f"==> bench: {name}", flush=True)
            text, numbers[name] = parts.PARTS[name](setting)
            sections.append(text)
            (HERE / "report.md").write_text("\n".join(sections), encoding="utf-8")
            (HERE / "report.json").write_text(json.dumps(numbers, indent=1), encoding="utf-8")
    print(f"==> the report is in {HERE / 'report.md'}")


if __name__ == "__main__":
    main()
