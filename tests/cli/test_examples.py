"""The files of docs/examples do what their pages say, as far as that goes without the machines they are for."""

import re

import pytest
from harness import check


def step(t, name):
    """The commands of a step of the workflow."""
    text = (t.source / "docs" / "examples" / "golden-images.yml").read_text()
    found = re.search(rf"- name: {name}\n        run: \|\n((?:          .*\n)+)", text)
    check(found, f"the workflow has no step '{name}'")
    return re.sub(r"^          ", "", found.group(1), flags=re.MULTILINE)


def test_example_workflow_compares(t):
    t.path("golden").mkdir()
    t.clip("door.avi")
    t.clip("hall.mkv", seconds=1)
    t.write("golden/golden.toml", 'size = "160x100"\n[door]\ninput = "../door.avi"\n[hall]\ninput = "../hall.mkv"\n')

    def compare():
        return t.run(["sh", "-ec", step(t, "Compare the pictures")], env=t.put_on_path())

    compare().expect(7, out=None)
    for name in ("door", "hall"):
        t.path(f"golden/{name}.candidate.png").rename(t.path(f"golden/{name}.png"))
    compare().expect(0, out=None)
    t.copy("golden/hall.png", "golden/door.png")
    failed = compare().expect(7, out=None)
    check('failures="1"' in t.path("golden.xml").read_text(), str(failed))
    kept = sorted(path.name for path in t.path("golden").glob("door.*"))
    check(kept == ["door.candidate.png", "door.diff.png", "door.png"], f"{kept}")


def test_example_services_can_write(t):
    """A unit writes only below the folders that systemd opens to it."""
    for name in ("vvr-watch@.service", "vvr-archive.service"):
        unit = (t.source / "docs" / "examples" / name).read_text()
        written = re.search(r"^ExecStart=.* -o (\S+)", unit, flags=re.MULTILINE).group(1)
        opened = [f"/var/lib/{name}" for name in re.findall(r"^StateDirectory=(.*)", unit, flags=re.MULTILINE)]
        opened += re.findall(r"^ReadWritePaths=(.*)", unit, flags=re.MULTILINE)
        check("\nUser=vvr\n" in unit and any(f"{written}/".startswith(f"{folder}/") for folder in opened), unit)


def cron_lines(t):
    """Every line for a crontab in the docs: page and command."""
    lines = [(page.name, line) for page in [t.source / "README.md", *sorted((t.source / "docs").glob("*.md"))]
             for line in re.findall(r"^[\d*/,-]+(?: +[\d*/,-]+){4} +(\S.*)$", page.read_text(), flags=re.MULTILINE)]
    check(len(lines) >= 4, f"{lines}")
    return lines


@pytest.mark.nightly
def test_cron_lines_draw_what_is_new(t):
    drawn = 0
    t.write("small.toml", 'size = "160x100"\n')
    as_cron_has_it = {"VVR_CONFIG": str(t.path("small.toml")), "PATH": "/usr/bin:/bin", "SHELL": "/bin/sh", "HOME": str(t.folder), "LOGNAME": "vvr"}
    for number, (page, line) in enumerate(cron_lines(t)):
        check(line.startswith(("/usr/local/bin/vvr ", "/usr/bin/vvr ")), f"{page}: cron does not find the program of `{line}`")
        here = t.path(f"{number}")
        t.clip(f"{number}/clips/door one.avi", seconds=1)
        t.stamp(f"{number}/clips/door one.avi", 1e9)
        (here / "pictures").mkdir()
        for place, there in (("/usr/local/bin/vvr", t.vvr_path), ("/usr/bin/vvr", t.vvr_path), ("/media/frigate/recordings", "clips"), ("/srv/cctv", "clips"), ("/data/cctv", "clips"),
                             ("/srv/pictures", "pictures"), ("/data/pictures", "pictures"), ("/var/log/vvr", ".")):
            line = line.replace(place, str(there))
        for _ in range(2 if number == 0 else 1):
            t.run(["/bin/sh", "-c", line], cwd=here, env=as_cron_has_it).expect(0, err="")  # cron would send a mail
        if "--write index" in line:
            check((here / "pictures/index.html").exists(), f"{page}: no index of `{line}`")
        else:
            drawn += len(list((here / "pictures").glob("*.avi.png")))
        if "--log-file" in line:
            check("1 clip drawn" in (here / "archive.log").read_text(), "the log is empty")
    check(drawn >= 2, f"{drawn} pictures were drawn")


def exec_line(t, unit, **places):
    """What a unit starts, with places of this machine."""
    line = re.search(r"^ExecStart=(.*)", (t.source / "docs" / "examples" / unit).read_text(), flags=re.MULTILINE).group(1)
    for there, here in places.items():
        line = line.replace(there, str(here))
    return line


def test_archive_service_draws_what_is_new(t):
    examples = t.source / "docs" / "examples"
    unit = (examples / "vvr-archive.service").read_text()
    check("\nSuccessExitStatus=6\n" in unit and "ReadWritePaths=/srv/pictures\n" in unit, unit)
    check("/var/log/vvr/*.log" in (examples / "vvr-archive.logrotate").read_text(), "logs of the crontab are not rotated")
    t.clip("clips/door one.avi", seconds=1)
    t.stamp("clips/door one.avi", 1e9)
    line = exec_line(t, "vvr-archive.service", **{"/usr/local/bin/vvr": t.vvr_path, "/srv/cctv": "clips", "/srv/pictures": "pictures"})
    done = t.run(line.split(), env={})
    check(done.status == 0 and "1 clip drawn" in done.err and t.path("pictures/door one.avi.png").exists(), str(done))


def test_watch_service_keeps_the_address_to_itself(t):
    t.clip("gate.avi", seconds=4)
    t.write("stream", "gate.avi\n")
    line = exec_line(t, "vvr-watch@.service", **{"/usr/local/bin/vvr": t.vvr_path, "${CREDENTIALS_DIRECTORY}": t.folder,
                                                 "/var/lib/vvr/%i": "gate", "$OPTIONS": "--brick 1s --reference first --size 320x200"})
    done = t.run(line.split(), env={})
    check(done.status == 0 and t.path("gate.html").exists(), str(done))
    check("gate.avi" not in line and "rtsp" not in line, f"other users read {line}")
    t.write("stream", "\n")
    t.vvr("watch", "@stream", "-o", "gate.png").expect(1, "'stream'", "rtsp://camera/stream", code="input-missing")
    t.vvr("watch", "@none", "-o", "gate.png").expect(2, "none", "No such file or directory", code="file-not-found")
