"""Asking a page by place; tests/web/geometry.test.js holds ways against brute force."""

import os
import random
import re
import shlex

import pytest
from browser import Page, Served
from harness import check
from test_page import H264, bag
from test_page_player import with_events

pytestmark = pytest.mark.browser

RATE = 25
LAST = 399


# By frames and by shares of width and height: to the right, to the left, above, a moment in the middle, there and back.
WAYS = [[[0, 0.1, 0.5], [100, 0.9, 0.5]], [[0, 0.9, 0.5], [100, 0.1, 0.5]], [[0, 0.1, 0.1], [100, 0.9, 0.1]],
        [[50, 0.5, 0.5]], [[0, 0.1, 0.5], [100, 0.9, 0.5], [200, 0.1, 0.5]]]


def listed(page):
    """Of each event in the list: its number, and what the list says of the place."""
    numbers = page.run("return [...document.querySelectorAll('#events .row')].map(b => Number(b.dataset.event))")
    return {number: text.split(" · ")[-1] for number, text in zip(numbers, page.run("return [...document.querySelectorAll('#events .row')].map(e => e.querySelector('small')?.textContent ?? '')"))}


def test_page_lists_what_crossed_a_line(t):
    wanted = {0: "→ 0:0[12]", 1: "← 0:0[12]", 4: "→ 0:0[12], ← 0:0[56]"}
    bag(t)
    with Page(t, with_events(t, "ways.html", WAYS)) as page:
        for begin, end in (((0.5, 0.3), (0.5, 0.7)), ((0.53, 0.85), (0.47, 0.15))):
            page.press("#askline")
            page.drag("#screen", begin, end)
            found = listed(page)
            check(found.keys() == wanted.keys(), f"{found}")
            check(all(re.fullmatch(f"crossed {wanted[number]}", text) for number, text in found.items()), f"{found}")
            check(page.text("heading") == "3 of 5 events", page.text("heading"))
            bars = page.run("return new Set([...document.querySelectorAll('#bars [data-event]')].map(b => b.dataset.event)).size")
            check(bars == 3, f"{bars} bars of 3 events")
        # What was asked is a picture with the line on it.
        check(page.text("askall") == "Across this line✕" and page.count("#askall line") == 1, page.text("askall"))
        page.wait("its picture", "return document.querySelector('#askall img')?.naturalWidth > 0")
        page.press("#askall")
        check(page.text("heading") == "5 events" and page.hidden("copyroi"), page.text("heading"))


def copied(page, selector):
    """What a button puts into the clipboard."""
    page.allow_clipboard()
    page.open_menu("share" if selector != "#copyroi" else "")
    page.press(selector)
    page.wait("it says so", "const told = document.getElementById('told'); return !told.hidden && told.textContent.startsWith('Copied')")
    return page.clipboard()


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
    lasts = float(t.probe(arguments[-1], "format=duration"))
    seconds = (last - first + 1) / RATE
    # It begins at the key frame before, which x264 sets at least every 10 s.
    check(seconds - 0.1 <= lasts <= seconds + 11, f"the clip lasts {lasts}, the event {seconds} s")


def test_page_copies_a_command_that_works_as_it_stands(t):
    """Whatever holds the codec, and all files of a recording in which the event lies."""
    t.scene("left_bag", "bag.y4m", "--size", "192x144", "--frames", "400")
    t.ffmpeg("-i", "bag.y4m", "-c:v", "msmpeg4", "-g", "25", "-q:v", "3", "bag.avi")
    t.ffmpeg("-i", "bag.y4m", *H264, "-g", "25", "-f", "segment", "-segment_time", "5", "-segment_format_options", "movflags=+faststart",
             "-reset_timestamps", "1", "day/gate %d.mp4")
    for k in range(4):  # each ends where the next begins
        os.utime(t.path(f"day/gate {k}.mp4"), (0, 1_700_000_000 + min(5 * (k + 1), 16)))
    for clip, files in (("bag.avi", ["./bag.avi"]), ("day", [f"./day/gate {k}.mp4" for k in range(4)])):
        t.vvr("render", clip, "-o", "out.html", "--size", "640x400", "--backend", "software", "--start-time", "none").expect(0)
        with Page(t, "out.html") as page:
            longest = page.run("return sortedPlaces(events, [...events.keys()], 'longest', kindOf)[0]")
            first, last = page.run(f"choose({longest}); return [data.events[{longest}].first, data.events[{longest}].last]")
            program, command, *arguments = shlex.split(copied(page, "#copycut"))
        check(arguments[:arguments.index("--start")] == (files if clip == "bag.avi" else files[first // 125:last // 125 + 1]), f"{arguments}")
        done = t.vvr(command, *arguments).expect(0, "frames copied")
        length = last - first + 1
        check(length <= t.frames_in(arguments[-1]) <= length + 28, f"{done}\n{t.frames_in(arguments[-1])} for {length}")
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


def saved_still(t, page, frame):
    """What the page says when the still of a frame is saved, and the file."""
    page.run("document.getElementById('told').textContent = ''; show(arguments[0], false)", frame)
    page.wait("it is there", "return !film || !video.seeking && video.readyState > 1")
    page.open_menu("share")
    path = page.saved(t, "#savestill", "*.png")
    page.wait("it says so", "return document.getElementById('told').textContent.startsWith('Saved')")
    return page.text("told"), path


def off_by(t, picture, clip, frame):
    """Mean difference of a picture and a frame, in grey levels."""
    t.ffmpeg("-i", clip, "-vf", f"select=eq(n\\,{frame})", "-frames:v", "1", "true.png")
    shown, true = (t.raw(name, "gray", "-vf", "scale=192:144") for name in (picture, "true.png"))
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
        told, path = saved_still(t, page, 150)
        check(path.name == f"{clip} 0-06.0{'' if whole else '.preview'}.png", path.name)
        if whole:
            check(told == f"Saved {path.name}, 480×360, as in the clip" and t.picture_size(path) == (480, 360), told)
        else:
            check("×" in told and "of the clip’s 480×360, from the preview in this page. “Copy command for this frame”" in told, told)
            check(t.picture_size(path) != (480, 360), "the preview is as large as the clip")
        check(off_by(t, path, clip, 150) < 4, f"another picture: {off_by(t, path, clip, 150)} grey levels")
        for frame in (0, 1, 137, 199):
            page.run("show(arguments[0], false)", frame)
            command = copied(page, "#copystill")
            check(command.startswith("ffmpeg -ss "), command)
            name = shlex.split(command)[-1]
            t.run(["bash", "-c", command.replace("ffmpeg ", "ffmpeg -v error -y ", 1)]).expect(0)
            check(t.picture_size(name) == (480, 360), f"{command}: {t.picture_size(name)}")
            check(off_by(t, name, clip, frame) == 0, f"{command}: not frame {frame}, {off_by(t, name, clip, frame)}")


def test_page_and_index_tell_the_same_crossings(t):
    """For the same clip and line, whatever the line: the same events, ways and times of day."""
    t.zone("UTC")
    t.scene("walkers", "walkers.y4m", "--size", "192x144", "--frames", "300", "--seed", "5")
    t.ffmpeg("-i", "walkers.y4m", "-c:v", "mpeg4", "-q:v", "3", "in/gate/20261117T071500.avi")
    t.stamp("in/gate/20261117T071500.avi", 1e9)
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
