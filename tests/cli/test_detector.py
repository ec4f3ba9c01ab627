"""--detector: what an object is stands in all outputs, a person was never left behind, and a model that is none is
refused before the clip is read. The models are the tests' own."""

import os
import re

import pytest
from browser import Page
from harness import check
from test_archive_index import opened
from test_report import read
from tiny_model import model

SUITCASE = 28
NO_CLASSES = [[kind, None, None, None, None] for kind in ("moved", "left", "moved")]
QUICK = ("--size", "160x100", "--backend", "software")


def bag(t, **of_model):
    """Somebody puts a bag down, and takes it again; the detector's model."""
    t.scene("left_bag", "bag.y4m", "--size", "192x144", "--frames", "400")
    t.write("tiny.onnx", model(**of_model))


def report_of(t, *arguments):
    t.vvr("render", "bag.y4m", "--report", "report.json", *arguments).expect(0)
    return read(t)


def facts(event):
    return [event[name] for name in ("kind", "class", "group", "score", "looks")]


def test_person_was_not_left_behind(t):
    bag(t)
    before = report_of(t)
    check([facts(event) for event in before["events"]] == NO_CLASSES, str(before["events"]))
    check(before["detector"] is None and before["events"][1]["evidence"]["refuted"] is None, str(before["detector"]))
    report = report_of(t, "--detector", "tiny.onnx")
    check(len(report["events"]) == 3, f"{len(report['events'])} events")
    for event, kind in zip(report["events"], ("moved", "stood", "moved"), strict=True):
        check(facts(event)[:4] == [kind, "person", "person", 0.9] and 1 <= event["looks"] <= 3, str(facts(event)))
    refuted = report["events"][1]
    check(refuted["evidence"] == before["events"][1]["evidence"] | {"refuted": "left"}, str(refuted["evidence"]))
    check(refuted["by"] is None and refuted["alone_since"] is None and refuted["stays"], str(refuted))
    use = report["detector"]
    check(use["format"] == "YOLOX" and use["events"] == 3 and 3 <= use["looks"] <= 9 and use["seconds"] >= 0, str(use))
    check(report["settings"]["detector"] == "tiny.onnx", str(report["settings"]))
    listed = report_of(t, "--detector", "tiny.onnx", "--events", "left")
    check(listed["events"] == [], "what was refuted is listed as left")


def test_thing_was_left_behind(t):
    bag(t, class_id=SUITCASE)
    report = report_of(t, "--detector", "tiny.onnx")
    check([facts(event)[:3] for event in report["events"]] == [["moved", "suitcase", "thing"], ["left", "suitcase", "thing"],
                                                               ["moved", "suitcase", "thing"]], str(report["events"]))


def test_detector_that_sees_nothing_refutes_nothing(t):
    bag(t, score=0.4)
    report = report_of(t, "--detector", "tiny.onnx")
    check([facts(event) for event in report["events"]] == NO_CLASSES, str(report["events"]))
    check(report["detector"]["events"] == 3, str(report["detector"]))


@pytest.mark.nightly
def test_detector_is_named_by_a_config_file(t):
    bag(t)
    t.write("vvr.toml", 'detector = "tiny.onnx"\n')
    config = os.environ | {"VVR_CONFIG": "vvr.toml"}
    t.vvr("render", "bag.y4m", "--report", "report.json", env=config).expect(0, "3 events (3 person)")
    check(read(t)["events"][1]["class"] == "person", "the config file's detector says nothing")
    said = t.vvr("doctor", "--json", env=config).expect(0, out=None).json()
    check(said["detector"] == {"model": "tiny.onnx", "works": True, "format": "YOLOX", "width": 64, "height": 64, "reason": None}, str(said))
    check("detector       YOLOX, 64x64 pixels: tiny.onnx\n" in t.vvr("doctor", env=config).expect(0, out=None).out, "no line")
    check("detector       none" in t.vvr("doctor").expect(0, out=None).out, "no line where none is set")
    check(t.vvr("doctor", "--json").expect(0, out=None).json()["detector"] is None, "one is set")
    t.write("tiny.onnx", "no model")
    broken = t.vvr("doctor", env=config).expect(2, "cannot use 'tiny.onnx' as a detector", code="not-a-model", out=None)
    check("detector       does not work: cannot use 'tiny.onnx'" in broken.out, broken.out)


BROKEN = [
    ("none.onnx", None, "file-not-found"),
    ("text.onnx", b"This is a text.\n", "not-a-model"),
    ("empty.onnx", b"", "not-a-model"),
    ("cut.onnx", model()[:len(model()) // 2], "not-a-model"),
    ("other.onnx", model().replace(b"Concat", b"Loop\n\n"), "not-a-model"),
]


@pytest.mark.parametrize("name, content, code", BROKEN, ids=[name for name, _, _ in BROKEN])
def test_model_that_is_none_is_refused_before_the_clip_is_read(t, name, content, code):
    if content is not None:
        t.write(name, content)
    for command in (["render", "no clip.avi", "-o", "out.png"], ["watch", "no stream.avi", "-o", "out.png"]):
        t.vvr(*command, "--detector", name).expect(2, f"'{name}'", code=code)
    t.clip("in/a.avi")
    t.archive("in", "-o", "out", *QUICK, "--detector", name).expect(2, f"'{name}'", code=code)
    check(not t.path("out").exists(), "the archive has begun")


@pytest.mark.nightly
def test_series_and_streams_have_classes(t):
    bag(t)
    t.vvr("render", "bag.y4m", "-o", "out.{brick:2}.png", "--report", "report.json", "--brick", "4s", "--window", "2", *QUICK,
          "--detector", "tiny.onnx").expect(0)
    report = read(t)
    check([event["class"] for event in report["events"]] == ["person"] * 3, str(report["events"]))
    # A picture is looked at once, however often the window finds the event again.
    check(3 <= report["detector"]["looks"] <= 12, str(report["detector"]))
    t.vvr("watch", "bag.y4m", "-o", "live.html", "--brick", "4s", "--window", "2", *QUICK, "--detector", "tiny.onnx").expect(0)
    check('"class":"person"' in t.path("live.html").read_text(), "the stream's page knows no classes")


def test_pictures_say_what_their_objects_are(t):
    bag(t)
    t.vvr("render", "bag.y4m", "-o", "out.exr", "--report", "report.json", "--backend", "software", "--size", "1600x1000",
          "--detector", "tiny.onnx").expect(0)
    texts = [label["text"] for label in read(t)["labels"]]
    check(any(text.startswith("person · stayed") for text in texts), f"{texts}")
    check(b"1 person, 2 person, 3 person" in t.path("out.exr").read_bytes(), "the file does not say which object is what")


def archive_of_bags(t, *arguments):
    bag(t)
    t.copy("bag.y4m", "in/gate/bag.y4m")
    t.clip("in/gate/quiet.avi", seconds=1)
    return t.archive("in", "-o", "out", *QUICK, "--match", "*.y4m", "--match", "*.avi", *arguments)


@pytest.mark.nightly
def test_archive_knows_what_came(t):
    archive_of_bags(t, "--detector", "tiny.onnx").expect(0)
    found = t.json("out/gate/bag.y4m.json")["found"]
    check([[event[0], event[-1]] for event in found] == [["moved", "person"], ["stood", "person"], ["moved", "person"]], str(found))
    index = t.path("out/index.html").read_text()
    check('"classes":{"person":["person"]}' in index, "the index knows no classes")
    t.archive("in", "-o", "out", *QUICK, "--match", "*.y4m", "--match", "*.avi", "--detector", "tiny.onnx", "--dry-run").expect(0, out=None)
    again = t.archive("in", "-o", "out", *QUICK, "--match", "*.y4m", "--match", "*.avi", "--dry-run").expect(0, out=None)
    check(re.search(r"other settings", again.out + again.err), f"another detector changes nothing: {again}")


@pytest.mark.browser
def test_index_is_filtered_by_class(t):
    archive_of_bags(t, "--detector", "tiny.onnx").expect(0)
    with opened(t, cards=2) as page:
        check(not page.hidden("class"), "no choice of classes")
        page.set("class", "person")
        page.wait("one card", "return document.querySelectorAll('.card').length === 1")
        check(page.run("return location.hash").endswith("class=person"), page.run("return location.hash"))
        page.set("class", "")
        page.wait("all cards", "return document.querySelectorAll('.card').length === 2")


@pytest.mark.browser
def test_page_is_filtered_by_class(t):
    bag(t)
    t.vvr("render", "bag.y4m", "-o", "plain.html", *QUICK).expect(0)
    t.vvr("render", "bag.y4m", "-o", "out.html", *QUICK, "--detector", "tiny.onnx").expect(0)
    with Page(t, "plain.html") as page:
        check(page.hidden("class"), "a choice of classes without a detector")
    with Page(t, "out.html") as page:
        check(page.run("return [...document.getElementById('class').options].map(o => [o.value, o.text])") ==
              [["", "everything"], ["person", "person 3"]], "the choice of classes")
        check("person (90 %)" in page.text("events"), page.text("events"))
        page.run("Object.assign(state.events[1], {class: 'dog', group: 'animal'}); Object.assign(state.events[2], {class: null, group: null}); drawClasses();")
        words = page.run("return [...document.getElementById('class').options].map(o => o.text)")
        check(words == ["everything", "person 1", "animal 1", "– dog 1", "unknown 1"], str(words))
        for name, count in (("animal", 1), ("dog", 1), ("?", 1), ("person", 1), ("", 3)):
            page.set("class", name)
            check(page.count("#events li") == count, f"{name}: {page.count('#events li')} events")
