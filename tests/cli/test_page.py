"""The page of a picture, in a real browser. Where there is no Chromium these are skipped, and say so."""

import os
import re

import pytest
from browser import Page
from harness import check, without_colours

SIZE = (192, 144)
RATE = 25
FRAMES = 250
TWENTY = range(7, FRAMES, 12)[:20]

# Straight from the side and without perspective, with time along x: then it is known where in the picture each moment is.
WIDTH, HEIGHT = 1200, 300
SIDE_VIEW = ("--layout", "box", "--camera", "0,0", "--fov", "0", "--size", f"{WIDTH}x{HEIGHT}", "--show", "volume",
             "--backend", "software")
H264 = ("-c:v", "libx264", "-bf", "3", "-pix_fmt", "yuv420p")
MSMPEG4 = ("-c:v", "msmpeg4v3", "-q:v", "2")


def column_of(share):
    """Of a moment, given as its share of the clip."""
    return WIDTH * (0.04 + 0.92 * share)


def row_of(row):
    """Of a row of the clip's picture, 0..1 from the top."""
    r_min, r_max = 0.45, 1
    length, high = 3.14159265 * (r_min + r_max) / 2, (r_max - r_min) * SIZE[1] / SIZE[0]
    return HEIGHT / 2 + (row - 0.5) * high * 0.92 * WIDTH / length


def brightest(t, clip):
    """The middle of what is bright in each frame of a clip, as shares of width and height."""
    grey = t.raw(clip, "gray", "-vsync", "passthrough")
    area = SIZE[0] * SIZE[1]
    middles = []
    for begin in range(0, len(grey), area):
        bright = [k for k, value in enumerate(grey[begin:begin + area]) if value > 140]
        middles.append((sum(k % SIZE[0] for k in bright) / len(bright) / SIZE[0],
                        sum(k // SIZE[0] for k in bright) / len(bright) / SIZE[1]))
    return middles


def discs(t, clip, *codec):
    """A clip with an object at another place each second. Returns where it is in each frame."""
    t.scene("one_object_a_second", "discs.y4m", "--size", f"{SIZE[0]}x{SIZE[1]}", "--frames", str(FRAMES))
    t.ffmpeg("-i", "discs.y4m", *codec, clip)
    places = brightest(t, "discs.y4m")
    check(len(places) == FRAMES, f"{len(places)} frames")
    t.path("discs.y4m").unlink()
    return places


def disc_page(t, clip="discs.mp4", codec=H264, *options):
    """The page out.html of such a clip. Returns where the object is in each frame."""
    places = discs(t, clip, *codec)
    t.vvr("render", clip, "-o", "out.html", *SIDE_VIEW, *options).expect(0)
    return places


def bag(t, *arguments):
    """A page of 16 s in which a bag is put down: three events."""
    t.scene("left_bag", "bag.y4m", "--size", "192x144", "--frames", "400")
    t.make("bag.mp4", "bag of pages", how=lambda: t.ffmpeg("-i", "bag.y4m", *H264, "bag.mp4"))
    command = ("render", "bag.mp4", "-o", "out.html", "--size", "640x400", "--backend", "software", *arguments)
    return t.make("out.html", "page of the bag", arguments, how=lambda: t.vvr(*command).expect(0, "3 events"))


def click_at_twenty(page, places, begin=0):
    """Clicks at 20 moments and holds the player's clock, and the frame that it shows, against the truth."""
    page.hold_still()
    for frame in TWENTY:
        clock, shown = page.click_and_look(column_of((frame + 0.5) / FRAMES), row_of(places[frame][1]))
        off = (clock - begin) * RATE - frame
        check(-1 < off < 2, f"frame {frame}: the clock stands {off} frames after its beginning")
        check(shown is not None and abs((shown - begin) * RATE - frame) < 1.01, f"frame {frame}: {shown} s is shown")
        check(clock >= shown - 1e-3 and clock < shown + 1 / RATE, f"frame {frame}: {clock} is not in the frame at {shown}")


@pytest.mark.browser
def test_page_plays_the_clip(t):
    places = disc_page(t)
    with Page(t, "out.html") as page:
        check(page.source() == "the original clip", page.source())
        frame = 100
        page.click(column_of((frame + 0.5) / FRAMES), row_of(places[frame][1]))
        page.wait("the clip plays", f"return !video.paused && video.currentTime > {(frame + 5) / RATE}")
        check(page.run("return now") >= frame + 2, "the page does not follow the player")
        click_at_twenty(page, places)
        check(page.complaints() == [], str(page.complaints()))
        strange = [url for url in page.requests() if not re.match("file:|data:|blob:", url)]
        check(strange == [], f"the page asks for {strange}")


@pytest.mark.browser
def test_page_points_at_moments(t):
    places = disc_page(t)
    with Page(t, "out.html") as page:
        for frame in TWENTY[::4]:
            page.point(column_of((frame + 0.5) / FRAMES), row_of(places[frame][1]))
            page.wait("a tip", "return !document.getElementById('tip').hidden")
            minutes, seconds = page.text("when").split(":")
            check(minutes == "0" and abs(float(seconds) - frame / RATE) <= 0.1 + 1 / RATE, f"{frame}: {page.text('when')}")
            check(page.run("return document.getElementById('peek').naturalWidth") > 100, "no still")
            page.wait("the frame itself", "return !peeker.hidden && !peeker.seeking")
            clock = page.run("return peeker.currentTime")
            check(-1 < clock * RATE - frame < 2, f"the film shows {clock} s at frame {frame}")
            check(page.box("#peeked") == page.box("#reel"), "it is not where the film is")
            left, top, right, bottom = page.box("#tip")
            check(bottom - top < 36, "the tip has more than a line")
        page.point(*page.run("return [contents[0] + 3, contents[1] + 3]"))
        page.wait("no tip where nothing is", "return document.getElementById('tip').hidden")
        check(page.run("return now") == 0 and page.run("return video.currentTime") == 0, "pointing plays")
        check(page.hidden("peeked"), "the film still shows what is no longer pointed at")


@pytest.mark.browser
def test_page_shows_a_preview_of_what_browsers_cannot_play(t):
    places = disc_page(t, "discs.avi", MSMPEG4)
    with Page(t, "out.html") as page:
        check("a small preview" in page.source(), page.source())
        click_at_twenty(page, places)
        # The preview's pixels can be read, so here is what a person sees: the object where it was in that frame.
        for frame in TWENTY:
            page.click_and_look(column_of((frame + 0.5) / FRAMES), row_of(places[frame][1]))
            x, y = page.run("""
                const canvas = document.createElement('canvas');
                [canvas.width, canvas.height] = [video.videoWidth, video.videoHeight];
                const context = canvas.getContext('2d');
                context.drawImage(video, 0, 0);
                const bytes = context.getImageData(0, 0, canvas.width, canvas.height).data;
                let count = 0, x = 0, y = 0;
                for (let k = 0; k < bytes.length / 4; ++k) {
                    if (bytes[4 * k] <= 140) continue;
                    ++count;
                    x += k % canvas.width;
                    y += Math.floor(k / canvas.width);
                }
                return [x / count / canvas.width, y / count / canvas.height];""")
            off = max(abs(x - places[frame][0]), abs(y - places[frame][1]))
            check(off < 0.02, f"frame {frame}: the object is at {x}, {y}, not at {places[frame]}")


@pytest.mark.browser
def test_page_of_a_clip_that_has_gone(t):
    places = disc_page(t)
    t.path("discs.mp4").unlink()
    with Page(t, "out.html") as page:
        check(page.source().startswith("the clip is not where it was, so this is a small preview"), page.source())
        click_at_twenty(page, places)
    # Another file of that name that is too short is not the clip.
    t.clip("discs.mp4", 2, codec=H264)
    with Page(t, "out.html") as page:
        check("a small preview" in page.source(), page.source())


@pytest.mark.browser
def test_page_of_stills(t):
    # So long and so slow that a preview would be no film.
    t.ffmpeg("-f", "lavfi", "-i", "testsrc=size=64x48:rate=1:duration=6500", "-c:v", "mpeg4", "long.avi")
    t.vvr("render", "long.avi", "-o", "out.html", "--size", "320x200", "--backend", "software", "--flow", "none", "--show",
          "volume,frames", timeout=110).expect(0)
    check(t.path("out.html").stat().st_size < 2_000_000, "stills are not small")
    with Page(t, "out.html") as page:
        check(page.source() == "this browser doesn’t play this kind of file, so this is a still", page.source())
        check(page.hidden("video") and not page.hidden("still"), "stills are not to be seen")
        page.run("show(3000, true)")
        near = page.run("return stillNear(parts.stills, 3000).frame")
        check(abs(near - 3000) <= 160, f"the nearest still is {near}")
        check(page.run("return still.src === stillNear(parts.stills, 3000).src && still.naturalWidth > 50"), "another still is shown")
        check(page.text("clock").startswith("50:0"), page.text("clock"))


@pytest.mark.browser
def test_page_of_a_variable_rate(t):
    # Frames come farther and farther apart; the container rounds their times.
    discs(t, "steady.mkv", *H264)
    for clip in ("varying.mp4", "varying.webm"):
        codec = H264 if clip.endswith("mp4") else ("-c:v", "libvpx", "-b:v", "1M", "-deadline", "realtime", "-cpu-used", "8")
        t.ffmpeg("-i", "steady.mkv", "-vf", "setpts='N*N/2500/TB+N/40/TB'", "-vsync", "vfr", "-enc_time_base", "1/1000",
                 *codec, clip)
        places = brightest(t, clip)
        times = [float(line.rstrip(",")) for line in t.probe(clip, "frame=pts_time", "-select_streams", "v").split()]
        check(len(times) == len(places), f"{len(times)} times of {len(places)} frames")
        t.vvr("render", clip, "-o", "out.html", *SIDE_VIEW).expect(0)
        with Page(t, "out.html") as page:
            check(page.source() == "the original clip", page.source())
            page.hold_still()
            for frame in TWENTY:
                _, shown = page.click_and_look(column_of((frame + 0.5) / len(times)), row_of(places[frame][1]))
                check(shown is not None, f"{clip}: frame {frame} is not shown")
                nearest = min(range(len(times)), key=lambda k, at=shown: abs(times[k] - times[0] - at))
                check(abs(nearest - frame) <= 1, f"{clip}: frame {frame} is to be shown, {nearest} is")


@pytest.mark.browser
def test_page_in_a_browser_that_tells_noise(t):
    places = disc_page(t)
    text = t.path("out.html").read_text()
    changed = re.sub(r'"sum":(\d+)', lambda found: f'"sum":{int(found[1]) + 1}', text)
    t.write("noise.html", changed)
    with Page(t, "out.html") as page:
        check(page.hidden("notice"), page.text("notice"))
        page.driver.get(t.path("noise.html").as_uri())
        page.wait("a notice", "return !document.getElementById('notice').hidden && document.getElementById('source').textContent !== ''")
        page.hold_still()
        page.click(column_of(0.5), row_of(places[125][1]))
        check(page.run("return moved") is False, "a click on noise goes somewhere")
        page.run("document.getElementById('strip').scrollIntoView()")
        page.run("""const box = strip.getBoundingClientRect();
            strip.dispatchEvent(new MouseEvent('click', {clientX: box.left + 1 + 0.5 * box.width, clientY: box.top + 5}))""")
        check(abs(page.run("return now") - 125) <= 1, f"the strip's middle is frame {page.run('return now')}")


@pytest.mark.browser
def test_page_of_a_part(t):
    places = disc_page(t, "discs.avi", MSMPEG4, "--start", "4s", "--end", "8s")
    with Page(t, "out.html") as page:
        check(page.text("summary") == "0:04 to 0:08, 4.0 s, 0 events; time of day not known", page.text("summary"))
        page.hold_still()
        for frame in (110, 130, 170, 190):
            _, shown = page.click_and_look(column_of((frame - 100 + 0.5) / 100), row_of(places[frame][1]))
            check(abs((shown + 4) * RATE - frame) < 1.01, f"frame {frame}: the preview shows {shown} s")
            check(abs(page.run("return now") - frame) <= 1, "the page counts from elsewhere")


@pytest.mark.browser
def test_page_steps_through_events(t):
    with Page(t, bag(t)) as page:
        from selenium.webdriver.common.keys import Keys
        check(page.text("heading") == "3 events", page.text("heading"))
        firsts = page.run("return data.events.map(event => event.first)")
        # The bag is put down at 354 of 1600 frames.
        check(abs(firsts[1] - 354 / 4) <= 5, f"the bag's event begins at {firsts[1]}")
        page.hold_still()
        for key, number in ((Keys.ARROW_RIGHT, 0), (Keys.ARROW_RIGHT, 1), (Keys.ARROW_RIGHT, 2), (Keys.ARROW_RIGHT, 2),
                            (Keys.ARROW_LEFT, 1), (Keys.ARROW_UP, 0), (Keys.ARROW_DOWN, 1)):
            page.key(key)
            check(page.run("return [chosen, now]") == [number, firsts[number]], f"{page.run('return [chosen, now]')}, not {number}")
            check(page.text("said").startswith(f"Event {number + 1}, {number + 1} of 3 in the list, from "), page.text("said"))
            page.wait("the player is there", f"return Math.floor(video.currentTime * 25 + 1e-6) === {firsts[number]}")
        check(page.run("return document.querySelectorAll('#events [aria-current=true]').length") == 1, "which is chosen?")
        page.run("show(150, false)")
        x, y = page.run("const r = document.getElementById('ring'); return [parseFloat(r.style.left), parseFloat(r.style.top)]")
        check(abs(x - 239 / 3.84) < 3 and abs(y - 228 / 2.88) < 3, f"the ring is at {x} %, {y} %")
        page.key(Keys.ESCAPE)
        check(page.run("return chosen") is None and page.hidden("ring"), "still chosen")
        # Everything can be reached by Tab, and has a name.
        reached = set()
        for _ in range(30):
            page.key(Keys.TAB)
            reached.add(page.run("return document.activeElement.id || document.activeElement.parentNode.tagName"))
        check({"view", "closer", "farther", "whole", "previous", "next", "LI"} <= reached, f"Tab reaches {reached}")
        nameless = page.run("""return [...document.querySelectorAll('button, [tabindex="0"], video')].filter(element =>
            !element.closest('[aria-hidden]') && !element.ariaLabel && !element.textContent.trim()).map(element => element.id)""")
        check(nameless == [], f"without a name: {nameless}")
        page.run("document.activeElement.blur(); video.play = HTMLVideoElement.prototype.play;")
        page.key(" ")
        page.wait("Space plays", "return !video.paused && video.currentTime > 0")


@pytest.mark.browser
def test_page_tells_which_object_it_is(t):
    with Page(t, bag(t, "--size", "960x600")) as page:
        portraits = page.run("return data.overlay.portraits")
        check({portrait["event"] for portrait in portraits} == {0, 1, 2}, f"{portraits}")
        colours = page.run("return data.events.map(event => event.colour)")
        check(len(set(colours)) == 3, f"{colours}")
        # The first part that stands for the bag is its portrait: pointing at it lights up the bag's trail alone.
        left, top, right, bottom = next(portrait["box"] for portrait in portraits if portrait["event"] == 1)
        page.point((left + right) / 2, (top + bottom) / 2)
        page.wait("the bag is named", "return document.getElementById('when').textContent.endsWith('2 left behind')")
        check(page.run("return chosen") is None, "pointing chooses")
        lit = page.run("""const shown = [0, 1, 2].map(() => [0, 0]);
            pixels.objects.forEach((object, k) => { if (object >= 0) ++shown[object][veilWords[k] === paleOf() ? 1 : 0]; });
            return shown;""")
        check(lit[1][0] > 100 and lit[1][1] == 0 and lit[0][0] == 0 and lit[2][0] == 0, f"lit and pale pixels: {lit}")
        page.hold_still()
        # A pixel of the third's trail chooses the third, and goes to the moment that it shows.
        x, y = page.run("""const mine = [];
            const {width, objects} = pixels;
            objects.forEach((object, k) => {
                if (object === 2) mine.push(k);
            });
            document.getElementById('letters').replaceChildren();  // numbers lie over trails
            const middle = mine[mine.length >> 1];
            return [middle % width, Math.floor(middle / width)];""")
        page.click(x + 0.5, y + 0.5)
        check(page.run("return chosen") == 2, f"{page.run('return chosen')} is chosen")
        first, last = page.run("return [data.events[2].first, data.events[2].last]")
        check(first <= page.run("return now") <= last, "another moment")


@pytest.mark.browser
def test_page_zooms_and_pans(t):
    places = disc_page(t)
    with Page(t, "out.html") as page:
        from selenium.webdriver.common.action_chains import ActionChains
        from selenium.webdriver.common.keys import Keys
        frame = TWENTY[12]
        spot = (column_of((frame + 0.5) / FRAMES), row_of(places[frame][1]))
        where = """const b = picture.getBoundingClientRect();
                   return [b.left + arguments[0] * b.width / pictureSize[0], b.top + arguments[1] * b.height / pictureSize[1], b.width]"""
        before = [round(value) for value in page.run(where, *spot)]
        page.run("""view.dispatchEvent(new WheelEvent('wheel', {deltaY: -900, clientX: arguments[0], clientY: arguments[1],
                    cancelable: true}))""", before[0], before[1])
        after = page.run(where, *spot)
        check(after[2] > 3 * before[2] and abs(after[0] - before[0]) < 4, f"zoomed from {before} to {after}")
        page.hold_still()
        clock, _ = page.click_and_look(*spot)
        check(-1 < clock * RATE - frame < 2, f"a click in the zoomed picture goes to {clock} s")
        asked = page.run("return now")
        x, y = round(after[0]), round(after[1])
        actions = ActionChains(page.driver)
        actions.w3c_actions.pointer_action.move_to_location(x, y).pointer_down().move_to_location(x - 60, y).pointer_up()
        actions.perform()
        moved = page.run(where, *spot)
        check(abs(moved[0] - after[0] + 60) < 3, f"dragged by {moved[0] - after[0]}, not by -60")
        check(page.run("return now") == asked, "a drag is no click")
        page.key("0")
        check(abs(page.run(where, *spot)[2] - before[2]) < 1, "0 does not show the whole picture")
        page.key("+")
        check(page.run(where, *spot)[2] > 1.4 * before[2], "+ does not zoom")
        left = page.run(where, *spot)[0]
        page.hold(Keys.SHIFT, Keys.ARROW_RIGHT)
        check(page.run(where, *spot)[0] < left - 40, "Shift and an arrow do not move the picture")
        check(page.run("return chosen") is None, "Shift and an arrow step through the events")


@pytest.mark.browser
def test_page_of_hostile_names(t):
    names = ["a \"b\" 'c' &amp; ü ñ 日本.mp4", "<script>alert(1)<%2Fscript>.mp4", "</title><img src=x onerror=alert(1)>.mp4",
             "--><!--{{name}}{{data}} #1?x=%41.mp4", "javascript:alert(1).mp4"]
    names = [name.replace("/", "\u2044") for name in names]
    t.clip("plain.mp4", 2, size="96x72", codec=H264)
    t.copy("plain.mp4", *names)
    t.path("in <b>").mkdir()
    for k, name in enumerate(names):
        t.vvr("render", f"./{name}", "-o", f"in <b>/page {k}.html", "--size", "320x200", "--backend",
              "software").expect(0)
    # A name that is no text at all.
    os.rename(t.path("plain.mp4"), bytes(t.folder) + b"/bad\xff.mp4")
    t.run([t.vvr_path, "render", b"bad\xff.mp4", "-o", "bad.html", "--size", "320x200"]).expect(0)
    with Page(t, "bad.html") as page:
        check(page.source() == "the original clip", page.source())
        for k, name in enumerate(names):
            page.open(t.path(f"in <b>/page {k}.html"))
            check(page.text_of("h1") == name, page.text_of("h1"))
            check(page.run("return document.title") == name, page.run("return document.title"))
            check(page.source() == "the original clip", f"{name}: {page.source()} {page.run('return data.clip')}")
            count = page.run("return [document.scripts.length, document.images.length, document.querySelectorAll('b').length]")
            plain = page.run("return [10, 4 + document.querySelectorAll('#events img, #letters img, #map img').length, document.querySelectorAll('#help b, #events b, #strip b, #letters b, #transport b').length + 1]")
            check(count == plain, f"{name}: the name made {count} of {plain} elements")
            check(page.complaints() == [], str(page.complaints()))


@pytest.mark.browser
def test_page_of_extracted_fields(t):
    t.clip("clip.avi", 2, size="96x72")
    for name, source in (("full", "a small preview"), ("bare", "a still, as there is no film")):
        t.vvr("extract", "clip.avi", "-o", name).expect(0)
        if name == "bare":
            without_colours(t, name)
        t.vvr("render", name, "-o", f"{name}.html", "--size", "320x200").expect(0)
        with Page(t, f"{name}.html") as page:
            check(page.source().startswith(source), page.source())


def test_page_is_whole_and_the_same(t):
    t.clip("clip.avi", 3, size="96x72")
    for name in ("a.html", "b.HTM"):
        t.render("clip.avi", "--backend", "software", output=name).expect(0, f"'{name}': 30 frames", "event")
    text = t.path("a.html").read_text()
    check(text == t.path("b.HTM").read_text(), "two pages of one clip differ")
    check(re.search("https?://(?!www.w3.org/2000/svg)", text) is None, "the page names an address")
    check(str(t.folder) not in text, "the page names a folder")
    check("vvr:" not in text and not re.search(r"\{\{[a-z ]+\}\}", text), "a place was left open")
    t.write("old.html", "older")
    t.render("none.avi", output="old.html").expect(2, code="file-not-found")
    check(t.path("old.html").read_text() == "older", "a failure touched the older page")
    t.expect_files("a.html", "b.HTM", "clip.avi", "old.html")


def test_page_that_cannot_be(t):
    t.clip()
    t.render("clip.avi", output="p.{brick}.html").expect(1, "'p.{brick}.html'", code="name-pattern-invalid")
    t.render("clip.avi", "--animate", "5", output="p.html").expect(1, "'p.html'", "--animate", code="options-conflict")
    t.render("clip.avi", output="none/p.html").expect(2, "'none/p.html'", "mkdir -p 'none'", code="file-not-found")
    t.render("clip.avi", "--report", "p.html", output="p.html").expect(1, "--report", "-o", "'p.html'", code="options-conflict")
    t.expect_files("clip.avi")
