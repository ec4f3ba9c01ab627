"""render --report: what stands in it is true, and as its schema says."""

import json
import re

import pytest
from harness import check, nightly_except, page_data
from schemas import closed, follows, schema_of


def read(t, name="report.json"):
    """A report, held against the schema, which lists all its keys."""
    report = t.json(name)
    follows(report, closed(schema_of(t, "report")))
    return report


def test_report_of_the_left_bag(t):
    # The scene's own pixels are half the size of the video's here: fields are 192x144.
    t.scene("left_bag", "bag.y4m", "--size", "384x288", "--frames", "400")
    result = t.render("bag.y4m", "--report", "report.json", "--tracks", "tracks.txt", "--field-size", "192x144").expect(
        0, "'out.png': 400 frames", "3 events; the longest from 3.", ", left behind")
    report = read(t)
    check(report["advice"] == [] and "--roi" not in result.err, "advice on a quiet scene")
    check(report["input"] == {"name": "bag.y4m", "camera": None, "container": "yuv4mpegpipe", "codec": "rawvideo", "width": 384,
                              "height": 288, "rate": 25, "recorded": None, "recorded_by": None, "written": None,
                              "bytes": t.path("bag.y4m").stat().st_size, "digest": report["input"]["digest"]}, str(report["input"]))
    check(report["frames"] == {"used": 400, "damaged": 0, "decoded": "all", "hwaccel": "none"}, str(report["frames"]))
    check(report["span"] == {"first": 0, "last": 15.96, "seconds": 15.96}, str(report["span"]))
    check(report["field"] == {"width": 192, "height": 144}, str(report["field"]))
    check(report["settings"]["field-size"] == "192x144" and report["settings"]["filter"] == "difference", str(report["settings"]))
    check(report["volume"]["layers"] == 400 and report["volume"]["bricks"] == 8 and not report["volume"]["still"], "volume")
    check(report["renderer"]["name"] and report["renderer"]["version"], str(report["renderer"]))
    stages = report["seconds"]
    check(stages["draw"] > 0 and stages["fields"] > 0, str(stages))
    check(sum(stages.values()) <= 2 * stages["total"] + 0.01, f"parts that are more than the whole: {stages}")
    check(report["peak_memory_bytes"] > 0, str(report["peak_memory_bytes"]))

    came, bag, back = report["events"]
    # Boxes of --tracks may be a pixel of the field larger, as smoothing widens what moves.
    for line in t.path("tracks.txt").read_text().splitlines():
        frame, number, left, top, width, height = [int(value) for value in line.split(",")[:6]]
        box = report["events"][number - 1]["box"]
        check(box["x"] - 2 <= left - 1 and left - 1 + width <= box["x"] + box["width"] + 2 and box["y"] - 2 <= top - 1 and
              top - 1 + height <= box["y"] + box["height"] + 2, f"frame {frame}: {number} is outside of {box}")
    # Put down at 354 of 1600 frames, taken at 1314, at 239,228 of 384x288.
    check(abs(bag["first"]["frame"] - 354 / 4) <= 5 and abs(bag["last"]["frame"] - 1314 / 4) <= 5, str(bag))
    check(bag["first"]["seconds"] == bag["first"]["frame"] / 25, str(bag["first"]))
    stay, = bag["stays"]
    check(abs(stay["place"]["x"] - 239) <= 5 and abs(stay["place"]["y"] - 228) <= 5, str(stay))
    check(abs(stay["field_place"]["x"] - 119) <= 3 and abs(stay["field_place"]["y"] - 114) <= 3, str(stay))
    box, small = bag["box"], bag["field_box"]
    check((box["x"], box["width"]) == (2 * small["x"], 2 * small["width"]), f"{box} and {small}")
    check((bag["from"], bag["into"]) == (came["number"], back["number"]) == (1, 3), str(bag))
    check(came["path_length"] > 300 and abs(came["path_length"] - 2 * came["field_path_length"]) < 0.1, str(came))
    check(came["path"][0]["place"]["x"] < 30 and came["path"][-1]["place"]["x"] > 350, "his path goes through the picture")
    check(came["stays"] == [] and bag["path_length"] < 5, "who stays and who goes")


def test_report_without_a_picture(t):
    t.clip()
    result = t.vvr("render", "clip.avi", "--report", "report.json").expect(0, "'clip.avi': 20 frames", out="")
    check(result.err.count("\n") == 2, str(result))
    report = read(t)
    check("draw" not in report["seconds"] and "write" not in report["seconds"], "something was drawn")
    t.expect_files("clip.avi", "report.json")
    t.vvr("render", "clip.avi", "--report", "quiet.json", "--quiet").expect(0, err="")
    check(read(t, "quiet.json")["events"] == report["events"], "quiet finds other events")


def test_report_of_nothing(t):
    t.scene("still", "still.y4m", "--size", "192x144", "--noise", "5", "--frames", "60")
    t.render("still.y4m", "--report", "report.json").expect(0, "vvr: no events\n", "nothing moves")
    report = read(t)
    check(report["events"] == [] and report["volume"]["still"], str(report["events"]))


def test_report_where_there_are_no_objects(t):
    t.clip()
    result = t.render("clip.avi", "--filter", "luminance", "--report", "report.json").expect(0)
    check("event" not in result.err, str(result))
    check(read(t)["events"] is None, "the video itself has events")


@pytest.mark.nightly
def test_report_of_what_was_extracted(t):
    t.scene("two_walkers_cross", "cross.y4m", "--size", "192x144", "--frames", "150")
    t.vvr("render", "cross.y4m", "--report", "clip.json").expect(0, "2 events")
    t.vvr("extract", "cross.y4m", "-o", "data").expect(0)
    t.vvr("render", "data", "--report", "data.json").expect(0, "2 events")
    # Data files hold no pictures, by whose colours objects are told apart: places may differ by what is seen of them.
    for of_clip, of_data in zip(read(t, "clip.json")["events"], read(t, "data.json")["events"]):
        for part in ("number", "kind", "first", "last", "from", "into", "by"):
            check(of_clip[part] == of_data[part], f"extraction changes {part}: {of_clip[part]} and {of_data[part]}")


def test_report_of_a_part(t):
    t.scene("left_bag", "bag.y4m", "--size", "192x144", "--frames", "400")
    t.vvr("render", "bag.y4m", "--report", "report.json", "--start", "3s", "--end", "10s").expect(0)
    report = read(t)
    check(report["span"]["first"] == 3 and report["frames"]["used"] == 175, str(report["span"]))
    person = report["events"][0]
    check(person["first"]["frame"] == 75 and person["first"]["seconds"] == 3, f"frames of the clip are counted: {person}")


def test_report_counts_damage(t):
    t.clip("clip.avi", 4)
    data = bytearray(t.path("clip.avi").read_bytes())
    for at in range(len(data) // 2, len(data) // 2 + 2000, 40):
        data[at] ^= 0xFF
    t.write("hurt.avi", bytes(data))
    t.vvr("render", "hurt.avi", "--report", "report.json").expect(0)
    report = read(t)
    check(report["frames"]["damaged"] > 0, str(report["frames"]))


def test_report_survives_a_picture_that_differs(t):
    t.clip()
    arguments = ("render", "clip.avi", "--size", "160x100", "--golden", "golden.png", "--report", "report.json")
    t.vvr(*arguments).expect(7, code="reference-missing")
    read(t)


def test_report_that_cannot_be_written(t):
    t.clip()
    t.render("clip.avi", "--report", "none/report.json").expect(2, "'none/report.json'", "mkdir -p 'none'", code="file-not-found")
    t.path("folder").mkdir()
    t.render("clip.avi", "--report", "folder").expect(2, "'folder'", code="not-a-file")
    t.vvr("render", "clip.avi", "--report", "r.json", "--animate", "3").expect(1, "--animate", "-o FILE", code="output-missing")
    t.expect_files("clip.avi", "folder")
    t.write("report.json", "older")
    t.vvr("render", "none.avi", "--report", "report.json").expect(2, code="file-not-found")
    check(t.path("report.json").read_text() == "older", "a failure touched the older report")


def test_report_names_are_text(t):
    name = "a \"quoted\" <b>ü clip.avi"
    t.clip(name)
    t.vvr("render", name, "--report", "report.json").expect(0)
    check(read(t)["input"]["name"] == name, "another name")
    data = t.path(name).read_bytes()
    with open(bytes(t.folder) + b"/bad\xff.avi", "wb") as file:
        file.write(data)
    t.run([t.vvr_path, "render", b"bad\xff.avi", "--report", "bytes.json"]).expect(0)
    read(t, "bytes.json")


def test_report_has_a_file_of_its_own(t):
    t.clip()
    before = t.path("clip.avi").read_bytes()
    t.render("clip.avi", "--report", "./out.png").expect(1, "--report", "-o", "'out.png'", "use another name", code="options-conflict")
    t.vvr("render", "clip.avi", "--golden", "g.png", "--report", "g.png").expect(
        1, "--report", "--golden", "'g.png'", code="options-conflict")
    t.vvr("render", "clip.avi", "--report", "clip.avi").expect(1, "--report 'clip.avi'", code="output-replaces-input")
    check(t.path("clip.avi").read_bytes() == before, "the clip was written over")
    t.expect_files("clip.avi")


def test_report_of_one_frame(t):
    t.clip("one.avi", 0.1)
    t.vvr("render", "one.avi", "--report", "report.json").expect(0, "'one.avi': 1 frame in 1 layer")
    report = read(t)
    check(report["frames"]["used"] == 1 and report["span"]["seconds"] == 0, str(report["span"]))
    check(report["events"] == [], str(report["events"]))


@pytest.mark.nightly
def test_report_of_a_series(t):
    t.scene("two_walkers_cross", "cross.y4m", "--size", "192x144", "--frames", "150")
    t.vvr("render", "cross.y4m", "--report", "whole.json").expect(0, "2 events")
    t.render("cross.y4m", "--brick", "30f", "--window", "2", "--report", "series.json", output="s{brick}.png").expect(
        0, "5 pictures of 150 frames", "2 events")
    whole, series = read(t, "whole.json"), read(t, "series.json")
    for part in ("frames", "span", "input", "events"):
        check(whole[part] == series[part], f"{part}: {whole[part]} and {series[part]}")
    check(series["seconds"]["draw"] > 0, str(series["seconds"]))


def peeking_clip(t):
    """Somebody walks through, and small things come round the corner of the picture again and again."""
    source = "size={}:rate=10:duration=80"
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:" + source.format("384x288"), "-f", "lavfi", "-i", "testsrc2=" + source.format("12x10"),
             "-f", "lavfi", "-i", "testsrc2=" + source.format("24x50"), "-filter_complex",
             "[0][1]overlay=x='if(lt(mod(n,50),18),384-2*mod(n,50),348)':y='if(lt(mod(n,50),18),16,16-2*(mod(n,50)-18))'[a];"
             "[a][2]overlay=x='-24+2*mod(n,300)':y=180", "-c:v", "ffv1", "peeking.mkv")


@pytest.mark.nightly
def test_report_advises_a_region_where_scraps_dominate(t):
    peeking_clip(t)
    result = t.vvr("render", "peeking.mkv", "--report", "report.json")
    report = read(t)
    advice, = report["advice"]
    small = [event for event in report["events"] if max(event["box"]["width"], event["box"]["height"]) <= 48]
    check(len(small) >= 12, str(len(small)))
    result.expect(0, f"vvr: warning: {advice}", f"{len(small)} of {len(report['events'])} events are small", "pixels at 34", "--roi")
    # What it says can be done.
    command = re.search(r"vvr (inspect 'peeking.mkv' --frame [\d.]+s -o roi.html)$", advice)[1]
    t.vvr(*command.replace("'", "").split()).expect(0, "draw regions on frame")
    # And it helps: what is left are those who walk through, and no advice.
    result = t.vvr("render", "peeking.mkv", "--report", "report.json", "--roi", "0,150 384,150 384,288 0,288").expect(0)
    left = read(t)
    check(len(left["events"]) == len(report["events"]) - len(small) and left["advice"] == [] and "--roi" not in result.err, str(left["advice"]))
    t.vvr("render", "peeking.mkv", "-o", "series.{brick:2}.png", "--size", "160x100", "--brick", "40s", "--report", "series.json").expect(0, "choose a region with --roi")
    check(read(t, "series.json")["advice"] == [advice], "a series has other advice")
    # Where a region was drawn already, there is nothing to say.
    t.vvr("render", "peeking.mkv", "--report", "report.json", "--roi", "0,0 384,0 384,288 0,288").expect(0)
    check(read(t)["advice"] == [], "advises what was done")


def test_a_stay_is_told_with_one_number_everywhere(t):
    # It stands twice: for 3 s, and for 4.5 s.
    place = "if(lt(t,2),20*t,if(lt(t,5),40,if(lt(t,7),40+20*(t-5),if(lt(t,11.5),80,80+20*(t-11.5)))))"
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=192x108:rate=10:duration=18", "-f", "lavfi", "-i",
             "testsrc2=size=20x40:rate=10:duration=18", "-filter_complex",
             f"[1]loop=-1:1[still];[0][still]overlay=x='{place}':y=40:shortest=1:eval=frame", "-c:v", "ffv1", "stays.mkv")
    told = t.render("stays.mkv", "--report", "report.json", "--page", "page.html", "--size", "960x600").expect(0)
    report = read(t)
    stood = max(report["events"], key=lambda event: len(event["stays"]))
    check(stood["kind"] == "stood" and len(stood["stays"]) == 2, str(stood["stays"]))
    seconds = sum(stay["seconds"] for stay in stood["stays"])
    check(7 < seconds < 8.5, f"{seconds}")
    text = f"stayed {round(seconds)} s"
    texts = [label["text"] for label in report["labels"]]
    check(text in texts, f"no {text!r} in the picture: {texts}")
    check(text in told.err, f"no {text!r} in the log: {told}")
    page = t.path("page.html").read_text(encoding="utf-8")
    data = page_data(page)
    check(abs(data["events"][stood["number"] - 1]["still"] - seconds) < 1e-3, str(data["events"]))
    check(f": {text} in all</li>" in page, f"no {text!r} in the page's list for browsers without scripts")


@pytest.mark.parametrize("goes", nightly_except([39.3, 41.6], 41.6))
def test_a_carried_bag_is_left_until_it_is_fetched(t, goes):
    """A bag as wide as who carries it. Its last frames show a hand before it, or somebody stands beside it who then goes with it."""
    man = f"if(between(t,4,12),(t-4)*21-24,if(between(t,12,14),146,if(between(t,14,22),146-(t-14)*21,if(between(t,32,39),(t-32)*24.3-24," \
          f"if(between(t,39,{goes}),146,if(between(t,{goes},50),146-(t-{goes})*21,-100))))))"
    source = "lavfi", "-i", "color={}:size={}:rate=15:duration=60"
    inputs = [part.format(*what) for what in (("gray", "320x240"), ("navy", "24x90"), ("red", "30x26")) for part in ("-f", *source)]
    t.ffmpeg(*inputs, "-filter_complex", f"[0]noise=alls=12:all_seed=3[room];[room][1]overlay=x='{man}':y=85:eval=frame[man];"
             f"[man][2]overlay=x='if(between(t,13,{goes - 0.1}),172,20+{man})':y=138:eval=frame,noise=alls=8:allf=t:all_seed=4", "-c:v", "mpeg4", "-q:v", "3", "bag.avi")
    t.vvr("render", "bag.avi", "--report", "r.json").expect(0, out=None)
    left = [event for event in json.loads(t.path("r.json").read_text())["events"] if event["kind"] == "left"]
    check(len(left) == 1 and abs(left[0]["last"]["seconds"] - goes) < 1 and left[0]["evidence"]["confidence"] > 0.8, f"{left}")


def test_report_names_a_rate_that_is_too_low_for_things(t):
    t.scene("left_bag", "bag.y4m", "--size", "192x144", "--frames", "400")
    for rate, count in ((2, 1), (5, 0)):
        t.ffmpeg("-i", "bag.y4m", "-vf", f"fps={rate}", "-c:v", "mpeg4", "-q:v", "2", f"{rate}.avi")
        said = t.vvr("render", f"{rate}.avi", "--report", "r.json").expect(0, out=None)
        advice = [text for text in t.json("r.json")["advice"] if "fewer than 5" in text]
        check(len(advice) == count == said.err.count("2 frames per second; with fewer than 5"), f"{advice} {said}")
    # The clip has enough frames, but only its key frames were decoded.
    t.ffmpeg("-i", "bag.y4m", "-c:v", "mpeg4", "-g", "25", "-q:v", "2", "25.avi")
    said = t.vvr("render", "25.avi", "--decode", "key", "--report", "r.json").expect(0, out=None).err
    check("1 frames per second of '25.avi' were decoded" in said and "use --decode all" in said, said)
