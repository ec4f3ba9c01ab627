"""What the command line's tests share: the means to make clips, run vvr and check what it did."""

import contextlib
import hashlib
import http.server
import json
import os
import pathlib
import re
import shutil
import subprocess
import threading
import time
from dataclasses import dataclass

import png
import pytest


def check(condition, text):
    """Fails the test with a text where a condition doesn't hold."""
    __tracebackhide__ = True
    if not condition:
        raise AssertionError(text)


def skip_with_sanitizers(why):
    """Skips a test that a program with sanitizers can't pass: `why` says what they do."""
    if "ASAN_OPTIONS" in os.environ:
        pytest.skip(f"sanitizers {why}")


def hijacked():
    """The environment in which clips take over the workers that open them."""
    skip_with_sanitizers("let no library be loaded before theirs")
    return {**os.environ, "LD_PRELOAD": os.environ["VVR_HIJACK"]}


def nightly_except(values, *daily):
    """Parameters of a test: the default set runs only those in `daily`."""
    return [value if value in daily else pytest.param(value, marks=pytest.mark.nightly) for value in values]


def fnv1a(text):
    """The hash that vvr makes names of hidden files and shares of clips with."""
    number = 0xcbf29ce484222325
    for byte in os.fsencode(text):
        number = (number ^ byte) * 0x100000001b3 % 2**64
    return number


def lock_name(name):
    """The hidden file of the claim to the files of that name."""
    return f".vvr-{fnv1a(name):016x}.lock"


def part_name(name, number=0):
    """The hidden file in which a file of that name is written."""
    return f".vvr-{fnv1a(name):016x}-{number}.part"


@dataclass
class Result:
    command: str
    status: int
    out: str
    err: str

    def expect(self, status, *texts, code=None, out="", err=None):
        """The exit status, the error's code, parts of stderr, and all of stdout and of stderr (None: anything)."""
        __tracebackhide__ = True
        check(self.status == status, f"{self}\nexpected status {status}")
        check(code is None or f"[{code}]\n" in self.err, f"{self}\nexpected the code {code}")
        for text in texts:
            check(text in self.err, f"{self}\nexpected on stderr: {text}")
        check(out is None or self.out == out, f"{self}\nexpected on stdout: {out!r}")
        check(err is None or self.err == err, f"{self}\nexpected on stderr: {err!r}")
        return self

    def json(self):
        """What stdout says, as data."""
        return json.loads(self.out)

    def __str__(self):
        return f"$ {self.command}\nstatus {self.status}\nstdout: {self.out}\nstderr: {self.err}"


class Bench:
    """The folder of one test, with ways to fill it and to run vvr in it."""

    def __init__(self, vvr, source, folder, monkeypatch, made):
        self.vvr_path = vvr
        self._monkeypatch = monkeypatch
        self.source = pathlib.Path(source)
        self.folder = pathlib.Path(folder)
        self._made = made

    def zone(self, name):
        """The time zone of what runs from here to the end of the test."""
        self._monkeypatch.setenv("TZ", name)

    def run(self, command, **options):
        options = {"cwd": self.folder, "stdin": subprocess.DEVNULL, "timeout": 120} | options
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False, **options)
        text = command if isinstance(command, str) else " ".join(map(str, command))
        return Result(text, done.returncode, done.stdout.decode(errors="replace"), done.stderr.decode(errors="replace"))

    def vvr(self, *arguments, **options):
        return self.run([self.vvr_path, *arguments], **options)

    def vvr_with_permissions(self, *arguments):
        """vvr for which permissions count even if the tests run as root."""
        rights = "-dac_override,-dac_read_search"
        user = ["setpriv", f"--bounding-set={rights}", f"--inh-caps={rights}"] if os.geteuid() == 0 else []
        return self.run([*user, self.vvr_path, *arguments])

    def help(self):
        """Each command's help as data, by its name."""
        said = self.vvr("help", "--json").expect(0, out=None).json()
        return {command["name"]: command for command in said["commands"]}

    def render(self, clip, *arguments, output="out.png", **options):
        """A small and quick picture; no `output` = none."""
        return self.vvr("render", clip, *(["-o", output] if output else []), "--size", "160x100", *arguments, **options)

    def start(self, *arguments, **options):
        """A run of vvr that goes on, without a word unless the options say otherwise."""
        nothing = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.DEVNULL)
        return subprocess.Popen([self.vvr_path, *arguments], **({"cwd": self.folder} | nothing | options))

    def archive(self, clips, *arguments, **options):
        """`vvr archive` of clips that nobody writes any more: none waits for the next run."""
        self.age(clips)
        return self.vvr("archive", clips, *arguments, **options)

    def old_clips(self, *names, seconds=1):
        """Copies of one clip below the folder in, written a day ago."""
        self.clip("one.avi", seconds)
        for name in names:
            self.copy("one.avi", f"in/{name}")
            self.stamp(f"in/{name}", -86400)
        self.path("one.avi").unlink()

    def age(self, folder):
        """Makes files that were just written two minutes older."""
        for path in self.path(folder).rglob("*"):
            if path.is_symlink() or not path.is_file() or time.time() - path.stat().st_mtime > 60:
                continue
            at = path.stat()
            os.utime(path, ns=(at.st_atime_ns, at.st_mtime_ns - 120 * 10**9))

    def put_on_path(self):
        """The environment in which programs find this vvr."""
        self.path("bin").mkdir(exist_ok=True)
        if not self.path("bin/vvr").exists():
            self.path("bin/vvr").symlink_to(self.vvr_path)
        return os.environ | {"PATH": f"{self.path('bin')}:{os.environ['PATH']}"}

    def peak_memory(self, *arguments, **options):
        """Bytes at the highest of a run of vvr that succeeds."""
        child = self.start(*arguments, **options)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        check(child.returncode == 0, f"{arguments}: status {child.returncode}")
        return usage.ru_maxrss * 1024

    def path(self, name):
        return self.folder / name

    def json(self, name):
        """What a file of JSON holds."""
        return json.loads(self.path(name).read_text(encoding="utf-8"))

    def folder_of(self, name):
        """Makes the folder that a file is to be in."""
        self.path(name).parent.mkdir(parents=True, exist_ok=True)

    def write(self, name, content):
        data = content if isinstance(content, bytes) else content.encode()
        self.folder_of(name)
        self.path(name).write_bytes(data)
        return name

    def copy(self, name, *copies):
        for copy in copies:
            self.folder_of(copy)
            shutil.copyfile(self.path(name), self.path(copy))

    def stamp(self, name, seconds):
        """Says that a file was last written then: seconds since 1970, or before now if they are negative."""
        os.utime(self.path(name), (seconds if seconds >= 0 else time.time() + seconds,) * 2)

    def ffmpeg(self, *arguments):
        self.folder_of(arguments[-1])
        self.run(["ffmpeg", "-v", "error", "-y", *arguments]).expect(0)

    def clip(self, name="clip.avi", seconds=2, size="64x48", codec=("-c:v", "mpeg4", "-g", "5")):
        """A clip in which much moves, 10 frames per second."""
        return self.make(name, "clip", seconds, size, codec, how=lambda: self.ffmpeg(
            "-f", "lavfi", "-i", f"testsrc2=size={size}:rate=10:duration={seconds}", *codec, name))

    def make(self, name, *key, how):
        """A file that `how` makes, or a copy of what an earlier test of this run has made by the same key."""
        ending = pathlib.Path(name).suffix
        self.folder_of(name)
        kept = self._made / (hashlib.sha256(repr((key, ending)).encode()).hexdigest()[:24] + ending)
        if kept.exists():
            shutil.copyfile(kept, self.path(name))
            return name
        how()
        if self.path(name).is_file() and self.path(name).stat().st_size < 32e6:
            part = kept.with_name(f"{os.getpid()}{kept.name}")
            shutil.copyfile(self.path(name), part)
            part.rename(kept)
        return name

    def make_folders(self, key, *names, how):
        """Folders that `how` makes, or copies of what an earlier test of this run has made by the same key."""
        kept = self._made / key
        if kept.exists():
            for name in names:
                shutil.copytree(kept / name, self.path(name))
            return
        how()
        part = kept.with_name(f"{os.getpid()} {key}")
        for name in names:
            shutil.copytree(self.path(name), part / name)
        if not kept.exists():
            part.rename(kept)

    def scene(self, name, clip, *options):
        """A generated scene, of which everything is known."""
        command = [os.environ["VVR_SCENE"], name, clip, *options]
        return self.make(clip, name, options, how=lambda: self.run(command).expect(0))

    def files(self):
        """Everything in the folder, hidden files too."""
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*"))

    def expect_files(self, *names):
        check(self.files() == sorted(names), f"expected the files {sorted(names)}, there are {self.files()}")

    def probe(self, name, entries, *options):
        """What ffprobe says of a file."""
        said = self.run(["ffprobe", "-v", "error", *options, "-show_entries", entries, "-of", "csv=p=0", name])
        return said.out.strip().rstrip(",")

    def frames_in(self, name):
        return int(self.probe(name, "stream=nb_read_frames", "-select_streams", "v", "-count_frames"))

    def picture_size(self, name):
        header = png.header(self.path(name).read_bytes())
        if header:
            return header[:2]
        return tuple(int(number) for number in re.findall(r"\d+", self.probe(name, "stream=width,height")))

    def raw(self, name, kind="rgb24", *options):
        """The pixels of a file's frames as ffmpeg decodes them."""
        return subprocess.run(["ffmpeg", "-v", "error", "-i", name, *options, "-f", "rawvideo", "-pix_fmt", kind, "-"],
                              cwd=self.folder, stdout=subprocess.PIPE, check=True).stdout

    def rgb(self, name):
        """The rows of a picture, each of its pixels' red, green and blue, 0 to 255."""
        rows = png.rows_of(self.path(name).read_bytes())
        if rows:
            return rows
        width, _ = self.picture_size(name)
        raw = self.raw(name, "rgb24", "-frames:v", "1")
        rows = (raw[at:at + 3 * width] for at in range(0, len(raw), 3 * width))
        return [[tuple(row[i:i + 3]) for i in range(0, len(row), 3)] for row in rows]

    def columns(self, name, is_shown):
        """The columns, from 0 to 1, that have a pixel whose red, green and blue are so."""
        rows = self.rgb(name)
        return sorted({i / len(rows[0]) for row in rows for i, pixel in enumerate(row) if is_shown(*pixel)})

    def expect_picture(self, name="out.png", size=(160, 100)):
        check(os.path.exists(self.path(name)), f"there is no {name}")
        check(self.picture_size(name) == size, f"{name} is {self.picture_size(name)}, not {size}")


def page_data(text):
    """What a page or an index, given as its text, has for its scripts."""
    return json.loads(re.search(r'id="data">(.*?)</script>', text, re.DOTALL)[1])


def send(request, content, status=200):
    """An answer of HTTP."""
    request.send_response(status)
    request.send_header("Content-Length", str(len(content)))
    request.end_headers()
    request.wfile.write(content)


@contextlib.contextmanager
def http_server(answer):
    """A server on this machine that answers each request by `answer(request)`, or with these bytes. Gives HOST:PORT."""
    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self):
            if callable(answer):
                answer(self)
            else:
                send(self, answer)

        def log_message(self, *_):
            pass

    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"127.0.0.1:{server.server_port}"
        server.shutdown()


def without_colours(t, folder):
    """Removes the frames' pictures from an extraction."""
    shutil.rmtree(t.path(folder) / "color")
    manifest = t.path(folder) / "manifest.json"
    manifest.write_text(manifest.read_text().replace('"color": true', '"color": false'))


def moving_clip(t, frames=40, step=1.5):
    """Makes clip.mkv: a textured square that crosses an empty scene, 10 frames per second."""
    seconds = frames / 10
    return t.make("clip.mkv", "moving", frames, step, how=lambda: t.ffmpeg(
        "-f", "lavfi", "-i", f"color=gray:size=96x64:rate=10:duration={seconds}", "-f", "lavfi", "-i",
        f"testsrc2=size=24x24:rate=10:duration={seconds}", "-filter_complex", f"[0][1]overlay=x='2+{step}*n':y=20",
        "-c:v", "ffv1", "clip.mkv"))
