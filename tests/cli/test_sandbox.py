"""What keeps an archive's workers from all but their clip and their pictures, and that they draw all the same."""

import ctypes
import errno
import os
import pathlib
import subprocess
import time

import pytest
from harness import check
from test_archive import age, archive, clips, complete, outputs, sidecar

LIBC = ctypes.CDLL(None, use_errno=True)
NEEDED = {"read its clip", "write and rename beside its picture", "remove beside its picture", "start a thread", "compile code"}
# What a machine or a user may be refused without a sandbox too: no proof of one.
UNSURE = {"empty its clip by opening", "trace the parent", "read the parent's memory", "mount", "make namespaces", "load BPF",
          "count events", "handle page faults", "open a ring", "use keys", "leave its group", "open a netlink socket"}
# What is refused from some version of Landlock on.
LATER = {"signal the parent's thread": 6}
ALL_WALLS = ("workers read their clips and write beside their pictures alone", "and have no network (seccomp)")


def landlock():
    """The version of the kernel's Landlock, 0 = none."""
    return max(0, LIBC.syscall(444, None, 0, 1))


def has_seccomp():
    return LIBC.prctl(22, 2, None) == -1 and ctypes.get_errno() == errno.EFAULT


@pytest.fixture
def walls():
    """For what takes the whole sandbox."""
    if landlock() == 0 or not has_seccomp():
        pytest.skip("this kernel lacks Landlock or seccomp")
    if "ASAN_OPTIONS" in os.environ:
        pytest.skip("sanitizers need what a sandbox refuses")


def without(features, t, *arguments):
    """An archive as on a kernel without them."""
    return t.run([os.environ["VVR_WITHHOLD"], features, t.vvr_path, "archive", "in", "-o", "out", "--size", "160x100", "--field-size", "48x36",
                  "--flow", "none", "--backend", "software", *arguments])


def hijack(t, mode):
    """What a worker is refused that a clip has taken over, by what it tried."""
    clips(t, "gate/own.avi", "gate/other.avi")
    t.write("private", "of the user\n")
    t.path("out").mkdir(exist_ok=True)
    places = {"HIJACK_CLIP": "in/gate/own.avi", "HIJACK_OTHER": "in/gate/other.avi", "HIJACK_OUTSIDE": "private", "HIJACK_OUT": "out/gate"}
    environment = {**os.environ, "LD_PRELOAD": os.environ["VVR_HIJACK"], **{name: str(t.path(place)) for name, place in places.items()}}
    if mode != "off":
        environment["HIJACK_PROGRAM"] = "1"
    done = archive(t, "--match", "gate/own.avi", "--sandbox", mode, env=environment)
    lines = t.path("out/gate/hijacked").read_text().splitlines()
    return done, {name: int(error) for name, error in (line.split("\t") for line in lines)}


def test_a_hijacked_worker_is_refused_all_but_its_clip_and_its_pictures(t, walls):
    done, refused = hijack(t, "required")
    done.expect(0, "1 clip drawn, 0 failed")
    check(len(refused) > 35, f"{refused}")
    for attempt, error in refused.items():
        if attempt in NEEDED:
            check(error == 0, f"a worker can't {attempt}: {os.strerror(error)}")
        elif landlock() >= LATER.get(attempt, 1):
            wanted = (errno.ENOSYS,) if attempt == "open a ring" else (errno.EACCES, errno.EPERM, errno.EXDEV)
            check(error in wanted, f"a worker could {attempt}: {os.strerror(error)}")
    check(refused["start a program"] == errno.EACCES, str(refused))
    check(t.path("in/gate/own.avi").stat().st_size > 0 and not t.path("private.new").exists(), "what was refused was done")


def test_a_hijacked_worker_without_a_sandbox_does_as_it_likes(t):
    """Else the test above would prove nothing."""
    if "ASAN_OPTIONS" in os.environ:
        pytest.skip("sanitizers let no library be loaded before theirs")
    _, refused = hijack(t, "off")
    sure = {attempt: error for attempt, error in refused.items() if attempt not in UNSURE | NEEDED}
    check(len(sure) > 20, f"{refused}")
    # The clip is emptied, linked, moved and gone on the way: what comes after that finds none.
    later = {errno.ENOENT} if not t.path("in/gate/own.avi").exists() else set()
    wrong = {attempt: os.strerror(error) for attempt, error in sure.items() if error not in {0} | later}
    check(not wrong, f"refused without a sandbox: {wrong}")


def test_a_worker_lives_within_its_walls(t, walls):
    t.path("in").mkdir()
    t.clip("in/long.avi", seconds=60, size="320x240")
    age(t)
    run = subprocess.Popen([t.vvr_path, "archive", "in", "-o", "out", "--backend", "software", "--sandbox", "required"], cwd=t.folder,
                           stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    status = {}
    for _ in range(400):
        for child in pathlib.Path(f"/proc/{run.pid}/task/{run.pid}/children").read_text().split():
            folder = pathlib.Path(f"/proc/{child}")
            try:
                if b"render" in (folder / "cmdline").read_bytes():
                    status = dict(line.split(":\t", 1) for line in (folder / "status").read_text().splitlines() if ":\t" in line)
            except OSError:
                continue
        if status or run.poll() is not None:
            break
        time.sleep(0.01)
    run.kill()
    run.wait()
    check(status.get("NoNewPrivs") == "1" and status.get("Seccomp") == "2", f"{status}")


def test_the_sandbox_changes_no_byte(t, walls):
    clips(t, "gate/one.avi", "two.avi")
    for mode in ("off", "required"):
        archive(t, "--sandbox", mode).expect(0, "2 clips drawn")
        t.path("out").rename(t.path(mode))
    for name in ("gate/one.avi", "two.avi"):
        for ending in (".png", ".html", ".jpg", ".still.jpg"):
            with_walls, without_walls = (t.path(f"{mode}/{name}{ending}").read_bytes() for mode in ("required", "off"))
            check(with_walls == without_walls, f"{name}{ending} differs")


def test_the_sandbox_is_said_once_a_run(t, walls):
    clips(t, "a.avi", "b.avi", "c.avi")
    done = archive(t, "--match", "[ab].avi").expect(0, *ALL_WALLS, f"(Landlock {landlock()})")
    check(done.err.count("Landlock") == 1, str(done))
    check("Landlock" not in archive(t, "--match", "[ab].avi").expect(0, "nothing to do").err, "nobody was shut in")
    archive(t, "--sandbox", "off").expect(0, "no sandbox: workers may do all that you may (--sandbox off)")


@pytest.mark.parametrize("features, said", [
    ("landlock", ["workers have no network (seccomp); this kernel has no Landlock (Function not implemented), by which files"]),
    ("seccomp", ["write beside their pictures alone (Landlock", "; this kernel has no seccomp filters (Invalid argument), by which the network"]),
    ("landlock,seccomp", ["no sandbox: this kernel has no Landlock (Function not implemented)", "this kernel has no seccomp filters"]),
], ids=["landlock", "seccomp", "both"])
def test_an_older_kernel_draws_with_what_it_has(t, walls, features, said):
    clips(t, "one.avi")
    without(features, t).expect(0, "vvr: warning: ", *said, "1 clip drawn, 0 failed")
    complete(t, ["one.avi"])


@pytest.mark.parametrize("feature, said", [("landlock", "this kernel has no Landlock (Function not implemented)"),
                                           ("seccomp", "this kernel has no seccomp filters (Invalid argument)")],
                         ids=["landlock", "seccomp"])
def test_a_sandbox_that_is_required_and_not_there(t, feature, said):
    clips(t, "one.avi")
    if feature == "seccomp" and landlock() == 0:
        pytest.skip("this kernel has no Landlock, which is what is missing first")
    without(feature, t, "--sandbox", "required").expect(
        4, "workers can't be shut in, and --sandbox required asks for it: " + said, "use a kernel that has it", "or --sandbox auto")
    check(outputs(t) == [], f"{outputs(t)}")


def test_unknown_sandbox(t):
    archive(t, "--sandbox", "strict").expect(1, "--sandbox", "'strict'", "auto, off, required")


def test_the_sandbox_lets_links_and_named_files_through(t, walls):
    """Clips behind links, PICTURES behind one, and each file that an option names, wherever they are."""
    for folder in ("elsewhere", "in/gate", "options", "real"):
        t.path(folder).mkdir(parents=True)
    t.clip("elsewhere/clip.avi", seconds=1)
    os.link(t.path("elsewhere/clip.avi"), t.path("in/gate/hard.avi"))
    t.path("in/gate/soft.avi").symlink_to("../../elsewhere/clip.avi")
    t.path("in/hall").symlink_to(t.path("elsewhere"))
    t.path("out").symlink_to("real")
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=64x48", "-frames:v", "1", "options/scene.png")
    t.ffmpeg("-f", "lavfi", "-i", "color=white:size=64x48", "-frames:v", "1", "options/mask.png")
    t.write("options/vvr.toml", '[archive]\nmask = "options/mask.png"\n')
    age(t)
    archive(t, "--sandbox", "required", "--reference", str(t.path("options/scene.png")), "--config", "options/vvr.toml", "--log-file",
            "elsewhere/log").expect(0, "3 clips drawn, 0 failed")
    for clip in ("gate/hard.avi", "gate/soft.avi", "hall/clip.avi"):
        check(sidecar(t, clip)["state"] == "done", clip)
    check("Landlock" in t.path("elsewhere/log").read_text(), "the log file has no word of it")


def test_the_sandbox_lets_a_day_through(t, walls):
    for minute in ("00", "01", "02"):
        t.path("in/2026-11-21/08/gate").mkdir(parents=True, exist_ok=True)
        t.clip(f"in/2026-11-21/08/gate/{minute}.00.avi", seconds=1)
    age(t)
    archive(t, "--sandbox", "required", "--per", "day").expect(0, "1 clip drawn, 0 failed")


def test_the_sandbox_needs_no_home(t, walls):
    """A service has a home that is not there, a folder for temporary files of its own, and no cache."""
    clips(t, "one.avi")
    environment = {"PATH": "/usr/bin:/bin", "HOME": "/nonexistent", "TMPDIR": str(t.path("in")), "VVR_CONFIG": "",
                   "MESA_SHADER_CACHE_DIR": str(t.path("no/cache"))}
    archive(t, "--sandbox", "required", env=environment).expect(0, "1 clip drawn, 0 failed")
    complete(t, ["one.avi"])
