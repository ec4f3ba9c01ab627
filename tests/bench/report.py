"""Writes out/bench/report.md and out/bench/report.json. See scripts/bench, which makes the clips."""

import argparse
import datetime
import json
import os
import pathlib
import platform
import re
import subprocess
import tempfile

import parts
from setting import Setting

HERE = pathlib.Path(__file__).parent
RUNS = 5


def first_line(command):
    """What a program says of itself; nothing where it isn't there."""
    try:
        done = subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    except (OSError, subprocess.CalledProcessError):
        return "not found"
    return done.stdout.partition("\n")[0]


def compiler(build):
    found = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", (build / "CMakeCache.txt").read_text(), re.MULTILINE)
    return first_line([found.group(1), "--version"]) if found else "not found"


def renderer(vvr, backend):
    """Name and version of what a backend draws with: those after its name in what `vvr doctor` prints."""
    doctor = subprocess.run([vvr, "doctor"], check=False, stdout=subprocess.PIPE, text=True).stdout
    name = r"\w+" if backend == "auto" else re.escape(backend)
    found = re.search(rf"^{name} +works.*\n +renderer +(.*)\n +version +(.*)$", doctor, re.MULTILINE)
    return f"{found.group(1)}, OpenGL {found.group(2)}" if found else "not found"


def versions(setting):
    """Of all that is measured or compared with."""
    own = subprocess.run([setting.vvr, "--version"], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
    libraries = dict(line.rsplit(" ", 1) for line in own if re.search(r" \d\S*$", line))
    return {
        "vvr": libraries.pop("vvr", own[0]),
        **libraries,
        "ffmpeg": first_line(["ffmpeg", "-version"]).split(" Copyright")[0].removeprefix("ffmpeg version "),
        "renderer": renderer(setting.vvr, setting.backend),
        "compiler": compiler(setting.build),
    }


def machine(setting):
    """What it ran on."""
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        names = [line.split(":")[1].strip() for line in file if line.startswith("model name")]
    return {
        "date": datetime.date.today().isoformat(),
        "processor": names[0] if names else platform.machine(),
        "cores": os.cpu_count(),
        "memory_gb": round(os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 1e9, 1),
        "system": platform.platform(),
        "load": os.getloadavg()[0],
        "versions": versions(setting),
    }


def introduction(about, given):
    told = about["versions"]
    options = (["--long"] if given.long else []) + ([f"--runs {given.runs}"] if given.runs != RUNS else [])
    return (
        "# Benchmark of vvr\n\n"
        f"`{' '.join(['scripts/bench', *options, *given.parts])}` on {about['date']}, with vvr {told['vvr']}: {about['cores']} cores of "
        f"{about['processor']}, {about['memory_gb']} GB of memory, {about['system']}; the load before it began was {about['load']:.1f}. "
        + ", ".join(f"{name}: {version}" for name, version in told.items() if name != "vvr")
        + f".\n\nWhat is compared runs in turn, {given.runs} times after a first time that isn't counted. Numbers are medians, with the "
        "least and the greatest in brackets. A difference that is smaller than this spread is noise. Trust ratios more than times. "
        "`report.json` has all numbers of all runs.\n"
        + ("" if given.scale == 1 else f"\n**This was only a try**: volumes and pictures were scaled by {given.scale:g}.\n")
    )


def main():
    options = argparse.ArgumentParser(prog="scripts/bench", description=__doc__)
    options.add_argument("parts", nargs="*", metavar="PART", help=f"of {', '.join(parts.PARTS)}; all if none is given")
    options.add_argument("--clip", required=True, help="footage")
    options.add_argument("--runs", type=int, default=RUNS, help="of which medians are taken")
    options.add_argument("--long", action="store_true", help="clips of 1 and 6 hours too")
    options.add_argument("--backend", default="software", help="auto takes a GPU where there is one")
    options.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"), help="where the programs are")
    options.add_argument("--clips", type=pathlib.Path, default=pathlib.Path(".cache/bench"), help="where the clips are that "
                                                                                                  "were made")
    options.add_argument("--out", type=pathlib.Path, default=HERE, help="where the report goes")
    options.add_argument("--scale", type=float, default=1,
                         help="of the volumes and pictures that are drawn; less than 1 only tries whether all works")
    given = options.parse_args()
    unknown = [name for name in given.parts if name not in parts.PARTS]
    if unknown:
        options.error(f"there is no part '{unknown[0]}'; there are {', '.join(parts.PARTS)}")

    with tempfile.TemporaryDirectory() as folder:
        setting = Setting(given.clip, given.runs, given.backend, pathlib.Path(folder), given.build, given.clips, given.long,
                          given.scale)
        about = machine(setting)
        sections, numbers = [introduction(about, given)], {"machine": about}
        for name in given.parts or parts.PARTS:
            print(f"==> bench: {name}", flush=True)
            text, numbers[name] = parts.PARTS[name](setting)
            sections.append(text)
            (given.out / "report.md").write_text("\n".join(sections), encoding="utf-8")
            (given.out / "report.json").write_text(json.dumps(numbers, indent=1), encoding="utf-8")
    print(f"==> the report is in {given.out / 'report.md'}")


if __name__ == "__main__":
    main()
