"""Events that are kept: pieces beside the pages of an archive, and the evidence of `vvr cut`."""

import hashlib
import json
import os
import shutil
import subprocess
import time

import pytest
from harness import check, fnv1a, hijacked, lock_name
from test_archive import QUICK
from test_cut import packets
from test_sandbox import walls  # noqa: F401, a fixture

H264 = ("-c:v", "libx264", "-bf", "2", "-g", "20", "-keyint_min", "20", "-sc_threshold", "0", "-pix_fmt", "yuv420p")
RATE = 10
CLIP = "gate/2026-11-21_20-00-00.mp4"


def two_events(t, name, codec=H264):
    """A clip of 16 s in which something passes at 2 s and at 11 s."""
    def encode():
        x = "if(between(t,2,5),(t-2)*60-40,if(between(t,11,14),(t-11)*60-40,-100))"
        t.ffmpeg("-f", "lavfi", "-i", f"color=gray:size=160x120:rate={RATE}:duration=16", "-f", "lavfi", "-i", f"color=red:size=30x40:rate={RATE}:duration=16",
                 "-f", "lavfi", "-i", "sine=duration=16", "-filter_complex", f"[0][1]overlay=x='{x}':y=40:eval=frame,noise=alls=4:all_seed=7[v]",
                 "-map", "[v]", "-map", "2:a", *codec, "-c:a", "aac", "-shortest", name)

    t.make(name, "two events", codec, how=encode)


def archive(t, *arguments):
    return t.vvr("archive", "in", "-o", "out", *QUICK, "--keep-events", "--margin", "0.5s", *arguments)


def archived(t, *arguments):
    two_events(t, f"in/{CLIP}")
    t.age("in")
    archive(t, *arguments).expect(0, "1 clip drawn")
    return t.path(f"out/{CLIP}.events")


def names(folder):
    return sorted(os.listdir(folder))


def sha256(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def evidence(folder):
    """What the record of a folder says, once SHA256SUMS is found to be right and to have all other files."""
    summed = subprocess.run(["sha256sum", "-c", "SHA256SUMS"], cwd=folder, capture_output=True, text=True)
    check(summed.returncode == 0, f"{summed}")
    check(sorted(line.split(":")[0] for line in summed.stdout.splitlines()) == sorted(set(names(folder)) - {"SHA256SUMS"}), summed.stdout)
    return json.loads((folder / "evidence.json").read_text())


def check_has(t, clip, piece, first, last):
    """A piece has the packets of the clip that show it from one second to another, and decodes without an error."""
    whole, part = packets(t, clip), packets(t, piece)
    hashes = [packet[2] for packet in part]
    check(part[0][1] == "K" and all(packet[2] in {p[2] for p in whole} for packet in part), "other packets")
    lost = [time for time, _, data in whole if first - 1e-3 <= time <= last + 1e-3 and data not in hashes]
    check(not lost, f"the frames at {lost} are missing")
    check(len(part) < len(whole) / 2, f"{len(part)} of {len(whole)} packets")
    t.run(["ffmpeg", "-v", "error", "-i", str(t.path(piece)), "-f", "null", "-"]).expect(0, err="")


@pytest.mark.nightly
def test_archive_keeps_events(t):
    folder = archived(t)
    check(names(folder) == ["SHA256SUMS", "event-1.mp4", "event-2.mp4", "evidence.json"], f"{names(folder)}")
    record = evidence(folder)
    report = t.json(f"out/{CLIP}.report.json")
    check([record["camera"], record["clock"]["source"], record["vvr"]] == ["gate", "file-name", report["vvr"]], f"{record}")
    check(record["settings"]["size"] == "160x100" and record["settings"]["threshold"] == report["settings"]["threshold"], f"{record['settings']}")
    footage = t.path(f"in/{CLIP}")
    check([(one["bytes"], one["sha256"]) for one in record["footage"]] == [(footage.stat().st_size, sha256(footage))], f"{record['footage']}")
    check(record["footage"][0]["file"].endswith(f"in/{CLIP}"), f"{record['footage']}")
    for event, piece in zip(report["events"], record["pieces"], strict=True):
        check(sha256(folder / piece["file"]) == piece["sha256"], f"{piece}")
        [told] = piece["events"]
        check([told["number"], told["kind"], told["first"]["time"]] == [event["number"], event["kind"], event["first"]["time"]], f"{told}")
        check(piece["first"]["time"].startswith("2026-11-21T20:00:") and piece["first"]["file"] == record["footage"][0]["file"], f"{piece}")
        check(piece["frames"] == {"present": len(packets(t, f"out/{CLIP}.events/{piece['file']}")), "expected": piece["frames"]["present"]}, f"{piece}")
        check_has(t, f"in/{CLIP}", f"out/{CLIP}.events/{piece['file']}", event["first"]["seconds"] - 0.5, event["last"]["seconds"] + 0.5)
    known = t.json(f"out/{CLIP}.json")
    check(known["pieces"] == names(folder), f"{known['pieces']}")
    # The page finds them beside it, and knows where in the clip they begin.
    page = t.path(f"out/{CLIP}.html").read_text()
    for piece in record["pieces"]:
        address = f'["./2026-11-21_20-00-00.mp4.events/{piece["file"]}",{piece["first"]["offset"]:g}'
        check(address in page, f"{address} is not on the page")


def test_archive_keeps_events_once(t):
    folder = archived(t)
    archive(t).expect(0, "nothing to do; 1 done before")
    (folder / "event-2.mp4").unlink()
    said = archive(t, "--dry-run").expect(0, out=None).out
    check(said.startswith("files missing"), said)
    archive(t).expect(0, "1 clip drawn")
    # Other margins are other pieces: two that overlap are one. What isn't vvr's stays.
    (folder / "mine.mp4").write_bytes(b"mine")
    archive(t, "--margin", "10s").expect(0, "1 clip drawn")
    check(names(folder) == ["SHA256SUMS", "event-1.mp4", "evidence.json", "mine.mp4"], f"{names(folder)}")
    record = t.json(f"out/{CLIP}.events/evidence.json")
    check([event["number"] for event in record["pieces"][0]["events"]] == [1, 2], f"{record['pieces']}")
    # Without the option they go when the clip is drawn again.
    t.vvr("archive", "in", "-o", "out", *QUICK).expect(0, "1 clip drawn")
    check(names(folder) == ["mine.mp4"], f"{names(folder)}")
    check("pieces" not in t.json(f"out/{CLIP}.json"), "the sidecar lists pieces")


def test_pieces_stay_when_the_clip_is_gone_and_go_by_age(t):
    folder = archived(t)
    t.path(f"in/{CLIP}").unlink()
    archive(t, "--keep", "30d").expect(0, "nothing to do")
    check("event-1.mp4" in names(folder), f"{names(folder)}")
    sidecar = t.path(f"out/{CLIP}.json")
    known = json.loads(sidecar.read_text())
    sidecar.write_text(sidecar.read_text().replace(str(known["clip"]["modified_ns"]), str((int(time.time()) - 31 * 86400) * 10**9)))
    (folder / "event-7.mp4").write_bytes(b"mine")  # the name of a piece, but no sidecar has it
    archive(t, "--keep", "30d").expect(0, f"{CLIP}: older than --keep; removed ", f"{CLIP}.events/event-1.mp4", f"{CLIP}.events/evidence.json")
    check(names(folder) == ["event-7.mp4"], f"{names(folder)}")
    check(not sidecar.exists() and not t.path(f"out/{CLIP}.png").exists(), "the rest")


def archive_that_loses_its_clip(t, *arguments):
    """A run whose clip the recorder removes while it is decoded. Without a sandbox, as the worker removes it itself."""
    t.path(f"in/{CLIP}").rename(t.path("clip.mp4"))
    shutil.copy2(t.path("clip.mp4"), t.path(f"in/{CLIP}"))
    done = t.vvr("archive", "in", "-o", "out", *QUICK, "--keep-events", "--sandbox", "off", *arguments, env={**hijacked(), "HIJACK_LOSES": str(t.path(f"in/{CLIP}"))})
    t.path("clip.mp4").rename(t.path(f"in/{CLIP}"))
    return done


def test_pieces_stay_when_a_redraw_loses_the_clip(t):
    """They may be all that is left of it; and a clip whose file could not be read is tried again."""
    two_events(t, f"in/{CLIP}")
    t.age("in")
    archive_that_loses_its_clip(t).expect(6, "1 clip drawn", "events could not be kept: cannot read ", code="file-not-found")
    known = t.json(f"out/{CLIP}.json")
    check((known["state"], known["tries"], known["code"]) == ("done", 1, "file-not-found") and "pieces" not in known, f"{known}")
    archive(t).expect(0, "1 clip drawn")
    folder = t.path(f"out/{CLIP}.events")
    before = {name: (folder / name).read_bytes() for name in names(folder)}
    check(len(before) > 2, f"{names(folder)}")
    archive_that_loses_its_clip(t, "--margin", "1s").expect(6, "1 failed", "could not be kept: cannot read ", "the older picture is kept", code="file-not-found")
    check({name: (folder / name).read_bytes() for name in names(folder)} == before, f"{names(folder)}")
    known = t.json(f"out/{CLIP}.json")
    check((known["state"], known["tries"], known["pieces"]) == ("failed", 1, sorted(before)) and "shows" in known, f"{known}")
    archive(t).expect(0, "1 clip drawn")
    check(names(folder) == sorted(before) and t.json(f"out/{CLIP}.json")["state"] == "done", f"{names(folder)}")


def test_pieces_stay_when_a_redraw_cannot_copy(t):
    """The clip has no time stamps any more."""
    clip = "in/gate/2026-11-21_20-00-00.avi"
    two_events(t, clip, ("-c:v", "mpeg4", "-g", "20"))
    t.age("in")
    archive(t).expect(0, "1 clip drawn")
    folder = t.path("out/gate/2026-11-21_20-00-00.avi.events")
    before = {name: (folder / name).read_bytes() for name in names(folder)}
    two_events(t, clip, ("-c:v", "mpeg4", "-bf", "2", "-g", "20"))
    t.age("in")
    archive(t).expect(6, "1 clip drawn", "2 of 2 events could not be kept: ", code="partial")
    check({name: (folder / name).read_bytes() for name in names(folder)} == before, f"{names(folder)}")
    check(t.json("out/gate/2026-11-21_20-00-00.avi.json")["pieces"] == sorted(before), "the sidecar forgets them")
    archive(t).expect(0, "nothing to do")


@pytest.mark.nightly
def test_archive_removes_the_empty_folder_of_pieces(t):
    folder = archived(t)
    t.stamp(f"in/{CLIP}", -40 * 86400)
    archive(t, "--margin", "0.4s").expect(0, "1 clip drawn")
    archive(t, "--margin", "0.4s", "--keep", "30d").expect(0, "removed")
    check(not folder.exists(), f"{names(folder.parent)}")


@pytest.mark.nightly
def test_archive_of_a_clip_whose_events_cannot_be_copied(t):
    """It has no time stamps: its picture is drawn, no half piece is left, and it says so once."""
    two_events(t, "in/gate/clip.avi", ("-c:v", "mpeg4", "-bf", "2", "-g", "20"))
    t.age("in")
    result = archive(t).expect(6, "1 clip drawn", "2 of 2 events could not be kept: ", code="partial")
    check(result.err.count("could not be kept") == 1, str(result))
    check(not t.path("out/gate/clip.avi.events").exists(), "a folder without pieces")
    known = t.json("out/gate/clip.avi.json")
    check(known["state"] == "done" and known["status"] == 6 and "could not be kept" in known["reason"] and "pieces" not in known, f"{known}")
    archive(t).expect(0, "nothing to do")


@pytest.mark.nightly
def test_archive_keeps_the_events_of_a_damaged_clip(t):
    two_events(t, "in/gate/clip.mkv")
    data = bytearray(t.path("in/gate/clip.mkv").read_bytes())
    for place in range(len(data) // 3, len(data) * 3 // 4, 997):
        data[place] ^= 0xFF
    t.write("in/gate/clip.mkv", bytes(data[:len(data) * 9 // 10]))
    t.age("in")
    result = archive(t)
    check(result.status in (0, 6), str(result))
    known = t.json("out/gate/clip.mkv.json")
    folder = t.path("out/gate/clip.mkv.events")
    there = names(folder) if folder.exists() else []
    check(known.get("pieces", []) == there and not [name for name in t.files() if ".part" in name or ".vvr-" in name], f"{t.files()}")
    for name in there:
        if name.startswith("event-"):
            check(float(t.probe(folder / name, "format=duration")) > 0, f"{name} has no length")


def test_kept_events_of_hostile_names(t):
    clip = "in/ga\"te$(x)\n<script>/2026-11-21_20-00-00.mp4"
    two_events(t, clip)
    t.age("in")
    archive(t).expect(0, "1 clip drawn")
    folder = t.path("out") / (clip[3:] + ".events")
    record = evidence(folder)
    check(record["camera"] == "ga\"te$(x)%0A<script>", record["camera"])
    check([one["file"] for one in record["footage"]] == [str(t.path(clip))] or record["footage"][0]["file"] == clip, f"{record['footage']}")
    page = (t.path("out") / (clip[3:] + ".html")).read_text()
    check('["./2026-11-21_20-00-00.mp4.events/event-1.mp4"' in page, "the page does not find the piece")


def test_kept_events_of_a_day(t):
    two_events(t, "in/gate/2026-11-21_20-00-00.mp4")
    t.copy("in/gate/2026-11-21_20-00-00.mp4", "in/gate/2026-11-21_20-00-16.mp4")
    t.age("in")
    archive(t, "--per", "day").expect(0, "1 clip drawn")
    record = evidence(t.path("out/gate/2026-11-21.events"))
    check(len(record["footage"]) == 2 and len(record["pieces"]) >= 3 and record["camera"] == "gate", f"{record}")
    last = record["pieces"][-1]
    check(last["first"]["time"] > "2026-11-21T20:00:24", f"{last}")


@pytest.mark.nightly
def test_kept_events_of_a_day_of_matroska_files(t):
    """One piece with all events, which begins with the first packets of a file: Matroska has no decoding times for them."""
    two_events(t, "in/gate/2026-11-21_20-00-00.mkv")
    t.copy("in/gate/2026-11-21_20-00-00.mkv", "in/gate/2026-11-21_20-00-16.mkv")
    t.age("in")
    done = archive(t, "--per", "day", "--margin", "6s").expect(0, "1 clip drawn")
    check("could not be kept" not in done.err, str(done))
    [piece] = evidence(t.path("out/gate/2026-11-21.events"))["pieces"]
    check(piece["first"]["offset"] == 0 and piece["last"]["offset"] > 15 and len(piece["parts"]) == 2, f"{piece}")


@pytest.mark.nightly
def test_kept_events_of_a_day_that_is_searched_in_part(t):
    two_events(t, "in/gate/2026-11-21_20-00-00.mp4")
    t.copy("in/gate/2026-11-21_20-00-00.mp4", "in/gate/2026-11-21_20-00-16.mp4")
    t.age("in")
    archive(t, "--per", "day", "--end", "29s").expect(0, "1 clip drawn")
    last = evidence(t.path("out/gate/2026-11-21.events"))["pieces"][-1]
    check(29 < last["last"]["offset"] + 16 < 30, f"the piece goes on behind the margin: {last}")


@pytest.mark.nightly
def test_the_sandbox_changes_no_piece(t, walls):  # noqa: F811
    found = []
    for mode in ("off", "required"):
        folder = archived(t, "--sandbox", mode)
        found.append({name: (folder / name).read_bytes() for name in names(folder)})
        t.path("out").rename(t.path(mode))
    check(len(found[0]) == 4 and found[0] == found[1], f"{found[0].keys()} {found[1].keys()}")


def test_archive_keeps_no_events_where_it_may_not(t):
    two_events(t, f"in/{CLIP}")
    t.age("in")
    archive(t, "--prune").expect(1, "--prune", "--keep AGE", code="options-conflict")
    archive(t, "--filter", "edges").expect(1, "filter 'edges'", "--keep-events", code="options-conflict")
    archive(t, "--margin", "2h").expect(1, "margin", code="option-value-out-of-range")
    # A link leads elsewhere: nothing is written there.
    t.path("elsewhere").mkdir()
    t.path("out/gate").mkdir(parents=True)
    t.path(f"out/{CLIP}.events").symlink_to(t.path("elsewhere"))
    archive(t).expect(6, ".events': it is a link", code="not-a-folder")
    check(names(t.path("elsewhere")) == [] and not t.path(f"out/{CLIP}.png").exists(), "written through a link")


def test_what_a_clip_that_is_gone_has_left_stays_after_a_killed_redraw(t):
    folder = archived(t)
    (folder / "mine.txt").write_text("mine")
    before = names(folder)
    t.path(f"out/{CLIP}.json").unlink()
    name = os.path.basename(CLIP)
    t.write(f"out/gate/{lock_name(name)}", name)
    t.path(f"in/{CLIP}").unlink()
    t.vvr("archive", "-o", "out", "--write", "index").expect(0)
    check(names(folder) == before and t.path(f"out/{CLIP}.png").exists(), f"{names(folder)}")


# ---- vvr cut --evidence


NAMED = "gate_2026-11-21_20-00-00.mp4"  # without an archive, only the name can tell the camera


def test_cut_writes_evidence(t):
    two_events(t, NAMED)
    t.vvr("render", NAMED, "--report", "report.json").expect(0)
    event = t.json("report.json")["events"][1]
    t.vvr("cut", NAMED, "--event", "2", "--report", "report.json", "--margin", "1s", "--evidence", "case").expect(
        0, "frames copied", "'case': event-2.mp4, event-2.png, event-2-marked.png, evidence.json and SHA256SUMS")
    case = t.path("case")
    check(names(case) == ["SHA256SUMS", "event-2-marked.png", "event-2.mp4", "event-2.png", "evidence.json"], f"{names(case)}")
    record = evidence(case)
    check([one["sha256"] for one in record["footage"]] == [sha256(t.path(NAMED))], f"{record['footage']}")
    check([record["camera"], record["clock"]["source"]] == ["gate", "file-name"], f"{record}")
    [piece], [still, marked] = record["pieces"], record["stills"]
    check([one["number"] for one in piece["events"]] == [2] and piece["events"][0]["box"] == event["box"], f"{piece}")
    check(record["settings"]["threshold"] == t.json("report.json")["settings"]["threshold"], f"{record['settings']}")
    check_has(t, NAMED, "case/event-2.mp4", event["first"]["seconds"] - 1, min(15.9, event["last"]["seconds"] + 1))
    # The report of an archive knows the camera from a folder.
    t.write("report.json", t.path("report.json").read_text().replace('"camera": "gate"', '"camera": "house/gate"'))
    t.vvr("cut", NAMED, "--event", "2", "--report", "report.json", "--evidence", "told").expect(0)
    check(evidence(t.path("told"))["camera"] == "house/gate", f"{evidence(t.path('told'))}")
    # Where nothing tells it, that is said, and the user can name it.
    t.copy(NAMED, "clip.mp4")
    t.vvr("cut", "clip.mp4", "--start", "1s", "--end", "2s", "--evidence", "unknown").expect(0, "warning: 'clip.mp4'", "--camera-name")
    check(evidence(t.path("unknown"))["camera"] is None, "a guess")
    t.vvr("cut", "clip.mp4", "--start", "1s", "--end", "2s", "--evidence", "named", "--camera-name", "yard").expect(0)
    check(evidence(t.path("named"))["camera"] == "yard", f"{evidence(t.path('named'))}")
    # The still is the frame of the event's portrait, of full size.
    check(t.picture_size("case/event-2.png") == (160, 120), f"{t.picture_size('case/event-2.png')}")
    at = still["at"]
    check(at["file"] == NAMED and abs(at["offset"] - event["portrait"]["seconds"]) < 0.05 and at["frame"] == round(at["offset"] * RATE), f"{still} {event['portrait']}")
    box = event["portrait"]["box"]
    plain, drawn = t.rgb("case/event-2.png"), t.rgb("case/event-2-marked.png")
    red = plain[box["y"] + box["height"] // 2][box["x"] + box["width"] // 2]
    check(red[0] > 200 and red[1] < 90, f"{red}")
    # The frame is around the box alone, in a copy.
    check(still["box"] == box and [marked["marks"], marked["sha256"]] == ["event-2.png", sha256(case / "event-2-marked.png")], f"{record['stills']}")
    inside = lambda x, y, edge: box["x"] - edge <= x < box["x"] + box["width"] + edge and box["y"] - edge <= y < box["y"] + box["height"] + edge
    for y, row in enumerate(drawn):
        for x, pixel in enumerate(row):
            is_edge = inside(x, y, 2) and not inside(x, y, 0)
            check(pixel == ((255, 0, 0) if is_edge else plain[y][x]), f"{x},{y}: {pixel}")
    # The same with a search, and without an event.
    t.vvr("cut", NAMED, "--event", "2", "--margin", "1s", "--evidence", "searched").expect(0)
    check(sha256(t.path("searched/event-2.mp4")) == sha256(t.path("case/event-2.mp4")), "another piece")
    t.vvr("cut", NAMED, "--start", "11s", "--end", "13s", "--evidence", "between/").expect(0)
    check(names(t.path("between")) == ["SHA256SUMS", "evidence.json", "piece.mp4", "piece.png"], f"{names(t.path('between'))}")
    record = t.json("between/evidence.json")
    check(record["pieces"][0]["events"] is None and record["stills"][0]["box"] is None, f"{record}")


def test_cut_writes_evidence_as_a_whole_or_not_at_all(t):
    two_events(t, NAMED)
    t.write("full/mine.txt", "mine")
    t.write("file", "mine")
    span = ("--start", "1s", "--end", "2s")
    t.vvr("cut", NAMED, *span, "--evidence", "full").expect(2, "'full'", code="folder-not-empty")
    t.vvr("cut", NAMED, *span, "--evidence", "file").expect(2, "'file'", code="not-a-folder")
    t.vvr("cut", NAMED, *span, "--evidence", "none/case").expect(2, "none/case", code="file-not-found")
    t.vvr("cut", NAMED, *span, "--evidence", "case", "-o", "x.mp4").expect(1, "--evidence", code="options-conflict")
    t.vvr("cut", NAMED, "--start", "99s", "--end", "100s", "--evidence", "case").expect(1, code="span-empty")
    two_events(t, "clip.avi", ("-c:v", "mpeg4", "-bf", "2", "-g", "20"))
    t.vvr("cut", "clip.avi", *span, "--evidence", "case").expect(3)
    check(not t.path("case").exists() and not [name for name in t.files() if ".vvr-" in name], f"{t.files()}")
    check(names(t.path("full")) == ["mine.txt"] and t.path("file").read_text() == "mine", "a file was changed")
    # A folder that is there keeps its permissions, and one of a run that was killed is removed.
    t.path("private").mkdir(mode=0o700)
    left = f".vvr-{fnv1a('private'):016x}.new"
    t.write(f"{left}/piece.mp4", "footage")
    t.vvr("cut", NAMED, *span, "--evidence", "private").expect(0)
    check(os.stat(t.path("private")).st_mode & 0o777 == 0o700, f"{os.stat(t.path('private')).st_mode:o}")
    check(len(names(t.path("private"))) == 4 and not t.path(left).exists(), f"{names(t.path('private'))}")
