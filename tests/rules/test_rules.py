"""The sources obey the rules of includes.py, meanings.py and tables.py, and what breaks one is found."""

import os
import pathlib
import re
import subprocess
import sys

import includes
import meanings
import pytest
import tables

SOURCE = pathlib.Path(__file__).parents[2]
sys.path.insert(0, str(SOURCE / "tests" / "mutation"))
from breaks import BREAKS  # noqa: E402

HOUSE = {
    "docs/design.md": "| `core/base/` | texts |\n| `core/media/` | frames |\n| `core/fields/` | fields |\n",
    "core/CMakeLists.txt": "foreach(module base media fields)\nendforeach()\n",
    "core/base/CMakeLists.txt": "add_library(vvr_base STATIC version.cpp)\n",
    "core/base/version.cpp": "#include <string>\n",
    "core/media/CMakeLists.txt": "vvr_module(media frame.cpp MODULES base LIBRARIES fmt::fmt)\n",
    "core/media/frame.cpp": '#include "core/base/version.h"\n',
    "core/media/later.h": "#include <string>\n",
    "core/media/later.cpp": '#include "core/media/late.h"\n',
    "core/fields/CMakeLists.txt": "file(GLOB sources CONFIGURE_DEPENDS *.cpp)\nvvr_module(fields ${sources} MODULES media)\n",
    "core/fields/flow.cpp": '#include "core/media/frame.h"\n#include "core/base/version.h"\n',
    "gl/CMakeLists.txt": "add_library(vvr_gl STATIC)\ntarget_link_libraries(vvr_gl PUBLIC vvr_base)\ntarget_sources(vvr_gl PRIVATE context.cpp)\n",
    "gl/context.cpp": '#include "shaders.h"\n',
    "cli/CMakeLists.txt": """add_library(vvr_plan STATIC plan/job.cpp)
target_link_libraries(vvr_plan PUBLIC vvr_gl vvr_fields)
add_library(vvr_draw STATIC draw/draw.cpp)
target_link_libraries(vvr_draw PUBLIC vvr_plan)
add_library(vvr_app STATIC app/render.cpp)
target_link_libraries(vvr_app PUBLIC vvr_draw)
add_library(vvr_cli STATIC log.cpp commands/render.cpp)
target_link_libraries(vvr_cli PUBLIC vvr_app CLI11::CLI11)
add_executable(vvr main.cpp)
target_link_libraries(vvr PRIVATE vvr_cli)
""",
    "cli/plan/settings.cpp": '#include "core/fields/flow.h"\n#include "gl/context.h"\n',
    "cli/commands/render.cpp": '#include <CLI/CLI.hpp>\n#include "cli/log.h"\n#include "cli/plan/settings.h"\n',
    "cli/draw/draw.cpp": '#include "cli/plan/plan.h"\n#include "gl/context.h"\n',
    "cli/app/render.cpp": '#include "cli/draw/draw.h"\n',
    "cli/main.cpp": '#include "cli/commands/render.h"\n',
    "cli/log.cpp": "#include <spdlog/spdlog.h>\n",
    "cli/library/CMakeLists.txt": "add_library(vvr_library SHARED clip.cpp)\ntarget_link_libraries(vvr_library PRIVATE vvr_cli)\n",
    "cli/library/clip.cpp": '#include <vvr/clip.h>\n#include "cli/log.h"\n',
    "cli/library/vvr/clip.h": "#include <string>\n#include <vvr/image.h>\n",
    "cli/library/vvr/image.h": "#include <vector>\n",
}

NAMES = {
    "core/base/plane.h": "namespace vvr {\nstruct Size {\n};\n}  // namespace vvr\n",
    "core/media/clock.h": "namespace vvr::media {\nclass Clock {\n};\n}  // namespace vvr::media\n",
    "core/scene/clock.cpp": "namespace vvr::scene {\nclass Clock {\n};\nnamespace {\nstruct Size {\n};\n}  // namespace\n}  // namespace vvr::scene\n",
    "gl/size.cpp": "namespace vvr::gl {\nnamespace {\nstruct Size {\n};\n}  // namespace\nstruct Owner::Size {\n};\n}  // namespace vvr::gl\n",
    "core/fields/flows/settings.h": "namespace re2 {\nclass RE2;\n}\nnamespace vvr::setting {\n}  // namespace vvr::setting\n",
    "core/fields/flows/dis.h": "namespace vvr::fields {\nnamespace detail {\n}  // namespace detail\n}  // namespace vvr::fields\n",
    "cli/log.h": "namespace vvr::cli {\n}  // namespace vvr::cli\n",
    "gl/context.h": "namespace vvr::gl {\nclass Size;\nclass Context final : public Owner {\n};\n}  // namespace vvr::gl\n",
}

ROWS = {
    "core/tracking/event_kind.h": 'EventKindRow{.kind = EventKind::left,\n.name = "left"},\nEventKindRow{.kind = EventKind::ran,\n.name = "ran"},\n',
    "core/tracking/conclude.cpp": "kind = fast ? EventKind::ran : EventKind::left;\n",
    "core/tracking/event.h": "EventKind kind = EventKind::left;\n",
    "core/image/picture_file.cpp": 'Format{".png", 8},\nFormat{".exr", 16},\n',
    "core/web/page/page.css": "#strip { left: 2px; }\n.left { color: red; }\n",
    "core/web/page/strip.js": "bar.style.left = share + '%';\nif (ran) stop();\n",
    "core/base/error.cpp": 'ErrorRow{ErrorCode::not_a_file, "not-a-file", ErrorKind::io,\n"no file"},\n',
    "cli/exit_status.h": "enum class ExitStatus { io = 2 };\n",
    "docs/reliability.md": "| `not-a-file` | 2 | no file |\n",
    "docs/report.schema.json": '"kind": {"enum": ["left", "ran"], "description": "x"}',
    "docs/developing.md": "| to add | files |\n|---|---|\n| an event kind | 2 |\n\n### Add an event kind (2 files)\n\n"
                          "- `core/tracking/event_kind.h`: the row.\n- `core/tracking/<name>.cpp`\n\n## Style\n",
}

OF_RULES = pytest.mark.parametrize("rules, sources", [(includes, HOUSE), (meanings, NAMES), (tables, ROWS)],
                                   ids=["includes", "meanings", "tables"])


def said(rules, folder, sources):
    """What the rules say of a folder with these files."""
    for name, text in sources.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return rules.complaints(folder)


@OF_RULES
def test_the_sources_obey(rules, sources):
    found = rules.complaints(SOURCE)
    assert not found, "\n" + "\n".join(found)


SCRIPTS = [script for script in sorted((SOURCE / "scripts").iterdir())
           if script.is_file() and os.access(script, os.X_OK) and "/lib.sh" in script.read_text(encoding="utf-8")]


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: script.name)
def test_a_script_explains_itself_and_does_nothing_else(script):
    ran = subprocess.run([script, "--help"], capture_output=True, text=True, check=True, env={"PATH": "/usr/bin:/bin"}, timeout=10)
    comment = script.read_text(encoding="utf-8").split("\n", 2)[1].removeprefix("# ")
    assert ran.stdout.splitlines()[0] == comment
    assert ran.stderr == ""


@OF_RULES
def test_sources_in_order_pass(tmp_path, rules, sources):
    assert said(rules, tmp_path, sources) == []


@pytest.mark.parametrize("name, text, complaint", [
    ("core/media/late.cpp", '#include "core/fields/flow.h"\n', "core/media/late.cpp:1: includes core/fields/flow.h of vvr_fields, which vvr_media"),
    ("core/fields/late.cpp", '#include "gl/context.h"\n', "includes gl/context.h of vvr_gl, which vvr_fields doesn't link"),
    ("gl/late.cpp", '#include "core/fields/flow.h"\n', "of vvr_fields, which vvr_gl doesn't link"),
    ("gl/late.cpp", '\n#include "cli/log.h"\n', "gl/late.cpp:2: includes cli/log.h of vvr_cli"),
    ("cli/app/late.h", "#include <CLI/CLI.hpp>\n", "cli/app/late.h:1: includes CLI/CLI.hpp, which only the rest of cli"),
    ("cli/app/late.h", "#include <spdlog/logger.h>\n", "includes spdlog/logger.h, which only"),
    ("cli/app/late.h", '#include "cli/commands/render.h"\n', "of vvr_cli, which vvr_app doesn't link"),
    ("cli/draw/late.h", '#include "cli/plan/settings.h"\n', "cli/draw/late.h:1: includes cli/plan/settings.h: cli/draw sees cli/plan/plan.h, not the job"),
    ("cli/late.h", '#include "cli/commands/render.h"\n', "cycle cli -> cli/commands -> cli: cli/late.h:1, cli/commands/render.cpp:2"),
    ("core/media/late.h", '#include "core/media/later.h"\n', "cycle core/media/late -> core/media/later -> core/media/late: "
     "core/media/late.h:1, core/media/later.cpp:1"),
    ("cli/library/vvr/late.h", '#include "core/base/version.h"\n', "vvr/late.h:1: includes core/base/version.h, which other programs don't have"),
    ("cli/library/vvr/late.h", "#include <fmt/format.h>\n", "includes fmt/format.h, which other programs don't have"),
    ("cli/library/vvr/late.h", "#include <vvr/none.h>\n", "includes vvr/none.h, which is not in cli/library/vvr"),
    ("cli/log.cpp", "#include <vvr/clip.h>\n", "cli/log.cpp:1: includes vvr/clip.h, which is for other programs"),
    ("cli/library/late.cpp", "#include <spdlog/logger.h>\n", "includes spdlog/logger.h, which only"),
    ("gl/CMakeLists.txt", "add_library(vvr_gl STATIC context.cpp)\ntarget_link_libraries(vvr_gl PUBLIC vvr_library)\n",
     "vvr_gl in gl links vvr_library in cli/library, which comes after it"),
    ("cli/late.h", '#include "page/late.h"\n', "no library has sources in page"),
    ("core/media/CMakeLists.txt", "vvr_module(media frame.cpp MODULES base gl)\n", "vvr_media in core/media links vvr_gl in gl, which comes after it"),
    ("docs/design.md", "| `core/fields/` | |\n| `core/media/` | |\n", "docs/design.md lists ['core/fields', 'core/media']"),
])
def test_a_wrong_include_is_found(tmp_path, name, text, complaint):
    found = said(includes, tmp_path, HOUSE | {name: text})
    assert any(complaint in each for each in found), found


@pytest.mark.parametrize("name, text, complaint", [
    ("core/media/time.h", "namespace vvr::media {\nstruct Clock {\n};\n}  // namespace vvr::media\n",
     "vvr::media::Clock is 2 types: core/media/clock.h:2, core/media/time.h:2"),
    ("gl/state.cpp", "namespace vvr::gl {\n\nenum class Context {\n};\n}  // namespace vvr::gl\n",
     "vvr::gl::Context is 2 types: gl/context.h:3, gl/state.cpp:3"),
    ("core/base/size.cpp", "namespace vvr {\nnamespace {\n}  // namespace\n\nclass Size final : public Base {\n};\n}  // namespace vvr\n",
     "vvr::Size is 2 types: core/base/plane.h:2, core/base/size.cpp:5"),
    ("core/media/frame.cpp", "namespace vvr {\n}  // namespace vvr\n", "core/media/frame.cpp:1: vvr is not the namespace of this module, vvr::media"),
    ("cli/plan/plan.h", "namespace vvr::cli {\n}  // namespace vvr::cli\n", "cli/plan/plan.h:1: vvr::cli is not the namespace of this module, vvr::app"),
    ("core/fields/filters/knn.cpp", "namespace vvr::filters {\n}  // namespace vvr::filters\n",
     "core/fields/filters/knn.cpp:1: vvr::filters is not the namespace of this module, vvr::fields"),
])
def test_a_second_meaning_is_found(tmp_path, name, text, complaint):
    assert said(meanings, tmp_path, NAMES | {name: text}) == [complaint]


KINDS = "names the kinds left, ran; what it says of each is for the table in core/tracking/event_kind.h"


@pytest.mark.parametrize("name, text, complaint", [
    ("core/annotation/objects.cpp", "case EventKind::left:\ncase EventKind::ran:\n", f"core/annotation/objects.cpp {KINDS}"),
    ("core/web/page/events.js", "if (kind === 'left' || kind === 'ran') mark();\n", f"core/web/page/events.js {KINDS}"),
    ("core/web/page/events.js", "const rank = {left: 0, ran: 1, walked: 2};\n", f"core/web/page/events.js {KINDS}"),
    ("core/web/index/index.css", ".badge.left { color: red; }\n.badge.ran { color: blue; }\n", f"core/web/index/index.css {KINDS}"),
    ("core/web/index/index.html", '<option value="left">\n<option value="ran">\n', f"core/web/index/index.html {KINDS}"),
    ("docs/report.schema.json", '"kind": {"enum": ["left"]}', "docs/report.schema.json lists other kinds of events than core/tracking/event_kind.h: left, ran"),
    ("tests/cli/test_output.py", 'for ending in ("png", "exr"):\n',
     "tests/cli/test_output.py:1 lists the picture formats; the table is in core/image/picture_file.cpp"),
    ("docs/reliability.md", "", "docs/reliability.md: there is no | `not-a-file` | 2 | no file | of core/base/error.cpp"),
    ("docs/reliability.md", ROWS["docs/reliability.md"] * 2,
     "docs/reliability.md lists other codes of errors than core/base/error.cpp, or in another order"),
    ("docs/developing.md", ROWS["docs/developing.md"].replace("| 2 |", "| 3 |"),
     "docs/developing.md: to add an event kind, 2 files in the heading, 3 in the table"),
    ("docs/developing.md", ROWS["docs/developing.md"].replace("- `core/tracking/<name>.cpp`\n", ""),
     "docs/developing.md: to add an event kind, 2 files in the heading, 1 in the list"),
    ("docs/developing.md", ROWS["docs/developing.md"].replace("tracking/<name>", "kinds/<name>"),
     "docs/developing.md: to add an event kind, there is no core/kinds/<name>.cpp"),
])
def test_what_repeats_a_table_is_found(tmp_path, name, text, complaint):
    assert said(tables, tmp_path, ROWS | {name: text}) == [complaint]


def test_each_deliberate_bug_has_its_place():
    stale = [bug for bug in BREAKS if (SOURCE / bug.file).read_text(encoding="utf-8").count(bug.old) != 1]
    assert len(BREAKS) >= 40 and stale == []


def test_the_default_set_has_the_test_of_each_deliberate_bug():
    left_out = []
    for name in {bug.test for bug in BREAKS if "::" in bug.test}:
        file, function = name.split("[")[0].split("::")
        marks = re.search(rf"((?:^@.*\n(?:^[ )].*\n)*)*)^def {function}\(", (SOURCE / "tests" / file).read_text(encoding="utf-8"), re.MULTILINE)
        if re.search(r"^@pytest\.mark\.(nightly|slow|browser)\b", marks[1], re.MULTILINE):
            left_out.append(name)
    assert left_out == []
