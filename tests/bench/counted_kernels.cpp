// Four kernels on input that is always the same, for valgrind to count the instructions of: unlike times these don't
// depend on what else the machine does. See bench/check.py.
//
//     counted_kernels jacobi|flow|fields|events
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include <hwy/targets.h>

#include "core/fields/field_stages.h"
#include "core/fields/flow.h"
#include "core/fields/flows/derivatives.h"
#include "core/fields/flows/linear_system.h"
#include "core/tracking/event_finder.h"

/// What valgrind counts is what happens in here.
extern "C" __attribute__((noipa)) void vvr_counted(const std::function<void()>& work) {
    work();
    asm volatile("");  // else this would be left before the work begins
}

namespace {

using namespace vvr;

constexpr Size size{384, 288};

/// Noise, and a square that goes to the right.
media::Frame frame_of(int index) {
    media::Frame frame{index, index / 25.0, Plane<std::uint8_t>(size), Plane<Bgr>(size)};
    std::uint32_t state = 12345U + static_cast<std::uint32_t>(index);
    for (int j = 0; j < size.height; ++j) {
        for (int i = 0; i < size.width; ++i) {
            state = state * 1664525U + 1013904223U;
            const bool square = j >= 100 && j < 180 && i >= 60 + 2 * index && i < 110 + 2 * index;
            const int texture =
                static_cast<int>(20 * std::sin(0.4 * (i - (square ? 2 * index : 0))) + 15 * std::sin(0.3 * j));
            const auto value = static_cast<std::uint8_t>((square ? 60 : 130) + texture + static_cast<int>(state >> 30));
            frame.grey.at(i, j) = value;
            frame.colour.at(i, j) = {value, value, static_cast<std::uint8_t>(value + (square ? 40 : 0))};
        }
    }
    return frame;
}

void jacobi() {
    const std::vector<float> taps = fields::gaussian_taps(1.5);
    std::vector<Plane<float>> smooth;
    for (int f = 0; f < 15; ++f) smooth.push_back(fields::smoothed(frame_of(f).grey, taps));
    std::vector<const Plane<float>*> frames;
    for (const Plane<float>& plane : smooth) frames.push_back(&plane);
    fields::PlaneStack derivatives;
    fields::barron_derivatives(frames, taps, {0, 0, size.width, size.height}, derivatives);
    fields::LinearSystem system(size, 100);
    system.load(derivatives);
    system.clear();
    vvr_counted([&] { system.relax(60); });
}

void flow() {
    const auto method = fields::make_flow({});
    const std::vector<media::Frame> clip{frame_of(0), frame_of(1), frame_of(2)};
    vvr_counted([&] {
        std::vector<fields::FlowFrame> prepared;
        for (const media::Frame& frame : clip) prepared.push_back(method->prepare(frame.grey));
        (*method)(std::vector<const fields::FlowFrame*>{&prepared[0], &prepared[1], &prepared[2]},
                  {0, 0, size.width, size.height});
    });
}

void fields() {
    fields::FieldOptions options;
    options.flow.method = "none";
    fields::EmptyScene scene;
    const media::Frame empty = frame_of(-60);
    scene.reference = fields::Planes{empty.grey, empty.colour};
    fields::FieldStages work(scene, options);
    std::vector<media::Frame> clip;
    for (int f = 0; f < 4; ++f) clip.push_back(frame_of(f));
    vvr_counted([&] {
        for (const media::Frame& frame : clip) work.finish(work.gather(work.begin(frame)));
    });
}

void events() {
    tracking::EventFinder finder(size, {});
    std::vector<media::Frame> clip;
    std::vector<Plane<std::uint8_t>> fields;
    for (int f = 0; f < 20; ++f) {
        clip.push_back(frame_of(f));
        Plane<std::uint8_t>& field = fields.emplace_back(size);
        for (int j = 100; j < 180; ++j) {
            for (int i = 60 + 2 * f; i < 110 + 2 * f; ++i) field.at(i, j) = 120;
        }
    }
    vvr_counted([&] {
        for (std::size_t f = 0; f < clip.size(); ++f) {
            finder.add({fields[f], clip[f].grey, clip[f].colour}, {clip[f].index, clip[f].pts});
        }
    });
}

struct Kernel {
    const char* name;
    void (*run)();
};
constexpr Kernel counted[] = {{"jacobi", jacobi}, {"flow", flow}, {"fields", fields}, {"events", events}};

}  // namespace

int main(int argc, char** argv) {
    // The widest vectors that valgrind knows.
    hwy::SetSupportedTargetsForTest(HWY_AVX2);
    for (const Kernel& kernel : counted) {
        if (argc != 2 || argv[1] != std::string(kernel.name)) continue;
        kernel.run();
        return 0;
    }
    std::fputs("usage: counted_kernels jacobi|flow|fields|events\n", stderr);
    return 1;
}
