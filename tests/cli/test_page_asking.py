"""Asking a page by place: what it lists is held against a computation of its own, by brute force."""

import os
import random
import re
import shlex
import time

import pytest
from browser import Page, Served
from harness import check
from test_page import H264
from test_page_player import bag, with_events

pytestmark = pytest.mark.browser

RATE = 25
LAST = 399


def wanderers(t, count=300):
    """The page with so many events that wander at random instead of its own. Returns their paths."""
    chance = random.Random(7)
    times = [sorted(chance.sample(range(LAST), chance.randint(1, 8))) for _ in range(count)]
    # Five digits: none lies on a line from pixel to pixel, where whether it was crossed is a matter of taste.
    paths = [[[frame, round(chance.random(), 4) + 3e-5, round(chance.random(), 4) + 3e-5] for frame in frames] for frames in times]
    with_events(t, "crowd.html", paths)
    return paths


def in_box(path, box):
    """Seconds that a path was in a box, by looking at very many of its moments; None = never."""
    if len(path) == 1:
        return 0 if box[0] <= path[0][1] <= box[2] and box[1] <= path[0][2] <= box[3] else None
    seconds, touched = 0, False
    for (begin, x, y), (end, to_x, to_y) in zip(path, path[1:]):
        steps = 4000
        places = ((x + k / steps * (to_x - x), y + k / steps * (to_y - y)) for k in range(steps + 1))
        inside = sum(box[0] <= at_x <= box[2] and box[1] <= at_y <= box[3] for at_x, at_y in places)
        touched = touched or inside > 0
        seconds += inside / (steps + 1) * (end - begin) / RATE
    return seconds if touched else None


def crossings(path, a, b):
    """Each time that a path crosses the stretch from a to b: at which second, and towards which side, 1 or -1. The two
    equations of each pair of stretches are solved."""
    found = []
    for (frame, x, y), (next_frame, to_x, to_y) in zip(path, path[1:]):
        dx, dy, ex, ey = to_x - x, to_y - y, b[0] - a[0], b[1] - a[1]
        below = dx * ey - dy * ex
        if below:
            along = ((a[0] - x) * ey - (a[1] - y) * ex) / below
            across = ((a[0] - x) * dy - (a[1] - y) * dx) / below
            if 0 <= along < 1 and 0 <= across <= 1:
                found.append(((frame + along * (next_frame - frame)) / RATE, 1 if below < 0 else -1))
    return found


def told_crossings(text):
    """Of the words about crossings: how many of each arrow, and those that are told one by one: arrow and second."""
    one_by_one = [(arrow, int(minutes) * 60 + int(seconds)) for arrow, minutes, seconds in re.findall(r"([→↘↓↙←↖↑↗]) (\d+):(\d\d)", text)]
    many = re.fullmatch(r"crossed (\d+) times \((.*?)\): .*, and (\d+) more", text)
    if not many:
        check(re.fullmatch(r"crossed .*[^,]", text) and len(one_by_one) <= 4, text)
        arrows = [arrow for arrow, _ in one_by_one]
        return {arrow: arrows.count(arrow) for arrow in arrows}, one_by_one
    counts = {arrow: int(count) for arrow, count in re.findall(r"([→↘↓↙←↖↑↗]) (\d+)", many[2])}
    check(sum(counts.values()) == int(many[1]) == len(one_by_one) + int(many[3]), text)
    return counts, one_by_one


def box_of(a, b):
    return [min(a[0], b[0]), min(a[1], b[1]), max(a[0], b[0]), max(a[1], b[1])]


def listed(page):
    """Of each event in the list: its number, and what the list says of the place."""
    numbers = page.run("return [...document.querySelectorAll('#events .row')].map(b => Number(b.dataset.event))")
    return {number: text.split(" · ")[-1] for number, text in zip(numbers, page.run("return [...document.querySelectorAll('#events .row')].map(e => e.querySelector('small')?.textContent ?? '')"))}


def test_page_lists_what_was_in_a_rectangle(t):
    bag(t)
    paths = wanderers(t)
    with Page(t, "crowd.html") as page:
        for begin, end in (((0.3, 0.2), (0.55, 0.6)), ((0.9, 0.9), (0.7, 0.05)), ((0.1, 0.5), (0.2, 0.6))):
            page.press("#askbox")
            page.drag("#screen", begin, ((begin[0] + end[0]) / 2, end[1]), end)
            left, top, right, bottom = box = box_of(*page.run("return [asked.from, asked.to]"))
            check(max(abs(a - b) for a, b in zip(box_of(begin, end), box)) < 0.01, f"{begin} to {end} is taken for {box}")
            found = listed(page)
            slack = 0.001
            for number, path in enumerate(paths):
                surely = in_box(path, (left + slack, top + slack, right - slack, bottom - slack))
                maybe = in_box(path, (left - slack, top - slack, right + slack, bottom + slack))
                check(surely is None or number in found, f"event {number} was there and is not listed")
                check(maybe is not None or number not in found, f"event {number} was not there and is listed")
                if number in found:
                    # Less than a twentieth of a second is no time that one can read.
                    seconds = 0 if found[number] == "came past here" else float(re.fullmatch(r"here ([\d.]+) s", found[number])[1])
                    check((surely or 0) - 0.06 <= seconds <= maybe + 0.06, f"event {number}: {seconds} s, not {surely} to {maybe}")
            check(page.text("heading") == f"{len(found)} of 300 events" and 0 < len(found) < 300, page.text("heading"))
            bars = page.run("return new Set([...document.querySelectorAll('#bars [data-event]')].map(b => b.dataset.event)).size")
            check(bars in (0, len(found)), f"{bars} bars of {len(found)} events")
        page.press("#askall")
        check(page.text("heading") == "300 events" and page.hidden("copyroi"), page.text("heading"))


def test_page_lists_what_crossed_a_line(t):
    bag(t)
    paths = wanderers(t)
    with Page(t, "crowd.html") as page:
        for begin, end in (((0.5, 0.1), (0.5, 0.9)), ((0.8, 0.7), (0.2, 0.4))):
            page.press("#askline")
            page.drag("#screen", begin, end)
            a, b = page.run("return [asked.from, asked.to]")
            wanted = {number: crossings(path, a, b) for number, path in enumerate(paths)}
            found = listed(page)
            crossed = {number for number, those in wanted.items() if those}
            check(set(found) == crossed, f"{set(found) ^ crossed} of {len(crossed)} differ; the line is {a} to {b}")
            arrows = {side: page.run("return arrowAcross(asked, arguments[0], data.size)", side) for side in (1, -1)}
            check(max(map(len, wanted.values())) > 4, "none crosses it often")
            for number, text in found.items():
                counts, one_by_one = told_crossings(text)
                sides = [side for _, side in wanted[number]]
                check(counts == {arrows[side]: sides.count(side) for side in set(sides)}, f"{wanted[number]}: {text}")
                for (arrow, second), (at, side) in zip(one_by_one, wanted[number]):
                    check(arrow == arrows[side] and at - 1.06 <= second <= at + 0.06, f"{wanted[number]}: {text}")
        # Upright lines are crossed to the right or to the left.
        page.press("#askline")
        page.drag("#screen", (0.5, 0.01), (0.5, 0.99))
        for number, text in listed(page).items():
            xs = [x for _, x, _ in paths[number]]
            if counts_once(xs):
                check(("→" if xs[-1] > 0.5 else "←") in text, f"{xs}: {text}")


def counts_once(xs):
    return sum((a < 0.495) != (b < 0.495) for a, b in zip(xs, xs[1:])) == 1 and all(abs(x - 0.5) > 0.01 for x in xs)


def copied(page, selector):
    """What a button puts into the clipboard."""
    page.cdp("Browser.grantPermissions", permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])
    page.open_menu("share" if selector != "#copyroi" else "")
    page.press(selector)
    page.wait("it says so", "const told = document.getElementById('told'); return !told.hidden && told.textContent.startsWith('Copied')")
    page.run("window.copied = null; navigator.clipboard.readText().then(text => { window.copied = text; });")
    page.wait("what was copied", "return window.copied !== null")
    return page.run("return window.copied")


def test_page_gives_the_region_for_the_next_run(t):
    with Page(t, bag(t)) as page:
        page.press("#askbox")
        page.drag("#screen", (0.25, 0.25), (0.75, 0.5))
        option, value = shlex.split(copied(page, "#copyroi"))
        corners = [tuple(map(int, point.split(","))) for point in value.split()]
        wanted = [(48, 36), (144, 36), (144, 72), (48, 72)]
        check(option == "--roi" and all(abs(a - b) <= 1 for c, w in zip(corners, wanted) for a, b in zip(c, w)), value)
    t.vvr("render", "bag.mp4", "-o", "again.png", "--size", "320x200", "--backend", "software", option, value).expect(0)


def test_page_copies_the_command_that_cuts_an_event(t):
    bag(t)
    name = "it's \"a\" bag $(touch gone).mp4"
    t.path("bag.mp4").rename(t.path(name))
    t.vvr("render", name, "-o", "out.html", "--size", "640x400", "--backend", "software").expect(0)
    with Page(t, "out.html") as page:
        check(page.run("return document.getElementById('copycut').disabled"), "a command without an event")
        page.run("choose(1)")
        first, last = page.run("return [data.events[1].first, data.events[1].last]")
        command = copied(page, "#copycut")
    program, *arguments = shlex.split(command)
    check(program == "vvr", command)
    # A shell reads it as Python does: nothing in a name is a command.
    done = t.run(["bash", "-c", 'vvr() { printf "%s\\n" "$@"; }; ' + command])
    check(done.out.splitlines() == arguments, str(done))
    before = set(t.files())
    t.vvr(*arguments).expect(0)
    made = set(t.files()) - before
    check(made == {arguments[-1]}, f"{made}")
    probe = t.run(["ffprobe", "-v", "error", "-show_entries", "format=duration", "-of", "csv=p=0", arguments[-1]])
    seconds = (last - first + 1) / RATE
    # It begins at the key frame before, which x264 sets at least every 10 s.
    check(seconds - 0.1 <= float(probe.out) <= seconds + 11, f"the clip lasts {probe.out}, the event {seconds} s")


def test_page_copies_a_command_that_works_as_it_stands(t):
    """Whatever holds the codec, and all files of a recording in which the event lies."""
    t.scene("left_bag", "bag.y4m", "--size", "192x144", "--frames", "400")
    t.path("day").mkdir()
    t.ffmpeg("-i", "bag.y4m", "-c:v", "msmpeg4", "-g", "25", "-q:v", "3", "bag.avi")
    t.ffmpeg("-i", "bag.y4m", *H264, "-g", "25", "-f", "segment", "-segment_time", "5", "-segment_format_options", "movflags=+faststart",
             "-reset_timestamps", "1", "day/gate %d.mp4")
    for k in range(4):  # each ends where the next begins
        os.utime(t.path(f"day/gate {k}.mp4"), (0, 1_700_000_000 + min(5 * (k + 1), 16)))
    for clip, files in (("bag.avi", ["./bag.avi"]), ("day", [f"./day/gate {k}.mp4" for k in range(4)])):
        t.vvr("render", clip, "-o", "out.html", "--size", "640x400", "--backend", "software", "--start-time", "none").expect(0)
        with Page(t, "out.html") as page:
            longest = page.run("return sortedPlaces(events, [...events.keys()], 'longest', time, kindOf)[0]")
            first, last = page.run(f"choose({longest}); return [data.events[{longest}].first, data.events[{longest}].last]")
            program, command, *arguments = shlex.split(copied(page, "#copycut"))
        check(arguments[:arguments.index("--start")] == (files if clip == "bag.avi" else files[first // 125:last // 125 + 1]), f"{arguments}")
        done = t.vvr(command, *arguments).expect(0, "frames copied")
        shown = t.run(["ffprobe", "-v", "error", "-select_streams", "v", "-count_frames", "-show_entries", "stream=nb_read_frames",
                       "-of", "csv=p=0", arguments[-1]])
        length = last - first + 1
        check(length <= int(shown.out.strip().strip(",")) <= length + 28, f"{done}\n{shown} for {length}")
        check(arguments[-1].endswith(".avi" if clip == "bag.avi" else ".mp4"), arguments[-1])


def test_page_links_lead_to_moments_and_events(t):
    bag(t)
    with Page(t, "out.html") as page:
        first = page.run("return data.events[1].first")
        for address, event, frame in (("#t=10", None, 250), ("#event=2", 1, first), ("#t=nonsense", None, 0), ("#event=99", None, 0),
                                      ("#t=1e9", None, LAST), ("#t=-4", None, 0)):
            page.driver.get("about:blank")
            page.driver.get(t.path("out.html").as_uri() + address)
            page.wait("it is open", "return document.documentElement.dataset.ready !== undefined && film !== null")
            check(page.run("return [chosen, now]") == [event, frame], f"{address} leads to {page.run('return [chosen, now]')}")
            page.wait("the player is there", f"return Math.floor(video.currentTime * 25 + 1e-6) === {frame}")
            check(page.run("return isPlaying()") is False, "it plays at once")
            check(("no event 99" in page.text("told")) == ("99" in address), f"{address}: {page.text('told')}")
        page.run("choose(null); show(123, false)")
        check(copied(page, "#copylink") == t.path("out.html").as_uri() + "#t=4.920", page.run("return window.copied"))
        page.open_menu("")
        page.press("#events li:nth-child(2) .row")
        check(copied(page, "#copylink") == t.path("out.html").as_uri() + "#event=2", page.run("return window.copied"))
        check(page.run("return location.hash") == "#event=2", "the address does not keep the event")


def test_page_says_what_it_could_not_copy(t):
    with Page(t, bag(t)) as page:
        page.run("""navigator.clipboard.writeText = () => Promise.reject(new Error('no'));
            document.execCommand = () => false; choose(1)""")
        page.open_menu("share")
        page.press("#copylink")
        page.wait("it says so", "return document.getElementById('told').textContent !== ''")
        check(page.text("told").startswith("This browser copies nothing.") and "#event=2" in page.text("told"), page.text("told"))


def saved(t, page, frame):
    """Saves the still of a frame. Returns what the page says, and the file."""
    folder = t.path("saved")
    folder.mkdir(exist_ok=True)
    page.cdp("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(folder))
    page.run("document.getElementById('told').textContent = ''; show(arguments[0], false)", frame)
    page.wait("it is there", "return !film || !video.seeking && video.readyState > 1")
    page.open_menu("share")
    page.press("#savestill")
    page.wait("it says so", "return document.getElementById('told').textContent.startsWith('Saved')")
    told = page.text("told")
    name = told[len("Saved "):].split(".png")[0] + ".png"
    for _ in range(100):
        if (folder / name).exists():
            break
        time.sleep(0.05)
    check((folder / name).exists(), f"{told}: there is {list(folder.iterdir())}")
    return told, folder / name


def size_of(t, path):
    probe = t.run(["ffprobe", "-v", "error", "-show_entries", "stream=width,height", "-of", "csv=p=0", str(path)])
    return probe.out.strip().rstrip(",")


def off_by(t, picture, clip, frame):
    """Mean difference of a picture and a frame, in grey levels."""
    t.ffmpeg("-i", str(picture), "-vf", "scale=192:144", "-f", "rawvideo", "-pix_fmt", "gray", "shown.raw")
    t.ffmpeg("-i", clip, "-vf", f"select=eq(n\\,{frame})", "-frames:v", "1", "true.png")
    t.ffmpeg("-i", "true.png", "-vf", "scale=192:144", "-f", "rawvideo", "-pix_fmt", "gray", "true.raw")
    shown, true = t.path("shown.raw").read_bytes(), t.path("true.raw").read_bytes()
    check(len(shown) == len(true), f"{len(shown)} and {len(true)} bytes")
    return sum(abs(a - b) for a, b in zip(shown, true)) / len(true)


@pytest.mark.parametrize("clip, codec", [("bag.mp4", H264), ("bag.avi", ("-c:v", "msmpeg4v2", "-q:v", "3")),
                                         ("hevc.mp4", ("-c:v", "libx265", "-preset", "ultrafast", "-x265-params", "log-level=none"))])
@pytest.mark.parametrize("server", [False, True])
def test_page_saves_a_still(t, clip, codec, server):
    """What is not the clip's own frame says so, in its name too, and there is a command for the frame itself."""
    t.scene("left_bag", "bag.y4m", "--size", "480x360", "--frames", "200")
    t.ffmpeg("-i", "bag.y4m", *codec, clip)
    t.vvr("render", clip, "-o", "out.html", "--size", "640x400", "--backend", "software").expect(0)
    whole = server and clip == "bag.mp4"  # of a file that was opened as one browsers give no pixels, and others they don't play
    with Served(t.folder) as served, Page(t, served.url("out.html") if server else "out.html") as page:
        page.wait("a film is open", "return film !== null")
        told, path = saved(t, page, 150)
        check(path.name == f"{clip} 0-06.0{'' if whole else '.preview'}.png", path.name)
        if whole:
            check(told == f"Saved {path.name}, 480×360, as in the clip" and size_of(t, path) == "480,360", told)
        else:
            check("×" in told and "of the clip’s 480×360, from the preview in this page. “Copy command for this frame”" in told, told)
            check(size_of(t, path) != "480,360", size_of(t, path))
        check(off_by(t, path, clip, 150) < 4, f"another picture: {off_by(t, path, clip, 150)} grey levels")
        for frame in (0, 1, 137, 199):
            page.run("show(arguments[0], false)", frame)
            command = copied(page, "#copystill")
            check(command.startswith("ffmpeg -ss "), command)
            name = shlex.split(command)[-1]
            t.run(["bash", "-c", command.replace("ffmpeg ", "ffmpeg -v error -y ", 1)]).expect(0)
            check(size_of(t, name) == "480,360", f"{command}: {size_of(t, name)}")
            check(off_by(t, name, clip, frame) == 0, f"{command}: not frame {frame}, {off_by(t, name, clip, frame)}")


def test_page_and_index_tell_the_same_crossings(t):
    """For the same clip and line, whatever the line: the same events, ways and times of day."""
    t.zone("UTC")
    t.scene("walkers", "walkers.y4m", "--size", "192x144", "--frames", "300", "--seed", "5")
    t.path("in/gate").mkdir(parents=True)
    t.ffmpeg("-i", "walkers.y4m", "-c:v", "mpeg4", "-q:v", "3", "in/gate/20261117T071500.avi")
    os.utime(t.path("in/gate/20261117T071500.avi"), (1e9, 1e9))
    t.vvr("archive", "in", "-o", "out", "--size", "320x200", "--backend", "software").expect(0)
    chance = random.Random(11)
    lines = [((0.5, 0.02), (0.5, 0.98)), ((0.02, 0.5), (0.98, 0.5))]
    lines += [tuple((round(chance.random(), 3), round(chance.random(), 3)) for _ in range(2)) for _ in range(30)]
    ask = "askPlace({kind: 'line', from: arguments[0].map(v => v * arguments[2]), to: arguments[1].map(v => v * arguments[2])});"
    told = []
    with Page(t, "out/gate/20261117T071500.avi.html") as page:
        for a, b in lines:
            page.run(ask, a, b, 1)
            told.append({number + 1: text for number, text in listed(page).items()} if page.count("#events .row") else {})
        page.driver.get(t.path("out/index.html").as_uri())
        page.wait("the list", "return document.querySelector('#days .day') !== null")
        page.press("#views [value=scene]")
        page.wait("all events", "return document.getElementById('foundheading').textContent.includes('event')")
        page.wait("the scene", "return document.getElementById('ground').naturalWidth > 0")
        for (a, b), of_page in zip(lines, told):
            page.run("set({answer: null});" + ask, a, b, 1000)
            page.wait("an answer", "return answer !== null && document.getElementById('foundheading').textContent.includes(' of ')")
            of_index = dict(page.run("return answer.found.map(({event, how}) => [event.number, how.words()])"))
            of_index = {int(number): text for number, text in of_index.items()}
            check(of_index == of_page, f"{a} to {b}: the page says {of_page}, the index {of_index}")
    check(sum(map(len, told)) > 20, f"too few crossings: {told}")
