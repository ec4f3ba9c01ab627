"""Calls that fail, kills, clocks that jump, folders that go away, OpenGL that is lost: tests/faults has the means.

They take minutes, so they are of the nightly set. VVR_FAULTS and VVR_KILLS ask for more of them than it has, VVR_SEED for
others, and VVR_FAULT_ONLY for one alone, as malloc:17 or read:3+.
"""

import json
import os
import pathlib
import random
import shutil
import subprocess
import sys
import time

import pytest
from harness import check

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "faults"))
from faults import SCENES, Walk, faults_of  # noqa: E402

pytestmark = pytest.mark.slow

FAULTS = int(os.environ.get("VVR_FAULTS", "20"))  # for each use of vvr and each call
KILLS = int(os.environ.get("VVR_KILLS", "60"))  # for each use
SEED = os.environ.get("VVR_SEED", "2")
ONLY = os.environ.get("VVR_FAULT_ONLY")
SMALL = ("--size", "64x40", "--quiet")
PNG, EXR, EXTRACT = (next(scene for scene in SCENES if scene.name == name) for name in ("png", "exr", "extract"))

by_name = pytest.mark.parametrize("scene", SCENES, ids=[scene.name for scene in SCENES])


def built(t, name):
    """What the build has made of tests/faults; a sanitizer takes the place of what these stand before."""
    file = pathlib.Path(t.vvr_path).resolve().parents[1] / "tests" / "faults" / name
    if not file.exists():
        pytest.skip(f"{name} is not built; sanitizers leave it out")
    return str(file)


@pytest.fixture
def walk(t):
    return Walk(t.vvr_path, built(t, "libvvr_fail_nth.so"), t.folder)


def check_findings(walk):
    ours = [str(finding) for finding in walk.findings if not finding.is_others]
    check(not ours, "\n".join(ours))


@by_name
@pytest.mark.timeout(0)  # each run has a limit of its own
def test_many_calls_that_fail_leave_nothing_half_done(walk, scene):
    for fault in [ONLY] if ONLY else faults_of(walk, scene, FAULTS, SEED):
        walk.inject(scene, fault)
    check_findings(walk)


@by_name
@pytest.mark.timeout(0)  # each run has a limit of its own
def test_many_kills_leave_nothing_half_done(walk, scene):
    chance = random.Random(f"{SEED} {scene.name}")
    walk.learn(scene)
    for number in range(KILLS):
        moment = chance.uniform(0, 1.1 * walk.lasted[scene.name])
        walk.kill(scene, moment, number, first=number % 3 == 0, last=number % 3 == 2)
    check_findings(walk)


def test_the_injector_makes_the_call_fail_that_it_is_told(walk):
    """So that a walk in which nothing fails is noticed."""
    walk.learn(PNG)
    for call, status, words in (("write", 2, "No space left on device"), ("fsync", 2, "Input/output error"),
                                ("rename", 2, "Input/output error"), ("malloc", 5, "out of memory"), ("pthread_create", 5, "out of memory")):
        walk.empty(PNG)
        # libc takes the first memory, to look up the user, and can do without or crashes.
        number = 100 if call == "malloc" else 1
        run = walk.run(PNG, f"{call}:{number}")
        check(run.status == status and words in run.said, f"{call}: {run}")
        check([line.split()[:4] for line in run.log] == [["fault", "main", call, str(number)]], f"{run.log}")


def test_threads_that_are_short_end_it_with_status_5(walk):
    """Whichever is the first that can't be had: OpenImageIO's libraries would wait for ever for theirs."""
    walk.learn(PNG)
    for number in range(1, 10, 2):
        walk.empty(PNG)
        run = walk.run(PNG, f"pthread_create:{number}+")
        log4cplus = any("liblog4cplus" in line for line in run.log)  # had as many before as it wants, which counts no more
        check(run.status in (0, 5) or log4cplus, f"{number}: {run}")


def test_threads_that_the_rasteriser_cannot_have_end_it_with_status_5(walk):
    """llvmpipe would wait for ever for a thread that it could not start."""
    ended = set()
    for number in range(1, 12):
        walk.empty(PNG)
        run = walk.run(PNG, f"pthread_create:{number}+", LP_NUM_THREADS="2")
        check(run.status in (0, 5), f"{number}: {run}")
        ended.add(run.status)
    check(ended == {0, 5}, f"{ended}: too few or too many threads fail for this test to show anything")


def test_threads_that_openexr_cannot_have_end_it_with_status_5(walk):
    """It says nothing then."""
    walk.learn(EXR)
    said = 0
    for number in range(8, walk.counts[EXR.name, "pthread_create"] + 1):
        walk.empty(EXR)
        run = walk.run(EXR, f"pthread_create:{number}")
        log4cplus = any("liblog4cplus" in line for line in run.log)
        check(run.status in (0, 5) or log4cplus, f"{number}: {run}")
        said += "cannot encode 'out.exr': out of memory or threads" in run.said
    check(said > 0, f"{walk.counts}")


def test_threads_that_a_decoder_cannot_have_are_no_fault_of_the_clip(t):
    t.clip("clip.mp4", seconds=1, codec=("-c:v", "libx264"))
    said = 0
    for number in range(1, 8):
        run = t.render("clip.mp4", "--threads", "4", env=os.environ | {"VVR_FAULT": f"pthread_create:{number}",
                                                                      "LD_PRELOAD": built(t, "libvvr_fail_nth.so")})
        check(run.status in (0, 5), f"{number}: {run}")
        said += "cannot decode 'clip.mp4': no thread could be started; use fewer threads, or give vvr more memory (--threads)" in run.err
    check(said > 0, "no thread is the decoder's")


def test_files_that_cannot_be_opened_are_no_fault_of_the_clip(t):
    t.clip("clip.avi", seconds=1)
    log = t.path("log")
    for number in range(1, 100):
        log.unlink(missing_ok=True)
        run = t.vvr("info", "clip.avi", env=os.environ | {"VVR_FAULT": f"open:{number}", "VVR_FAULT_LOG": str(log),
                                                          "LD_PRELOAD": built(t, "libvvr_fail_nth.so")})
        if "libavformat" in log.read_text():  # which opens the clip
            run.expect(2, "'clip.avi'", "Too many open files", "ulimit -n", code="too-many-open-files")
            return
    check(False, "libavformat opens nothing")


def test_memory_that_is_short_as_libraries_are_loaded_ends_it_with_status_5(walk):
    """What they throw then can't be caught, and the loader stays locked; so the program ends there."""
    walk.learn(PNG)
    ends = set()
    for number in range(0, walk.counts[PNG.name, "malloc"], walk.counts[PNG.name, "malloc"] // 8):
        walk.empty(PNG)
        run = walk.run(PNG, f"malloc:{number + 1}")
        ends.add(run.status)
        walk.check(PNG, f"malloc:{number + 1}", run)
    check_findings(walk)
    check(5 in ends, f"{ends}")


def test_data_that_cannot_be_removed_stay_known(walk):
    """With no file left to open, a folder of data can't be emptied, but the next run still knows it for its own."""
    walk.learn(EXTRACT)
    count = walk.counts[EXTRACT.name, "open"]
    stays = sum(walk.inject(EXTRACT, f"open:{number}+").status == 2 for number in range(count - 11, count, 2))
    check_findings(walk)
    check(stays > 0, "each run could remove its data")


@by_name
def test_a_clock_that_jumps_back_changes_no_picture(walk, scene):
    walk.learn(scene)
    count = walk.counts[scene.name, "clock"]
    check(count > 0, f"{walk.counts}")
    fault = f"clock:{(count + 1) // 2}"
    walk.empty(scene)
    run = walk.run(scene, fault)
    check(run.status == 0, str(run))
    check(any(line.startswith("fault main clock") for line in run.log) or scene.process == "worker", f"{run.log}")
    walk.check(scene, fault, run)
    check(walk.files(scene) == walk.whole[scene.name], f"{fault}: other files")
    walk.check_next(scene, fault, run)
    check_findings(walk)


def test_backend_is_tried_before_a_long_clip_is_read(t):
    """One of more than 5000 frames: shorter ones are read meanwhile."""
    t.clip("clip.avi", seconds=520)
    library = built(t, "libvvr_fail_nth.so")
    reads = {}
    for backend, status in ((("egl:99",), 4), (("software",), 0)):
        environment = os.environ | {"VVR_FAULT": "count", "VVR_FAULT_LOG": str(t.path("log")), "LD_PRELOAD": library}
        t.vvr("render", "clip.avi", "-o", "out.png", *SMALL, "--flow", "none", "--backend", *backend, env=environment).expect(status)
        reads[status] = int(t.path("log").read_text().split("count main read ")[1].split()[0])
        t.path("log").unlink()
    whole = t.path("clip.avi").stat().st_size / 32768  # that libav reads at once
    check(reads[0] - reads[4] > 0.8 * whole, f"reads without and with OpenGL: {reads}, of {whole:.0f}")


# Folders


def fed_by_hand(t, *arguments, **options):
    """vvr, with a clip on its stdin of which it has the first half; and the other half."""
    data = t.path("clip.avi").read_bytes()
    child = subprocess.Popen([t.vvr_path, *arguments], cwd=t.folder, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL,
                             stderr=subprocess.PIPE, **options)
    child.stdin.write(data[:len(data) // 2])
    child.stdin.flush()
    for _ in range(200):  # the file in which the stream is kept is open once the output has been looked at
        if any("vvr-" in os.path.realpath(link) for link in pathlib.Path(f"/proc/{child.pid}/fd").iterdir()):
            break
        time.sleep(0.05)
    return child, data[len(data) // 2:]


def test_a_folder_that_goes_away_in_the_middle(t):
    t.clip("clip.avi", seconds=1)
    t.path("out").mkdir()
    child, rest = fed_by_hand(t, "render", "-", "-o", "out/out.png", *SMALL)
    shutil.move(t.path("out"), t.path("elsewhere"))
    _, said = child.communicate(rest, timeout=60)
    check(child.returncode == 2 and b"'out'" in said and b"[file-not-found]\n" in said, f"{child.returncode} {said}")
    t.expect_files("clip.avi", "elsewhere")


def test_a_folder_that_turns_read_only_in_the_middle(t):
    t.clip("clip.avi", seconds=1)
    out = t.path("out")
    out.mkdir()
    (out / "out.png").write_bytes(b"older")
    user = {"user": 65534, "group": 65534, "extra_groups": []} if os.getuid() == 0 else {}
    if user:  # permissions don't hold root back
        for folder in (t.folder, *t.folder.parents[:2]):
            os.chmod(folder, 0o755)
        os.chown(out, 65534, 65534)
        os.chown(out / "out.png", 65534, 65534)
        if not os.access(t.vvr_path, os.X_OK) or subprocess.run(["true"], **user, cwd="/", check=False).returncode != 0:
            pytest.skip("another user can't run here")
        if subprocess.run([t.vvr_path, "--version"], **user, cwd="/", stdout=subprocess.DEVNULL, check=False).returncode != 0:
            pytest.skip("another user can't run this vvr")
    child, rest = fed_by_hand(t, "render", "-", "-o", "out/out.png", *SMALL, **user)
    os.chmod(out, 0o555)
    _, said = child.communicate(rest, timeout=60)
    os.chmod(out, 0o755)
    check(child.returncode == 2 and b"[permission-denied]\n" in said, f"{child.returncode} {said}")
    check((out / "out.png").read_bytes() == b"older", "the older file is not as it was")
    t.expect_files("clip.avi", "out", "out/out.png")


def test_a_folder_for_streams_that_is_not_there(t):
    t.clip("clip.avi", seconds=1)
    gone = os.environ | {"TMPDIR": str(t.path("gone"))}
    t.run(["bash", "-c", f"cat clip.avi | '{t.vvr_path}' render - -o out.png --size 64x40 --quiet"], env=gone).expect(
        2, "No such file or directory", "TMPDIR", code="file-not-found")
    t.vvr("render", "clip.avi", "-o", "out.png", *SMALL, env=gone).expect(0)


# OpenGL

EGL_CALLS = ("eglGetProcAddress", "eglQueryDevicesEXT", "eglGetPlatformDisplayEXT", "eglInitialize", "eglQueryString", "eglBindAPI",
             "eglChooseConfig", "eglCreateContext", "eglMakeCurrent", "OpenGL")


def egl_environment(t, **variables):
    """That of a libEGL which has a GPU that fails as it is told, and Mesa's rasteriser."""
    folder = os.path.dirname(built(t, "egl/libEGL.so.1"))
    listed = subprocess.run(["/sbin/ldconfig", "-p"], stdout=subprocess.PIPE, check=True).stdout.decode()
    real = next(line.split()[-1] for line in listed.splitlines() if "libEGL.so.1 " in line)
    return os.environ | {"LD_LIBRARY_PATH": folder, "VVR_REAL_EGL": real} | variables


def test_a_gpu_that_fails_is_left_for_the_rasteriser(t):
    """By auto alone: who asks for the GPU gets status 4, and who asks for the rasteriser sees nothing of it."""
    t.clip("clip.avi", seconds=1)
    t.vvr("render", "clip.avi", "-o", "right.png", *SMALL, "--backend", "software").expect(0)
    right = t.path("right.png").read_bytes()
    for call in EGL_CALLS:
        both = call in ("eglGetProcAddress", "eglQueryDevicesEXT")  # which know nothing of a device yet
        environment = egl_environment(t, VVR_EGL_FAULT=("all:" if both else "") + call)
        what = "libEGL" if call == "eglGetProcAddress" else \
            "EGL_KHR_surfaceless_context" if call == "eglQueryString" else \
            "OpenGL 3.3" if call == "OpenGL" else call
        t.vvr("render", "clip.avi", "-o", "egl.png", *SMALL, "--backend", "egl", env=environment).expect(
            4, "egl", what, "`vvr doctor`", code="opengl-unavailable")
        check(not t.path("egl.png").exists(), call)
        backend = t.vvr("render", "clip.avi", "-o", "out.png", *SMALL, "--backend", "software", env=environment)
        backend.expect(4 if both else 0)
        if not both:
            check(t.path("out.png").read_bytes() == right, call)
    for call in ("eglInitialize", "all:eglInitialize"):  # to software, and to OSMesa
        t.vvr("render", "clip.avi", "-o", "auto.png", *SMALL, env=egl_environment(t, VVR_EGL_FAULT=call)).expect(0)
        t.expect_picture("auto.png", size=(64, 40))


@pytest.mark.parametrize("error, lasts, status, code", [
    ("0x505", "", 5, "out-of-memory"), ("0x507", "+", 4, "opengl-lost")], ids=["out_of_memory", "context_lost"])
def test_opengl_that_fails_anywhere(t, error, lasts, status, code):
    """At each place where OpenGL is asked for errors: a clear text, and the older picture stays."""
    t.clip("clip.avi", seconds=1)
    t.write("out.png", "older")
    for number in range(1, 200):
        run = t.vvr("render", "clip.avi", "-o", "out.png", *SMALL, env=egl_environment(t, VVR_GL_ERROR=f"{error}:{number}{lasts}"))
        if run.status == 0:
            break
        run.expect(status, "--backend" if status == 4 else "--size", code=code)
        check(t.path("out.png").read_bytes() == b"older", "the older picture is not as it was")
        t.expect_files("clip.avi", "out.png")
    check(number > 10, f"OpenGL was asked {number - 1} times for errors")
    t.expect_picture(size=(64, 40))


def test_an_archive_tells_each_event_once_whichever_file_cannot_be_moved(t):
    """The files of a clip are moved to their places one by one, and its report isn't the last."""
    t.old_clips("a.avi", seconds=4)
    archive = ("archive", "in", "-o", "out", *SMALL, "--flow", "none", "--backend", "software", "--events-to", "events.jsonl")
    failed = 0
    for number in range(1, 10):
        shutil.rmtree(t.path("out"), ignore_errors=True)
        t.path("events.jsonl").unlink(missing_ok=True)
        run = t.vvr(*archive, env=os.environ | {"VVR_FAULT": f"rename:{number}", "VVR_FAULT_IN": "main",
                                                "LD_PRELOAD": built(t, "libvvr_fail_nth.so")})
        failed += "a.avi failed" in run.err
        t.vvr(*archive).expect(0)
        events = [event["number"] for event in t.json("out/a.avi.report.json")["events"]]
        told = [json.loads(line)["number"] for line in t.path("events.jsonl").read_text(encoding="utf-8").splitlines()]
        check(events and told == events, f"rename {number}: told are {told} of {events}\n{run}")
    check(failed >= 7, f"only {failed} of the files could not be moved")
