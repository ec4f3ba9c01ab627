"""OpenGL backends: there, not there, and alike."""

import os

import pytest
from harness import check


def test_backend_that_is_not_there(t):
    t.clip()
    t.render("clip.avi", "--backend", "egl:99").expect(4, "egl", "99", "`vvr doctor`", code="opengl-unavailable")
    t.expect_files("clip.avi")


def test_doctor_tells_programs(t):
    text = t.vvr("doctor").expect(0, out=None).out
    said = t.vvr("doctor", "--json").expect(0, out=None).json()
    check(said["vvr"] in text and set(said["libraries"]) == {"FFmpeg", "OpenImageIO", "OpenCV"}, f"{said}")
    for backend in said["backends"]:
        check(f"{backend['name']:<14} {'works' if backend['works'] else 'does not work'}: {backend['what']}" in text, text)
        check((backend["renderer"] is not None) == backend["works"] == (backend["reason"] is None), f"{backend}")
    check(f"font           {said['font']}\n" in text, f"{said}")
    check(f"time zone      {said['time_zone']}\nsandbox        {said['sandbox']}\n" in text, f"{said}")
    check(f"page video     {said['page_video']}\n" in text and said["page_video"] == "libx264", f"{said}")
    check(any(backend["works"] for backend in said["backends"]), f"{said}")
    first = next(backend for backend in said["backends"] if backend["works"])
    check(said["draws_with"] == first["name"] and f"draws with     {first['name']}: {first['renderer']}\n" in text, text)
    t.vvr("doctor", "--backend", "software").expect(0, out=None)
    t.vvr("doctor", "--backend", "egl:200").expect(4, "egl", "200", code="opengl-unavailable", out=None)


def test_doctor_tells_of_every_backend(t):
    result = t.vvr("doctor").expect(0, out=None)
    for text in ("vvr ", "FFmpeg ", "OpenImageIO ", "OpenCV ", "\negl ", "\nsoftware ", "\nosmesa ", "llvmpipe"):
        check(text in result.out, f"{result}\nexpected: {text}")
    works = [" works:" in block.splitlines()[0] for block in result.out.split("\n\n")[1:]]
    check(works == sorted(works, reverse=True), f"what works does not come first: {result}")
    for block in result.out.split("\n\n")[1:]:
        wanted = ["renderer", "version"] if " works:" in block.splitlines()[0] else ["reason", "fix with"]
        for word in wanted:
            check(word in block, f"no {word} in\n{block}")


def test_works_without_a_display(t):
    t.clip()
    bare = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY", "XDG_RUNTIME_DIR")}
    t.render("clip.avi", "--quiet", env=bare).expect(0, err="")


@pytest.mark.nightly
def test_pixel_data_without_framebuffer_fetch(t):
    """A driver that can't read the framebuffer in a shader draws each slice into a second one: the same data."""
    t.scene("left_bag", "bag.y4m", "--size", "96x72", "--frames", "60")
    for name, overrides in (("a.exr", ""), ("b.exr", "-GL_EXT_shader_framebuffer_fetch")):
        t.vvr("render", "bag.y4m", "-o", name, "--size", "320x200", "--backend", "software",
              env={"MESA_EXTENSION_OVERRIDE": overrides}).expect(0)
    check(t.path("a.exr").read_bytes() == t.path("b.exr").read_bytes(), "other pixel data")
