"""The index answers "who crossed this line, which way, show me", and leads from hit to hit, in a real browser."""

import random
import time

import pytest
from harness import check
from test_archive_index import NOW, HOUR, known, opened, write_index

pytestmark = pytest.mark.browser

DAYS = ("16", "17", "18", "19", "20")  # of November 2026, Monday to Friday
READY = "return document.documentElement.dataset.ready !== undefined && document.getElementById('source').textContent !== ''"
# Somebody comes from the right, somebody else from the left.
GATE = {"17T201500": "left", "17T214000": "right", "17T193000": "left", "18T203000": "left", "19T080000": "right", "19T090000": "left",
        "20T180000": "right"} | {f"{day}T120000": "left" for day in DAYS}


def three_cameras(t):
    """An archive of three cameras over five days; in each clip of the gate one crosses the middle."""
    t.zone("UTC")
    t.make_folders("three cameras", "clips", "out", how=lambda: draw_three_cameras(t))


def draw_three_cameras(t):
    t.scene("two_walkers_cross", "walker.y4m", "--size", "192x144", "--frames", "60")
    film = ("-c:v", "libx264", "-pix_fmt", "yuv420p", "-g", "10")
    t.ffmpeg("-i", "walker.y4m", *film, "left.mp4")
    t.ffmpeg("-i", "walker.y4m", "-vf", "hflip", *film, "right.mp4")
    clips = {f"gate/202611{when}": way for when, way in GATE.items()}
    clips |= {f"{camera}/202611{day}T204500": "left" for camera in ("hall", "yard") for day in DAYS}
    for name, way in clips.items():
        t.copy(f"{way}.mp4", f"clips/{name}.mp4")
    t.archive("clips", "-o", "out", "--size", "320x200", "--backend", "software").expect(0, f"{len(clips)} clips drawn")


def keys(page, *names):
    from selenium.webdriver.common.keys import Keys
    page.key(*(getattr(Keys, name, name) for name in names))


def is_on(page, title):
    page.wait(title, f"return document.title === '{title}'")
    page.wait("the page is ready", READY)


def hits(page, count):
    page.wait(f"{count} hits", f"return document.querySelectorAll('#found a').length === {count} && answer !== null")
    return page.texts("#found a .answer")


def draw_on_gate(page):
    page.wait("the scenes", "return [...document.querySelectorAll('.chooser img')].filter(i => i.naturalWidth > 0).length === 3")
    check(page.texts(".chooser button") == ["gate", "hall", "yard"], str(page.texts(".chooser button")))
    page.drag(".chooser svg", (0.5, 0.03), (0.5, 0.97))
    page.wait("the camera is chosen", "return camera !== null && place !== null")


def expect_unseen(page, count):
    page.press("#views [value=clips]")
    page.run("document.querySelector('[value=unseen]').click()")
    page.wait("the filter", "return document.getElementById('count').textContent !== ''")
    check(page.text("count") == f"{count} of {len(GATE) + 10} clips", page.text("count"))


def test_index_who_crossed_this_line_on_tuesday_after_eight(t):
    three_cameras(t)
    with opened(t) as page:
        # Four steps: a tool, a line on one of the scenes, when, and the first hit.
        page.press("#askline")
        draw_on_gate(page)
        page.driver.find_element("id", "text").send_keys("tuesday after 20:00")
        told = hits(page, 2)
        check(told[0].startswith("crossed → 21:40:0") and told[1].startswith("crossed ← 20:15:0"), f"{told}")
        check(page.texts("#ways button") == ["Both ways 2", "← 1", "→ 1"], str(page.texts("#ways button")))
        page.wait("pictures", "return [...document.querySelectorAll('#found .tile img')].filter(i => i.naturalWidth > 0).length === 2")
        check(page.count("#found .tile line") == 2 and page.count("#found .tile .spot") == 2, "no line, or nobody, is in the pictures")
        check(page.texts("#found .of") == ["", ""], f"the pictures are of other moments: {page.texts('#found .of')}")
        page.press("#found a")
        is_on(page, "gate · Tue 17 Nov 2026, 21:40")
        page.wait("it plays", "return vvr.isPlaying() || now > 20")
        check(page.run("return [asked.kind, asked.from[0]]")[0] == "line" and page.text("heading").startswith("1 "), "no line is drawn")
        check(page.text("nth") == "1 of 2", page.text("nth"))
        # A key for each hit; at the end it says so.
        keys(page, "n")
        is_on(page, "gate · Tue 17 Nov 2026, 20:15")
        check(page.text("nth") == "2 of 2", page.text("nth"))
        keys(page, "n")
        page.wait("the end", "return document.getElementById('told').textContent === 'This is the last hit.'")
        is_on(page, "gate · Tue 17 Nov 2026, 20:15")
        page.driver.refresh()
        page.wait("the page is ready", READY)
        check(page.text("nth") == "2 of 2" and page.run("return asked !== null"), "a reload forgets what was searched for")
        keys(page, "b")
        is_on(page, "gate · Tue 17 Nov 2026, 21:40")
        page.press("#toindex")
        hits(page, 2)
        page.wait("the hit has the focus", "return document.activeElement === document.querySelector('#found a')")
        page.driver.refresh()
        hits(page, 2)
        # Those that were passed have been seen too.
        page.press("#clear")
        expect_unseen(page, len(GATE) + 8)
        check(page.complaints() == [], str(page.complaints()))


def test_index_page_and_address_have_the_same_line(t):
    """However a line is drawn: its hits are those of its address, and each one's page shows the event that was found."""
    chance = random.Random(3)
    three_cameras(t)
    with opened(t) as page:
        page.window(1213, 907)
        page.press("#askline")
        draw_on_gate(page)
        page.wait("hits", f"return answer !== null && document.querySelectorAll('#found a').length === {len(GATE)}")
        for _ in range(6):
            across = [0.5 + chance.uniform(-0.4, 0.4) for _ in range(2)]
            page.run("set({answer: null})")
            page.drag("#drawing", (across[0], 0.04), (across[1], 0.96))
            page.wait("an answer", "return answer !== null")
            check(page.run("return [...place.from, ...place.to].every(Number.isInteger)"), f"{page.run('return place')}")
            told = [page.texts("#found a"), page.run("return [place, location.hash]")]
            page.driver.refresh()
            page.wait("an answer", "return window.vvr && vvr.state.answer !== null && document.getElementById('foundheading').textContent.includes(' of ')")
            check([page.texts("#found a"), page.run("return [place, location.hash]")] == told, "a reload answers something else")
            page.press("#found a")
            page.wait("the page is ready", READY)
            check(page.text("heading") == "1 event", f"the page of a hit says {page.text('heading')}")
            answer = page.text_of("#events .row small")
            check(answer.split(" ")[0] in ("crossed", "touched"), answer)
            page.driver.back()
            page.wait("an answer", "return window.vvr && vvr.state.answer !== null && document.querySelectorAll('#found a').length > 0")
            page.press("#askline")


def test_index_searches_by_keyboard(t):
    three_cameras(t)
    with opened(t) as page:
        page.run("document.getElementById('askline').focus()")
        keys(page, "ENTER")
        page.wait("a camera to choose", "return document.activeElement.textContent === 'gate'")
        keys(page, "ENTER")
        page.wait("an end of a line", "return document.activeElement.dataset.end === 'from'")
        keys(page, *["ARROW_UP"] * 18, "TAB")
        page.wait("the other end", "return document.activeElement.dataset.end === 'to'")
        keys(page, *["ARROW_DOWN"] * 18, "ENTER")
        told = hits(page, len(GATE))
        check(page.run("return [place.from, place.to]") == [[500, 20], [500, 980]], str(page.run("return place")))
        check(sum("←" in text for text in told) == list(GATE.values()).count("left"), f"{told}")
        # One direction alone; a kind; from hit to hit.
        page.press("#ways button:last-child")
        check(all("→" in text for text in hits(page, list(GATE.values()).count("right"))), "another direction")
        check("way=-1" in page.run("return location.hash"), page.run("return location.hash"))
        page.run("document.querySelector('#found a').focus()")
        keys(page, "ARROW_RIGHT", "ENTER")
        is_on(page, "gate · Thu 19 Nov 2026, 08:00")
        page.wait("it plays", "return vvr.isPlaying() || now > 20")


def test_index_plays_all_hits(t):
    """12 events with one key."""
    three_cameras(t)
    with opened(t) as page:
        page.run("location.hash = '#view=scene&camera=gate&order=oldest'")
        hits(page, 12)
        page.run("document.getElementById('playall').focus()")
        keys(page, "ENTER")
        shown = []
        end = time.monotonic() + 120
        while not shown or "last hit" not in shown[-1][1]:
            check(time.monotonic() < end, f"{shown}")
            now = page.run("return [document.getElementById('nth')?.textContent ?? '', document.getElementById('told')?.textContent ?? '',"
                           "document.title]")
            if now[0] and now not in shown:
                shown.append(now)
            time.sleep(0.05)
        check([nth for nth, told, _ in shown if not told] == [f"{k} of 12" for k in range(1, 13)], f"{shown}")
        check(shown[0][2] == "gate · Mon 16 Nov 2026, 12:00" and shown[-1][2] == "gate · Fri 20 Nov 2026, 18:00", f"{shown}")


def test_index_leads_within_what_is_asked(t):
    three_cameras(t)
    with opened(t) as page:
        # "Not seen yet" stays the filter, although the clip itself is seen now.
        page.run("location.hash = '#camera=gate&kind=unseen&text=wednesday'")
        page.wait("two", "return document.querySelectorAll('.card').length === 2")
        page.run("document.querySelector('a.card').click()")
        is_on(page, "gate · Wed 18 Nov 2026, 20:30")
        page.press("#earlier")
        is_on(page, "gate · Wed 18 Nov 2026, 12:00")
        keys(page, "b")
        page.wait("the end", "return document.getElementById('told').textContent === 'This is the first clip that was asked for.'")
        is_on(page, "gate · Wed 18 Nov 2026, 12:00")
        page.press("#toindex")
        page.wait("the filter", "return kind === 'unseen' && text === 'wednesday'")
        page.press("#clear")
        expect_unseen(page, len(GATE) + 8)


def test_index_filters_events_by_kind_and_time(t):
    passed = [["moved", number, 0, 10 * number, 100, 500, 10 * number + 9, 900, 500] for number in range(1, 400)]
    known(t, "gate/a.avi", NOW, events=400, found=[["left", 400, 255, 10, 500, 500, 270, 500, 500], *passed])
    known(t, "gate/b.avi", NOW - 12 * HOUR, events=1, found=[["stood", 1, 1850, 0, 100, 100, 3000, 200, 100]])
    known(t, "hall/c.avi", NOW, events=1, found=[["taken", 1, 0, 5, 1, 1, 9, 2, 2]])
    write_index(t)
    with opened(t) as page:
        marked = "return getComputedStyle(document.querySelector(`#cameras li:nth-child(${arguments[0]}) button`)).backgroundColor"
        check(page.run(marked, 1) != page.run(marked, 2), "the chosen camera is not marked")
        page.run("[...document.querySelectorAll('#cameras button')].find(b => b.textContent.startsWith('gate')).click()")
        check(page.run(marked, 1) != page.run(marked, 2), "the chosen camera is not marked")
        page.press("#views [value=scene]")
        page.wait("all", "return document.getElementById('foundheading').textContent === '401 events'")
        check(page.count("#found a") == 300, "the list has no limit")
        page.run("dispatchEvent(new Event('beforeprint'))")
        check(page.count("#found a") == 401, "not all is printed")
        page.run("dispatchEvent(new Event('afterprint'))")
        check(page.count("#found a") == 300, "the list has no limit")
        # The night, and back by the address.
        page.set("time", "2")
        page.wait("the night", "return document.getElementById('foundheading').textContent === '1 event'")
        address = page.run("return location.href")
        check("since=20%3A00" in address and "until=06%3A00" in address, address)
        page.press("#clear")
        page.wait("all", "return hits().length === 402")
        page.driver.get("about:blank")
        page.driver.get(address)
        page.wait("the night", "return document.getElementById('foundheading').textContent === '1 event'")
        check(page.text("count") == "20:00 to 06:00 of the next day", page.text("count"))


def test_index_fits_small_windows_and_fingers(t):
    for number in range(12):
        known(t, f"{'gate' if number % 2 else 'hall'}/{number}.avi", NOW - number * HOUR, events=number)
    write_index(t)
    with opened(t, cards=12) as page:
        for width, height in ((390, 844), (320, 256), (640, 360)):
            page.window(width, height, mobile=width == 390)
            page.wait("it is narrow", f"return innerWidth === {width}")
            wide = page.run("return [document.documentElement.scrollWidth, innerWidth]")
            check(wide[0] <= wide[1], f"{width} px: the page is {wide[0]} px wide")
        page.window(390, 844, mobile=True)
        check(page.box(".card")[1] < 400, f"the first clip is at {page.box('.card')[1]}")
        page.set("camera", "0")
        page.wait("a camera", "return document.querySelectorAll('.card').length === 6")
        page.press("#filtering")
        faint, count = page.faint()
        check(faint == [] and count > 20, f"{faint}")


def test_index_is_seen_in_forced_colours(t):
    known(t, "gate/a.avi", NOW, events=3)
    write_index(t)
    with opened(t) as page:
        page.cdp("Emulation.setEmulatedMedia", media="", features=[{"name": "forced-colors", "value": "active"}])
        page.press("#views [value=days]")
        colour = "return getComputedStyle(document.querySelector(arguments[0])).backgroundColor"
        check(page.run(colour, "td .busy") != page.run(colour, "td button"), "the hours vanish")
        page.press("#cameras button")
        count, ground = page.run("""const b = document.querySelector('#cameras [aria-pressed=true]');
            return [getComputedStyle(b.querySelector('i')).color, getComputedStyle(b).color];""")
        check(count == ground, f"the count of the chosen camera is {count}, its name {ground}")
        check(page.run(colour, "#views [aria-pressed=true]") != page.run(colour, "#views [aria-pressed=false]"), "what is chosen can't be seen")
