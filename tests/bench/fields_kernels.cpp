// How long the kernels of the fields take at 384x288, on one core.
//
//     bench_fields                          all
//     bench_fields --benchmark_filter=Jacobi     60 steps, beside the plain loop of the same arithmetic
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/fields/field_source.h"
#include "core/fields/filter.h"
#include "core/fields/flow.h"
#include "core/fields/flows/derivatives.h"
#include "core/fields/flows/linear_system.h"
#include "core/fields/seeds.h"
#include "tests/scene/scene.h"
#include "tests/unit/fields/plain_jacobi.h"

namespace {

using namespace vvr;

constexpr Size size{384, 288};
constexpr float alpha = 10;
constexpr int steps = 60;

video::Frame frame_of(const generator::Scene& scene, int index) {
    video::Frame frame{index, index / 25.0, Plane<std::uint8_t>(scene.size()), scene.frame(index)};
    std::ranges::transform(frame.colour.pixels(), frame.grey.pixels().begin(), [](const Bgr& p) {
        return static_cast<std::uint8_t>(std::lround(0.114 * p[0] + 0.587 * p[1] + 0.299 * p[2]));
    });
    return frame;
}

/// Frames of people walking, in colour.
const std::vector<video::Frame>& walkers() {
    static const std::vector<video::Frame> frames = [] {
        const generator::Scene scene = generator::make_walkers();
        std::vector<video::Frame> result;
        for (int f = 0; f < 100; ++f) result.push_back(frame_of(scene, 200 + f));
        return result;
    }();
    return frames;
}

fields::PlaneStack derivatives() {
    const std::vector<float> taps = fields::gaussian_taps(1.5);
    std::vector<Plane<float>> smooth;
    for (int f = 0; f < 15; ++f) smooth.push_back(fields::smoothed(walkers()[static_cast<std::size_t>(f)].grey, taps));
    std::vector<const Plane<float>*> frames;
    for (const Plane<float>& plane : smooth) frames.push_back(&plane);
    fields::PlaneStack result;
    fields::barron_derivatives(frames, taps, {0, 0, size}, result);
    return result;
}

double milliseconds(std::chrono::steady_clock::time_point since) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - since).count();
}

// Both in turn, so that whatever else the machine does falls on both: `ratio` is that of the medians.
void JacobiAgainstPlainLoop(benchmark::State& state) {
    const fields::PlaneStack d = derivatives();
    const Plane<float> x = d.plane(fields::along_x), y = d.plane(fields::along_y), t = d.plane(fields::along_t);
    fields::LinearSystem system(size, alpha * alpha);
    system.load(d);
    std::vector<double> fast, plain;
    for (auto _ : state) {
        auto start = std::chrono::steady_clock::now();
        system.clear();
        system.relax(steps);
        benchmark::ClobberMemory();
        fast.push_back(milliseconds(start));
        start = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(test::plain_jacobi(x, y, t, alpha, steps));
        plain.push_back(milliseconds(start));
    }
    std::ranges::sort(fast);
    std::ranges::sort(plain);
    state.counters["best_jacobi_ms"] = fast.front();
    state.counters["jacobi_ms"] = fast[fast.size() / 2];
    state.counters["plain_ms"] = plain[plain.size() / 2];
    state.counters["ratio"] = plain[plain.size() / 2] / fast[fast.size() / 2];
}
BENCHMARK(JacobiAgainstPlainLoop)->Iterations(30)->Unit(benchmark::kMillisecond);

/// The whole flow of a frame by one method, without what is done once a frame.
void flow_of_a_frame(benchmark::State& state, const std::string& name, const std::string& solver) {
    fields::FlowOptions options;
    options.method = name;
    options.solver = solver;
    const auto method = fields::make_flow(options);
    std::vector<fields::FlowFrame> prepared;
    for (int f = 0; f < 2 * method->reach() + 1; ++f) {
        prepared.push_back(method->prepare(walkers()[static_cast<std::size_t>(f)].grey));
    }
    std::vector<const fields::FlowFrame*> about;
    for (const fields::FlowFrame& frame : prepared) about.push_back(&frame);
    for (auto _ : state) benchmark::DoNotOptimize((*method)(about, {0, 0, size}));
}
BENCHMARK_CAPTURE(flow_of_a_frame, jacobi, "horn-schunck", "jacobi")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(flow_of_a_frame, pyramid, "horn-schunck", "pyramid")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(flow_of_a_frame, dis, "dis", "pyramid")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(flow_of_a_frame, farneback, "farneback", "pyramid")->Unit(benchmark::kMillisecond);

/// All fields of frames that are in memory, by two threads: difference, flow and seeds.
void fields_of_frames(benchmark::State& state, bool colour, const std::string& flow) {
    fields::EmptyScene scene;
    const video::Frame empty = frame_of(generator::make_still(), 0);
    scene.reference.grey = empty.grey;
    if (colour) scene.reference.colour = empty.colour;
    std::vector<video::Frame> frames = walkers();
    for (video::Frame& frame : frames) {
        if (!colour) frame.colour = {};
    }
    fields::FieldOptions options;
    options.flow.method = flow;
    options.threads = 2;
    std::int64_t done = 0;
    for (auto _ : state) {
        const fields::FrameReader read = [&, next = std::size_t{0}]() mutable -> fields::FrameJob {
            if (next == frames.size()) return {};
            return [&frame = frames[next++]] { return frame; };
        };
        done += fields::compute_fields(read, scene, options, [](const video::SharedFrame&, fields::Field&& field) {
            benchmark::DoNotOptimize(field.seeds);
        });
    }
    state.SetItemsProcessed(done);
}
BENCHMARK_CAPTURE(fields_of_frames, grey, false, "horn-schunck")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fields_of_frames, colour, true, "horn-schunck")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fields_of_frames, colour_without_flow, true, "none")->UseRealTime()->Unit(benchmark::kMillisecond);

/// Every filter on frames in colour that are in memory, by one thread.
void filter_of_frames(benchmark::State& state, const std::string& name) {
    fields::EmptyScene scene;
    const video::Frame empty = frame_of(generator::make_still(), 0);
    scene.reference = fields::Planes{empty.grey, empty.colour};
    fields::FieldOptions options;
    options.filter = name;
    options.threads = 1;
    if (!options.filter->traits.flow) options.flow.method = "none";
    std::int64_t done = 0;
    for (auto _ : state) {
        const fields::FrameReader read = [next = std::size_t{0}]() mutable -> fields::FrameJob {
            if (next == 20) return {};
            return [&frame = walkers()[next++]] { return frame; };
        };
        done += fields::compute_fields(read, scene, options, [](const video::SharedFrame&, fields::Field&& field) {
            benchmark::DoNotOptimize(field.pts);
        });
    }
    state.SetItemsProcessed(done);
}

const bool filters_registered = [] {
    for (const fields::FilterRow& row : fields::filters()) {
        const std::string name(row.name);
        benchmark::RegisterBenchmark(("filter_of_frames/" + name).c_str(), filter_of_frames, name)
            ->Unit(benchmark::kMillisecond);
    }
    return true;
}();

void seeds_of_a_frame(benchmark::State& state) {
    const fields::Flow flow{Plane<float>(size, 1.F), Plane<float>(size, -0.5F)};
    const Plane<std::uint8_t> object(size, 255);
    const Plane<std::uint16_t> age(size, 3);
    for (auto _ : state) benchmark::DoNotOptimize(fields::make_seeds({0, flow, object, age}, {}));
}
BENCHMARK(seeds_of_a_frame)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
