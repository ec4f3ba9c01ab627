"""The files of docs/examples do what their pages say, as far as that goes without the machines they are for."""

import os
import re
import shutil

from harness import check


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


def test_example_workflow_compares(t):
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


def test_example_workflow_builds_with_what_is_there(t):
    build = step(t, "Build vvr")
    check("./scripts/install" in build and (t.source / "scripts" / "install").exists(), build)
    presets = (t.source / "CMakePresets.json").read_text()
    check('"name": "release"' in presets and "--preset release" in build, build)


def test_example_services_can_write(t):
    """A unit writes only below the folders that systemd opens to it."""
    for name in ("vvr-watch@.service", "vvr-archive.service"):
        unit = (t.source / "docs" / "examples" / name).read_text()
        written = re.search(r"^ExecStart=.* -o (\S+)", unit, flags=re.MULTILINE).group(1)
        opened = [f"/var/lib/{name}" for name in re.findall(r"^StateDirectory=(.*)", unit, flags=re.MULTILINE)]
        opened += re.findall(r"^ReadWritePaths=(.*)", unit, flags=re.MULTILINE)
        check("\nUser=vvr\n" in unit and any(f"{written}/".startswith(f"{folder}/") for folder in opened), unit)


def test_examples_for_cron_and_systemd_draw_what_is_new(t):
    examples = t.source / "docs" / "examples"
    unit = (examples / "vvr-archive.service").read_text()
    lines = re.findall(r"^ExecStart=(.*)", unit, flags=re.MULTILINE)
    lines += re.findall(r"^\*/10 \* \* \* \*  (.*)", (t.source / "docs" / "archive.md").read_text(), flags=re.MULTILINE)
    check(len(lines) == 3, f"{lines}")
    check("\nSuccessExitStatus=6\n" in unit and "ReadWritePaths=/srv/pictures\n" in unit, unit)
    check("/var/log/vvr/*.log" in (examples / "vvr-archive.logrotate").read_text() and "/var/log/vvr/archive.log" in lines[2], lines[2])
    if shutil.which("systemd-analyze"):
        for name in ("vvr-archive.service", "vvr-archive.timer"):
            copy = (examples / name).read_text().replace("/usr/local/bin/vvr", t.vvr_path)
            t.write(name, copy)
        done = t.run(["systemd-analyze", "verify", "--man=no", t.path("vvr-archive.timer")])
        check("vvr-archive" not in done.err, str(done))
    for number, line in enumerate(lines):
        t.path(f"clips{number}").mkdir()
        t.clip(f"clips{number}/door one.avi", seconds=1)
        os.utime(t.path(f"clips{number}/door one.avi"), (1e9, 1e9))
        for place, here in (("/usr/local/bin/vvr", t.vvr_path), ("/srv/cctv", f"clips{number}"), ("/srv/pictures", f"pictures{number}"),
                            ("/var/log/vvr", ".")):
            line = line.replace(place, here)
        done = t.run(["sh", "-c", line], env={"PATH": "/usr/bin:/bin", "HOME": str(t.folder)})  # as cron has it
        check(done.status == 0 and done.out == "", f"cron would send a mail: {done}")
        check(t.path(f"pictures{number}/door one.avi.png").exists(), str(done))
        check(("1 clip drawn" in done.err) == (number == 0), f"what it prints: {done}")
    check("1 clip drawn" in t.path("archive.log").read_text(), "the log is empty")
