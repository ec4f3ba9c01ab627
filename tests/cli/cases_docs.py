"""What README and docs/ say is true: their commands run, the list of options is the program's own."""

import re
import subprocess

from harness import case, check


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


@case
def readme_commands(t):
    run_commands(t, "README.md")


@case
def formats_commands(t):
    run_commands(t, "docs/formats.md")


@case
def reliability_commands(t):
    run_commands(t, "docs/reliability.md")


@case
def golden_images_commands(t):
    run_commands(t, "docs/golden-images.md")


@case
def report_commands(t):
    run_commands(t, "docs/report.md")


@case
def archive_commands(t):
    run_commands(t, "docs/archive.md")


@case
def page_commands(t):
    run_commands(t, "docs/page.md")


@case
def watch_commands(t):
    run_commands(t, "docs/watch.md")


@case
def cluster_commands(t):
    run_commands(t, "docs/cluster.md")


@case
def cli_page_is_up_to_date(t):
    page = subprocess.run([t.source / "scripts" / "cli-page", t.vvr_path], stdout=subprocess.PIPE, check=True).stdout
    check(page == (t.source / "docs" / "cli.md").read_bytes(), "docs/cli.md is old; make it with scripts/cli-page")


@case
def options_that_messages_name_exist(t):
    page = (t.source / "docs" / "cli.md").read_text()
    known = set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", page))
    for room in ("cli", "core", "gl"):
        for file in (t.source / room).rglob("*.cpp"):
            lines = [line for line in file.read_text().splitlines() if '"' in line and not line.strip().startswith("//")]
            for option in re.findall(r"(?<![\w-])--[a-z][a-z-]+", "\n".join(lines)):
                check(option in known, f"{file.relative_to(t.source)} names {option}, which is no option")


@case
def links_lead_somewhere(t):
    for page in [*t.source.glob("*.md"), *(t.source / "docs").glob("*.md")]:
        for link in re.findall(r"\]\((?!http)([^)#]+)", page.read_text()):
            check((page.parent / link).exists(), f"{page.name} links to {link}, which is not there")
        for name in re.findall(r"`((?:cli|core|gl|glsl|scripts|tests)/[\w./-]*)`", page.read_text()):
            check((t.source / name).exists(), f"{page.name} names {name}, which is not there")


@case
def scripts_are_sound(t):
    jobs = sorted((t.source / "scripts" / "cluster").iterdir())
    for script in [t.source / "scripts" / name for name in ("install", "demo", "test", "bench", "cli-page", "lib.sh")] + jobs:
        done = t.run(["bash", "-n", str(script)])
        check(done.status == 0, str(done))
