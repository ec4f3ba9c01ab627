"""Watching with a page: by touch, by keys, as large as one wants; what is chosen is to be seen; marks are kept."""

import json
import time

import pytest
from browser import Page, Served
from harness import check
from test_page import bag
from test_page_player import crowd, with_events

pytestmark = pytest.mark.browser


def points_of(page, selector):
    return page.run("return document.querySelector(arguments[0])?.getAttribute('points')", selector)


def test_page_plays_at_a_tap(t):
    """The page scrolls to the player, and the tap's own click must not land there."""
    with Page(t, bag(t)) as page:
        page.window(390, 844, mobile=True)
        page.wait("the window", "return innerWidth === 390")
        page.press("#tabvolume")
        page.wait("the picture", "return stageWidth > 200")
        for number in range(3):
            page.run("setPlaying(false); choose(null); scrollTo(0, 0)")
            left, top, right, bottom = page.run("""const box = document.querySelectorAll('#letters .portrait')[arguments[0]].getBoundingClientRect();
                return [box.left, box.top, box.right, box.bottom];""", number)
            page.touch("touchStart", ((left + right) / 2, (top + bottom) / 2))
            page.touch("touchEnd")
            page.wait("it plays", "return chosen !== null && isPlaying() && !video.paused && now > events[chosen].first")
            check(page.run("return document.getElementById('play').ariaLabel") == "Pause", "the button says something else")
        # A tap on nothing shows all again, and fingers have room.
        page.run("setPlaying(false); scrollTo(0, 0)")
        left, top, right, _ = page.box("#view")
        page.touch("touchStart", (right - 12, top + 100))
        page.touch("touchEnd")
        page.wait("nothing is chosen", "return chosen === null", 5)
        page.run("askPlace({kind: 'box', from: [0, 0], to: [1, 1]}); zoomStrip(0.3, 1)")
        for menu in ("help", "share", "filters"):
            page.run(f"for (const open of document.querySelectorAll('details[open]')) open.open = false; document.getElementById('{menu}').open = true")
            small = page.run("""return [...document.querySelectorAll('button, select, summary, .menu > div a, .menu > div label')]
                .filter(e => e.checkVisibility()).map(e => [e.id || e.textContent, e.getBoundingClientRect().height])
                .filter(([, high]) => high < 44)""")
            check(small == [], f"too small for a finger: {small}")


def test_page_always_lights_what_is_chosen(t):
    with Page(t, bag(t)) as page:
        for place in range(3):
            page.run("choose(arguments[0]); show(events[arguments[0]].first + 3, false)", place)
            lit = page.run("""const lit = [...document.querySelectorAll('#lit .trail')];
                const pale = (root, is) => [...document.querySelectorAll(root + ' [data-event]')].filter(e => (Number(e.dataset.event) === chosen) === is && e.classList.contains('pale') === is).length;
                return [lit.map(e => Number(e.dataset.event)), lit[0].getBoundingClientRect().width, pale('#letters', true), pale('#lines', true),
                    [...document.querySelectorAll('#letters [data-event], #lines [data-event], #bars i')].filter(e => Number(e.dataset.event) !== chosen && !e.classList.contains('pale')).length];""")
            check(lit[0] == [place] and lit[1] > 3, f"lit: {lit}")
            check(lit[2] == lit[3] == 0, f"its own parts are pale: {lit}")
            check(lit[4] == 0, f"{lit[4]} parts of others are not pale")
        # What is chosen leaves when it is not found any more.
        page.set("least", "60")
        check(page.run("return [chosen, document.querySelectorAll('#lit .trail').length]") == [None, 0], "it stays chosen")
        check(page.text("events").startswith("No matching events"), page.text("events"))
        page.press("#events li button")
        check(page.text("heading") == "3 events", page.text("heading"))


def test_page_shows_now_on_the_arc(t):
    with Page(t, bag(t)) as page:
        check(page.count("#lit .rib") == 0, "now, before anything was asked")
        page.run("show(100, false)")
        first = points_of(page, "#lit .rib")
        page.key(".")
        check(points_of(page, "#lit .rib") != first, "the rib does not move by a frame")
        page.key("k")
        page.wait("it plays", "return now > 110")
        second = points_of(page, "#lit .rib")
        page.wait("it moves on", "return now > 130")
        check(points_of(page, "#lit .rib") != second, "the rib stands while it plays")
        page.run("setPlaying(false); choose(0); show(events[0].first + 5, false)")
        # The dot on the trail is where the object is, in the event's colour.
        colours = page.run("return ['#lit .here', '#ring', '#lit .trail'].map(s => getComputedStyle(document.querySelector(s)).getPropertyValue('--event').trim())")
        check(len(set(colours)) == 1 and colours[0].startswith("#"), f"{colours}")


def test_page_plays_the_events_without_the_rest(t):
    bag(t)
    firsts = (20, 110, 200, 310)
    with Page(t, with_events(t, "four.html", [[[first, 0.1, 0.5], [first + 30, 0.9, 0.5]] for first in firsts])) as page:
        spans = page.run("return events.map(e => [e.first, e.last])")
        page.key("e")
        seen = []
        end = time.monotonic() + 30
        while page.run("return touring") and time.monotonic() < end:
            seen.append(page.run("return [now, chosen]"))
        check(not page.run("return touring || isPlaying()"), "it does not end")
        chosen = {place for _, place in seen if place is not None}
        check(chosen == {0, 1, 2, 3}, f"{chosen} were played")
        between = [now for now, _ in seen if not any(first - 6 <= now <= last + 12 for first, last in spans)]
        check(len(between) <= len(seen) / 10, f"what is between them was played: {between}")
        check(page.run("return now") == spans[-1][1], "it stops elsewhere")
        # An arrow goes on playing.
        page.run("choose(0); show(events[0].first, true)")
        page.key("\ue014")
        page.wait("the next one plays", "return chosen === 1 && isPlaying()", 5)


def test_page_goes_to_a_typed_time(t):
    with Page(t, bag(t, "--start-time", "2026-11-21 07:12:00")) as page:
        for text, frame in (("0:08", 200), ("07:12:04", 100), ("6", 150)):
            page.key("g")
            check(page.run("return document.activeElement.id") == "jump", "no field")
            page.key(*text, "\ue007")
            check(page.run("return now") == frame and page.hidden("jump"), f"{text} goes to {page.run('return now')}")
        page.key("g", *"25:99", "\ue007")
        check("is no time of this clip" in page.text("told") and page.run("return now") == 150, page.text("told"))
        page.key("\ue00c")
        for key, speed in ((">", 2), (">", 4), ("<", 2)):
            page.key(key)
            check(page.run("return [speed, video.playbackRate]") == [speed, speed], key)


def test_page_player_is_as_large_as_one_wants(t):
    with Page(t, bag(t)) as page:
        wide = lambda selector: page.run("return document.querySelector(arguments[0]).getBoundingClientRect().width", selector)
        before = wide("#screen")
        check(abs(wide("#player") - wide("#view")) < 2, f"halves of {wide('#player')} and {wide('#view')}")
        page.drag("#divider", (0.5, 0.5), (15, 0.5), (25, 0.5))
        check(wide("#player") > wide("#view") * 1.5 and wide("#screen") > before * 1.1, f"dragged from {before} to {wide('#screen')}")
        page.run("document.getElementById('divider').focus()")
        dragged = page.run("return filmShare")
        page.key("\ue012")
        check(abs(page.run("return filmShare") - dragged + 0.03) < 0.002, "the border has no keys")
        page.reload()
        check(abs(page.run("return filmShare") - dragged + 0.03) < 0.002, "the width is forgotten")
        page.run("localStorage.removeItem('vvr-film'); set({filmShare: 0.5}); document.activeElement.blur()")
        page.key("x")
        check(wide("#screen") > 1.1 * before and wide("#view") < 500, f"the film is not larger: {wide('#screen')}, {wide('#view')}")
        page.key("x")
        check(wide("#view") > 900, f"the volume is not larger: {wide('#view')}")
        page.key("x")
        check(abs(wide("#screen") - before) < 2, "not as it was")
        # The wheel zooms into the film, about what is under it.
        x, y = page.run("""const b = document.getElementById('screen').getBoundingClientRect();
            document.getElementById('screen').dispatchEvent(new WheelEvent('wheel', {deltaY: -600, clientX: b.left + 0.25 * b.width, clientY: b.top + 0.5 * b.height, cancelable: true}));
            const r = document.getElementById('reel').getBoundingClientRect();
            return [(b.left + 0.25 * b.width - r.left) / r.width, (b.top + 0.5 * b.height - r.top) / r.height];""")
        check(page.run("return filmScale") > 2 and abs(x - 0.25) < 0.01 and abs(y - 0.5) < 0.01, f"zoomed about {x}, {y}")


@pytest.mark.parametrize("has_full_screen", [True, False])
def test_page_full_screen_has_film_strip_and_buttons_that_can_be_read(t, has_full_screen):
    with Page(t, bag(t)) as page:
        if not has_full_screen:  # as on a phone
            page.run("document.documentElement.requestFullscreen = undefined")
        page.run("choose(1); show(events[1].first, false); zoomStrip(0.5, 1)")
        for scheme in ("light", "dark"):
            page.media(scheme=scheme)
            page.key("f")
            page.wait("full screen", f"return fills && (document.fullscreenElement !== null) === {str(has_full_screen).lower()}", 5)
            faint, count = page.faint()
            check(faint == [] and count > 5, f"{scheme}: {faint} of {count}")
            signs = page.run("""return [...document.querySelectorAll('#transport button')].filter(e => e.checkVisibility())
                .map(e => [getComputedStyle(e).color, getComputedStyle(e).backgroundColor])""")
            check(len(signs) == 8 and all(sign != ground for sign, ground in signs), f"{scheme}: blank buttons: {signs}")
            shown = page.run("return ['screen', 'strip', 'stripwhole', 'larger', 'view', 'side'].filter(id => document.getElementById(id).checkVisibility())")
            check(shown == ["screen", "strip", "stripwhole"], f"{shown}")
            width, height = page.run("return [innerWidth, innerHeight]")
            for part in ("#screen", "#transport", "#strip"):
                left, top, right, bottom = page.box(part)
                check(0 <= left < right <= width and 0 <= top < bottom <= height, f"{part} is not within the window: {page.box(part)}")
            check(page.box("#transport")[3] <= page.box("#strip")[1], "the strip covers the buttons")
            left, top, right, bottom = page.box("#screen")
            check(abs((right - left) / (bottom - top) - page.run("return data.size[0] / data.size[1]")) < 0.01, "the film is stretched")
            names = page.run("return ['previous', 'next'].map(id => [document.getElementById(id).ariaLabel, document.querySelector(`#${id} .number`).textContent])")
            check(names == [["Previous event: 1", "1"], ["Next event: 3", "3"]], f"{names}")
            page.key("x")
            check(page.run("return filmShare") == 0.5, "a key moves what nobody sees")
            page.key("f")
            page.wait("no full screen", "return !fills && document.fullscreenElement === null", 5)
            check(page.run("return document.getElementById('view').clientWidth > 300 && Number.isFinite(middle[0] + stageWidth)"), "no picture after it")
        page.window(390, 844)  # upright
        page.key("f")
        page.wait("full screen", "return fills && innerWidth === 390")
        left, top, right, bottom = page.box("#screen")
        check(abs((right - left) / (bottom - top) - page.run("return data.size[0] / data.size[1]")) < 0.01, "the film is stretched")
        page.key("f", "\ue014")
        check(page.run("return [chosen, document.getElementById('next').ariaLabel]") == [2, "Last event again: 3"], "the last leads on")


def test_page_lets_a_finger_choose_among_what_is_near(t):
    with Page(t, bag(t)) as page:
        page.window(390, 844, mobile=True)
        page.wait("the window", "return innerWidth === 390")
        page.press("#tabvolume")
        check(page.texts("#legend span") == ["moved", "stayed or left behind", "other change"], f"{page.texts('#legend span')}")
        left, top, right, bottom = page.box("#legend")
        zoom = page.box(".zoom")
        check((right <= zoom[0] or bottom <= zoom[1]) and top > page.box("#map")[1] and bottom < page.box("#view")[3], f"the legend at {page.box('#legend')}, buttons at {zoom}")
        # Maps of two events: 1 and 2 are at two columns with 20 pixels of the screen between them, and what is none is all between.
        page.run("""const {width, height} = pixels;
            const gap = 20 * width / stageWidth;
            const at = (k, column) => Math.abs(k % width - column) < 1;
            const objects = pixels.objects.map((_, k) => at(k, width / 2 - gap / 2) ? 0 : at(k, width / 2 + gap / 2) ? 1 : -1);
            set({pixels: {...pixels, objects, frames: objects.map((_, k) => Math.abs(k % width - width / 2) < gap ? 50 + objects[k] : -1)}});
            for (const e of document.querySelectorAll('#letters > *')) e.remove();""")

        def tap(by):
            page.run("setPlaying(false); choose(null); scrollTo(0, 0)")
            x, y = page.run("const b = picture.getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2]")
            page.touch("touchStart", (x + by, y))
            page.touch("touchEnd")
            time.sleep(0.3)
            return page.run("return [chosen, which === null ? null : which.candidates.map(({event}) => event)]")

        check(tap(-18) == [0, None], "the nearest is another")
        check(tap(18) == [1, None], "the nearest is another")
        check(page.run("return isPlaying() && now >= 50"), "it does not play")
        check(tap(1) == [None, [1, 0]], "it is not asked which")
        page.wait("portraits", "return [...document.querySelectorAll('#which img')].filter(i => i.naturalWidth > 0).length === 2")
        left, top, right, bottom = page.box("#which")
        check(0 <= left < right <= 390 and 0 <= top < bottom <= 844, f"outside: {page.box('#which')}")
        page.press("#which button:nth-child(2)")
        page.wait("the other one plays", "return chosen === 0 && which === null && isPlaying()")
        check(tap(-1) == [None, [0, 1]], "it is not asked which")
        page.key("\ue00c")
        check(page.run("return [which, chosen]") == [None, None], "Escape does not end it")
        check(tap(60) == [None, None], "there is nothing")
        # A mouse means the pixel that it is on.
        x, y = page.run("const b = picture.getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2]")
        page.move(x, y)
        page.wait("what is there", "return pointed !== null")
        check(page.run("return lightened") is None, "a mouse is a finger")


def point_at(page, number):
    """The pointer on an event of the list, whose actions come then."""
    left, top, right, bottom = page.box(f"#events li:nth-child({number}) .words b")
    page.move((left + right) / 2, (top + bottom) / 2)


def test_page_keeps_stars_notes_and_what_is_nothing(t):
    bag(t)
    with Served(t.folder) as served, Page(t, served.url("out.html")) as page:
        acts = "#events li:nth-child(2) .acts button:nth-child(%d)"
        check(page.run("return getComputedStyle(document.querySelector(arguments[0])).visibility", acts % 1) == "hidden", "actions of all events are shown")
        point_at(page, 2)
        page.press(acts % 1)
        page.press(acts % 2)
        page.key(*"a blue bag", "\ue007")
        check("a blue bag" in page.texts("#events .noted")[0], "no note")
        point_at(page, 3)
        page.press("#events li:nth-child(3) .acts button:nth-child(3)")
        check(page.text("heading") == "2 of 3 events, 1 hidden", page.text("heading"))
        check("is hidden" in page.text("told") and page.texts("#told button") == ["Undo", "Copy --mask"], page.text("told"))
        page.reload()
        check(page.text("heading") == "2 of 3 events, 1 hidden" and len(page.texts("#events .noted")) == 1, "it is forgotten")
        page.open_menu("share")
        rows = json.loads(page.saved(t, "#savenotes", "*.notes.json").read_text())["events"]
        check([(row["event"], row["star"], row["nothing"], row["note"]) for row in rows] == [(2, True, False, "a blue bag"), (3, False, True, "")], f"{rows}")
        page.open_menu("")
        page.run("set({showsHidden: true})")
        point_at(page, 3)
        page.press("#events li:nth-child(3) .acts button:nth-child(3)")
        check(page.text("heading") == "3 events", page.text("heading"))


def test_page_has_a_large_film_and_events_on_a_small_screen(t):
    bag(t)
    with Page(t, crowd(t, 40)) as page:
        page.window(1280, 720)
        page.wait("the window", "return innerWidth === 1280 && innerHeight === 720")
        left, top, right, bottom = page.box("#screen")
        share = (right - left) * (bottom - top) / (1280 * 720)
        check(share > 0.13, f"the film has {100 * share:.0f} % of the window")
        _, top, _, bottom = page.box("#events")
        check(bottom - top >= 110, f"the list has {bottom - top} of 720 pixels")
        whole = page.run("return [...document.querySelectorAll('#events .card')].filter(e => e.getBoundingClientRect().bottom <= innerHeight).length")
        check(whole >= 4, f"{whole} events are seen whole")
        before = page.box("#events")
        page.run("askPlace({kind: 'box', from: [0, 0], to: [1, 1]})")
        check(page.box("#events")[1] - before[1] <= 20, "asking moves the list")
        # One stop of Tab, and arrows from there.
        stops = page.run("return document.querySelectorAll('#events .row[tabindex=\"0\"]').length")
        check(stops == 1, f"{stops} rows are stops of Tab")
        page.run("askPlace(null); document.querySelector('#events .row').focus()")
        page.key("\ue015", "\ue015")
        check(page.run("return document.activeElement === document.querySelector('#events [aria-current=true]')"), "the focus stays behind")


def test_page_strip_follows_what_plays(t):
    with Page(t, bag(t)) as page:
        page.run("zoomStrip(0.2, 0)")
        for frame in (399, 200, 0):
            page.run("show(arguments[0], false)", frame)
            shown = page.run("return [time.secondsOf(now), stripFrom, stripFrom + stripLasts]")
            check(shown[1] - 1e-6 <= shown[0] <= shown[2] + 1e-6 and not page.hidden("cursor"), f"{shown}")
        check(not page.hidden("part"), "nothing says that it is zoomed")
        page.press("#stripwhole")
        check(page.hidden("stripwhole") and page.run("return stripLasts === time.lasts"), "it stays zoomed")


def test_page_searches_by_keyboard(t):
    with Page(t, bag(t)) as page:
        page.key("a")
        page.wait("a shape is there", "return drawn !== null && drawn.kind === 'box'", 5)
        page.run("askPlace({kind: 'box', from: [0.2, 0.2], to: [0.8, 0.8]})")
        check(page.run("return document.querySelector('#lines .asked') !== null"), "the area is not on the map")
        # A line, moved and searched by keys alone.
        page.run("askPlace(null); document.activeElement.blur()")
        page.key("d")
        page.wait("a line is there", "return drawn !== null && drawn.kind === 'line' && document.activeElement.dataset.end === 'from'", 5)
        begin = page.run("return drawn.from[0]")
        page.key("\ue012", "\ue012", "\ue012")
        page.wait("its end moves", f"return Math.abs({begin} - drawn.from[0] - 0.03) < 1e-6", 5)
        page.key("\ue007")
        page.wait("it is searched", "return asked !== null && asked.kind === 'line' && drawn === null", 5)
        check(page.text("heading").split()[1:2] == ["of"] or "event" in page.text("heading"), page.text("heading"))


def test_page_of_few_lines_scrolls(t):
    """At 200 % and 400 % nothing covers the list."""
    bag(t)
    with Page(t, crowd(t, 10)) as page:
        for width, height in ((640, 360), (320, 256)):
            page.window(width, height)
            page.wait("the window", f"return innerWidth === {width}")
            page.run("document.querySelector('#events li:last-child').scrollIntoView({block: 'center'})")
            hit = page.run("""const b = document.querySelector('#events li:last-child .row').getBoundingClientRect();
                return document.elementFromPoint(b.left + 40, b.top + b.height / 2)?.closest('#events') !== null && document.documentElement.scrollWidth <= innerWidth;""")
            check(hit, f"{width}x{height}: the list is covered, or too wide")
            # The wheel scrolls there, over the picture too, and zooms with Ctrl alone.
            page.run("scrollTo(0, 0)")
            kept = page.run("""const wheel = ctrlKey => new WheelEvent('wheel', {deltaY: 100, ctrlKey, bubbles: true, cancelable: true});
                return ['view', 'strip', 'screen'].map(id => document.getElementById(id)).flatMap(e => [e.dispatchEvent(wheel(false)), e.dispatchEvent(wheel(true))]);""")
            check(kept == [True, False] * 3, f"the page keeps the wheel for itself: {kept}")
            kept = page.run("""return ['ArrowDown', 'ArrowRight'].map(key =>
                document.body.dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true, cancelable: true})));""")
            check(kept == [True, False], f"the page keeps the arrows that scroll it: {kept}")
            high = page.run("return view.getBoundingClientRect().height")
            check(high >= 200, f"{width}x{height}: the picture has {high} pixels, too few for its text")


def luminance(rgb):
    parts = [value / 255 for value in rgb]
    red, green, blue = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def test_page_colours_of_events_are_seen_in_the_dark_and_with_forced_colours(t):
    colours = ["#0838b8", "#6b3000", "#7b0c6b", "#b8860b", "#457b36", "#0a7bc4", "#f5245c", "#57005f"]
    with Page(t, bag(t)) as page:
        for scheme, features in (("light", []), ("dark", []), ("light", [{"name": "forced-colors", "value": "active"}])):
            page.cdp("Emulation.setEmulatedMedia", media="", features=[{"name": "prefers-color-scheme", "value": scheme}, *features])
            for colour in colours:
                page.run("set({events: events.map(event => ({...event, colour: arguments[0]}))})", colour)
                bar, ground = page.run("""const context = new OffscreenCanvas(1, 1).getContext('2d');
                    const read = colour => { context.fillStyle = colour; context.fillRect(0, 0, 1, 1); return [...context.getImageData(0, 0, 1, 1).data].slice(0, 3); };
                    return [read(getComputedStyle(document.querySelector('#bars i'), '::before').backgroundColor), read(getComputedStyle(strip).backgroundColor)];""")
                light, dark = sorted((luminance(bar), luminance(ground)), reverse=True)
                check((light + 0.05) / (dark + 0.05) >= 3, f"{scheme}, {features}: {colour} is {bar} on {ground}")


@pytest.mark.slow
def test_page_can_be_used_before_it_has_come(t):
    """At 1.5 Mbit/s, and nothing leaps."""
    t.scene("left_bag", "bag.y4m", "--size", "640x480", "--frames", "400")
    t.ffmpeg("-i", "bag.y4m", "-c:v", "msmpeg4v2", "-q:v", "2", "bag.avi")
    t.vvr("render", "bag.avi", "-o", "out.html", "--backend", "software").expect(0)
    for mobile, most in ((False, 3000), (True, 6000)):
        load_slowly(t, mobile, most)


def load_slowly(t, mobile, most):
    """In a window, or on a phone whose processor is four times as slow."""
    with Served(t.folder) as served, Page(t, served.url("out.html")) as page:
        page.driver.get("about:blank")
        if mobile:
            page.window(390, 844, mobile)
            page.cdp("Emulation.setCPUThrottlingRate", rate=4)
        page.cdp("Network.enable")
        page.cdp("Network.emulateNetworkConditions", offline=False, latency=40, downloadThroughput=1.5e6 / 8, uploadThroughput=1.5e6 / 8)
        page.driver.get(served.url("out.html?again"))
        page.wait("it is whole", "return film !== null", 60)
        usable, shift = page.driver.execute_async_script("""let shift = 0;
            new PerformanceObserver(list => { for (const entry of list.getEntries()) if (!entry.hadRecentInput) shift += entry.value; }).observe({type: 'layout-shift', buffered: true});
            setTimeout(() => arguments[0]([performance.getEntriesByName('usable')[0].startTime, shift]), 500);""")
        print(f"usable after {usable:.0f} ms, layout shift {shift:.4f}")
        check(usable < most, f"{mobile}: usable after {usable} ms")
        check(shift < 0.05, f"{mobile}: layout shift {shift}")
        # A file that no browser plays does not come before what the page still needs.
        asked = [path for _, path, _ in served.asked if path.startswith("/bag.avi")]
        parts = page.run("return performance.getEntriesByType('resource').filter(({name}) => name.includes('bag.avi')).map(({startTime}) => startTime)")
        whole = page.run("return performance.getEntriesByType('navigation')[0].responseEnd")
        check(asked and all(start >= whole for start in parts), f"asked at {parts}, the page came until {whole}")
