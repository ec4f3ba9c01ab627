"""Page and index have the same ways of objects; tests/web/geometry.test.js tests what is asked of them."""

from harness import check, page_data


def test_ways_are_the_same_in_page_and_index(t):
    t.scene("walkers", "walkers.y4m", "--size", "192x144", "--frames", "300", "--seed", "5")
    t.ffmpeg("-i", "walkers.y4m", "-c:v", "mpeg4", "-q:v", "3", "in/gate/20261117T071500.avi")
    t.stamp("in/gate/20261117T071500.avi", 1e9)
    t.vvr("archive", "in", "-o", "out", "--size", "320x200", "--backend", "software").expect(0)
    events = page_data(t.path("out/gate/20261117T071500.avi.html").read_text())["events"]
    ways = {number: list(way) for _, number, _, *way in t.json("out/gate/20261117T071500.avi.json")["found"]}
    check(len(events) > 3 and sum(len(event["way"]) > 6 for event in events) > 2, f"too little to be a test: {events}")
    check({event.get("number", place + 1): event["way"] for place, event in enumerate(events)} == ways, f"{events}\n{ways}")
