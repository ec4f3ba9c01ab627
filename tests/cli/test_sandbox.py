"""What keeps an archive's workers from all but their clip and their pictures, and that they draw all the same."""

import contextlib
import ctypes
import errno
import os
import pathlib
import signal
import time

import pytest
from harness import check, hijacked, nightly_except, skip_with_sanitizers
from test_archive import archive, complete, outputs, sidecar

LIBC = ctypes.CDLL(None, use_errno=True)
NEEDED = {"read its clip", "write and rename beside its picture", "remove beside its picture", "start a thread", "compile code"}
# What a machine or a user may be refused without a sandbox too: no proof of one.
UNSURE = {"empty its clip by opening", "count events", "open a ring", "use keys", "leave its group", "open a netlink socket",
          "set the flags of a file", "reserve room for a file", "make a file without a name"}
# What no worker may, whatever --sandbox says.
HELD = {"make a giant file": errno.EFBIG, "grow its plan": errno.EPERM, "write into its plan": errno.EPERM}
REFUSED = {errno.EACCES, errno.EPERM, errno.EXDEV, errno.ENOSYS}
SIGSYS = 128 + signal.SIGSYS
ALL_WALLS = ("workers can only read their clips and write beside their pictures", "and can't use the network (seccomp)")


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
    skip_with_sanitizers("need what a sandbox refuses")


def without(features, t, *arguments):
    """An archive as on a kernel without them."""
    return t.run([os.environ["VVR_WITHHOLD"], features, t.vvr_path, "archive", "in", "-o", "out", "--size", "160x100", "--field-size", "48x36",
                  "--flow", "none", "--backend", "software", *arguments])


def hijack(t, mode, *arguments):
    """What a worker is refused that a clip has taken over, by what it tried."""
    t.old_clips("gate/own.avi", "gate/other.avi")
    t.write("private", "of the user\n")
    t.path("out").mkdir()
    places = {"HIJACK_CLIP": "in/gate/own.avi", "HIJACK_OTHER": "in/gate/other.avi", "HIJACK_OUTSIDE": "private", "HIJACK_OUT": "out/gate"}
    environment = {**hijacked(), **{name: str(t.path(place)) for name, place in places.items()}}
    done = archive(t, "--match", "gate/own.avi", "--sandbox", mode, *arguments, env=environment)
    lines = t.path("out/gate/hijacked").read_text().splitlines()
    return done, {name: int(error) for name, error in (line.split("\t") for line in lines)}


@pytest.mark.parametrize("backend", nightly_except(["software", "auto"], "auto"))
def test_a_hijacked_worker_is_refused_all_but_its_clip_and_its_pictures(t, walls, backend):
    """Also where it may use a graphics card, whether there is one or not."""
    done, refused = hijack(t, "required", "--backend", backend)
    done.expect(0, "1 clip drawn, 0 failed")
    check(len(refused) > 45, f"{refused}")
    for attempt, error in refused.items():
        if backend == "auto" and attempt == "make a file in memory":
            continue  # graphics drivers share buffers so
        if attempt in NEEDED:
            check(error == 0, f"a worker can't {attempt}: {os.strerror(error)}")
        else:
            check(error in ({HELD[attempt]} if attempt in HELD else REFUSED), f"a worker could {attempt}: {os.strerror(error)}")
    check(t.path("in/gate/own.avi").stat().st_size > 0 and not t.path("private.new").exists(), "what was refused was done")


def test_a_hijacked_worker_without_a_sandbox_does_as_it_likes(t):
    """Else the test above would prove nothing."""
    _, refused = hijack(t, "off")
    check({attempt: refused[attempt] for attempt in HELD} == HELD, f"{refused}")
    sure = {attempt: error for attempt, error in refused.items() if attempt not in UNSURE | NEEDED | set(HELD)}
    check(len(sure) > 30, f"{refused}")
    # The clip is emptied, linked, moved and gone on the way: what comes after that finds none.
    later = {errno.ENOENT} if not t.path("in/gate/own.avi").exists() else set()
    wrong = {attempt: os.strerror(error) for attempt, error in sure.items() if error not in {0} | later}
    check(not wrong, f"refused without a sandbox: {wrong}")


@pytest.mark.nightly
def test_a_worker_that_asks_for_what_nothing_needs_is_ended(t, walls):
    """Each by a clip of its own, in one run; the clip that asks for nothing is drawn."""
    calls = ["execve", "execveat", "ptrace", "peek", "mount", "unshare", "bpf", "userfaultfd", "int80", "x32"]
    t.old_clips("good.avi", *[f"{call}.avi" for call in calls])
    archive(t, "--sandbox", "required", env=hijacked()).expect(6, f"1 clip drawn, {len(calls)} failed", code="worker-killed")
    shut = {call: sidecar(t, f"{call}.avi")["status"] for call in calls}
    if os.uname().machine == "x86_64":
        t.path("out").rename(t.path("shut"))
        archive(t, "--sandbox", "off", env=hijacked()).expect(6)
        free = {call: sidecar(t, f"{call}.avi")["status"] for call in calls}
        check(SIGSYS not in free.values(), f"ended without a sandbox too, so it proves nothing: {free}")
        if free["int80"] == 128 + signal.SIGSEGV:  # a processor or a virtual machine that has no 32-bit calls
            del shut["int80"]
    check(set(shut.values()) == {SIGSYS}, f"not ended by SIGSYS: {shut}")


@pytest.mark.nightly
@pytest.mark.parametrize("mode", ["auto", "off"])
def test_no_worker_ends_the_run(t, mode):
    """Whatever one says, leaves or does that a clip has taken over: the others are drawn, and each try is counted."""
    said = {"exit-127": (127, "worker-result-invalid", "cannot execute"), "exit-2": (2, "io", "No space left on device"),
            "exit-4": (4, "backend", "no OpenGL"), "exit-5": (5, "limit", "out of memory"), "liar": (2, "disk-full", "No space left"),
            "vague": (3, "not-video", "without an error message"), "deep": (3, "not-video", "without an error message"),
            "done": (2, "worker-result-invalid", "cannot read the report"), "broken": (2, "worker-result-invalid", "cannot read the report"),
            "sparse": (2, "worker-result-invalid", "100000000"), "closed": (3, "not-video", "without an error message"),
            "flood": (3, "not-video", "xxx"), "greedy": (5, "worker-output-limit", "more than the limit of 4000 MB")}
    t.old_clips("good.avi", *[f"{deed}.avi" for deed in said])
    t.stamp("in/good.avi", 1)  # so that it comes last
    for tries in (1, 2):
        done = archive(t, "--sandbox", mode, env=hijacked()).expect(6, f"{len(said)} failed")
        for deed, (status, code, words) in said.items():
            known = sidecar(t, f"{deed}.avi")
            check((known["state"], known["status"], known["code"], known["tries"]) == ("failed", status, code, tries), f"{deed}: {known}\n{done}")
            check(words in known["reason"] and f"{known['reason']} [{code}]\n" in done.err, f"{deed}: {known}\n{done}")
        check(sidecar(t, "good.avi")["state"] == "done", str(done))
    check("good.avi" in t.path("out/index.html").read_text(), "no index")


def no_process_of(folder, seconds):
    """Whether, in so many seconds, no process is left that works in a folder."""
    def left():
        for link in pathlib.Path("/proc").glob("[0-9]*/cwd"):
            try:
                if os.readlink(link) == str(folder):
                    return True
            except OSError:
                continue
        return False

    until = time.monotonic() + seconds
    while left():
        if time.monotonic() > until:
            return False
        time.sleep(0.02)
    return True


@pytest.mark.parametrize("number", nightly_except([signal.SIGKILL, signal.SIGTERM, signal.SIGINT], signal.SIGKILL),
                         ids=["kill", "term", "int"])
def test_a_hijacked_worker_does_not_outlive_the_run(t, walls, number):
    """It asks not to end with its parent, and to be in a group of its own, and ignores what it can."""
    t.old_clips("stay.avi")
    run = t.start("archive", "in", "-o", "out", "--backend", "software", "--sandbox", "required", env=hijacked())
    time.sleep(1.5)
    check(run.poll() is None, "it did not stay")
    began = time.monotonic()
    run.send_signal(number)
    run.wait(timeout=20)
    check(no_process_of(t.folder, max(0.0, 2.5 - (time.monotonic() - began))), "a worker is left")
    check(run.returncode == -number, f"{run.returncode}")
    archive(t).expect(0, "1 clip drawn")  # the lock is free


def of_a_worker(t, name, *options):
    """The file /proc/PID/NAME of a worker, once it runs."""
    t.clip("in/long.avi", seconds=60, size="320x240")
    t.age("in")
    run = t.start("archive", "in", "-o", "out", "--backend", "software", *options)
    found = b""
    while not found and run.poll() is None:
        for child in pathlib.Path(f"/proc/{run.pid}/task/{run.pid}/children").read_text().split():
            folder = pathlib.Path(f"/proc/{child}")
            with contextlib.suppress(OSError):
                if b"render" in (folder / "cmdline").read_bytes():
                    found = (folder / name).read_bytes()
        time.sleep(0.01)
    run.kill()
    run.wait()
    return found.decode()


def test_a_worker_lives_within_its_walls(t, walls):
    lines = of_a_worker(t, "status", "--sandbox", "required").splitlines()
    status = dict(line.split(":\t", 1) for line in lines if ":\t" in line)
    check(status.get("NoNewPrivs") == "1" and status.get("Seccomp") == "2", f"{status}")


def test_the_sandbox_changes_no_byte(t, walls):
    t.old_clips("gate/one.avi", "two.avi")
    for mode in ("off", "required"):
        archive(t, "--sandbox", mode).expect(0, "2 clips drawn")
        t.path("out").rename(t.path(mode))
    for name in ("gate/one.avi", "two.avi"):
        for ending in (".png", ".html", ".jpg", ".still.jpg"):
            with_walls, without_walls = (t.path(f"{mode}/{name}{ending}").read_bytes() for mode in ("required", "off"))
            check(with_walls == without_walls, f"{name}{ending} differs")


@pytest.mark.nightly
def test_the_sandbox_is_said_once_a_run(t, walls):
    t.old_clips("a.avi", "b.avi", "c.avi")
    done = archive(t, "--match", "[ab].avi").expect(0, *ALL_WALLS, f"(Landlock {landlock()})")
    check(done.err.count("Landlock") == 1, str(done))
    check("Landlock" not in archive(t, "--match", "[ab].avi").expect(0, "nothing to do").err, "nobody was shut in")
    archive(t, "--sandbox", "off").expect(0, "no sandbox: workers have all permissions of this user (--sandbox off)")


@pytest.mark.parametrize("features, said", [
    ("landlock", ["workers can't use the network (seccomp); this kernel has no Landlock (Function not implemented), so workers"]),
    ("seccomp", ["write beside their pictures (Landlock", "; this kernel has no seccomp filters (Invalid argument), so workers"]),
    ("landlock,seccomp", ["no sandbox: this kernel has no Landlock (Function not implemented)", "this kernel has no seccomp filters"]),
], ids=["landlock", "seccomp", "both"])
def test_an_older_kernel_draws_with_what_it_has(t, walls, features, said):
    t.old_clips("one.avi")
    without(features, t).expect(0, "vvr: warning: ", *said, "1 clip drawn, 0 failed")
    complete(t, ["one.avi"])


@pytest.mark.parametrize("feature, said", [("landlock", "this kernel has no Landlock (Function not implemented)"),
                                           ("seccomp", "this kernel has no seccomp filters (Invalid argument)")],
                         ids=["landlock", "seccomp"])
def test_a_sandbox_that_is_required_and_not_there(t, feature, said):
    t.old_clips("one.avi")
    if feature == "seccomp" and landlock() == 0:
        pytest.skip("this kernel has no Landlock, which is what is missing first")
    without(feature, t, "--sandbox", "required").expect(
        4, said, "or --sandbox auto", code="sandbox-unavailable")
    check(outputs(t) == [], f"{outputs(t)}")


def test_the_sandbox_lets_links_and_named_files_through(t, walls):
    """Clips behind links, PICTURES behind one, and each file that an option names, wherever they are."""
    for folder in ("in/gate", "real"):
        t.path(folder).mkdir(parents=True)
    t.clip("elsewhere/clip.avi", seconds=1)
    os.link(t.path("elsewhere/clip.avi"), t.path("in/gate/hard.avi"))
    t.path("in/gate/soft.avi").symlink_to("../../elsewhere/clip.avi")
    t.path("in/hall").symlink_to(t.path("elsewhere"))
    t.path("out").symlink_to("real")
    t.ffmpeg("-f", "lavfi", "-i", "color=gray:size=64x48", "-frames:v", "1", "options/scene.png")
    t.ffmpeg("-f", "lavfi", "-i", "color=white:size=64x48", "-frames:v", "1", "options/mask.png")
    t.write("options/vvr.toml", '[archive]\nmask = "options/mask.png"\n')
    t.age(".")
    archive(t, "--sandbox", "required", "--reference", str(t.path("options/scene.png")), "--config", "options/vvr.toml", "--log-file",
            "elsewhere/log").expect(0, "3 clips drawn, 0 failed")
    for clip in ("gate/hard.avi", "gate/soft.avi", "hall/clip.avi"):
        check(sidecar(t, clip)["state"] == "done", clip)
    check("Landlock" in t.path("elsewhere/log").read_text(), "the log file has no word of it")


@pytest.mark.nightly
def test_the_sandbox_lets_a_day_through(t, walls):
    t.old_clips(*[f"2026-11-21/08/gate/{minute}.00.avi" for minute in ("00", "01", "02")])
    archive(t, "--sandbox", "required", "--per", "day").expect(0, "1 clip drawn, 0 failed")


@pytest.mark.nightly
def test_the_sandbox_needs_no_home(t, walls):
    """A service has a home that is not there, a folder for temporary files of its own, and no cache."""
    t.old_clips("one.avi")
    environment = {"PATH": "/usr/bin:/bin", "HOME": "/nonexistent", "TMPDIR": str(t.path("in")), "VVR_CONFIG": "",
                   "MESA_SHADER_CACHE_DIR": str(t.path("no/cache"))}
    archive(t, "--sandbox", "required", env=environment).expect(0, "1 clip drawn, 0 failed")
    complete(t, ["one.avi"])
