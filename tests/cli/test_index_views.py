"""The index answers "was anything left?", by days and by place, in a real browser."""

import json
import random
import re
import time

import pytest
from harness import check
from test_archive_index import HOUR, NOW, files_of, known, opened, write_index

pytestmark = pytest.mark.browser


def cards(page):
    """Of each card: name, badges and the number of events."""
    return page.run("return [...document.querySelectorAll('.card')].map(card => [card.querySelector('.facts').title.split('/').pop(),"
                    "[...card.querySelectorAll('.badge, .count')].map(b => b.textContent)])")


def test_index_tells_what_was_left(t):
    left = ["left", 1, 255, 10, 500, 500, 270, 500, 500]       # 26 s
    stood = ["stood", 2, 1850, 0, 100, 100, 3000, 200, 100]     # for 3:05
    taken = ["taken", 3, 0, 5, 1, 1, 9, 2, 2]
    passed = ["moved", 1, 0, 0, 0, 0, 50, 1000, 0]
    known(t, "gate/a.avi", NOW - HOUR, events=1, found=[left])
    known(t, "gate/b.avi", NOW - 2 * HOUR, events=3, found=[passed, stood, taken])
    known(t, "gate/c.avi", NOW - 3 * HOUR, events=9, found=[passed] * 9)
    known(t, "gate/d.avi", NOW - 4 * HOUR, events=0, found=[])
    known(t, "gate/bad.avi", NOW, state="failed", tries=1, status=3, reason="'bad.avi' is not a video", files={})
    write_index(t)
    with opened(t, cards=5) as page:
        check(cards(page) == [["a.avi", ["left behind for 26 s", "1 event"]], ["b.avi", ["taken", "stayed for 3 min", "3 events"]],
                              ["c.avi", ["9 events"]], ["d.avi", ["no events"]], ["bad.avi", []]], str(cards(page)))
        for kind, names in (("left", "a b"), ("stood", "b"), ("events", "a b c"), ("failed", "bad")):
            page.run(f"document.querySelector('[value={kind}]').click()")
            page.wait(kind, f"return document.querySelectorAll('.card').length === {len(names.split())}")
            check([name for name, _ in cards(page)] == [f"{name}.avi" for name in names.split()], f"{kind}: {cards(page)}")
        page.run("document.querySelector('[value=all]').click()")
        page.set("order", "events")
        page.wait("cards", "return document.querySelectorAll('.card').length === 5")
        check([name[0] for name, _ in cards(page)] == list("cbadb"), f"{cards(page)}")
        page.filter("nothing has this name")
        check("No matching clips" in page.text("days"), page.text("days"))
        page.press("#days .empty button")
        page.wait("all again", "return document.querySelectorAll('.card').length === 5")


def test_index_keeps_what_was_seen_and_marks_what_is_gone(t):
    for number, name in enumerate(("a.avi", "b.avi", "gone.avi")):
        known(t, f"gate/{name}", NOW - number * HOUR, events=1)
        t.write(f"out/gate/{name}.html", f"<title>the page of {name}</title>")
    for name in ("a.avi", "b.avi"):
        t.clip(f"clips/gate/{name}", 1)
    t.archive("clips", "-o", "out", "--size", "320x200").expect(0)
    with opened(t, cards=3) as page:
        check(files_of(page, ".facts:has(.gone)") == ["gate/gone.avi"], str(files_of(page, ".facts:has(.gone)")))
        check(" · 1 gone" in page.text("summary"), page.text("summary"))
        check(page.count(".seen") == 0, "one is said to be seen")
        page.run("document.querySelector('a.card:has([title$=\"gone.avi\"])').click()")
        page.wait("the clip's page", "return document.title === 'the page of gone.avi'")
        page.open(t.path("out/index.html"))
        page.wait("cards", "return document.querySelectorAll('.card').length === 3")
        check(files_of(page, ".seen .facts") == ["gate/gone.avi"], str(files_of(page, ".seen .facts")))
        check("seen, " in page.run("return document.querySelector('.seen').ariaLabel"), "a screen reader does not tell it")
        looks = "return [...document.querySelectorAll('.card .tile')].map(e => getComputedStyle(e).opacity)"
        page.move(2, 2)
        check(sorted(page.run(looks)) == ["0.5", "1", "1"], f"seen is not dimmed: {page.run(looks)}")
        page.run("document.querySelector('[value=unseen]').click()")
        page.wait("two are left", "return document.querySelectorAll('.card').length === 2")


def test_index_leads_from_clip_to_clip(t):
    for name in ("gate/20261120T080000", "hall/20261120T083000", "gate/20261120T090000", "gate/20261120T100000"):
        t.clip(f"clips/{name}.avi", 2)
    t.archive("clips", "-o", "out", "--size", "320x200", "--backend", "software").expect(0)
    with opened(t, cards=4) as page:
        page.run("[...document.querySelectorAll('a.card')].find(c => c.textContent.includes('09:00')).click()")
        for selector, name in (("#later", "20261120T100000.avi"), ("#earlier", "20261120T090000.avi"), ("#earlier", "20261120T080000.avi")):
            page.wait("a clip's page", "return document.documentElement.dataset.ready !== undefined")
            page.press(selector)
            title = f"gate · Fri 20 Nov 2026, {name[9:11]}:00"
            page.wait(title, f"return document.title === '{title}'")
            check(page.text_of("#file") == name, page.text_of("#file"))
        page.wait("the clip's page", "return document.documentElement.dataset.ready !== undefined")
        # Before the first there is none: it stays there, and says so.
        page.press("#earlier")
        page.wait("it says so", "return document.getElementById('told').textContent === 'This is the first clip of this camera with a picture.'")
        check(page.run("return document.title") == "gate · Fri 20 Nov 2026, 08:00" and page.count("#earlier[href]") == 0, "it leads on")
        page.press("#toindex")
        page.wait("the index", "return document.querySelectorAll('.card').length === 4")


def test_index_by_days(t):
    left = ["left", 1, 0, 0, 1, 1, 260, 1, 1]
    for day in range(40):
        for camera in ("gate", "hall"):
            if camera == "gate" or day % 3 == 0:
                known(t, f"{camera}/{day}.avi", NOW - day * 24 * HOUR, events=day % 4, found=[left] if day == 5 else [])
    write_index(t)
    with opened(t) as page:
        page.press("#views [value=days]")
        page.wait("days", "return document.querySelectorAll('#overview th[scope=row]').length === 40")
        check(page.texts("#overview table:first-of-type th[scope=col] bdi") == ["gate", "hall"], str(page.texts("#overview th[scope=col]")))
        check(page.texts("#overview table:first-of-type th[scope=col]:last-child .scale i") == ["0", "6", "12", "18", "24"], "the hours have no scale")
        check(page.texts("#overview caption") == ["November 2026", "October 2026"], str(page.texts("#overview caption")))
        check(page.count("#overview td button") == 40 + 14, "cells")
        check(page.count("#overview td button .hours i") == 54, "an hour of each clip")
        # Columns are equally wide, and the bars of a day at one height, whatever is told below them.
        wide = page.run("return [...document.querySelectorAll('#overview th[scope=col]')].map(e => Math.round(e.getBoundingClientRect().width))")
        check(len(set(wide)) == 1, f"columns of {wide} pixels")
        tops = page.run("return [...document.querySelectorAll('#overview tr')].map(row => [...row.querySelectorAll('.hours')].map(e => e.getBoundingClientRect().top))")
        check(all(len(set(row)) <= 1 for row in tops), f"bars at {tops}")
        left, top, right, bottom = page.box("#overview .hours i")
        page.move((left + right) / 2, (top + bottom) / 2)
        page.wait("what the hour has", "return document.querySelector('#overview .hours i').title === '08:00 to 08:59: 0 events in clips that begin then'")
        check(page.texts("#overview tr:has(.strong) th") == ["Mon 16"] and page.texts("#overview .strong") == ["left behind for 26 s"], "what was left")
        page.run("document.querySelector('#overview .strong').closest('button').click()")
        page.wait("the day's clips", "return document.querySelectorAll('.card').length === 1")
        check(page.text("count") == "1 of 54 clips · Mon 16 Nov", page.text("count"))


@pytest.mark.parametrize("width", [1280, 2560, 390])
def test_index_fills_its_width(t, width):
    """Cards of a day fill rows, all cameras together, each still in its own shape; on a phone the first one is high up."""
    for number, (camera, size) in enumerate([("gate", "160x120"), ("hall", "160x90"), ("yard", "160x120")] * 4):
        clip = f"{camera}/{number:02}.avi"
        known(t, clip, NOW - number * 600, events=1)
        t.path(f"out/{camera}").mkdir(parents=True, exist_ok=True)
        t.ffmpeg("-f", "lavfi", "-i", f"color=red:size={size}:duration=1:rate=1", "-frames:v", "1", f"out/{clip}.jpg")
    write_index(t)
    with opened(t) as page:
        page.window(width, 844 if width == 390 else 900, mobile=width == 390)
        page.reload()
        page.wait("pictures", "return [...document.querySelectorAll('.card img')].filter(i => i.naturalWidth > 0).length > 2")
        boxes = page.run("return [...document.querySelectorAll('.card .images')].map(e => { const b = e.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; })"
                         ".filter(([, top]) => top < innerHeight)")  # others are not laid out
        whole = page.run("return document.getElementById('days').clientWidth")
        rows = {}
        for left, top, wide, high in boxes:
            rows.setdefault(round(top), []).append((left, wide, high))
        *full, last = rows.values()
        for row in full:
            heights = [high for *_, high in row]
            check(max(heights) - min(heights) < 1, f"heights in a row: {row}")
            used = sum(wide for _, wide, _ in row) + 14 * len(row)
            check(used > 0.95 * whole, f"a row of {used} in {whole} pixels")
        ratios = sorted({round(wide / high, 1) for _, _, wide, high in boxes})
        check(all(ratio in (1.3, 1.4, 1.7, 1.8) for ratio in ratios), f"pictures of the shapes {ratios}")
        cut = "return [...document.querySelectorAll('.first > *')].filter(e => e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 0).map(e => e.textContent)"
        page.media("print")
        check(page.run(cut) == [], f"on paper this is cut off: {page.run(cut)}")
        page.media()
        if width == 390:
            check(boxes[0][1] < 130, f"the first card is at {boxes[0][1]}")


def gallery_page(t):
    """A clip of the archive whose card has a picture of each of its events."""
    t.scene("walkers", "walkers.y4m", "--size", "192x144", "--frames", "300", "--seed", "5")
    t.ffmpeg("-i", "walkers.y4m", "-c:v", "mpeg4", "-q:v", "3", "clips/gate/20261120T080000.avi")
    t.archive("clips", "-o", "out", "--size", "320x200", "--backend", "software").expect(0)


def test_index_card_shows_each_event(t):
    """The pointer's place, keys and swipes choose the event; it plays, and the card leads to it."""
    gallery_page(t)
    with opened(t) as page:
        page.wait("the card", "return document.querySelector('.card .images img')?.naturalWidth > 0")
        check(page.text_of(".card .of") == "" and page.count(".card .now") == 0,
              "a card shows an event before one asks for it")
        count = page.count(".card .ticks i")
        check(count >= 3, f"the clip has {count} events")
        shown = "return document.querySelector('.card .of').textContent.startsWith(arguments[0])"

        def hover(share):
            left, top, right, bottom = page.box(".card")
            page.move(left + share * (right - left), (top + bottom) / 2)

        tiles = "return [...document.querySelectorAll('.card .tile')].map(e => { const b = e.getBoundingClientRect(); return [b.x, b.y, b.width, b.height].join(); })"
        hrefs = []
        for place in range(count):
            hover((place + 0.5) / count)
            page.wait(f"event {place + 1}", shown.replace("arguments[0]", f"'{place + 1} of {count} · 08:00:'"))
            check(page.run("return [...document.querySelectorAll('.card .ticks i')].findIndex(i => i.className === 'now')") == place, "another mark")
            check(page.count(".card .tile .spot") == 1, "nothing shows where it is")
            page.wait("its pictures", "return [...document.querySelectorAll('.card .tile img')].every(i => i.naturalWidth > 0)")
            check(len(page.run(tiles)) == 2 and len(set(page.run(tiles))) == 1, f"the card is torn: {page.run(tiles)}")
            hrefs.append(page.run("return document.querySelector('.card').hash"))
        # The numbers of the events of the only clip, in the order of the index.
        [day] = [path.read_text() for path in t.path("out").glob("index.????-??-??.js")]
        [(_, rows, *_)] = json.loads(day[day.index(",") + 1:day.rindex(")")])
        check(hrefs == [f"#event={row[1]}" for row in rows], f"{hrefs} for {rows}")
        # It plays: its pictures follow one another, and begin again.
        looks = "const i = document.querySelector('.card .tile:not(.single) img'); return [i.style.left, i.style.top].join()"
        first = page.run(looks)
        page.wait("it plays", f"return (() => {{ {looks} }})() !== '{first}'")
        page.wait("it begins again", f"return (() => {{ {looks} }})() === '{first}'")
        # Away from it the clip is shown again.
        page.move(2, 2)
        page.wait("the clip", "return document.querySelector('.card .of').textContent === ''")
        check(page.count(".card .tile") == 1 and page.run("return document.querySelector('.card').hash") == "", "the event stays")
        # Keys.
        page.run("document.querySelector('#order').focus()")
        while not page.run("return document.activeElement.matches('.card')"):
            page.key("\ue004")
        page.wait("the first event", f"return document.querySelector('.card .of').textContent.startsWith('1 of {count}')")
        page.key("\ue012")
        check(page.text_of(".card .of").startswith(f"1 of {count}"), "before the first there is another one")
        check(len(page.run(tiles)) == 2 and len(set(page.run(tiles))) == 1, f"the card is torn: {page.run(tiles)}")
        page.key("\ue014")
        check(page.text_of(".card .of").startswith(f"2 of {count}"), page.text_of(".card .of"))
        described = page.run("return document.querySelector('.card').getAttribute('aria-description')")
        check(described.startswith(f"2 of {count} · 08:00:"), f"a screen reader is told: {described}")
        page.key("\ue007")
        page.wait("the clip's page", "return document.documentElement.dataset.ready !== undefined && vvr.state.chosen !== null")
        check(page.run("return location.hash") == hrefs[1], "another event than that on the card")
        check(page.complaints() == [], str(page.complaints()))


def test_index_card_turns_by_swipes(t):
    gallery_page(t)
    with opened(t) as page:
        page.window(390, 844, mobile=True)
        page.wait("the card", "return innerWidth === 390 && document.querySelector('.card .images img')?.naturalWidth > 0")
        count = page.count(".card .ticks i")
        page.run("document.querySelector('.card').scrollIntoView({block: 'center'})")

        def swipe(begin, end):
            left, top, right, bottom = page.box(".card .images")
            middle = (top + bottom) / 2
            page.touch("touchStart", (left + begin * (right - left), middle))
            for k in range(1, 6):
                page.touch("touchMove", (left + (begin + (end - begin) * k / 5) * (right - left), middle))
            page.touch("touchEnd")

        for begin, end, wanted in ((0.8, 0.3, 2), (0.8, 0.3, 3), (0.2, 0.7, 2)):
            swipe(begin, end)
            page.wait(f"event {wanted}", f"return document.querySelector('.card .of').textContent.startsWith('{wanted} of {count}')")
        check(page.run("return document.title") == "Video archive", "a swipe opens the clip")
        wanted = page.run("return document.querySelector('.card').hash")
        left, top, right, bottom = page.box(".card .images")
        for _ in range(10):  # a tap just after a swipe only ends its movement, in every page
            time.sleep(0.5)
            if page.run("return document.title") != "Video archive":
                break
            page.touch("touchStart", ((left + right) / 2, (top + bottom) / 2))
            page.touch("touchEnd")
        page.wait("a tap opens it", "return document.documentElement.dataset.ready !== undefined && vvr.state.chosen !== null")
        check(page.run("return location.hash") == wanted and wanted.startswith("#event="), f"it leads to {page.run('return location.hash')}")


def test_index_answers_a_hundred_thousand_events_at_once(t):
    chance = random.Random(5)
    known(t, "gate/a.avi", NOW, events=1, found=[["moved", 1, 0, 0, 1, 1]])
    write_index(t)

    def wander():
        times = sorted(chance.sample(range(200), chance.randint(1, 6)))
        return [value for at in times for value in (at, chance.randint(0, 1000), chance.randint(0, 1000))]

    events = [["moved", number, 0, *wander()] for number in range(100_000)]
    name = next(t.path("out").glob("index.????-??-??.js"))
    url = re.search(r'\[\["([^"]*)"', name.read_text())[1]
    day = name.name[6:16]
    name.write_text(f'vvrDay("{day}",{json.dumps([[url, events]], separators=(",", ":"))});\n')
    with opened(t) as page:
        page.press("#views [value=scene]")
        page.wait("all events", "return document.getElementById('foundheading').textContent === '100,000 events'", 60)
        took, bare = [], []
        for tool, begin, end in (("#askbox", (0.3, 0.3), (0.6, 0.6)), ("#askline", (0.1, 0.9), (0.9, 0.2)),
                                 ("#askbox", (0.1, 0.1), (0.2, 0.2)), ("#askbox", (0.2, 0.4), (0.6, 0.9))):
            page.press(tool)
            page.run("set({answer: null})")
            page.drag("#stage", begin, end)
            page.wait("an answer", "return answer !== null")
            took.append(page.run("return answer.took"))
            bare.append(page.run("""const begin = performance.now(); let sum = 0;
                for (const {way} of answer.events) for (let k = 0; k < way.length; ++k) sum += Math.max(way[k], sum % 7);
                return performance.now() - begin + 0 * sum;"""))
            found = page.run("return answer.found.length")
            check(1000 < found < 100_000, f"{found} events")
        print(f"{[round(ms, 1) for ms in took]} ms; to read all points: {[round(ms, 1) for ms in bare]} ms")
        check(min(took) < 3 * min(bare), f"an answer takes {took} ms, to read all points {bare} ms")
