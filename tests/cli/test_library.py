"""libvvr, as a program of someone else's finds, links and calls it."""

import fcntl
import filecmp
import os
import pathlib
import re
import shutil
import subprocess

import pytest
from harness import check

BUILD = pathlib.Path(os.environ["VVR"]).parents[1]
SHOWN = {"vvr_free", "vvr_read_clip_info", "vvr_render_clip", "vvr_render_frames", "vvr_version", "vvr_write_image"}


@pytest.fixture(name="prefix")
def installed(t, made):
    """An installed library, moved to another place than it was installed to. All tests share it."""
    if "VVR_SANITIZE:BOOL=ON" in (BUILD / "CMakeCache.txt").read_text(encoding="utf-8"):
        pytest.skip("a program without sanitizers can't load a library with them")
    prefix = made / "library"
    with open(made / "library.lock", "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not prefix.exists():
            t.run(["cmake", "--install", BUILD, "--prefix", t.path("made"), "--component", "development"]).expect(0, out=None)
            shutil.copytree(t.path("made"), prefix, symlinks=True)
            shutil.rmtree(t.path("made"))
    return prefix


@pytest.fixture(name="examples")
def built(t, made, prefix):
    """The folder of the examples, built by cmake. All tests share it."""
    examples = made / "examples"
    with open(made / "examples.lock", "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (examples / "whole").exists():
            t.run(["cmake", "-G", "Ninja", "-S", t.source / "docs/examples/library", "-B", examples,
                   f"-DCMAKE_PREFIX_PATH={prefix}"]).expect(0, out=None)
            t.run(["cmake", "--build", examples]).expect(0, out=None)
            (examples / "whole").touch()
    return examples


def test_the_library_shows_its_headers_and_nothing_else(t, prefix):
    headers = sorted(file.name for file in (prefix / "include/vvr").iterdir())
    check(headers == ["vvr.h", "vvr_c.h"], f"{headers}")
    for language, header in [("c++", "vvr.h"), ("c++", "vvr_c.h"), ("c", "vvr_c.h")]:  # each can be included alone
        standard = "c++17" if language == "c++" else "c99"
        t.run(["cc", f"-std={standard}", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only", "-I",
               prefix / "include", "-x", language, "-include", f"vvr/{header}", "/dev/null"]).expect(0, out=None)
    symbols = t.run(["nm", "-DC", "--defined-only", prefix / "lib/libvvr.so"]).out
    names = {re.split(r"[\[(@]", line.split(maxsplit=2)[2])[0] for line in symbols.splitlines()} - {"VVR_0"}
    check(names == SHOWN, f"{names ^ SHOWN}")


def compile_against(t, prefix, code):
    """A program with this code, which is linked to the library."""
    t.write("main.cpp", code)
    t.run(["c++", "-std=c++17", "main.cpp", "-o", "main", f"-I{prefix}/include", f"-L{prefix}/lib", "-lvvr",
           f"-Wl,-rpath,{prefix}/lib"]).expect(0, out=None)
    return t.path("main")


def build_by_pkg_config(t, prefix):
    if not shutil.which("pkg-config"):
        pytest.skip("needs pkg-config")
    flags = subprocess.run(["pkg-config", "--cflags", "--libs", "vvr"], check=True, capture_output=True, text=True,
                           env=os.environ | {"PKG_CONFIG_PATH": str(prefix / "lib/pkgconfig")}).stdout.split()
    t.run(["c++", "-std=c++17", t.source / "docs/examples/library/render_a_clip.cpp", "-o", "by_pkg_config", *flags,
           f"-Wl,-rpath,{prefix}/lib"]).expect(0, out=None)
    return t.path("by_pkg_config")


def test_the_examples_draw_what_the_program_draws(t, prefix, examples):
    """Built by cmake, by what pkg-config says, and in C."""
    t.clip()
    t.render("clip.avi", output="program.png").expect(0, out=None)
    for example in (examples / "render_a_clip", build_by_pkg_config(t, prefix), examples / "render_in_c"):
        done = t.run([example, "clip.avi", "library.png", "160x100"])
        check(done.status == 0 and "20 frames in library.png" in done.out, str(done))
        check(filecmp.cmp(t.path("library.png"), t.path("program.png"), shallow=False), f"{example}: other bytes than the program's")


def test_errors_are_failures_with_a_kind(t, examples):
    example = examples / "render_a_clip"
    t.write("noise.avi", os.urandom(5000))
    t.clip()
    for arguments, status, text in [
            (["none.avi", "out.png"], 3, "[file-not-found]"),
            (["noise.avi", "out.png"], 4, "noise.avi"),
            (["clip.avi", "out.png", "160"], 2, "size"),
            (["clip.avi", "out.bmp2", "160x100"], 2, "out.bmp2"),
            (["clip.avi", "no/out.png", "160x100"], 3, "[file-not-found]")]:
        done = t.run([example, *arguments])
        check(done.status == status and text in done.err, str(done))
        check("terminate" not in done.err and not t.path("out.png").exists(), str(done))
    # Config files count for nothing.
    t.run([example, "clip.avi", "out.png", "160x100"], env=os.environ | {"VVR_CONFIG": "/none"}).expect(0, out=None)


def test_settings_have_the_programs_names_and_checks(t, prefix):
    t.clip()
    main = compile_against(t, prefix, """
        #include <cstdio>
        #include <vvr/vvr.h>
        int main(int, char** words) {
            try {
                vvr::Rendering done = vvr::render_image("clip.avi", {{"size", "160x100"}, {words[1], words[2]}});
                std::printf("%dx%d %zu", done.image.width, done.image.height, done.image.rgba.size());
                done.image.rgba.pop_back();
                vvr::write_image("short.png", done.image);
            } catch (const vvr::Failure& failure) {
                std::printf(" %d %s: %s", static_cast<int>(failure.kind()), failure.code(), failure.what());
            }
        }""")
    for name, value, text in [
            ("size", "200x100", "200x100 80000 0 usage: 'short.png': an image of 200x100 pixels needs 4 values per pixel, but has 79999 in total"),
            ("sise", "1x1", " 0 option-unknown: there is no setting 'sise' (did you mean 'size'?)"),
            ("slices", "-1", " 0 option-value-out-of-range: slices: '-1' is not a whole number from 0 to 16384"),
            ("help", "yes", " 0 option-unknown"), ("config", "/nowhere", " 0 option-unknown"),
            ("config=/nowhere", "x", " 0 option-unknown"), ("input-problem", "x", " 0 option-unknown"), ("output", "x.png", " 0 option-unknown")]:
        done = t.run([main, name, value])
        check(done.status == 0 and done.out.startswith(text), str(done))
    check(not t.path("short.png").exists(), "a picture of an image that is none")


def test_frames_in_memory_give_the_picture_of_the_same_file(t, prefix):
    t.scene("walkers", "walkers.y4m", "--size", "160x120", "--frames", "100")
    t.ffmpeg("-i", "walkers.y4m", "-pix_fmt", "bgr24", "-f", "rawvideo", "frames.raw")
    t.ffmpeg("-i", "walkers.y4m", "-pix_fmt", "bgr24", "-c:v", "rawvideo", "frames.avi")
    main = compile_against(t, prefix, """
        #include <algorithm>
        #include <cstdio>
        #include <fstream>
        #include <iterator>
        #include <vvr/vvr.h>
        int main() {
            const std::ptrdiff_t stride = 3 * 160, size = 120 * stride, last = size - stride;
            std::ifstream file("frames.raw", std::ios::binary);
            std::vector<char> pixels{std::istreambuf_iterator<char>(file), {}};
            vvr::FrameSequence frames;
            frames.width = 160;
            frames.height = 120;
            frames.frames_per_second = 25;
            frames.frames = 100;
            frames.read = [&](std::int64_t index, vvr::FrameView& frame) {
                if (index == 100) return false;
                frame = {reinterpret_cast<std::uint8_t*>(&pixels[index * size]), stride, 7 + index / 25.0};
                return true;
            };
            vvr::RenderOptions options;
            options.events = options.pixel_data = true;
            const vvr::Settings settings{{"size", "160x100"}, {"title", "walkers"}};
            const vvr::Rendering done = vvr::render_image(frames, settings, options);
            vvr::write_image("memory.png", done.image);
            std::size_t marked = 0;
            for (const float object : done.pixel_data.object) marked += object > 0;
            std::printf("%zu events, %zu pixels, %d", done.events.size(), done.pixel_data.frame.size(), marked > 0);
            std::size_t points = 0;
            for (const vvr::Event& event : done.events) points += event.path.size();
            std::printf(", %d", points > done.events.size());

            for (int index = 0; index < 100; ++index) {  // the bottom row first
                for (int y = 0; y < 60; ++y) {
                    char* const frame = &pixels[index * size];
                    std::swap_ranges(frame + y * stride, frame + (y + 1) * stride, frame + (119 - y) * stride);
                }
            }
            frames.read = [&](std::int64_t index, vvr::FrameView& frame) {
                if (index == 100) return false;
                frame = {reinterpret_cast<std::uint8_t*>(&pixels[index * size + last]), -stride, index / 25.0};
                return true;
            };
            std::printf(", %d", vvr::render_image(frames, settings).image.rgba == done.image.rgba);
        }""")
    done = t.run([main])
    t.vvr("render", "frames.avi", "--events-csv", "events.csv").expect(0, out=None)
    events = len(t.path("events.csv").read_text(encoding="utf-8").splitlines()) - 1
    check(events > 0 and done.out == f"{events} events, 16000 pixels, 1, 1, 1", str(done))
    t.render("frames.avi", "--title", "walkers", output="file.png").expect(0, out=None)
    t.vvr("compare", "memory.png", "file.png", "--tolerance", "0").expect(0, out=None)


@pytest.mark.nightly
def test_what_callers_do_wrong_or_throw(t, prefix):
    main = compile_against(t, prefix, """
        #include <cstdio>
        #include <string>
        #include <vvr/vvr.h>
        int main(int, char** words) {
            const std::string fault = words[1];
            std::vector<std::uint8_t> pixels(3 * 64 * 48);
            vvr::FrameSequence frames;
            frames.width = fault == "size" ? 0 : 64;
            frames.height = 48;
            if (fault == "format") frames.format = static_cast<vvr::PixelFormat>(9);
            if (fault != "reader") frames.read = [&](std::int64_t index, vvr::FrameView& frame) {
                if (fault == "exception" && index == 5) throw 42;
                frame.pixels = fault == "pixels" && index == 3 ? nullptr : pixels.data();
                frame.stride = fault == "stride" ? 100 : fault == "overflow" ? PTRDIFF_MAX / 2 : 192;
                frame.seconds = fault == "time" ? 1 : index / 10.0;
                return index < (fault == "empty" ? 0 : 30);
            };
            vvr::RenderOptions options;
            if (fault == "progress") options.progress = [](const vvr::Progress&) -> bool { throw 42; };
            if (fault == "cancel") options.progress = [](const vvr::Progress& now) { return now.stage != vvr::Progress::Stage::drawing || now.done == 0; };
            try {
                vvr::render_image(frames, {{"size", "160x100"}}, options);
                std::printf("done");
            } catch (const vvr::Failure& failure) {
                std::printf("%s: %s", failure.code(), failure.what());
            } catch (int number) {
                std::printf("int %d", number);
            }
        }""")
    for fault, text in [("none", "done"), ("exception", "int 42"), ("progress", "int 42"), ("cancel", "cancelled: "),
                        ("size", "input-unsuitable: frames in memory: 0x48"), ("reader", "input-unsuitable: "),
                        ("format", "input-unsuitable: there is no pixel format 9"),
                        ("pixels", "input-unsuitable: frames in memory, frame 3: no pixels"),
                        ("stride", "input-unsuitable: frames in memory, frame 0: pixels and a stride of 100 bytes"),
                        ("overflow", "input-unsuitable: frames in memory, frame 0: pixels and a stride of 4611686018427387903 bytes"),
                        ("time", "input-unsuitable: frames in memory, frame 1: it is at 1 s"), ("empty", "no-frame: ")]:
        done = t.run([main, fault])
        check(done.status == 0 and done.out.startswith(text), f"{fault}: {done}")


def test_threads_draw_at_the_same_time_what_they_draw_alone(t, prefix):
    t.clip("a.avi")
    t.clip("b.avi", seconds=3)
    main = compile_against(t, prefix, """
        #include <cstdio>
        #include <thread>
        #include <vvr/vvr.h>
        std::vector<float> draw(const char* clip, const char* filter) {
            return vvr::render_image(clip, {{"size", "160x100"}, {"filter", filter}, {"flow", "dis"}}).image.rgba;
        }
        int main() {
            const auto a = draw("a.avi", "difference");
            const auto b = draw("b.avi", "flow");
            int same = 0;
            std::thread other([&] { for (int i = 0; i < 4; ++i) same += draw("b.avi", "flow") == b; });
            int here = 0;
            for (int i = 0; i < 4; ++i) here += draw("a.avi", "difference") == a;
            other.join();
            std::printf("%d %d", here, same);
        }""")
    t.run([main]).expect(0, out="4 4")


def test_c_gets_events_and_an_error_for_a_missing_array(t, prefix):
    t.scene("walkers", "walkers.y4m", "--size", "160x120", "--frames", "100")
    t.write("main.c", """
        #include <stdio.h>
        #include <vvr/vvr_c.h>
        int main(int count, char** words) {
            const struct vvr_setting small = {"size", "160x100"};
            struct vvr_options options = {count > 2 ? NULL : &small, 1, 1, 0, NULL, NULL};
            struct vvr_rendering* const done = vvr_render_clip(words[1], &options);
            printf("%d %s\\n", done->status, done->text);
            const struct vvr_event* const event = done->events;
            if (done->event_count > 0) printf("%.3f %.3f %d\\n", event->first_seconds, event->last_seconds, event->open_ended);
            vvr_free(done);
            return 0;
        }""")
    t.run(["cc", "main.c", "-o", "main", f"-I{prefix}/include", f"-L{prefix}/lib", "-lvvr", f"-Wl,-rpath,{prefix}/lib"]).expect(0, out=None)
    t.run([t.path("main"), "walkers.y4m", "none"]).expect(0, out="1 no array of settings given: the pointer is NULL\n")
    t.vvr("render", "walkers.y4m", "--events-csv", "events.csv").expect(0, out=None)
    heading, row, *_ = [line.split(",") for line in t.path("events.csv").read_text().splitlines()]
    of = dict(zip(heading, row))
    t.run([t.path("main"), "walkers.y4m"]).expect(0, out=f"0 \n{of['first']} {of['last']} {int(of['open_ended'] == 'true')}\n")


@pytest.mark.nightly
def test_examples_draw_frames_in_memory(t, prefix, examples):
    frames = examples / "render_frames"
    done = t.run([frames, "frames.png"])
    check(done.status == 0 and "1: moved right, 0 s to 5.96 s\n" in done.out and t.path("frames.png").exists(), str(done))
    t.run([frames, "cancelled.png", "0"]).expect(8, "[cancelled]", out=None)
    python = ["python3", t.source / "docs/examples/library/render_frames.py", prefix / "lib/libvvr.so"]
    t.run([*python, "python.png"]).expect(0, out="75 frames in python.png\n")
    t.run([*python, "none/python.png"]).expect(2, "none", out=None)
    check(t.path("python.png").exists() and not t.path("cancelled.png").exists(), f"{t.files()}")
