"""Asking a page by place: what it lists is held against a computation of its own, by brute force."""

import random
import re
import shlex
import time

import pytest
from browser import Page
from harness import check
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
    """How often a path crosses the stretch from a to b: the two equations of each pair of stretches are solved."""
    count = 0
    for (_, x, y), (_, to_x, to_y) in zip(path, path[1:]):
        dx, dy, ex, ey = to_x - x, to_y - y, b[0] - a[0], b[1] - a[1]
        below = dx * ey - dy * ex
        if below:
            along = ((a[0] - x) * ey - (a[1] - y) * ex) / below
            across = ((a[0] - x) * dy - (a[1] - y) * dx) / below
            count += 0 <= along < 1 and 0 <= across <= 1
    return count


def box_of(a, b):
    return [min(a[0], b[0]), min(a[1], b[1]), max(a[0], b[0]), max(a[1], b[1])]


def listed(page):
    """Of each event in the list: its number, and what the list says of the place."""
    numbers = page.run("return [...document.querySelectorAll('#events button')].map(b => Number(b.dataset.event))")
    return {number: text.split(" · ")[-1] for number, text in zip(numbers, page.texts("#events small"))}


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
                    seconds = float(re.fullmatch(r"here ([\d.]+) s", found[number])[1])
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
            counts = {number: crossings(path, a, b) for number, path in enumerate(paths)}
            found = listed(page)
            crossed = {number for number, count in counts.items() if count}
            check(set(found) == crossed, f"{set(found) ^ crossed} of {len(crossed)} differ; the line is {a} to {b}")
            for number, text in found.items():
                check(text.endswith(f" {counts[number]} times") == (counts[number] > 1), f"{counts[number]} times: {text}")
                check(re.fullmatch(r"crossed [→↘↓↙←↖↑↗]( \d+ times)?", text), text)
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
            check(page.run("return playing") is False, "it plays at once")
        page.run("choose(null); show(123, false)")
        check(copied(page, "#copylink") == t.path("out.html").as_uri() + "#t=4.920", page.run("return window.copied"))
        page.press("#events li:nth-child(2) button")
        check(copied(page, "#copylink") == t.path("out.html").as_uri() + "#event=2", page.run("return window.copied"))
        check(page.run("return location.hash") == "#event=2", "the address does not keep the event")


def test_page_saves_a_still(t):
    bag(t)
    folder = t.path("saved")
    folder.mkdir()
    with Page(t, "out.html") as page:
        page.cdp("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(folder))
        page.run("show(300, false)")
        page.press("#savestill")
        page.wait("it says so", "return document.getElementById('told').textContent.startsWith('Saved')")
        name = page.text("told")[len("Saved "):].split(".png")[0] + ".png"
        for _ in range(100):
            if (folder / name).exists():
                break
            time.sleep(0.05)
    check(name == "bag.mp4 0-12.0.png", name)
    # It is the frame: the two differ by what the preview's codec loses.
    t.ffmpeg("-i", f"saved/{name}", "-vf", "scale=192:144", "-f", "rawvideo", "-pix_fmt", "gray", "shown.raw")
    t.ffmpeg("-i", "bag.mp4", "-vf", "select=eq(n\\,300)", "-frames:v", "1", "-f", "rawvideo", "-pix_fmt", "gray", "true.raw")
    shown, true = t.path("shown.raw").read_bytes(), t.path("true.raw").read_bytes()
    off = sum(abs(a - b) for a, b in zip(shown, true)) / len(true)
    check(len(shown) == len(true) and off < 4, f"another picture: {off} grey levels")
