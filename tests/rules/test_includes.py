"""The sources obey the rules of includes.py, and a file that breaks one is found."""

import pathlib

import pytest
from includes import complaints

HOUSE = {
    "docs/design.md": "| `core/base/` | texts |\n| `core/video/` | frames |\n| `core/fields/` | fields |\n",
    "core/CMakeLists.txt": "foreach(module base video fields)\nendforeach()\n",
    "core/base/CMakeLists.txt": "add_library(vvr_base STATIC version.cpp)\n",
    "core/base/version.cpp": "#include <string>\n",
    "core/video/CMakeLists.txt": "vvr_module(video frame.cpp MODULES base LIBRARIES fmt::fmt)\n",
    "core/video/frame.cpp": '#include "core/base/version.h"\n',
    "core/video/later.h": "#include <string>\n",
    "core/video/later.cpp": '#include "core/video/late.h"\n',
    "core/fields/CMakeLists.txt": "file(GLOB sources CONFIGURE_DEPENDS *.cpp)\nvvr_module(fields ${sources} MODULES video)\n",
    "core/fields/flow.cpp": '#include "core/video/frame.h"\n#include "core/base/version.h"\n',
    "gl/CMakeLists.txt": "add_library(vvr_gl STATIC)\ntarget_link_libraries(vvr_gl PUBLIC vvr_base)\ntarget_sources(vvr_gl PRIVATE context.cpp)\n",
    "gl/context.cpp": '#include "shaders.h"\n',
    "cli/CMakeLists.txt": """add_library(vvr_app STATIC app/job.cpp)
target_link_libraries(vvr_app PUBLIC vvr_gl vvr_fields)
add_library(vvr_cli STATIC log.cpp commands/render.cpp)
target_link_libraries(vvr_cli PUBLIC vvr_app CLI11::CLI11)
add_executable(vvr main.cpp)
target_link_libraries(vvr PRIVATE vvr_cli)
""",
    "cli/app/job.cpp": '#include "core/fields/flow.h"\n#include "gl/context.h"\n',
    "cli/commands/render.cpp": '#include <CLI/CLI.hpp>\n#include "cli/log.h"\n#include "cli/app/job.h"\n',
    "cli/main.cpp": '#include "cli/commands/render.h"\n',
    "cli/log.cpp": "#include <spdlog/spdlog.h>\n",
    "cli/library/CMakeLists.txt": "add_library(vvr_library SHARED clip.cpp)\ntarget_link_libraries(vvr_library PRIVATE vvr_cli)\n",
    "cli/library/clip.cpp": '#include <vvr/clip.h>\n#include "cli/log.h"\n',
    "cli/library/vvr/clip.h": "#include <string>\n#include <vvr/image.h>\n",
    "cli/library/vvr/image.h": "#include <vector>\n",
}


def house(folder, **changed):
    for name, text in (HOUSE | changed).items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return folder


def test_the_sources_obey():
    said = complaints(pathlib.Path(__file__).parents[2])
    assert not said, "\n" + "\n".join(said)


def test_a_house_in_order_passes(tmp_path):
    assert complaints(house(tmp_path)) == []


@pytest.mark.parametrize("name, text, complaint", [
    ("core/video/late.cpp", '#include "core/fields/flow.h"\n', "core/video/late.cpp:1: includes core/fields/flow.h of vvr_fields, which vvr_video"),
    ("core/fields/late.cpp", '#include "gl/context.h"\n', "includes gl/context.h of vvr_gl, which vvr_fields doesn't link"),
    ("gl/late.cpp", '#include "core/fields/flow.h"\n', "of vvr_fields, which vvr_gl doesn't link"),
    ("gl/late.cpp", '\n#include "cli/log.h"\n', "gl/late.cpp:2: includes cli/log.h of vvr_cli"),
    ("cli/app/late.h", "#include <CLI/CLI.hpp>\n", "cli/app/late.h:1: includes CLI/CLI.hpp, which only the rest of cli"),
    ("cli/app/late.h", "#include <spdlog/logger.h>\n", "includes spdlog/logger.h, which only"),
    ("cli/app/late.h", '#include "cli/commands/render.h"\n', "of vvr_cli, which vvr_app doesn't link"),
    ("cli/late.h", '#include "cli/commands/render.h"\n', "cycle cli -> cli/commands -> cli: cli/late.h:1, cli/commands/render.cpp:2"),
    ("core/video/late.h", '#include "core/video/later.h"\n', "cycle core/video/late -> core/video/later -> core/video/late: "
     "core/video/late.h:1, core/video/later.cpp:1"),
    ("cli/library/vvr/late.h", '#include "core/base/version.h"\n', "vvr/late.h:1: includes core/base/version.h, which other programs don't have"),
    ("cli/library/vvr/late.h", "#include <fmt/format.h>\n", "includes fmt/format.h, which other programs don't have"),
    ("cli/library/vvr/late.h", "#include <vvr/none.h>\n", "includes vvr/none.h, which is not in cli/library/vvr"),
    ("cli/log.cpp", "#include <vvr/clip.h>\n", "cli/log.cpp:1: includes vvr/clip.h, which is for other programs"),
    ("cli/library/late.cpp", "#include <spdlog/logger.h>\n", "includes spdlog/logger.h, which only"),
    ("gl/CMakeLists.txt", "add_library(vvr_gl STATIC context.cpp)\ntarget_link_libraries(vvr_gl PUBLIC vvr_library)\n",
     "vvr_gl in gl links vvr_library in cli/library, which comes after it"),
    ("cli/late.h", '#include "page/late.h"\n', "no library has sources in page"),
    ("core/video/CMakeLists.txt", "vvr_module(video frame.cpp MODULES base gl)\n", "vvr_video in core/video links vvr_gl in gl, which comes after it"),
    ("docs/design.md", "| `core/fields/` | |\n| `core/video/` | |\n", "docs/design.md lists ['core/fields', 'core/video']"),
])
def test_what_breaks_a_rule_is_found(tmp_path, name, text, complaint):
    said = complaints(house(tmp_path, **{name: text}))
    assert any(complaint in each for each in said), said
