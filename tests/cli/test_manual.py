"""Manual pages and completions say what the program's help says."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest
from harness import check


def manual(t):
    return pathlib.Path(t.vvr_path).parents[1] / "manual"


def command_names(t):
    names = re.findall(r"^  vvr (\w+)", t.vvr("--help").out, flags=re.MULTILINE)
    check(len(names) >= 10, f"{names}")
    return names


def needs(program):
    if not shutil.which(program):
        pytest.skip(f"needs {program}")


def test_man_pages_name_every_option(t):
    for command in command_names(t):
        options = re.findall(r"^  (?:-\w, )?(--[a-z-]+)", t.vvr(command, "--help").out, flags=re.MULTILINE)
        check("--help" in options, f"{command}: {options}")
        page = (manual(t) / "man1" / f"vvr-{command}.1").read_text().replace("\\-", "-")
        for option in options:
            check(f"\\fB{option}\\fR" in page, f"vvr-{command}(1) does not tell of {option}")


def test_man_pages_are_sound(t):
    needs("mandoc")
    pages = sorted((manual(t) / "man1").glob("*.1"))
    check(len(pages) == 1 + len(command_names(t)), f"{pages}")
    done = t.run(["mandoc", "-Tlint", "-Wwarning", *pages])
    check(done.status == 0, str(done))
    text = t.run(["mandoc", "-Tutf8", manual(t) / "man1" / "vvr.1"]).out
    for word in ("CONFIG FILES", "ENVIRONMENT", "VVR_CONFIG", "TMPDIR", "EXIT STATUS", "vvr-render"):
        check(word in re.sub(".\x08", "", text), text)


def bash_completes(t, *words):
    """What the last word could become, by the function that the file gives to bash."""
    script = '''source "$1"; shift
        COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
        [[ $(complete -p vvr) == *" -F _vvr "* ]] && _vvr && printf "%s\\n" "${COMPREPLY[@]}"'''
    done = t.run(["bash", "--norc", "-uc", script, "bash", manual(t) / "bash" / "vvr", "vvr", *words])
    check(done.status == 0 and done.err == "", str(done))
    return done.out.split()


def test_bash_completes_commands_options_and_values(t):
    for words, expected in [
        (["re"], ["render"]),
        (["render", "--filt"], ["--filter"]),
        (["render", "--filter", "te"], ["temporal"]),
        (["render", "--filter", "=", "te"], ["temporal"]),
        (["render", "clip.avi", "--show", "volume,ru"], ["volume,ruler"]),
        (["render", "--slices", "1"], []),
        (["doctor", "--filt"], []),
        (["nothing", "--filt"], []),
    ]:
        found = bash_completes(t, *words)
        check(found == expected, f"{words} is completed to {found}, not {expected}")
    check(bash_completes(t, "") == command_names(t), "all commands")
    check(bash_completes(t, "render", "--theme", "=") == ["light", "dark", "print"], "all values")


def test_fish_completes_commands_options_and_values(t):
    needs("fish")
    for line, expected in [("vvr re", "render"), ("vvr render --filt", "--filter"), ("vvr render --filter te", "temporal"),
                           ("vvr render --show volume,ru", "volume,ruler")]:
        done = t.run(["fish", "--no-config", "-c", "source $argv[1]; complete -C $argv[2]", manual(t) / "fish" / "vvr.fish",
                      line])
        check([row.split("\t")[0] for row in done.out.splitlines()] == [expected] and done.err == "", str(done))


def test_zsh_completion_is_sound(t):
    needs("zsh")
    script = '''autoload -Uz compinit && compinit -D -u && autoload -Uz _vvr && functions _vvr >/dev/null
        [[ $_comps[vvr] == _vvr ]] && zsh -n $fpath[1]/_vvr'''
    done = t.run(["zsh", "-fc", f"fpath=({manual(t) / 'zsh'} $fpath)\n{script}"])
    check(done.status == 0 and done.err == "", str(done))


def test_help_that_is_not_understood_is_an_error(t):
    sys.path.insert(0, str(t.source / "scripts" / "manual"))
    try:
        from command_help import parse
    finally:
        sys.path.pop(0)
    text = t.vvr("render", "--help", env=os.environ | {"COLUMNS": "120"}).out
    parse("render", text)
    for broken in (text.replace("\nRun:", "\nwords that are none of an option\n\nRun:"), text.replace("  --log-file", "  --NoOption"),
                   text.replace("values: blue, ", "values; blue, ")):
        with pytest.raises(ValueError):
            parse("render", broken)


def test_manual_needs_its_date(t):
    done = subprocess.run([t.source / "scripts" / "manual" / "make", t.vvr_path, t.path("out")], env={}, check=False,
                          stderr=subprocess.PIPE)
    check(done.returncode == 1 and b"SOURCE_DATE_EPOCH" in done.stderr and not t.path("out").exists(), str(done))
