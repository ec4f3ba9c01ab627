"""The jobs of scripts/cluster with a Slurm of a few lines, which runs a job where it is submitted; scripts/cluster/test
has a real one."""

import fcntl
import os
import threading

import pytest
from harness import check, lock_name

SBATCH = """#!/bin/bash
set -eu
tasks=1 log=/dev/null
echo "$@" >>submitted
while [[ $1 == --* ]]; do
    case $1 in
        --array=1-*) tasks=${1#--array=1-} ;;
        --output=*) log=${1#--output=} ;;
    esac
    shift
done
for task in $(seq "$tasks"); do
    SLURM_ARRAY_TASK_ID=$task SLURM_JOB_ID=7 bash "$@" >>"${log%%%*}" 2>&1 || echo "task $task: status $?" >>ended
done
echo 7
"""
SCONTROL = """#!/bin/bash
case $1 in
    --oneliner) echo "JobId=7 JobState=${STATE:-RUNNING} Requeue=1 Restarts=${RESTARTS:-0} BatchFlag=1" ;;
    *) echo "$@" >>requeued ;;
esac
"""

def script_of(t, name, text):
    t.write(name, text)
    t.path(name).chmod(0o755)
    return str(t.path(name))


def submit(t, script, *arguments, **environment):
    script_of(t, "bin/sbatch", SBATCH)
    script_of(t, "bin/scontrol", SCONTROL)
    path = f"{t.path('bin')}:{os.environ['PATH']}"
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("SLURM_", "SBATCH_", "VVR"))}
    return t.run([str(t.source / "scripts/cluster" / script), *arguments],
                 env=kept | {"PATH": path, "VVR": t.vvr_path} | environment)


def text_of(t, pattern):
    return "".join(path.read_text() for path in sorted(t.folder.glob(pattern)))


def test_cluster_draws_an_archive(t):
    for name in ("gate", "hall"):
        t.clip(f"in/{name}/clip.avi", seconds=1)
    t.write("in/bad.avi", "no video")
    t.age("in")
    small = ("--", "--size", "160x100")
    submit(t, "submit-archive", "in", "out", "--shards", "3", "--cpus", "2", *small).expect(0, "then the index as job 7", out="7\n")
    for name in ("gate/clip.avi.png", "hall/clip.avi.png", "index.html", "bad.avi.json"):
        check(t.path(f"out/{name}").exists(), f"{name} is not there\n{text_of(t, 'out/.logs/*')}")
    check(t.path("ended").read_text().count("status 6") == 1, "the task of the bad clip did not end with 6")
    check("--cpus-per-task=2" in t.path("submitted").read_text(), "no processors asked for")
    check("afterany:7" in t.path("submitted").read_text(), "no index after clips that fail")
    check(not t.path("requeued").exists(), "a clip that is bad is bad on every node")
    submit(t, "submit-archive", "in", "out", "--shards", "3", "--gpu", *small).expect(0, out=None)
    check("--gres=gpu:1" in t.path("submitted").read_text() and "--backend egl" in t.path("submitted").read_text(), "no GPU asked for")


@pytest.mark.nightly
def test_cluster_requeues_what_may_be_the_nodes_fault(t):
    t.path("in").mkdir()
    vvr = script_of(t, "vvr", "#!/bin/sh\ncase $* in *--dry-run*) ;; *) exit 4 ;; esac\n")

    def tried(**environment):
        t.path("ended").unlink(missing_ok=True)
        t.path("requeued").unlink(missing_ok=True)
        submit(t, "submit-archive", "in", "out", "--shards", "1", VVR=vvr, **environment).expect(0, out=None)
        check("task 1: status 4" in t.path("ended").read_text(), "the status is another")
        return t.path("requeued").exists()

    check(tried(), "not put back into the queue")
    check(not tried(SLURM_RESTART_COUNT="5", RESTARTS="5"), "a sixth restart")
    check(tried(SLURM_RESTART_COUNT="5", RESTARTS="5", VVR_RESTARTS="6"), "VVR_RESTARTS has no effect")
    check(not tried(STATE="COMPLETED"), "a job that has ended is started again by a run that was lost")
    check(not tried(RESTARTS="1"), "the run that was lost puts back the one that took its place")


@pytest.mark.nightly
def test_cluster_waits_for_the_run_that_slurm_lost(t):
    t.path("out").mkdir()
    t.clip("in/a.avi", seconds=1)
    t.age("in")

    def started_again(**environment):
        return submit(t, "submit-archive", "in", "out", "--shards", "1", "--", "--size", "160x100",
                      SLURM_RESTART_COUNT="1", RESTARTS="1", **environment).expect(0, out=None)

    with open(t.path(f"out/{lock_name('a.avi')}"), "w") as lock:
        lock.write("a.avi")
        lock.flush()
        fcntl.flock(lock, fcntl.LOCK_EX)
        started_again(VVR_PATIENCE="1")
        check("after 5 s 1 clip(s) are still in the hands of another run" in text_of(t, "out/.logs/*"), text_of(t, "out/.logs/*"))
        check(t.path("ended").read_text() == "task 1: status 6\n", "the task is content")
        t.path("ended").unlink()
        threading.Timer(4, lambda: fcntl.flock(lock, fcntl.LOCK_UN)).start()
        started_again()
        check(t.path("out/a.avi.png").exists() and not t.path("ended").exists(), text_of(t, "out/.logs/*"))


@pytest.mark.parametrize("seconds, options", [
    (3, ("--grid", "9", "--color=video", "--camera", "-20,40", "--opacity", "2")),
    # Long ones keep flow of a part of their frames.
    pytest.param(20, (), marks=pytest.mark.nightly),
    pytest.param(20, ("--time", "busy"), marks=pytest.mark.nightly),
    pytest.param(20, ("--preset", "day"), marks=pytest.mark.nightly),
])
def test_cluster_draws_a_clip_in_parts(t, seconds, options):
    t.clip(seconds=seconds)
    options = (*options, "--size", "160x100")
    t.vvr("render", "clip.avi", "-o", "whole.png", "--backend", "software", *options).expect(0, " frames in ")
    submit(t, "submit-clip", "clip.avi", "parts.png", "--parts", "2", "--", *options).expect(0, "array 7 of 2 parts", out="7\n")
    check(t.path("parts.png").exists(), f"no picture\n{text_of(t, 'parts.png.parts-*/logs/*')}")
    check(t.path("parts.png").read_bytes() == t.path("whole.png").read_bytes(), f"the parts make another picture, {options}")
    check(not list(t.folder.glob("parts.png.*")), f"something is left: {t.files()}")


@pytest.mark.nightly
def test_cluster_makes_the_parts_that_are_missing(t):
    t.clip("clip.avi", seconds=2)
    vvr = script_of(t, "vvr", f"""#!/bin/bash
[[ $* != *--part* ]] || echo "$*" >>extracted
[[ $* != *--part\\ 2/3* || -e mended ]] || exit 3
exec '{t.vvr_path}' "$@"
""")

    def once():
        t.path("extracted").unlink(missing_ok=True)
        arguments = ("clip.avi", "out.png", "--parts", "3", "--", "--size", "160x100")
        submit(t, "submit-clip", *arguments, VVR=vvr).expect(0, out=None)
        return len(t.path("extracted").read_text().splitlines())

    check(once() == 3, "not every part was tried")
    logs = text_of(t, "out.png.parts-*/logs/*")
    check("there are 2 of 3 parts in 'out.png.parts-" in logs and "run submit-clip again" in logs, logs)
    check(not t.path("out.png").exists() and not list(t.folder.glob("out.png.parts-*/try.*")), str(t.files()))
    t.write("mended", "")
    check(once() == 1, "parts that are whole were made again")
    t.expect_picture("out.png")


@pytest.mark.nightly
def test_cluster_refuses_what_cannot_be(t):
    t.clip("clip.avi", seconds=1)
    t.path("in").mkdir()
    for command, text in [
        (("submit-archive", "in"), "asked for IN and OUT, found 1 names"),
        (("submit-archive", "none", "out"), "cannot read the archive 'none'"),
        (("submit-archive", "in", "out", "--shards", "0"), "--shards: '0' is not a whole number above 0"),
        (("submit-archive", "in", "out", "--cpus"), "--cpus needs a value"),
        (("submit-archive", "in", "out", "--partition", "long"), "unknown option '--partition'"),
        (("submit-archive", "in", "out", "--", "--part=1/2"), "--part is for submit-archive to set"),
        (("submit-archive", "in", "out", "--", "--sise", "1x1"), "did you mean"),
        (("submit-clip", "clip.avi"), "asked for CLIP and OUT, found 1 names"),
        (("submit-clip", "none.avi", "out.png"), "none.avi"),
        (("submit-clip", "clip.avi", "out.png", "--parts", "11"), "--parts 11: 'clip.avi' tells of 10 frames"),
        (("submit-clip", "clip.avi", "out.png", "--parts", "2", "--", "--start", "3f"),
         "--start does not go with parts of a whole clip"),
        (("submit-clip", "clip.avi", "out.png", "--parts", "2", "--", "--sise", "1x1"), "are options of vvr render"),
        (("submit-clip", "clip.avi", "out.png", "--parts", "2", "--", "--grid", "much"), "--grid"),
    ]:
        result = submit(t, *command)
        check(result.status != 0 and text in result.err, f"{result}\nexpected: {text}")
    check(not t.path("submitted").exists(), "something was submitted")
