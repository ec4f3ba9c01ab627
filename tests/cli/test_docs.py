"""What README and docs/ say is true: their commands run, the list of options is the program's own."""

import pathlib
import re
import subprocess

from harness import check


def commands(text):
    """The commands of the ```sh blocks that follow a line `<!-- test -->`."""
    return re.findall(r"<!-- test -->\n+```sh\n(.*?)```", text, flags=re.DOTALL)


def run_commands(t, page):
    """Runs a page's commands in a folder where the clip that it names is."""
    blocks = commands((t.source / page).read_text())
    check(blocks, f"{page} has no commands to test")
    t.clip("clip.avi")
    t.path(".cache").mkdir()
    t.clip(".cache/vtest.avi")  # where scripts/demo leaves it
    (t.path("bin")).mkdir()
    t.path("bin/vvr").symlink_to(t.vvr_path)
    for block in blocks:
        done = t.run(["bash", "-euc", f'PATH="{t.path("bin")}:$PATH"\n{block}'])
        check(done.status == 0, str(done))


def test_readme_commands(t):
    run_commands(t, "README.md")


def test_formats_commands(t):
    run_commands(t, "docs/formats.md")


def test_reliability_commands(t):
    run_commands(t, "docs/reliability.md")


def test_golden_images_commands(t):
    run_commands(t, "docs/golden-images.md")


def test_report_commands(t):
    run_commands(t, "docs/report.md")


def test_archive_commands(t):
    run_commands(t, "docs/archive.md")


def test_day_commands(t):
    run_commands(t, "docs/day.md")


def test_page_commands(t):
    run_commands(t, "docs/page.md")


def test_cut_commands(t):
    run_commands(t, "docs/cut.md")


def test_pictures_commands(t):
    run_commands(t, "docs/pictures.md")


def test_reading_commands(t):
    run_commands(t, "docs/reading.md")


def test_faq_commands(t):
    run_commands(t, "docs/faq.md")


def test_watch_commands(t):
    run_commands(t, "docs/watch.md")


def test_cluster_commands(t):
    run_commands(t, "docs/cluster.md")


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


def test_reliability_names_its_tests(t):
    """Each promise has its tests, and each test that is named is there."""
    tests = t.source / "tests"
    there = {"cluster.slurm"}
    for file in (tests / "cli").glob("test_*.py"):
        there.update(re.findall(r"^def test_(\w+)\(", file.read_text(), flags=re.MULTILINE))
    for file in tests.rglob("*.cpp"):
        found = re.findall(r"^TEST(?:_[FP])?\((\w+), (\w+)\)", file.read_text(), flags=re.MULTILINE)
        there.update(f"{suite}.{name}" for suite, name in found)
    rows = rows_of((t.source / "docs" / "reliability.md").read_text())
    check(len(rows) > 40, f"{rows}")
    for *_, named in rows:
        names = re.findall(r"`([\w.]+)`", named)
        check(names and not re.sub(r"`[\w.]+`|[, ]", "", named), f"a promise of docs/reliability.md without a test: {named}")
        for name in names:
            check(name in there, f"docs/reliability.md names the test {name}, which is not there")


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
    for script in [t.source / "scripts" / name for name in ("install", "demo", "test", "bench", "lib.sh", "fuzz", "faults", "package",
                                                          "figures", "reading-figures")] + jobs:
        done = t.run(["bash", "-n", str(script)])
        check(done.status == 0, str(done))
