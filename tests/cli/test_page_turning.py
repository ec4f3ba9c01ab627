"""The volume that turns in a page, in Chromium with its software rasteriser: beside what the program draws from the same angle, and what
a hand, keys and addresses do with it."""

import contextlib
import time

import pytest
from browser import Page, Served
from harness import check
from test_page import bag

pytestmark = [pytest.mark.browser, pytest.mark.nightly]

SOFTWARE = ("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist")
CAMERAS = ((0, 46), (0, 90), (-55, 16), (40, 30), (120, 25), (180, 40), (-90, 60), (75, 5), (-20, 70), (0, 10))

# The volume as it is drawn, beside a picture of the program: the mean difference of their colours on white, of 255.
DIFFERENCE = """
const done = arguments[arguments.length - 1];
const [source, size] = arguments;
const read = (image, from, onto) => {
    const context = Object.assign(document.createElement('canvas'), {width: onto[0], height: onto[1]}).getContext('2d');
    context.fillStyle = '#fff';
    context.fillRect(0, 0, ...onto);
    context.drawImage(image, ...from, 0, 0, ...onto);
    return context.getImageData(0, 0, ...onto).data;
};
const canvas = document.getElementById('volume');
const view = document.getElementById('view').getBoundingClientRect();
const box = document.getElementById('picture').getBoundingClientRect();
const scale = size[0] / box.width;
const image = Object.assign(new Image(), {src: source});
image.decode().then(() => {
    const onto = [canvas.width, canvas.height];
    const a = read(canvas, [0, 0, ...onto], onto);
    const b = read(image, [(view.left + 1 - box.left) * scale, (view.top + 1 - box.top) * scale, (view.width - 2) * scale, (view.height - 2) * scale], onto);
    let sum = 0;
    let drawn = 0;
    for (let k = 0; k < a.length; k += 4) {
        if (b[k] < 250 || b[k + 1] < 250 || b[k + 2] < 250 || a[k] < 250) ++drawn;
        for (let c = 0; c < 3; ++c) sum += Math.abs(a[k + c] - b[k + c]);
    }
    done([sum / (a.length / 4 * 3), drawn / (a.length / 4)]);
});
"""

# Objects at a grid of points, by the volume and by the numbers of pixels that the program wrote.
OBJECTS = """
const [objects, size, step] = arguments;
const view = document.getElementById('view').getBoundingClientRect();
const box = document.getElementById('picture').getBoundingClientRect();
const scale = size[0] / box.width;
let both = 0, same = 0;
for (let y = 2; y < view.height - 2; y += step) {
    for (let x = 2; x < view.width - 2; x += step) {
        const column = Math.floor((view.left + 1 + x - box.left) * scale), row = Math.floor((view.top + 1 + y - box.top) * scale);
        if (column < 0 || row < 0 || column >= size[0] || row >= size[1]) continue;
        const truth = objects[row * size[0] + column];
        const found = vvr.pickedAround(x, y, 0).objects[0];
        if (truth < 0 || found < 0) continue;
        ++both;
        if (truth === found) ++same;
    }
}
return [same, both];
"""


@contextlib.contextmanager
def turnable(t, name="out.html", width=390, height=844):
    """A page whose volume can be turned, in a window in which the software rasteriser is quick enough."""
    with Page(t, name, *SOFTWARE) as page:
        page.window(width, height)
        page.run("localStorage.setItem('vvr-dragged', '1')")  # nothing is said, so the volume has more room
        page.reload()
        if width < 760:
            page.run("set({tab: 'volume'})")
        ready(page)
        yield page


def ready(page):
    page.wait("the volume has come", "return parts.volume !== null")
    page.run("prepareVolume(1e9)")
    page.wait("it can be turned", "return turnable", 60)


def settled(page):
    """After the volume has been drawn in full."""
    page.wait("it is drawn in full", """const {volume} = document.all; const seen = volume.dataset.seen ?? '0';
        if ((volume.dataset.drawn ?? '0') === seen) return false; volume.dataset.seen = volume.dataset.drawn; return true;""", 60)


def turn_to(page, angle):
    page.run("document.getElementById('volume').dataset.seen = document.getElementById('volume').dataset.drawn ?? '0';"
             "set({turns: true, moved: false, angle: arguments[0]})", list(angle))
    settled(page)


def test_volume_lies_on_what_the_program_draws(t):
    bag(t)
    for k, (azimuth, elevation) in enumerate(CAMERAS):
        t.vvr("render", "bag.mp4", "-o", f"{k}.html", "--size", "640x400", "--backend", "software", "--camera", f"{azimuth},{elevation}").expect(0)
    truth = []
    with turnable(t, "0.html") as page:
        for k in range(len(CAMERAS)):
            page.open(t.path(f"{k}.html"))
            truth.append(page.run("return [picture.src, [...pixels.objects]]"))
    with turnable(t, "0.html") as page:
        page.run("""const style = new CSSStyleSheet();
            style.replaceSync('#view { --buttons: 0px !important; --meaning: 0px !important; width: 322px !important; height: 192px !important }');
            document.adoptedStyleSheets = [style];""")
        page.wait("a small view", "return room[0] === 320 && room[1] === 190")
        size = page.run("return pictureSize")
        worst = []
        for (source, objects), angle in zip(truth, CAMERAS):
            turn_to(page, angle)
            page.driver.set_script_timeout(60)
            off, drawn = page.driver.execute_async_script(DIFFERENCE, source, size)
            same, both = page.run(OBJECTS, objects, size, 3)
            check(drawn > 0.01, f"{angle}: only {drawn:.3f} of the view shows anything")
            check(both > 30, f"{angle}: only {both} points show an object in both")
            check(same >= 0.95 * both, f"{angle}: {same} of {both} points show the same object")
            check(off < 6, f"{angle}: colours differ by {off} of 255")
            worst.append((angle, round(off, 2), round(same / both, 3)))
        print(worst)
        check(page.complaints() == [], page.complaints())


def test_volume_is_turned_by_hand_keys_and_address(t):
    bag(t)
    with turnable(t) as page:
        check(page.run("return [turns, angle]") == [False, [0, 46]], "it begins with the picture")
        page.drag("#view", (0.5, 0.5), (0.55, 0.5), (0.7, 0.6))
        turns, (azimuth, elevation) = page.run("return [turns, angle]")
        check(turns and azimuth < -10 and elevation > 47, f"{azimuth}, {elevation}")
        check(page.run("return chosen === null && scale === 1"), "a drag chooses nothing and moves nothing")
        page.wait("the address has the angle", "return location.hash.includes('view=')")
        hash_before = page.run("return location.hash")
        for begin, end, limit in ((0.2, 0.75, 90), (0.75, 0.2, 3)):  # not beyond straight above, not below the ground
            for _ in range(5):
                page.drag("#view", (0.3, begin), (0.3, (begin + end) / 2), (0.3, end))
            check(page.run("return angle[1]") == limit, f"the elevation ends at {page.run('return angle[1]')}")
        page.run("document.getElementById('view').focus()")
        before = page.run("return angle")
        page.hold("\ue00a", "\ue012")  # Alt and the arrow to the left
        page.hold("\ue00a", "\ue013")
        after = page.run("return angle")
        check(after == [before[0] + 6, before[1] + 4], f"{before} to {after}")
        page.key("0")
        page.wait("it is as it was", "return angle[0] === 0 && angle[1] === 46", 5)
        page.wait("so is the address", "return !location.hash.includes('view')", 5)
        page.run("location.hash = arguments[0]; location.reload()", hash_before)
        ready(page)
        page.wait("the address turns it", "return turns", 20)
        check(page.run("return angle") == [azimuth, elevation], "another angle")
        for name, wanted in (("above", [0, 90]), ("side", [-55, 16]), ("unbent", [0, 28]), ("default", [0, 46])):
            page.set("angle", name)
            page.wait(name, f"return angle[0] === {wanted[0]} && angle[1] === {wanted[1]} && unbent === {'true' if name == 'unbent' else 'false'}", 20)
        check(page.complaints() == [], page.complaints())


def test_volume_shows_events_and_moments(t):
    bag(t)
    with turnable(t) as page:
        turn_to(page, (-30, 40))
        page.hold_still()
        # Twenty places of events: the middle of what is seen of each.
        found = page.run("""const box = document.getElementById('volume').getBoundingClientRect();
            const places = [];
            for (let y = Math.ceil(box.top) + 4; y < box.bottom; y += 4) for (let x = Math.ceil(box.left) + 4; x < box.right; x += 4) {
                const {frames, objects} = vvr.pickedAround(x - box.left, y - box.top, 0);
                if (objects[0] >= 0) places.push([x, y, objects[0], frames[0]]);
            }
            return places;""")
        check(len(found) >= 20, f"only {len(found)} places show an event")
        from selenium.webdriver.common.action_chains import ActionChains
        for x, y, event, frame in found[::max(1, len(found) // 20)][:20]:
            page.run("choose(null); set({moved: false}); scrollTo(0, 0)")  # what is chosen makes the rest faint, and a click shows the player
            on_badge = page.run("return document.elementFromPoint(...arguments).closest('button, select, input') !== null || [...document.querySelectorAll('#letters [data-event]')].some(e => { const b = e.getBoundingClientRect();"
                                "return arguments[0] >= b.left - 1 && arguments[0] <= b.right + 1 && arguments[1] >= b.top - 1 && arguments[1] <= b.bottom + 1; })", x, y)
            if on_badge:
                continue
            time.sleep(0.6)  # two clicks are no double click
            actions = ActionChains(page.driver, duration=0)
            actions.w3c_actions.pointer_action.move_to_location(x, y).click()
            actions.perform()
            chosen, now = page.run("return [chosen, now]")
            check(chosen == event and abs(now - frame) <= 1, f"at {x}, {y}: event {chosen} at {now}, not {event} at {frame}")
        check(page.complaints() == [], page.complaints())


def test_volume_has_the_film_inside(t):
    bag(t)
    for address in ("file", "http"):
        with Served(t.folder) as served, Page(t, served.url("out.html") if address == "http" else "out.html", *SOFTWARE) as page:
            page.window(390, 844)
            ready(page)
            page.run("set({tab: 'volume'})")
            page.run("show(200, false)")
            page.wait("it is there", "return !video.seeking && now === 200")
            turn_to(page, (-35, 40))
            page.run("set({moved: true})")
            settled(page)
            # The orange frame's middle: what is held there is dragged along the volume.
            where = """const points = document.querySelector('#lit .rib').getAttribute('points').split(' ').map(p => p.split(',').map(Number));
                const b = document.getElementById('picture').getBoundingClientRect(); const v = document.getElementById('view').getBoundingClientRect();
                const middle = [0, 1].map(k => points.reduce((sum, p) => sum + p[k], 0) / 4 * b.width / pictureSize[0]);
                return [middle[0] + b.left - v.left, middle[1] + b.top - v.top, v.width, v.height];"""
            x, y, wide, high = page.run(where)
            page.wait(f"{address}: the film stands there", f"return vvr.pickedAround({x - 1}, {y - 1}, 0).isNow", 20)
            before = page.run("return [angle, now]")
            page.drag("#view", (x / wide, y / high), (x / wide + 0.02, y / high), (x / wide + 0.06, y / high))
            angle, now = page.run("return [angle, now]")
            check(angle == before[0] and now > before[1], f"{address}: from {before} to {angle}, {now}")
            check(page.complaints() == [], page.complaints())


def test_volume_of_a_piece_of_time(t):
    bag(t)
    with turnable(t) as page:
        check(page.hidden("piece"), "nothing is zoomed")
        page.run("vvr.zoomStrip(0.4, 0.5)")
        first, last = page.run("return [stripFrom, stripFrom + stripLasts]")
        page.press("#cut")
        check(page.run("return [turns, piece, bends]") == [True, [first, last], False], "cut")
        settled(page)
        page.press("#bend")
        check(page.run("return [piece, bends]") == [[first, last], True], "bent")
        settled(page)
        ends = page.run("return [overlayNow().sections[0][0], overlayNow().sections.at(-1)[0]]")
        check(abs(ends[0] - first) < 0.2 and abs(ends[1] - last) < 0.2, f"{ends}, not {first} to {last}")
        page.press("#bend")
        check(page.run("return piece") is None, "all again")
        # A brush along the strip's times chooses a piece without a zoom, and the volume follows it.
        page.press("#stripwhole")
        page.drag("#rail", (0.25, 0.5), (0.4, 0.5), (0.5, 0.5))
        begins, lasts = page.run("return [time.begins, time.lasts]")
        chosen = page.run("return [(brush[0] - arguments[0]) / arguments[1], (brush[1] - arguments[0]) / arguments[1]]", begins, lasts)
        check(abs(chosen[0] - 0.25) < 0.02 and abs(chosen[1] - 0.5) < 0.02, f"{chosen}")
        check(page.run("return [now, piece]")[1] is None, "a brush alone cuts")
        page.press("#cut")
        check(page.run("return piece") == page.run("return brush"), "another piece")
        page.drag("#rail", (0.5, 0.5), (0.6, 0.5), (0.75, 0.5))
        check(page.run("return piece") == page.run("return brush") and page.run("return (piece[0] - time.begins) / time.lasts > 0.45"), "it does not follow")
        page.run("document.activeElement.blur()")
        page.key("\ue00c")
        check(page.run("return [brush, piece]") == [None, None], "Escape does not end it")


def test_volume_shows_only_what_the_list_has(t):
    bag(t)
    events = """const {clientWidth, clientHeight} = document.getElementById('view');
        const found = new Set();
        for (let y = 4; y < clientHeight; y += 8) for (let x = 4; x < clientWidth; x += 8) found.add(vvr.pickedAround(x, y, 0).objects[0]);
        return [...found].filter(place => place >= 0).sort();"""
    with turnable(t) as page:
        turn_to(page, (-30, 40))
        everything = page.run(events)
        check(len(everything) > 1, f"{everything}")
        kind, wanted = page.run("const kind = events[arguments[0]].kind; return [kind, [...events.keys()].filter(place => events[place].kind === kind)]", everything[0])
        page.run("set({kind: arguments[0]})", kind)
        settled(page)
        check(set(page.run(events)) == set(wanted) & set(everything), f"{page.run(events)}, not {wanted}")
        shown = page.run("return [...document.querySelectorAll('#letters [data-event]')].filter(e => e.checkVisibility()).map(e => Number(e.dataset.event))")
        check(set(shown) <= set(wanted), f"numbers of {shown}")


def test_volume_gives_way_to_the_picture(t):
    bag(t)
    shows = "const {picture, volume} = document.all; return [getComputedStyle(picture).visibility === 'visible', getComputedStyle(volume).display !== 'none']"
    with turnable(t) as page:
        turn_to(page, (-30, 40))
        check(page.run(shows) == [False, True], "the volume is shown")
        page.media("print")
        check(page.run(shows) == [True, False], "on paper is the picture")
        page.media()
        page.run("window.lose = document.getElementById('volume').getContext('webgl2').getExtension('WEBGL_lose_context'); lose.loseContext()")
        page.wait("the picture is back", "return !turns && !turnable")
        check(page.run(shows) == [True, False], "after a lost context is the picture")
        page.run("lose.restoreContext()")
        page.wait("it turns again", "return turnable", 60)
        turn_to(page, (30, 20))
        check(page.run(shows) == [False, True], "and again the volume")
    with Page(t, "out.html", "--disable-webgl", "--disable-webgl2", "--disable-3d-apis") as page:
        page.wait("the volume has come", "return parts.volume !== null")
        page.run("window.tried = prepareVolume().then(() => { window.done = true; })")
        page.wait("it was tried", "return window.done")
        check(page.run("return turnable") is False, "without WebGL")
        page.drag("#view", (0.5, 0.5), (0.6, 0.5), (0.7, 0.6))
        check(page.run(shows) == [True, False], "the picture stays")
        check(page.complaints() == [], page.complaints())


def test_volume_is_left_out(t):
    bag(t, "--flat-page")
    with Page(t, "out.html", *SOFTWARE) as page:
        check(page.run("return allArrived && parts.volume") is None, "there is none")
        check(page.hidden("turning"), "nothing offers to turn it")


def test_zebra_runs_where_an_object_moves(t):
    bag(t)
    with turnable(t) as page:
        turn_to(page, (-30, 40))
        check(page.count("#lit .zebra") == 0, "nothing is chosen")
        runs = "return getComputedStyle(document.querySelector('#lit .zebra')).animationName"
        lies, place = page.run("return [events.findIndex(({stays}) => stays?.length), events.findIndex(({stays}) => !stays?.length)]")
        page.run("set({lightened: arguments[0]})", lies)
        check(page.count("#lit .trail") > 0 and page.count("#lit .zebra") == 0, "what lies has a zebra")
        page.run("set({lightened: arguments[0]})", place)
        check(page.run(runs) == "run", "it stands where the pointer is on its event")
        page.run("set({lightened: null}); choose(arguments[0])", place)
        check(page.run(runs) == "none", "it runs while nothing plays")
        page.cdp("Emulation.setEmulatedMedia", features=[{"name": "prefers-reduced-motion", "value": "reduce"}])
        page.run("set({lightened: arguments[0]})", place)
        check(page.run(runs) == "none", "it runs for who wants less motion")
        check(page.complaints() == [], page.complaints())


def test_volume_fills_its_view_as_it_turns(t):
    bag(t)
    shown = "return [...document.querySelectorAll('#letters .portrait, #lines line')].filter(e => e.checkVisibility({visibilityProperty: true})).length"
    used = """const corners = overlayNow().sections.flatMap(([, ...xy]) => xy);
        const sides = [0, 1].map(axis => { const some = corners.filter((_, k) => k % 2 === axis); return Math.max(...some) - Math.min(...some); });
        return sides.map((side, k) => side * stageWidth / pictureSize[0] / room[k]);"""
    with turnable(t, width=1280, height=720) as page:
        check(page.text("what") == "The arc is the film, bent: it starts at the left and ends at the right.", page.text("what"))
        check(page.run(shown) > 0, "the picture has no portraits")
        first = page.box("#picture")
        turn_to(page, (2, 46))
        check(page.box("#picture") == first, "the first live frames do not lie on the picture")
        for angle in ((-35, 38), (60, 20), (0, 90), (180, 40)):
            turn_to(page, angle)
            check(page.run(shown) == 0, f"{angle}: portraits are left")
            check(max(page.run(used)) > 0.7, f"{angle}: the volume has {page.run(used)} of the view")
            outside = page.run("""const view = document.getElementById('view').getBoundingClientRect();
                return [...document.querySelectorAll('#letters .note, #letters .badge')].filter(e => e.checkVisibility({visibilityProperty: true})).map(e => [e.textContent, e.getBoundingClientRect()])
                    .filter(([, b]) => b.left < view.left || b.right > view.right || b.top < view.top || b.bottom > view.bottom).map(([text]) => text);""")
            check(outside == [], f"{angle}: cut off: {outside}")
        check(page.text("what") == "The arc is the film, bent: it starts at the right and ends at the left.", page.text("what"))
        page.key("0")
        page.wait("all is back", "return angle[0] === 0")
        page.wait("as it was", "return document.querySelectorAll('#letters .portrait').length > 0", 5)
        page.set("angle", "unbent")
        page.wait("unbent", "return unbent && angle[1] === 28", 5)
        check(page.text("what") == "The box is the film: it starts at the left and ends at the right.", page.text("what"))
        check(page.complaints() == [], page.complaints())


def test_frames_that_are_seen_from_behind_say_so(t):
    bag(t)
    says = "return [...document.querySelectorAll('#letters .note')].filter(e => e.textContent === 'seen from behind').map(e => e.getBoundingClientRect().x)"
    with turnable(t, width=1280, height=800) as page:
        left, _, right, _ = page.box("#view")
        [x] = page.run(says)
        check(x > (left + right) / 2, "the picture's right end")
        turn_to(page, (180, 40))
        [x] = page.run(says)
        check(x > (left + right) / 2, "from the other side it is the first frame")


def test_volume_of_nothing(t):
    """2,000 layers in which nothing moves."""
    t.ffmpeg("-f", "lavfi", "-i", "color=c=gray:size=96x72:rate=50:duration=40", "-c:v", "libx264", "-pix_fmt", "yuv420p", "still.mp4")
    t.vvr("render", "still.mp4", "-o", "out.html", "--size", "320x200", "--layers", "2000", "--backend", "software").expect(0)
    with turnable(t) as page:
        turn_to(page, (-30, 40))
        check(page.run("return pickedAround(160, 90, 20).objects.every(object => object < 0)"), "an object of nothing")
        page.set("angle", "above")
        page.wait("from above", "return angle[1] === 90", 20)
        settled(page)
        check(page.complaints() == [], page.complaints())


def test_volume_of_a_hostile_name(t):
    bag(t)
    name = "in </script><img src=x onerror=alert(1)> `rm` $(ls) ü.mp4".replace("/", "\u2044")
    t.copy("bag.mp4", name)
    t.vvr("render", f"./{name}", "-o", "evil.html", "--size", "640x400", "--backend", "software").expect(0)
    with turnable(t, "evil.html") as page:
        turn_to(page, (-30, 40))
        page.allow_clipboard()
        page.open_menu("share")
        page.press("#copyview")
        copied = page.clipboard()
        check(f"'./{name}'" in copied or f"'{name}'" in copied, copied)
        check(page.text_of("h1") == name and page.count("img[src=x]") == 0, page.text_of("h1"))
        check(page.complaints() == [], page.complaints())
