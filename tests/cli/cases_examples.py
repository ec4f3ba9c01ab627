"""The files of docs/examples do what their pages say, as far as that goes without the machines they are for."""

import re

from harness import case, check


def put_vvr_on_path(t):
    t.path("bin").mkdir(exist_ok=True)
    if not t.path("bin/vvr").exists():
        t.path("bin/vvr").symlink_to(t.vvr_path)
    return {"PATH": f"{t.path('bin')}:/usr/local/bin:/usr/bin:/bin", "HOME": str(t.folder)}


def step(t, name):
    """The commands of a step of the workflow."""
    text = (t.source / "docs" / "examples" / "golden-images.yml").read_text()
    found = re.search(rf"- name: {name}\n        run: \|\n((?:          .*\n)+)", text)
    check(found, f"the workflow has no step '{name}'")
    return re.sub(r"^          ", "", found.group(1), flags=re.MULTILINE)


@case
def example_workflow_compares(t):
    environment = put_vvr_on_path(t)
    t.path("clips").mkdir()
    t.path("golden").mkdir()
    t.clip("clips/door.avi")
    t.clip("clips/hall.mkv", seconds=1)

    def compare():
        return t.run(["sh", "-ec", step(t, "Compare the pictures")], env=environment)

    check(compare().status == 1, "a missing golden picture passes")
    for name in ("door", "hall"):
        t.path(f"golden/{name}.candidate.png").rename(t.path(f"golden/{name}.png"))
    passed = compare()
    check(passed.status == 0, str(passed))
    t.path("golden/door.png").write_bytes(t.path("golden/hall.png").read_bytes())
    failed = compare()
    check(failed.status == 1 and "differs from 'golden/door.png'" in failed.err, str(failed))
    kept = sorted(path.name for path in t.path("golden").glob("door.*"))
    check(kept == ["door.candidate.png", "door.diff.png", "door.png"], f"{kept}")


@case
def example_workflow_builds_with_what_is_there(t):
    build = step(t, "Build vvr")
    check("./scripts/install" in build and (t.source / "scripts" / "install").exists(), build)
    presets = (t.source / "CMakePresets.json").read_text()
    check('"name": "release"' in presets and "--preset release" in build, build)


@case
def example_for_cron_draws_what_is_new(t):
    environment = put_vvr_on_path(t)
    t.path("clips").mkdir()
    t.clip("clips/door one.avi")
    t.clip("clips/hall.mkv", seconds=1)
    script = t.source / "docs" / "examples" / "new-clips.sh"

    def run():
        return t.run(["sh", script, "clips", "pictures"], env=environment)

    def pictures():
        return {path.name: path.stat().st_mtime_ns for path in t.path("pictures").glob("*.png")}

    first = run()
    check(first.status == 0 and first.out + first.err == "", f"cron would send a mail: {first}")
    drawn = pictures()
    check(set(drawn) == {"door one.avi.png", "hall.mkv.png"}, str(drawn))
    check(run().status == 0 and pictures() == drawn, "pictures that were there are drawn again")
    t.write("clips/notes.txt", "no clip")
    t.clip("clips/lift.avi", seconds=1)
    third = run()
    check(third.status == 1 and "notes.txt" in third.err and third.err.count("\n") == 1, str(third))
    check(set(pictures()) == {*drawn, "lift.avi.png"}, "one bad clip stops the others")
