"""Seeds in the picture: flags of bricks, one list that all frames share, where seeds may lie, and a flow that is stored."""

import contextlib
import signal
import struct
import time

import pytest
from harness import check, moving_clip

# Time runs from left to right over the whole width, and all that has a colour is an arrow.
STRAIGHT = ("--backend", "software", "--layout", "box", "--camera", "0,40", "--fov", "0", "--size", "400x120",
            "--show", "arrows")


def is_arrow(red, green, blue):
    return red > blue + 60 and red >= green


def columns(t, name="out.png"):
    return t.columns(name, is_arrow)


def arrows(t, name="out.png"):
    return sum(is_arrow(*pixel) for row in t.rgb(name) for pixel in row)


def seed_list(points, frame=0, size="96 64"):
    lines = "".join(f"{' '.join(map(str, point))}\n" for point in points)
    return f"vvr-seeds 1\nframe {frame}\nsize {size}\npoints {len(points)}\n{lines}"


def set_flags(t, folder, flag):
    """Gives each seed of a folder of lists the flag that `flag(frame)` is."""
    for file in t.path(folder).glob("*.txt"):
        *head, points = file.read_text().partition("# x y u v flag\n")
        frame = int(file.stem)
        points = "".join(f"{line.rsplit(' ', 1)[0]} {flag(frame)}\n" for line in points.splitlines())
        file.write_text("".join(head) + points)


@pytest.mark.nightly
def test_a_seed_whose_flag_is_0_draws_nothing(t):
    t.vvr("extract", moving_clip(t), "-o", "data").expect(0)
    lists = ("--seeds", "data/seeds")
    t.render("clip.mkv", *STRAIGHT, *lists, output="all.png").expect(0)
    check(columns(t, "all.png")[0] < 0.1 and columns(t, "all.png")[-1] > 0.9, "arrows are not everywhere")
    set_flags(t, "data/seeds", lambda frame: 1 if frame < 20 else 0)
    for part in ("arrows", "tracelines"):
        t.render("clip.mkv", *STRAIGHT, *lists, "--show", part).expect(0)
        shown = columns(t)
        check(shown and shown[0] < 0.1 and shown[-1] < 0.52, f"{part} of the second half: {shown[-1:]}")
    set_flags(t, "data/seeds", lambda frame: 0)
    for part in ("arrows", "tracelines"):
        t.render("clip.mkv", *STRAIGHT, *lists, "--show", part, "--verbose").expect(0, " 0 arrows")
        check(arrows(t) == 0, f"{part} of seeds whose flags are 0")


@pytest.mark.nightly
def test_a_digit_per_brick(t):
    t.vvr("extract", moving_clip(t), "-o", "data").expect(0)
    t.render("clip.mkv", *STRAIGHT, "--window", "4", "--seed-flags", "10").expect(0)
    by_rule = columns(t)
    check(by_rule, "no arrows")
    check(all(0 <= x < 0.27 or 0.49 < x < 0.77 for x in by_rule), f"arrows in the second or the fourth brick: {by_rule}")
    set_flags(t, "data/seeds", lambda frame: "10")
    t.render("clip.mkv", *STRAIGHT, "--window", "4", "--seeds", "data/seeds").expect(0)
    check(columns(t) == by_rule, "a list whose flags say the same shows other arrows")
    t.render("clip.mkv", *STRAIGHT, "--window", "4", "--seeds", "data/seeds", "--seed-flags", "01").expect(0)
    check(all(0.23 < x < 0.52 or x > 0.73 for x in columns(t)), "the rule does not replace the flags of the list")


def test_flags_count_bricks_from_the_first_of_the_clip(t):
    moving_clip(t)
    t.render("clip.mkv", *STRAIGHT, "--brick", "10f", "--window", "2", "--seed-flags", "100", output="s.{brick}.png").expect(0)
    shown = [arrows(t, f"s.{brick}.png") > 0 for brick in range(4)]
    check(shown == [True, True, False, True], f"arrows of bricks 0 and 3 in windows of two: {shown}")


@pytest.mark.nightly
def test_one_list_that_all_frames_share(t):
    moving_clip(t)
    # The square passes 40, 30 from frame 11 to 24, and 80, 30 from frame 37 on.
    t.write("shared.txt", seed_list([(40, 30, 9, 9, 1), (40.5, 60, 0, 0, 1)]))
    t.render("clip.mkv", *STRAIGHT, "--seeds", "shared.txt", "--verbose").expect(0)
    shown = columns(t)
    check(shown and 0.2 < shown[0] and shown[-1] < 0.75, f"arrows where the square is not: {shown}")
    check(len(shown) > 8, f"only few frames share the list: {shown}")
    t.write("none.txt", seed_list([(40, 30, 9, 9, 0)]))
    t.render("clip.mkv", *STRAIGHT, "--seeds", "none.txt", "--verbose", output="none.png").expect(0, " 0 arrows")
    # Directions are those of the flow, so a list with others gives the same picture.
    t.write("other.txt", seed_list([(40, 30, -3, 1, 1), (40.5, 60, 1, 1, 1)]))
    t.render("clip.mkv", *STRAIGHT, "--seeds", "other.txt", output="other.png").expect(0)
    check(t.rgb("other.png") == t.rgb("out.png"), "the list's own directions were taken")
    t.vvr("extract", "clip.mkv", "-o", "data").expect(0)
    t.render("data", *STRAIGHT, "--seeds", "shared.txt", output="stored.png").expect(0)
    check(arrows(t, "stored.png") > 0, "no arrows of a stored flow")


@pytest.mark.nightly
def test_lists_and_flags_that_do_not_fit(t):
    moving_clip(t)
    t.write("big.txt", seed_list([], size="97 64"))
    t.write("flag.txt", seed_list([(1, 1, 0, 0, 2)]))
    t.write("good.txt", seed_list([(40, 30, 0, 0, 1)]))
    t.render("clip.mkv", "--seeds", "big.txt").expect(2, "big.txt", "97x64", "96x64", code="file-invalid")
    t.render("clip.mkv", "--seeds", "flag.txt").expect(2, "flag.txt:5", "32", "'2'", code="file-invalid")
    t.render("clip.mkv", "--seeds", "none.txt").expect(2, "--seeds", "'none.txt'", "No such file or directory", code="file-not-found")
    t.render("clip.mkv", "--seeds", "good.txt", "--flow", "none").expect(1, "--seeds", "--flow", code="options-conflict")
    for digits in ("2", "", "1" * 33, "1 0"):
        t.render("clip.mkv", "--seed-flags", digits).expect(1, "--seed-flags", "1 to 32", code="option-value")
    t.render("clip.mkv", "--seed-area", "somewhere").expect(1, "--seed-area", "'somewhere'", "object", "field", code="choice-unknown")
    t.expect_files("big.txt", "clip.mkv", "flag.txt", "good.txt")


@pytest.mark.nightly
def test_seeds_on_the_object_or_all_over_the_field(t):
    # The whole picture moves, and differs from the empty scene on the right half alone.
    t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=192x64:rate=10:duration=2", "-vf", "crop=96:64:x=n:y=0", "-c:v", "ffv1",
             "clip.mkv")
    t.ffmpeg("-f", "lavfi", "-i", "color=black:size=96x64:rate=10:duration=2", "-vf", "drawbox=x=48:w=48:h=64:t=fill:c=white",
             "-frames:v", "1", "right.png")
    right = ("--roi", "right.png")
    for area in ("object", "field"):
        t.vvr("extract", "clip.mkv", "-o", area, *right, "--seed-area", area, "--grid", "8").expect(0)

    def at(folder):
        points = [line.split() for line in t.path(f"{folder}/seeds/000010.txt").read_text().splitlines()[5:]]
        return [float(point[0]) for point in points]
    check(at("object") and min(at("object")) >= 48, f"seeds beside the object: {at('object')}")
    check(min(at("field")) < 16 and max(at("field")) > 80, f"seeds do not fill the field: {at('field')}")
    for area in ("object", "field"):
        t.render("clip.mkv", *right, *STRAIGHT, "--camera", "-90,0", "--seed-area", area, output=f"{area}.png").expect(0)
    check(arrows(t, "field.png") > 1.3 * arrows(t, "object.png"), "the picture shows no more arrows")


def flo(u, v, size=(96, 64)):
    return struct.pack("<fii", 202021.25, *size) + struct.pack("<2f", u, v) * (size[0] * size[1])


def points_of(t, file):
    return [[float(word) for word in line.split()] for line in t.path(file).read_text().splitlines()[5:]]


def test_seeds_of_a_stored_flow(t):
    t.vvr("extract", moving_clip(t), "-o", "data", "--grid", "8").expect(0)
    t.vvr("seeds", "data", "-o", "same", "--grid", "8").expect(0, "'same': 40 lists with ")
    t.vvr("seeds", "data", "-o", "fine", "--grid", "4", "--seed-order", "age", "--seed-select", "first:9").expect(0)
    for frame in (20, 30):
        of_extract = points_of(t, f"data/seeds/{frame:06}.txt")
        anew = points_of(t, f"same/{frame:06}.txt")
        check(all(point in anew for point in of_extract), f"frame {frame}: seeds that extract chose are missing")
        count = len(points_of(t, f"fine/{frame:06}.txt"))
        check(count == 9, f"{count} seeds, not the first nine")
    t.render("data", *STRAIGHT, "--seeds", "fine").expect(0)
    check(arrows(t) > 0, "the lists draw no arrows")
    # Somebody else's flow: all to the left, in two frames.
    t.write("flows/frame_0003.flo", flo(-4, 0))
    t.write("flows/frame_0030.flo", flo(0, 0.1))
    t.vvr("seeds", "flows", "-o", "own", "--grid", "32", "--seed-area", "field").expect(0, "'own': 2 lists with 6 seeds")
    check(points_of(t, "own/000003.txt") == [[x, y, -4, 0, 1] for y in (16, 48) for x in (16, 48, 80)], "u, v of that flow")
    check(points_of(t, "own/000030.txt") == [], "slower than --min-magnitude")
    t.render("clip.mkv", *STRAIGHT, "--seeds", "own", "--verbose").expect(0, " 6 arrows")
    check(0.05 < columns(t)[0] and columns(t)[-1] < 0.14, f"arrows where frame 3 is not: {columns(t)}")


@pytest.mark.nightly
def test_stored_flows_that_cannot_be(t):
    moving_clip(t)
    t.path("flows").mkdir()
    t.vvr("seeds", "flows", "-o", "out").expect(2, "'flows'", ".flo", code="file-not-found")
    t.write("clip.avi", "a file")
    t.vvr("seeds", "clip.avi", "-o", "out").expect(2, "'clip.avi'", "Not a directory", code="not-a-folder")
    t.write("flows/a1.flo", flo(1, 1))
    t.vvr("seeds", "flows", "-o", "out").expect(1, "'flows'", "--seed-area", "--seed-order", code="extraction-unsuitable")
    t.vvr("seeds", "flows", "-o", "out", "--seed-area", "field", "--seed-order", "age").expect(
        1, "'flows'", "--seed-area", "--seed-order", code="extraction-unsuitable")
    t.vvr("seeds", "flows", "-o", "flows", "--seed-area", "field").expect(2, "'flows'", "--output", code="folder-not-empty")
    t.write("flows/b1.flo", flo(1, 1))
    t.vvr("seeds", "flows", "-o", "out", "--seed-area", "field").expect(
        2, "frame 1", "'flows/a1.flo'", "'flows/b1.flo'", code="file-invalid")
    t.path("flows/b1.flo").unlink()
    t.write("flows/2.flo", b"PIEH")
    t.vvr("seeds", "flows", "-o", "out", "--seed-area", "field").expect(2, "flows/2.flo", "4 bytes", "12", code="file-invalid")
    t.path("flows/2.flo").rename(t.path("flows/x.flo"))
    t.vvr("seeds", "flows", "-o", "out", "--seed-area", "field").expect(1, "'flows/x.flo'", "frame000012.flo", code="input-unsuitable")
    t.vvr("seeds", "flows").expect(1, "-o DIR", code="output-missing")
    t.vvr("seeds", "-o", "out").expect(1, "FLOW", ".flo", code="input-missing")
    t.vvr("extract", "clip.mkv", "-o", "edges", "--filter", "edges").expect(0)
    t.vvr("seeds", "edges", "-o", "out").expect(1, "'edges'", "--seed-area", code="extraction-unsuitable")
    check(not t.path("out").exists(), "a folder was left")


def hidden(t):
    return [path.name for path in t.folder.glob(".vvr-*")]


@contextlib.contextmanager
def writing_lists(t):
    """A run of `vvr seeds` that has written some of its lists, and is stopped there."""
    child = t.start("seeds", "flows", "-o", "lists", "--seed-area", "field", "--grid", "2")
    until = time.monotonic() + 60
    while not list(t.folder.glob(".vvr-*/*.txt")) and not t.path("lists").exists():
        check(child.poll() is None and time.monotonic() < until, "it wrote no list")
        time.sleep(0.001)
    child.send_signal(signal.SIGSTOP)
    try:
        yield child
    finally:
        child.kill()
        child.wait()


def test_seed_lists_appear_together_or_not_at_all(t):
    for frame in range(400):
        t.write(f"flows/{frame}.flo", flo(3, 0))
    with writing_lists(t) as run:
        run.send_signal(signal.SIGTERM)
        run.send_signal(signal.SIGCONT)
        check(run.wait(timeout=60) == -signal.SIGTERM, f"status {run.returncode}")
    check(not t.path("lists").exists() and not hidden(t), f"{t.files()}, {hidden(t)}")
    with writing_lists(t):
        t.vvr("seeds", "flows", "-o", "lists", "--seed-area", "field").expect(2, "'lists'", "another vvr", code="file-locked")
    check(not t.path("lists").exists() and hidden(t), f"{t.files()}, {hidden(t)}")
    t.vvr("seeds", "flows", "-o", "lists", "--seed-area", "field").expect(0, "400 lists")
    check(not hidden(t), f"the killed run's files stay: {hidden(t)}")
