"""What README and docs/ say is true: their commands run, the list of options is the program's own."""

import pathlib
import re
import subprocess

import pytest
from harness import check, nightly_except

SOURCE = pathlib.Path(__file__).resolve().parents[2]


def commands(text):
    """The commands of the ```sh blocks that follow a line `<!-- test -->`."""
    return re.findall(r"<!-- test -->\n+```sh\n(.*?)```", text, flags=re.DOTALL)


PAGES = ("README.md", *sorted(f"docs/{page.name}" for page in (SOURCE / "docs").glob("*.md") if commands(page.read_text())))


@pytest.mark.parametrize("page", nightly_except(PAGES, "README.md"))
def test_commands_of(t, page):
    """Runs a page's commands in a folder where the clip that it names is. Their pictures are small if they don't say how large."""
    t.write(".cache/small.toml", 'size = "160x100"\n')
    t.clip("clip.avi")
    t.clip(".cache/vtest.avi")  # where scripts/demo leaves it
    blocks = commands((t.source / page).read_text())
    check(blocks, f"{page} has no commands to test")
    for block in blocks:
        t.run(["bash", "-euc", block], env=t.put_on_path() | {"VVR_CONFIG": str(t.path(".cache/small.toml"))}).expect(0, out=None)


def test_cli_page_is_up_to_date(t):
    page = subprocess.run([t.source / "scripts" / "cli-page", t.vvr_path], stdout=subprocess.PIPE, check=True).stdout
    check(page == (t.source / "docs" / "cli.md").read_bytes(), "docs/cli.md is old; make it with scripts/cli-page")


def test_options_that_messages_name_exist(t):
    page = (t.source / "docs" / "cli.md").read_text()
    known = set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", page))
    for module in ("cli", "core", "gl"):
        for file in (t.source / module).rglob("*.cpp"):
            lines = [line for line in file.read_text().splitlines() if '"' in line and not line.strip().startswith("//")]
            for option in re.findall(r"(?<![\w-])--[a-z][a-z-]+", "\n".join(lines)):
                check(option in known, f"{file.relative_to(t.source)} names {option}, which is no option")


def rows_of(page):
    """The rows of each table whose last column is `test`, as lists of columns."""
    rows = []
    in_table = False
    for line in page.splitlines():
        columns = [column.strip() for column in re.split(r"(?<!\\)\|", line)[1:-1]]
        if not columns:
            in_table = False
        elif columns[-1] == "test":
            in_table = True
        elif in_table and set(line) - set("|-"):
            rows.append(columns)
    return rows


def test_commands_of_pages_have_their_options(t):
    known = {name: {f"--{option['name']}" for option in command["options"]} for name, command in t.help().items()}
    found = 0
    for page in [*t.source.glob("*.md"), *(t.source / "docs").glob("*.md"), *(path for path in (t.source / "docs" / "examples").rglob("*") if path.is_file())]:
        text = page.read_text().replace("\\\n", " ")
        for command, rest in re.findall(r"(?<![\w.-])vvr (\w+)((?: +[^\n`|;#&]+)?)", text):
            for option in re.findall(r"(?<![\w-])--[a-z][a-z-]+(?![a-z<-])", rest if command in known else ""):
                found += 1
                check(option in known[command], f"{page.name}: `vvr {command}{rest}`: there is no {option}")
            bare = re.search(r"--(?:start|end|frame|from|to|brick)[ =][1-9][\d.]*(?![\d:.a-z])", rest)
            check(command not in known or not bare, f"{page.name}: `vvr {command}{rest}`: a time without its unit")
    check(found > 150, f"only {found} options were looked at")


def all_tests(source):
    """Names of all tests: of pytest without their `test_`, of unit tests with their suite, and files of tests."""
    there = {"cluster.slurm", "tests/bench/smoke_test.py"}
    for file in (source / "tests" / "cli").glob("test_*.py"):
        there.add(str(file.relative_to(source)))
        there.update(re.findall(r"^def test_(\w+)\(", file.read_text(), flags=re.MULTILINE))
    for file in (source / "tests").rglob("*_test.cpp"):
        found = re.findall(r"^TEST(?:_[FP])?\((\w+), (\w+)\)", file.read_text(), flags=re.MULTILINE)
        check(found, f"{file.name} has no test")
        there.add(str(file.relative_to(source)))
        there.update(f"{suite}.{name}" for suite, name in found)
    return there


@pytest.mark.parametrize("page, least", [("reliability.md", 70), ("paper.md", 45)])
def test_promises_have_their_tests(t, page, least):
    """Each promise has its tests, and each test that is named is there."""
    there = all_tests(t.source)
    rows = rows_of((t.source / "docs" / page).read_text())
    check(len(rows) >= least, f"{len(rows)} promises")
    for *_, named in rows:
        names = re.findall(r"`([^`]+)`", named)
        check(names, f"a promise of docs/{page} without a test: {named}")
        for name in names:
            golden = "golden" in named and (t.source / "tests" / "golden" / f"{name}.png").exists()
            check(golden or name in there or name == "tests/support/ray_caster.cpp", f"docs/{page} names the test {name}, which is not there")


def test_sentences_of_the_readme_are_in_it(t):
    text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", (t.source / "README.md").read_text())  # links as their words
    readme = " ".join(text.split())
    page = (t.source / "docs" / "reliability.md").read_text().partition("## What the README says")[2].partition("\n## ")[0]
    for sentence, _ in rows_of(page):
        check(sentence in readme, f"README.md does not say: {sentence}")


def test_links_lead_somewhere(t):
    for page in [*t.source.glob("*.md"), *(t.source / "docs").glob("*.md")]:
        for link in re.findall(r"\]\((?!http)([^)#]+)", page.read_text()):
            check((page.parent / link).exists(), f"{page.name} links to {link}, which is not there")
        for name in re.findall(r"`((?:cli|core|gl|glsl|scripts|tests)/[\w./-]*)`", page.read_text()):
            check((t.source / name).exists(), f"{page.name} names {name}, which is not there")


def test_every_page_is_listed_and_links_back(t):
    listed = set(re.findall(r"\]\(([\w-]+\.md)\)", (t.source / "docs" / "README.md").read_text()))
    pages = {page.name for page in (t.source / "docs").glob("*.md")} - {"README.md"}
    check(listed == pages, f"docs/README.md lists {sorted(listed - pages)} that are not there, and not {sorted(pages - listed)}")
    for name in sorted(pages):
        last = (t.source / "docs" / name).read_text().rstrip("\n").splitlines()[-1]
        check(last == "[All pages](README.md)", f"docs/{name} ends with '{last}', not with a link to docs/README.md")


def test_anchors_are_there(t):
    """A link to a heading of a page, by the name that GitHub gives it."""
    headings = {}
    for page in [*t.source.glob("*.md"), *(t.source / "docs").glob("*.md")]:
        text = re.sub(r"^```.*?^```", "", page.read_text(), flags=re.DOTALL | re.MULTILINE)
        titles = re.findall(r"^#+ (.*)$", text, flags=re.MULTILINE)
        headings[page] = {re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-") for title in titles}
    for page in headings:
        for link, anchor in re.findall(r"\]\((?!http)([^)#]*)#([^)]+)\)", page.read_text()):
            target = (page.parent / link).resolve() if link else page
            check(anchor in headings.get(target, ()), f"{page.name} links to {link}#{anchor}: there is no such heading")


def test_scripts_are_sound(t):
    jobs = sorted((t.source / "scripts" / "cluster").iterdir())
    for script in [t.source / "scripts" / name for name in ("install", "demo", "test", "bench", "lib.sh", "fuzz", "package",
                                                          "figures", "reading-figures", "page-figures", "page-film")] + jobs:
        t.run(["bash", "-n", str(script)]).expect(0)
