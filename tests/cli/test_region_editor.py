"""vvr inspect -o roi.html: regions drawn on a frame become the option that vvr takes."""

import base64
import re

import pytest
from browser import Page
from harness import check, moving_clip, page_data

SIZE = (320, 240)


def clip(t, name="clip.mkv"):
    """A square that crosses an empty scene at half height."""
    t.ffmpeg("-f", "lavfi", "-i", f"color=gray:size={SIZE[0]}x{SIZE[1]}:rate=10:duration=4", "-f", "lavfi", "-i",
             "testsrc2=size=40x40:rate=10:duration=4", "-filter_complex", "[0][1]overlay=x='8*n-40':y=100", "-c:v", "ffv1", name)
    return name


def test_inspect_makes_a_region_editor(t):
    clip(t)
    t.vvr("inspect", "clip.mkv", "--frame", "2s", "-o", "roi.html").expect(
        0, "vvr: 'roi.html': a page to draw regions on frame 20 at 2.000 s")
    page = t.path("roi.html").read_text()
    check('viewBox="0 0 320 240"' in page and "clip.mkv" in page and "at 0:02, 320×240 pixels" in page, page[:2000])
    check(page_data(page) == {"option": "roi", "regions": ""}, "data")
    check(not re.search(r"https?://(?!www\.w3\.org/)", page), "the page leads elsewhere")
    t.vvr("inspect", "clip.mkv", "--frame", "2s", "-o", "again.html").expect(0)
    check(page == t.path("again.html").read_text(), "the same input gives another page")


def test_region_editor_shows_the_frame_itself(t):
    clip(t)
    t.vvr("inspect", "clip.mkv", "--frame", "20f", "-o", "roi.html").expect(0)
    found = re.search(r'src="data:image/jpeg;base64,([^"]+)"', t.path("roi.html").read_text())[1]
    shown = t.raw(t.write("frame.jpg", base64.b64decode(found)), "gray")
    true = t.raw("clip.mkv", "gray", "-vf", "select=eq(n\\,20)", "-frames:v", "1")
    check(len(shown) == len(true) == SIZE[0] * SIZE[1], "another size")
    off = sum(abs(a - b) for a, b in zip(shown, true)) / len(true)
    check(off < 3, f"another frame: {off} grey levels")


def test_region_editor_of_what_cannot_be(t):
    clip(t)
    t.vvr("inspect", "clip.mkv", "-o", "roi.html").expect(
        0, "a page to draw regions on frame 20 at 2.000 s; --frame TIME chooses another")
    t.path("roi.html").unlink()
    t.vvr("inspect", "clip.mkv", "--frame", "9s", "-o", "roi.html").expect(
        1, "--frame", "'clip.mkv'", "40 frames", "3.900 s", code="option-value-out-of-range")
    t.vvr("inspect", "clip.mkv", "--frame", "1s", "--roi", "1,2 3,4", "-o", "roi.html").expect(
        1, "--roi", "character 8", "1,2 3,4", code="option-value")
    t.vvr("inspect", "clip.mkv", "--frame", "1s", "-o", "no/roi.html").expect(2, "'no/roi.html'", "mkdir -p 'no'", code="file-not-found")
    t.expect_files("clip.mkv")
    t.ffmpeg("-i", "clip.mkv", "-frames:v", "1", "area.png")
    t.vvr("inspect", "clip.mkv", "--frame", "1s", "--roi", "area.png", "-o", "roi.html").expect(
        0, "warning: --roi 'area.png' is a picture, which the page can't edit")


class Editor(Page):
    """The page with what a person does on its frame, in the clip's pixels."""

    READY = "return document.documentElement.dataset.ready !== undefined"
    kind = "mouse"  # or touch

    def screen(self, x, y):
        left, top, wide, high = self.run("const b = drawing.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]")
        return round(left + x * wide / SIZE[0]), round(top + y * high / SIZE[1])

    def actions(self):
        from selenium.webdriver.common.action_chains import ActionChains
        from selenium.webdriver.common.actions.action_builder import ActionBuilder
        from selenium.webdriver.common.actions.pointer_input import PointerInput
        chain = ActionChains(self.driver, duration=0)
        chain.w3c_actions = ActionBuilder(self.driver, mouse=PointerInput(self.kind, self.kind), duration=0)
        return chain, chain.w3c_actions.pointer_action

    def drag(self, a, b):
        chain, pointer = self.actions()
        pointer.move_to_location(*self.screen(*a)).pointer_down()
        pointer.move_to_location(*self.screen((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)).move_to_location(*self.screen(*b)).pointer_up()
        chain.perform()

    def tap(self, *points):
        chain, pointer = self.actions()
        for point in points:
            pointer.move_to_location(*self.screen(*point)).pointer_down().pointer_up()
        chain.perform()

    def press(self, selector):
        self.run("document.querySelector(arguments[0]).click()", selector)

    def option(self):
        return self.run("return document.getElementById('option').value")

    def corners(self):
        """Of each region of the option."""
        return [[tuple(map(int, point.split(","))) for point in part.split()] for part in self.option().split('"')[1].split(";")]


def near(found, wanted, slack=1):
    return len(found) == len(wanted) and all(abs(a - b) <= slack for f, w in zip(found, wanted) for a, b in zip(f, w))


def editor(t, *arguments):
    clip(t)
    t.vvr("inspect", "clip.mkv", "--frame", "2s", "-o", "roi.html", *arguments).expect(0)
    return Editor(t, "roi.html")


@pytest.mark.browser
@pytest.mark.parametrize("kind", ["mouse", "touch"])
def test_region_editor_by_pointer(t, kind):
    with editor(t) as page:
        page.kind = kind
        check(page.option() == "" and page.run("return document.getElementById('copy').disabled"), "begins with a region")
        page.drag((40, 30), (120, 90))
        check(page.option().startswith('--roi "') and near(page.corners()[0], [(40, 30), (120, 30), (120, 90), (40, 90)]), page.option())
        page.drag((80, 60), (100, 80))  # the region
        check(near(page.corners()[0], [(60, 50), (140, 50), (140, 110), (60, 110)], 2), page.option())
        page.drag((140, 110), (200, 150))  # its corner
        check(near(page.corners()[0], [(60, 50), (200, 50), (200, 150), (60, 150)], 3), page.option())
        page.drag((100, 100), (-4, 100))  # out of the picture
        left = min(x for x, _ in page.corners()[0])
        check(left == 0 and max(x for x, _ in page.corners()[0]) in range(137, 144), page.option())
        page.press("[name=tool][value=polygon]")
        page.tap((220, 20), (300, 40), (290, 120))
        check(len(page.corners()) == 1, "a polygon that is not closed counts")
        page.tap((220, 20))
        check(near(page.corners()[1], [(220, 20), (300, 40), (290, 120)]), page.option())
        check(kind == "touch" or "x " in page.text("place"), page.text("place"))  # fingers do not hover
        page.press("[name=option][value=mask]")
        check(page.option().startswith('--mask "'), page.option())
        page.press("[data-key='delete 0']")
        check(len(page.corners()) == 1 and len(page.corners()[0]) == 3, page.option())
        page.press("#undo")
        check(len(page.corners()) == 2, page.option())
        page.press("#clear")
        check(page.option() == "", page.option())
        page.tap((20, 20))  # one corner
        page.key("\ue00c")  # Escape
        check(page.option() == "" and page.complaints() == [], f"{page.option()} {page.complaints()}")
        check(all(re.match("file:|data:", url) for url in page.requests()), str(page.requests()))


@pytest.mark.browser
def test_region_editor_by_keys(t):
    with editor(t) as page:
        from selenium.webdriver.common.keys import Keys
        page.run("document.getElementById('add').focus()")
        page.key(Keys.ENTER)
        check(page.corners() == [[(96, 72), (192, 72), (192, 144), (96, 144)]], page.option())
        page.run("document.querySelector('[data-key=\"region 0\"]').focus()")
        page.key(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_DOWN)
        check(page.corners()[0][0] == (98, 73), page.option())
        page.hold(Keys.SHIFT, Keys.ARROW_LEFT)
        check(page.corners()[0][0] == (88, 73), page.option())
        page.key(Keys.TAB)
        page.key(Keys.ARROW_LEFT, Keys.ARROW_UP)  # its first corner
        check(page.corners()[0] == [(87, 72), (184, 72), (184, 145), (87, 145)], page.option())
        page.press("#corner")
        check(page.corners()[0] == [(87, 72), (136, 72), (184, 72), (184, 145), (87, 145)], page.option())
        page.run("document.querySelector('[data-key=\"row 0\"]').focus()")
        page.key(Keys.DELETE)
        check(page.option() == "", page.option())
        page.hold(Keys.CONTROL, "z")
        check(len(page.corners()[0]) == 5, page.option())
        said = page.run("return [...document.querySelectorAll('svg [tabindex]')].map(e => e.getAttribute('aria-label'))")
        check(said[0].startswith("Region 1: 5 corners"), str(said))


@pytest.mark.browser
def test_region_editor_gives_what_vvr_takes(t):
    """The whole way: draw, copy, render; a region beside the way of the square shows nothing, one on it shows it."""
    with editor(t, "--roi", "10,170 300,170 300,230 10,230; 10,5 300,5 150,60") as page:
        check(page.option() == '--roi "10,170 300,170 300,230 10,230; 10,5 300,5 150,60"', page.option())
        beside = page.option().split('"')[1]
        page.press("#clear")
        page.drag((5, 80), (315, 160))
        across = page.option().split('"')[1]
        page.press("[name=option][value=mask]")
        mask = page.option().split('"')[1]
    found = {}
    for name, option, area in (("beside", "--roi", beside), ("across", "--roi", across), ("mask", "--mask", mask)):
        t.vvr("render", "clip.mkv", option, area, "--report", "report.json").expect(0)
        found[name] = len(t.json("report.json")["events"])
    check(found["beside"] == 0 and found["across"] == 1 and found["mask"] == 0, str(found))


@pytest.mark.browser
def test_region_editor_copies(t):
    with editor(t, "--mask", "10,10 50,10 50,50") as page:
        check(page.option() == '--mask "10,10 50,10 50,50"', page.option())
        page.allow_clipboard()
        page.press("#copy")
        page.wait("it is copied", "return document.getElementById('said').textContent === 'Copied.'")
        check(page.clipboard() == '--mask "10,10 50,10 50,50"', page.clipboard())


@pytest.mark.browser
def test_region_editor_looks(t):
    """Nothing is cut off in small windows; hostile names stay names."""
    name = "a\"><script>document.title='gone'<b>'.mkv"
    clip(t)
    t.path("clip.mkv").rename(t.path(name.replace("/", "_")))
    t.vvr("inspect", name, "--frame", "2s", "-o", "roi.html", "--roi", "10,10 50,10 50,50").expect(0)
    with Editor(t, "roi.html") as page:
        check(page.run("return document.title").startswith("Regions of a\"><script>"), page.run("return document.title"))
        for width, height in ((1440, 900), (800, 600), (390, 844)):
            page.window(width, height)
            page.wait("it fits", "return document.documentElement.scrollWidth <= innerWidth"
                      " && drawing.getBoundingClientRect().bottom <= innerHeight")
            box = page.run("const b = drawing.getBoundingClientRect(); return [b.width, b.height]")
            check(abs(box[0] / box[1] - SIZE[0] / SIZE[1]) < 0.02, f"{width}: {box}")
            check(box[0] >= 350, f"{width}: the frame is {box[0]} wide")
        check(page.complaints() == [], str(page.complaints()))


def test_areas_come_from_a_text_file(t):
    moving_clip(t)
    t.write("areas.txt", "# where it begins\n0,0 30,0 30,64 0,64\n\n60,0 96,0 96,64 60,64   # where it ends\n")
    t.render("clip.mkv", "--roi", "0,0 30,0 30,64 0,64; 60,0 96,0 96,64 60,64", "--show", "volume", output="text.png").expect(0)
    t.render("clip.mkv", "--roi", "areas.txt", "--show", "volume", output="file.png").expect(0)
    t.render("clip.mkv", "--show", "volume", output="all.png").expect(0)
    check(t.rgb("text.png") == t.rgb("file.png") != t.rgb("all.png"), "the file does not say the same")
    t.vvr("inspect", "clip.mkv", "--frame", "1s", "--mask", "areas.txt", "-o", "roi.html").expect(0)
    check("0,0 30,0 30,64 0,64" in t.path("roi.html").read_text(), "the page begins without the areas")
    t.write("two.txt", "0,0 30,0\n")
    t.render("clip.mkv", "--roi", "two.txt").expect(1, "--roi", "'two.txt'", code="option-value")
    t.render("clip.mkv", "--mask", "none.txt").expect(2, "--mask", "none.txt", "No such file or directory", code="file-not-found")


def test_a_picture_is_an_area_where_it_is_128_or_brighter(t):
    moving_clip(t)
    t.ffmpeg("-f", "lavfi", "-i", "color=0x808080:size=10x10", "-frames:v", "1", "grey128.png")
    t.ffmpeg("-f", "lavfi", "-i", "color=0x7f7f7f:size=10x10", "-frames:v", "1", "grey127.png")
    t.render("clip.mkv", "--roi", "grey128.png", "--show", "volume", output="in.png").expect(0)
    t.render("clip.mkv", "--show", "volume", output="all.png").expect(0)
    t.render("clip.mkv", "--roi", "grey127.png", "--show", "volume", output="out.png").expect(0, "nothing moves in the region of interest")
    check(t.rgb("in.png") == t.rgb("all.png"), "grey 128 does not count")
