"""How pages look: light and dark, in small windows, printed, without JavaScript; and what keyboards and screen readers find.

axe-core is in no Debian package, so what it would find is looked for here: contrast by the formula of WCAG 2, names, roles,
and the order in which Tab goes.
"""

import re
import time

import pytest
from browser import Page
from harness import check
from test_archive_index import HOUR, NOW, files_of, known, opened, write_index
from test_page import bag
from test_page_player import crowd
from test_region_editor import Editor

pytestmark = pytest.mark.browser

SCHEMES = ("light", "dark")
WINDOWS = ((1440, 900, False), (1280, 720, False), (800, 600, True), (390, 844, True))


def ground_of(page, element):
    """Red, green and blue behind it."""
    colour = page.run(f"return getComputedStyle({element}).backgroundColor")
    return [int(number) for number in re.findall(r"\d+", colour)[:3]]


def expect_readable(page, least):
    """Light is light, dark is dark, and every text can be read."""
    for scheme in SCHEMES:
        page.media(scheme=scheme)
        ground = ground_of(page, "document.documentElement")
        check(max(ground) < 64 if scheme == "dark" else min(ground) > 200, f"{scheme}: the ground is {ground}")
        faint, count = page.faint()
        check(count >= least, f"{scheme}: only {count} texts")
        check(faint == [], f"{scheme}: {faint}")


def expect_names(page):
    """Everything that can be used has a name, no id comes twice, no Tab order is forced, and headings and landmarks are there."""
    nameless = page.run("""const used = [...document.querySelectorAll('a[href], button, input, select, textarea, video, [tabindex]')];
        const nameOf = e => e.ariaLabel || e.labels?.[0]?.textContent.trim() || e.textContent.trim() || e.title;
        return used.filter(e => e.checkVisibility() && !e.closest('[aria-hidden=true]') && !nameOf(e)).map(e => e.outerHTML.slice(0, 80));""")
    check(nameless == [], f"without a name: {nameless}")
    ids = page.run("return [...document.querySelectorAll('[id]')].map(e => e.id)")
    check(len(ids) == len(set(ids)), "an id twice")
    check(page.run("return [...document.querySelectorAll('[tabindex]')].every(e => e.tabIndex <= 0)"), "a forced order")
    check(page.run("return [document.documentElement.lang, document.title !== '']") == ["en", True], "language, title")
    check(page.count("h1") == 1 and page.count("main:not([hidden])") == 1, "heading, main")
    check(page.run("return [...document.images].every(i => i.hasAttribute('alt'))"), "a picture without alt")


def test_page_is_readable_light_and_dark(t):
    bag(t)
    with Page(t, crowd(t, 30)) as page:
        page.run("choose(3); tell('Copied a link'); tip.hidden = false; askPlace({kind: 'box', from: [0, 0], to: [1, 1]})")
        expect_readable(page, 60)
        expect_names(page)
        # Tab goes from the film to the picture, the strip and the list, as they stand.
        order = []
        page.run("document.activeElement.blur(); getSelection().removeAllRanges(); scrollTo(0, 0)")
        for _ in range(44):
            page.key("\ue004")
            order.append(page.run("return document.activeElement.closest('[id]')?.id ?? ''"))
        wanted = ["playall", "previous", "play", "speed", "clock", "divider", "view", "strip", "filters", "askbox", "share", "events"]
        stops = [name for name, before in zip(order, ["", *order]) if name in wanted and name != before]
        check(stops[:len(wanted)] == wanted, f"{order}")


def test_page_of_a_dark_picture_stays_one_page(t):
    bag(t, "--theme", "dark")
    with Page(t, "out.html") as page:
        for scheme in SCHEMES:
            page.media(scheme=scheme)
            ground = ground_of(page, "view")
            check(max(ground) < 64, f"{scheme}: a dark picture stands on {ground}")


VIEWS = {"clips": "days", "days": "overview", "scene": "scene"}  # on the button, and in the page


def expect_fits(page, width):
    """A phone would make its window wider for a page that does not fit."""
    page.wait(f"it fits into {width}", f"return innerWidth === {width} && document.documentElement.scrollWidth <= {width}", 5)


def show_view(page, view):
    page.press(f"#views [value={view}]")
    page.wait(view, f"const shown = document.getElementById('{VIEWS[view]}'); return !shown.hidden && shown.textContent.length > 20")


def test_index_is_readable_light_and_dark(t):
    left, stood, taken = ["left", 1, 0, 0, 100, 100, 260, 100, 100], ["stood", 2, 90, 0, 5, 5, 100, 500, 900], ["taken", 3, 0, 0, 1, 1, 9, 9, 9]
    known(t, "gate/a.avi", NOW, events=3, found=[left, stood, taken])
    known(t, "hall/b.avi", NOW - HOUR, events=0)
    known(t, "hall/bad.avi", NOW - 2 * HOUR, state="failed", tries=3, status=3, reason="'bad.avi' is not a video", files={})
    write_index(t)
    with opened(t) as page:
        for view in VIEWS:
            show_view(page, view)
            expect_readable(page, 18)
            expect_names(page)
            for width, height, mobile in WINDOWS:
                page.window(width, height, mobile)
                expect_fits(page, width)
            page.window(1440, 900)
        page.press("#views [value=clips]")
        page.filter("nothing is like this")
        expect_readable(page, 12)


def test_region_editor_is_readable_light_and_dark(t):
    t.clip()
    t.vvr("inspect", "clip.avi", "--frame", "0", "-o", "roi.html", "--roi", "5,5 40,5 40,40").expect(0)
    with Editor(t, "roi.html") as page:
        expect_readable(page, 12)
        expect_names(page)


def cut_off(page):
    """What stands out of the window at its sides."""
    return page.run("""return [...document.querySelectorAll('body *')].filter(e => {
        const box = e.getBoundingClientRect();
        const counts = e.checkVisibility() && box.width > 2 && !e.closest('#view, #strip, svg, #tip, .unseen');
        return counts && (box.left < -1 || box.right > innerWidth + 1);
    }).map(e => e.id || e.className || e.tagName)""")


def test_page_fits_every_window(t):
    bag(t, "--start-time", "2026-11-21 07:12:00")
    with Page(t, crowd(t, 60)) as page:
        for width, height, mobile in WINDOWS:
            page.window(width, height, mobile)
            expect_fits(page, width)
            check(cut_off(page) == [], f"{width}x{height}: cut off: {cut_off(page)}")
            left, _, right, _ = page.box("#strip")
            ends = page.run("""const boxes = [...document.querySelectorAll('#ticks span')].map(e => e.getBoundingClientRect());
                return boxes.map(b => [b.left, b.right]);""")
            check(all(left <= a and b <= right for a, b in ends), f"{width}x{height}: times in the strip are cut off: {ends}")
            if width < 760:
                expect_phone(page)
                page.press("#tabvolume")
            high = page.run("return view.getBoundingClientRect().height")
            check(high > 90, f"{width}x{height}: the picture has {high} pixels")
            # The picture is cropped to its contents.
            used = page.run("""const b = picture.getBoundingClientRect();
                const [left, top, right, bottom] = contents;
                return [(right - left) / pictureSize[0] * b.width / view.clientWidth, (bottom - top) / pictureSize[1] * b.height / room[1]];""")
            check(0.97 < max(used) < 1.03, f"{width}: what is drawn takes {used} of the view")


def expect_phone(page):
    """The film is on top, and the first event is in the upper half; each tab shows what it says."""
    check(page.box("#screen")[3] < page.box("#strip")[1] < page.box("#tabs")[1], "another order")
    top = page.box("#events .card")[1]
    check(top < 450, f"the first event begins at {top}")
    for tab, part in (("volume", "view"), ("map", "sheet"), ("events", "side")):
        if tab == "map" and not page.run("return data.overlay.map"):
            check(page.hidden("tabmap"), "a map that is not there")
            continue
        page.press(f"#tab{tab}")
        shown = page.run("return ['view', 'sheet', 'side'].filter(id => document.getElementById(id).checkVisibility())")
        check(shown == [part], f"{tab} shows {shown}")


def expect_in_sight(page):
    page.wait("the player is in sight", """const box = document.getElementById('screen').getBoundingClientRect();
        return box.top >= -1 && box.bottom <= innerHeight + 1;""", 5)


@pytest.mark.parametrize("width, height", [(390, 844), (800, 600)])
def test_page_on_touch_keeps_what_plays_in_sight(t, width, height):
    bag(t)
    with Page(t, "out.html") as page:
        page.window(width, height, mobile=True)
        page.wait("the window", f"return innerWidth === {width}")
        if width == 390:
            page.press("#tabvolume")
        page.run("scrollTo(0, 0)")
        pixel, wide, high = page.run("return [pixels.frames.findIndex((frame, k) => k > pixels.frames.length / 2 && frame >= 0), ...pictureSize]")
        left, top, right, bottom = page.box("#picture")
        x, y = left + (pixel % wide + 0.5) / wide * (right - left), top + (pixel // wide + 0.5) / high * (bottom - top)
        page.touch("touchStart", (x, y))
        page.touch("touchEnd")
        page.wait("it goes there", "return moved", 5)
        expect_in_sight(page)
        page.run("set({tab: 'events'}); scrollTo(0, document.documentElement.scrollHeight)")
        page.run("document.querySelector('#events li:last-child .row').click()")
        expect_in_sight(page)
        page.run("set({tab: 'volume'})")
        # Two fingers zoom, about the place between them.
        page.run("scrollTo(0, 0)")
        left, top, right, bottom = page.box("#view")
        mid = ((left + right) / 2, (top + bottom) / 2)
        before = page.run("return scale")
        page.touch("touchStart", (mid[0] - 20, mid[1]), (mid[0] + 20, mid[1]))
        for apart in range(25, 85, 5):
            page.touch("touchMove", (mid[0] - apart, mid[1]), (mid[0] + apart, mid[1]))
        page.touch("touchEnd")
        after = page.run("return scale")
        check(before == 1 and 2.5 < after < 5, f"two fingers that go from 40 to 160 pixels apart zoom from {before} to {after}")
        check(page.run("return visualViewport.scale") == 1, "the window zooms too")


def test_page_is_printed_whole(t):
    bag(t)
    with Page(t, crowd(t, 60)) as page:
        for width, height in ((718, 1047), (1047, 718)):  # A4 at 96 dpi without its edges
            page.window(width, height)
            page.media("print")
            page.wait("the paper", f"return innerWidth === {width}")
            check(page.run("return document.documentElement.scrollWidth") <= width, "wider than the paper")
            parts = ["picture", "strip", "video", "play", "closer", "copylink", "next", "keys", "filters", "order"]
            shown = page.run("return arguments[0].filter(id => document.getElementById(id).checkVisibility())", parts)
            check(shown == ["picture", "strip"], f"printed: {shown}")
            left, top, right, bottom = box = page.box("#picture")
            check(left >= 0 and right <= width and right - left > 0.9 * width, f"the picture is at {box}")
            check(abs((right - left) / (bottom - top) - 1.6) < 0.02, f"the picture of 640x400 is at {box}")
            *_, end = page.box("#events")
            rows = page.run("""const boxes = [...document.querySelectorAll('#events .row')].map(e => e.getBoundingClientRect());
                return boxes.map(b => [b.height, b.right, b.bottom]);""")
            check(len(rows) == 60 and all(high > 10 and right <= width and low <= end for high, right, low in rows), f"{end}: {rows}")
            faint, _ = page.faint()
            check(faint == [], f"{faint}")
            # The strip is below the picture, before the list; nothing has the size for fingers.
            check(page.box("#picture")[3] <= page.box("#strip")[1] and page.box("#strip")[3] <= page.box("#heading")[1], "another order")
        page.run("choose(3)")
        veiled = "return veilWords.some(word => word !== 0) && document.getElementById('veil').checkVisibility()"
        check(page.run(veiled), "what is not chosen is printed as what is")
        page.media("print", "dark")
        page.wait("dark", "return dark")  # the window says so a moment later
        page.run("dispatchEvent(new Event('beforeprint'))")
        page.wait("light", "return !dark")
        page.run("dispatchEvent(new Event('afterprint'))")
        page.wait("as on the screen", "return dark")
        check(page.run("return getComputedStyle(document.documentElement).backgroundColor") == "rgb(255, 255, 255)", "dark paper")
        faint, _ = page.faint()
        check(faint == [], f"printed from a dark window: {faint}")
        paper = page.cdp("Page.printToPDF", paperWidth=8.27, paperHeight=11.69)["data"]
        check(len(paper) > 20_000, "no paper")


def test_index_is_printed_whole(t):
    for number in range(200):
        known(t, f"{('gate', 'hall', 'yard', 'street')[number % 4]}/{number}.avi", NOW - number // 2 * 24 * HOUR, events=1)
    write_index(t)
    with opened(t) as page:
        check(page.run("return document.querySelectorAll('.card').length") < 200, "all is built at once")
        page.window(718, 1047)
        page.cdp("Page.printToPDF", paperWidth=8.27, paperHeight=11.69)
        check(page.run("return document.querySelectorAll('.card').length") == 200, "only what was near the window is printed")
        for view, name in (("clips", "days"), ("days", "overview")):
            page.press(f"#views [value={view}]")
            page.media("print")
            check(not page.run("return document.getElementById('tools').checkVisibility() || document.querySelector('nav').checkVisibility()"),
                  "tools are printed")
            far = page.run("""const parts = [...document.querySelectorAll('.card, table, td')].filter(e => e.checkVisibility());
                return Math.max(...parts.map(e => e.getBoundingClientRect().right));""")
            check(150 < far <= 718, f"{name}: it goes to {far} of 718")
            page.media()


def test_page_without_scripts(t):
    bag(t)
    rows = len(re.findall("<li>", t.path("out.html").read_text().split("<ol id=\"events\"")[1].split("</ol>")[0]))
    check(rows == 3, f"{rows} events in the text")
    with Page(t, "out.html") as page:
        page.cdp("Emulation.setScriptExecutionDisabled", value=True)
        page.driver.get(t.path("out.html").as_uri())
        is_listed = re.compile(r"2\. 0:\d\d\.\d – 0:\d\d\.\d: left behind")
        end = time.monotonic() + 10
        while not is_listed.search(visible_text(page)) and time.monotonic() < end:
            time.sleep(0.1)  # rows are laid out when they come into sight
        text = visible_text(page)
        check(is_listed.search(text), text)
        check("Without JavaScript" in text, text)
        for dead in ("▶", "Copy", "Search by area", "Space", "1×", "Point"):
            check(dead not in text, f"{dead} is shown, and dead: {text}")
        check(count_boxes(page, "button, select, input, video") == 0, "something dead is shown")
        check(count_boxes(page, "#picture") == 1, "no picture")


def visible_text(page):
    """What can be seen as text, asked of the browser and not of the page, which runs nothing."""
    nodes = page.cdp("DOMSnapshot.captureSnapshot", computedStyles=[])
    strings, layout = nodes["strings"], nodes["documents"][0]["layout"]
    return "\n".join(strings[k] for k in layout["text"] if k >= 0)


def count_boxes(page, selector):
    """How many elements have a box on show."""
    root = page.cdp("DOM.getDocument")["root"]["nodeId"]
    count = 0
    for node in page.cdp("DOM.querySelectorAll", nodeId=root, selector=selector)["nodeIds"]:
        try:
            page.cdp("DOM.getBoxModel", nodeId=node)
            count += 1
        except Exception:  # it has no box
            pass
    return count


RLO, ISOLATE = "\u202e", "\u2067"
EVIL = "</title><script>document.title='evil'</script>.avi".replace("/", "\u2215")
TURNED = [f"a{RLO}gpj.avi", f"b{ISOLATE}x\u202a.avi", EVIL, "{{list}}<b>c.avi"]


def test_page_of_names_that_turn_the_writing(t):
    t.clip("plain.avi", 2, size="96x72")
    for number, name in enumerate(TURNED):
        t.path("plain.avi").rename(t.path(name))
        t.vvr("render", name, "-o", f"{number}.html", "--size", "320x200", "--backend", "software", "--title", name).expect(0)
        t.path(name).rename(t.path("plain.avi"))
    for number, name in enumerate(TURNED):
        with Page(t, f"{number}.html") as page:
            check(page.count("script") == 10 and page.count("h1 *") == 0, "a name became markup")
            check(page.run("return document.title") == page.text_of("h1"), "a name became a script")
            expect_upright(page)
            check(("[U+202E]gpj.avi" in page.text_of("h1")) == (number == 0), page.text_of("h1"))
            page.run("choose(0)" if page.run("return data.events?.length > 0") else "0")
            disabled = page.run("return document.getElementById('copycut').disabled")
            check(disabled or number > 1, "a command that reads otherwise than it is")


def expect_upright(page):
    """No mark that turns the writing is on show: it would turn the end of its name, and what stands beside it."""
    turned = page.run("""const marks = /[\\u061c\\u200e\\u200f\\u202a-\\u202e\\u2066-\\u2069]/;
        const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
        const found = marks.test(document.title) ? [document.title] : [];
        while (walker.nextNode()) {
            const parent = walker.currentNode.parentElement;
            const turns = marks.test(walker.currentNode.data) && !parent.closest('script, style, noscript');
            if (turns) found.push(parent.outerHTML.slice(0, 80));
        }
        return found;""")
    check(turned == [], f"{turned}")


def test_index_of_names_that_turn_the_writing(t):
    for number, name in enumerate(TURNED):
        known(t, f"{RLO}cam{number}/{name}", NOW - number * HOUR, events=1, found=[["moved", 1, 0, 0, 1, 1, 5, 5, 5]])
    known(t, f"{RLO}cam0/{RLO}bad.avi", NOW, state="failed", tries=1, status=3, reason=f"'{RLO}bad.avi' is not a video", files={})
    write_index(t)
    with opened(t, cards=5) as page:
        for view in VIEWS:
            show_view(page, view)
            expect_upright(page)
        page.press("#views [value=clips]")
        check(any("[U+202E]gpj.avi" in name for name in files_of(page)), f"{files_of(page)}")
        check("[U+202E]bad.avi' is not a video" in page.text("days"), page.text("days"))
        check(page.run("return document.title") == "Video archive", "a name became a script")


def test_page_first_line_lies_on_nothing(t):
    bag(t)
    with Page(t, "out.html") as page:
        for width, height in ((2560, 1440), (1920, 1080), (1440, 900), (1280, 720), (960, 700), (844, 390), (640, 360), (390, 844)):
            page.window(width, height)
            page.run("set({tab: 'volume'})")
            page.wait("it is drawn for this window", "return !document.getElementById('first').hidden && document.getElementById('what').textContent && Math.abs(room[0] - document.getElementById('view').clientWidth) < 1")
            covered = page.run("""const box = e => e.getBoundingClientRect(), first = box(document.getElementById('meaning')), view = box(document.getElementById('view'));
                if ([...document.querySelectorAll('#what, #first')].map(box).some(b => b.left < first.left || b.right > first.right || b.top < first.top || b.bottom > first.bottom)) return ['the border'];
                return [...document.querySelectorAll('#letters > *, #letters .caption, #map > *, #legend span, .zoom button')].filter(e => e.checkVisibility()).filter(e => {
                    const b = box(e); return b.left < first.right && b.right > first.left && b.top < first.bottom && b.bottom > first.top;
                }).map(e => e.textContent || e.className || e.id);""")
            check(covered == [], f"{width}x{height}: it covers {covered}")
            cut = page.run("return [...document.querySelectorAll('#letters .caption')].filter(e => e.scrollWidth > e.clientWidth + 1).map(e => e.textContent)")
            check(cut == [], f"{width}x{height}: cut off: {cut}")
