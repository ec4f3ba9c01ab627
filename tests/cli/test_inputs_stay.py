"""What is read is never written: by each output, the log too, under whatever name."""

import os
import resource
import signal

import pytest
from harness import check

SMALL = ("--size", "160x100", "--backend", "software", "--quiet")


class Kept:
    """Refuses each command that would write over `name`, whose bytes stay."""

    def __init__(self, t, name):
        self.t, self.name = t, name
        self.bytes = t.path(name).read_bytes()

    def refuses(self, *command, read=None):
        run = self.t.vvr(*command, stdin=None if read is None else open(self.t.path(read), "rb"))
        run.expect(1, code="output-replaces-input")
        check(self.t.path(self.name).read_bytes() == self.bytes, f"{self.name} has changed: {run}")


@pytest.mark.nightly
def test_a_log_is_no_input(t):
    """A log is opened before anything else, and only ever added to."""
    t.clip("clip.avi", seconds=1)
    os.link(t.path("clip.avi"), t.path("log.txt"))
    os.symlink("clip.avi", t.path("link.txt"))
    clip = Kept(t, "clip.avi")
    for log in ("clip.avi", "log.txt", "link.txt"):
        for command in (("render", "clip.avi", "-o", "out.png", *SMALL), ("info", "clip.avi"), ("extract", "clip.avi", "-o", "data"),
                        ("cut", "clip.avi", "--start", "0s", "-o", "out.avi"), ("inspect", "clip.avi", "--frame", "1f", "-o", "out.png"),
                        ("watch", "clip.avi", "-o", "out.png"), ("compare", "clip.avi", "clip.avi"), ("archive", ".", "-o", "out")):
            clip.refuses(*command, "--log-file", log)
    clip.refuses("render", "-", "-o", "out.png", "--log-file", "log.txt", read="clip.avi")
    t.write("vvr.toml", "quiet = true\n")
    Kept(t, "vvr.toml").refuses("info", "clip.avi", "--config", "vvr.toml", "--log-file", "vvr.toml")
    t.expect_files("clip.avi", "link.txt", "log.txt", "vvr.toml")


def test_a_log_is_a_log(t):
    """Nothing else is added to: footage that vvr reads otherwise, by a link or a pattern, notes, and what is no file."""
    t.clip("clip.avi", seconds=1)
    t.copy("clip.avi", "footage/gate.dat")
    os.symlink("footage", t.path("linked"))
    before = t.path("footage/gate.dat").read_bytes()
    t.vvr("archive", "linked", "-o", "out", "--match", "*.dat", "--log-file", "linked/gate.dat").expect(
        2, "cannot write the log 'linked/gate.dat': it exists, and does not begin as one that vvr wrote; use another name", code="file-invalid")
    check(t.path("footage/gate.dat").read_bytes() == before, "the footage has changed")
    for notes in ("remember the milk\n", '{"time":"noon"}\n', '{\n  "vvr-archive": 1\n}\n', "2026-11-21T20:00:00Z else: a line\n"):
        t.write("notes", notes)
        t.vvr("info", "clip.avi", "--log-file", "notes").expect(2, "'notes'", code="file-invalid")
        check(t.path("notes").read_text() == notes, "the notes have changed")
    for begin in ("vvr: from stderr\n", '{"time":"2026-11-21T20:00:00Z","level":"info"}\n', "2026-11-21T20"):
        t.write("begun", begin)
        t.vvr("info", "missing.avi", "--log-file", "begun").expect(2, code="file-not-found")
        check(t.path("begun").read_text().startswith(begin.rstrip() + "\n"), t.path("begun").read_text())
    os.mkfifo(t.path("pipe"))
    for strange in ("pipe", "/dev/null"):
        t.vvr("info", "clip.avi", "--log-file", strange, timeout=20).expect(
            2, f"cannot write the log '{strange}': it is not a regular file; use another name", code="file-invalid")
    # A line that a full disk has cut short does not hold the log up.
    t.write("log", "2026-11-21T20:00:00Z vvr: half a li")
    t.vvr("info", "missing.avi", "--log-file", "log").expect(2, code="file-not-found")
    check(len(t.path("log").read_text().splitlines()) == 2, t.path("log").read_text())


def test_a_log_that_is_lost_is_said(t):
    t.clip("clip.avi", seconds=1)
    full = "2026-11-21T20:00:00Z vvr: a line\n" * 30000
    t.write("log", full)

    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (len(full), len(full)))

    run = t.vvr("render", "clip.avi", "-o", "out.png", *SMALL, "--log-file", "log", preexec_fn=limit)
    run.expect(2, "cannot write the log 'log': File too large", code="disk-full")
    check(run.err.count("\n") == 1 and t.path("log").read_text() == full, f"{run}")
    t.expect_picture("out.png")


def test_no_output_is_in_the_folder_of_another(t):
    """An archive gives its files their names, and an extraction is replaced as a whole."""
    t.clip("in/gate/a.avi", seconds=1)
    t.age("in")
    for name in ("out/gate/a.avi.json", "out/gate/a.avi.report.json", "out/gate/../index.html", "out/x.PNG", "out/a.avi.1.mp4"):
        for option in ("--events-to", "--log-file"):
            t.vvr("archive", "in", "-o", "out", option, name, *SMALL).expect(1, f"{option} both name '{name}'", code="options-conflict")
    t.vvr("extract", "in/gate/a.avi", "-o", "data", "--log-file", "data/log").expect(1, "'data/log'", code="options-conflict")
    t.expect_files("in", "in/gate", "in/gate/a.avi")
    t.path("out").mkdir()
    t.vvr("archive", "in", "-o", "out", "--events-to", "out/events.jsonl", "--log-file", "out/log", *SMALL).expect(0)
    check("1 clip drawn" in t.path("out/log").read_text(), "no log")


@pytest.mark.nightly
def test_a_file_of_a_recording_is_no_output(t):
    """In a folder below, of a pattern, of a list, and by a link."""
    deep = "day/sub/2026-11-21_10-00-00.avi"
    t.clip("day/2026-11-21_10-00-03.avi", seconds=1)
    t.copy("day/2026-11-21_10-00-03.avi", deep)
    os.link(t.path(deep), t.path("hard.png"))
    t.write("list.txt", deep + "\n")
    segment = Kept(t, deep)
    for given in ("day", "day/*/*.avi", "day/*", "list.txt"):
        for outputs in (("--report", deep), ("-o", "hard.png"), ("-o", "out.png", "--still", "hard.png"),
                        ("-o", "out.png", "--log-file", deep)):
            segment.refuses("render", given, *outputs, *SMALL)
    listed = Kept(t, "list.txt")
    listed.refuses("render", "list.txt", "--report", "list.txt", *SMALL)
    # What lies in the folder and is not read may be written, as often as one likes.
    for _ in range(2):
        t.vvr("render", "day/sub", "--report", "day/sub/report.json", *SMALL).expect(0)


@pytest.mark.nightly
def test_a_picture_of_a_pattern_is_no_output(t):
    t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=10:duration=0.5", "f/%03d.png")
    picture = Kept(t, "f/003.png")
    for given in ("f/%03d.png", "f/*.png", "f"):
        for output in ("f/003.png", "f/{brick:3}.png", "f/###.png", "f/%03d.png"):
            picture.refuses("render", given, "-o", output, *SMALL)
    picture.refuses("compare", "f/003.png", "f/001.png", "--diff", "f/003.png")


def test_what_options_read_is_no_output(t):
    """Seeds, one list or a folder of them, transfer functions, masks, fonts, golden pictures and data folders."""
    t.clip("clip.avi", seconds=1)
    t.vvr("extract", "clip.avi", "-o", "data", "--quiet").expect(0)
    t.write("points.txt", "0 0 0 0 0\n255 1 1 1 1\n")
    t.write("area.txt", "0,0 60,0 60,40\n")
    seeds, scalar = "data/seeds/000002.txt", "data/scalar/000002.png"
    for name, command in (
            (seeds, ("render", "clip.avi", "--seeds", "data/seeds", "--report", seeds)),
            (seeds, ("render", "clip.avi", "--seeds", seeds, "--log-file", seeds)),
            ("points.txt", ("render", "clip.avi", "--transfer", "points.txt", "--report", "points.txt")),
            ("area.txt", ("render", "clip.avi", "--mask", "area.txt", "--log-file", "area.txt")),
            (scalar, ("render", "data", "-o", scalar)),
            ("data/manifest.json", ("render", "data", "--report", "data/manifest.json")),
            (seeds, ("seeds", "data", "-o", "lists", "--log-file", seeds)),
            ("data/first.png", ("render", "clip.avi", "-o", "data/first.png", "--golden", "data/first.png")),
            # An older extraction is replaced as a whole, so nothing of it can be what is extracted.
            (scalar, ("extract", "data/scalar", "-o", "data"))):
        Kept(t, name).refuses(*command)
    # A picture is blessed as golden in the place of the old one.
    t.vvr("render", "clip.avi", "--golden", "golden.png", "--bless", *SMALL).expect(0)
    t.vvr("render", "clip.avi", "--golden", "golden.png", "--bless", *SMALL).expect(0)
    os.link(t.path("clip.avi"), t.path("clip.png"))
    Kept(t, "clip.avi").refuses("render", "clip.avi", "--golden", "clip.png", "--bless", *SMALL)


def test_the_films_of_a_live_page_are_no_input(t):
    t.clip("gate.film-1.mp4", seconds=1)
    Kept(t, "gate.film-1.mp4").refuses("watch", "gate.film-1.mp4", "-o", "gate.html", "--size", "160x100", "--backend", "software")
    check(not t.path("gate.html").exists(), "a page was written")
