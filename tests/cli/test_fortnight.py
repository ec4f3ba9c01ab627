"""Two weeks of three cameras, by one line of cron: nights, pieces, and what is kept."""

import datetime
import os
import time

import pytest
from harness import check, page_data
from test_keep_events import evidence, two_events

pytestmark = pytest.mark.slow

# The clock of a process, $LATER seconds later. The times of files stay.
CLOCK = """
#define _GNU_SOURCE
#include <stdlib.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>
int clock_gettime(clockid_t clock, struct timespec* now) {
    const int result = syscall(SYS_clock_gettime, clock, now);
    if (clock == CLOCK_REALTIME) now->tv_sec += atol(getenv("LATER"));
    return result;
}
time_t time(time_t* now) {
    struct timespec precise;
    clock_gettime(CLOCK_REALTIME, &precise);
    if (now) *now = precise.tv_sec;
    return precise.tv_sec;
}
"""
CAMERAS = ("gate", "till", "yard")
FIRST = datetime.date(2026, 11, 2)
DAYS = 14
FOOTAGE = 4  # days after which the recorder overwrites
PICTURES = 9  # days after which the line removes
LINE = ("archive", "cctv", "-o", "pictures", "--per", "night", "--keep-events", "--keep", f"{PICTURES}d", "--quiet", "--size", "320x200")


def at(day, hour, minute=0):
    return datetime.datetime.combine(FIRST + datetime.timedelta(days=day), datetime.time(hour, minute), datetime.timezone.utc)


def record(t, camera, day):
    """The camera's files from noon to noon: something passes in each; one before and one after midnight."""
    for when in (at(day, 12, 30), at(day, 23, 50), at(day + 1, 0, 10), at(day + 1, 8)):
        file = f"cctv/{camera}/{when:%Y-%m-%d}/{when:%H-%M-%S}.mp4"
        t.copy("event.mp4", file)
        t.stamp(file, when.timestamp() + 16)


def overwrite(t, now):
    """The recorder deletes its oldest files."""
    for file in t.path("cctv").rglob("*.mp4"):
        if now.timestamp() - file.stat().st_mtime > FOOTAGE * 86400:
            file.unlink()


def night(day):
    return f"{FIRST + datetime.timedelta(days=day)}-night"


def nights_of(folder, ending):
    return {path.name.removesuffix(ending) for path in folder.glob(f"*-night{ending}")}


def size_of(folder):
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())


def test_a_fortnight_of_three_cameras(t):
    two_events(t, "event.mp4")
    t.write("clock.c", CLOCK)
    t.run(["cc", "-shared", "-fPIC", "clock.c", "-o", "clock.so"]).expect(0)
    clock = str(t.path("clock.so"))
    t.write("pictures/gate/notes.txt", "not vvr's")
    drawn = {}
    for day in range(DAYS):
        now = at(day + 1, 13)
        for camera in CAMERAS:
            record(t, camera, day)
        overwrite(t, now)
        begin = time.monotonic()
        environment = os.environ | {"LD_PRELOAD": clock, "LATER": str(int(now.timestamp() - time.time())), "TZ": "UTC"}
        t.vvr(*LINE, env=environment, timeout=300).expect(0)
        print(f"{now:%Y-%m-%d}: {time.monotonic() - begin:.1f} s, {size_of(t.path('cctv')) / 1e6:.2f} MB of footage, "
              f"{size_of(t.path('pictures')) / 1e6:.2f} MB of pictures, pages and pieces")
        for camera in CAMERAS:
            folder = t.path(f"pictures/{camera}")
            # Of the night in progress, the first file has been recorded.
            expected = {night(one) for one in range(max(0, day + 1 - PICTURES), day + 1)}
            for kind in (".png", ".html", ".json", ".events"):
                there = nights_of(folder, kind)
                check(there == expected, f"day {day}: {kind} of {sorted(there)}, expected {sorted(expected)}")
            for name in expected:
                changed = (folder / f"{name}.png").stat().st_mtime_ns
                check(drawn.setdefault((camera, name), changed) == changed, f"{camera} {name} was drawn again on day {day}")
    check(t.path("pictures/gate/notes.txt").exists(), "a file of somebody else was removed")

    oldest = night(DAYS - PICTURES)
    check(not list(t.path(f"cctv/gate/{FIRST + datetime.timedelta(days=DAYS - PICTURES)}").glob("*.mp4")), "the footage is still there")
    pieces = t.path(f"pictures/gate/{oldest}.events")
    record_of_pieces = evidence(pieces)
    check(record_of_pieces["camera"] == "gate" and len(list(pieces.glob("event-*.mp4"))) >= 4, f"{record_of_pieces}")
    page = t.path(f"pictures/gate/{oldest}.html").read_text(encoding="utf-8")
    data = page_data(page)
    check(len(data["events"]) >= 8, f"{len(data['events'])} events in a night with 8")
    for piece in pieces.glob("event-*.mp4"):
        check(piece.name in page, f"the page doesn't play {piece.name}")
        t.run(["ffmpeg", "-v", "error", "-i", piece, "-f", "null", "-"]).expect(0, err="")
    index = t.path("pictures/index.html").read_text(encoding="utf-8")
    check(oldest in index and night(0) not in index, "the index lists other nights than there are")
