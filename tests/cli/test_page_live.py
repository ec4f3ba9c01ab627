"""The page of a stream: it looks for news, fetches them when there are any, and tells its age by the server's clock."""

import os
import re
import time

import pytest
from browser import Page, Served
from harness import check
from test_page_looks import expect_names, expect_readable
from test_page_turning import SOFTWARE
from test_watch import Watch, source

pytestmark = pytest.mark.browser


class Live(Page):
    """The page of a stream."""

    READY = "return document.documentElement.dataset.ready !== undefined"


def page_of(t, name, seconds, *options, ended=False):
    """What is on the disk when a stream of so many seconds has ended."""
    source(t, "cam.ts", seconds=seconds)
    Watch(t, "cam.ts", "-o", name, "--brick", "1s", "--window", "3", "--size", "480x300", "--backend", "software", *options).end()
    if not ended:
        text = t.path(name).read_text()
        check('"ended":true' in text, "a page says that its stream has ended")
        t.write(name, text.replace('"ended":true', '"ended":false'))
    return name


def written_at(t, name, when):
    """Says in the page when it was written."""
    text = t.path(name).read_text()
    check(len(re.findall(r'"written":\d+', text)) == 1, "a page says once when it was written")
    t.write("part", re.sub(r'"written":\d+', f'"written":{int(when)}', text))
    os.replace(t.path("part"), t.path(name))


def asked(served, method):
    return [size for kind, path, size in served.asked if kind == method and path.startswith("/live.html")]


def test_live_page_fetches_when_there_is_news(t):
    page_of(t, "live.html", 6)
    page_of(t, "later.html", 12)
    size = t.path("live.html").stat().st_size
    with Served(t.folder) as served, Live(t, served.url("live.html")) as page:
        check(page.text("livestate") == "learning the empty scene", page.text("livestate"))
        begin = len(asked(served, "HEAD"))
        time.sleep(4)
        heads = len(asked(served, "HEAD")) - begin
        check(2 <= heads <= 8, f"it asked {heads} times in 4 s for news")
        check(asked(served, "GET") == [size], f"it fetched {asked(served, 'GET')} bytes, though nothing changed")
        frames = page.run("return [time.firstFrame, time.lastFrame]")
        # News: the same page goes on with it, and keeps what was asked of it.
        page.set("speed", "4")
        page.run("window.same = true")
        old = page.run("return picture.src")
        os.replace(t.path("later.html"), t.path("live.html"))
        page.wait("the news", f"return time.firstFrame > {frames[0]}")
        page.wait("the picture is read", "return pixels !== null")
        check(page.run("return window.same && document.getElementById('speed').value === '4'"), "it was loaded again as a whole")
        check(page.run("return picture.src") != old, "the picture is the old one")
        check(page.text("livestate") == "watching", page.text("livestate"))
        check(page.count("#events .row") == page.run("return data.events.length"), "the list is the old one")
        check(re.fullmatch(r".*, \d+ events?;.*", page.text("summary")), page.text("summary"))
        check(len(asked(served, "GET")) == 2, f"{len(asked(served, 'GET'))} pages were fetched for one piece of news")
        # It is a page to point at and to click on, as that of a clip.
        pixel, width = page.run("return [pixels.frames.findIndex((frame, k) => k > pixels.frames.length / 2 && frame > time.firstFrame), pixels.width]")
        y, x = divmod(pixel, width)
        page.point(x + 0.5, y + 0.5)
        page.wait("a tip", "return !document.getElementById('tip').hidden")
        page.click(x + 0.5, y + 0.5)
        check(page.run("return moved && isPlaying() && now >= time.firstFrame"), "a click plays nothing")
        check([line for line in page.complaints() if "404" not in line] == [], str(page.complaints()))
        print(f"{size} bytes for each piece of news, {heads} questions of no bytes in 4 s")


@pytest.mark.parametrize("ahead", [-3600, 0, 7200])
def test_live_page_tells_its_age_by_the_clock_of_the_server(t, ahead):
    page_of(t, "live.html", 6)
    with Served(t.folder) as served:
        served.ahead = ahead
        with Live(t, served.url("live.html")) as page:
            written_at(t, "live.html", time.time() + ahead - 2)
            page.wait("its age", "return /^· updated \\d s ago$/.test(document.getElementById('age').textContent)", 5)
            check(page.run("return document.getElementById('state').className") == "", "it is said to be old")
            written_at(t, "live.html", time.time() + ahead - 300)
            page.wait("it is old", "return /^· no new picture for 30\\d s$/.test(document.getElementById('age').textContent)", 8)
            check(page.run("return document.getElementById('state').className") == "old", "old, and not marked")


def test_live_page_is_readable_and_says_what_it_shows(t):
    page_of(t, "front <b>gate.html", 6, "--title", "a\u202egpj <i>gate</i>")
    with Live(t, "front <b>gate.html") as page:
        # What is watched is a finished file here, so nothing tells its date.
        check(page.text_of("h1") == "a[U+202E]gpj <i>gate</i>" and page.count("h1 *") == 0, page.text_of("h1"))
        expect_readable(page, 10)
        expect_names(page)


def test_live_page_follows_now_unless_one_looks_back(t):
    page_of(t, "live.html", 6)
    page_of(t, "later.html", 12)
    with Served(t.folder) as served, Live(t, served.url("live.html")) as page:
        check(page.run("return [now === time.lastFrame, follows, moved]") == [True, True, True], "it opens in the past")
        check(page.hidden("tonow"), "a way to now, at now")
        page.run("zoomStrip(0.3, 1)")
        lasts = page.run("return stripLasts")
        os.replace(t.path("later.html"), t.path("live.html"))
        first = page.run("return time.firstFrame")
        page.wait("the news", f"return time.firstFrame > {first}")
        check(page.run("return now === time.lastFrame"), "it does not follow")
        check(abs(page.run("return stripLasts") - lasts) < 1e-6, "the strip's zoom is lost")
        page.run("show(time.firstFrame, true)")
        check(not page.hidden("tonow"), "no way to now")
        begin = page.run("return now")
        page.wait("it plays", f"return now > {begin}")
        page.press("#tonow")
        check(page.run("return [now === time.lastFrame, isPlaying()]") == [True, False], "it does not go to now")


def test_live_page_changes_picture_and_veil_together(t):
    page_of(t, "live.html", 6)
    page_of(t, "later.html", 12)
    with Served(t.folder) as served, Live(t, served.url("live.html")) as page:
        page.run("""choose(0);
            window.seen = [];
            const [old, first] = [picture.src, time.firstFrame];
            const look = () => {
                window.seen.push([picture.src !== old, vvr.state.time.firstFrame !== first, vvr.state.pixels !== null]);
                requestAnimationFrame(look);
            };
            requestAnimationFrame(look);""")
        os.replace(t.path("later.html"), t.path("live.html"))
        page.wait("the news", "return window.seen.filter(([picture, time]) => picture && time).length > 5")
        seen = page.run("return window.seen")
        check(all(pixels for *_, pixels in seen), "a veil without pixels")
        apart = sum(picture != time for picture, time, _ in seen)
        check(apart <= 2, f"{apart} of {len(seen)} times the picture was of another time than its veil")


def test_live_page_does_not_talk_each_second(t):
    """A screen reader reads what changes in a status; the age changes each second, and is none."""
    page_of(t, "live.html", 4)
    with Served(t.folder) as served, Live(t, served.url("live.html")) as page:
        page.run("""window.said = [];
            window.ages = 0;
            new MutationObserver(() => said.push(livestate.textContent)).observe(livestate, {childList: true, characterData: true, subtree: true});
            new MutationObserver(() => ++ages).observe(age, {childList: true, characterData: true, subtree: true});""")
        page.wait("its age", "return window.ages >= 3", 10)
        check(page.run("return window.said") == [], f"it says {page.run('return window.said')}")
        check(page.run("return age.closest('[role=status], [aria-live]')") is None, "the age is a status")


def test_live_page_says_how_long_an_event_has_lasted(t):
    """Not only within the last bricks, which are all that the page shows."""
    t.scene("stands", "stands.y4m", "--size", "192x144", "--frames", "400", "--noise", "2")  # without noise, a still picture counts as frozen
    t.ffmpeg("-i", "stands.y4m", "-c:v", "libx264", "-preset", "ultrafast", "-pix_fmt", "yuv420p", "-g", "25", "cam.ts")
    Watch(t, "cam.ts", "-o", "live.html", "--brick", "1s", "--window", "4", "--size", "480x300", "--backend", "software").end()
    with Live(t, "live.html") as page:
        first, begins, lasts, still = page.run("return [events[0].first, time.firstFrame, events[0].end - events[0].begin, events[0].still]")
        check(first < begins and lasts > still > 4, f"it stood for {still} of {lasts} s, from frame {first} on; the page begins at {begins}")
        check(page.texts("#events .lasts")[0] == f" · {lasts:.0f} s", f"{page.texts('#events .lasts')}: {lasts} s")
        # A screen reader hears of the same time that the list has.
        began = page.run("return time.clockOf(events[0].begin)")
        page.run("document.getElementById('next').click()")
        check(f", from {began} to " in page.text("said"), f"{page.text('said')}, not {began}")
        check(began[:-2] in page.texts("#events .row b")[0], f"{page.texts('#events .row b')}, not {began}")


def test_live_page_says_when_the_stream_has_ended(t):
    page_of(t, "live.html", 4, ended=True)
    with Served(t.folder) as served, Live(t, served.url("live.html")) as page:
        check([page.text("livestate"), page.text("age")] == ["the stream has ended", ""], page.text("state"))
        begin = len(asked(served, "HEAD"))
        time.sleep(2.5)
        check(len(asked(served, "HEAD")) - begin <= 1, "it still asks for news")


def test_live_page_of_a_file_keeps_what_one_did(t):
    """It opens itself again for each brick, and no more often."""
    page_of(t, "live.html", 6)
    with Live(t, "live.html") as page:
        page.run("window.old = true; set({leastSeconds: 2, follows: false, now: time.firstFrame + 3, scale: 2})")
        page.wait("it opened itself again", "return window.old === undefined && document.documentElement.dataset.ready !== undefined")
        kept = page.run("return [leastSeconds, follows, now - time.firstFrame, scale]")
        check(kept == [2, False, 3, 2], f"{kept}")
        check(page.complaints() == [], str(page.complaints()))


def films(t, name="live"):
    return sorted(path.name for path in t.path(".").glob(f"{name}.film-*"))


def test_live_page_plays_a_film_of_its_window(t):
    """One small file per brick; older ones are replaced, and nothing else is touched."""
    for name in ("live.film-9.mp4", "live.film-0.txt", "other.film-0.mp4"):
        t.write(name, "not ours")
    page_of(t, "live.html", 9)
    ours = [f"live.film-{place}.mp4" for place in range(5)]  # three bricks, and two that an older page may still ask for
    check(films(t) == sorted([*ours, "live.film-9.mp4", "live.film-0.txt"]), f"{films(t)}")
    for name in ("live.film-9.mp4", "live.film-0.txt", "other.film-0.mp4"):
        check(t.path(name).read_text() == "not ours", f"{name} was written")
    with Served(t.folder) as served, Live(t, served.url("live.html")) as page:
        page.wait("a film", "return film !== null && !stills")
        check(page.source() == "a film of the last bricks", page.source())
        check(page.run("return film.files.length") == 3, f"{page.run('return film.files')}")
        page.wait("it shows now", "return follows && now === time.lastFrame && video.readyState > 1 && !video.seeking")
        # From the first brick into the next one.
        page.run("show(time.firstFrame, true, {until: null})")
        page.wait("it plays", "return now > time.firstFrame + 3")
        first = page.run("return film.segment[0]")
        page.wait("it goes on in the next file", f"return film.segment[0] !== {first!r} && now > time.firstFrame + 30")
        check([line for line in page.complaints() if "404" not in line] == [], str(page.complaints()))


def test_live_page_goes_on_with_newer_films(t):
    page_of(t, "live.html", 6)
    page_of(t, "later.html", 12)
    with Served(t.folder) as served, Live(t, served.url("live.html")) as page:
        page.wait("a film", "return film !== null")
        first = page.run("return time.firstFrame")
        os.replace(t.path("later.html"), t.path("live.html"))
        page.wait("the news", f"return time.firstFrame > {first}")
        page.wait("its newest film", "return video.currentSrc.includes('later.film-') && video.readyState > 1 && !video.seeking")
        check(page.run("return [follows, now === time.lastFrame, isPlaying()]") == [True, True, False], "it does not follow")


@pytest.mark.nightly
def test_live_page_turns_and_takes_newer_voxels(t):
    page_of(t, "live.html", 6)
    page_of(t, "later.html", 12)
    # Points of the paths of events, and what the volume shows there.
    shown = """return events.flatMap((event, place) => pathOf(event).map(pixelAt).map(([x, y]) => {
        const view = document.getElementById('view').getBoundingClientRect();
        const box = picture.getBoundingClientRect();
        const scale = box.width / pictureSize[0];
        return [place, ...pickedAround(box.left + x * scale - view.left, box.top + y * scale - view.top, 2).objects];
    }));"""
    with Served(t.folder) as served, Live(t, served.url("live.html"), *SOFTWARE) as page:
        page.window(500, 500)
        page.wait("its voxels", "return parts.volume !== null")
        page.run("prepareVolume(1e6)")
        page.wait("it can be turned", "return turnable", 60)
        for news in (False, True):
            if news:
                first = page.run("return time.firstFrame")
                os.replace(t.path("later.html"), t.path("live.html"))
                page.wait("the news", f"return time.firstFrame > {first}", 60)
            page.run("set({turns: true, angle: [-30, 40]})")
            points = page.run(shown)
            right = sum(place in found for place, *found in points)
            check(len(points) > 5 and right > 0.6 * len(points), f"news: {news}; {right} of {len(points)} points show their event")
        check(page.run("return [turns, ...angle]") == [True, -30, 40], "the angle is lost")


def test_a_live_page_without_a_name_is_live(t):
    source(t, "cam.ts", seconds=4)
    for more, heading in (((), "Live · "), (("--camera-name", "gate"), "gate · ")):
        with open(t.path("cam.ts"), "rb") as clip:
            Watch(t, "-", "-o", "live.html", "--brick", "1s", "--size", "480x300", "--backend", "software", *more, stdin=clip).end()
        text = t.path("live.html").read_text()
        check(f"<h1>{heading}" in text and f"<title>{heading}" in text, re.search("<h1>.*</h1>", text)[0])
        check("stdin" not in re.sub("<script>.*?</script>", "", text, flags=re.DOTALL).split('id="data"')[0], "it speaks of stdin")
