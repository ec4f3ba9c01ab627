"""The player of a page: it plays the right moment, to the end of what was chosen, and keys and the strip of time move it."""

import json
import re

import pytest
import test_moments as moments
from browser import Page, Served
from harness import check
from test_keep_events import two_events
from test_page import FRAMES, RATE, bag, column_of, disc_page, row_of

pytestmark = pytest.mark.browser


def with_events(t, name, paths, kind_of=lambda _: "moved"):
    """The page out.html with other events, of these paths of [frame, x, y], and ways by them."""
    events = [{"kind": kind_of(k), "first": path[0][0], "last": path[-1][0], "begin": path[0][0] / RATE, "end": path[-1][0] / RATE,
               "still": 0, "from": None, "into": None, "by": None, "path": path, "stays": [], "box": [0.1, 0.1, 0.3, 0.3], "way": [value for frame, x, y in path for value in (frame / RATE * 10, 1000 * x, 1000 * y)],
               "deed": {"left": "left behind"}.get(kind_of(k), kind_of(k)), "number": k + 1} for k, path in enumerate(paths)]
    text = t.path("out.html").read_text()
    overlay = {"sections": [], "notes": [], "portraits": [], "captions": 0, "numbers": False, "map": None}
    for old, new in ((r'"events":\[.*?\],"overlay":.*?,"settings"', f'"events":{json.dumps(events)},"overlay":{json.dumps(overlay)},"settings"'),
                     (r'"objects":\{[^}]*\}', '"objects":null'), (r'"portraits":\["data.*?\]\}', '"portraits":[]}')):
        text, count = re.subn(old, lambda _, to=new: to, text, count=1)
        check(count == 1, f"the page's data have another form: {old}")
    return t.write(name, text)


def crowd(t, count):
    """The page with so many events of 0.16 s."""
    firsts = [2 + k * 380 // count for k in range(count)]
    return with_events(t, "crowd.html", [[[first, 0.1, 0.5], [first + 3, 0.9, 0.5]] for first in firsts],
                       lambda k: "left" if k % 100 == 50 else "moved")


@pytest.mark.parametrize("ranges", [True, False])
def test_page_from_a_server(t, ranges):
    """A server without Range would play the clip's beginning, whatever was clicked: then the preview takes over."""
    places = disc_page(t)
    with Served(t.folder, ranges) as served, Page(t, served.url("out.html")) as page:
        page.wait("a film is open", "return film !== null")
        wanted = "the original clip" if ranges else "the server can’t send a part of the clip, so this is a small preview"
        check(page.source() == wanted, page.source())
        page.hold_still()
        for frame in (31, 127, 223):
            _, shown = page.click_and_look(column_of((frame + 0.5) / FRAMES), row_of(places[frame][1]))
            check(shown is not None and abs(shown * RATE - frame) < 1.01, f"frame {frame}: {shown} s is shown")


def test_page_space_is_play_and_pause_whatever_was_clicked(t):
    with Page(t, bag(t)) as page:
        for selector in ("#events .row", "#next", "#previous", "#forward", "#loop", "#askbox", "#copylink", "#strip"):
            page.open_menu("share" if selector in ("#loop", "#copylink") else "")
            page.press(selector)
            chosen = page.run("return chosen")
            looped = page.run("return document.getElementById('loop').checked")
            for _ in range(2):
                before = page.run("return isPlaying()")
                page.key(" ")
                page.wait(f"Space after {selector}", f"return isPlaying() === {str(not before).lower()}", 5)
            check(page.run("return chosen") == chosen, f"Space after {selector} chooses")
            check(page.run("return document.getElementById('loop').checked") == looped, f"Space after {selector} presses")
        # Who came by Tab presses what has the focus.
        page.run("setPlaying(false); choose(null); document.getElementById('playall').focus()")
        for _ in range(20):
            page.key("\ue004")
            if page.run("return document.activeElement.id") == "next":
                break
        page.key(" ")
        check(page.run("return [chosen !== null, isPlaying()]") == [True, False], "Space does not press what Tab has reached")


def test_page_stops_at_the_end_of_an_event_or_loops(t):
    with Page(t, bag(t)) as page:
        page.set("speed", "4")
        check(page.run("return video.playbackRate") == 4, "the speed is not that of the player")
        first, last = page.run("return [data.events[0].first, data.events[0].last]")
        check(last < 390, f"the event ends with the clip: {last}")
        page.press("#events .row")
        page.wait("it plays", f"return isPlaying() && now > {first}")
        page.wait("it stops", "return !isPlaying() && video.paused")
        check(page.run("return now") == last, f"it stops at {page.run('return now')}, the event ends at {last}")
        page.open_menu("share")
        page.press("#loop")
        page.open_menu("")
        page.press("#events .row")
        page.run("""window.rounds = 0; let before = now;
            setInterval(() => { if (now < before - 5) ++window.rounds; before = now; }, 20);""")
        page.wait("it begins again", "return window.rounds >= 2")
        check(page.run("return isPlaying() && now <= data.events[0].last + 3"), "it plays beyond the end")


def test_page_keys_of_players(t):
    with Page(t, bag(t)) as page:
        page.run("show(200, false)")
        for key, frame in ((".", 201), (".", 202), (",", 201), ("j", 76), ("l", 201), ("L", 326), ("J", 201)):
            page.key(key)
            check(page.run("return now") == frame, f"{key} goes to {page.run('return now')}, not {frame}")
            page.wait("the player is there", f"return Math.floor(video.currentTime * 25 + 1e-6) === {frame}")
        page.key("k")
        page.wait("K plays", "return !video.paused && now > 203")
        page.key("k")
        page.wait("K pauses", "return video.paused")
        for speed in ("0.5", "2", "8"):
            page.set("speed", speed)
            check(page.run("return video.playbackRate") == float(speed), speed)


def test_page_strip_scrubs_zooms_and_has_keys(t):
    with Page(t, bag(t)) as page:
        page.drag("#strip", (0.1, 0.5), (0.3, 0.5), (0.75, 0.9))
        check(abs(page.run("return now") - 0.75 * 399) < 4, f"dragged to {page.run('return now')}")
        check(page.run("return [isPlaying(), chosen]") == [False, None], "a drag plays or chooses")
        page.wait("the player is there", "return Math.abs(video.currentTime * 25 - now) < 2")
        # A bar chooses its event.
        number = page.run("return Number(document.querySelector('#bars i:nth-last-child(2)').dataset.event)")
        page.drag("#bars i:nth-last-child(2)", (0.5, 0.5))
        check(page.run("return chosen") == number, f"a click on its bar chooses {page.run('return chosen')}, not {number}")
        check(page.count("#bars i.chosen") == 1, "no bar is marked")
        # It is a slider, with keys.
        page.run("setPlaying(false); choose(null); strip.focus(); show(100, false)")
        check(page.run("return document.activeElement.id") == "strip", "the strip takes no focus")
        for key, frame in (("\ue014", 125), ("\ue012", 100), ("\ue00e", 350), ("\ue010", 399), ("\ue011", 0)):
            page.key(key)
            check(page.run("return now") == frame, f"{key!r} goes to {page.run('return now')}, not {frame}")
        role, most, now, text = page.run("return ['role', 'aria-valuemax', 'aria-valuenow', 'aria-valuetext'].map(n => strip.getAttribute(n))")
        check(role == "slider" and 15 < float(most) <= 16 and [now, text] == ["0.0", "0:00.0"], f"{role}, {now} of {most}, {text}")
        labels = page.texts("#ticks span")
        check(page.hidden("stripwhole"), "nothing is to be reset")
        page.key("+", "+", "+")
        check(not page.hidden("stripwhole"), "no way back is to be seen")
        check(page.run("return stripLasts") < 5 and labels != page.texts("#ticks span"), "+ does not zoom")
        page.key("-", "-", "-", "-")
        check(abs(page.run("return stripLasts - time.lasts")) < 1e-6, "- does not show all again")


def test_page_of_hundreds_of_events(t):
    bag(t)
    with Page(t, crowd(t, 800)) as page:
        check(page.text("heading") == "800 events", page.text("heading"))
        density, marks = page.count("#bars i.density"), page.count("#bars i.mark")
        check(density > 100 and marks == 8, f"{density} columns, {marks} marks of things that were left")
        page.run("zoomStrip(0.1, 0.5)")
        check(page.count("#bars i[data-event]") > 10, "no bars in the strip when it is zoomed")
        # Chips ask for a kind, and the orders order.
        page.run("[...document.querySelectorAll('.chip')].find(chip => chip.textContent === 'left behind 8').click()")
        check(page.text("heading") == "8 of 800 events" and page.count("#events li") == 8, page.text("heading"))
        page.press(".chip")
        page.set("order", "kind")
        kinds = page.texts("#events .kind")
        check(kinds[:8] == ["left behind"] * 8 and kinds[8] == "moved" and len(kinds) == 800, str(kinds[:10]))
        high = page.run("return document.querySelector('#events li').getBoundingClientRect().height")
        check(88 <= high <= 140, f"a row is {high} pixels high")


def test_page_names_what_the_pointer_is_on_and_makes_room_when_it_plays(t):
    with Page(t, bag(t)) as page:
        left, top, right, bottom = page.run("return data.overlay.portraits[0].box")
        number = page.run("return data.overlay.portraits[0].event")
        page.point((left + right) / 2, (top + bottom) / 2)
        page.wait("a tip", "return !document.getElementById('tip').hidden")
        kind = page.run("return data.events[arguments[0]].deed", number)
        check(page.text("when").endswith(f" · {number + 1} {kind}"), page.text("when"))
        check(not page.hidden("peekring"), "no ring in the tip")
        check(page.count("#events .lit") == 1, "its row is not lit")
        page.click((left + right) / 2, (top + bottom) / 2)
        page.wait("it plays", "return isPlaying()")
        check(page.hidden("tip") and page.run("return chosen") == number, "the tip stays, or another is chosen")
        # What came out of what leads there.
        page.run("setPlaying(false); choose(null); set({events: events.map((event, k) => k === 2 ? {...event, from: 0} : event)})")
        page.run("document.querySelector('#events li:nth-child(3) .relation').click()")
        page.wait("the other", "return chosen === 0")
        check(page.text_of("#events li:nth-child(3) .relation") == "began in one outline with 1", page.text_of("#events .relation"))


def test_page_plays_the_pieces_of_its_events_when_the_clip_is_gone(t):
    two_events(t, "in/gate/2026-11-21_20-00-00.mp4")
    options = ("--size", "640x400", "--backend", "software", "--keep-events", "--margin", "0.5s")
    t.archive("in", "-o", "out", *options).expect(0, "1 clip drawn")
    page_name = "out/gate/2026-11-21_20-00-00.mp4.html"
    with Page(t, page_name) as page:
        page.wait("a film is open", "return film !== null")
        check(page.source() == "the original clip", page.source())
    t.path("in/gate/2026-11-21_20-00-00.mp4").unlink()
    with Page(t, page_name) as page:
        page.wait("a film is open", "return film !== null")
        check(page.source().startswith("the clip is not where it was, so this is a clip per event: event-"), page.source())
        events = page.run("return data.events.map(({first, last}) => [first, last])")
        begins = page.run("return data.pieces.map(([, begin]) => begin)")
        check(len(events) == 2 and len(begins) == 2, f"{events} {begins}")
        for number, (first, last) in enumerate(events):
            page.run(f"show({(first + last) // 2}, false)")
            page.wait("its piece is open", f"return video.src.endsWith('event-{number + 1}.mp4') && !video.seeking && video.readyState > 1")
            shown = page.run("return video.currentTime") + begins[number]
            check(abs(shown * 10 - (first + last) // 2) < 1.01, f"frame {(first + last) // 2}: {shown} s is shown")
            check(not page.hidden("video") and page.hidden("still"), "no film")
            # Commands and the link name the piece, not the clip that is gone.
            check(page.run("return document.getElementById('openclip').href").endswith(f"/event-{number + 1}.mp4"), "the link is to the clip")
            check(not page.run("return document.getElementById('copystill').disabled"), "no command for a frame of a piece")
        # Between the events there is a still, and playing goes on with the next piece.
        between = (events[0][1] + events[1][0]) // 2
        page.run(f"show({between}, false)")
        page.wait("a still", "return document.getElementById('video').hidden && !document.getElementById('still').hidden")
        check(page.run("return now") == between, f"it shows {page.run('return now')}")
        check(page.run("return document.getElementById('copystill').disabled"), "a command for a frame that is gone")
        page.run("setPlaying(true)")
        page.wait("the next piece plays", f"return isPlaying() && now > {events[1][0] - 20} && !document.getElementById('video').hidden")
        # An event plays to its end and stops.
        page.press("#events .row")
        page.wait("it plays", f"return isPlaying() && now > {events[0][0]}")
        page.wait("it stops", "return !isPlaying() && video.paused")
        check(page.run("return now") == events[0][1], f"it stops at {page.run('return now')}, the event ends at {events[0][1]}")


NUMBER = f"""const canvas = document.createElement('canvas');
[canvas.width, canvas.height] = [video.videoWidth, video.videoHeight];
const context = canvas.getContext('2d');
context.drawImage(video, 0, 0);
const row = context.getImageData(0, 24, canvas.width, 1).data;
let number = 0;
for (let k = 0; k < {moments.BITS}; ++k) number += row[4 * ({moments.SIDE} * k + {moments.SIDE // 2})] > 128 ? 2 ** k : 0;
return number;"""


def test_page_plays_what_it_draws(t):
    moments.recording(t)
    t.zone("UTC")
    look = ("--mask", moments.MASK, "--backend", "software", "--size", "640x400")
    t.vvr("render", "day", "-o", "day.html", "--start", "@08:00:08", "--end", "@08:00:23", *look).expect(0)
    t.vvr("render", "day/gate_20261121_080000.mp4", "-o", "one.html", "--start", "3s", *look).expect(0)
    with Served(t.folder) as served, Page(t, served.url("one.html")) as page:
        page.wait("the first frame that is drawn", "return !video.seeking && video.readyState > 1 && video.currentTime > 2.9")
        check([page.run(NUMBER), page.run("return now"), page.source()] == [30, 30, "the original clip"], f"{page.run(NUMBER)}")
        page.open(served.url("day.html"))
        page.wait("the first frame that is drawn", "return !video.seeking && video.readyState > 1 && video.currentTime > 1.9")
        check([page.run(NUMBER), page.run("return now"), page.text("clock")] == [80, 80, "08:00:08.0"], f"{page.run(NUMBER)}")
        check(page.source() == "the original recording: gate_20261121_080006.mp4", page.source())
        page.run("setPlaying(true)")
        page.wait("it plays over the gap", "return now > 205 && !video.seeking")
        page.run("video.pause()")
        page.wait("it pauses", "return video.paused && !video.seeking")
        check(abs(page.run(NUMBER) - page.run("return now")) <= 1, f"{page.run(NUMBER)} is shown at {page.run('return now')}")
        check(page.source() == "the original recording: gate_20261121_080020.mp4", page.source())
        page.run("setPlaying(true)")
        page.wait("it stops after the last frame that is drawn", "return video.paused && now === time.lastFrame && !video.seeking")
        check(page.run("return now") == 229 and abs(page.run(NUMBER) - 229) <= 1, f"{page.run(NUMBER)}")
