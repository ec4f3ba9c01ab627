"""The schemas of docs/: what the program writes follows them, and programs that use them may meet new keys."""

import json
import re

import jsonschema
import pytest
from harness import check
from schemas import follows, schema_of

SMALL = ("--size", "160x100", "--backend", "software", "--flow", "none", "--quiet")


def crossing(t, name):
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=192x144:rate=10:duration=8", "-f", "lavfi", "-i", "testsrc2=size=30x40:rate=10:duration=8",
             "-filter_complex", "[0][1]overlay=x='if(between(t,2,5),60*(t-2),-100)':y=50:eval=frame", "-c:v", "mpeg4", "-q:v", "2", name)


def made_by_info(t):
    crossing(t, "in/gate/2026-11-21_20-00-00.avi")
    clip = "in/gate/2026-11-21_20-00-00.avi"
    return [t.vvr("info", clip, "--json", *more).expect(0, out=None).json() for more in ((), ("--quick",))]


def made_by_golden(t):
    crossing(t, "clip.avi")
    t.write("bad.avi", "no video")
    t.write("g/golden.toml", 'size = "160x100"\nbackend = "software"\nflow = "none"\n[a]\ninput = "../clip.avi"\n[b]\ninput = "../bad.avi"\n')
    runs = [t.vvr("golden", "g", *more, "--report", "-", "--quiet") for more in ((), ("--bless",), ())]
    check([run.status for run in runs] == [6, 6, 6], f"{runs}")
    return [run.json() for run in runs]


def of_an_archive(t):
    """A clip, and one that is none, with its pieces."""
    t.zone("UTC")
    crossing(t, "in/gate/2026-11-21_20-00-00.avi")
    t.write("in/gate/2026-11-21_21-00-00.avi", "no video")
    t.age("in")
    t.vvr("archive", "in", "-o", "out", "--keep-events", "--events-to", "events.jsonl", *SMALL).expect(6)


def sidecars(t):
    of_an_archive(t)
    names = ("gate/2026-11-21_20-00-00.avi.json", "gate/2026-11-21_21-00-00.avi.json")
    found = [t.json(f"out/{name}") for name in names]
    check([one["state"] for one in found] == ["done", "failed"] and found[0]["found"], f"{found}")
    return found


def events(t):
    of_an_archive(t)
    return [json.loads(line) for line in t.path("events.jsonl").read_text().splitlines()]


def evidence(t):
    of_an_archive(t)
    clip = "in/gate/2026-11-21_20-00-00.avi"
    t.vvr("render", clip, "--report", "report.json", "--flow", "none", "--quiet").expect(0)
    t.vvr("cut", clip, "--event", "1", "--report", "report.json", "--evidence", "case", "--quiet").expect(0)
    t.vvr("cut", clip, "--start", "1s", "--end", "2s", "--evidence", "between", "--quiet").expect(0)
    return [t.json(name) for name in ("case/evidence.json", "between/evidence.json", "out/gate/2026-11-21_20-00-00.avi.events/evidence.json")]


@pytest.mark.parametrize("name, make", [("info", made_by_info), ("golden", made_by_golden), ("sidecar", sidecars),
                                        ("event-line", events), ("evidence", evidence)])
def test_what_is_written_follows_its_schema(t, name, make):
    schema = schema_of(t, name)
    made = make(t)
    check(made, "nothing was written")
    for one in made:
        follows(one, schema)
        follows({**one, "of_a_later_version": 1}, schema)
    for key in schema["required"]:
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate({key_: value for key_, value in made[0].items() if key_ != key}, schema)


def test_schemas_have_a_name_and_allow_new_keys(t):
    found = sorted((t.source / "docs").glob("*.schema.json"))
    check(len(found) == 7, f"{found}")
    pages = "".join(page.read_text() for page in (t.source / "docs").glob("*.md"))
    for file in found:
        schema = schema_of(t, file.name.removesuffix(".schema.json"))
        check(re.fullmatch(rf"urn:vvr:{file.name.removesuffix('.schema.json')}:[1-9]", schema["$id"]), schema["$id"])
        check('"additionalProperties": false' not in file.read_text(), f"{file.name} forbids keys of later versions")
        check(f"({file.name})" in pages, f"no page links to {file.name}")
