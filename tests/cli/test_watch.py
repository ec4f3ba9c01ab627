"""`vvr watch`: FFmpeg serves streams on this machine, in real time where time is what is looked at."""

import contextlib
import datetime
import json
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import time

import pytest
from harness import check, page_data

pytestmark = pytest.mark.alone  # a live stream drops frames when the machine is busy with other tests

SIZE = ("--size", "320x200")


def source(t, name="cam.ts", seconds=6, rate=25, size="384x288"):
    """Something moves before an empty scene, and nothing does in the first seconds, from which the scene is learnt."""
    graph = (f"color=gray:size={size}:rate={rate}:duration={seconds}[g];color=white:size=60x60:rate={rate}:duration={seconds}[w];"
             f"[g][w]overlay=x='if(lt(t,2.5),-100,mod(90*(t-2.5),{size.split('x')[0]}))':y=120:shortest=1")
    t.ffmpeg("-filter_complex", graph, "-c:v", "libx264", "-preset", "ultrafast", "-g", str(rate), "-bf", "0", name)
    return name


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Server:
    """FFmpeg, sending a file to an address; gone at the end of the block."""

    def __init__(self, t, url, clip="cam.ts", form=("-f", "mpegts"), real_time=True, begin=0, loop=False):
        pace = ("-re",) if real_time else ()
        again = ("-stream_loop", "-1") if loop else ()
        self.child = subprocess.Popen(["ffmpeg", "-v", "error", *pace, *again, "-ss", str(begin), "-i", clip, "-c", "copy", *form, url],
                                      cwd=t.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                      stderr=subprocess.DEVNULL)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.kill()

    def kill(self):
        self.child.kill()
        self.child.wait()


class Watch:
    """vvr at its work."""

    def __init__(self, t, *arguments, **options):
        self.log = open(t.path("stderr"), "w+", encoding="utf-8")
        self.child = subprocess.Popen([t.vvr_path, "watch", *arguments], cwd=t.folder, stdout=subprocess.DEVNULL,
                                      stderr=self.log, **({"stdin": subprocess.DEVNULL} | options))

    def said(self):
        self.log.seek(0)
        return self.log.read()

    def wait_for(self, text, seconds=30, times=1):
        until = time.monotonic() + seconds
        while self.said().count(text) < times:
            check(time.monotonic() < until and self.child.poll() is None, f"expected {text}: {self.said()}")
            time.sleep(0.05)

    def end(self, status=0, seconds=60):
        try:
            check(self.child.wait(timeout=seconds) == status, f"status {self.child.returncode}: {self.said()}")
        finally:
            self.child.kill()
        return self.said()


def listening(port):
    """Waits until somebody listens, without connecting."""
    for _ in range(100):
        with open("/proc/net/tcp", encoding="ascii") as table:
            if any(line.split()[1].endswith(f":{port:04X}") and line.split()[3] == "0A" for line in table.readlines()[1:]):
                return
        time.sleep(0.05)
    raise AssertionError(f"nobody listens on {port}")


def figures(said):
    """Of the last line: pictures, frames, seconds, median and longest latency, dropped, reconnections."""
    found = re.search(r"(\d+) pictures? of (\d+) frames? in ([\d.]+) s; ([\d.]+) s from frame to picture \(median\), ([\d.]+) s "
                      r"at most; (\d+) frames? dropped, (\d+) reconnections?", said)
    check(found, said)
    names = ("pictures", "frames", "seconds", "median", "longest", "dropped", "reconnections")
    return dict(zip(names, map(float, found.groups())))


def red_pixels(t, name):
    """Those of the hatching on the ruler, above the volume."""
    raw = t.raw(name, "rgb24", "-vf", "crop=iw:ih*0.45:0:0")
    return sum(raw[i] > 150 and raw[i + 1] < 110 and raw[i + 2] < 110 for i in range(0, len(raw), 3))


@contextlib.contextmanager
def stream(t, url=None, **server):
    """FFmpeg waits for who connects by TCP, and sends cam.ts. Gives the address; one that is given is used again."""
    url = url or f"tcp://127.0.0.1:{free_port()}"
    with Server(t, url + "?listen=1", **server):
        listening(int(url.rsplit(":", 1)[1]))
        yield url


def watched(t, *options, output="out.{brick}.png", **server):
    """A stream to its end."""
    with stream(t, **server) as url:
        return Watch(t, url, "-o", output, "--brick", "1s", "--window", "3", *SIZE, *options).end()


# The longest come first: the others run beside them.
def test_watch_shows_gaps(t):
    source(t, seconds=30)
    with stream(t) as url:
        watch = Watch(t, url, "-o", "out.{brick}.png", "--brick", "1s", "--window", "16", *SIZE, "--duration", "17s", "--start-time",
                      "2026-11-21 08:00:00", "--show", "volume,outline,ruler,title", "--color", "transfer")
        watch.wait_for("brick 0")
    before = sorted(name for name in t.files() if name.startswith("out."))
    check(red_pixels(t, before[-1]) < 5, f"hatched without a gap: {red_pixels(t, before[-1])}")
    for times, begin in enumerate((8, 16), 1):
        time.sleep(1.5)
        with stream(t, url, begin=begin):
            watch.wait_for("reconnected to", 20, times)
            time.sleep(3.5)
    said = watch.end()
    now = figures(said)
    check(now["reconnections"] >= 2 and said.count("lost the connection") >= 2, said)
    numbers = sorted(int(name.split(".")[1]) for name in t.files() if name.startswith("out."))
    check(len(numbers) == now["pictures"] and numbers[-1] > len(numbers), f"bricks without a frame have pictures: {numbers}")
    check(red_pixels(t, f"out.{numbers[-1]}.png") > 40, f"no hatching in out.{numbers[-1]}.png")


def test_render_of_a_live_stream_is_refused(t):
    """It has no end, and can't be read twice."""
    source(t)
    for command in (("render", "-o", "out.png"), ("render", "-o", "out.png", "--end", "1s"), ("extract", "-o", "data")):
        with stream(t, loop=True) as url:
            said = t.vvr(command[0], url, *command[1:]).expect(
                1, "`vvr watch`", "ffmpeg -i ADDRESS -t 60 -c copy part.mkv", code="input-unsuitable").err
            check((f"opening '{url}'" in said) == (command[0] == "render"), said)
    t.expect_files("cam.ts")


def test_watch_ends_when_asked(t):
    source(t, seconds=30)
    for number in (signal.SIGTERM, signal.SIGINT):
        with stream(t) as url:
            watch = Watch(t, url, "-o", "out.png", "--brick", "10s", *SIZE, "--log-file", "watch.log")
            watch.wait_for("frames per second")
            time.sleep(3.5)
            watch.child.send_signal(number)
            said = watch.end(0, seconds=10)
        check(figures(said)["pictures"] == 1, said)
        t.expect_picture(size=(320, 200))
        t.path("out.png").unlink()
    # Before there is anything to be seen.
    with stream(t) as url:
        watch = Watch(t, url, "-o", "out.png", *SIZE)
        watch.wait_for("frames per second")
        watch.child.send_signal(signal.SIGTERM)
        check("0 pictures of 0 frames" in watch.end(0, seconds=10), watch.said())
    t.expect_files("cam.ts", "stderr", "watch.log")


def test_watch_over_tcp(t):
    source(t)
    said = watched(t, "--duration", "5s")
    now = figures(said)
    check(now["dropped"] == 0 and now["reconnections"] == 0 and now["pictures"] >= 2, said)
    for i in range(int(now["pictures"])):
        t.expect_picture(f"out.{i}.png", size=(320, 200))
    check("brick 1, 20" in said, said)


@pytest.mark.slow
def test_watch_over_udp(t):
    source(t)
    url = f"udp://127.0.0.1:{free_port()}"
    with Server(t, url, loop=True):
        said = Watch(t, url, "-o", "out.png", "--brick", "1s", *SIZE, "--duration", "5s", "--patience", "3").end()
    check(figures(said)["pictures"] >= 1, said)


@pytest.mark.slow
def test_watch_over_http(t):
    source(t)
    port = free_port()
    with Server(t, f"http://127.0.0.1:{port}/cam.ts", form=("-f", "mpegts", "-listen", "1")):
        listening(port)
        said = Watch(t, f"http://127.0.0.1:{port}/cam.ts?token=secret", "-o", "out.png", "--brick", "1s", *SIZE, "--duration",
                     "5s").end()
    check(figures(said)["pictures"] >= 2 and "secret" not in said, said)
    t.expect_picture(size=(320, 200))


@pytest.mark.slow
def test_watch_over_rtsp(t):
    """From a server of Debian's, rtsp-server-perl."""
    if not shutil.which("rtsp-server-perl"):
        pytest.skip("rtsp-server-perl is not installed; scripts/test --all does it")
    source(t, seconds=20)
    clients, sources, rtp = free_port(), free_port(), 20000 + 2 * (os.getpid() % 10000)
    server = subprocess.Popen(["rtsp-server-perl", "--clientport", str(clients), "--serverport", str(sources), "--rtp_start_port",
                               str(rtp), "--client_listen_address", "127.0.0.1", "--source_listen_address", "127.0.0.1"],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        listening(sources)
        with Server(t, f"rtsp://127.0.0.1:{sources}/cam", form=("-f", "rtsp", "-rtsp_transport", "udp")):
            time.sleep(2)
            said = Watch(t, f"rtsp://user:secret@127.0.0.1:{clients}/cam", "-o", "out.png", "--brick", "1s", *SIZE, "--duration",
                         "6s").end()
    finally:
        server.kill()
        server.wait()
    check(figures(said)["pictures"] >= 2 and "secret" not in said, said)


def test_watch_a_pipe_drops_nothing(t):
    source(t, seconds=8)
    with t.path("cam.ts").open("rb") as clip:
        cat = subprocess.Popen(["cat"], stdin=clip, stdout=subprocess.PIPE)
        said = Watch(t, "-", "-o", "out.{brick}.png", "--brick", "2s", *SIZE, stdin=cat.stdout).end()
        cat.stdout.close()
        cat.wait()
    now = figures(said)
    check(now["dropped"] == 0 and now["frames"] == 150 and now["pictures"] == 3, said)
    # A named pipe and a file, which end as well.
    os.mkfifo(t.path("fifo"))
    feeder = subprocess.Popen(["bash", "-c", "cat cam.ts >fifo"], cwd=t.folder)
    check(figures(Watch(t, "fifo", "-o", "fifo.png", "--brick", "2s", *SIZE).end())["frames"] == 150, "named pipe")
    feeder.wait()
    said = Watch(t, "cam.ts", "-o", "file.png", "--brick", "2s", "--reference", "first", *SIZE).end()
    check(figures(said)["frames"] == 199, said)
    check(t.path("fifo.png").read_bytes()[:4] == b"\x89PNG", "no picture of the named pipe")


def test_watch_keeps_the_hole_of_a_file_or_a_pipe(t):
    """Both are read in a moment, so the clock of the machine says nothing about the minute in which nothing was recorded."""
    source(t, seconds=8)
    t.ffmpeg("-i", "cam.ts", "-vf", "setpts=PTS+gte(N\\,150)*60/TB", "-vsync", "0", "-c:v", "libx264", "-preset", "ultrafast", "-bf", "0",
             "2026-11-21_08-00-00.ts")
    look = ("-o", "out.png", "--brick", "2s", "--reference", "first", *SIZE)
    said = Watch(t, "2026-11-21_08-00-00.ts", *look).end()
    check(67 < figures(said)["seconds"] < 69, said)
    check("to 08:01:07 (by file name)" in said, f"the time of day after the hole: {said}")
    with t.path("2026-11-21_08-00-00.ts").open("rb") as clip:
        cat = subprocess.Popen(["cat"], stdin=clip, stdout=subprocess.PIPE)
        said = Watch(t, "-", *look, stdin=cat.stdout).end()
        cat.stdout.close()
        cat.wait()
    check(67 < figures(said)["seconds"] < 69, said)
    check(said.count("warning: '-' comes faster than it was recorded, so its times of day are ahead of the clock; give --start-time none") == 1, said)


def test_watch_of_a_finished_file_is_not_now(t):
    """What is in a file has been: its clock is that of its name, or none, and `render` is meant."""
    source(t)
    t.stamp("cam.ts", -60)
    look = ("--brick", "2s", "--reference", "first", *SIZE)
    said = Watch(t, "cam.ts", "-o", "cam.html", *look).end()
    check("warning: 'cam.ts' is a complete file, not a live stream; `vvr render` draws all of it" in said, said)
    check("brick 0, 0.0 s to " in said and time.strftime("%Y-") not in said, said)
    data = page_data(t.path("cam.html").read_text(encoding="utf-8"))
    check(data["clock"] is None, str(data["clock"]))
    t.path("cam.ts").rename(t.path("2026-11-21_08-00-00.ts"))
    said = Watch(t, "2026-11-21_08-00-00.ts", "-o", "named.png", *look).end()
    check("brick 0, 2026-11-21 08:00:00 to " in said and "(by file name)" in said and "is a complete file" in said, said)
    os.utime(t.path("2026-11-21_08-00-00.ts"))
    said = Watch(t, "2026-11-21_08-00-00.ts", "-o", "named.png", *look).end()
    check("warning: '2026-11-21_08-00-00.ts' is a growing file, not a live stream; vvr ends where it ends now; `tail -c +1 -f`" in said, said)


@pytest.mark.slow
def test_watch_draws_the_last_seconds_before_an_outage(t):
    """A camera is cut off in the middle of a brick, for longer than the window: what it showed is in a picture."""
    source(t, seconds=30)
    with stream(t) as url:
        watch = Watch(t, url, "-o", "out.{brick}.png", "--brick", "2s", "--window", "1", *SIZE, "--reference", "first", "--duration", "20s")
        watch.wait_for("brick 0")
        time.sleep(1)
    time.sleep(5)
    with stream(t, url, begin=16):
        watch.wait_for("reconnected to", 20)
        watch.wait_for("brick 1,", 10)
        time.sleep(3)
    said = watch.end()
    first, last = re.search(r"brick 1, .*? ([0-9:]+) to ([0-9:]+)", said).groups()
    seconds = [sum(int(part) * unit for part, unit in zip(moment.split(":"), (3600, 60, 1))) for moment in (first, last)]
    check(0 <= (seconds[1] - seconds[0]) % 86400 <= 2, f"brick 1 is not of the time before the outage: {said}")


def test_watch_keeps_the_clock_across_an_outage(t):
    """A decoder gives its last frame when the connection is given up: that frame did not arrive then."""
    source(t, seconds=30)
    url = f"udp://127.0.0.1:{free_port()}"
    with Server(t, url):
        watch = Watch(t, url, "-o", "out.png", "--brick", "1s", "--window", "2", *SIZE, "--reference", "first", "--patience", "4", "--log-file",
                      "watch.log", "--log-format", "json", "--duration", "25s")
        watch.wait_for("brick 1,")
    time.sleep(6)
    with Server(t, url, begin=16):
        watch.wait_for("reconnected to", 20)
        time.sleep(4)
        watch.child.terminate()
        watch.end()
    entries = [json.loads(line) for line in t.path("watch.log").read_text(encoding="utf-8").splitlines()]
    pictures = [entry for entry in entries if re.search("brick [0-9]+, ", entry["message"])]
    latest = pictures[-2]  # the last one may end within its brick
    shown = re.search(r"to (?:[0-9-]+ )?([0-9:]+) .* written ([0-9.]+) s", latest["message"])
    seconds = lambda text: sum(int(part) * unit for part, unit in zip(text.split(":"), (3600, 60, 1)))
    drawn = datetime.datetime.fromisoformat(latest["time"].replace("Z", "+00:00")).astimezone()
    late = drawn.hour * 3600 + drawn.minute * 60 + drawn.second - float(shown[2]) - seconds(shown[1])
    check(abs((late + 43200) % 86400 - 43200) <= 2.2, f"{late:.1f} s: {latest}")


def test_watch_while_nobody_sends_ends_too(t):
    source(t)
    with stream(t) as url:
        watch = Watch(t, url, "-o", "out.png", "--brick", "1s", *SIZE)
        watch.wait_for("trying again")
    watch.child.send_signal(signal.SIGTERM)
    check(figures(watch.end(0, seconds=5))["pictures"] >= 1, watch.said())


@pytest.mark.slow
def test_watch_falls_behind_gracefully(t):
    # Sent as fast as can be, at a size at which no machine keeps up.
    source(t, seconds=20, size="1280x720")
    said = watched(t, "--field-size", "source", "--duration", "18s", "--reference", "first", real_time=False)
    now = figures(said)
    check(now["dropped"] > 20 and now["frames"] + now["dropped"] > 300, said)
    check(now["longest"] < 8, said)


def test_watch_a_page(t):
    source(t)
    said = watched(t, "--duration", "5s", "--title", "<b>Gate</b>", output="live.html")
    page = t.path("live.html").read_text(encoding="utf-8")
    check('"live":{"state":"learning the empty scene' in page and '"brick":1' in page and "connect-src 'self'" in page, page[:2000])
    check("&lt;b&gt;Gate&lt;/b&gt;" in page and "<b>Gate" not in page, page[:2000])
    check("'live.html': brick 1" in said and "data:image/png;base64," in page, said)


def test_watch_refuses(t):
    t.clip()
    t.write("text.txt", "no video")
    t.path("folder").mkdir()
    for arguments, status, code, *texts in [
        (("clip.avi",), 1, "output-missing", "-o FILE"),
        (("-o", "out.png"), 1, "input-missing", "INPUT"),
        (("clip.avi", "-o", "out.gif"), 1, "output-format-unknown", "'out.gif'"),
        (("clip.avi", "-o", "out.png", "--start", "3s"), 1, "option-unknown", "--start"),
        (("clip.avi", "-o", "out.png", "--end", "3s"), 1, "option-unknown", "--end", "--duration"),
        (("clip.avi", "-o", "out.png", "--between", "02:00-05:00"), 1, "option-unknown", "--between"),
        (("clip.avi", "-o", "out.png", "--start-time", "container"), 1, "choice-unknown", "--start-time"),
        (("clip.avi", "-o", "out.png", "--reference", "median"), 1, "options-conflict", "--reference median"),
        (("clip.avi", "-o", "out.png", "--start-time", "recorded"), 1, "choice-unknown", "--start-time"),
        (("clip.avi", "-o", "out.png", "--seeds", "folder"), 1, "options-conflict", "--seeds"),
        (("clip.avi", "-o", "out.png", "--patience", "0"), 1, "option-value-out-of-range", "--patience", "0.5s to 3600s"),
        (("missing.ts", "-o", "out.png"), 2, "file-not-found", "'missing.ts'", "No such file", "rtsp://camera/stream"),
        (("tcp://127.0.0.1:1", "-o", "out.png"), 2, "stream-unreachable", "'tcp://127.0.0.1:1'", "Connection refused"),
        (("folder", "-o", "out.png"), 1, "input-unsuitable", "'folder'", "`vvr render`"),
        (("clip.avi", "-o", "none/out.png"), 2, "file-not-found", "'none'", "mkdir -p 'none'"),
        (("text.txt", "-o", "out.png"), 3, "not-video", "'text.txt' is not a video, but a text file", "give a video"),
        (("/dev/null", "-o", "out.png"), 3 if device_library() else 1, "not-video" if device_library() else "usage", "/dev/null"),
        (("clip.avi", "-o", "out.png", "--log-file", "none/log"), 2, "file-not-found", "'none/log'"),
    ]:
        t.vvr("watch", *arguments).expect(status, *texts, code=code)
    t.ffmpeg("-i", "clip.avi", "-t", "1", "short.avi")
    t.vvr("watch", "short.avi", "-o", "out.png").expect(3, "'short.avi'", code="not-video")
    port = free_port()
    with socket.socket() as mute:
        mute.bind(("127.0.0.1", port))
        mute.listen()
        t.vvr("watch", f"tcp://127.0.0.1:{port}", "-o", "out.png", "--patience", "1").expect(
            2, f"'tcp://127.0.0.1:{port}'", code="stream-timeout")
    t.expect_files("clip.avi", "folder", "short.avi", "text.txt")


def device_library():
    return "libavdevice.so" in subprocess.run(["/sbin/ldconfig", "-p"], stdout=subprocess.PIPE, check=False).stdout.decode()


def test_logs_for_machines(t):
    t.clip()
    t.render("clip.avi", "--log-file", "log.json", "--log-format", "json", "--quiet").expect(0)
    lines = [json.loads(line) for line in t.path("log.json").read_text(encoding="utf-8").splitlines()]
    check(lines and lines[-1]["level"] == "info" and "'out.png': 20 frames" in lines[-1]["message"], f"{lines}")
    check(re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d+)?Z", lines[-1]["time"]), f"{lines}")
    told = t.render("clip.avi", "--log-format", "json").expect(0)
    check(json.loads(told.err)["level"] == "info", str(told))
    for order in (["--log-format", "json", "--nonsense"], ["--nonsense", "--log-format=json"]):
        told = t.render("clip.avi", *order).expect(1)
        check(json.loads(told.err)["code"] == "option-unknown", str(told))
    t.render("missing.avi", "--log-file", "log.txt", "--quiet").expect(2, code="file-not-found")
    t.render("clip.avi", "--log-file", "log.txt").expect(0, "vvr: 'out.png'")
    text = t.path("log.txt").read_text(encoding="utf-8")
    check(len(text.splitlines()) == 2 and "Z vvr: cannot read 'missing.avi'" in text, text)


def test_logs_that_are_rotated(t):
    source(t, seconds=8)
    with stream(t) as url:
        watch = Watch(t, url, "-o", "out.png", "--brick", "1s", *SIZE, "--log-file", "log", "--duration", "6s")
        watch.wait_for("brick 0")
        t.path("log").rename(t.path("log.1"))
        watch.end()
    check("brick 0" in t.path("log.1").read_text(encoding="utf-8"), "nothing in the old log")
    check("pictures of" in t.path("log").read_text(encoding="utf-8"), "nothing in the new log")


@pytest.mark.slow
def test_watch_takes_the_memory_of_its_window(t):
    """Of one run, as the order of allocations, and the peak with it, differs from run to run."""
    source(t, seconds=30)
    feed = subprocess.Popen(["ffmpeg", "-v", "error", "-stream_loop", "-1", "-i", "cam.ts", "-c", "copy", "-t", "1800", "-f", "mpegts", "-"],
                            cwd=t.folder, stdout=subprocess.PIPE)
    with feed, feed.stdout:
        watch = Watch(t, "-", "-o", "out.png", "--brick", "20s", "--window", "2", *SIZE, "--reference", "first", stdin=feed.stdout)
        peaks = []
        for brick in (12, 85):
            watch.wait_for(f"brick {brick},", seconds=300)
            status = pathlib.Path(f"/proc/{watch.child.pid}/status").read_text(encoding="ascii")
            peaks.append(int(re.search(r"VmHWM:\s+(\d+) kB", status)[1]) / 1e3)
        watch.end()
    print(f"{peaks[0]:.1f} MB after 4 minutes, {peaks[1]:.1f} MB after 28")
    check(peaks[1] < 1.05 * peaks[0], f"{peaks[0]:.1f} and {peaks[1]:.1f} MB")
