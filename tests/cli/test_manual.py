"""Manual pages and completions say what the program's help says."""

import os
import re
import shutil

import pytest
from harness import check


@pytest.fixture(name="manual")
def made_manual(t):
    """The folder in which scripts/manual/make has written everything."""
    t.run([t.source / "scripts/manual/make", t.vvr_path, t.path("manual")],
          env=os.environ | {"SOURCE_DATE_EPOCH": "86400"}).expect(0)
    return t.path("manual")


def needs(program):
    if not shutil.which(program):
        pytest.skip(f"needs {program}")


def test_man_pages_name_every_option(t, manual):
    for name, command in t.help().items():
        page = (manual / "man1" / f"vvr-{name}.1").read_text().replace("\\-", "-")
        check(f".TH VVR-{name.upper()} 1 1970-01-02 " in page, f"the date of SOURCE_DATE_EPOCH: {page[:80]}")
        for option in command["options"]:
            check(f"\\fB--{option['name']}\\fR" in page, f"vvr-{name}(1) does not have --{option['name']}")
            check(not option["default"] or f"[{option['default']}]" in page, f"vvr-{name}(1) lacks the default of --{option['name']}")


def test_man_pages_are_sound(t, manual):
    needs("mandoc")
    pages = sorted((manual / "man1").glob("*.1"))
    check(len(pages) == 1 + len(t.help()), f"{pages}")
    t.run(["mandoc", "-Tlint", "-Wwarning", *pages]).expect(0, out=None)
    text = t.run(["mandoc", "-Tutf8", manual / "man1" / "vvr.1"]).out
    for word in ("CONFIG FILES", "ENVIRONMENT", "VVR_CONFIG", "TMPDIR", "EXIT STATUS", "an internal error", "vvr-render"):
        check(word in re.sub(".\x08", "", text), text)


def bash_completes(t, manual, *words):
    """What the last word could become, by the function that the file gives to bash."""
    script = '''source "$1"; shift
        COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
        [[ $(complete -p vvr) == *" -F _vvr "* ]] && _vvr && printf "%s\\n" "${COMPREPLY[@]}"'''
    done = t.run(["bash", "--norc", "-uc", script, "bash", manual / "bash" / "vvr", "vvr", *words])
    return done.expect(0, out=None, err="").out.split()


def test_bash_completes_commands_options_and_values(t, manual):
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
        found = bash_completes(t, manual, *words)
        check(found == expected, f"{words} is completed to {found}, not {expected}")
    check(bash_completes(t, manual, "") == list(t.help()), "all commands")
    check(bash_completes(t, manual, "render", "--theme", "=") == ["light", "dark", "print"], "all values")


def test_fish_completes_commands_options_and_values(t, manual):
    needs("fish")
    for line, expected in [("vvr re", "render"), ("vvr render --filt", "--filter"), ("vvr render --filter te", "temporal"),
                           ("vvr render --show volume,ru", "volume,ruler")]:
        done = t.run(["fish", "--no-config", "-c", "source $argv[1]; complete -C $argv[2]", manual / "fish" / "vvr.fish",
                      line])
        check([row.split("\t")[0] for row in done.out.splitlines()] == [expected] and done.err == "", str(done))


def test_zsh_completion_is_sound(t, manual):
    needs("zsh")
    script = '''autoload -Uz compinit && compinit -D -u && autoload -Uz _vvr && functions _vvr >/dev/null
        [[ $_comps[vvr] == _vvr ]] && zsh -n $fpath[1]/_vvr'''
    t.run(["zsh", "-fc", f"fpath=({manual / 'zsh'} $fpath)\n{script}"]).expect(0, out=None, err="")
