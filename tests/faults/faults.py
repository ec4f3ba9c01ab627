"""Runs of vvr in which a call fails or which are killed, and what has to hold after each: for tests/cli/test_faults.py."""

import json
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import time
import zlib
from dataclasses import dataclass, field

CALLS = ("open", "write", "fsync", "rename", "read", "malloc", "mmap", "pthread_create", "clock")
DOCUMENTED = (0, 1, 2, 3, 4, 5, 6)  # docs/cli.md, "exit status"; 7 belongs to --golden, and 70 is a bug
PATIENCE = 20  # seconds, after which a run hangs
MANIFEST = "data/manifest.json"
OLDER = b"an older file\n"
MEASURED = {"took_seconds", "peak_memory_bytes", "tries", "timings"}  # in JSON, what differs from run to run
# Through these goes everything that is thrown or aborted: who did it comes after them in a backtrace.
RUNTIME = ("libc.so", "libstdc++.so", "libgcc_s.so", "ld-linux", "libvvr_fail_nth.so", "libpthread")
# OpenGL's driver, whose crashes where memory is short are its own: Mesa checks few of its allocations, LLVM aborts.
MESA = ("_dri.so", "libEGL", "libOSMesa", "libgallium", "libLLVM", "libGLX", "libglapi", "libgbm", "libdrm")

# A library of OpenVDB's, which comes with OpenImageIO. It starts its threads as it is loaded, and calls std::terminate or
# waits for ever when it gets some of them and not all. vvr tries before whether there are as many threads.
LOG4CPLUS = ("liblog4cplus",)
# libc itself ends a program that has no memory for a library's thread-local variables.
NO_THREAD_LOCAL = "cannot allocate memory for thread-local data: ABORT"
# What glad generates to load OpenGL's functions is linked into vvr. It checks no allocation as it reads the extensions.
GLAD = ("glad",)
OTHERS = MESA + LOG4CPLUS + GLAD

SMALL = ("--size", "64x40", "--backend", "software", "--threads", "2")
RENDER = ("render", "{in}/clip.avi", "-o")


@dataclass(frozen=True)
class Scene:
    """One use of vvr, small, in a folder that holds nothing else."""
    name: str
    command: tuple
    files: tuple  # that there are before, with other bytes; a run replaces them or leaves them
    process: str = "main"  # the one in which calls fail: main or worker


SCENES = (
    Scene("png", (*RENDER, "out.png", "--report", "out.json", *SMALL), ("out.png", "out.json")),
    Scene("exr", (*RENDER, "out.exr", "--report", "out.json", *SMALL), ("out.exr", "out.json")),
    Scene("html", (*RENDER, "out.png", "--page", "out.html", "--report", "out.json", *SMALL), ("out.png", "out.html", "out.json")),
    Scene("extract", ("extract", "{in}/keys.avi", "-o", "data", "--threads", "2"), ()),
    Scene("archive", ("archive", "{in}/clips", "-o", "pictures", "--jobs", "1", "--size", "64x40", "--backend", "software"), ()),
    Scene("worker", ("archive", "{in}/one", "-o", "pictures", "--jobs", "1", "--size", "64x40", "--backend", "software",
                     "--sandbox", "off"), (), "worker"),
    Scene("recording", ("render", "{in}/day", "-o", "out.png", "--report", "out.json", *SMALL), ("out.png", "out.json")),
    Scene("day", ("archive", "{in}/days", "-o", "pictures", "--per", "day", "--jobs", "1", "--size", "64x40", "--backend", "software"), ()),
    Scene("cut", ("cut", "{in}/day", "--start", "0.5s", "--end", "1.5s", "-o", "piece.avi"), ("piece.avi",)),
    Scene("watch", ("watch", "{in}/cam.ts", "-o", "out.png", "--brick", "1s", "--reference", "first", "--start-time",
                    "2026-11-21 08:00:00", *SMALL), ("out.png",)),
)


def make_inputs(folder):
    """The clips of all scenes, of a second or two."""
    for name in ("clips", "one", "day", "days/gate", "days/hall"):
        (folder / name).mkdir(parents=True)

    def ffmpeg(seconds, codec, name):
        subprocess.run(["ffmpeg", "-v", "error", "-y", "-f", "lavfi", "-i", f"testsrc2=size=64x48:rate=10:duration={seconds}",
                        *codec, folder / name], check=True, stdin=subprocess.DEVNULL)

    ffmpeg(1, ("-c:v", "mpeg4", "-g", "5"), "clip.avi")
    ffmpeg(4, ("-c:v", "mpeg4", "-g", "1"), "keys.avi")  # enough key frames for the empty scene: each is decoded alone
    ffmpeg(2, ("-c:v", "libx264", "-preset", "ultrafast", "-g", "10", "-bf", "0"), "cam.ts")
    day = ("20261120_080000.avi", "20261120_080001.avi")
    for name in ("clips/a.avi", "clips/b.avi", "one/a.avi", *(f"{folder}/{name}" for folder in ("day", "days/gate", "days/hall") for name in day)):
        shutil.copy(folder / "clip.avi", folder / name)
        os.utime(folder / name, (time.time() - 86400,) * 2)  # nobody still writes it


@dataclass
class Run:
    status: int
    said: str
    log: list  # lines of fail_nth
    seconds: float


UNDOCUMENTED = "ends with an undocumented status"
WORKER_CRASHES = "a worker crashes"
CRASHES = (UNDOCUMENTED, WORKER_CRASHES)

# It goes on with the part of its configuration that it could read, and tells nobody: letters may look another way then.
SILENT = "libfontconfig"


@dataclass
class Finding:
    """Something that must not be, with what repeats it."""
    what: str
    scene: str
    fault: str
    run: Run
    whose: str = "vvr"

    @property
    def is_others(self):
        """Whether it is what vvr can't help: a crash within a library, or a wait for one that is known."""
        known = any(part in self.whose for part in OTHERS)
        looks_other = SILENT in self.whose and ("draws another" in self.what or "missing [], other bytes" in self.what)
        return known or looks_other or (self.what in CRASHES and ".so" in self.whose and "libvvr" not in self.whose)

    def __str__(self):
        said = "\n    ".join(self.run.said.strip().splitlines()[-4:])
        crash = "\n    ".join(line[:700] for line in self.run.log if line.startswith(("crash", "fault")))
        return f"{self.scene} {self.fault}: {self.what} ({self.whose}), status {self.run.status}\n    {said}\n    {crash}"


def function_at(place):
    """The name of the function at FILE+OFFSET, where the file has names."""
    file, offset = place.rsplit("+", 1)
    found = subprocess.run(["addr2line", "-fe", file, offset], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
    return found.stdout.decode(errors="replace").split("\n")[0]


def culprit(log):
    """Whose a crash is, by its backtrace: the first file that is none of the runtime's. Of a hang, who asked for what failed."""
    for kind in ("crash", "fault"):
        for line in log:
            if not line.startswith(kind):
                continue
            places = line.split()[3 if kind == "crash" else 4:]
            files = [pathlib.Path(place.rsplit("+", 1)[0]).name for place in places]
            for i, name in enumerate(files):
                # What vvr itself does when nobody catches what is thrown stands before who threw it.
                catches = ".so" not in name and any("libstdc++" in later for later in files[i + 1:i + 2])
                if not catches and not any(part in name for part in RUNTIME):
                    return "glad" if ".so" not in name and function_at(places[i]).startswith("glad") else name
    return "vvr"


def is_whole_png(data):
    """Chunk for chunk, to the end."""
    at = 8
    while data[:8] == b"\x89PNG\r\n\x1a\n" and at + 12 <= len(data):
        length = int.from_bytes(data[at:at + 4], "big")
        kind = data[at + 4:at + 8 + length]
        if int.from_bytes(data[at + 8 + length:at + 12 + length], "big") != zlib.crc32(kind):
            return False
        at += 12 + length
        if kind == b"IEND":
            return at == len(data)
    return False


def is_whole_exr(data):
    """Its table of chunks, which is written last, is complete, and the last chunk ends the file."""
    def number(at, size):
        return int.from_bytes(data[at:at + size], "little")

    at = 8
    while data[at:at + 1] not in (b"", b"\0"):  # an attribute: name, type, size, value
        kind = data.find(b"\0", at) + 1
        size = data.find(b"\0", kind) + 1
        if kind == 0 or size == 0:
            return False
        at = size + 4 + number(size, 4)
    table = at + 1
    chunks = [number(place, 8) for place in range(table, number(table, 8), 8)]
    return len(chunks) > 0 and min(chunks) > table and max(chunks) + 8 + number(max(chunks) + 4, 4) == len(data)


def is_whole_seed_list(data):
    """It has as many points as its header says, each on a line of its own."""
    head, _, points = data.partition(b"# x y u v flag\n")
    count = re.search(rb"^points (\d+)$", head, re.MULTILINE)
    lines = points.splitlines(keepends=True)
    return (data.startswith(b"vvr-seeds 1\n") and count is not None and len(lines) == int(count[1])
            and all(len(line.split()) == 5 and line.endswith(b"\n") for line in lines))


def without_measures(value):
    if isinstance(value, dict):
        return {key: without_measures(inner) for key, inner in value.items()
                if key not in MEASURED and not (key == "seconds" and isinstance(inner, dict))}
    return [without_measures(inner) for inner in value] if isinstance(value, list) else value


def content(path):
    """What has to be the same in each run."""
    data = path.read_bytes()
    if path.suffix != ".json" or data == OLDER:
        return data
    try:
        return without_measures(json.loads(data))
    except ValueError:
        return data


def is_hidden(name):
    return any(part.startswith(".vvr-") for part in pathlib.PurePath(name).parts)


@dataclass
class Walk:
    """Runs scenes with faults in a folder, and keeps account."""
    vvr: str
    library: str
    folder: pathlib.Path
    findings: list = field(default_factory=list)
    whole: dict = field(default_factory=dict)  # by scene, the files of a run without faults
    words: dict = field(default_factory=dict)  # by scene, what it says
    counts: dict = field(default_factory=dict)  # by scene and call, how many calls there are
    lasted: dict = field(default_factory=dict)

    def __post_init__(self):
        self.folder = pathlib.Path(self.folder)
        self.inputs = self.folder / "in"
        # A fault while fontconfig looks for fonts leaves an empty cache. Here, not where all programs of the machine read it.
        self.fonts = self.folder / "fonts.conf"
        self.fonts.write_text(f"<fontconfig><cachedir>{self.folder}/fonts</cachedir>"
                              "<include>/etc/fonts/fonts.conf</include></fontconfig>")
        make_inputs(self.inputs)

    # Files

    def place(self, scene):
        return self.folder / scene.name

    def files(self, scene):
        root = self.place(scene)
        return {str(path.relative_to(root)): content(path) for path in sorted(root.rglob("*")) if path.is_file()}

    def empty(self, scene):
        shutil.rmtree(self.place(scene), ignore_errors=True)
        self.place(scene).mkdir()
        for name in scene.files:
            (self.place(scene) / name).write_bytes(OLDER)

    # Runs

    def start(self, scene, **variables):
        command = [self.vvr, *(word.replace("{in}", str(self.inputs)) for word in scene.command)]
        environment = os.environ | {"VVR_CONFIG": "", "LP_NUM_THREADS": "0", "LANG": "C.UTF-8"} | variables
        log = open(self.folder / "said", "w+b")
        child = subprocess.Popen(command, cwd=self.place(scene), env=environment, stdin=subprocess.DEVNULL,
                                 stdout=subprocess.DEVNULL, stderr=log, start_new_session=True)
        child.said = log
        return child

    def end(self, child, begin):
        try:
            status = child.wait(timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            os.killpg(child.pid, signal.SIGKILL)
            child.wait()
            status = None
        child.said.seek(0)
        said = child.said.read().decode(errors="replace")
        child.said.close()
        log = self.folder / "log"
        lines = log.read_text(errors="replace").splitlines() if log.exists() else []
        log.unlink(missing_ok=True)
        return Run(status, said, lines, time.monotonic() - begin)

    def run(self, scene, fault=None, **more):
        begin = time.monotonic()
        variables = {"VVR_FAULT": fault, "VVR_FAULT_IN": scene.process, "VVR_FAULT_LOG": str(self.folder / "log"),
                     "LD_PRELOAD": self.library} if fault else {}
        return self.end(self.start(scene, FONTCONFIG_FILE=str(self.fonts), **variables, **more), begin)

    def learn(self, scene):
        """What a scene does without faults: its files, its words, its calls."""
        if scene.name in self.whole:
            return
        self.empty(scene)
        run = self.run(scene, "count")
        assert run.status == 0, run
        self.whole[scene.name] = self.files(scene)
        assert not any(is_hidden(name) for name in self.whole[scene.name]), self.whole[scene.name].keys()
        self.words[scene.name] = re.sub(r"[\d.]+", "#", run.said)
        self.lasted[scene.name] = run.seconds
        for line in run.log:
            kind, process, call, number = line.split()
            assert kind == "count" and process == scene.process, line
            key = (scene.name, call)
            self.counts.setdefault(key, int(number))

    # What has to hold

    def report(self, what, scene, fault, run):
        whose = "libc.so" if NO_THREAD_LOCAL in run.said else culprit(run.log)
        self.findings.append(Finding(what, scene.name, fault, run, whose))

    def is_whole(self, name, data):
        """Whether what differs from the right bytes is a whole file none the less, with what the run could do."""
        if isinstance(data, dict):
            return True
        if name.endswith(".png"):
            return is_whole_png(data)
        if name.endswith(".exr"):
            return is_whole_exr(data)
        if name.endswith(".avi"):  # as long as its header says
            return data[:4] == b"RIFF" and int.from_bytes(data[4:8], "little") + 8 == len(data)
        if name.endswith(".flo"):  # the same; the last flow of fewer frames is another one
            width, height = (int.from_bytes(data[at:at + 4], "little") for at in (4, 8))
            return data[:4] == b"PIEH" and len(data) == 12 + 8 * width * height
        if "/seeds/" in name:  # the points of fewer frames are others
            return is_whole_seed_list(data)
        return data.rstrip().endswith(b"</html>") if name.endswith(".html") else False

    def warns(self, scene, run):
        """Whether a run says something that one without faults does not."""
        return re.sub(r"[\d.]+", "#", run.said) != self.words[scene.name]

    def check(self, scene, fault, run, killed=False):
        """After a run in which something failed."""
        if run.status is None:
            self.report(f"hangs longer than {PATIENCE} s", scene, fault, run)
        elif not killed and run.status not in DOCUMENTED:
            self.report(UNDOCUMENTED, scene, fault, run)
        elif not killed and any(line.startswith("crash") for line in run.log):
            self.report(WORKER_CRASHES, scene, fault, run)
        right = self.whole[scene.name]
        hidden = False
        files = self.files(scene)
        # A folder of data is whole when its manifest says so, which is written first and last.
        unfinished = MANIFEST in files and isinstance(files[MANIFEST], dict) and files[MANIFEST]["complete"] is False
        if unfinished and run.status == 0:
            self.report("says that all is well, and the manifest does not", scene, fault, run)
        for name, data in files.items():
            if is_hidden(name):
                hidden = True
            elif name not in right:
                self.report(f"leaves {name}", scene, fault, run)
            elif unfinished and name != MANIFEST:
                continue
            elif data != right[name] and not (name in scene.files and data == OLDER):
                # The picture of a clip in which something could not be read, if that is said.
                states = name.endswith(".json") or name == "pictures/index.html" or name == "out.html"
                if not self.is_whole(name, data):
                    self.report(f"leaves a part of {name}", scene, fault, run)
                elif run.status == 0 and not killed and not self.warns(scene, run) and not states:
                    self.report(f"draws another {name} and does not say why", scene, fault, run)
            elif data == OLDER and run.status == 0 and not killed:
                self.report(f"says that all is well, and {name} is an older one", scene, fault, run)
        # With no memory at all, a JSON value that is destroyed ends the program, as it allocates then. The next run tidies up.
        no_memory = scene.command[0] == "archive" and fault.startswith("malloc:") and fault.endswith("+") and run.status == 5
        if hidden and run.status is not None and run.status >= 0 and not killed and not no_memory:
            self.report("leaves a hidden file", scene, fault, run)

    def check_next(self, scene, fault, before, killed=False):
        """The next run completes what there is to do, and nothing hidden stays."""
        left = self.files(scene)
        run = self.run(scene)
        if run.status != 0:
            self.report("the next run fails", scene, fault, run)
            return
        now = self.files(scene)
        right = self.whole[scene.name]
        # An archive does not draw a clip again if the run before has drawn it and said what it could not read.
        told = scene.command[0] == "archive" and before.status == 0 and not killed and self.warns(scene, before)
        done = {name for name, data in left.items() if told and now.get(name) == data and self.is_whole(name, data)}
        missing = right.keys() - now.keys()
        other = [name for name in right if name in now and now[name] != right[name] and name not in done]
        over = now.keys() - right.keys()
        if missing or other or over:
            run.log = before.log
            self.report(f"the next run leaves: missing {sorted(missing)}, other bytes {other}, too much {sorted(over)}", scene, fault, run)

    def inject(self, scene, fault):
        """One run with a fault, and the next one."""
        self.learn(scene)
        self.empty(scene)
        run = self.run(scene, fault)
        self.check(scene, fault, run)
        self.check_next(scene, fault, run)
        return run

    def kill(self, scene, moment, number, first=True, last=True):
        """SIGKILL so many seconds after the start. \\param first in an empty folder, or in what an earlier kill has left"""
        self.learn(scene)
        worker = scene.process == "worker"
        if worker:  # whose clip is given up after three
            first = last = True
        if first:
            self.empty(scene)
        begin = time.monotonic()
        child = self.start(scene)
        time.sleep(moment)
        victim = first_child(child.pid) if worker else child.pid
        if victim and child.poll() is None:
            os.kill(victim, signal.SIGKILL)
        run = self.end(child, begin)
        what = f"kill {number} at {moment:.3f} s" + (" of a worker" if worker else "")
        killed = run.status == -signal.SIGKILL or worker
        self.check(scene, what, run, killed=killed)
        if last:
            self.check_next(scene, what, run, killed=killed)


def first_child(pid):
    try:
        children = pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
    except OSError:
        return None
    return int(children[0]) if children else None


def sample(numbers, most, chance):
    """All of 1 ... numbers, or so many of them: the first few, and others from everywhere."""
    if numbers <= most:
        return list(range(1, numbers + 1))
    first = most // 4
    return list(range(1, first + 1)) + sorted(chance.sample(range(first + 1, numbers + 1), most - first))


def faults_of(walk, scene, most, seed):
    """The faults of a scene, of each call at most so many, and of those that last."""
    walk.learn(scene)
    chance = random.Random(f"{seed} {scene.name}")
    for call in CALLS:
        count = walk.counts.get((scene.name, call), 0)
        for number in sample(count, most, chance):
            yield f"{call}:{number}"
        if call == "clock":  # which stays as it was set
            continue
        # A disk that stays full, files that stay shut: once or twice for each call.
        for number in sample(count, max(1, most // 10), chance)[:max(1, most // 10)]:
            yield f"{call}:{number}+"
