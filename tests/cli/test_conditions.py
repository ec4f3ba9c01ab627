"""What a recording itself did: its times are told, and nothing is said because of it."""

import csv
import json

import pytest
from harness import check
from schemas import follows, schema_of

SIZE = ["--size", "400x300"]


@pytest.fixture
def walkers(t):
    """24 s of a camera with noise, 10 frames per second: people walk all the time."""
    t.scene("walkers", "walkers.y4m", "--size", "192x144", "--frames", "240", "--rate", "10", "--noise", "2", "--detail", "6")
    return "walkers.y4m"


def encoded(t, source, name, filters, *codec):
    t.ffmpeg("-i", source, "-vf", filters, "-c:v", "mpeg4", "-q:v", "3", *codec, name)
    return name


def report_of(t, clip, *options):
    t.vvr("render", clip, "-o", "out.png", "--report", "out.json", "--quiet", *SIZE, *options).expect(0)
    return json.loads(t.path("out.json").read_text())


def intervals_of(report):
    return [(one["kind"], one["begin"]["seconds"], one["end"]["seconds"]) for one in report["unseen"]["intervals"]]


def expect_interval(report, kind, begin, end):
    told = intervals_of(report)
    check(len(told) == 1 and told[0][0] == kind, f"expected one interval '{kind}', there are {told}")
    # A codec takes up to a second to settle on a frozen picture.
    check(abs(told[0][1] - begin) <= (1 if kind == "frozen" else 0.5) and abs(told[0][2] - end) <= 0.5, f"{begin} to {end} s is told as {told}")


def expect_no_claims(report):
    kinds = [event["kind"] for event in report["events"]]
    check(not {"left", "taken"} & set(kinds), f"something is said to have been left or taken: {kinds}")


def expect_none_across(report, begin, end):
    for event in report["events"]:
        first, last = event["first"]["seconds"], event["last"]["seconds"]
        check(last <= end - 0.5 or first >= begin + 0.5, f"an event from {first} to {last} s spans the interval")


def test_a_clip_without_faults_has_no_interval(t, walkers):
    report = report_of(t, walkers)
    check(intervals_of(report) == [], f"of a faultless clip are told {intervals_of(report)}")


def test_a_frozen_picture_is_not_somebody_who_stands(t, walkers):
    # From 10 s on, the last picture is repeated for 8 s; the clock goes on.
    clip = encoded(t, walkers, "frozen.avi",
                   "loop=loop=80:size=1:start=100,select='lt(n,181)+gte(n,261)',setpts=N/10/TB", "-r", "10")
    report = report_of(t, clip)
    expect_interval(report, "frozen", 10, 18)
    expect_no_claims(report)
    expect_none_across(report, 10, 18)
    check("no new pictures from" in report["advice"][0], f"the advice is {report['advice']}")


@pytest.mark.parametrize("colour", ["gray", "blue", "black"])
def test_a_card_is_no_picture(t, walkers, colour):
    clip = encoded(t, walkers, "card.avi", f"drawbox=color={colour}:t=fill:enable='between(t,9,15)',"
                   "drawtext=text='NO SIGNAL':fontsize=14:fontcolor=white:x=50:y=60:enable='between(t,9,15)'")
    report = report_of(t, clip)
    expect_interval(report, "blank", 9, 15)
    expect_no_claims(report)
    expect_none_across(report, 9, 15)


@pytest.mark.parametrize("degrees", [2, -3])
def test_people_are_found_before_and_after_a_knock(t, walkers, degrees):
    moved = f"rotate=a='if(lt(t,12),0,{degrees}*PI/180)':ow=iw:oh=ih,crop=160:120:x='if(lt(t,12),10,18)':y='if(lt(t,12),8,14)'"
    report = report_of(t, encoded(t, walkers, "knock.avi", moved))
    expect_interval(report, "camera_moved", 12, 12)
    expect_no_claims(report)
    still = report_of(t, encoded(t, walkers, "still.avi", "crop=160:120:10:8"))
    # Whoever is there for two seconds of that time.
    for what, wanted in (("before", lambda event: event["first"]["seconds"] < 10),
                         ("after", lambda event: event["last"]["seconds"] > 14)):
        found = len([event for event in report["events"] if wanted(event)])
        there = len([event for event in still["events"] if wanted(event)])
        check(4 * found >= 3 * there > 0, f"{what} the knock {found} of {there} are found")


def test_a_picture_says_when_it_shows_nothing(t, walkers):
    """A clip that ends with a card keeps its length."""
    clip = encoded(t, walkers, "end.avi", "drawbox=color=gray:t=fill:enable='gte(t,18)'")
    report = report_of(t, clip)
    expect_interval(report, "blank", 18, 23.9)
    whole = report_of(t, encoded(t, walkers, "all.avi", "drawbox=color=gray:t=fill"))
    check(whole["events"] == [], "nothing but a card has events")


def test_the_shadow_of_a_cloud_is_no_visitor(t, walkers):
    """A shadow of 40 % with a soft border passes from 5 to 19 s, over people who walk."""
    shadow = "lum(X,Y)*(1-0.4/(1+exp((abs(X-(T*24-210))-90)/9)))"
    t.ffmpeg("-i", walkers, "-vf", f"geq=lum='{shadow}':cb='128+(cb(X,Y)-128)*(1-0.4/(1+exp((abs(X-(T*24-210))-90)/9)))'"
             f":cr='128+(cr(X,Y)-128)*(1-0.4/(1+exp((abs(X-(T*24-210))-90)/9)))'", "-c:v", "mpeg4", "-q:v", "2", "cloud.avi")
    told = report_of(t, "cloud.avi")
    expect_no_claims(told)
    check({kind for kind, _, _ in intervals_of(told)} == {"light_changed"}, f"a cloud is told as {intervals_of(told)}")
    kept = report_of(t, encoded(t, walkers, "none.avi", "null"))
    check(len(told["events"]) <= len(kept["events"]) + 1, f"with a cloud there are {len(told['events'])} events, without {len(kept['events'])}")


@pytest.mark.parametrize("gain", [1.5, 0.6])
def test_a_jump_of_the_exposure_is_told(t, walkers, gain):
    """From 9 to 15 s. People are found as without it."""
    clip = encoded(t, walkers, "jump.avi", f"lutyuv=y='clip(val*{gain},16,235)':enable='between(t,9,14.95)'")
    told = report_of(t, clip)
    expect_interval(told, "light_changed", 9, 15)
    expect_no_claims(told)
    kept = report_of(t, encoded(t, walkers, "none.avi", "null"))
    check(abs(len(told["events"]) - len(kept["events"])) <= 1, f"with it there are {len(told['events'])} events, without {len(kept['events'])}")


def test_events_go_on_where_times_are_doubtful(t, walkers):
    """The camera's clock goes back at 12 s; the recorder writes each later frame one tick after the one before."""
    encoded(t, walkers, "true.mp4", "null")
    stamps = "if(lt(N,120),{0},PREV_OUT{0}+1)"
    t.ffmpeg("-i", "true.mp4", "-c", "copy", "-bsf:v", f"setts=pts='{stamps.format('PTS')}':dts='{stamps.format('DTS')}'", "jumped.mp4")
    told = report_of(t, "jumped.mp4")
    expect_interval(told, "times_doubtful", 11.9, 23.9)
    true = report_of(t, "true.mp4")
    check(intervals_of(true) == [], f"of true times is told {intervals_of(true)}")
    check(len(told["events"]) == len(true["events"]) > 0, f"{len(told['events'])} events with such times, {len(true['events'])} without")
    check("times doubtful from" in told["advice"][0], f"the advice is {told['advice']}")


def test_a_watched_stream_tells_its_faults(t, walkers):
    """The card is longer than the window: it is told whole, and once."""
    encoded(t, walkers, "gate.avi", "drawbox=color=gray:t=fill:enable='between(t,9,15)'")
    t.vvr("watch", "gate.avi", "-o", "gate.png", "--brick", "1s", "--window", "3", "--reference", "first", "--events-to", "gate.jsonl",
          "--quiet", *SIZE).expect(0)
    lines = [json.loads(line) for line in t.path("gate.jsonl").read_text().splitlines()]
    faults = [line for line in lines if line["number"] is None]
    check(len(faults) == 1 and faults[0]["kind"] == "blank", f"the lines of faults are {faults}")
    check(abs(faults[0]["first"] - 8.9) < 0.5 and abs(faults[0]["last"] - 15.1) < 0.5 and faults[0]["page"] is None, f"{faults}")
    check(any(line["number"] for line in lines[lines.index(faults[0]):]), f"events end later than the card, but it is told last: {lines}")
    follows(faults[0], schema_of(t, "event-line"))


def test_a_fault_is_in_tables_lines_and_index(t, walkers):
    t.path("in/gate").mkdir(parents=True)
    encoded(t, walkers, "in/gate/2026-11-21_20-00-00.avi", "drawbox=color=gray:t=fill:enable='between(t,9,15)'")
    t.stamp("in/gate/2026-11-21_20-00-00.avi", -3600)
    t.vvr("archive", "in", "-o", "out", "--events-csv", "all.csv", "--events-to", "all.jsonl", *SIZE).expect(0)
    with t.path("all.csv").open(newline="") as table:
        rows = [row for row in csv.DictReader(table) if row["kind"] == "blank"]
    check(len(rows) == 1 and rows[0]["number"] == "" and abs(float(rows[0]["seconds"]) - 6) < 0.5, f"the table has {rows}")
    lines = [json.loads(line) for line in t.path("all.jsonl").read_text().splitlines()]
    blank = [line for line in lines if line["kind"] == "blank"]
    check(len(blank) == 1 and blank[0]["number"] is None and blank[0]["begin"].startswith("2026-11-21T20:00:0"), f"the lines are {blank}")
    follows(blank[0], schema_of(t, "event-line"))
    sidecar = json.loads(t.path("out/gate/2026-11-21_20-00-00.avi.json").read_text())
    check(sidecar["faults"] == ['no picture for %.1f s' % float(rows[0]['seconds'])], f"the sidecar says {sidecar}")
    check(any("no picture for" in day.read_text() for day in t.path("out").glob("index*.js")) or
          "no picture for" in t.path("out/index.html").read_text(), "the index does not say it")
