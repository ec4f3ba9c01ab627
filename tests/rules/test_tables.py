"""A row of a table is all there is to add, and what repeats a table is found."""

import pathlib

import pytest
from tables import complaints

TREE = {
    "core/events/event_kind.h": 'EventKindRow{.kind = EventKind::left,\n.name = "left"},\nEventKindRow{.kind = EventKind::ran,\n.name = "ran"},\n',
    "core/events/conclude.cpp": "kind = fast ? EventKind::ran : EventKind::left;\n",
    "core/events/event.h": "EventKind kind = EventKind::left;\n",
    "core/image/picture_file.cpp": 'Format{".png", 8},\nFormat{".exr", 16},\n',
    "core/web/page/page.css": "#strip { left: 2px; }\n.left { color: red; }\n",
    "core/web/page/strip.js": "bar.style.left = share + '%';\nif (ran) stop();\n",
    "core/base/error.cpp": 'ErrorRow{ErrorCode::not_a_file, "not-a-file", ErrorKind::io,\n"no file"},\n',
    "cli/exit_status.h": "enum class ExitStatus { io = 2 };\n",
    "docs/reliability.md": "| `not-a-file` | 2 | no file |\n",
    "docs/report.schema.json": '"kind": {"enum": ["left", "ran"], "description": "x"}',
    "docs/developing.md": "| to add | files |\n|---|---|\n| an event kind | 2 |\n\n### Add an event kind (2 files)\n\n"
                          "- `core/events/event_kind.h`: the row.\n- `core/events/<name>.cpp`\n\n## Style\n",
}


def tree(folder, changed):
    for name, text in {**TREE, **changed}.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return complaints(folder)


def test_the_sources():
    assert complaints(pathlib.Path(__file__).parents[2]) == []


def test_a_tree_with_a_table_of_each(tmp_path):
    assert tree(tmp_path, {}) == []


KINDS = "names the kinds left, ran; what it says of each is for the table in core/events/event_kind.h"


@pytest.mark.parametrize(("file", "text", "said"), [
    ("core/glance/objects.cpp", "case EventKind::left:\ncase EventKind::ran:\n", f"core/glance/objects.cpp {KINDS}"),
    ("core/web/page/events.js", "if (kind === 'left' || kind === 'ran') mark();\n", f"core/web/page/events.js {KINDS}"),
    ("core/web/page/events.js", "const rank = {left: 0, ran: 1, walked: 2};\n", f"core/web/page/events.js {KINDS}"),
    ("core/web/index/index.css", ".badge.left { color: red; }\n.badge.ran { color: blue; }\n", f"core/web/index/index.css {KINDS}"),
    ("core/web/index/index.html", '<option value="left">\n<option value="ran">\n', f"core/web/index/index.html {KINDS}"),
    ("docs/report.schema.json", '"kind": {"enum": ["left"]}', "docs/report.schema.json lists other kinds of events than core/events/event_kind.h: left, ran"),
    ("tests/cli/test_output.py", 'for ending in ("png", "exr"):\n',
     "tests/cli/test_output.py:1 lists the picture formats; the table is in core/image/picture_file.cpp"),
    ("docs/reliability.md", "", "docs/reliability.md: there is no | `not-a-file` | 2 | no file | of core/base/error.cpp"),
    ("docs/reliability.md", TREE["docs/reliability.md"] * 2,
     "docs/reliability.md lists other codes of errors than core/base/error.cpp, or in another order"),
    ("docs/developing.md", TREE["docs/developing.md"].replace("| 2 |", "| 3 |"),
     "docs/developing.md: to add an event kind, 2 files in the heading, 3 in the table"),
    ("docs/developing.md", TREE["docs/developing.md"].replace("- `core/events/<name>.cpp`\n", ""),
     "docs/developing.md: to add an event kind, 2 files in the heading, 1 in the list"),
    ("docs/developing.md", TREE["docs/developing.md"].replace("events/<name>", "kinds/<name>"),
     "docs/developing.md: to add an event kind, there is no core/kinds/<name>.cpp"),
])
def test_what_repeats_a_table(tmp_path, file, text, said):
    assert tree(tmp_path, {file: text}) == [said]
