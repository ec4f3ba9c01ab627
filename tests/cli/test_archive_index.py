"""The index of an archive, in a real browser. Where there is no Chromium these are skipped, and say so."""

import json
import os
import time
import urllib.parse

import pytest
from browser import Page
from harness import check

pytestmark = pytest.mark.browser

HOUR = 3600
NOW = 1795248000  # 2026-11-21 08:00 UTC


class Index(Page):
    """The page that lists the clips."""

    READY = "return document.querySelector('#days .day, #days .empty') !== null"

    def filter(self, text):
        self.run("const box = document.getElementById('text'); box.value = arguments[0]; box.dispatchEvent(new Event('input'))", text)
        self.wait("the filter", f"return vvr.state.text === {json.dumps(text)}")


def known(t, clip, begins, **more):
    """A sidecar as `vvr archive` writes it, and the page that it names."""
    name = os.path.basename(clip)
    sidecar = {"vvr-archive": 1, "vvr": "0.1.0", "clip": {"path": clip, "bytes": 1, "modified_ns": (begins + 600) * 10**9},
               "settings": "s", "state": "done", "tries": 1, "status": 0, "reason": None, "took_seconds": 1, "frames": 1, "damaged": 0,
               "seconds": 600, "events": 0, "recorded": None,
               "files": {"picture": f"{name}.png", "page": f"{name}.html", "thumbnail": f"{name}.jpg"}} | more
    path = os.fsencode(t.path("out")) + b"/" + urllib.parse.unquote_to_bytes(clip) + b".json"
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        json.dump(sidecar, file, indent=2)


def write_index(t):
    t.vvr("archive", "-o", "out", "--write", "index").expect(0, "is up to date")


def files_of(page, selector=".card .facts"):
    """The paths of the clips on the cards, which are tooltips."""
    return page.run("return [...document.querySelectorAll(arguments[0])].map(facts => facts.title)", selector)


def opened(t, cards=None):
    """The index, once it has so many cards."""
    t.zone("UTC")
    page = Index(t, "out/index.html")
    if cards is not None:
        page.wait("cards", f"return document.querySelectorAll('.card').length === {cards}")
    return page


def test_index_lists_by_day_and_camera(t):
    known(t, "gate/2026-11-20/a.avi", NOW - 20 * HOUR, events=2)
    known(t, "gate/b.avi", NOW - HOUR, events=1, damaged=2)
    known(t, "hall/c.avi", NOW, events=None)
    known(t, "hall/bad.avi", NOW - 2 * HOUR, state="failed", tries=3, status=3, reason="'bad.avi' is not a video", files={})
    known(t, "d.avi", NOW - 30 * HOUR, recorded="2026-11-21 07:30:00", seconds=12.3)
    write_index(t)
    t.write("out/gate/b.avi.html", "<title>the page of b</title>")
    with opened(t) as page:
        check(page.texts("#days h2") == ["Saturday, 2026-11-21 4 clips", "Friday, 2026-11-20 1 clip"], str(page.texts("#days h2")))
        page.wait("cards", "return document.querySelectorAll('.card').length === 5")
        # All cameras of a day together, the newest first, failures last.
        captions = ["08:00hall", "07:30(top folder)no events", "07:00gate1 event", "06:10hall", "12:00gate2 events"]
        check(page.texts(".card .first") == captions, str(page.texts(".card .first")))
        check(page.texts(".badge") == ["damaged"], str(page.texts(".badge")))
        check(page.texts(".length") == ["10:00 min", "12 s", "10:00 min", "10:00 min"], str(page.texts(".length")))
        check(page.texts(".failed .reason") == ["Failed 3 times'bad.avi' is not a video"], str(page.texts(".reason")))
        check(page.text("summary") == "5 clips · 3 cameras · 3 events · 1 failure · times in UTC, "
              "from when files were last written (4), creation times in containers (1)", page.text("summary"))
        page.filter("HALL bad")
        page.wait("one", "return document.querySelectorAll('.card').length === 1")
        check(files_of(page) == ["hall/bad.avi"], str(files_of(page)))
        check(page.text("count") == "1 of 5 clips", page.text("count"))
        page.filter("11-20")
        page.wait("one", "return document.querySelectorAll('.card').length === 1")
        check(files_of(page) == ["gate/2026-11-20/a.avi"], str(files_of(page)))
        page.filter("")
        page.run("document.querySelector('[value=failed]').click()")
        check(page.text("count") == "1 of 5 clips", page.text("count"))
        page.run("document.querySelector('[value=events]').click()")
        page.run("[...document.querySelectorAll('#cameras button')].find(b => b.textContent.startsWith('gate')).click()")
        page.wait("two", "return document.querySelectorAll('.card').length === 2")
        # A clip's page, and back to what was asked for. A page that is still loading would have no place in the history.
        page.wait("it is loaded", "return document.readyState === 'complete'")
        page.run("document.querySelector('a.card').click()")
        page.wait("the clip's page", "return document.title === 'the page of b'")
        page.run("history.back()")
        page.wait("back again", "return document.querySelectorAll('.card').length === 2")
        check(page.text("count") == "2 of 5 clips", page.text("count"))


def test_index_of_a_redraw_that_failed(t):
    """The picture is there, and the index says until when it shows the clip."""
    until = (NOW - HOUR) * 10**9
    known(t, "gate/a.avi", NOW, state="failed", tries=2, status=5, reason="it took longer", events=1,
          shows={"bytes": 1, "modified_ns": until, "settings": "s"})
    known(t, "gate/2026-11-21", NOW, day={"camera": "gate", "date": "2026-11-21", "clips": 2}, seconds=1200)
    write_index(t)
    with opened(t) as page:
        page.wait("cards", "return document.querySelectorAll('a.card').length === 2")
        check("failed; shows what was until 2026-11-21 07:00:00" in page.texts(".bad"), str(page.texts(".bad")))
        check(page.texts(".card .first b") == ["07:50–08:10", "06:50"], str(page.texts(".card .first b")))
        page.run("document.querySelector('[value=failed]').click()")
        page.wait("one", "return document.querySelectorAll('.card').length === 1")


def test_index_of_names_that_mean_harm(t):
    evil = ["</script><script>document.title='evil'</script>", "<img src=x onerror=document.title='evil'>", "javascript:alert(1)",
            "a\" onmouseover=\"document.title='evil'", "{{script}}", "&lt;b&gt;", "#text=x?y", "up..%2F.."]
    for number, name in enumerate(evil):
        name = name.replace("/", "∕")
        known(t, f"{name if number < 3 else 'cam'}/{name}.avi".replace("%", "%25"), NOW - number, events=1)
    known(t, "cam/bad%FF.avi", NOW, state="failed", status=3, reason=evil[0] + evil[1], files={})
    write_index(t)
    with opened(t) as page:
        page.wait("cards", f"return document.querySelectorAll('.card').length === {len(evil) + 1}")
        check(page.run("return document.title") == "Video archive", "a name became a script")
        check(page.run("return document.querySelectorAll('#days script, .card b b, .reason img').length") == 0, "a name became markup")
        files = sorted(path.rsplit("/", 1)[1] for path in files_of(page, "a.card .facts"))
        check(files == sorted(name.replace("/", "∕") + ".avi" for name in evil), str(files))
        check(all(link.startswith("file:///") and "/out/" in link for link in page.run(
            "return [...document.querySelectorAll('a.card')].map(a => a.href)")), "a link leads elsewhere")
        check(page.text("cameras").count("evil") == 2, "a name is not shown")
        page.filter("<img")
        page.wait("one and the failure", "return document.querySelectorAll('.card').length === 2")
        complaints = [line for line in page.complaints() if "ERR_FILE_NOT_FOUND" not in str(line)]
        check(complaints == [], str(complaints))


def test_index_of_ten_thousand_clips(t):
    t.clip("one.avi", seconds=1)
    t.vvr("render", "one.avi", "-o", "one.jpg", "--size", "400x250", "--backend", "software").expect(0)
    stood = ["stood", 1, 90, 0, 1, 1, 100, 5, 5]
    for number in range(10_000):
        clip = f"cam {number % 8}/{number:05}.avi"
        known(t, clip, NOW - 600 * number, events=number % 3, found=[] if number % 50 else [stood])
        os.link(t.path("one.jpg"), t.path(f"out/{clip}.jpg"))
    begin = time.monotonic()
    write_index(t)
    took = time.monotonic() - begin
    check(took < 8, f"writing takes {took:.1f} s")
    size = t.path("out/index.html").stat().st_size
    check(size < 1_000_000, f"{size} bytes")
    with opened(t) as page:
        painted = []
        for _ in range(3):
            page.open(t.path("out/index.html"))
            page.wait("it is painted", "return performance.getEntriesByName('first-contentful-paint').length > 0")
            painted.append(page.run("return performance.getEntriesByName('first-contentful-paint')[0].startTime"))
        print(f"first paint after {[round(ms) for ms in painted]} ms, {size} bytes")
        check(min(painted) < 3000, f"it opens in {painted} ms")
        check("10,000 clips · 8 cameras" in page.text("summary"), page.text("summary"))
        page.wait("thumbnails", "return [...document.querySelectorAll('.card img')].filter(i => i.naturalWidth === 400).length > 5")
        loaded = [url for url in page.requests() if url.endswith(".jpg")]
        check(len(loaded) < 600, f"{len(loaded)} thumbnails are loaded at once")
        check(page.run("return document.querySelectorAll('.card').length") < 1500, "everything is built at once")
        begin = time.monotonic()
        page.filter("cam 3 2026-11-0")
        page.wait("the filter", "return document.getElementById('count').textContent.endsWith('of 10,000 clips')")
        check(time.monotonic() - begin < 3, "filtering is slow")
        page.filter("")
        page.run("scrollTo(0, document.documentElement.scrollHeight)")
        page.wait("the oldest",
                  "return [...document.querySelectorAll('.card .facts')].some(n => n.title.endsWith('/09999.avi'))"
                                " || (scrollTo(0, document.documentElement.scrollHeight), false)", 60)
        strange = [url for url in page.requests() if not url.startswith(("file:", "data:"))]
        check(strange == [], f"the page asks for {strange}")
        check(page.complaints() == [], str(page.complaints()))
        page.run("scrollTo(0, 0)")
        took = [page.run("""ask({view: 'clips'});
            const begin = performance.now();
            document.querySelector('#views [value=days]').click();
            document.body.getBoundingClientRect();
            return performance.now() - begin;""") for _ in range(5)]
        check(page.count("#overview td button") > 60, "no days")
        print(f"the days are there after {[round(ms) for ms in took]} ms")
        check(min(took) < 1000, f"the view of days takes {took} ms")
