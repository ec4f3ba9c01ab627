"""A page says whose it is, without a script: camera, day and time, what tells them, and the file's name."""

import html
import re

import pytest
from harness import check, nightly_except, page_data
from test_archive import QUICK
from test_page_live import page_of

MTIME = 1_790_000_000  # no day that a name here tells


def words_of(t, page):
    """Title, heading, the file's name and the summary."""
    text = t.path(page).read_text(errors="replace")
    found = [re.search(pattern, text, re.DOTALL)[1] for pattern in (
        "<title>(.*?)</title>", "<h1>(.*?)</h1>", '<p id="file">(.*?)</p>', '<p id="summary">(.*?)</p>')]
    title, heading, file, summary = map(html.unescape, found)
    check(title == heading, f"the tab says {title}, the page {heading}")
    return heading, file, summary


def clips(t, *names, seconds=2):
    t.clip("one.avi", seconds=seconds)
    for name in names:
        t.copy("one.avi", name)
        t.stamp(name, MTIME)
    t.path("one.avi").unlink()


def test_page_heading_of_a_clip_in_an_archive(t):
    names = [f"in/{camera}/{day}/07.15.00-07.15.20[M][0@0][0].avi" for camera in ("back-door", "Till & <b>") for day in ("2026-11-17", "2026-11-18")]
    clips(t, *names)
    patterns = ("--names", "{camera}/%Y-%m-%d/%H.%M.%S-*")
    t.vvr("archive", "in", "-o", "out", *QUICK, *patterns).expect(0)
    for name in names:
        camera, day = name.split("/")[1:3]
        heading, file, summary = words_of(t, name.replace("in/", "out/") + ".html")
        check(heading == f"{camera} · {'Tue 17' if day.endswith('17') else 'Wed 18'} Nov 2026, 07:15", heading)
        check(file == name.split("/")[-1], file)
        check(summary == "07:15:00 to 07:15:01, 0 events; times of day by file name", summary)


def test_page_heading_of_a_day_in_an_archive(t):
    clips(t, *[f"in/hall/2026-11-17/{time}.avi" for time in ("07-30-00", "14-00-00", "21-30-00")])
    t.vvr("archive", "in", "-o", "out", *QUICK, "--per", "day", "--names", "{camera}/%Y-%m-%d/%H-%M-%S").expect(0)
    heading, file, summary = words_of(t, "out/hall/2026-11-17.html")
    check(heading == "hall · Tue 17 Nov 2026, 07:30–21:30", heading)
    check(file == "3 files", file)
    report = t.json("out/hall/2026-11-17.report.json")
    check(report["frames"]["used"] == 60, str(report["frames"]))


def test_page_heading_of_a_clip_whose_time_nobody_knows(t):
    clips(t, "plain.avi", "named.avi")
    t.vvr("render", "plain.avi", "-o", "plain.html", *QUICK).expect(0)
    check(words_of(t, "plain.html") == ("plain.avi", "", "0:00 to 0:02, 0 events; time of day not known"), str(words_of(t, "plain.html")))
    t.vvr("render", "plain.avi", "-o", "given.html", *QUICK, "--start-time", "2026-11-17T23:59:59", "--title", "Gate").expect(0)
    heading, file, summary = words_of(t, "given.html")
    check(heading == "Gate · Tue 17 Nov 2026, 23:59 – Wed 18 Nov 2026, 00:00", heading)
    check(file == "plain.avi" and summary.endswith("; times of day as given"), f"{file}; {summary}")


def test_page_heading_ends_with_the_picture(t):
    """Times of a clip are rounded in both, and are those of its frames: the last of 47 is at 4.6 s."""
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=192x144:rate=10:duration=5", "-f", "lavfi", "-i", "testsrc2=size=30x40:rate=10:duration=5",
             "-filter_complex", "[0][1]overlay=x='if(between(t,1,4),10+40*(t-1),-100)':y=50:eval=frame", "-c:v", "mpeg4", "clip.avi")
    t.render("clip.avi", "--end", "47f", output="out.html").expect(0)
    check(words_of(t, "out.html")[2] == "0:00 to 0:05, 1 event; time of day not known", str(words_of(t, "out.html")))
    page = t.path("out.html").read_text()
    listed = re.findall("<li>(.*)</li>", page.split('<ol id="events"')[1].split("</ol>")[0])
    deeds = [event["deed"] for event in page_data(page)["events"]]
    check(deeds and [line.split(": ", 1)[1] for line in listed] == deeds, f"without scripts: {listed}, not {deeds}")


@pytest.mark.nightly
def test_page_heading_of_a_stream(t):
    page_of(t, "file.html", 3, "--title", "gate")
    heading, _, summary = words_of(t, "file.html")
    check(heading == "gate" and summary.endswith("; time of day not known"), f"a file is not of now: {heading}, {summary}")
    watch = f"cat cam.ts | {t.vvr_path} watch - -o live.html --title gate --brick 1s --window 3 --size 480x300 --backend software"
    t.run(["bash", "-c", watch]).expect(0)
    heading, _, summary = words_of(t, "live.html")
    check(re.fullmatch(r"gate · \w{3} \d+ \w{3} 20\d\d, \d\d:\d\d(–\d\d:\d\d)?", heading), heading)
    check(summary.endswith("; times of day live"), summary)


@pytest.mark.parametrize("hours", nightly_except([0, 2], 0))
def test_page_events_do_not_span_time_without_signal(t, hours):
    """Somebody stands there at the end of one file and at the beginning of the next."""
    rate, seconds = 10, 20
    for number in range(2):
        # A box comes and stays; in the second file it is there from the first frame on, and goes.
        place = "if(lt(t,5),-60+24*t,60)" if number == 0 else "if(lt(t,15),60,60+24*(t-15))"
        graph = (f"color=gray:size=192x144:rate={rate}:duration={seconds}[g];color=white:size=24x48:rate={rate}:duration={seconds}[w];"
                 f"[g][w]overlay=x='{place}':y=60:shortest=1")
        begin = 7 * 3600 + number * (seconds + hours * 3600)
        name = f"in/gate_2026-11-17_{begin // 3600:02}-{begin // 60 % 60:02}-{begin % 60:02}.avi"
        t.ffmpeg("-filter_complex", graph, "-c:v", "mpeg4", "-q:v", "2", name)
    t.vvr("render", "in", "-o", "out.html", "--size", "320x200", "--backend", "software", "--report", "report.json",
          "--names", "{camera}_%Y-%m-%d_%H-%M-%S").expect(0)
    events = t.json("report.json")["events"]
    check(events, "nobody was seen")
    longest = max(event["seconds"] for event in events)
    stood = max(sum(stay["seconds"] for stay in event["stays"]) for event in events)
    if hours:
        check(longest <= seconds + 0.2 and stood <= seconds + 0.2, f"{longest} s, stood for {stood} s, of {seconds} s of footage")
        gap = (seconds, hours * 3600 + seconds)
        for event in events:
            check(event["last"]["seconds"] <= gap[0] or event["first"]["seconds"] >= gap[1] - 1, f"it spans the gap: {event}")
        check(any(event["first"]["seconds"] >= gap[1] - 1 for event in events), "nobody is there after the gap")
    else:
        check(longest > seconds, f"without a gap it is one event: {longest} s")
