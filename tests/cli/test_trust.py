"""Names, files and texts that somebody made on purpose: nothing is replaced, forged, told or waited for without end."""

import http.server
import json
import os
import resource
import threading

from harness import check

SMALL = ("--size", "320x200", "--backend", "software", "--quiet")


def test_output_never_replaces_what_is_read(t):
    """Whatever the file is called: a clip may have any name, and a link leads to it too."""
    t.clip("clip.avi", seconds=1)
    before = t.path("clip.avi").read_bytes()
    os.link(t.path("clip.avi"), t.path("clip.png"))
    os.symlink("clip.avi", t.path("link.html"))
    os.link(t.path("clip.avi"), t.path("clip.jpg"))
    t.path("frames").mkdir()
    t.ffmpeg("-i", "clip.avi", "-frames:v", "5", "frames/%03d.png")
    frame = t.path("frames/003.png").read_bytes()
    for option, name in (("-o", "clip.png"), ("-o", "link.html"), ("--report", "clip.avi")):
        t.vvr("render", "clip.avi", option, name).expect(1, f"{option} '{name}' would replace what is read, 'clip.avi'; choose another name")
    for option, name in (("--thumbnail", "clip.jpg"), ("--still", "clip.jpg"), ("--page", "link.html")):
        t.vvr("render", "clip.avi", "-o", "out.png", option, name).expect(1, f"{option} '{name}' would replace what is read")
    t.vvr("render", "frames", "-o", "frames/003.png").expect(1, "-o 'frames/003.png' would replace what is read, 'frames'")
    t.vvr("render", "clip.avi", "-o", "frames/003.png", "--reference", "frames/003.png").expect(1, "would replace what is read")
    t.vvr("render", "clip.avi", "-o", "frames/003.png", "--golden", "frames/003.png").expect(1, "would replace what is read")
    check(t.path("clip.avi").read_bytes() == before and t.path("frames/003.png").read_bytes() == frame, "something was replaced")


def test_names_forge_no_lines(t):
    """Control characters, marks that turn the direction, and lines of their own are shown as escapes."""
    for name, shown in (("x\x1b[2Jy.avi", "x\\x1b[2Jy.avi"), ("x\nvvr: all is well", "x\\nvvr: all is well"),
                        ("gpj\u202eiva.avi", "gpj\\u202eiva.avi")):
        run = t.vvr("render", name, "-o", "out.png", "--log-file", "log.txt")
        run.expect(2, shown)
        for text in (run.err, t.path("log.txt").read_text(encoding="utf-8")):
            check(not any(mark in text for mark in "\x1b\u202e") and "\nvvr: all is well" not in text, repr(text))
    t.clip("y\x1b]0;evil.avi", seconds=1)
    run = t.vvr("info", "y\x1b]0;evil.avi")
    run.expect(0, out=None)
    check("\x1b" not in run.out and "\\x1b]0;evil.avi" in run.out, repr(run.out))


def test_addresses_tell_no_secrets(t):
    """A server whose playlist is fine and whose first segment is missing: libav's words have the whole address."""
    class Playlist(http.server.BaseHTTPRequestHandler):
        def do_GET(self):
            text = b"#EXTM3U\n#EXT-X-TARGETDURATION:2\n#EXTINF:2,\nmissing.ts?token=abc\n#EXT-X-ENDLIST\n"
            good = self.path.startswith("/p.m3u8")
            self.send_response(200 if good else 404)
            self.end_headers()
            self.wfile.write(text if good else b"")

        def log_message(self, *_):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Playlist)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://user:s3cret@127.0.0.1:{server.server_port}/p.m3u8?key=k3y"
    for command in (("render", address, "-o", "out.png"), ("info", address), ("render", address, "--report", "r.json")):
        run = t.vvr(*command, "--log-file", "log.txt")
        check(run.status != 0, "the stream has no segment")
        for text in (run.out, run.err, t.path("log.txt").read_text()):
            check(not any(secret in text for secret in ("s3cret", "user:", "token", "k3y")), text)
    check("127.0.0.1" in run.err, run.err)
    server.shutdown()


def test_json_that_is_deep_is_none(t):
    deep = "[" * 200_000
    t.path("data").mkdir()
    t.write("data/manifest.json", deep)
    t.vvr("render", "data", "-o", "out.png").expect(2, "manifest.json")
    t.path("pictures").mkdir()
    t.write("pictures/a.json", '{\n  "vvr-archive": ' + deep)
    t.vvr("archive", "-o", "pictures", "--index-only").expect(0)
    t.clip("clip.avi", seconds=1)
    t.write("r.json", deep)
    t.vvr("cut", "clip.avi", "--event", "1", "--report", "r.json", "-o", "x.avi").expect(1, "'r.json' is no report")


def test_long_titles_and_names_cost_nothing(t):
    t.clip("clip.avi", seconds=1)
    t.vvr("render", "clip.avi", "-o", "out.png", "--title", "x" * 100_000, *SMALL, timeout=30).expect(0)
    t.vvr("render", "clip.avi", "-o", "{" + "a" * 40_000).expect(1, "a name has 255 bytes at most, and this has 40001")
    t.vvr("render", "clip.avi", "-o", "#" * 40_000 + ".png").expect(1, "a name has 255 bytes at most")


def test_what_has_no_end_is_no_file(t):
    t.clip("clip.avi", seconds=1)
    for option in ("--mask", "--reference", "--roi", "--seeds"):
        run = t.vvr("render", "clip.avi", "-o", "out.png", option, "/dev/zero", timeout=20)
        check(run.status in (1, 2) and "/dev/zero" in run.err, f"{option}: {run.status} {run.err}")
    t.vvr("render", "/dev/zero", "-o", "out.png", timeout=20).expect(2, "'/dev/zero' is a device")
    t.vvr("compare", "/dev/zero", "/dev/zero", timeout=20).expect(2, "'/dev/zero' is no file but a device or a pipe; give a file")
    os.mkfifo(t.path("pipe"))
    t.vvr("compare", "pipe", "pipe", timeout=20).expect(2, "'pipe' is no file but a device or a pipe")


def test_watch_waits_for_no_writer(t):
    """A pipe that nobody writes to is given as long as a camera that does not answer."""
    os.mkfifo(t.path("pipe"))
    t.vvr("watch", "pipe", "-o", "out.png", "--patience", "1", "--duration", "2s", timeout=30).expect(
        2, "cannot read 'pipe': nothing came through the pipe in time; start what writes to it (--patience)")
    t.expect_files("pipe")


def test_a_file_on_a_server_is_waited_for(t):
    """It comes all at once: no frame is late, and --reference first is not advised to who has given it."""
    t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=25:duration=4", "-c:v", "mpeg2video", "clip.ts")
    content = t.path("clip.ts").read_bytes()

    class File(http.server.BaseHTTPRequestHandler):
        def do_GET(self):
            self.send_response(200)
            self.send_header("Content-Length", str(len(content)))
            self.end_headers()
            self.wfile.write(content)

        def log_message(self, *_):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), File)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_port}/clip.ts"
    watch = ("watch", address, "-o", "out.png", "--size", "160x100", "--backend", "software")
    t.vvr(*watch, "--brick", "1s", "--reference", "first").expect(0, "3 pictures of 75 frames", "0 frames dropped")
    run = t.vvr(*watch, "--brick", "1h", "--reference", "first", "--quiet")
    check("--reference first" not in run.err, run.err)
    server.shutdown()


def test_what_is_damaged_is_no_wrong_address(t):
    """libav has codes of the system for it: "Input/output error", "Device or resource busy"."""
    t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=10:duration=1", "-c:v", "mpeg4", "clip.mkv")
    whole = t.path("clip.mkv").read_bytes()
    t.write("cut.mkv", whole[:whole.index(bytes.fromhex("18538067")) + 30])
    t.vvr("info", "cut.mkv").expect(3, "'cut.mkv' is not a video that libav knows: File ended prematurely")
    for side in (16384, 100_000):
        t.write("large.y4m", f"YUV4MPEG2 W{side} H{side} F10:1 Ip A1:1 C420\nFRAME\nxxxx")
        t.vvr("info", "large.y4m").expect(3, "'large.y4m' is not a video that libav knows: it is damaged, or its pictures are too large")


def test_too_few_files_are_said(t):
    t.clip("clip.avi", seconds=1)
    few = (4, 4)  # three are open, the log takes the fourth
    t.vvr("info", "clip.avi", "--log-file", "log.txt", preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, few)).expect(
        2, "cannot read 'clip.avi': Too many open files; raise the limit of open files (`ulimit -n`)")


def test_times_that_cannot_be_are_refused(t):
    t.clip("clip.avi", seconds=1)
    t.vvr("extract", "clip.avi", "-o", "data", "--quiet").expect(0)
    manifest = json.loads(t.path("data/manifest.json").read_text())
    manifest["frames"][-1]["pts"] = 1e300
    t.write("data/manifest.json", json.dumps(manifest))
    t.vvr("render", "data", "-o", "out.png").expect(2, "'data/manifest.json': 'frames[9].pts' is 1e+300, not a number from 0 to 9200000000000; run `vvr extract` again")


def test_a_filter_that_a_manifest_invents_is_its_fault(t):
    t.clip("clip.avi", seconds=1)
    t.vvr("extract", "clip.avi", "-o", "data", "--quiet").expect(0)
    manifest = t.path("data/manifest.json").read_text()
    t.write("data/manifest.json", manifest.replace('"filter": "difference"', '"filter": "diference"'))
    t.vvr("render", "data", "-o", "out.png").expect(
        2, "'data/manifest.json': 'settings.filter' is 'diference', which this vvr does not have; run `vvr extract` again")


def test_archive_keeps_to_its_folder(t):
    """A link to / leads to all of the machine, and /proc and /sys hold no clips."""
    t.path("in").mkdir()
    t.clip("in/clip.avi", seconds=1)
    for name, to in (("root", "/"), ("above", ".."), ("proc", "/proc"), ("sys", "/sys")):
        os.symlink(to, t.path("in") / name)
    run = t.vvr("archive", "in", "-o", "out", "--settle", "0s", "--dry-run", timeout=20)
    for name in ("root", "above"):
        check(f"'in/{name}': it is a link to a folder that holds all clips; remove it" in run.err, run.err)
    check(run.err.count("vvr: ") == 2, run.err)
    check(run.out.count("\n") == 1 and "clip.avi" in run.out, run.out)


def test_too_little_memory_is_refused_at_once(t):
    t.path("in").mkdir()
    t.vvr("archive", "in", "-o", "out", "--max-memory", "1000").expect(
        1, "--max-memory: '1000' is less than a worker takes to start; give 200M at least, 1G for most clips")


def test_no_word_of_a_driver_without_a_home(t):
    t.clip("clip.avi", seconds=1)
    run = t.vvr("render", "clip.avi", "-o", "out.png", *SMALL, env=os.environ | {"XDG_CACHE_HOME": "/nowhere/cache"})
    run.expect(0)
    check(run.err == "", run.err)
