"""vvr golden: many golden pictures by one file, one status, and the results for CI systems."""

import os
import xml.etree.ElementTree as tree

import pytest
from harness import check, moving_clip

GENERAL = 'backend = "software"\nsize = "160x100"\nshow = "volume,outline"\n'


def folder(t, text):
    t.write("golden/golden.toml", GENERAL + text)


def two(t):
    moving_clip(t)
    folder(t, '[plain]\ninput = "../clip.mkv"\n\n[dark]   # on a dark ground\ninput = "../clip.mkv"\ntheme = "dark"\n')


def check_junit(t, name, tests, failures, errors):
    """The structure that CI systems expect: what each element may hold, and counts that agree."""
    root = tree.parse(t.path(name)).getroot()
    check(root.tag == "testsuites" and [suite.tag for suite in root] == ["testsuite"], f"{root}")
    suite = root[0]
    for element in (root, suite):
        counts = {key: int(element.get(key)) for key in ("tests", "failures", "errors")}
        check(counts == {"tests": tests, "failures": failures, "errors": errors} and float(element.get("time")) >= 0, f"{counts}")
    check(suite.get("name") and suite.get("skipped") == "0", "the suite has no name")
    for case in suite:
        check(case.tag == "testcase" and case.get("name") and case.get("classname") and float(case.get("time")) >= 0, f"{case.attrib}")
        check(len(case) <= 1 and all(what.tag in ("failure", "error") and what.get("type") and what.get("message") for what in case),
              f"{case.attrib}")
    check(len(suite.findall("testcase")) == tests and len(suite.findall("testcase/failure")) == failures, "counts")
    check(len(suite.findall("testcase/error")) == errors, "counts")
    return suite


def test_bless_compare_differ(t):
    two(t)
    t.vvr("golden", "golden", "--junit", "j.xml", "--report", "r.json").expect(
        7, "plain: golden picture 'golden/plain.png' does not exist", "'golden': 0 of 2 pictures as expected", code="reference-missing")
    check_junit(t, "j.xml", 2, 2, 0)
    t.vvr("golden", "golden", "--bless").expect(0, "'golden': 2 of 2 pictures blessed")
    t.expect_picture("golden/plain.png")
    check(t.path("golden/plain.png").read_bytes() != t.path("golden/dark.png").read_bytes(), "the section's settings don't hold")
    said = t.vvr("golden", "golden", "--junit", "j.xml", "--report", "-", "--diffs").expect(0, "2 of 2 pictures as expected", out=None)
    report = said.json()
    check([(one["name"], one["verdict"], one["percent_off"]) for one in report["pictures"]] == [("plain", "same", 0), ("dark", "same", 0)], said.out)
    check(report["differ"] == report["failed"] == 0, said.out)
    check_junit(t, "j.xml", 2, 0, 0)
    # One of them differs; the other is compared nevertheless.
    folder(t, '[plain]\ninput = "../clip.mkv"\nlayout = "box"\n[dark]\ninput = "../clip.mkv"\ntheme = "dark"\n')
    t.vvr("golden", "golden", "--junit", "j.xml", "--report", "r.json", "--diffs").expect(
        7, "plain: the picture differs from 'golden/plain.png'", "dark: same", "1 of 2 pictures as expected", code="picture-differs")
    suite = check_junit(t, "j.xml", 2, 1, 0)
    check(suite[0][0].get("type") == "picture-differs" and "plain.candidate.png" in suite[0][0].text, suite[0][0].text)
    plain = t.json("r.json")["pictures"][0]
    check(plain["verdict"] == "differs" and plain["code"] == "picture-differs" and plain["percent_off"] > 1, f"{plain}")
    t.expect_picture("golden/plain.candidate.png")
    check(t.path("golden/plain.diff.png").exists(), "no picture of the differences")
    t.vvr("golden", "golden", "dark").expect(0, "1 of 1 picture as expected")


def test_a_clip_that_can_not_be_drawn(t):
    """The others are compared, and the results have it."""
    moving_clip(t)
    t.write("bad<&\x01.avi", "no video")
    folder(t, '[bad]\ninput = "../bad<&\x01.avi"\n[good]\ninput = "../clip.mkv"\n')
    t.vvr("golden", "golden", "--bless").expect(6, "bad: ", "good: blessed", code="not-video")
    t.vvr("golden", "golden", "--junit", "j.xml").expect(6, "good: same", "1 of 2 pictures as expected")
    suite = check_junit(t, "j.xml", 2, 0, 1)
    check("bad<&" in suite[0][0].text and suite[0][0].get("type") == "not-video", suite[0][0].text)


def test_what_it_reads_stays(t):
    """The list, a clip elsewhere, and what the options of a section name."""
    moving_clip(t)
    t.write("golden/area.txt", "0,0 60,0 60,40\n")
    t.write("golden/mask.png", "no picture")
    folder(t, '[plain]\ninput = "../clip.mkv"\nmask = "area.txt"\n[dark]\ninput = "../clip.mkv"\nroi = "mask.png"\n')
    before = {name: t.path(name).read_bytes() for name in ("golden/golden.toml", "clip.mkv", "golden/area.txt", "golden/mask.png")}
    for name, bytes_ in before.items():
        for option in ("--report", "--junit", "--log-file"):
            t.vvr("golden", "golden", "--bless", option, name).expect(1, f"{option} '{name}'", code="output-replaces-input")
            check(t.path(name).read_bytes() == bytes_, f"{option}: {name} has changed")
    # The golden picture of one section, which another one reads.
    folder(t, '[plain]\ninput = "../clip.mkv"\n[mask]\ninput = "../clip.mkv"\n[dark]\ninput = "../clip.mkv"\nroi = "mask.png"\n')
    t.vvr("golden", "golden", "--bless").expect(1, "--golden 'golden/mask.png' would overwrite", code="output-replaces-input")
    check(t.path("golden/mask.png").read_text() == "no picture", "the mask was blessed away")


def test_links_in_the_folder_lead_nowhere(t):
    """A checkout of somebody's branch may have any."""
    two(t)
    t.vvr("golden", "golden", "--bless").expect(0)
    folder(t, '[plain]\ninput = "../clip.mkv"\nlayout = "box"\n[dark]\ninput = "../clip.mkv"\ntheme = "dark"\n')
    t.write("precious", "mine")
    for name in ("plain.candidate.png", "plain.diff.png"):
        t.path(f"golden/{name}").symlink_to(t.path("precious"))
    t.vvr("golden", "golden", "--diffs").expect(6, "'golden/plain.diff.png': it is a link; remove it", "dark: same", code="not-a-file")
    t.vvr("golden", "golden").expect(7, "plain: the picture differs", code="picture-differs")
    check(not t.path("golden/plain.candidate.png").is_symlink(), "the candidate is elsewhere")
    # A pipe, a folder or a link in place of a golden picture fails only this one.
    for make in (os.mkfifo, os.mkdir, lambda place: os.symlink(t.path("precious"), place)):
        t.path("golden/plain.png").unlink()
        make(t.path("golden/plain.png"))
        t.vvr("golden", "golden", "--bless").expect(6, "plain: ", "'golden/plain.png'", "dark: blessed", code="not-a-file")
        t.path("golden/plain.png").rename(t.path("golden/gone"))
        t.write("golden/plain.png", "")
        (t.path("golden/gone").rmdir if t.path("golden/gone").is_dir() else t.path("golden/gone").unlink)()
    check(t.path("precious").read_text() == "mine", "written through a link")


@pytest.mark.nightly
def test_files_are_found_from_anywhere(t):
    two(t)
    t.vvr("golden", "golden", "--bless").expect(0)
    t.path("elsewhere").mkdir()
    t.vvr("golden", "../golden", cwd=t.path("elsewhere")).expect(0)
    t.write("golden/mask.png", t.path("golden/plain.png").read_bytes())
    folder(t, '[plain]\ninput = "../clip.mkv"\nmask = "mask.png"\n')
    t.vvr("golden", "../golden", "--report", "-", "--quiet", cwd=t.path("elsewhere")).expect(7, out=None)


@pytest.mark.nightly
def test_mistakes_in_the_file(t):
    """Nothing is drawn then."""
    moving_clip(t)
    t.vvr("golden").expect(1, "no folder given", code="input-missing")
    t.vvr("golden", "none").expect(2, "none/golden.toml", code="file-not-found")
    for text, words, code in (
            ("", "it has no pictures", "config-invalid"),
            ('[a]\ninput = "../clip.mkv"\nsizes = "8x8"\n', "there is no setting 'sizes' (did you mean 'size'?)", "option-unknown"),
            ("[a]\n", "[a]: no input given", "input-missing"),
            ('[a]\ninput = "../clip.mkv"\n [a] # twice\ntheme = "dark"\n', "lines 4 and 6 both begin the section [a]", "config-invalid"),
            ('[a]\ninput = "../clip.mkv"\noutput = "x.png"\n', "it sets 'output', which `vvr golden` decides", "config-invalid"),
            ('[a]\ninput = "../clip.mkv"\nthumbnail = "x.jpg"\n', "there is no setting 'thumbnail'", "option-unknown"),
            ('[a]\ninput = "../clip.mkv"\nbless = true\n', "it sets 'bless'", "config-invalid"),
            ('["a/b"]\ninput = "../clip.mkv"\n', "is not usable as the name of a file", "config-invalid"),
            ('[a]\ninput = "../clip.mkv"\nsize = "big"\n', "[a]: size", "option-value")):
        folder(t, text)
        t.vvr("golden", "golden", "--bless").expect(1, "golden/golden.toml", words, code=code)
    two(t)
    t.vvr("golden", "golden", "drak").expect(1, "it has no section [drak] (did you mean 'dark'?)", code="config-invalid")
    t.expect_files("clip.mkv", "golden", "golden/golden.toml")
