"""Stills of objects are cut out of the decoded frame, not out of the small one from which fields are computed."""

import base64
import re
import statistics

import pytest
from harness import check

OBJECT = 160  # pixels
SQUARES = 4   # pixels: smaller than a pixel of the fields, whose long side has 384


def checkerboard_clip(t, name="board.mp4"):
    """An object with a fine checkerboard crosses an empty scene at 1920x1080, 10 frames per second."""
    squares = f"if(mod(floor(X/{SQUARES})+floor(Y/{SQUARES})\\,2)\\,235\\,16)"
    t.ffmpeg("-f", "lavfi", "-i", "color=0x506050:size=1920x1080:rate=10:duration=4",
             "-f", "lavfi", "-i", f"color=gray:size={OBJECT}x{OBJECT}:rate=10:duration=4",
             "-filter_complex", f"[1]geq=lum='{squares}':cb=128:cr=128[board];[0][board]overlay=x='24*n':y=400",
             "-c:v", "libx264", "-preset", "veryfast", "-crf", "18", "-pix_fmt", "yuv420p", name)
    return name


def portraits(t, page):
    listed = re.search(r'"portraits":\[([^\]]*)\]', t.path(page).read_text(encoding="utf-8").split('id="stilldata"')[1])[1]
    found = re.findall(r'"data:image/jpeg;base64,([^"]+)"', listed)
    return [base64.b64decode(portrait) for portrait in found]


def contrast(t, jpeg):
    """The standard deviation of the grey levels in the middle of a picture, which the object fills."""
    rows = t.rgb(t.write("portrait.jpg", jpeg))
    middle = range(len(rows) * 3 // 8, len(rows) * 5 // 8)
    return statistics.pstdev(sum(rows[j][i]) / 3 for j in middle for i in middle)


@pytest.mark.nightly
def test_portraits_show_what_the_small_frame_cannot_hold(t):
    clip = checkerboard_clip(t)
    t.render(clip, "--backend", "software", output="page.html").expect(0)
    sharp = portraits(t, "page.html")
    check(len(sharp) == 1, f"{len(sharp)} portraits")
    check(contrast(t, sharp[0]) > 40, f"the checkerboard has a contrast of {contrast(t, sharp[0])}")
    check(t.picture_size("portrait.jpg") == (144, 144), f"the portrait has {t.picture_size('portrait.jpg')} pixels")
    check(len(sharp[0]) < 12_000, f"{len(sharp[0])} bytes")

    piped = t.run(f"cat {clip} | '{t.vvr_path}' render - -o pipe.html --size 160x100 --backend software", shell=True)
    piped.expect(0)
    check(portraits(t, "pipe.html") == sharp, "a pipe gives another portrait than its file")

    # Data files have only frames at the size of the fields.
    t.vvr("extract", clip, "-o", "data").expect(0)
    t.render("data", "--backend", "software", output="data.html").expect(0)
    blurred = portraits(t, "data.html")
    check(len(blurred) == 1, f"{len(blurred)} portraits of data files")
    check(contrast(t, blurred[0]) < 25, f"at field size the checkerboard has a contrast of {contrast(t, blurred[0])}")


@pytest.mark.nightly
def test_every_event_of_a_long_clip_has_its_still(t):
    """Flashes are sharper than somebody in the dark, and there are thousands: his still has to make room, and is read again."""
    flashes = "format=gray,geq=lum='if(gt(N,120)*gt(random(1),0.95),255,128)',scale=160:120:flags=neighbor"
    t.ffmpeg("-f", "lavfi", "-i", f"nullsrc=size=8x6:rate=10:duration=400,{flashes}", "-f", "lavfi", "-i",
             "color=0x707070:size=10x16:rate=10:duration=400", "-filter_complex",
             "[0][1]overlay=x='if(between(t,3,11),20*(t-3)-14,-50)':y=50:eval=frame,format=gray", "-c:v", "ffv1", "-g", "50", "flashes.mkv")
    t.render("flashes.mkv", "--threshold", "12", "--report", "r.json", output="page.html").expect(0)
    first = t.json("r.json")["events"][0]
    check(first["first"]["seconds"] < 4 and first["last"]["seconds"] > 10, f"{first}")
    found = portraits(t, "page.html")
    check(len(found) == len(t.json("r.json")["events"]), f"{len(found)} stills")
    # He is darker than the grey around him, and the flashes are white.
    pixels = [pixel[0] for row in t.rgb(t.write("portrait.jpg", found[0])) for pixel in row]
    share = sum(100 <= grey <= 122 for grey in pixels) / len(pixels)
    check(share >= 0.03, f"{share:.3f} of the portrait are his grey")
