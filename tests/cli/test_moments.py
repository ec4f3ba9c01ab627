"""Which file shows a moment, and where in it: frames that carry their own number tell whether report, cut, evidence and page agree;
and what nobody looked at is said."""

import hashlib

from harness import check

RATE = 10
BITS = 12
SIDE = 16  # pixels of a bit
WIDTH, HEIGHT = BITS * SIDE, 144
H264 = ("-c:v", "libx264", "-bf", "0", "-g", "10", "-keyint_min", "10", "-sc_threshold", "0", "-pix_fmt", "yuv420p")
MASK = f"0,0 {WIDTH},0 {WIDTH},48 0,48"  # over the numbers
FILES = {"day/gate_20261121_080000.mp4": 0, "day/gate_20261121_080006.mp4": 60, "day/gate_20261121_080020.mp4": 200}


def numbered(t, name, first=0, seconds=6):
    """A clip whose frames show their numbers, counted from `first`, as bits; below, a disc passes from 1 s to 4 s."""
    def encode():
        bits = f"235*mod(floor((N+{first})/pow(2,floor(X/{SIDE}))),2)"
        disc = "if(lt(hypot(X-(T-1)*100+40,Y-96),18),235,60)"
        t.ffmpeg("-f", "lavfi", "-i", f"nullsrc=size={WIDTH}x{HEIGHT}:rate={RATE}:duration={seconds}", "-vf",
                 f"geq=lum='if(lt(Y,48),{bits},{disc})':cb=128:cr=128", *H264, name)

    return t.make(name, "numbered", first, seconds, how=encode)


def recording(t):
    """Three files, the third after a gap of 8 s; a frame's number is its tenth of a second in all."""
    for name, first in FILES.items():
        numbered(t, name, first)


def numbers(t, name, *options):
    """The number that each frame shows."""
    raw = t.raw(name, "gray", "-fps_mode", "passthrough", *options)
    rows = [raw[at + 24 * WIDTH:at + 25 * WIDTH] for at in range(0, len(raw), WIDTH * HEIGHT)]
    return [sum((row[k * SIDE + SIDE // 2] > 128) << k for k in range(BITS)) for row in rows]


def render(t, *arguments):
    t.vvr("render", *arguments, "--mask", MASK, "--backend", "software", "--report", "r.json").expect(0)
    return t.json("r.json")


def test_report_cut_and_evidence_agree_on_the_file_of_a_moment(t):
    recording(t)
    t.zone("UTC")
    events = render(t, "day")["events"]
    check(len(events) == 3, f"{events}")
    shown = {name: numbers(t, name) for name in FILES}
    for number, event in enumerate(events, 1):
        for moment in (event["first"], event["last"]):
            check(shown[moment["file"]][round(moment["offset"] * RATE)] == round(moment["seconds"] * RATE), f"{moment}")
        t.vvr("cut", "day", "--event", str(number), "--report", "r.json", "--margin", "1s", "--evidence", f"case{number}").expect(0)
        record = t.json(f"case{number}/evidence.json")
        [piece], still = record["pieces"], record["stills"][0]
        wanted = [number for part in piece["parts"] for number in shown[part["file"]][part["first_frame"]:part["last_frame"] + 1]]
        check(numbers(t, f"case{number}/{piece['file']}") == wanted and piece["frames"]["present"] == len(wanted), f"{piece}")
        for moment, number_then in ((piece["first"], wanted[0]), (piece["last"], wanted[-1])):
            check(shown[moment["file"]][round(moment["offset"] * RATE)] == number_then, f"{moment}")
        at = still["at"]
        check(numbers(t, f"case{number}/event-{number}.png") == [shown[at["file"]][at["frame"]]] and round(at["offset"] * RATE) == at["frame"], f"{still}")
        check(at["file"] == event["first"]["file"] and at["time"].startswith("2026-11-21T08:00:"), f"{still}")
        check(piece["events"][0]["first"]["file"] == event["first"]["file"], f"{piece}")
    # The file alone, by the report of the day: seconds are those of that file.
    alone = "day/gate_20261121_080020.mp4"
    t.vvr("cut", alone, "--event", "3", "--report", "r.json", "-o", "x.mp4").expect(0, "frames copied, 1.000 s to 3.", f"s of '{alone}', which is 2026-11-21T08:00:21")
    check(numbers(t, "x.mp4")[0] == 210, f"{numbers(t, 'x.mp4')}")
    # Over the gap.
    t.vvr("cut", "day", "--start", "11s", "--end", "21s", "--evidence", "gap").expect(
        0, "'day' has no frames from 5.900 s of 'day/gate_20261121_080006.mp4' to 0.000 s of 'day/gate_20261121_080020.mp4', where 80 are missing")
    [piece] = t.json("gap/evidence.json")["pieces"]
    check([part["frames"] for part in piece["parts"]] == [10, 10] and piece["frames"] == {"present": 20, "expected": 100}, f"{piece}")
    [gap] = piece["unseen"]["gaps"]
    check([gap["begin"]["offset"], gap["end"]["offset"], gap["frames"]] == [5.9, 0, 80], f"{gap}")


def test_files_that_overlap(t):
    """Of two files that show a moment, the earlier one is used until its end."""
    numbered(t, "day/gate_20261121_080000.mp4", 0, 8)
    numbered(t, "day/gate_20261121_080006.mp4", 60, 8)
    events = render(t, "day")["events"]
    for event in events:
        for moment in (event["first"], event["last"]):
            first = FILES[moment["file"]]
            check(first + round(moment["offset"] * RATE) == round(moment["seconds"] * RATE), f"{moment}")
            check((moment["file"] == "day/gate_20261121_080000.mp4") == (moment["seconds"] < 7.95), f"{moment}")


def lost(t):
    """A transport stream of 11 s without the packets from 5 s to 9 s."""
    numbered(t, "whole.ts", 0, 11)
    t.ffmpeg("-i", "whole.ts", "-t", "6.4", "-c", "copy", "-copyts", "a.ts")
    t.ffmpeg("-ss", "9", "-i", "whole.ts", "-c", "copy", "-copyts", "b.ts")
    t.write("lost.ts", t.path("a.ts").read_bytes() + t.path("b.ts").read_bytes())
    shown = numbers(t, "lost.ts")
    check(shown == list(range(50)) + list(range(90, 110)), f"{shown}")


def test_gaps_below_five_seconds_are_told(t):
    lost(t)
    report = render(t, "lost.ts", "-o", "x.png")
    [gap] = report["unseen"]["gaps"]
    check([round(gap[end]["seconds"], 2) for end in ("begin", "end")] == [4.9, 9.0] and gap["frames"] == 40, f"{gap}")
    check(any("; no frames for 4.1 s" in label["text"] for label in report["labels"]), f"{report['labels']}")
    t.vvr("cut", "lost.ts", "--start", "2s", "--end", "12s", "--evidence", "case").expect(
        0, "'lost.ts' has no frames from 4.900 s to 9.000 s of 'lost.ts', where 40 are missing")
    [piece] = t.json("case/evidence.json")["pieces"]
    check(piece["frames"] == {"present": 50, "expected": 90}, f"{piece}")
    [gap] = piece["unseen"]["gaps"]
    check([gap["begin"], gap["end"]] == [{"file": "lost.ts", "offset": 4.9}, {"file": "lost.ts", "offset": 9.0}], f"{gap}")


def test_areas_that_were_left_out_are_told(t):
    numbered(t, "gate_20261121_080000.mp4")
    report = render(t, "gate_20261121_080000.mp4", "-o", "x.png")
    [area] = report["unseen"]["areas"]
    check([area["option"], area["value"], area["sha256"]] == ["mask", MASK, hashlib.sha256(MASK.encode()).hexdigest()], f"{area}")
    check(abs(report["unseen"]["masked"] - 1 / 3) < 0.01, f"{report['unseen']}")
    check(any(label["text"].endswith("; 34 % of the scene masked") for label in report["labels"]), f"{report['labels']}")
    t.vvr("render", "gate_20261121_080000.mp4", "--mask", MASK, "-o", "x.html", "--backend", "software").expect(0)
    page = t.path("x.html").read_text()
    check('<p id="unseen">Not seen: 34 % of the scene masked</p>' in page and '"unseen":["34 % of the scene masked"]' in page, "the page does not tell it")
    # A file has the digest of its bytes, in the evidence too, where nobody can look at it any more.
    t.ffmpeg("-f", "lavfi", "-i", f"color=white:size={WIDTH}x{HEIGHT}:duration=1", "-vf", "drawbox=0:48:iw:ih:black:fill", "-frames:v", "1", "mask.png")
    t.vvr("render", "gate_20261121_080000.mp4", "--mask", "mask.png", "--report", "r.json").expect(0)
    digest = hashlib.sha256(t.path("mask.png").read_bytes()).hexdigest()
    t.path("mask.png").unlink()
    t.vvr("cut", "gate_20261121_080000.mp4", "--event", "1", "--report", "r.json", "--evidence", "case").expect(0)
    [piece] = t.json("case/evidence.json")["pieces"]
    check(piece["unseen"]["areas"] == [{"option": "mask", "value": "mask.png", "sha256": digest}] and abs(piece["unseen"]["masked"] - 1 / 3) < 0.01, f"{piece}")
    # A search knows it as well.
    t.vvr("cut", "gate_20261121_080000.mp4", "--event", "1", "--mask", MASK, "--evidence", "found").expect(0)
    check(t.json("found/evidence.json")["pieces"][0]["unseen"]["areas"] == [area], "the search does not tell its mask")
    plain = t.vvr("render", "gate_20261121_080000.mp4", "-o", "y.png", "--backend", "software", "--report", "plain.json").expect(0)
    check(t.json("plain.json")["unseen"] == {"masked": 0, "areas": [], "gaps": [], "damage": [], "intervals": [], "damaged": 0, "dropped": 0}, str(plain))


def test_damage_is_told_with_its_times(t):
    numbered(t, "clip.mkv", 0, 11)
    whole = t.run(["ffprobe", "-v", "error", "-select_streams", "v", "-show_entries", "packet=pts_time,pos,size", "-of", "json", "clip.mkv"]).json()["packets"]
    data = bytearray(t.path("clip.mkv").read_bytes())
    for packet in whole[40:50]:
        for at in range(int(packet["pos"]) + 20, int(packet["pos"]) + int(packet["size"])):
            data[at] ^= 0x5A
    t.write("damaged.mkv", bytes(data))
    report = render(t, "damaged.mkv", "-o", "x.png")
    unseen = report["unseen"]
    check(unseen["damaged"] == report["frames"]["damaged"] == sum(damage["packets"] for damage in unseen["damage"]) > 0, f"{unseen}")
    check(all(3 < damage[end]["seconds"] < 6 for damage in unseen["damage"] for end in ("begin", "end")), f"{unseen}")
    check(any(f"; {unseen['damaged']} damaged packet" in label["text"] for label in report["labels"]), f"{report['labels']}")
    # Damage before the part that is drawn is not in it.
    later = render(t, "damaged.mkv", "--start", "7s")
    check(later["unseen"]["damaged"] == 0 == later["frames"]["damaged"], f"{later['unseen']}")
