"""Names, files and texts that somebody made on purpose: nothing is replaced, forged, told or waited for without end."""

import http.server
import json
import os
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
