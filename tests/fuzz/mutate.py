#!/usr/bin/python3
"""Damages clips, data folders and archives in a thousand ways, and looks at what vvr does with each.

    tests/fuzz/mutate.py --vvr build/release/cli/vvr --count 200 --seed 1 --report mutated

Input K of a seed is the same each time, so `--only K` does one again. A finding is: a signal, a status that the docs do
not have for such an input, more than 20 seconds, a file that is not whole, or one that should not be there. Findings
keep their input below `--keep`; the exit status is 1 if there are any.
"""

import argparse
import collections
import json
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, field
from typing import Callable

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
from harness import lock_name  # noqa: E402

HANG = 20  # seconds
BUSY = 10  # so many times as long a run may take that was only waiting for a processor
MEMORY = 6 * 2**30  # address space; the software rasteriser reserves much more than it uses
FILE_SIZE = 2**28
PROCESSES = 2048

# The statuses that docs/cli.md has for an input that is damaged: no usage, no backend, no bug.
OF_A_CLIP = {0, 3, 5}
OF_DATA = {0, 2, 3, 5}
OF_A_FILE = {0, 1, 2, 3, 5}
OF_AN_ARCHIVE = {0, 6}

SMALL = ["--size", "64x40", "--backend", "software", "--quiet", "--threads", "1"]
SOURCE = ["-f", "lavfi", "-i", "testsrc2=size=64x48:rate=10:duration=0.8"]


@dataclass
class Kind:
    """What is damaged, and what vvr is asked to do with it. Commands run in the folder of the input."""
    name: str
    make: Callable[[pathlib.Path, str], None]  # fills a folder with what is whole; also gets the program
    may_break: str  # a glob: which files are damaged
    commands: list[list[str]]
    allowed: set[int]
    outputs: list[str] = field(default_factory=list)  # files that a command may leave, beside those of the input


def ffmpeg(folder, *arguments):
    subprocess.run(["ffmpeg", "-v", "error", "-y", *SOURCE, *arguments], cwd=folder, check=True, stdin=subprocess.DEVNULL)


def clip(name, *codec):
    """A kind of one clip, which is rendered and described."""
    return Kind(name, lambda folder, _: ffmpeg(folder, *codec, f"clip.{name.split('-')[0]}"), "clip.*",
                [["render", f"clip.{name.split('-')[0]}", "-o", "out.png", *SMALL],
                 ["info", f"clip.{name.split('-')[0]}"]], OF_A_CLIP, ["out.png"])


def pictures(folder, _):
    (folder / "frames").mkdir()
    ffmpeg(folder, "frames/%03d.png")


def data(folder, vvr):
    ffmpeg(folder, "-c:v", "mpeg4", "clip.avi")
    subprocess.run([vvr, "extract", "clip.avi", "-o", "data", "--quiet"], cwd=folder, check=True)
    (folder / "clip.avi").unlink()


def archive(folder, vvr):
    (folder / "in").mkdir()
    for name in ("one", "two"):
        ffmpeg(folder, "-c:v", "mpeg4", f"in/{name}.avi")
        os.utime(folder / f"in/{name}.avi", (1, 1))  # clips that were just written wait
    subprocess.run([vvr, "archive", "in", "-o", "out", *SMALL], cwd=folder, check=True)
    # The claim of a program that was killed before it had written anything.
    (folder / "out" / lock_name("gone.avi")).write_text("gone.avi")


def settings(folder, _):
    ffmpeg(folder, "-c:v", "mpeg4", "clip.avi")
    ffmpeg(folder, "-frames:v", "1", "set-mask.png")
    (folder / "set-config.toml").write_text('size = "64x40"\ntitle = "A title"\nmin-area = 2\n[render]\nfilter = "difference"\n')
    (folder / "set-transfer.txt").write_text("# value red green blue opacity\n12 0.1 0.2 0.3 0\n255, 1, 1, 1, 0.9\n")
    (folder / "set-seeds.txt").write_text("vvr-seeds 1\nframe 3\nsize 64 48\npoints 2\n10 10 1.5 0.5 1\n20 20 -1 0 01\n")


FILES = ["--mask", "set-mask.png", "--config", "set-config.toml", "--transfer", "set-transfer.txt", "--seeds", "set-seeds.txt"]

KINDS = [
    clip("avi", "-c:v", "mpeg4", "-g", "4"),
    clip("mkv", "-c:v", "libx264", "-g", "4"),
    clip("mp4", "-c:v", "libx264", "-g", "4"),
    clip("mp4-fragments", "-c:v", "libx264", "-g", "4", "-movflags", "frag_keyframe+empty_moov"),
    clip("mp4-hevc", "-c:v", "libx265", "-x265-params", "log-level=none"),
    clip("ts", "-c:v", "libx264", "-g", "4"),
    clip("webm", "-c:v", "libvpx", "-deadline", "realtime"),
    clip("mjpeg", "-c:v", "mjpeg"),
    clip("y4m"),
    clip("gif"),
    clip("mpg", "-c:v", "mpeg2video", "-r", "25"),
    clip("flv", "-c:v", "flv1"),
    clip("wmv", "-c:v", "wmv2"),
    clip("mov-prores", "-c:v", "prores"),
    Kind("pictures", pictures, "frames/*", [["render", "frames", "-o", "out.png", *SMALL], ["info", "frames"]], OF_A_CLIP,
         ["out.png"]),
    Kind("data", data, "data/*", [["render", "data", "-o", "out.png", *SMALL]], OF_DATA, ["out.png"]),
    Kind("archive", archive, "out/*", [["archive", "-o", "out", "--write", "index"],
                                       ["archive", "in", "-o", "out", "--dry-run", *SMALL]],
         OF_AN_ARCHIVE),
    Kind("settings", settings, "set-*", [["render", "clip.avi", "-o", "out.png", *SMALL, *FILES]], OF_A_FILE, ["out.png"]),
]


# How bytes are damaged ----------------------------------------------------------------------------------------------

def place(chance, size):
    """Where: headers are the more interesting half."""
    return chance.randrange(min(size, chance.choice([64, 512, size, size])))


def flip(chance, bytes_):
    for _ in range(chance.choice([1, 1, 2, 8, 64])):
        bytes_[place(chance, len(bytes_))] ^= 1 << chance.randrange(8)


def scribble(chance, bytes_):
    begin = place(chance, len(bytes_))
    end = min(len(bytes_), begin + chance.choice([1, 4, 16, 256]))
    bytes_[begin:end] = chance.randbytes(end - begin)


def number(chance, bytes_):
    """A count or a length that can't be."""
    begin = place(chance, len(bytes_))
    value = chance.choice([0, 1, 0x7F, 0xFF, 0x7FFF, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF])
    bytes_[begin:begin + 4] = value.to_bytes(4, chance.choice(["little", "big"]))


def digits(chance, bytes_):
    """For texts: another number, sign, bracket or word."""
    begin = place(chance, len(bytes_))
    bytes_[begin:begin + chance.choice([0, 1, 4])] = chance.choice(
        [b"-", b"1e300", b"99999999999999999999", b"nan", b"[" * 300, b"{", b"\"", b"\0", b"../", b"\xff", b"\x1b[2J", b"null"])


def cut(chance, bytes_):
    del bytes_[place(chance, len(bytes_)):]


def remove(chance, bytes_):
    begin = place(chance, len(bytes_))
    del bytes_[begin:begin + chance.choice([1, 4, 100, 1000])]


def repeat(chance, bytes_):
    begin = place(chance, len(bytes_))
    part = bytes_[begin:begin + chance.choice([1, 16, 188, 1000])]
    bytes_[begin:begin] = part * chance.choice([1, 2, 50])


def swap(chance, bytes_):
    size = chance.choice([4, 188, 1000])
    a, b = sorted((place(chance, len(bytes_)), place(chance, len(bytes_))))
    first, second = bytes_[a:a + size], bytes_[b:b + size]
    bytes_[b:b + size] = first
    bytes_[a:a + size] = second


WAYS = [flip, flip, scribble, number, digits, cut, remove, repeat, swap]


def damage(chance, file):
    content = bytearray(file.read_bytes())
    for _ in range(chance.choice([1, 1, 1, 2, 5])):
        if content:
            chance.choice(WAYS)(chance, content)
    if chance.random() < 0.01:
        content.clear()
    file.write_bytes(content)


# What vvr makes of it -----------------------------------------------------------------------------------------------

def limit():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_FSIZE, (FILE_SIZE, FILE_SIZE))
    resource.setrlimit(resource.RLIMIT_CPU, (HANG, HANG + 1))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_NPROC, (PROCESSES, PROCESSES))


def status_of(vvr, command, folder, spool):
    """The exit status, and what was said; None for a hang: 20 seconds of a processor, or ten times that of waiting."""
    environment = os.environ | {"VVR_CONFIG": "", "TMPDIR": str(spool), "LP_NUM_THREADS": "0"}
    try:
        done = subprocess.run([vvr, *command], cwd=folder, env=environment, stdin=subprocess.DEVNULL, capture_output=True,
                              timeout=BUSY * HANG, preexec_fn=limit, check=False)
    except subprocess.TimeoutExpired:
        return None, ""
    status = None if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL) else done.returncode
    return status, done.stderr.decode(errors="replace")


def listing(folder):
    return {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}


def is_whole(picture):
    content = picture.read_bytes()
    return content.startswith(b"\x89PNG") and content.endswith(b"IEND\xaeB`\x82")


def findings_of(kind, command, status, said, folder, before, spool):
    if status is None:
        yield "hang"
        return
    if status < 0:
        yield f"signal {-status}"
    elif status not in kind.allowed:
        yield f"status {status}"
    if status != 0 and not said.strip():
        yield "no word"
    if "a bug in vvr" in said or any(ord(c) < 32 and c != "\n" for c in said):
        yield "words"
    after = listing(folder)
    for name in before - after:
        if not pathlib.Path(name).name.startswith(".vvr-"):
            yield f"removed {name}"
    left = after - before
    wanted = {name for name in kind.outputs if status == 0 and name in command}
    for name in left - wanted:
        # The index of an archive is written anew; the claim that was left behind may be gone.
        if kind.name != "archive" or pathlib.Path(name).name.startswith(".vvr-"):
            yield f"left {name}"
    for name in wanted:
        if name not in left or not is_whole(folder / name):
            yield f"partial {name}"
    if any(spool.iterdir()):
        yield "left in TMPDIR"


def try_one(vvr, kind, whole, number_, seed, work):
    """Damages one input. Gives the status of each command, and findings."""
    chance = random.Random(f"{seed}:{number_}")
    folder, spool = work / "input", work / "spool"
    for path in (folder, spool):
        shutil.rmtree(path, ignore_errors=True)
    shutil.copytree(whole, folder)
    spool.mkdir()
    files = sorted(path for path in folder.glob(kind.may_break) if path.is_file())
    deeper = sorted(path for path in folder.glob(kind.may_break + "/*") if path.is_file())
    for _ in range(chance.choice([1, 1, 3])):
        damage(chance, chance.choice(files if not deeper or chance.random() < 0.5 else deeper))
    statuses, findings = [], []
    for command in kind.commands:
        before = listing(folder)
        status, said = status_of(vvr, command, folder, spool)
        statuses.append(status)
        found = list(findings_of(kind, command, status, said, folder, before, spool))
        findings += [{"number": number_, "kind": kind.name, "command": command, "finding": text, "said": said[-500:]}
                     for text in found]
        for name in kind.outputs:
            (folder / name).unlink(missing_ok=True)
    return statuses, findings


def check_whole(vvr, kind, work):
    """What is not damaged has to pass: else a kind would test nothing."""
    folder, spool = work / "input", work / "spool"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(work / kind.name, folder)
    spool.mkdir(exist_ok=True)
    for command in kind.commands:
        status, said = status_of(vvr, command, folder, spool)
        if status != 0:
            sys.exit(f"{kind.name}, not damaged: {' '.join(command)}: status {status}: {said}")


def write_report(path, summary):
    pathlib.Path(path + ".json").write_text(json.dumps(summary, indent=2) + "\n")
    columns = sorted({status for counts in summary["by_kind"].values() for status in counts}, key=str)
    rows = [f"| {kind} | " + " | ".join(str(counts.get(status, 0)) for status in columns) + " |"
            for kind, counts in summary["by_kind"].items()]
    pathlib.Path(path + ".md").write_text("\n".join([
        f"{summary['inputs']} damaged inputs, {summary['runs']} runs, {summary['seconds']:.0f} s, seed {summary['seed']}, "
        f"{len(summary['findings'])} findings.", "", f"`{summary['command']}`", "",
        "| kind | " + " | ".join(f"status {status}" for status in columns) + " |", "|" + "---|" * (len(columns) + 1), *rows,
        ""]))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--vvr", default="build/release/cli/vvr")
    parser.add_argument("--count", type=int, default=100, help="inputs, of all kinds in turn")
    parser.add_argument("--seconds", type=float, help="end after this time")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="this input alone")
    parser.add_argument("--kind", action="append", choices=[kind.name for kind in KINDS], help="this kind alone")
    parser.add_argument("--keep", default="", help="folder for inputs with findings")
    parser.add_argument("--report", default="", help="writes REPORT.json and REPORT.md")
    return parser.parse_args()


def main():
    given = arguments()
    for end in (signal.SIGINT, signal.SIGTERM):
        signal.signal(end, signal.default_int_handler)
    vvr = os.path.abspath(given.vvr)
    os.environ["VVR_CONFIG"] = ""
    kinds = [kind for kind in KINDS if not given.kind or kind.name in given.kind]
    begin = time.monotonic()
    counts = {kind.name: collections.Counter() for kind in kinds}
    findings, inputs = [], 0
    with tempfile.TemporaryDirectory(prefix="vvr-mutate-") as work:
        work = pathlib.Path(work)
        for kind in kinds:
            (work / kind.name).mkdir()
            kind.make(work / kind.name, vvr)
            check_whole(vvr, kind, work)
        print(f"seed {given.seed}, {len(kinds)} kinds", flush=True)
        for number_ in [given.only] if given.only is not None else range(given.count):
            if given.seconds and time.monotonic() - begin > given.seconds:
                break
            kind = kinds[number_ % len(kinds)]
            try:
                statuses, found = try_one(vvr, kind, work / kind.name, number_, given.seed, work)
            except KeyboardInterrupt:
                break  # the report is of what was done
            counts[kind.name].update(str(status) for status in statuses)
            findings += found
            inputs += 1
            for one in found:
                print(json.dumps(one), flush=True)
            if found and given.keep:
                shutil.copytree(work / "input", pathlib.Path(given.keep) / f"{given.seed}-{number_}", dirs_exist_ok=True)
    summary = {"command": " ".join(sys.argv), "seed": given.seed, "inputs": inputs,
               "runs": sum(sum(one.values()) for one in counts.values()), "seconds": time.monotonic() - begin,
               "by_status": dict(sum(counts.values(), collections.Counter())),
               "by_kind": {kind: dict(one) for kind, one in counts.items()}, "findings": findings}
    if given.report:
        write_report(given.report, summary)
    print(f"{inputs} inputs, {summary['runs']} runs, {summary['seconds']:.0f} s, by status {summary['by_status']}, "
          f"{len(findings)} findings", flush=True)
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
