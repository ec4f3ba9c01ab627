"""Clips, folders, data, archives and settings that are damaged by chance: each command ends as the docs say.

The first input of each kind is whole: else a kind could test nothing. Input K of a seed is the same each time. A test ends
at its first finding, and pytest keeps the folder. VVR_FUZZ_INPUTS says how many inputs of each kind there are, and
VVR_FUZZ_SEED which: scripts/fuzz --containers.
"""

import os
import pathlib
import random
import resource
import shutil
from dataclasses import dataclass
from typing import Callable

import pytest
from harness import check, lock_name

pytestmark = [pytest.mark.slow, pytest.mark.timeout(0)]  # each run has a limit of its own

INPUTS = int(os.environ.get("VVR_FUZZ_INPUTS", "2"))
SEED = int(os.environ.get("VVR_FUZZ_SEED", "1"))
HANG = 20  # seconds of a processor; ten times as many of waiting for one
MEMORY = 6 * 2**30  # address space; the software rasteriser reserves much more than it uses
LIMITS = {resource.RLIMIT_AS: MEMORY, resource.RLIMIT_FSIZE: 2**28, resource.RLIMIT_CPU: HANG, resource.RLIMIT_CORE: 0,
          resource.RLIMIT_NPROC: 2048}

# The statuses that docs/cli.md has for an input that is damaged: no usage, no backend, no bug.
OF_A_CLIP = {0, 3, 5}
OF_DATA = {0, 2, 3, 5}
OF_A_FILE = {0, 1, 2, 3, 5}
OF_AN_ARCHIVE = {0, 6}

SMALL = ["--size", "64x40", "--backend", "software", "--quiet", "--threads", "1"]


@dataclass
class Kind:
    """What is damaged, and what vvr is asked to do with it. Commands run in the folder of the input."""
    name: str
    make: Callable  # fills the folder of a test with what is whole
    may_break: str  # a glob: which files are damaged
    commands: list[list[str]]
    allowed: set[int]


def clip(name, *codec):
    """A kind of one clip, which is rendered and described."""
    file = f"clip.{name.split('-')[0]}"
    return Kind(name, lambda t: t.clip(file, seconds=0.8, codec=codec), "clip.*",
                [["render", file, "-o", "out.png", *SMALL], ["info", file]], OF_A_CLIP)


def pictures(t):
    t.path("frames").mkdir()
    t.clip("frames/%03d.png", seconds=0.8, codec=())


def data(t):
    t.clip(seconds=0.8)
    t.vvr("extract", "clip.avi", "-o", "data", "--quiet").expect(0)
    t.path("clip.avi").unlink()


def archive(t):
    t.path("in").mkdir()
    for name in ("one", "two"):
        t.clip(f"in/{name}.avi", seconds=0.8)
    t.archive("in", "-o", "out", *SMALL).expect(0)
    # The claim of a program that was killed before it had written anything.
    t.write(f"out/{lock_name('gone.avi')}", "gone.avi")


def settings(t):
    t.clip(seconds=0.8)
    t.ffmpeg("-i", "clip.avi", "-frames:v", "1", "set-mask.png")
    t.write("set-config.toml", 'size = "64x40"\ntitle = "A title"\nmin-area = 2\n[render]\nfilter = "difference"\n')
    t.write("set-transfer.txt", "# value red green blue opacity\n12 0.1 0.2 0.3 0\n255, 1, 1, 1, 0.9\n")
    t.write("set-seeds.txt", "vvr-seeds 1\nframe 3\nsize 64 48\npoints 2\n10 10 1.5 0.5 1\n20 20 -1 0 01\n")


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
    Kind("pictures", pictures, "frames/*", [["render", "frames", "-o", "out.png", *SMALL], ["info", "frames"]], OF_A_CLIP),
    Kind("data", data, "data/*", [["render", "data", "-o", "out.png", *SMALL]], OF_DATA),
    Kind("archive", archive, "out/*", [["archive", "-o", "out", "--write", "index"],
                                       ["archive", "in", "-o", "out", "--dry-run", *SMALL]], OF_AN_ARCHIVE),
    Kind("settings", settings, "set-*", [["render", "clip.avi", "-o", "out.png", *SMALL, *FILES]], OF_A_FILE),
]


# How bytes are damaged


def place(chance, size):
    """Where: headers are the more interesting half."""
    return chance.randrange(min(size, chance.choice([64, 512, size, size])))


def flip(chance, content):
    for _ in range(chance.choice([1, 1, 2, 8, 64])):
        content[place(chance, len(content))] ^= 1 << chance.randrange(8)


def scribble(chance, content):
    begin = place(chance, len(content))
    end = min(len(content), begin + chance.choice([1, 4, 16, 256]))
    content[begin:end] = chance.randbytes(end - begin)


def number(chance, content):
    """A count or a length that can't be."""
    begin = place(chance, len(content))
    value = chance.choice([0, 1, 0x7F, 0xFF, 0x7FFF, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF])
    content[begin:begin + 4] = value.to_bytes(4, chance.choice(["little", "big"]))


def digits(chance, content):
    """For texts: another number, sign, bracket or word."""
    begin = place(chance, len(content))
    content[begin:begin + chance.choice([0, 1, 4])] = chance.choice(
        [b"-", b"1e300", b"99999999999999999999", b"nan", b"[" * 300, b"{", b"\"", b"\0", b"../", b"\xff", b"\x1b[2J", b"null"])


def cut(chance, content):
    del content[place(chance, len(content)):]


def remove(chance, content):
    begin = place(chance, len(content))
    del content[begin:begin + chance.choice([1, 4, 100, 1000])]


def repeat(chance, content):
    begin = place(chance, len(content))
    part = content[begin:begin + chance.choice([1, 16, 188, 1000])]
    content[begin:begin] = part * chance.choice([1, 2, 50])


WAYS = [flip, flip, scribble, number, digits, cut, remove, repeat]


def damage(chance, folder, pattern):
    files = sorted(path for path in folder.glob(pattern) if path.is_file())
    deeper = sorted(path for path in folder.glob(pattern + "/*") if path.is_file())
    for _ in range(chance.choice([1, 1, 3])):
        file = chance.choice(files if not deeper or (files and chance.random() < 0.5) else deeper)
        content = bytearray(file.read_bytes())
        for _ in range(chance.choice([1, 1, 1, 2, 5])):
            if content:
                chance.choice(WAYS)(chance, content)
        file.write_bytes(content)


# What vvr makes of it


def listing(folder):
    return {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}


def is_whole(picture):
    content = picture.read_bytes() if picture.exists() else b""
    return content.startswith(b"\x89PNG") and content.endswith(b"IEND\xaeB`\x82")


def is_hidden(name):
    return pathlib.Path(name).name.startswith(".vvr-")


def findings(kind, run, command, folder, before):
    """What must not be, after a run."""
    if run.status != 0 and not run.err.strip():
        yield "no word"
    if "a bug in vvr" in run.err or any(ord(letter) < 32 and letter != "\n" for letter in run.err):
        yield "words"
    after = listing(folder)
    yield from (f"removed {name}" for name in before - after if not is_hidden(name))
    wanted = {"out.png"} if run.status == 0 and "out.png" in command else set()
    # The index of an archive is written anew; the claim that was left behind may be gone.
    yield from (f"left {name}" for name in after - before - wanted if kind.name != "archive" or is_hidden(name))
    yield from (f"partial {name}" for name in wanted if not is_whole(folder / name))


def limit():
    for kind, most in LIMITS.items():
        resource.setrlimit(kind, (most, most))


@pytest.mark.parametrize("kind", KINDS, ids=[kind.name for kind in KINDS])
def test_damaged_inputs_end_as_documented(t, tmp_path_factory, kind):
    kind.make(t)
    folder, spool = tmp_path_factory.mktemp("input"), tmp_path_factory.mktemp("spool")
    environment = os.environ | {"VVR_CONFIG": "", "TMPDIR": str(spool), "LP_NUM_THREADS": "0"}
    for count in range(INPUTS + 1):
        shutil.rmtree(folder)
        shutil.copytree(t.folder, folder)
        if count > 0:
            damage(random.Random(f"{SEED} {kind.name} {count}"), folder, kind.may_break)
        for command in kind.commands:
            before = listing(folder)
            run = t.vvr(*command, cwd=folder, env=environment, timeout=10 * HANG, preexec_fn=limit)
            where = f"input {count} of seed {SEED}, in {folder}: {run}"
            check(run.status in (kind.allowed if count > 0 else {0}), where)
            found = list(findings(kind, run, command, folder, before))
            check(not found and not any(spool.iterdir()), f"{found}, {where}")
            (folder / "out.png").unlink(missing_ok=True)
