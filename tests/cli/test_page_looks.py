"""How pages look: light and dark, in small windows, printed, without JavaScript; and what keyboards and screen readers find.

axe-core is in no Debian package, so what it would find is looked for here: contrast by the formula of WCAG 2, names, roles,
and the order in which Tab goes.
"""

import os
import re

import pytest
from browser import Page
from harness import check
from test_archive_index import HOUR, NOW, Index, known, write_index
from test_page_player import bag, crowd

pytestmark = pytest.mark.browser

SCHEMES = ("light", "dark")
WINDOWS = ((1440, 900, False), (1280, 720, False), (800, 600, True), (390, 844, True))


class Plain(Page):
    """A page of any kind."""

    def open(self, path):
        self.driver.get(path.as_uri())
        self.wait("the page is there", "return document.readyState === 'complete'")


def expect_readable(page, least):
    """Light is light, dark is dark, and every text can be read."""
    for scheme in SCHEMES:
        page.media(scheme=scheme)
        ground = [int(number) for number in re.findall(r"\d+", page.run("return getComputedStyle(document.documentElement).backgroundColor"))[:3]]
        check(max(ground) < 64 if scheme == "dark" else min(ground) > 200, f"{scheme}: the ground is {ground}")
        faint, count = page.faint()
        check(count >= least, f"{scheme}: only {count} texts")
        check(faint == [], f"{scheme}: {faint}")


def expect_names(page):
    """Everything that can be used has a name, no id comes twice, no Tab order is forced, and headings and landmarks are there."""
    nameless = page.run("""return [...document.querySelectorAll('a[href], button, input, select, textarea, video, [tabindex]')].filter(e =>
        e.checkVisibility() && !e.closest('[aria-hidden=true]') && !(e.ariaLabel || e.labels?.[0]?.textContent.trim() || e.textContent.trim() || e.title)).map(e => e.outerHTML.slice(0, 80))""")
    check(nameless == [], f"without a name: {nameless}")
    check(page.run("const ids = [...document.querySelectorAll('[id]')].map(e => e.id); return ids.filter((id, k) => ids.indexOf(id) !== k)") == [], "an id twice")
    check(page.run("return [...document.querySelectorAll('[tabindex]')].every(e => e.tabIndex <= 0)"), "a forced order")
    check(page.run("return [document.documentElement.lang, document.title !== '', document.querySelectorAll('h1').length, document.querySelectorAll('main').length > 0]")
          == ["en", True, 1, True], "language, title, heading, main")
    check(page.run("return [...document.images].every(i => i.hasAttribute('alt'))"), "a picture without alt")


def test_page_is_readable_light_and_dark(t):
    bag(t)
    with Page(t, crowd(t, 30)) as page:
        page.run("choose(3); tell('Copied a link'); tip.hidden = false; askPlace({kind: 'box', from: [0, 0], to: [1, 1]})")
        expect_readable(page, 60)
        expect_names(page)
        # Tab goes from the picture to the strip, the player and the list, as they stand.
        order = []
        page.run("document.activeElement.blur(); getSelection().removeAllRanges(); scrollTo(0, 0)")
        for _ in range(26):
            page.key("\ue004")
            order.append(page.run("return document.activeElement.closest('[id]').id"))
        wanted = ["view", "strip", "play", "speed", "askbox", "copylink", "previous", "order", "events"]
        check([name for name in order if name in wanted][:len(wanted)] == wanted, f"{order}")


def test_page_of_a_dark_picture_stays_one_page(t):
    bag(t, "--theme", "dark")
    with Page(t, "out.html") as page:
        for scheme in SCHEMES:
            page.media(scheme=scheme)
            ground = page.run("return getComputedStyle(view).backgroundColor")
            check(max(map(int, re.findall(r"\d+", ground)[:3])) < 64, f"{scheme}: a dark picture stands on {ground}")


def index_of_all_kinds(t):
    """An index with a card of each kind."""
    known(t, "gate/a.avi", NOW, events=3, found=[["l", 1, 0, 0, 100, 100, 260, 100, 100], ["s", 2, 90, 0, 5, 5, 100, 500, 900], ["t", 3, 0, 0, 1, 1, 9, 9, 9]])
    known(t, "hall/b.avi", NOW - HOUR, events=0)
    known(t, "hall/bad.avi", NOW - 2 * HOUR, state="failed", tries=3, status=3, reason="'bad.avi' is not a video", files={})
    write_index(t)
    os.environ["TZ"] = "UTC"
    return "out/index.html"


def test_index_is_readable_light_and_dark(t):
    with Index(t, index_of_all_kinds(t)) as page:
        for view in ("clips", "days", "scene"):
            page.press(f"#views [value={view}]")
            page.wait("the view", f"return document.getElementById({{clips: 'days', days: 'overview', scene: 'scene'}}['{view}']).textContent.length > 20")
            expect_readable(page, 18)
            expect_names(page)
            for width, height, mobile in WINDOWS:
                page.window(width, height, mobile)
                page.wait(f"{view} fits into {width}", f"return innerWidth === {width} && document.documentElement.scrollWidth <= {width}", 5)
            page.window(1440, 900)
        page.press("#views [value=clips]")
        page.filter("nothing is like this")
        expect_readable(page, 12)


def test_region_editor_is_readable_light_and_dark(t):
    t.clip()
    t.vvr("inspect", "clip.avi", "--frame", "0", "-o", "roi.html", "--roi", "5,5 40,5 40,40").expect(0)
    with Plain(t, "roi.html") as page:
        page.wait("the page is ready", "return document.documentElement.dataset.ready !== undefined")
        expect_readable(page, 12)
        expect_names(page)


def cut_off(page):
    """What stands out of the window at its sides."""
    return page.run("""return [...document.querySelectorAll('body *')].filter(e => {
        const box = e.getBoundingClientRect();
        return e.checkVisibility() && box.width > 2 && !e.closest('#view, #strip, svg, #tip, .unseen') && (box.left < -1 || box.right > innerWidth + 1);
    }).map(e => e.id || e.className || e.tagName)""")


def test_page_fits_every_window(t):
    bag(t, "--start-time", "2026-11-21 07:12:00")
    with Page(t, crowd(t, 60)) as page:
        for width, height, mobile in WINDOWS:
            page.window(width, height, mobile)
            page.wait(f"it fits into {width}", f"return innerWidth === {width} && document.documentElement.scrollWidth <= {width}", 5)
            check(cut_off(page) == [], f"{width}x{height}: cut off: {cut_off(page)}")
            ticks = page.run("const s = strip.getBoundingClientRect(); return [...document.querySelectorAll('#ticks span')].map(e => e.getBoundingClientRect())"
                             ".filter(b => b.left < s.left || b.right > s.right).length")
            check(ticks == 0, f"{width}x{height}: {ticks} times in the strip are cut off")
            high = page.run("return view.getBoundingClientRect().height")
            check(high > 90, f"{width}x{height}: the picture has {high} pixels")
            check((page.run("return document.querySelector('.keys').checkVisibility()")) == (not mobile), f"{width}: hints of keys")
            # The picture is cropped to its contents.
            box, whole = page.run("const b = picture.getBoundingClientRect(), v = view.getBoundingClientRect();"
                                  "const [l, t, r, u] = contents; return [[(r - l) / width * b.width, (u - t) / height * b.height], [v.width, v.height]]")
            check(max(box[0] / whole[0], box[1] / whole[1]) > 0.97, f"{width}: what is drawn takes {box} of {whole}")


def touch(page, kind, *points):
    page.cdp("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(points)])


def in_sight(page):
    top, bottom, height = page.run("const b = document.getElementById('screen').getBoundingClientRect(); return [b.top, b.bottom, innerHeight]")
    return top >= -1 and bottom <= height + 1


@pytest.mark.parametrize("width, height", [(390, 844), (800, 600)])
def test_page_on_touch_keeps_what_plays_in_sight(t, width, height):
    bag(t)
    with Page(t, "out.html") as page:
        page.window(width, height, mobile=True)
        page.wait("the window", f"return innerWidth === {width}")
        x, y = page.run("""scrollTo(0, 0); const b = picture.getBoundingClientRect(), v = view.getBoundingClientRect();
            for (let k = frames.length >> 1; k < frames.length; ++k) {
                const [x, y] = [b.left + (k % width + 0.5) / width * b.width, b.top + (Math.floor(k / width) + 0.5) / height * b.height];
                if (frames[k] >= 0 && x > v.left && x < v.right && y > v.top && y < Math.min(v.bottom, innerHeight)) return [x, y];
            }""")
        touch(page, "touchStart", (x, y))
        touch(page, "touchEnd")
        page.wait("it goes there", "return moved", 5)
        page.wait("the player is in sight", "const b = document.getElementById('screen').getBoundingClientRect(); return b.top >= -1 && b.bottom <= innerHeight + 1", 5)
        page.run("scrollTo(0, document.documentElement.scrollHeight); document.querySelector('#events li:last-child button').click()")
        page.wait("the player is in sight", "const b = document.getElementById('screen').getBoundingClientRect(); return b.top >= -1 && b.bottom <= innerHeight + 1", 5)
        # Two fingers zoom, about the place between them.
        page.run("scrollTo(0, 0)")
        left, top, wide, high = page.run("const b = view.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]")
        mid = (left + wide / 2, top + high / 2)
        before = page.run("return scale")
        touch(page, "touchStart", (mid[0] - 20, mid[1]), (mid[0] + 20, mid[1]))
        for apart in range(25, 85, 5):
            touch(page, "touchMove", (mid[0] - apart, mid[1]), (mid[0] + apart, mid[1]))
        touch(page, "touchEnd")
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
            shown = page.run("""return ['picture', 'video', 'play', 'strip', 'closer', 'copylink', 'next', 'keys', 'filters', 'order'].filter(id =>
                document.getElementById(id).checkVisibility())""")
            check(shown == ["picture"], f"printed: {shown}")
            box = page.run("const b = picture.getBoundingClientRect(); return [b.left, b.right, b.width / b.height, width / height]")
            check(box[0] >= 0 and box[1] <= width and box[1] - box[0] > 0.9 * width and abs(box[2] / box[3] - 1) < 0.02, f"the picture is at {box}")
            cut = page.run("""const l = document.getElementById('events'), b = l.getBoundingClientRect();
                const rows = [...l.querySelectorAll('button')].map(e => e.getBoundingClientRect());
                return [rows.length, rows.filter(r => r.height < 10 || r.right > innerWidth + 1 || r.bottom > b.bottom + 1).length, l.scrollHeight - l.clientHeight]""")
            check(cut[0] == 60 and cut[1] == 0 and cut[2] <= 1, f"rows, those that are cut, what scrolls: {cut}")
            faint, _ = page.faint()
            check(faint == [], f"{faint}")
        page.media("print", "dark")
        check(page.run("return getComputedStyle(document.documentElement).backgroundColor") == "rgb(255, 255, 255)", "dark paper")
        faint, _ = page.faint()
        check(faint == [], f"printed from a dark window: {faint}")
        paper = page.cdp("Page.printToPDF", paperWidth=8.27, paperHeight=11.69)["data"]
        check(len(paper) > 20_000, "no paper")


def test_index_is_printed_whole(t):
    for number in range(200):
        known(t, f"{('gate', 'hall', 'yard', 'street')[number % 4]}/{number}.avi", NOW - number // 2 * 24 * HOUR, events=1)
    write_index(t)
    os.environ["TZ"] = "UTC"
    with Index(t, "out/index.html") as page:
        check(page.run("return document.querySelectorAll('.card').length") < 200, "all is built at once")
        page.window(718, 1047)
        page.cdp("Page.printToPDF", paperWidth=8.27, paperHeight=11.69)
        check(page.run("return document.querySelectorAll('.card').length") == 200, "only what was near the window is printed")
        for view, name in (("clips", "days"), ("days", "overview")):
            page.press(f"#views [value={view}]")
            page.media("print")
            check(page.run("return [document.getElementById('tools').checkVisibility(), document.querySelector('nav').checkVisibility()]") == [False, False],
                  "tools are printed")
            check(page.run("return document.documentElement.scrollWidth <= innerWidth && [...document.querySelectorAll('.card, table, td')].filter(e => e.checkVisibility()).every(e =>"
                           f"e.getBoundingClientRect().right <= innerWidth)"), f"{name}: cut at the right")
            page.media()


def test_page_without_scripts(t):
    bag(t)
    rows = len(re.findall("<li>", t.path("out.html").read_text().split("<ol id=\"events\"")[1].split("</ol>")[0]))
    check(rows == 3, f"{rows} events in the text")
    with Page(t, "out.html") as page:
        page.cdp("Emulation.setScriptExecutionDisabled", value=True)
        page.driver.get(t.path("out.html").as_uri())
        text = visible_text(page)
        check(re.search(r"2\. [\d.:]+( s)? to .*left behind", text), text)
        check("Without JavaScript" in text, text)
        for dead in ("▶", "Copy", "In an area", "Space", "1×", "Point"):
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
TURNED = [name.replace("/", "\u2215") for name in (f"a{RLO}gpj.avi", f"b{ISOLATE}x\u202a.avi", "</title><script>document.title='evil'</script>.avi", "{{list}}<b>c.avi")]


def test_page_of_names_that_turn_the_writing(t):
    t.clip("plain.avi", 2, size="96x72")
    for number, name in enumerate(TURNED):
        t.path("plain.avi").rename(t.path(name))
        t.vvr("render", name, "-o", f"{number}.html", "--size", "320x200", "--backend", "software", "--title", name).expect(0)
        t.path(name).rename(t.path("plain.avi"))
    for number, name in enumerate(TURNED):
        with Page(t, f"{number}.html") as page:
            check(page.run("return [document.scripts.length, document.querySelectorAll('b').length <= 3 + data.events.length]") == [2, True], "a name became markup")
            check("evil" not in page.run("return document.title") or name in page.run("return document.title"), "a name became a script")
            expect_upright(page)
            check(("[U+202E]gpj.avi" in page.text_of("h1")) == (number == 0), page.text_of("h1"))
            page.run("choose(0)" if page.run("return data.events?.length > 0") else "0")
            check(number > 1 or page.run("return document.getElementById('copycut').disabled"), "a command that reads otherwise than it is")


def expect_upright(page):
    """No mark that turns the writing is on show: it would turn the end of its name, and what stands beside it."""
    turned = page.run("""const marks = /[\\u061c\\u200e\\u200f\\u202a-\\u202e\\u2066-\\u2069]/;
        const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
        const found = marks.test(document.title) ? [document.title] : [];
        while (walker.nextNode()) {
            const parent = walker.currentNode.parentElement;
            if (marks.test(walker.currentNode.data) && !parent.closest('script, style, noscript')) found.push(parent.outerHTML.slice(0, 80));
        }
        return found;""")
    check(turned == [], f"{turned}")


def test_index_of_names_that_turn_the_writing(t):
    for number, name in enumerate(TURNED):
        known(t, f"{RLO}cam{number}/{name}", NOW - number * HOUR, events=1, found=[["m", 1, 0, 0, 1, 1, 5, 5, 5]])
    known(t, f"{RLO}cam0/{RLO}bad.avi", NOW, state="failed", tries=1, status=3, reason=f"'{RLO}bad.avi' is not a video", files={})
    write_index(t)
    os.environ["TZ"] = "UTC"
    with Index(t, "out/index.html") as page:
        page.wait("cards", "return document.querySelectorAll('.card').length === 5")
        for view in ("clips", "days", "scene"):
            page.press(f"#views [value={view}]")
            page.wait("the view", f"return !document.getElementById({{clips: 'days', days: 'overview', scene: 'scene'}}['{view}']).hidden")
            expect_upright(page)
        page.press("#views [value=clips]")
        check("[U+202E]gpj.avi" in page.text("days") and "[U+202E]bad.avi' is not a video" in page.text("days"), page.text("days"))
        check(page.run("return document.title") == "Video archive", "a name became a script")
