"""Files that are not what their names say, have no end, or go away while they are read."""

import os
import random
import resource
import shutil
import struct
import subprocess
import time
import zlib

import pytest
from harness import check, http_server, send

SMALL = ("--size", "160x100", "--backend", "software", "--quiet")
# What a run may end with: a status of its own, never a signal.
STATUSES = (0, 2, 3, 5, 7)


def mutated(data, seed):
    """Some bytes of the file others, most of them in its header, and sometimes its end cut off."""
    choose = random.Random(seed)
    changed = bytearray(data)
    for _ in range(choose.randint(1, 12)):
        place = choose.randrange(min(len(changed), choose.choice((64, 1024, len(changed)))))
        changed[place] = choose.choice((0, 1, 0x7f, 0x80, 0xff, choose.randrange(256)))
    return bytes(changed[:choose.randint(1, len(changed))] if choose.random() < 0.2 else changed)


@pytest.mark.nightly
def test_pictures_of_other_formats_are_refused(t):
    """Dozens of readers come with OpenImageIO, and some end the program where a file is damaged: they never get one."""
    t.clip("clip.avi", seconds=1)
    t.ffmpeg("-i", "clip.avi", "-frames:v", "1", "good.png")
    t.vvr("extract", "clip.avi", "-o", "data", "--quiet").expect(0)
    for ending in ("sgi", "dpx", "gif", "bmp", "hdr"):
        if t.run(["ffmpeg", "-v", "error", "-y", "-i", "clip.avi", "-frames:v", "1", f"other.{ending}"]).status != 0:
            continue
        data = t.path(f"other.{ending}").read_bytes()
        for seed in range(2):
            t.write("bad.png", data if seed == 0 else mutated(data, f"{ending} {seed}"))
            t.vvr("compare", "bad.png", "good.png").expect(2, "'bad.png'", "PNG, JPEG, TIFF or OpenEXR", code="file-invalid")
        t.write("data/scalar/000005.png", data)
        t.vvr("render", "data", "-o", "out.png", *SMALL).expect(2, "'data/scalar/000005.png'", "`vvr extract`", code="file-invalid")
    t.vvr("render", "clip.avi", "--golden", "bad.png", *SMALL).expect(2, "'bad.png'", code="file-invalid")
    check(not t.path("out.png").exists(), "a picture of what can't be read")


@pytest.mark.nightly
def test_damaged_pictures_end_no_program(t):
    t.clip("clip.avi", seconds=1)
    good = {}
    t.render("clip.avi", output="good.png").expect(0)
    for ending in ("png", "jpg", "tif", "exr"):
        t.render("clip.avi", output=f"good.{ending}").expect(0)
        good[ending] = t.path(f"good.{ending}").read_bytes()
    for seed in range(16):
        ending = list(good)[seed % len(good)]
        t.write("bad", mutated(good[ending], seed))
        run = t.vvr("compare", "bad", "good.png", timeout=60)
        check(run.status in STATUSES and "bug" not in run.err, f"{ending}, seed {seed}: {run}")


def test_a_picture_that_says_it_is_huge_is_refused(t):
    t.clip("clip.avi", seconds=1)
    t.render("clip.avi", output="good.png").expect(0)
    data = bytearray(t.path("good.png").read_bytes())
    data[16:24] = struct.pack(">II", 900_000, 900_000)
    data[29:33] = struct.pack(">I", zlib.crc32(bytes(data[12:29])))
    t.write("huge.png", bytes(data))
    run = t.vvr("compare", "huge.png", "good.png", timeout=30)
    check(run.status in (2, 5) and "huge.png" in run.err, str(run))


def test_what_has_no_end_is_read_nowhere(t):
    """A device, a pipe that nobody writes to, and a file of holes: in each place where a file is read."""
    t.clip("clip.avi", seconds=1)
    t.vvr("extract", "clip.avi", "-o", "data", "--quiet").expect(0)
    os.mkfifo(t.path("pipe"))
    with open(t.path("holes"), "wb") as holes:
        holes.truncate(20 << 30)
    t.vvr("render", "/dev/zero", "-o", "out.png", timeout=20).expect(2, "'/dev/zero'", "vvr watch", code="not-a-file")
    for strange in ("/dev/zero", "pipe"):
        t.vvr("compare", strange, strange, timeout=20).expect(2, f"'{strange}'", code="not-a-file")
        for option in ("--transfer", "--config", "--roi", "--mask", "--reference", "--seeds", "--golden")[:7 if strange == "pipe" else 2]:
            run = t.vvr("render", "clip.avi", "-o", "out.png", option, strange, *SMALL, timeout=30)
            check(run.status in (1, 2, 7) and strange in run.err, f"{option} {strange}: {run}")
        t.vvr("watch", f"@{strange}", "-o", "out.png", timeout=30).expect(2, f"'{strange}'", code="not-a-file")
        for part in ("scalar/000005.png", "first.png", "last.png", "seeds/000000.txt")[:1 if strange == "/dev/zero" else 4]:
            shutil.rmtree(t.path("copy"), ignore_errors=True)
            shutil.copytree(t.path("data"), t.path("copy"))
            (t.path("copy") / part).unlink()
            os.symlink(strange if strange.startswith("/") else t.path(strange), t.path("copy") / part)
            t.vvr("render", "copy", "-o", "out.png", "--show", "volume,arrows", *SMALL, timeout=30).expect(
                2, f"'copy/{part}'", code="not-a-file")
    for option in ("--transfer", "--config"):
        t.vvr("render", "clip.avi", "-o", "out.png", option, "holes", *SMALL, timeout=30).expect(
            5, "'holes'", "16 MB", code="file-too-large")
    home = {name: value for name, value in os.environ.items() if name not in ("VVR_CONFIG", "XDG_CONFIG_HOME")}
    home["HOME"] = str(t.path("home"))
    t.path("home/.config/vvr").mkdir(parents=True)
    os.mkfifo(t.path("home/.config/vvr/vvr.toml"))
    t.vvr("info", "clip.avi", env=home, timeout=30).expect(2, "vvr.toml'", code="not-a-file")


@pytest.mark.nightly
def test_a_recording_that_goes_away_in_the_middle(t):
    """An error, or a picture of what was read and a word about the rest: never a signal, and never a series of nothing."""
    t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=320x240:rate=25:duration=2", "-c:v", "mpeg4", "-q:v", "3", "x.avi")
    t.copy("x.avi", *[f"day/2026-11-21_10-00-{second:02}.avi" for second in range(0, 48, 2)])
    for seconds in (0.1, 0.3, 0.6, 1.2):
        for output, *options in (("out.png",), ("out.{brick:3}.png", "--brick", "10s")):
            for old in t.folder.glob("out.*"):
                old.unlink()
            run = t.start("render", "day", "-o", output, *options, *SMALL, stderr=subprocess.PIPE)
            time.sleep(seconds)
            t.path("day").rename(t.path("away"))
            said = run.communicate(timeout=120)[1].decode()
            t.path("away").rename(t.path("day"))
            drawn = list(t.folder.glob("out.*png"))
            check(run.returncode in (0, 2, 3), f"after {seconds} s: status {run.returncode}\n{said}")
            check((run.returncode == 0) == bool(drawn), f"after {seconds} s: status {run.returncode}, {drawn}\n{said}")


@pytest.mark.nightly
def test_a_header_that_lies_about_time_stops_nothing(t):
    """A length of centuries, and a clock that jumps by them: the picture is drawn, and it is said."""
    t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=10:duration=2", "-c:v", "mpeg4", "clip.mkv")
    data = t.path("clip.mkv").read_bytes()
    place = data.index(b"\x44\x89\x88") + 3
    for milliseconds, years in ((1e13, 317), (1e16, 316881)):
        t.write("lies.mkv", data[:place] + struct.pack(">d", milliseconds) + data[place + 8:])
        run = t.render("lies.mkv").expect(0, "20 frames")
        check("--" not in run.err, f"an option that was not given: {run}")
        check(years == 316881 or f"warning: 'lies.mkv' has a duration of {years} years in its header" in run.err, str(run))
        t.vvr("info", "lies.mkv").expect(0, out=None)
    for jump in ("1e9", "1e10", "1e12"):
        t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=10:duration=2", "-vf", f"setpts=PTS+gte(N\\,10)*{jump}/TB",
                 "-fps_mode", "passthrough", "-c:v", "mjpeg", "jump.mkv")
        run = t.render("jump.mkv", timeout=60).expect(0, "20 frames", "'jump.mkv': timestamps jump by ")
        check("--" not in run.err, f"an option that was not given: {run}")
    t.copy("clip.mkv", "far/1971-11-21_10-00-00.mkv", "far/2026-11-21_10-00-00.mkv")
    t.render("far", timeout=60).expect(0, "40 frames")


def test_a_pattern_of_many_parts_is_refused(t):
    for parts in (20_000, 2040):
        run = t.vvr("info", "*/" * parts, timeout=60)
        check(run.status in (1, 2), str(run)[-300:])
    t.vvr("info", "*/" * 20_000).expect(1, "4095", "40000", code="name-pattern-invalid")


def test_a_manifest_that_is_none_makes_no_folder_ours(t):
    t.clip("clip.avi", seconds=1)
    for name in ("manifest.json", "first.png", "color/a.png"):
        t.write(f"mine/{name}", "{ mine")
    t.vvr("extract", "clip.avi", "-o", "mine").expect(2, "'mine'", "`vvr extract`", code="folder-not-empty")
    t.expect_files("clip.avi", "mine", "mine/color", "mine/color/a.png", "mine/first.png", "mine/manifest.json")


@pytest.mark.nightly
def test_memory_that_is_short_is_never_another_fault(t):
    """Whatever it is that memory runs out for, a library, OpenGL or a plane: status 5, and no clip or driver is blamed."""
    t.clip("clip.avi", seconds=1)
    t.render("clip.avi").expect(0)
    sweeps = {resource.RLIMIT_DATA: (60, 90, 110, 150, 165, 200), resource.RLIMIT_AS: (300, 350, 400, 430, 450, 480, 520, 560)}
    for kind, sizes in sweeps.items():
        for megabytes in sizes:
            def limit(kind=kind, most=megabytes << 20):
                resource.setrlimit(kind, (most, most))
            run = t.vvr("render", "clip.avi", "-o", "out.png", "--size", "1600x1000", "--backend", "software", preexec_fn=limit)
            # Some libraries crash (docs/reliability.md).
            check(run.status in (0, 5, 127) or run.status < 0, f"{megabytes} MB: {run}")


def test_an_archive_whose_workers_have_too_little_memory(t):
    for i in range(3):
        t.clip(f"in/{i}.avi", seconds=1)
    run = t.archive("in", "-o", "out", "--max-memory", "240M", "--backend", "software", timeout=300)
    check(run.status in (0, 5, 6), str(run))
    check("0x8cdd" not in run.err and "no clip can be drawn" not in run.err, str(run))


def test_a_server_leads_to_no_other_host(t):
    t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=25:duration=2", "-c:v", "mpeg2video", "clip.ts")
    content = t.path("clip.ts").read_bytes()

    def lead(request):
        if request.path == "/clip.ts":
            return send(request, content)
        request.send_response(302)
        request.send_header("Location", "/clip.ts" if request.path == "/own" else f"http://{other}/clip.ts")
        request.end_headers()

    with http_server(content) as other, http_server(lead) as first:
        watch = ("-o", "out.png", "--size", "160x100", "--backend", "software", "--reference", "first")
        t.vvr("watch", f"http://{first}/own", *watch, timeout=60).expect(0, "1 picture of 25 frames")
        os.remove(t.path("out.png"))
        t.vvr("watch", f"http://{first}/other", *watch, timeout=60).expect(2, f"'{other}'", code="stream-unreachable")
    check(not t.path("out.png").exists(), "a picture of another host")


def test_a_size_that_lies_is_damage(t):
    """libav has no memory for a packet, or an index, that is as large as a damaged number says."""
    t.clip("ok.mp4", seconds=2, codec=("-c:v", "libx264", "-pix_fmt", "yuv420p", "-g", "10"))
    data = bytearray(t.path("ok.mp4").read_bytes())
    table = data.find(b"stsz")
    samples = int.from_bytes(data[table + 12:table + 16], "big")
    data[table + 16 + 4 * (samples - 1)] = 0x20
    t.write("bad.mp4", bytes(data))
    t.render("bad.mp4", "--backend", "software").expect(0, f"{samples - 1} frames", "1 damaged packet")
    t.vvr("cut", "bad.mp4", "--start", "0s", "--end", "1s", "-o", "piece.mp4").expect(0)
    t.vvr("info", "bad.mp4", "--quick").expect(0, out=None)
    for second in (0, 2, 4):
        t.copy("bad.mp4" if second == 2 else "ok.mp4", f"day/2026-11-21_10-00-0{second}.mp4")
    t.render("day", "--backend", "software", output="day.png").expect(0, "'day/2026-11-21_10-00-02.mp4' has 1 damaged packet")


def test_an_archive_names_what_a_day_lacks(t):
    for second in range(3):
        t.clip(f"in/gate/20261120_08000{second}.avi", 1)
    t.write("in/gate/20261120_080001.avi", "no video" * 100)
    t.archive("in", "-o", "out", "--per", "day", "--size", "64x40", "--backend", "software").expect(
        6, "vvr: gate/2026-11-20: 'in/gate/20261120_080001.avi' is not a video", code="partial")
    sidecar = t.json("out/gate/2026-11-20.json")
    check("20261120_080001.avi" in sidecar["reason"] and "unread" not in sidecar["day"], f"{sidecar}")
    check(sidecar["reason"] in t.path("out/index.html").read_text(), "the index does not say it")
    # It can be opened, so nothing changes until it does.
    t.archive("in", "-o", "out", "--per", "day", "--size", "64x40", "--backend", "software").expect(0, "nothing to do; 1 done before")
