"""--events-to: one line of JSON for each event that has ended, for other programs."""

import json
import os
import subprocess
import threading

import pytest
from harness import check

FAST = ("--size", "160x100", "--flow", "none", "--backend", "software")
KEYS = ["camera", "clip", "number", "kind", "class", "begin", "end", "first", "last", "seconds", "open_ended", "box", "direction", "page"]


def walk(t, name, begins=2, seconds=16):
    """An empty scene that a square crosses to the right in three seconds, and nothing afterwards."""
    t.make(name, "walk", begins, seconds, how=lambda: t.ffmpeg(
        "-f", "lavfi", "-i", f"color=gray:size=192x144:rate=10:duration={seconds}", "-f", "lavfi", "-i",
        f"testsrc2=size=30x40:rate=10:duration={seconds}", "-filter_complex",
        f"[0][1]overlay=x='if(between(t,{begins},{begins}+3),60*(t-{begins}),-100)':y=50:eval=frame", "-c:v", "mpeg4", "-q:v", "2", name))
    return name


def clips(t, *names):
    for name in names:
        walk(t, name)
    t.age("in")


def archive(t, *arguments):
    return t.vvr("archive", "in", "-o", "out", *FAST, "--events-to", "events.jsonl", *arguments)


def lines(t, name="events.jsonl"):
    text = t.path(name).read_text(encoding="utf-8")
    check(text == "" or text.endswith("\n"), f"half a line: {text}")
    return [json.loads(line) for line in text.splitlines()]


def test_archive_tells_each_event_once(t):
    t.zone("UTC")
    clips(t, "in/gate/2026-11-21_20-00-00.avi")
    archive(t).expect(0)
    told = lines(t)
    check([list(line) for line in told] == [KEYS], f"{told}")
    line = told[0]
    check(line["camera"] == "gate" and line["clip"] == "gate/2026-11-21_20-00-00.avi" and line["kind"] == "moved", f"{line}")
    check(line["direction"] == "right" and line["number"] == 1 and line["class"] is None, f"{line}")
    check(line["begin"].startswith("2026-11-21T20:00:0") and line["end"] > line["begin"], f"{line}")
    check(1.5 < line["first"] < 3.5 and 4 < line["last"] < 5.5, f"{line}")
    check(abs(line["seconds"] - (line["last"] - line["first"])) < 0.002, f"{line}")
    box = line["box"]
    check(box["x"] < 20 and box["width"] > 120 and 30 < box["y"] < 60, f"{box}")
    page, event = line["page"].split("#")
    check(t.path(f"out/{page}").exists() and event == "event=1", f"{line}")
    report = t.json("out/gate/2026-11-21_20-00-00.avi.report.json")
    check(report["events"][0]["direction"] == "right", f"{report['events']}")
    # Neither a repeated run nor new settings tell it again.
    archive(t).expect(0, "nothing to do")
    archive(t, "--theme", "dark").expect(0)
    check(lines(t) == told, "an event was told twice")
    clips(t, "in/gate/2026-11-21_20-30-00.avi")
    archive(t, "--theme", "dark").expect(0)
    check([line["clip"][-12:] for line in lines(t)] == ["20-00-00.avi", "20-30-00.avi"], f"{lines(t)}")


def test_a_clip_without_its_sidecar_tells_no_event_again(t):
    """Removing the sidecar has a clip drawn again; its report says what was told."""
    clips(t, "in/gate/a.avi")
    archive(t).expect(0)
    told = lines(t)
    check(len(told) == 1, f"{told}")
    t.path("out/gate/a.avi.json").unlink()
    archive(t).expect(0, "1 clip drawn")
    check(lines(t) == told, "told again")
    # Where no report says so, nothing is known; whatever is there instead stops nobody.
    for count, report in enumerate((None, "{", '{"span": {"last": "x"}}', '{"span":' * 100, "{" + " " * 100_000_001), start=2):
        t.path("out/gate/a.avi.json").unlink()
        t.path("out/gate/a.avi.report.json").unlink()
        if report is not None:
            t.write("out/gate/a.avi.report.json", report)
        archive(t).expect(0, "1 clip drawn")
        check(lines(t) == told * count, f"{(report or '')[:30]}: {len(lines(t))} lines")


@pytest.mark.nightly
def test_a_day_tells_the_events_of_its_new_files(t):
    t.zone("UTC")
    clips(t, "in/gate/2026-11-21_20-00-00.avi")
    t.stamp("in/gate/2026-11-21_20-00-00.avi", -7200)
    archive(t, "--per", "day").expect(0)
    first = lines(t)
    clips(t, "in/gate/2026-11-21_20-00-16.avi")
    t.stamp("in/gate/2026-11-21_20-00-16.avi", -3600)
    archive(t, "--per", "day").expect(0)
    told = lines(t)
    check(told[:1] == first and [line["clip"] for line in told] == ["gate/2026-11-21_20-00-00.avi", "gate/2026-11-21_20-00-16.avi"], f"{told}")
    check(told[1]["begin"].startswith("2026-11-21T20:00:1") and told[1]["page"].endswith("#event=2"), f"{told}")
    archive(t, "--per", "day").expect(0, "nothing to do")
    check(lines(t) == told, "told again")


def test_standard_output(t):
    clips(t, "in/one.avi")
    said = t.vvr("archive", "in", "-o", "out", *FAST, "--events-to", "-", "--quiet").expect(0, out=None)
    line = said.json()
    check(line["camera"] is None and line["begin"] is None and line["clip"] == "one.avi", said.out)


@pytest.mark.nightly
def test_a_named_pipe_needs_no_reader(t):
    clips(t, "in/one.avi")
    os.mkfifo(t.path("events.jsonl"))
    taken = []
    reader = threading.Thread(target=lambda: taken.append(open(t.path("events.jsonl"), encoding="utf-8").readline()))
    reader.start()
    archive(t).expect(0)
    reader.join(20)
    check(taken and json.loads(taken[0])["clip"] == "one.avi", f"{taken}")
    clips(t, "in/two.avi")
    archive(t).expect(0)


@pytest.mark.nightly
def test_lines_that_can_not_be_written(t):
    """The pictures are there, and the exit status tells."""
    clips(t, "in/one.avi")
    said = t.vvr("archive", "in", "-o", "out", *FAST, "--events-to", "/dev/full")
    said.expect(2, "cannot write events to '/dev/full': it is neither a file nor a named pipe", code="file-invalid")
    check(not t.path("out").exists() or not list(t.path("out").glob("*.png")), "drawn")
    command = f"exec '{t.vvr_path}' archive in -o out {' '.join(FAST)} --events-to - >/dev/full"
    t.run(["bash", "-c", command]).expect(2, "cannot write an event to standard output: No space left on device; it is lost",
                                          "1 event could not be written to standard output", code="disk-full")
    t.expect_picture("out/one.avi.png")
    clips(t, "in/two.avi")
    # A reader that has gone.
    read, write = os.pipe()
    os.close(read)
    done = subprocess.run([t.vvr_path, "archive", "in", "-o", "out", *FAST, "--events-to", "-"], cwd=t.folder, stdout=write,
                          stderr=subprocess.PIPE, check=False)
    os.close(write)
    check(done.returncode == 2 and b"Broken pipe; it is lost" in done.stderr, f"{done}")
    t.expect_picture("out/two.avi.png")


def test_a_file_of_another_kind_stays(t):
    clips(t, "in/one.avi")
    before = t.path("in/one.avi").read_bytes()
    for mine in ("mine\n", '{\n  "name": "my project"\n}\n', '{"report":1}\n', "{}"):
        t.write("notes.txt", mine)
        t.vvr("archive", "in", "-o", "out", "--events-to", "notes.txt").expect(
            2, "'notes.txt': it exists, and does not begin as one that vvr wrote; use another name", code="file-invalid")
        check(t.path("notes.txt").read_text() == mine, "appended")
    t.vvr("watch", "in/one.avi", "-o", "out.png", "--events-to", "in/one.avi").expect(
        1, "would overwrite the input", code="output-replaces-input")
    check(t.path("in/one.avi").read_bytes() == before, "appended")
    # After a crash, a line may lack its end. The next one begins a new line.
    t.write("events.jsonl", '{"cam')
    archive(t).expect(0)
    check(t.path("events.jsonl").read_text(encoding="utf-8").splitlines()[0] == '{"cam', "joined")


def test_options_that_make_no_events(t):
    clips(t, "in/one.avi")
    archive(t, "--write", "index").expect(1, "--write index draws nothing", code="options-conflict")
    for command in (("archive", "in", "-o", "out"), ("watch", "in/one.avi", "-o", "out.png")):
        t.vvr(*command, "--filter", "luminance", "--events-to", "events.jsonl").expect(
            1, "--events-to needs a filter that marks objects, and --filter luminance does not", code="options-conflict")
    archive(t, "--dry-run").expect(0, out=None)
    check(not t.path("events.jsonl").exists(), "a dry run has written")


def test_watch_tells_what_has_ended(t):
    """While the stream goes on, not at its end."""
    walk(t, "gate.avi", begins=6, seconds=26)
    said = t.vvr("watch", "gate.avi", "-o", "gate.html", "--brick", "2s", "--window", "4", *FAST, "--title", "Gate",
                 "--start-time", "2026-11-21 08:00:00", "--events-to", "-", "--log-format", "text").expect(0, out=None)
    told = [json.loads(line) for line in said.out.splitlines()]
    check(len(told) == 1 and list(told[0]) == KEYS, said.out)
    line = told[0]
    check(line["camera"] == "Gate" and line["clip"] == "gate.avi" and line["direction"] == "right", f"{line}")
    check(line["begin"].startswith("2026-11-21T08:00:0") and line["page"] == f"gate.html#event={line['number']}", f"{line}")
    check(5.5 < line["first"] < 7.5 and 8 < line["last"] < 9.5 and line["box"]["width"] > 120, f"{line}")


def test_watch_tells_before_the_end(t):
    """An event is told some seconds after it has ended; the stream may go on for days."""
    walk(t, "gate.avi", begins=6, seconds=26)
    os.mkfifo(t.path("feed"))
    watch = t.start("watch", "feed", "-o", "gate.png", "--brick", "2s", "--window", "4", *FAST, "--events-to",
                    "events.jsonl")
    with open(t.path("feed"), "wb") as feed:
        feed.write(subprocess.run(["ffmpeg", "-v", "error", "-i", "gate.avi", "-c", "copy", "-f", "mpegts", "-"], cwd=t.folder,
                                  stdout=subprocess.PIPE, check=True).stdout)
        feed.flush()
        for _ in range(600):
            if t.path("events.jsonl").exists() and t.path("events.jsonl").stat().st_size:
                break
            check(watch.poll() is None, "it has ended")
            threading.Event().wait(0.05)
        check(watch.poll() is None and len(lines(t)) == 1, "nothing is told while the stream goes on")
    check(watch.wait(60) == 0 and len(lines(t)) == 1, f"{lines(t)}")


def test_watch_tells_at_the_end_what_still_lasts(t):
    walk(t, "gate.avi", begins=7, seconds=9)
    t.vvr("watch", "gate.avi", "-o", "gate.png", "--brick", "2s", *FAST, "--events-to", "events.jsonl").expect(0)
    check(len(lines(t)) == 1 and lines(t)[0]["page"] is None and lines(t)[0]["last"] > 8.5, f"{lines(t)}")


def test_watch_tells_of_a_bag_that_lay_for_long(t):
    """It lies for 95 s, longer than the window and all that a stream remembers of those who have gone."""
    t.scene("left_bag", "hall.y4m", "--size", "192x144", "--rate", "8")
    t.vvr("watch", "hall.y4m", "-o", "hall.png", "--brick", "1s", "--window", "3", *FAST, "--reference", "first", "--events-to",
          "events.jsonl").expect(0)
    told = lines(t)
    left = [line for line in told if line["kind"] == "left"]
    check(len(left) == 1 and left[0]["seconds"] > 90, f"{told}")
    numbers = [line["number"] for line in told]
    check(len(set(numbers)) == len(numbers), f"told twice: {told}")
