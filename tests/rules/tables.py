"""Checks that a row of a table is all there is to add.

The table of event kinds is in core/tracking/event_kind.h. Elsewhere

- no C++ file but conclude.cpp, which decides of what kind an object is, names two or more enumerators of EventKind;
- no script, stylesheet or HTML file of a page or the index names two or more kinds: as a quoted text, as the key of an object,
  or as a class in a selector;
- docs/report.schema.json lists the names of the table, in its order.

The table of picture formats is in core/image/picture_file.cpp. No other file of core, gl, cli or the tests has all its extensions
in one line.

The table of error codes is in core/base/error.cpp: docs/reliability.md has a row for each, in its order.

In docs/developing.md, each section "Add …" says in its heading how many files there are, and so does the row of the table of
checklists. It has a line of a list for each, which begins with the file's path. The file is there; of one with <name> in its
path, the folder is.
"""

import json
import re

from includes import FLOORS, sources

KINDS = "core/tracking/event_kind.h"
FORMATS = "core/image/picture_file.cpp"
SCHEMA = "docs/report.schema.json"
CODES = "core/base/error.cpp"
STATUSES = "cli/exit_status.h"
LISTED_CODES = "docs/reliability.md"
CHECKLISTS = "docs/developing.md"
DECIDES = "core/tracking/conclude.cpp"


def kinds_of(root):
    """Enumerators of the kinds, and their names, in the order of the table."""
    text = (root / KINDS).read_text(encoding="utf-8")
    return re.findall(r"\.kind = EventKind::(\w+)", text), re.findall(r'\.name = "([^"]+)"', text)


def names_in_web(text, names):
    """The kinds that a script, a stylesheet or an HTML file names."""
    for name in names:
        word = re.escape(name)
        if re.search(rf"""['"`]{word}['"`]|[{{,]\s*{word}:(?!:)[^;]*,|\.{word}(?=[\s,.:]*[^{{}};=()]*\{{)""", text):
            yield name


def lists_of_kinds(root):
    enumerators, names = kinds_of(root)
    for file, text in sources(root, FLOORS, (".h", ".cpp", ".js", ".css", ".html")):
        if file.suffix in (".h", ".cpp"):
            found = sorted(set(re.findall(r"\bEventKind::(\w+)", text)) & set(enumerators))
        else:
            found = list(names_in_web(text, names))
        if len(found) > 1 and str(file) not in (KINDS, DECIDES):
            yield f"{file} names the kinds {', '.join(found)}; what it says of each is for the table in {KINDS}"


def schema_of_kinds(root):
    listed = re.search(r'"kind": \{"enum": (\[[^\]]*\])', (root / SCHEMA).read_text(encoding="utf-8"))
    names = kinds_of(root)[1]
    if not listed or json.loads(listed[1]) != names:
        yield f"{SCHEMA} lists other kinds of events than {KINDS}: {', '.join(names)}"


def lists_of_formats(root):
    endings = re.findall(r'Format\{"\.(\w+)"', (root / FORMATS).read_text(encoding="utf-8"))
    for file, text in sources(root, (*FLOORS, "tests/unit", "tests/cli"), (".h", ".cpp", ".py")):
        if str(file) == FORMATS:
            continue
        for number, line in enumerate(text.splitlines(), 1):
            if endings and all(re.search(rf"\b{ending}\b", line) for ending in endings):
                yield f"{file}:{number} lists the picture formats; the table is in {FORMATS}"


def list_of_codes(root):
    statuses = dict(re.findall(r"(\w+) = (\d+)", (root / STATUSES).read_text(encoding="utf-8")))
    rows = re.findall(r'ErrorRow\{ErrorCode::\w+,\s*"([^"]+)",\s*ErrorKind::(\w+),\s*"([^"]+)"\}', (root / CODES).read_text(encoding="utf-8"))
    wanted = [(name, statuses[kind], meaning) for name, kind, meaning in rows]
    listed = re.findall(r"^\| `([^`]+)` \| (\d+) \| (.+) \|$", (root / LISTED_CODES).read_text(encoding="utf-8"), re.MULTILINE)
    for name, status, meaning in wanted:
        if (name, status, meaning) not in listed:
            yield f"{LISTED_CODES}: there is no | `{name}` | {status} | {meaning} | of {CODES}"
    if not rows or (len(listed) == len(wanted) and listed != wanted) or len(listed) > len(wanted):
        yield f"{LISTED_CODES} lists other codes of errors than {CODES}, or in another order"


def checklists(root):
    text = (root / CHECKLISTS).read_text(encoding="utf-8")
    counts = dict(re.findall(r"^\| (.+?) \| (\d+) \|$", text, re.MULTILINE))
    for what, count, body in re.findall(r"^### Add (.+?) \((\d+) files\)\n(.*?)(?=^##)", text, re.MULTILINE | re.DOTALL):
        paths = re.findall(r"^- `([^`]+)`", body, re.MULTILINE)
        if counts.get(what) != count:
            yield f"{CHECKLISTS}: to add {what}, {count} files in the heading, {counts.get(what, 'none')} in the table"
        if len(paths) != int(count):
            yield f"{CHECKLISTS}: to add {what}, {count} files in the heading, {len(paths)} in the list"
        for path in paths:
            there = (root / path).parent if "<name>" in path else root / path
            if not there.exists():
                yield f"{CHECKLISTS}: to add {what}, there is no {path}"


def complaints(root):
    return [*lists_of_kinds(root), *schema_of_kinds(root), *lists_of_formats(root), *list_of_codes(root), *checklists(root)]
