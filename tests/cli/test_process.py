"""Signals, terminals, and where the program may stand."""

import os
import pathlib
import pty
import re
import shutil
import signal
import time

import pytest
from harness import check, skip_with_sanitizers


def interrupt(t, number, after):
    """Sends a signal to a render of a long clip; its exit status."""
    child = t.start("render", "long.avi", "-o", "out.png")
    time.sleep(after)
    child.send_signal(number)
    return child.wait(timeout=60)


def test_it_asks_for_huge_pages(t):
    skip_with_sanitizers("have a malloc of their own")
    if not os.path.exists("/sys/kernel/mm/transparent_hugepage"):
        pytest.skip("this kernel has no huge pages")
    t.clip("long.avi", seconds=20, size="384x288")
    child = t.start("render", "long.avi", "-o", "out.png")
    advised = False
    while not advised and child.poll() is None:
        mappings = pathlib.Path(f"/proc/{child.pid}/smaps").read_text(encoding="utf-8")
        advised = any("hg" in flags.split() for flags in re.findall(r"\[heap\]\n(?:.*\n)*?VmFlags:(.*)", mappings))
    child.kill()
    child.wait()
    check(advised, "no part of the heap is to be of huge pages")


def test_signals_end_it_without_a_file(t):
    t.clip("long.avi", seconds=120, size="384x288")
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        status = interrupt(t, number, 0.6)
        check(status == -number, f"signal {number}: status {status}")
        t.expect_files("long.avi")


def test_signals_at_any_time_leave_all_or_nothing(t):
    t.clip("long.avi", seconds=1)
    for i in range(12):
        status = interrupt(t, signal.SIGTERM, 0.05 * i)
        done = [name for name in t.files() if name != "long.avi"]
        check(done in ([], ["out.png"]), f"left behind: {done}")
        if done:
            t.expect_picture(size=(1280, 960))
            t.path("out.png").unlink()
        check(status in (0, -signal.SIGTERM), f"status {status}")


def test_ignored_signals_stay_ignored(t):
    t.clip("long.avi", seconds=1)
    render = f'"{t.vvr_path}" render long.avi -o out.png --size 160x100'
    t.run(["bash", "-c", f'trap "" HUP; {render} & sleep 0.2; kill -HUP $!; wait $!']).expect(0)
    t.expect_picture()


def on_terminal(t, *arguments):
    """What a run that succeeds writes to stderr, where that is a terminal."""
    parent, terminal = pty.openpty()
    child = t.start(*arguments, env=os.environ | {"TERM": "xterm"}, stderr=terminal)
    os.close(terminal)
    said = b""
    try:
        while chunk := os.read(parent, 4096):
            said += chunk
    except OSError:  # how Linux says that the other end of a terminal is gone
        pass
    check(child.wait() == 0, said.decode())
    return said.decode()


def test_progress_bar_on_a_terminal(t):
    t.clip("long.avi", seconds=20, size="384x288")
    said = on_terminal(t, "render", "long.avi", "-o", "out.png")
    check("frames [" in said and " %" in said and "drawing" in said, said)
    last = said.rsplit("\033[K", 1)[1]
    check("200 frames" in last and "[" not in last, f"the bar is still there: {last!r}")


@pytest.mark.nightly
def test_archive_shows_its_progress_on_a_terminal(t):
    for name in ("one.avi", "two.avi"):
        t.clip(f"in/{name}", seconds=20, size="192x144")
    t.age("in")
    said = on_terminal(t, "archive", "in", "-o", "out", "--jobs", "1", "--size", "160x100")
    lines = [line for line in said.split("\r\033[K") if line.startswith("archive [")]
    check(lines and all(len(line) < 80 and "\n" not in line for line in lines), said)
    check(any("; 0 of 2 clips; " in line for line in lines) and any("; 1 of 2 clips; " in line for line in lines), said)
    parts = [int(found[1]) for line in lines if (found := re.search(r"avi (\d+) %", line))]
    check(len(set(parts)) > 2, f"the parts of a clip: {parts}")
    last = said.rsplit("\033[K", 1)[1]
    check("'out': 2 clips drawn" in last and "archive [" not in last, f"the bar is still there: {last!r}")
    check("archive [" not in on_terminal(t, "archive", "in", "-o", "quiet", "--quiet", "--size", "160x100"), "a bar in spite of --quiet")


def test_installed_program_is_relocatable(t):
    build = os.path.dirname(os.path.dirname(t.vvr_path))
    t.run(["cmake", "--install", build, "--prefix", t.path("first")]).expect(0, out=None)
    for name in ("bin/vvr", "lib/vvr-*/libvvr_pictures.so", "share/doc/vvr/LICENSE"):
        check(len(list(t.path("first").glob(name))) == 1, f"{name} is not installed")
    shutil.move(t.path("first"), t.path("moved"))
    t.clip()
    t.run([t.path("moved/bin/vvr"), "render", "clip.avi", "-o", "out.png", "--size", "160x100"]).expect(0)
    t.expect_picture()


def test_no_command_opens_a_connection(t):
    """A call that would, ends the program here."""
    alone = (os.environ["VVR_WITHHOLD"], "network")
    check(t.run([*alone, "bash", "-c", "exec 3<>/dev/tcp/127.0.0.1/9"]).status == -signal.SIGSYS, "connections can be made here")
    t.clip()
    t.run([*alone, t.vvr_path, "render", "clip.avi", "-o", "out.html", "--report", "out.json", "--size", "160x100"]).expect(0)
    for command in (("info", "clip.avi"), ("doctor",), ("cut", "clip.avi", "-o", "cut.avi", "--start", "0.5s"),
                    ("archive", ".", "-o", "pictures", "--size", "160x100")):
        t.run([*alone, t.vvr_path, *command]).expect(0, out=None)


def test_version_loads_neither_drivers_nor_openimageio(t):
    loaded = t.run(["env", "LD_TRACE_LOADED_OBJECTS=1", t.vvr_path]).out
    for library in ("libEGL", "libOSMesa", "libOpenImageIO"):
        check("libc.so" in loaded and library not in loaded, loaded)


def loads(t, library, *command):
    run = t.run(["env", "LD_DEBUG=files", t.vvr_path, *command]).expect(0, out=None)
    check("libc.so" in run.err, run.err[-300:])
    return library in run.err


def test_a_report_alone_opens_no_opengl(t):
    """It costs more than to read a short clip."""
    t.clip()
    check(loads(t, "libEGL", "render", "clip.avi", "-o", "out.png", "--size", "160x100"), "a picture is drawn without EGL")
    check(not loads(t, "libEGL", "render", "clip.avi", "--report", "report.json"), "a report loads EGL")
    check(t.json("report.json")["renderer"] is None, "a renderer that has drawn nothing")
    # Nothing of OpenGL can fail then.
    t.vvr("render", "clip.avi", "--backend", "egl", "--events-csv", "events.csv").expect(0)


def test_png_and_jpeg_files_and_pages_load_no_openimageio(t):
    """Loading it takes longer than to draw a short clip: only other formats need it."""
    t.clip()
    small = ("--size", "160x100", "--backend", "software")

    def loads_openimageio(*command):
        return loads(t, "libOpenImageIO", *command)

    for command in (("render", "clip.avi", "-o", "out.png", "--still", "still.jpg", *small), ("compare", "out.png", "out.png"),
                    ("render", "clip.avi", "--golden", "out.png", *small), ("extract", "clip.avi", "-o", "data"),
                    ("render", "data", "-o", "again.png", *small), ("render", "clip.avi", "-o", "page.html", *small)):
        check(not loads_openimageio(*command), f"{command} loads OpenImageIO")
    check(loads_openimageio("render", "clip.avi", "-o", "out.exr", *small), "an EXR is written without it")
