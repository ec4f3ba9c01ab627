"""Names, files and texts that somebody made on purpose: nothing is replaced, forged, told or waited for without end."""

import fcntl
import json
import os
import resource
import signal
import time

import pytest
from harness import check, http_server, lock_name, send, skip_with_sanitizers
from test_archive import QUICK

SMALL = ("--size", "320x200", "--backend", "software", "--quiet")


def test_output_never_replaces_what_is_read(t):
    """Whatever the file is called: a clip may have any name, and a link leads to it too."""
    t.clip("clip.avi", seconds=1)
    before = t.path("clip.avi").read_bytes()
    os.link(t.path("clip.avi"), t.path("clip.png"))
    os.symlink("clip.avi", t.path("link.html"))
    os.link(t.path("clip.avi"), t.path("clip.jpg"))
    t.ffmpeg("-i", "clip.avi", "-frames:v", "5", "frames/%03d.png")
    frame = t.path("frames/003.png").read_bytes()
    for option, name in (("-o", "clip.png"), ("-o", "link.html"), ("--report", "clip.avi")):
        t.vvr("render", "clip.avi", option, name).expect(1, f"{option} '{name}'", "'clip.avi'", code="output-replaces-input")
    for option, name in (("--still", "clip.jpg"), ("--page", "link.html")):
        t.vvr("render", "clip.avi", "-o", "out.png", option, name).expect(1, f"{option} '{name}'", "'clip.avi'", code="output-replaces-input")
    t.vvr("render", "frames", "-o", "frames/003.png").expect(1, "-o 'frames/003.png'", "'frames'", code="output-replaces-input")
    t.vvr("render", "clip.avi", "-o", "frames/003.png", "--reference", "frames/003.png").expect(
        1, "-o 'frames/003.png'", code="output-replaces-input")
    t.vvr("render", "clip.avi", "-o", "frames/003.png", "--golden", "frames/003.png").expect(
        1, "-o 'frames/003.png'", code="output-replaces-input")
    check(t.path("clip.avi").read_bytes() == before and t.path("frames/003.png").read_bytes() == frame, "something was replaced")


def test_names_forge_no_lines(t):
    """Control characters, marks that turn the direction, and lines of their own are shown as escapes."""
    for name, shown in (("x\x1b[2Jy.avi", "x\\x1b[2Jy.avi"), ("x\nvvr: all is well", "x\\nvvr: all is well"),
                        ("gpj\u202eiva.avi", "gpj\\u202eiva.avi")):
        run = t.vvr("render", name, "-o", "out.png", "--log-file", "log.txt")
        run.expect(2, shown, code="file-not-found")
        for text in (run.err, t.path("log.txt").read_text(encoding="utf-8")):
            check(not any(mark in text for mark in "\x1b\u202e") and "\nvvr: all is well" not in text, repr(text))
    t.clip("y\x1b]0;evil.avi", seconds=1)
    run = t.vvr("info", "y\x1b]0;evil.avi")
    run.expect(0, out=None)
    check("\x1b" not in run.out and "\\x1b]0;evil.avi" in run.out, repr(run.out))
    # JSON has the same name, without the characters that a terminal obeys. Others stay readable.
    name = "T\u00fcr\u009b2J\u202eiva.avi"
    t.copy("y\x1b]0;evil.avi", name)
    run = t.vvr("info", name, "--json").expect(0, out=None)
    check(not any(mark in run.out for mark in "\u009b\u202e") and "T\u00fcr" in run.out, repr(run.out))
    check(name in json.dumps(run.json(), ensure_ascii=False), repr(run.out))


def test_addresses_tell_no_secrets(t):
    """A server whose playlist is fine and whose first segment is missing: libav's words have the whole address."""
    playlist = b"#EXTM3U\n#EXT-X-TARGETDURATION:2\n#EXTINF:2,\nmissing.ts?token=abc\n#EXT-X-ENDLIST\n"
    with http_server(lambda request: send(request, playlist, 200 if request.path.startswith("/p.m3u8") else 404)) as host:
        address = f"http://user:s3cret@{host}/p.m3u8?key=k3y"
        for command in (("render", address, "-o", "out.png"), ("info", address), ("render", address, "--report", "r.json")):
            run = t.vvr(*command, "--log-file", "log.txt")
            check(run.status != 0, "the stream has no segment")
            for text in (run.out, run.err, t.path("log.txt").read_text()):
                check(not any(secret in text for secret in ("s3cret", "user:", "token", "k3y")), text)
    check("127.0.0.1" in run.err, run.err)


@pytest.mark.nightly
def test_no_output_tells_the_secrets_of_an_address(t):
    """A stream that is read, a reference and a title: each file that vvr writes, and all that it says."""
    t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=96x64:rate=10:duration=2", "-c:v", "mpeg2video", "clip.ts")
    secrets = ("Wh0-Is-It", "s3cret-w0rd", "t0ken-0f-mine")
    outputs = ("-o", "a.png", "--page", "a.html", "--still", "s.jpg", "--report", "a.json", "--log-file", "log")
    with http_server(t.path("clip.ts").read_bytes()) as host:
        address = "http://{}:{}@{}/hall.ts?token={}".format(*secrets[:2], host, secrets[2])
        runs = {
            ("info", address): 0, ("info", address, "--json"): 0,
            ("render", address, *outputs, "--size", "320x200", "--backend", "software", "--verbose"): 0,
            ("render", address, "-o", "n.{brick}.png", "--report", "n.json", "--brick", "1s", *SMALL[:4], "--log-format", "json"): 0,
            ("render", "clip.ts", "--reference", address, "-o", "r.png", "--page", "r.html", "--report", "r.json", *SMALL): 0,
            ("extract", address, "-o", "data"): 0, ("render", "data", "-o", "d.png", "--report", "d.json", *SMALL): 0,
            ("inspect", address, "--frame", "5f", "-o", "inspect.png"): None,
            ("watch", address, "-o", "w.png", "--log-file", "watch.log", "--duration", "2s", *SMALL[:4]): None,
            ("render", address, "-o", "late.png", "--start", "100s"): None, ("render", address, address, "-o", "two.png"): 1,
            ("seeds", address, "-o", "seeds"): None, ("cut", address, "--start", "0", "-o", "cut.avi"): 1,
            ("archive", address, "-o", "out"): None}
        for command, status in runs.items():
            run = t.vvr(*command)
            check(status in (None, run.status), f"{run}")
            told = [secret for secret in secrets if secret in run.out + run.err]
            check(not told, f"{command}: {told} in what it says")
    files = [path for path in t.folder.rglob("*") if path.is_file()]
    told = [(str(path), secret) for path in files for secret in secrets if secret.encode() in path.read_bytes()]
    check(not told, f"{told}")
    check(t.json("a.json")["input"]["name"].endswith("/hall.ts"), "the report names no stream")
    check(t.json("r.json")["settings"]["reference"] == "hall.ts", "the report names no reference")
    check(len(files) > 15, f"{files}")


def test_json_that_is_deep_is_none(t):
    deep = "[" * 200_000
    t.write("data/manifest.json", deep)
    t.vvr("render", "data", "-o", "out.png").expect(2, "'data/manifest.json'", code="file-invalid")
    t.write("pictures/a.json", '{\n  "vvr-archive": ' + deep)
    t.vvr("archive", "-o", "pictures", "--write", "index").expect(0)
    t.clip("clip.avi", seconds=1)
    t.write("r.json", deep)
    t.vvr("cut", "clip.avi", "--event", "1", "--report", "r.json", "-o", "x.avi").expect(1, "'r.json'", code="input-unsuitable")


def test_long_titles_and_names_cost_nothing(t):
    t.clip("clip.avi", seconds=1)
    t.vvr("render", "clip.avi", "-o", "out.png", "--title", "x" * 100_000, *SMALL, timeout=30).expect(0)
    t.vvr("render", "clip.avi", "-o", "{" + "a" * 40_000 + ".png").expect(1, "255 bytes", "40005", code="name-pattern-invalid")
    t.vvr("render", "clip.avi", "-o", "#" * 40_000 + ".png").expect(1, "255 bytes", code="name-pattern-invalid")


def test_watch_waits_for_no_writer(t):
    """A pipe that nobody writes to is given as long as a camera that does not answer."""
    os.mkfifo(t.path("pipe"))
    t.vvr("watch", "pipe", "-o", "out.png", "--patience", "1", "--duration", "2s", timeout=30).expect(
        2, "'pipe'", "--patience", code="stream-timeout")
    t.expect_files("pipe")


@pytest.mark.nightly
def test_a_file_on_a_server_is_waited_for(t):
    """It comes all at once: no frame is late, and --reference first is not advised to who has given it."""
    t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=25:duration=4", "-c:v", "mpeg2video", "clip.ts")
    with http_server(t.path("clip.ts").read_bytes()) as host:
        watch = ("watch", f"http://{host}/clip.ts", "-o", "out.png", "--size", "160x100", "--backend", "software")
        t.vvr(*watch, "--brick", "1s", "--reference", "first").expect(0, "3 pictures of 75 frames", "0 frames dropped")
        run = t.vvr(*watch, "--brick", "1h", "--reference", "first", "--quiet")
    check("--reference first" not in run.err, run.err)


def test_what_is_damaged_is_no_wrong_address(t):
    """libav has codes of the system for it: "Input/output error", "Device or resource busy"."""
    t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=10:duration=1", "-c:v", "mpeg4", "clip.mkv")
    whole = t.path("clip.mkv").read_bytes()
    t.write("cut.mkv", whole[:whole.index(bytes.fromhex("18538067")) + 30])
    t.vvr("info", "cut.mkv").expect(3, "'cut.mkv'", "File ended prematurely", code="not-video")
    for side in (16384, 100_000):
        t.write("large.y4m", f"YUV4MPEG2 W{side} H{side} F10:1 Ip A1:1 C420\nFRAME\nxxxx")
        t.vvr("info", "large.y4m").expect(3, "'large.y4m'", "`ffprobe`", code="not-video")


def test_too_few_files_are_said(t):
    skip_with_sanitizers("open files of their own")
    t.clip("clip.avi", seconds=1)
    few = (4, 4)  # three are open, the log takes the fourth
    t.vvr("info", "clip.avi", "--log-file", "log.txt", preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, few)).expect(
        2, "'clip.avi'", "Too many open files", "`ulimit -n`", code="too-many-open-files")


def test_a_filter_that_a_manifest_invents_is_its_fault(t):
    t.clip("clip.avi", seconds=1)
    t.vvr("extract", "clip.avi", "-o", "data", "--quiet").expect(0)
    manifest = t.path("data/manifest.json").read_text()
    t.write("data/manifest.json", manifest.replace('"filter": "difference"', '"filter": "diference"'))
    t.vvr("render", "data", "-o", "out.png").expect(
        2, "'data/manifest.json'", "'settings.filter'", "'diference'", "`vvr extract`", code="file-invalid")


def test_archive_keeps_to_its_folder(t):
    """A link to / leads to all of the machine, and /proc and /sys hold no clips."""
    t.clip("in/clip.avi", seconds=1)
    for name, to in (("root", "/"), ("above", ".."), ("proc", "/proc"), ("sys", "/sys")):
        os.symlink(to, t.path("in") / name)
    run = t.archive("in", "-o", "out", "--dry-run", timeout=20)
    for name in ("root", "above"):
        check(f"'in/{name}': it is a symbolic link" in run.err, run.err)
    check(run.err.count("vvr: ") == 2, run.err)
    check(run.out.count("\n") == 1 and "clip.avi" in run.out, run.out)


def test_a_clip_with_absurd_times_holds_up_no_archive(t):
    """Its clock jumps by 30 million years; and sidecars say the like."""
    t.old_clips("a.avi")
    t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=10:duration=3", "-c:v", "mpeg4", "b.mkv")
    t.ffmpeg("-i", "b.mkv", "-c", "copy", "-bsf:v", "setts=ts='if(lt(N,15),N*100,1000000000000000000+N*100)'", "in/jump.mkv")
    t.stamp("in/jump.mkv", -86400)
    archive = ("archive", "in", "-o", "out", *QUICK)
    t.zone("Europe/Berlin")
    t.vvr(*archive, timeout=60).expect(0, "2 clips drawn", "jump.mkv: its times give an impossible length of 1e+15 s")
    known = t.json("out/jump.mkv.json")
    check(known["seconds"] == 0 and known["state"] == "done", f"{known}")
    text = t.path("out/a.avi.json").read_text()
    for change in (('"seconds": 0.9', '"seconds": 1e15'), ('"recorded": null', '"recorded": "2026-11-21 4294967295:00:00"'),
                   ('"recorded": null', '"recorded": "99999-11-21 00:00:00"'), ('"modified_ns": 1', '"modified_ns": 9')):
        check(change[0] in text, f"{change} {text}")
        t.write("out/a.avi.json", text.replace(*change))
        t.vvr("archive", "-o", "out", "--write", "index", timeout=20).expect(0)
    # What can't be is no sidecar, so the clip is new.
    t.vvr(*archive, timeout=60).expect(0, "1 clip drawn")


def test_archive_writes_through_no_link(t):
    """What a link in PICTURES leads to is not the archive's."""
    t.old_clips("a/a.avi", "b/b.avi", "c/c.avi", "d/d.avi")
    victims = ["victim/sidecar", "victim/index", "victim/day", "victim/picture", "victim/dir/b.avi.png"]
    for name in victims:
        t.write(name, "precious")
    for folder in ("a", "c"):
        t.path(f"out/{folder}").mkdir(parents=True)
    links = {"a/a.avi.json": "../../victim/sidecar", "c/c.avi.png": "../../victim/picture", "index.html": "../victim/index", "b": "../victim/dir"}
    for name, to in links.items():
        t.path(f"out/{name}").symlink_to(to)
    archive = ("archive", "in", "-o", "out", *QUICK)
    t.vvr(*archive).expect(
        2, "a/a.avi failed, ", "'out/a/a.avi.json'", "c/c.avi failed, ", "'out/c/c.avi.png'", "b/b.avi failed, ", "'out/b'",
        "[not-a-folder]", "'out/index.html'", "1 clip drawn, 3 failed", code="not-a-file")
    t.vvr(*archive, "--opacity", "0.5", "--prune").expect(
        2, "'out/index.html'", "1 clip drawn, 3 failed", code="not-a-file")
    check([t.path(name).read_text() for name in victims] == ["precious"] * 5, "a link was followed")
    check(sorted(os.listdir(t.path("victim/dir"))) == ["b.avi.png"], "files were made behind a link")
    check(all(t.path(f"out/{name}").is_symlink() for name in links), "a link is gone")
    check(t.path("out/d/d.avi.png").exists(), "the others were not drawn")


def test_what_is_no_sidecar_stops_no_archive(t):
    """A pipe that nobody writes to, a device, and a file of holes with the right beginning."""
    skip_with_sanitizers("reserve more addresses than the limit here allows")
    t.old_clips("a.avi", "b.avi")
    t.path("out").mkdir()
    for name in ("q.json", "a.avi.json", "index.2026-11-21.js"):
        os.mkfifo(t.path(f"out/{name}"))
    with open(t.path("out/large.json"), "wb") as file:
        file.write(b'{\n  "vvr-archive": 1,')
        file.truncate(20 << 30)
    limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))
    run = t.vvr("archive", "in", "-o", "out", *QUICK, "--prune", timeout=60, preexec_fn=limit)
    run.expect(
        6, "'out/q.json'", "'out/large.json'", "21474836480 bytes", "a.avi failed, ", "'out/a.avi.json'",
        "1 clip drawn, 1 failed", code="not-a-file")
    check(t.path("out/index.html").exists() and t.path("out/b.avi.png").exists(), f"{t.files()}")
    t.vvr("archive", "in", "-o", "out", *QUICK, "--dry-run", timeout=20).expect(0, out=None)


def test_a_signal_ends_the_wait_for_a_lock(t):
    """One that somebody holds for good, too."""
    t.old_clips("a.avi")
    t.vvr("archive", "in", "-o", "out", *QUICK).expect(0)
    lock = open(t.path(f"out/{lock_name('index.html')}"), "w", encoding="utf-8")
    fcntl.flock(lock, fcntl.LOCK_EX)
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        run = t.start("archive", "-o", "out", "--write", "index")
        time.sleep(1)
        check(run.poll() is None, f"it did not wait: {run.returncode}")
        run.send_signal(number)
        run.wait(timeout=30)
        check(run.returncode == -number, f"{run.returncode}")
    lock.close()
    t.vvr("archive", "-o", "out", "--write", "index").expect(0, "is up to date")


@pytest.mark.nightly
def test_a_page_without_its_preview_is_a_page(t):
    """One frame whose time is 25 days late makes a film that libav can't write."""
    t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=10:duration=3", "-c:v", "flv1", "b.flv")
    t.ffmpeg("-i", "b.flv", "-c", "copy", "-bsf:v", "setts=ts='if(eq(N,15),2147480000,N*100)'", "-flvflags", "no_duration_filesize+no_metadata",
             "in/jump.flv")
    t.vvr("render", "in/jump.flv", "-o", "out.png", "--page", "out.html", "--size", "160x100", "--backend", "software").expect(
        0, "warning: the page has stills but no video preview, because FFmpeg could not encode one: cannot encode 'preview': Invalid argument")
    check(t.path("out.html").exists() and t.path("out.png").exists(), f"{t.files()}")
    t.archive("in", "-o", "out", *QUICK).expect(0, "1 clip drawn, 0 failed")


def test_no_word_of_a_driver_without_a_home(t):
    t.clip("clip.avi", seconds=1)
    t.vvr("render", "clip.avi", "-o", "out.png", *SMALL,
          env=os.environ | {"XDG_CACHE_HOME": "/nowhere/cache"}).expect(0, err="")
