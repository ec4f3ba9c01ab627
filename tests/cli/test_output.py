"""Where pictures go, and that they are whole or not there."""

import fcntl
import os
import pty
import resource
import struct
import subprocess
import time

import pytest
from harness import check, part_name


def test_same_bytes_every_time(t):
    t.clip()
    for name, threads in (("a.png", "1"), ("b.png", "1"), ("c.png", "5"), ("a.exr", "1"), ("b.exr", "5")):
        t.render("clip.avi", "--backend", "software", "--threads", threads, output=name).expect(0)
    for one, other in (("a.png", "b.png"), ("a.png", "c.png"), ("a.exr", "b.exr")):
        check(t.path(one).read_bytes() == t.path(other).read_bytes(), f"{one} and {other} differ")


@pytest.mark.nightly
def test_layers_stand_in_an_exr(t):
    t.clip()
    for backend in ("software", "osmesa"):
        t.render("clip.avi", "--backend", backend, "--show", "volume,arrows,tracelines,outline,frames",
                 output="out.exr").expect(0)
        header = t.path("out.exr").read_bytes()[:2000]
        for channel in (b"R", b"G", b"B", b"Z", b"time", b"frame"):
            kind = struct.pack("<i", 1 if channel in b"RGB" else 2)  # half and float, as the format numbers them
            check(b"\0" + channel + b"\0" + kind in header, f"{backend}: no channel {channel}, or of another type")
    t.render("clip.avi", "--brick", "10f", output="series.{brick}.exr").expect(0, "2 pictures")
    check(b"\0time\0" in t.path("series.1.exr").read_bytes()[:2000], "a series has no layers")


def test_settings_stand_in_the_picture(t):
    t.clip()
    t.ffmpeg("-i", "clip.avi", "-frames:v", "1", "empty-scene.png")
    t.render("clip.avi", "--camera", "-12,34", "--reference", str(t.path("empty-scene.png"))).expect(0)
    data = t.path("out.png").read_bytes()
    for text in (b"vvr:camera\0-12,34", b"vvr:threshold\0", b"vvr:frames\0" + b"20", b"Software\0vvr ", b"vvr:renderer\0"):
        check(text in data, f"{text} is not in the picture")
    check(str(t.folder).encode() not in data, "the picture names a folder")


def test_unknown_format(t):
    t.clip()
    t.render("clip.avi", output="out.pgn").expect(1, "'.pgn'", "'.png'", ".html .gif .mp4 .webm", code="output-format-unknown")
    t.render("clip.avi", output="out.htlm").expect(1, "'.htlm'", "'.html'", code="output-format-unknown")
    t.render("clip.avi", output="out").expect(1, "'out'", ".png .exr", ".html .gif .mp4 .webm", code="output-format-unknown")
    t.expect_files("clip.avi")


def test_standard_output(t):
    t.clip()
    t.render("clip.avi").expect(0)
    piped = f"'{t.vvr_path}' render - -o - --size 160x100 --title clip.avi <clip.avi >piped.png"
    t.run(["bash", "-c", piped]).expect(0, "20 frames")
    check(t.rgb("piped.png") == t.rgb("out.png"), "another picture")
    report = t.render("clip.avi", "--report", "-").expect(0, "20 frames", out=None).json()
    check(report["frames"]["used"] == 20, f"{report}")
    t.vvr("render", "clip.avi", "-o", "-", "--report", "-").expect(1, "-o", "--report", code="options-conflict")
    t.vvr("render", "clip.avi", "-o", "-", "--animate", "3", "--show", "volume,tracelines").expect(1, "'-'", code="options-conflict")
    for command in (("render", "clip.avi", "-o", "x.png", "--page", "-"), ("extract", "clip.avi", "-o", "-"),
                    ("render", "clip.avi", "--golden", "-"), ("watch", "clip.avi", "-o", "-"),
                    ("cut", "clip.avi", "--start", "0s", "-o", "-"), ("archive", ".", "-o", "-")):
        t.vvr(*command).expect(1, "'-'", "./-", code="option-value")
    t.expect_files("clip.avi", "out.png", "piped.png")


def test_a_terminal_gets_no_picture(t):
    t.clip()
    outside, terminal = pty.openpty()
    done = subprocess.run([t.vvr_path, "render", "clip.avi", "-o", "-"], cwd=t.folder, stdin=subprocess.DEVNULL, stdout=terminal,
                          stderr=subprocess.PIPE, check=False)
    os.close(terminal)
    os.close(outside)
    check(done.returncode == 1 and b"-o -" in done.stderr and b"[usage]\n" in done.stderr, f"{done}")


def test_an_output_that_is_named_twice(t):
    t.clip()
    t.vvr("render", "clip.avi", "-o", "a.png", "--output=b.png").expect(1, "--output", "'a.png'", "'b.png'", code="options-conflict")
    t.vvr("render", "clip.avi", "-o", "a.png", "--report", "a.json", "--report", "b.json").expect(1, "--report", code="options-conflict")
    t.render("clip.avi", "-o", "out.png").expect(0)  # the same


def test_missing_folder(t):
    t.clip()
    t.render("clip.avi", output="none/out.png").expect(2, "'none'", "mkdir -p 'none'", code="file-not-found")
    t.render("none.avi", output="none/out.png").expect(2, "'none/out.png'", code="file-not-found")  # before the clip is read
    t.expect_files("clip.avi")


def test_folder_that_cannot_be_written(t):
    t.clip()
    t.render("clip.avi", output="/proc/out.png").expect(2, "'/proc'", code="file-not-found")
    t.path("locked").mkdir()
    t.path("locked").chmod(0o555)
    if os.geteuid() != 0:
        t.render("clip.avi", output="locked/out.png").expect(2, "Permission denied", code="permission-denied")
    t.path("folder.png").mkdir()
    t.render("clip.avi", output="folder.png").expect(2, "'folder.png'", code="not-a-file")
    t.expect_files("clip.avi", "folder.png", "locked")


def test_a_folder_that_cannot_be_listed(t):
    t.clip()
    t.path("data").mkdir(mode=0o300)
    # Root may list all folders, unless it gives that up.
    as_user = ("setpriv", "--bounding-set", "-dac_override,-dac_read_search") if os.geteuid() == 0 else ()
    for command in (("extract", "clip.avi", "-o", "data"), ("cut", "clip.avi", "--start", "0s", "--evidence", "data")):
        t.run([*as_user, t.vvr_path, *command]).expect(
            2, "cannot list the folder 'data': Permission denied; fix its permissions", code="permission-denied")


def test_full_disk_by_file_size_limit(t):
    t.clip()
    t.write("before.png", "an older picture")

    limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))
    t.render("clip.avi", output="before.png", preexec_fn=limit).expect(2, "'before.png'", "File too large", code="disk-full")
    t.render("clip.avi", preexec_fn=limit).expect(2, "'out.png'", "File too large", code="disk-full")
    check(t.path("before.png").read_text() == "an older picture", "the older picture was touched")
    t.expect_files("before.png", "clip.avi")


def test_removes_what_a_killed_run_left(t):
    t.clip()
    old, young, held, second = (part_name(name, number) for name, number in (("old.png", 0), ("young.png", 0), ("held.png", 0), ("held.png", 1)))
    others = part_name("out.png"), part_name("out.jpg")
    for name in (old, young, held, second, *others):
        t.write(name, "half")
    t.stamp(old, -3700)
    t.render("clip.avi", output="old.png").expect(0)
    check(old not in t.files(), "it has been there for an hour")
    t.render("clip.avi", output="young.png").expect(0)
    # Only where all who may be writing it share this kernel, it is certain that nobody is.
    system = t.run(["stat", "-f", "-c", "%T", "."]).out.strip()
    check(young not in t.files() or system not in ("ext2/ext3", "xfs", "btrfs", "tmpfs", "overlayfs"), f"left on {system}")
    with open(t.path(held), "a") as writing:
        fcntl.flock(writing, fcntl.LOCK_EX)
        t.stamp(held, 1)
        t.stamp(second, 1)
        t.render("clip.avi", output="held.png").expect(0)
        check(held in t.files() and second not in t.files(), "somebody is still writing it")
    t.path(held).unlink()
    check(all(name in t.files() for name in others), "of another name")
    # What is no file of vvr's stays, and nothing waits for it.
    t.path(others[0]).unlink()
    os.mkfifo(t.path(others[0]))
    t.path(part_name("out.png", 1)).symlink_to("clip.avi")
    t.render("clip.avi", timeout=60).expect(0)
    t.expect_picture()
    check(others[0] in t.files() and t.path(part_name("out.png", 1)).is_symlink(), "not vvr's")


def test_quiet_is_quiet(t):
    t.clip()
    result = t.render("clip.avi").expect(0, "vvr: 'out.png': 20 frames in 20 layers and 8 bricks")
    check("\r" not in result.err and "\033" not in result.err, "a progress bar without a terminal")
    t.render("clip.avi", "--quiet").expect(0, err="")
    t.render("none.avi", "--quiet").expect(2, "none.avi", code="file-not-found")
    t.render("clip.avi", "--verbose").expect(0, "backend ", "arrows")


def test_reader_that_has_seen_enough(t):
    result = t.run(["bash", "-c", f'set -o pipefail; "{t.vvr_path}" render --help | head -n 1'])
    check(result.status == 0 and result.err == "" and result.out.count("\n") == 1, str(result))


def test_stdout_that_does_not_block(t):
    expected = t.vvr("help", "--json").out.encode()
    check(len(expected) > 65536, "a pipe takes all of it at once")
    reader, writer = os.pipe()
    os.set_blocking(writer, False)
    run = t.start("help", "--json", stdout=writer, stderr=subprocess.PIPE)
    os.close(writer)
    time.sleep(0.2)  # until the pipe is full; nothing fails if it is not yet
    with open(reader, "rb") as pipe:
        said = pipe.read()
    check(run.wait() == 0 and said == expected, f"{len(said)} of {len(expected)} bytes, {run.stderr.read()}")


def test_stdout_that_cannot_be_written(t):
    with open("/dev/full", "wb") as full:
        done = subprocess.run([t.vvr_path, "--version"], stdout=full, stderr=subprocess.PIPE, check=False)
    check(done.returncode == 2 and b"No space left" in done.stderr and b"[disk-full]\n" in done.stderr, str(done))


def test_over_a_limit(t):
    t.clip()
    t.render("clip.avi", "--field-size", "16384x16384").expect(5, "16384x16384", "100 megapixels", "--field-size", code="picture-too-large")
    t.expect_files("clip.avi")


def test_a_page_beside_the_picture(t):
    t.clip()
    t.render("clip.avi", "--page", "out.html", "--size", "640x400").expect(0)
    t.expect_files("clip.avi", "out.png", "out.html")
    t.expect_picture("out.png", (640, 400))
    t.render("clip.avi", "--size", "640x400", output="alone.png").expect(0)
    check(t.path("alone.png").read_bytes() == t.path("out.png").read_bytes(), "a page changes the picture")
    t.render("clip.avi", "--page", "out.txt").expect(1, "--page", "'out.txt'", ".html", code="output-format-unknown")
    t.render("clip.avi", "--page", "b.html", output="a.html").expect(1, "'a.html'", "--page", code="options-conflict")
    t.render("clip.avi", "--page", "p.html", output="{brick}.png").expect(1, "--page", code="options-conflict")
    t.render("clip.avi", "--still", "small.bmp").expect(1, "'small.bmp'", "'.bmp'", ".png .exr", code="output-format-unknown")
    t.render("clip.avi", "--still", "out.png").expect(1, "--still", "-o", "'out.png'", code="options-conflict")
    t.vvr("render", "clip.avi", "--report", "r.json", "--page", "p.html").expect(1, "--page", "-o FILE", code="option-needs-another")
