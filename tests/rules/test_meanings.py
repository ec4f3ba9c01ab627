"""Each type of the sources has a name of its own, and a second one of that name is found."""

import pathlib

import pytest
from meanings import complaints

TREE = {
    "core/base/plane.h": "namespace vvr {\nstruct Size {\n};\n}  // namespace vvr\n",
    "core/video/clock.h": "namespace vvr::video {\nclass Clock {\n};\n}  // namespace vvr::video\n",
    "core/scene/clock.cpp": "namespace vvr::scene {\nclass Clock {\n};\nnamespace {\nstruct Size {\n};\n}  // namespace\n}  // namespace vvr::scene\n",
    "gl/size.cpp": "namespace vvr::gl {\nnamespace {\nstruct Size {\n};\n}  // namespace\nstruct Owner::Size {\n};\n}  // namespace vvr::gl\n",
    "core/fields/flows/settings.h": "namespace re2 {\nclass RE2;\n}\nnamespace vvr::setting {\n}  // namespace vvr::setting\n",
    "core/fields/flows/dis.h": "namespace vvr::fields {\nnamespace detail {\n}  // namespace detail\n}  // namespace vvr::fields\n",
    "cli/log.h": "namespace vvr::cli {\n}  // namespace vvr::cli\n",
    "gl/context.h": "namespace vvr::gl {\nclass Size;\nclass Context final : public Owner {\n};\n}  // namespace vvr::gl\n",
}


def tree(folder, changed):
    for name, text in {**TREE, **changed}.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return complaints(folder)


def test_the_sources():
    assert complaints(pathlib.Path(__file__).parents[2]) == []


def test_a_tree_in_which_each_name_has_one_meaning(tmp_path):
    assert tree(tmp_path, {}) == []


@pytest.mark.parametrize(("file", "text", "said"), [
    ("core/video/time.h", "namespace vvr::video {\nstruct Clock {\n};\n}  // namespace vvr::video\n",
     "vvr::video::Clock is 2 types: core/video/clock.h:2, core/video/time.h:2"),
    ("gl/state.cpp", "namespace vvr::gl {\n\nenum class Context {\n};\n}  // namespace vvr::gl\n",
     "vvr::gl::Context is 2 types: gl/context.h:3, gl/state.cpp:3"),
    ("core/base/size.cpp", "namespace vvr {\nnamespace {\n}  // namespace\n\nclass Size final : public Base {\n};\n}  // namespace vvr\n",
     "vvr::Size is 2 types: core/base/plane.h:2, core/base/size.cpp:5"),
    ("core/video/frame.cpp", "namespace vvr {\n}  // namespace vvr\n", "core/video/frame.cpp:1: vvr is not the namespace of this module, vvr::video"),
    ("cli/app/plan.h", "namespace vvr::cli {\n}  // namespace vvr::cli\n", "cli/app/plan.h:1: vvr::cli is not the namespace of this module, vvr::app"),
    ("core/fields/filters/knn.cpp", "namespace vvr::filters {\n}  // namespace vvr::filters\n",
     "core/fields/filters/knn.cpp:1: vvr::filters is not the namespace of this module, vvr::fields"),
])
def test_a_second_meaning(tmp_path, file, text, said):
    assert tree(tmp_path, {file: text}) == [said]
