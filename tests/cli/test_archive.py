"""vvr archive: exactly the good clips get pictures, once each, whatever is killed on the way."""

import contextlib
import json
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import time

import pytest
from harness import check, fnv1a, hijacked, lock_name, page_data, part_name

QUICK = ("--size", "160x100", "--field-size", "48x36", "--flow", "none", "--backend", "software")
DAY_FILE = re.compile(r"index\.\d{4}-\d\d-\d\d\.js")
ENDINGS = (".png", ".html", ".jpg", ".still.jpg", ".stills.jpg", ".report.json", ".json")


def archive(t, *arguments, **options):
    return t.vvr("archive", "in", "-o", "out", *QUICK, *arguments, **options)


def outputs(t):
    return sorted(name[4:] for name in t.files() if name.startswith("out/") and t.path(name).is_file() and not DAY_FILE.fullmatch(name[4:]))


def sidecar(t, clip):
    return t.json(f"out/{clip}.json")


def nothing_hidden(t):
    check(not [name for name in t.files() if "/.vvr-" in name], f"left behind: {t.files()}")


def sidecars(t, files_there=True):
    """All of them by clip, each of which must speak the truth."""
    found = {}
    for name in outputs(t):
        if not name.endswith(".json") or name.endswith(".report.json"):
            continue
        known = t.json(f"out/{name}")
        clip = known["clip"]["path"]
        check(name == f"{clip}.json", f"{name} speaks of {clip}")
        for file in known["files"].values() if files_there else ():
            whole(t, os.path.join(os.path.dirname(name), file))
        found[clip] = known
    return found


def whole(t, name):
    """A file that was written to its end."""
    data = t.path(f"out/{name}").read_bytes()
    ends = {".png": b"IEND\xaeB`\x82", ".html": b"</html>\n", ".jpg": b"\xff\xd9", ".json": b"}\n"}
    check(data.endswith(ends[os.path.splitext(name)[1]]), f"{name} is half written")


def complete(t, good):
    """Each good clip has its files, and there is nothing else."""
    expected = sorted([clip + ending for clip in good for ending in ENDINGS] + ["index.html"])
    check(outputs(t) == expected, f"expected {expected}\nthere are {outputs(t)}")
    found = sidecars(t)
    check(all(found[clip]["state"] == "done" for clip in good), "a clip is not done")


def stamps(t, files_there=True):
    """When each done clip's sidecar was written."""
    return {clip: t.path(f"out/{clip}.json").stat().st_mtime_ns
            for clip, known in sidecars(t, files_there).items() if known["state"] == "done"}


@pytest.mark.nightly
def test_archive_of_ten_kinds_of_clips(t):
    t.clip("in/good.mp4", seconds=1, codec=("-c:v", "libx264", "-pix_fmt", "yuv420p", "-metadata", "creation_time=2026-11-20T08:00:07Z"))
    t.clip("in/long.avi", seconds=3)
    t.write("in/cut.avi", t.path("in/long.avi").read_bytes()[:-6000])
    t.clip("in/empty.avi", seconds=1)
    t.write("in/empty.avi", t.path("in/empty.avi").read_bytes()[:5600])
    t.write("in/text.avi", "Please find the recording attached.\n" * 100)
    t.ffmpeg("-f", "lavfi", "-i", "sine=duration=1", "-c:a", "aac", "in/audio.mp4")
    t.write("in/zero.mkv", b"")
    t.clip("in/odd.avi", seconds=1, codec=("-c:v", "zmbv"))
    t.ffmpeg("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=10:duration=2", "-vf", "setpts=N*N/40/TB", "-vsync", "vfr", "-c:v", "mpeg4",
             "in/variable.mkv")
    t.write("in/header.y4m", b"YUV4MPEG2 W60000 H60000 F25:1 C420\nFRAME\n" + b"x" * 1000)
    t.path("in/long.avi").unlink()
    bad = {"empty.avi": "", "text.avi": "is not a video", "audio.mp4": "", "zero.mkv": "is empty", "header.y4m": ""}
    good = sorted(path.name for path in t.path("in").iterdir() if path.name not in bad)
    # Nobody can read a link to itself, not even root.
    t.path("in/loop.avi").symlink_to("loop.avi")
    t.age("in")
    first = archive(t).expect(6, f"{len(good)} clips drawn, {len(bad)} failed", "loop.avi': it cannot be read: Too many levels")
    found = sidecars(t)
    for clip in good:
        check(found[clip]["state"] == "done" and found[clip]["frames"] > 0, f"{clip}: {found[clip]}")
    for clip, reason in bad.items():
        known = found[clip]
        check(known["state"] == "failed" and known["status"] in (3, 5) and reason in known["reason"], f"{clip}: {known}")
        check(f"{clip} failed, status {known['status']}: {known['reason']}" in first.err, f"{clip} is not named: {first}")
        check(known["files"] == {} and known["tries"] == 1, str(known))
    expected = [clip + ending for clip in good for ending in ENDINGS] + [f"{clip}.json" for clip in bad] + ["index.html"]
    check(outputs(t) == sorted(expected), "exactly the good ones have pictures")
    for _ in range(2):
        archive(t).expect(6, f"0 clips drawn, {len(bad)} failed")
    archive(t).expect(6, f"nothing to do; {len(good)} done before, {len(bad)} failed three times")


def test_archive_does_what_is_new(t):
    t.old_clips("a.avi", "cam/b.avi")
    first = archive(t).expect(0, "1/2 ", "a.avi: ", "cam/b.avi: ", "2 clips drawn, 0 failed")
    check(re.search(r"\d/2 a\.avi: \d+ events?, \d+\.\d s\n", first.err), str(first))
    complete(t, ["a.avi", "cam/b.avi"])
    known = sidecar(t, "cam/b.avi")
    file = t.path("in/cam/b.avi").stat()
    check(known["clip"] == {"path": "cam/b.avi", "bytes": file.st_size, "modified_ns": file.st_mtime_ns}, str(known))
    check((known["state"], known["tries"], known["status"], known["frames"]) == ("done", 1, 0, 10), str(known))
    check(known["files"]["report"] == "b.avi.report.json" and known["recorded"] is None, str(known))
    t.expect_picture("out/cam/b.avi.png")
    check("./../../in/cam/b.avi" in t.path("out/cam/b.avi.html").read_text(), "the page does not find its clip")

    before = stamps(t)
    archive(t).expect(0, "'out': nothing to do; 2 done before")
    archive(t, "--quiet").expect(0)
    check(stamps(t) == before, "done twice")

    # Each reason why a clip is to be done, and only such clips are.
    def only(reasons):
        expected = [f"{reason:<15} {clip}  camera not known, time of day not known" for clip, reason in reasons.items()]
        lines = archive(t, "--dry-run").expect(0, out=None).out.splitlines()
        check(sorted(lines) == sorted(expected), f"{lines}")
        kept = {other: stamp for other, stamp in stamps(t, files_there=False).items() if other not in reasons}
        archive(t).expect(0, *[f" {clip}: " for clip in reasons], f"{len(reasons)} clips drawn")
        check(kept.items() <= stamps(t).items(), "another clip was done too")

    t.old_clips("c.avi", "d.avi")
    t.path("in/a.avi").write_bytes(t.path("in/a.avi").read_bytes() + b"more")
    t.age("in")
    only({"a.avi": "changed", "c.avi": "new", "d.avi": "new"})
    t.stamp("in/a.avi", -7200)
    t.path("out/c.avi.jpg").unlink()
    t.path("out/d.avi.json").unlink()
    only({"a.avi": "changed", "c.avi": "files missing", "d.avi": "new"})
    check(archive(t, "--dry-run", "--opacity", "2").out.count("other settings") == 4, "settings make no difference")
    archive(t, "--write", "pictures,index").expect(0, "4 clips drawn")
    check(not any(name.endswith("avi.html") for name in outputs(t)), "pages that are not true any more")


def test_archive_uses_the_contents_of_files_of_settings(t):
    t.old_clips("a.avi")
    t.ffmpeg("-f", "lavfi", "-i", "color=white:size=64x48", "-frames:v", "1", "mask.png")
    archive(t, "--mask", "mask.png").expect(0, "1 clip drawn")
    archive(t, "--mask", "mask.png").expect(0, "nothing to do")
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=64x48", "-frames:v", "1", "mask.png")
    check(archive(t, "--mask", "mask.png", "--dry-run").out == "other settings  a.avi  camera not known, time of day not known\n", "another mask")
    t.write("settings.ini", "[archive]\nsize = 120x80\n")
    t.vvr("archive", "in", "-o", "small", "--config", "settings.ini", "--flow", "none", "--backend", "software").expect(0, "1 clip drawn")
    t.expect_picture("small/a.avi.png", (120, 80))


def test_archive_leaves_what_is_still_written(t):
    t.old_clips("a.avi", "b.avi")
    os.utime(t.path("in/b.avi"))
    archive(t).expect(0, "1 clip drawn, 0 failed", "1 still being written")
    check(archive(t, "--dry-run").out == "still written   b.avi  camera not known, time of day not known\n", "dry run")
    check("out/b.avi.png" not in t.files(), "b.avi was drawn")
    t.age("in")
    archive(t).expect(0, "1 clip drawn", "1 done before")


@pytest.mark.nightly
def test_archive_tries_again(t):
    t.old_clips("a.avi")
    t.write("in/bad.avi", "no video")
    t.age("in")
    archive(t, "--quiet").expect(6, "bad.avi failed, status 3: 'in/bad.avi'", code="not-video")
    for tries in (2, 3):
        check(archive(t, "--dry-run").out.startswith("failed, again   bad.avi: 'in/bad.avi' is not"), "dry run")
        archive(t).expect(6, "1/1 bad.avi failed", "1 done before", code="not-video")
        check(sidecar(t, "bad.avi")["tries"] == tries, str(sidecar(t, "bad.avi")))
    # A service that runs every ten minutes has not failed for a clip that is known to be dead.
    result = archive(t).expect(0, "nothing to do; 1 done before, 1 failed three times")
    check("is not a video" not in result.err, "told again and again")
    check(archive(t, "--quiet").expect(0).err == "", "a dead clip is news")
    check(archive(t, "--dry-run").out.startswith("given up        bad.avi: 'in/bad.avi' is not"), "dry run")
    t.copy("in/a.avi", "in/bad.avi")
    t.age("in")
    archive(t).expect(0, "1/1 bad.avi: ")
    check(sidecar(t, "bad.avi")["tries"] == 1, "a good clip was tried once")
    # A clip that goes bad keeps the picture of what it was, which may be all that is left of it.
    before = sidecar(t, "a.avi")
    t.write("in/a.avi", "no video")
    t.age("in")
    archive(t).expect(6, "a.avi failed, status 3: 'in/a.avi'", "is kept", code="not-video")
    check([name for name in outputs(t) if name.startswith("a.")] == sorted(f"a.avi{ending}" for ending in ENDINGS), str(outputs(t)))
    after = sidecar(t, "a.avi")
    check((after["state"], after["frames"], after["files"]) == ("failed", before["frames"], before["files"]), f"{after}")
    check(after["shows"] == {name: before["clip"][name] for name in ("bytes", "modified_ns")} | {"settings": before["settings"]}, f"{after}")
    check("failed; shows what was until" in t.path("out/index.html").read_text(), "the index does not say it")


def test_archive_counts_no_try_of_a_clip_that_it_may_not_read(t):
    t.old_clips("a.avi", "shut.avi")
    t.path("in/shut.avi").chmod(0)
    for _ in range(4):
        t.vvr_with_permissions("archive", "in", "-o", "out", *QUICK).expect(
            6, "shut.avi failed, cannot read 'in/shut.avi': Permission denied; check its permissions", code="permission-denied")
    check(not t.path("out/shut.avi.json").exists(), f"{outputs(t)}")
    nothing_hidden(t)
    t.path("in/shut.avi").chmod(0o644)
    archive(t).expect(0, "1 clip drawn", "1 done before")


def test_a_day_says_what_it_lacks_until_it_can_be_read(t):
    t.zone("UTC")
    t.old_clips(*[f"hall/2026-11-21_09-00-0{second}.avi" for second in (0, 1, 2)])
    t.path("in/hall/2026-11-21_09-00-01.avi").chmod(0)
    line = "'in/hall/2026-11-21_09-00-01.avi': Permission denied"
    run = ("archive", "in", "-o", "out", *QUICK, "--per", "day", "--quiet")
    for _ in range(4):
        t.vvr_with_permissions(*run).expect(6, "vvr: hall/2026-11-21: cannot read ", line, code="partial")
    known = sidecar(t, "hall/2026-11-21")
    check(known["state"] == "done" and known["frames"] == 20 and known["day"]["unread"] == {"hall": ["2026-11-21_09-00-01.avi"]}, f"{known}")
    row = days_of(t)[0]["hall", "2026-11-21"]["row"]
    check(row[9] is None and line in row[10], f"{row}")
    check("3 files, 1 could not be read" in t.path("out/hall/2026-11-21.html").read_text(), "the page does not say it")
    said = t.vvr_with_permissions(*run, "--log-format", "json").expect(6).err
    told = json.loads(said.splitlines()[0])
    check((told["camera"], told["clip"], told["code"]) == ("hall", "hall/2026-11-21", "partial"), said)
    t.path("in/hall/2026-11-21_09-00-01.avi").chmod(0o644)
    t.vvr_with_permissions(*run).expect(0)
    known = sidecar(t, "hall/2026-11-21")
    check(known["frames"] == 30 and "unread" not in known["day"] and len(days_of(t)[0]["hall", "2026-11-21"]["row"]) == 9, f"{known}")


def test_clips_outside_the_span_are_skipped(t):
    t.zone("UTC")
    t.old_clips("gate/2026-11-21_02-30-00.avi", "gate/2026-11-21_12-00-00.avi", "gate/2026-11-22_12-00-00.avi")
    archive(t).expect(0, "3 clips drawn")
    span = ("--between", "02:00-05:00")
    archive(t, *span).expect(0, "1 clip drawn, 0 failed", "2 without a frame in the given span")
    check(outputs(t) == sorted([f"gate/2026-11-21_02-30-00.avi{ending}" for ending in ENDINGS] + ["index.html"] +
                               [f"gate/2026-11-2{day}_12-00-00.avi.json" for day in (1, 2)]), f"{outputs(t)}")
    check(sidecar(t, "gate/2026-11-22_12-00-00.avi")["state"] == "outside", "the sidecar")
    check([row[1] for row in days_of(t)[1]["clips"]] == ["./gate/2026-11-21_02-30-00.avi"], "the index")
    archive(t, *span).expect(0, "nothing to do; 1 done before, 2 without a frame in the given span")
    archive(t, *span, "--per", "day").expect(0, "1 clip drawn, 0 failed", "1 without a frame in the given span")
    archive(t).expect(0, "3 clips drawn")


def test_archive_skips_recycle_bins_and_snapshots(t):
    t.old_clips("gate/a.avi", "#recycle/gate/b.avi", "@Recently-Snapshot/x/gate/a.avi", "$RECYCLE.BIN/c.avi", "gate/@eaDir/a.avi/note.txt")
    archive(t, "--dry-run").expect(0, "'in': at least 3 clips in folders of deleted files or snapshots left out: '#recycle', '$RECYCLE.BIN', "
                                   "'@Recently-Snapshot'; to draw them, give such a folder as CLIPS", out=None)
    check(archive(t, "--dry-run").out.split()[1] == "gate/a.avi", "the plan")
    t.vvr("archive", "in/#recycle", "-o", "out", "--dry-run").expect(0, out="new             gate/b.avi  camera gate, time of day not known\n")
    t.vvr("info", "in", "--json", "--quick").expect(0, out=None)


def test_days_by_the_times_of_containers(t):
    t.zone("UTC")
    for number, day in enumerate((5, 5, 20)):
        name = f"in/A01/IMAG{number:04}.MP4"
        t.clip(name, seconds=1, codec=("-c:v", "mpeg4", "-metadata", f"creation_time=2026-10-{day:02}T11:43:0{number}Z"))
    t.clip("in/A01/IMAG0009.AVI", seconds=1)
    t.age("in")
    said = archive(t, "--per", "day", "--start-time", "container", "--exclude", "*.AVI", "--dry-run").expect(0, out=None)
    check("A01/2026-10-05" in said.out and "camera A01, 2026-10-05 11:43:01 when the container was written" in said.out, said.out)
    check(said.err == "", f"a warning: {said.err}")
    archive(t, "--per", "day", "--start-time", "container", "--exclude", "*.AVI").expect(0, "A01/2026-10-05: ", "A01/2026-10-20: ", "2 clips drawn")
    check(set(days_of(t)[0]) == {("A01", "2026-10-05"), ("A01", "2026-10-20")}, f"{days_of(t)[0]}")
    # Pruning goes by the same days.
    archive(t, "--per", "day", "--start-time", "container", "--exclude", "*.AVI", "--prune").expect(0, "nothing to do; 2 done before")
    archive(t, "--per", "day", "--prune", "--dry-run", "--start-time", "container").expect(
        0, "no time in the names or containers of 1 clip, for example 'A01/IMAG0009.AVI'", out=None)
    check(len(days_of(t)[0]) == 2, "pruned")


def test_a_shortage_of_memory_counts_no_try_that_lasts(t):
    t.old_clips("a.avi")
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (400 << 20, 400 << 20))
    for _ in range(3):
        check(archive(t, preexec_fn=limit).status in (5, 6), "400 MB are enough")
    if sidecar_there := t.path("out/a.avi.json").exists():
        check(sidecar(t, "a.avi")["limits"]["memory"] <= 400 << 20, f"{sidecar(t, 'a.avi')}")
    archive(t).expect(0, "1 clip drawn")
    check(sidecar_there, "no try was counted, so nothing was tested")


def test_archive_tries_again_with_a_higher_limit(t):
    t.old_clips("stay.avi")  # what libvvr_hijack.so makes of this clip lasts for ever
    for tries in (1, 2, 3):
        archive(t, "--timeout", "1s", env=hijacked()).expect(6, "stay.avi failed, status 5: ", code="worker-timeout")
        check(sidecar(t, "stay.avi")["tries"] == tries and sidecar(t, "stay.avi")["limits"]["seconds"] == 1, f"{sidecar(t, 'stay.avi')}")
    archive(t, "--timeout", "1s").expect(0, "1 failed three times")
    archive(t, "--timeout", "2s", env=hijacked()).expect(6, "stay.avi failed, status 5: ", code="worker-timeout")
    check(sidecar(t, "stay.avi")["tries"] == 1 and sidecar(t, "stay.avi")["limits"]["seconds"] == 2, f"{sidecar(t, 'stay.avi')}")
    archive(t, "--timeout", "2s").expect(0, "1 clip drawn")
    check("limits" not in sidecar(t, "stay.avi"), f"{sidecar(t, 'stay.avi')}")


@pytest.mark.nightly
def test_archive_takes_any_name(t):
    names = ["-o [a] %05d* ####{brick}.avi", "a b'\"<&>ä€😀.avi", "line\nbreak%41.avi", "-dir/cam:1/d.avi", "a.avi", "a.mp4"]
    t.old_clips(*names)
    raw = os.fsencode(t.path("in")) + b"/\xff\xfe.avi"
    shutil.copy2(t.path("in/a.avi"), raw)
    count = len(names) + 1
    archive(t).expect(0, f"{count} clips drawn, 0 failed", "%FF%FE.avi: ", "line%0Abreak%2541.avi: ")
    for ending in (b".png", b".html", b".jpg", b".json"):
        check(os.path.exists(os.fsencode(t.path("out")) + b"/\xff\xfe.avi" + ending), f"no {ending}")
    for name in names:
        whole(t, name + ".png")
    archive(t).expect(0, f"nothing to do; {count} done before")
    check("%FF%FE.avi" in t.path("out/index.html").read_text(), "the index leaves one out")


def test_archive_goes_on_past_what_it_cannot_read(t):
    t.old_clips("a.avi", "shut/b.avi", "open/c.avi")
    t.path("in/gone.avi").symlink_to("nowhere.avi")
    if os.geteuid() != 0:
        t.path("in/shut").chmod(0)
    result = archive(t)
    t.path("in/shut").chmod(0o755)
    result.expect(6, "'in/gone.avi': it cannot be read: No such file or directory; fix that, or exclude it")
    if os.geteuid() != 0:
        result.expect(6, "'in/shut'", "Permission denied")
    check({"a.avi.png", "open/c.avi.png"} <= set(outputs(t)), "others are left out")
    # Something stands where a folder has to be.
    t.path("in/gone.avi").unlink()
    t.old_clips("cam/d.avi")
    t.write("out/cam", "in the way")
    archive(t, "--write", "pictures,pages").expect(6, "cam/d.avi failed, ", "'out/cam'", code="not-a-folder")


def test_archive_refuses_what_cannot_be(t):
    t.old_clips("a.avi")
    t.vvr("archive", "in").expect(1, "-o DIR", code="output-missing")
    t.vvr("archive", "-o", "out").expect(1, "INPUT", code="input-missing")
    t.vvr("archive", "in", "in", "-o", "out").expect(1, "'in'", code="input-unsuitable")
    t.vvr("archive", "in", "-o", "in").expect(1, "such as 'in/pictures'", code="options-conflict")
    t.vvr("archive", "none", "-o", "out").expect(2, "'none'", "No such file or directory", code="file-not-found")
    t.vvr("archive", "in/a.avi", "-o", "out").expect(2, "vvr render 'in/a.avi' -o picture.png", code="not-a-folder")
    t.write("file", "")
    t.vvr("archive", "in", "-o", "file").expect(2, "'file'", code="not-a-folder")
    t.vvr("archive", "in", "-o", "file/out").expect(2, "'file/out'", code="not-a-folder")
    t.vvr("archive", "in", "-o", "/proc/out").expect(2, "'/proc/out'", "-o", code="file-not-found")
    t.vvr("archive", "in", "-o", "out", "--write", "index", "--prune").expect(1, "--write index", "--prune", code="options-conflict")
    t.vvr("archive", "in", "-o", "out", "--names", "%Y-%m-%d").expect(
        1, "'%Y-%m-%d'", "%Y, %m (or %b), %d and %H", "--names", code="name-pattern-invalid")
    t.vvr("archive", "in", "-o", "out", "--names", "{cam}").expect(1, "'{cam}'", "{camera}", code="name-pattern-invalid")
    t.vvr("archive", "in", "-o", "out", "--start", "2s", "--end", "1s").expect(1, "--end", code="span-empty")
    archive(t, "--margin", "5s").expect(1, "--margin", "--keep-events", code="option-needs-another")
    t.vvr("archive", "in", "-o", "out", "-o", "other").expect(1, "'out'", "'other'", code="options-conflict")
    t.folder_of("flow/a.flo")
    archive(t, "--flow", "flow").expect(1, "--flow", "vvr render CLIP --flow 'flow'", code="options-conflict")
    archive(t, "--max-memory", "1000").expect(
        1, "--max-memory", "'1000'", "200M", "1G", code="option-value-out-of-range")
    check(not t.path("out").exists(), "a refused run leaves something")


def test_archive_without_opengl_blames_no_clip(t):
    t.old_clips("a.avi", "b.avi")
    result = t.vvr("archive", "in", "-o", "out", "--size", "160x100", "--backend", "egl:200")
    result.expect(4, "egl", "`vvr doctor`", code="opengl-unavailable")
    check(all(known["tries"] == 0 for known in sidecars(t).values()), "the clips are blamed")
    archive(t).expect(0, "2 clips drawn")


@pytest.mark.nightly
def test_archive_limits_its_workers(t):
    t.old_clips("a.avi")
    t.clip("part.avi", seconds=60, size="384x288")
    t.ffmpeg("-stream_loop", "50", "-i", "part.avi", "-c", "copy", "in/long.avi")
    t.age("in")
    archive(t, "--timeout", "6s", "--field-size", "source", "--flow", "horn-schunck").expect(
        6, "long.avi failed, status 5: ", "a.avi: ", code="worker-timeout")
    check(sidecar(t, "long.avi")["code"] == "worker-timeout", str(sidecar(t, "long.avi")))
    check([name for name in outputs(t) if name.startswith("long")] == ["long.avi.json"], str(outputs(t)))
    t.path("in/long.avi").unlink()
    t.vvr("archive", "in", "-o", "little", *QUICK, "--max-memory", "200M", "--size", "4000x4000").expect(
        6, "a.avi failed, status ", "--max-memory", code="out-of-memory")


def test_an_archive_says_what_its_workers_warn_of(t):
    t.clip("long.avi", seconds=3)
    t.write("in/cut.avi", t.path("long.avi").read_bytes()[:-6000])
    t.age("in")
    archive(t).expect(0, "cut.avi: 'in/cut.avi': 1 damaged packet")
    check(archive(t, "--quiet").err == "", "a warning of what is done before")


@pytest.mark.nightly
def test_archive_is_shared_out(t):
    t.old_clips(*[f"cam{k % 3}/{k}.avi" for k in range(9)])
    options = ("--write", "pictures,pages", "--dry-run")
    parts = [archive(t, "--part", f"{number}/3", *options).out.splitlines() for number in (1, 2, 3)]
    check(all(parts) and sorted(sum(parts, [])) == sorted(archive(t, "--dry-run").out.splitlines()),
          "not each clip once")
    for number, part in enumerate(parts):
        check(all(fnv1a(line[16:].split("  ")[0]) % 3 == number for line in part), "not the hash that docs/archive.md names")
    share = [line[16:].split("  ")[0] for line in parts[1]]
    archive(t, "--part", "2/3", "--write", "pictures,pages").expect(0, "drawn, 0 failed")
    check("index.html" not in outputs(t), "a shard writes an index")
    t.vvr("archive", "-o", "out", "--write", "index").expect(0, "'out/index.html' is up to date")
    complete(t, share)


def test_archive_prunes(t):
    t.old_clips("a.avi", "b.avi", "cam/2026-11-21/c.avi", "cam/2026-11-22/c.avi", "disk/d.avi", "away/e.avi", "linked/f.avi")
    archive(t).expect(0)
    t.write("out/b.avi.txt", "a note")
    t.write("out/mine/x.avi.png", "not vvr's")
    t.path("in/b.avi").unlink()
    t.path("in/cam/2026-11-21/c.avi").unlink()
    t.path("in/cam/2026-11-21").rmdir()
    t.path("in/disk/d.avi").unlink()
    t.path("in/away").rename(t.path("elsewhere"))
    t.path("in/linked").rename(t.path("far"))
    t.path("in/linked").symlink_to("nowhere")
    archive(t).expect(0, "nothing to do")
    check("b.avi.png" in outputs(t), "removed unasked")
    check(sorted(archive(t, "--prune", "--dry-run").out.splitlines()) == ["gone            b.avi", "gone            cam/2026-11-21/c.avi"], "dry run")
    archive(t, "--prune").expect(0, "b.avi: the clip was deleted, so its picture was removed",
                                 *[f"warning: 'in/{name}' is empty or missing, so its pictures are kept: its disk may not be mounted" for name in ("disk", "away", "linked")])
    kept = ("a.avi", "cam/2026-11-22/c.avi", "disk/d.avi", "away/e.avi", "linked/f.avi")
    expected = [clip + ending for clip in kept for ending in ENDINGS]
    check(outputs(t) == sorted(expected + ["b.avi.txt", "mine/x.avi.png", "index.html"]), str(outputs(t)))
    text = t.path("out/index.html").read_text()
    check("a.avi" in text and "b.avi" not in text, "the index is old")
    t.path("in/a.avi").unlink()
    t.path("in/cam/2026-11-22/c.avi").unlink()
    archive(t, "--prune").expect(2, code="archive-empty")
    check("a.avi.png" in outputs(t), "an empty disk took the pictures with it")


def test_archive_says_that_it_cannot_remove(t):
    """The others are removed, and the run has not succeeded."""
    t.old_clips("gate/gone.avi", "hall/gone.avi", "hall/a.avi")
    archive(t).expect(0, "3 clips drawn")
    t.path("in/gate/gone.avi").unlink()
    t.path("in/hall/gone.avi").unlink()
    t.copy("in/hall/a.avi", "in/gate/a.avi")
    t.stamp("in/gate/a.avi", -40 * 86400)
    run = ("archive", "in", "-o", "out", *QUICK, "--keep", "30d")
    t.path("out/gate").chmod(0o555)
    pruned = t.vvr_with_permissions(*run, "--prune")
    known = t.path("out/gate/gone.avi.json").read_text()
    t.path("out/gate/gone.avi.json").write_text(re.sub(r'"modified_ns": \d+', '"modified_ns": 1', known))
    expired = t.vvr_with_permissions(*run)
    t.path("out/gate").chmod(0o755)
    pruned.expect(2, "cannot lock 'out/gate/", "hall/gone.avi: the clip was deleted, so its picture was removed: hall/gone.avi.png, ", code="permission-denied")
    expired.expect(2, "cannot lock 'out/gate/", code="permission-denied")
    archive(t, "--keep", "30d").expect(0, "gate/gone.avi: older than --keep; removed gate/gone.avi.png, ")


def test_archive_names_a_folder_of_pictures_that_it_cannot_read(t):
    t.old_clips("gate/a.avi", "hall/a.avi")
    archive(t, "--dry-run", "--prune", "--keep", "30d").expect(0, out=None)  # no folder yet
    check(not t.path("out").exists(), "a dry run leaves something")
    archive(t).expect(0, "2 clips drawn")
    t.path("out/lost+found").mkdir(0)  # of a file system, not of the archive
    t.path("out/gate").chmod(0)
    indexed = t.vvr_with_permissions("archive", "-o", "out", "--write", "index")
    kept = t.vvr_with_permissions("archive", "in", "-o", "out", *QUICK, "--match", "hall/*", "--keep", "30d")
    t.path("out/gate").chmod(0o755)
    check("lost+found" not in indexed.err + kept.err, str(indexed))
    indexed.expect(0, "warning: 'out/gate': Permission denied; it is left unchanged and is missing from the index")
    kept.expect(2, "cannot read 'out/gate': Permission denied; nothing is removed there", code="io")


def test_archive_takes_no_other_file_for_a_lock(t):
    """Whoever may write into PICTURES can't have files of others removed or written."""
    t.old_clips("a.avi", "b.avi", "c.avi", "d.avi")
    victims = ["victim/photo.png", "out/photo.png", "victim/empty"]
    for name in victims:
        t.write(name, "" if name.endswith("empty") else "mine")
    t.write(f"out/{lock_name('../victim/photo')}", "../victim/photo")
    t.write("out/.vvr-1111111111111111.lock", "photo")
    t.path("out/.vvr-3333333333333333.lock").mkdir()
    before = t.files()
    t.vvr("archive", "-o", "out", "--write", "index", timeout=20).expect(0, "'out/index.html' is up to date")
    check(t.files() == sorted(before + ["out/index.html"]), f"files are gone or new: {set(before) ^ set(t.files())}")
    check(t.path("out/.vvr-1111111111111111.lock").read_text() == "photo", "what is no lock was written")
    # A link, or a pipe, at the place of a clip's own lock.
    t.path(f"out/{lock_name('a.avi')}").symlink_to("../victim/new")
    t.path(f"out/{lock_name('b.avi')}").symlink_to("../victim/empty")
    os.mkfifo(t.path(f"out/{lock_name('c.avi')}"))
    archive(t, timeout=60).expect(
        6, "1 clip drawn, 3 failed", "a.avi failed, ", f"'out/{lock_name('a.avi')}'", "b.avi failed, ", f"'out/{lock_name('b.avi')}'",
        f"'out/{lock_name('c.avi')}'", code="not-a-file")
    check(not t.path("victim/new").exists(), "a link was followed to nowhere")
    check([t.path(name).read_text() for name in victims] == ["mine", "mine", ""], "files of others were written")
    t.path("out/index.html").unlink()
    t.path(f"out/{lock_name('index.html')}").symlink_to("../victim/new")
    t.vvr("archive", "-o", "out", "--write", "index").expect(2, f"'out/{lock_name('index.html')}'", code="not-a-file")


def test_archive_tidies_only_what_is_the_clips(t):
    t.old_clips("gone.report")
    archive(t, "--match", "*").expect(0, "1 clip drawn")
    for name in ("gone", "index", "other"):
        t.write(f"out/{lock_name(name)}", name)
    t.write("out/gone.png", "half")
    t.path("out/gone.jpg").mkdir()
    t.path("out/gone.html").symlink_to("other.html")
    t.write("out/other.txt", "mine")
    kept = [f"gone.report{ending}" for ending in ENDINGS] + ["gone.html", "gone.jpg", "index.html", "other.txt"]
    t.vvr("archive", "-o", "out", "--write", "index").expect(0)
    check(sorted(os.listdir(t.path("out"))) == sorted(kept), str(os.listdir(t.path("out"))))


def test_archive_replaces_no_page_of_others(t):
    """A folder may be that of a web site. vvr checks whose index it has before it draws."""
    t.old_clips("a.avi")
    t.write("out/index.html", "<!DOCTYPE html>\n<title>My pictures</title>\n")
    words = "cannot write 'out/index.html': it is another page, which vvr did not write; choose another folder for the pictures, or move this page"
    archive(t).expect(2, words, code="file-invalid")
    check(outputs(t) == ["index.html"], f"{outputs(t)}")
    t.vvr("archive", "-o", "out", "--write", "index").expect(2, words, code="file-invalid")
    check("My pictures" in t.path("out/index.html").read_text(), "it was replaced")
    archive(t, "--write", "pictures").expect(0, "1 clip drawn")
    t.path("out/index.html").unlink()
    archive(t).expect(0, "1 clip drawn")
    archive(t).expect(0, "nothing to do")


def test_archive_names_names_that_are_too_long(t):
    long = {length: "n" * (length - 4) + ".avi" for length in (243, 244, 251, 255)}
    t.old_clips("a.avi", *long.values())
    t.stamp("in/a.avi", 1)  # so that it comes last
    result = archive(t, "--jobs", "1").expect(6, "2 clips drawn, 0 failed")
    for length in (244, 251, 255):
        line = next((line for line in result.err.splitlines() if f"'in/{long[length]}'" in line), "")
        check(f"'{long[length]}.report.json'" in line and f"{length + 12} bytes" in line and "255" in line, f"{result}\nof {length} bytes: {line}")
    complete(t, ["a.avi", long[243]])
    archive(t).expect(6, "nothing to do; 2 done before")


def test_archive_goes_on_past_a_sidecar_that_cannot_be_written(t):
    full = "No space left on device.avi"
    t.old_clips("a.avi", "b.avi", "c.avi", full)
    t.stamp("in/a.avi", 1)
    for name in ("b.avi", full):
        t.path(f"out/{name}.json").mkdir(parents=True)
    t.path("out/c.avi.json").symlink_to("c.avi.json")
    archive(t, "--jobs", "1").expect(
        6, "1 clip drawn, 3 failed", "b.avi failed, ", "'out/b.avi.json'", "c.avi failed, ", "'out/c.avi.json'", f"{full} failed, ",
        "4/4 a.avi: ", code="not-a-file")
    check("a.avi" in t.path("out/index.html").read_text(), "no index")
    nothing_hidden(t)


def test_archive_removes_what_a_killed_index_left(t):
    t.old_clips("a.avi")
    archive(t).expect(0, "1 clip drawn")
    t.write(f"out/{lock_name('index.html')}", "index.html")
    t.write(f"out/{part_name('index.html', 3)}", "half")
    t.write(f"out/.vvr-{fnv1a('index.html'):016x}-4711-0.part", "half, of an older vvr")
    archive(t).expect(0, "nothing to do; 1 done before")
    complete(t, ["a.avi"])


def gone_in_index(t):
    """The clips that the index marks as gone."""
    return sorted(row[1] for row in days_of(t)[1]["clips"] if row[5] & 256)


def test_index_marks_as_gone_only_what_prune_would_remove(t):
    """A camera's disk that is not mounted has lost no clip."""
    t.old_clips("gate/a.avi", "hall/b.avi", "hall/gone.avi", "yard/c.avi")
    archive(t).expect(0, "4 clips drawn")
    check(gone_in_index(t) == [], f"{gone_in_index(t)}")
    t.path("in/hall/gone.avi").unlink()
    t.path("in/gate/a.avi").unlink()
    t.path("in/yard").rename(t.path("elsewhere"))
    archive(t, "--match", "b.avi").expect(0)
    check(gone_in_index(t) == ["./hall/gone.avi"], f"{gone_in_index(t)}")
    t.vvr("archive", "in", "-o", "out", "--write", "index").expect(0)
    check(gone_in_index(t) == ["./hall/gone.avi"], f"{gone_in_index(t)}")
    # No clip at all: nobody knows, and the index is written.
    t.path("in/hall/b.avi").unlink()
    t.write("in/note.txt", "mine")
    archive(t).expect(0, "no clips found")
    check(gone_in_index(t) == [], f"{gone_in_index(t)}")


def test_archive_removes_what_a_killed_redraw_left_of_a_clip_that_goes(t):
    """With --prune and with --keep: nobody will draw it again."""
    t.old_clips("gate/a.avi", "gate/gone.avi", "gate/old.avi")
    t.stamp("in/gate/old.avi", -40 * 86400)
    archive(t, "--write", "pictures,index").expect(0, "3 clips drawn")
    for name in ("gone.avi", "old.avi"):
        t.write(f"out/gate/{lock_name(name)}", name)
        t.write(f"out/gate/{part_name(f'{name}.json')}", "half")
        t.write(f"out/gate/.vvr-{fnv1a(name):016x}.new/{name}.png", "half")
        t.write(f"out/gate/{name}.html", "moved to its place, and in no sidecar")
        t.write(f"out/gate/{name}.txt", "mine")
    t.path("in/gate/gone.avi").unlink()
    archive(t, "--write", "pictures", "--prune", "--keep", "30d").expect(
        0, "gate/gone.avi: the clip was deleted", "gate/old.avi: older than --keep; removed gate/old.avi.png, ")
    nothing_hidden(t)
    left = [name for name in outputs(t) if not name.startswith("gate/a.avi")]
    check(left == ["gate/gone.avi.txt", "gate/old.avi.txt", "index.html"], f"{left}")


def test_archive_removes_what_a_killed_run_left_of_a_clip_that_fails(t):
    """It was killed before it wrote the sidecar: no later one would name these files."""
    t.old_clips("gate/bad.avi")
    archive(t).expect(0, "1 clip drawn")
    t.path("out/gate/bad.avi.json").unlink()
    t.write(f"out/gate/{lock_name('bad.avi')}", "bad.avi")
    for ending in ENDINGS[:-1]:
        if ending != ".jpg":
            os.utime(t.path(f"out/gate/bad.avi{ending}"))
    t.stamp("out/gate/bad.avi.jpg", -3600)
    t.write("in/gate/bad.avi", "no video")
    t.age("in")
    archive(t).expect(6, "1 failed", code="not-video")
    check(outputs(t) == ["gate/bad.avi.jpg", "gate/bad.avi.json", "index.html"], f"a complete run made one of them: {outputs(t)}")
    nothing_hidden(t)


def test_what_a_complete_run_made_outlives_a_killed_redraw(t):
    """The sidecar was removed to have the clip drawn again; that run was killed, and the recorder removed the clip."""
    t.old_clips("gate/a.avi", "gate/gone.avi", seconds=2)
    archive(t, "--keep-events").expect(0, "2 clips drawn")
    t.path("out/gate/gone.avi.json").unlink()
    t.write("out/gate/gone.avi.events/event-1.mp4", "all that is left of it")
    before = [name for name in t.files() if "gone.avi." in name]
    for name in before:
        t.stamp(name, -60)
    t.write(f"out/gate/{lock_name('gone.avi')}", "gone.avi")
    t.path("in/gate/gone.avi").unlink()
    archive(t, "--keep-events").expect(0, "nothing to do")
    check([name for name in t.files() if "gone.avi." in name] == before and "out/gate/gone.avi.png" in before, f"{t.files()}")
    nothing_hidden(t)


def start(t, *arguments, **options):
    return t.start("archive", "in", "-o", "out", *QUICK, *arguments, stderr=subprocess.PIPE, start_new_session=True,
                   **options)


@pytest.mark.nightly
def test_archives_at_once_share_the_work(t):
    names = [f"cam{k % 2}/{k}.avi" for k in range(5)]
    t.old_clips(*names)
    runs = [start(t) for _ in range(3)]
    said = [run.communicate(timeout=100)[1].decode() for run in runs]
    check([run.returncode for run in runs] == [0, 0, 0], "\n".join(said))
    drawn = sum(int(number) for text in said for number in re.findall(r"(\d+) clips? drawn", text))
    check(drawn == len(names), f"{drawn} clips were drawn\n" + "\n".join(said))
    complete(t, names)
    nothing_hidden(t)


def workers_of(run):
    try:
        return [int(number) for number in pathlib.Path(f"/proc/{run.pid}/task/{run.pid}/children").read_text().split()]
    except FileNotFoundError:
        return []


def first_workers_of(run):
    """Once there are any."""
    workers = []
    while not workers and run.poll() is None:
        workers = workers_of(run)
        time.sleep(0.01)
    return workers


def no_worker_left(workers):
    end = time.monotonic() + 10
    while any(os.path.exists(f"/proc/{number}/fd/0") for number in workers):
        check(time.monotonic() < end, f"workers outlive their parent: {workers}")
        time.sleep(0.02)


@pytest.mark.nightly
@pytest.mark.timeout(600)
def test_archive_that_is_killed(t):
    """In every way, at random moments; after the next whole run all is as if nothing had been."""
    names = [f"cam{k % 3}/{k}.avi" for k in range(10)]
    t.old_clips(*names)
    random.seed(1)
    for way in ("kill all", "kill a worker", "kill the parent", "disk full", "end politely"):
        done = stamps(t) if t.path("out").exists() else {}
        if way == "disk full":
            # A limit on the size of files is met where a full disk would be, and says much the same. A smaller one would
            # also be met by what workers are told, which is on no disk.
            full = start(t, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (random.choice((8000, 20000)),) * 2))
            said = full.communicate(timeout=240)[1].decode()
            check(full.returncode == 2 or len(done) == len(names), f"status {full.returncode}: {said}")
        else:
            run = start(t)
            time.sleep(random.uniform(0.02, 2.0))
            workers = workers_of(run)
            with contextlib.suppress(ProcessLookupError):
                if way == "kill all":
                    os.killpg(run.pid, signal.SIGKILL)
                else:
                    victim = random.choice(workers) if workers and way == "kill a worker" else run.pid
                    os.kill(victim, signal.SIGTERM if way == "end politely" else signal.SIGKILL)
            run.communicate(timeout=240)
            if way == "end politely":
                check(run.returncode in (-signal.SIGTERM, 0, 6), f"status {run.returncode}")
            no_worker_left(workers)
        after = stamps(t)
        check(done.items() <= after.items(), "something was done twice")
        for name in outputs(t):
            if "/." not in f"/{name}":
                whole(t, name)
    done = stamps(t)
    check(archive(t, timeout=300).status == 0, "the last run")
    check(done.items() <= stamps(t).items(), "something was done twice")
    complete(t, names)
    archive(t).expect(0, f"nothing to do; {len(names)} done before")


def test_archive_on_a_full_disk(t):
    t.old_clips(*[f"{k}.avi" for k in range(8)])
    # A small disk of one's own, where the system lets anybody have one.
    small = ["unshare", "-rm", "sh", "-c", 'mkdir out && mount -t tmpfs -o size=120k none out && "$@"; status=$?; ls -A out; exit $status', "sh"]
    if t.run(["unshare", "-rm", "true"]).status != 0:
        return
    result = t.run([*small, t.vvr_path, "archive", "in", "-o", "out", *QUICK])
    result.expect(2, "'out", code="disk-full", out=None)
    check(".vvr-" not in result.out, f"left behind: {result}")


@pytest.mark.nightly
def test_archive_ends_its_workers(t):
    t.old_clips(*[f"{k}.avi" for k in range(6)])
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        run = start(t, "--jobs", "2")
        workers = first_workers_of(run)
        os.kill(run.pid, number)
        run.communicate(timeout=20)
        check(run.returncode == -number, f"{run.returncode}")
        check(not any(os.path.exists(f"/proc/{worker}") for worker in workers), "workers outlive a polite end")
        nothing_hidden(t)
    archive(t).expect(0, "0 failed")


def test_archive_ends_workers_that_do_not_answer(t):
    """A worker that does not hear the polite word is killed before anybody notices the wait."""
    t.old_clips("a.avi", "b.avi")
    run = start(t, "--jobs", "2", "--field-size", "source", "--flow", "horn-schunck")
    workers = first_workers_of(run)
    for worker in workers:
        os.kill(worker, signal.SIGSTOP)
    os.kill(run.pid, signal.SIGTERM)
    run.communicate(timeout=20)
    check(run.returncode == -signal.SIGTERM, f"{run.returncode}")
    no_worker_left(workers)
    nothing_hidden(t)


@pytest.mark.nightly
def test_archive_draws_no_playlists(t):
    t.clip("in/seg.ts", codec=("-c:v", "mpeg2video"))
    t.write("in/list.m3u8", "#EXTM3U\n#EXT-X-TARGETDURATION:2\n#EXTINF:2,\nseg.ts\n")
    result = t.archive("in", "-o", "out", "--size", "160x100", "--match", "*.ts", "--match", "*.m3u8")
    result.expect(6, "'in/list.m3u8'", "playlist")
    check(t.path("out/seg.ts.png").exists(), "the video was not drawn")


def days_of(t):
    data = page_data(t.path("out/index.html").read_text())
    return {(data["cameras"][day["row"][0]], day["date"]): day for day in data["recordings"]}, data


@pytest.mark.nightly
def test_archive_says_where_a_day_is_that_of_writing(t):
    """Nothing tells when these were recorded: log, report, sidecar and index say that the day is by when they were written."""
    t.zone("UTC")
    for name, written in (("a.avi", 1795176000), ("b.avi", 1795176060)):  # 2026-11-20 12:00
        t.clip(f"in/gate/{name}", seconds=2)
        t.stamp(f"in/gate/{name}", written)
    archive(t).expect(0, "2 clips drawn")
    archive(t, "--per", "day").expect(
        0, "warning: 'in': no recording time in the names of 2 clips, for example 'gate/a.avi'; each is assigned to the day "
        "of its last modification", "1 clip drawn")
    report = t.json("out/gate/2026-11-20.report.json")
    for words in ("by their modification times", "no recording time in the names of 2 of 2 files"):
        check(any(words in problem for problem in report["problems"]), f"{report['problems']}")
    check(report["clock"] is None and report["input"]["recorded"] is None, f"{report['input']}")
    check(not any(re.search("[0-9]{2}:[0-9]{2}:[0-9]{2}", label["text"]) for label in report["labels"]), f"{report['labels']}")
    check(sidecar(t, "gate/2026-11-20")["recorded"] is None, "nothing tells it")
    # A single file is no recording of several, and its night is no more than a guess.
    t.clip("in/hall/a.avi", seconds=2)
    t.stamp("in/hall/a.avi", 1795176000)
    archive(t, "--per", "night", "--match", "hall/*").expect(0, "1 clip drawn")
    report = t.json("out/hall/2026-11-20-night.report.json")
    check("no recording time in the names of 1 of 1 file" in report["problems"][0], f"{report['problems']}")
    check(report["settings"]["title"] == "hall" and report["input"]["camera"] == "hall", f"{report['settings']}")
    days, data = days_of(t)
    by_file, by_container = 2048, 1024
    check(days["gate", "2026-11-20"]["row"][5] & by_file, f"{days}")
    check(all(row[5] & by_file for row in data["clips"]), f"{data['clips']}")
    # A container that says when it was written tells no more of when it was recorded, and the index says that it is that.
    t.clip("in/gate/c.mp4", seconds=2, codec=("-c:v", "mpeg4", "-metadata", "creation_time=2026-11-19T08:00:00Z"))
    t.clip("in/gate/2026-11-18_08-00-00.avi", seconds=2)
    for name in ("c.mp4", "2026-11-18_08-00-00.avi"):
        t.stamp(f"in/gate/{name}", 1795176120)
    archive(t).expect(0, "3 clips drawn")
    rows = {row[1]: row for row in days_of(t)[1]["clips"]}
    check(rows["./gate/c.mp4"][2] == 1795075200 and rows["./gate/c.mp4"][5] & by_container, f"{rows}")
    check(sidecar(t, "gate/c.mp4")["recorded_by"] == "container", f"{sidecar(t, 'gate/c.mp4')}")
    named = next(row for url, row in rows.items() if "2026-11-18" in url)
    check(not named[5] & (by_file | by_container), f"{rows}")


def test_archive_keeps_files_for_a_time(t):
    for name, age in (("new.avi", 10), ("old.avi", 40), ("linked.avi", 40)):
        t.clip(f"in/gate/{name}", seconds=1)
        t.stamp(f"in/gate/{name}", -age * 86400)
    archive(t).expect(0, "3 clips drawn")
    # What vvr didn't record stays, whatever its name and age: other files, and what took the place of one of its own.
    kept = ["out/gate/old.avi.event-1.mp4", "out/gate/older.avi.png", "out/gate/note.json"]
    for name in kept:
        t.write(name, "mine")
        t.stamp(name, -400 * 86400)
    t.path("out/gate/linked.avi.png").unlink()
    t.path("out/gate/linked.avi.png").symlink_to(t.path(kept[0]))
    said = archive(t, "--keep", "30d", "--dry-run").expect(0, out=None).out
    check("too old         gate/old.avi\n" in said and "new.avi" not in said and t.path("out/gate/old.avi.png").exists(), said)
    archive(t, "--keep", "30d").expect(0, "gate/old.avi: older than --keep; removed ", "gate/old.avi.html", "gate/old.avi.json")
    names = {path.name for path in t.path("out/gate").iterdir() if not path.name.startswith(".")}
    expected = {f"new.avi{ending}" for ending in ENDINGS} | {pathlib.Path(name).name for name in kept} | {"linked.avi.png"}
    check(names == expected, f"{sorted(names)}")
    # It isn't drawn again, though the clip is still there.
    archive(t, "--keep", "30d").expect(0, "nothing to do; 1 done before, 2 older than --keep")
    check([row[1] for row in days_of(t)[1]["clips"]] == ["./gate/new.avi"], "the index")
    archive(t, "--keep", "60s").expect(1, "--keep", code="option-value-out-of-range")
    archive(t, "--keep", "30d", "--write", "index").expect(1, "--keep", code="options-conflict")


@pytest.mark.nightly
def test_archive_draws_nights(t):
    """From noon to noon, also when the clock changes: on 2026-10-25 at 3:00 it goes back to 2:00 in Berlin."""
    t.zone("Europe/Berlin")
    times = ("24_11-59-00", "24_12-00-00", "25_02-30-00", "25_11-59-00", "25_12-00-00")
    for time_of_day in times:
        t.clip(f"in/gate/2026-10-{time_of_day}.avi", seconds=1)
    t.age("in")
    archive(t, "--per", "night").expect(0, "gate/2026-10-23-night: ", "gate/2026-10-24-night: ", "gate/2026-10-25-night: ",
                                        "3 clips drawn")
    known = sidecar(t, "gate/2026-10-24-night")
    check(known["day"] == {"camera": "gate", "date": "2026-10-24", "clips": 3, "begins": "12:00"}, f"{known['day']}")
    report = t.json("out/gate/2026-10-24-night.report.json")
    check(report["settings"]["title"] == "gate, night of 2026-10-24", f"{report['settings']}")
    check("<title>gate, night of 2026-10-24" in t.path("out/gate/2026-10-24-night.html").read_text(), "the page's title")
    recording = days_of(t)[0]["gate", "2026-10-24"]
    check(recording["night"] and recording["clips"] == 3, f"{recording}")
    # The same beginning has the same nights, and another one draws them again. A night has its pictures while it has a clip.
    archive(t, "--per", "night", "--day-begins", "12:00", "--prune").expect(0, "nothing to do; 3 done before")
    archive(t, "--per", "night", "--day-begins", "12:30", "--dry-run").expect(0, out=None)
    archive(t, "--per", "day", "--day-begins", "06:00").expect(0, "gate/2026-10-24: ", "2 clips drawn")
    again = archive(t, "--per", "day", "--dry-run").expect(0, out=None).out
    check("other settings  gate/2026-10-24\n" in again, again)
    for options, code in ((["--day-begins", "06:00"], "options-conflict"), (["--per", "night", "--day-begins", "06:00"], "options-conflict"),
                          (["--per", "day", "--day-begins", "24:00"], "option-value")):
        archive(t, *options).expect(1, "--day-begins", code=code)


def test_archive_draws_days_of_cameras(t):
    t.zone("UTC")
    segments = [f"2026-11-21/08/{camera}/00.{second:02}.avi" for camera in ("gate", "hall") for second in (0, 2, 4)]
    t.old_clips(*segments, "2026-11-22/00/gate/00.00.avi", seconds=2)
    archive(t, "--per", "day", "--dry-run").expect(0, out=None)
    archive(t, "--per", "day").expect(0, "gate/2026-11-21: ", "hall/2026-11-21: ", "3 clips drawn, 0 failed")
    expected = sorted(f"{day}{ending}" for day in ("gate/2026-11-21", "gate/2026-11-22", "hall/2026-11-21") for ending in ENDINGS)
    check(outputs(t) == sorted([*expected, "index.html"]), f"{outputs(t)}")
    known = sidecar(t, "gate/2026-11-21")
    check(known["day"] == {"camera": "gate", "date": "2026-11-21", "clips": 3} and known["frames"] == 60, f"{known}")
    check(known["recorded"] == "2026-11-21 08:00:00", f"{known}")
    days, data = days_of(t)
    check(set(days) == {("gate", "2026-11-21"), ("gate", "2026-11-22"), ("hall", "2026-11-21")}, f"{days}")
    check(days["gate", "2026-11-21"]["row"][2] == 1795248000 and data["clips"] == [], f"{days}")
    archive(t, "--per", "day").expect(0, "nothing to do; 3 done before")
    # Segments come: the day is drawn again when enough has come, or nothing more.
    t.old_clips("2026-11-21/08/gate/00.06.avi", seconds=2)
    t.stamp("in/2026-11-21/08/gate/00.06.avi", -70)
    t.stamp("in/2026-11-21/08/gate/00.00.avi", -80)  # the recorder wrote it again: what is new is seconds long
    archive(t, "--per", "day").expect(0, "1 clip drawn")
    check(sidecar(t, "gate/2026-11-21")["frames"] == 80, "not drawn again")
    t.old_clips("2026-11-21/08/gate/00.08.avi", seconds=2)
    t.stamp("in/2026-11-21/08/gate/00.08.avi", -65)
    archive(t, "--per", "day").expect(0, "1 waiting to be redrawn with more clips")
    check(sidecar(t, "gate/2026-11-21")["frames"] == 80, "drawn again too soon")
    t.path("in/2026-11-21/08/gate/00.08.avi").unlink()
    # What the recorder removes stays in the picture of a day, until the day has gone.
    t.path("in/2026-11-21/08/gate/00.00.avi").unlink()
    archive(t, "--per", "day", "--prune").expect(0, "nothing to do; 3 done before")
    t.path("in/2026-11-22/00/gate/00.00.avi").unlink()
    archive(t, "--per", "day", "--prune").expect(0, "'in/2026-11-22/00/gate' is empty or missing, so its pictures are kept")
    for folder in ("gate", "", ".."):
        (t.path("in/2026-11-22/00") / folder).resolve().rmdir()
    archive(t, "--per", "day", "--prune").expect(0, "gate/2026-11-22: the clip was deleted")
    check("gate/2026-11-22.png" not in outputs(t) and "gate/2026-11-21.png" in outputs(t), f"{outputs(t)}")
    # Pictures of clips may be beside those of days.
    archive(t, "--exclude", "*/hall/*", "--exclude", "2026-11-21/08/hall/*", "--prune").expect(0, "3 clips drawn")
    check("2026-11-21/08/gate/00.02.avi.png" in outputs(t) and "2026-11-21/08/hall/00.02.avi.png" not in outputs(t), f"{outputs(t)}")
    archive(t, "--per", "week").expect(1, "--per", "'week'", code="choice-unknown")


def test_archive_takes_no_camera_for_a_way_out(t):
    t.old_clips("cam .. 2026-11-21 08.00.avi", "cam .x 2026-11-21 08.00.avi", "cam a 2026-11-21 08.00.avi", seconds=2)
    result = archive(t, "--per", "day", "--names", "cam {camera} %Y-%m-%d %H.%M").expect(6, "'..'", "'.x'", "1 clip drawn")
    check(outputs(t) == sorted([f"a/2026-11-21{ending}" for ending in ENDINGS] + ["index.html"]), f"{outputs(t)} {result}")
    check(not list(t.folder.glob("2026*")), f"{t.files()}")


def pictures(t):
    return [name for name in outputs(t) if name.endswith(".png")]


@pytest.mark.nightly
def test_archive_prunes_no_day_whose_clips_may_be_there(t):
    """Whatever a run leaves out of the clips, or can't see of them."""
    folders = {day: f"in/2026-11-{day}" for day in (20, 21)}
    names = [f"2026-11-{day}/10/{camera}/00.00.avi" for day in folders for camera in ("gate", "hall")]
    t.old_clips(*names, seconds=2)
    archive(t, "--per", "day").expect(0, "4 clips drawn")
    days = pictures(t)

    def prune(status, *texts, options=(), code=None):
        archive(t, "--per", "day", "--prune", *options).expect(status, *texts, code=code)
        check(pictures(t) == days, f"{options} {texts}: left are {pictures(t)}")

    prune(0, options=("--exclude", "*/*/hall/*"))
    prune(0, options=("--match", "*.mp4"))
    prune(0, options=("--names", "{camera}/%Y.%m.%d %H"))
    for stamp in (time.time(), time.time() + 10 * 365 * 86400, 0):  # copied again; the clock set back; copied by who knows no times
        for name in names:
            t.stamp(f"in/{name}", stamp)
        prune(0)
    t.path("in/broken.avi").symlink_to("broken.avi")
    t.path(f"in/{names[0]}").rename(t.path("kept.avi"))
    prune(2, "'in/broken.avi'", "Too many levels of symbolic links", code="io")
    t.path("in/broken.avi").unlink()
    # Moved within the archive, the day is there still.
    t.copy("kept.avi", "in/2026-11-20/11/gate/00.00.avi")
    prune(0)
    if os.geteuid() != 0:
        t.path(f"{folders[21]}/10").chmod(0)
        prune(2, "Permission denied", code="io")
        t.path(f"{folders[21]}/10").chmod(0o755)
    # A sidecar of an older vvr does not tell its clips.
    for day in ("gate/2026-11-20", "gate/2026-11-21"):
        known = sidecar(t, day)
        del known["clips"]
        t.write(f"out/{day}.json", json.dumps(known, indent=2))
    for hour in (10, 11):
        shutil.rmtree(t.path(f"{folders[20]}/{hour}/gate"))
    prune(0, "1 day was drawn by an older vvr, which did not record the clips")


@pytest.mark.nightly
def test_archive_keeps_a_day_whose_redraw_fails(t):
    """Until a new set is whole the old one stays, and says what it shows."""
    slow = ("--per", "day", "--field-size", "source", "--flow", "horn-schunck", "--write", "pictures,index")
    t.old_clips("2026-11-21/08/gate/00.00.avi", "2026-11-21/08/gate/00.02.avi", seconds=2)
    archive(t, *slow).expect(0, "1 clip drawn")
    day = "gate/2026-11-21"
    before = sidecar(t, day)
    whole_before = {name: t.path(f"out/{name}").read_bytes() for name in outputs(t) if name.startswith(day) and not name == f"{day}.json"}
    t.clip("in/2026-11-21/08/gate/10.00.avi", seconds=600, size="384x288")
    t.stamp("in/2026-11-21/08/gate/10.00.avi", -7200)
    archive(t, *slow, "--timeout", "1s").expect(6, f"{day} failed, status 5: ", "is kept", code="worker-timeout")
    after = sidecar(t, day)
    check(whole_before == {name: t.path(f"out/{name}").read_bytes() for name in whole_before}, f"{outputs(t)}")
    check((after["state"], after["tries"], after["frames"], after["day"]["clips"]) == ("failed", 1, before["frames"], 3), f"{after}")
    check(after["shows"]["modified_ns"] == before["clip"]["modified_ns"] < after["clip"]["modified_ns"], f"{after}")
    check(sum(len(names) for names in after["clips"].values()) == 3, f"{after}")
    row = days_of(t)[0]["gate", "2026-11-21"]["row"]
    check(row[12] == before["clip"]["modified_ns"] // 10**9 and row[5] & 1, f"{row}")
    nothing_hidden(t)
    # Whole again once it can be drawn.
    t.path("in/2026-11-21/08/gate/10.00.avi").unlink()
    archive(t, *slow).expect(0, "1 clip drawn")
    check("shows" not in sidecar(t, day) and sidecar(t, day)["state"] == "done", f"{sidecar(t, day)}")


def test_archive_says_that_clips_are_of_the_future(t):
    """And draws them with the others of their day."""
    t.old_clips(*[f"2026-11-21/08/gate/00.0{second}.avi" for second in (0, 2, 4)], seconds=2)
    later = time.time() + 365 * 86400
    t.stamp("in/2026-11-21/08/gate/00.02.avi", later)
    archive(t, "--per", "day").expect(0, "warning: 1 clip has a modification time in the future, such as 'in/2026-11-21/08/gate/00.02.avi'")
    known = sidecar(t, "gate/2026-11-21")
    check(known["day"]["clips"] == 3 and known["frames"] == 60, f"{known}")
    archive(t, "--per", "day").expect(0, "nothing to do; 1 done before")
    os.utime(t.path("in/2026-11-21/08/gate/00.04.avi"))
    archive(t, "--per", "day").expect(0, "1 still being written")


def test_archive_without_clips_says_what_it_looked_for(t):
    t.path("in").mkdir()
    archive(t).expect(0, "no clips found below 'in'; searched for ", ".avi ")
    archive(t, "--quiet").expect(0, "vvr: no clips found below 'in'; searched for ")
    t.old_clips("a.avi")
    archive(t, "--match", "*.xyz", "--match", "gate/*").expect(0, "no clips found below 'in'; searched for *.xyz gate/*", "'out': nothing to do")
