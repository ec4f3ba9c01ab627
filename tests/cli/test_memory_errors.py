"""Each command under valgrind: no read or write of memory that isn't its own, no decision by what was never written."""

import pathlib
import shutil

import pytest
from harness import check

COMMANDS = {
    "render": ("render", "clip.avi", "-o", "out.png", "--size", "64x40", "--report", "out.json"),
    "page": ("render", "clip.avi", "-o", "out.html", "--size", "64x40"),
    "series": ("render", "clip.avi", "-o", "out.{brick}.png", "--size", "64x40", "--brick", "5f", "--window", "1"),
    "extract": ("extract", "clip.avi", "-o", "data"),
    "inspect": ("inspect", "clip.avi", "--frame", "3f", "-o", "out.png"),
    "info": ("info", "clip.avi", "--json"),
    "seeds": ("seeds", "data", "-o", "lists"),
    "cut": ("cut", "clip.avi", "--start", "0s", "--end", "0.5s", "-o", "out.avi"),
    "compare": ("compare", "one.png", "one.png"),
    # Workers of an archive are runs of render, and have limits that leave valgrind no room.
    "archive": ("archive", "clips", "-o", "pictures", "--dry-run"),
    "watch": ("watch", "clip.avi", "-o", "out.png", "--size", "64x40", "--reference", "first"),
    "config": ("config", "render"),
    "doctor": ("doctor", "--json"),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", COMMANDS)
def test_valgrind_finds_nothing_in(t, name):
    if not shutil.which("valgrind"):
        pytest.skip("there is no valgrind")
    if "rdtscp" not in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").split():
        pytest.skip("valgrind ends libhwy, which reads the time by RDTSCP, where the processor doesn't have that")
    t.clip(seconds=1)
    if name == "seeds":
        t.vvr("extract", "clip.avi", "-o", "data").expect(0)
    if name == "compare":
        t.render("clip.avi", output="one.png").expect(0)
    if name == "archive":
        t.clip("clips/a.avi", seconds=1)
    # The drivers compile code while they run, and the program asks the processor which instructions it has.
    result = t.run(["valgrind", "--quiet", "--error-exitcode=99", "--trace-children=yes", "--smc-check=all-non-file",
                    f"--suppressions={t.source / 'tests' / 'valgrind.supp'}", t.vvr_path, *COMMANDS[name]], timeout=1700)
    check(result.status == 0 and "==" not in result.err, f"{result}")
