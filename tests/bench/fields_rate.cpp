// Frames per second of a clip, on two threads: decoded and scaled to 384 pixels of grey, and with all fields as well.
// JSON on stdout.
//
//     fields_rate CLIP
#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/fields/field_source.h"

namespace {

using namespace vvr;

double frames_a_second(const std::string& clip, const std::string& filter, const std::string& flow, bool colour) {
    video::SourceOptions input;
    input.threads = 2;
    input.colour = colour;
    const auto source = video::open_source(clip, input);
    fields::FieldOptions options;
    options.filter = filter;
    options.flow.method = flow;
    options.threads = 2;
    // The reference frame is made before the first frame and takes its own pass over the clip.
    options.reference = "first";
    const auto start = std::chrono::steady_clock::now();
    const fields::FieldSummary summary =
        fields::compute_fields(*source, options, [](const video::SharedFrame&, fields::Field&&) {});
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    return static_cast<double>(summary.frames) / seconds.count();
}

struct Case {
    const char* name;
    const char* filter;
    const char* flow;
    bool colour;
    std::vector<double> rates;
};

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) {
        fmt::print(stderr, "usage: fields_rate CLIP\n");
        return 1;
    }
    std::vector<Case> cases{{"decoded and scaled to grey", "luminance", "none", false, {}},
                            {"and all fields", "difference", "horn-schunck", false, {}},
                            {"all fields, in colour", "difference", "horn-schunck", true, {}}};
    // In turn, so that whatever else the machine does falls on all.
    constexpr int runs = 5;
    for (int run = 0; run < runs; ++run) {
        for (Case& c : cases) c.rates.push_back(frames_a_second(argv[1], c.filter, c.flow, c.colour));
    }
    nlohmann::json report;
    for (const Case& c : cases) report[c.name] = c.rates;
    fmt::print("{}\n", report.dump());
    return 0;
} catch (const std::exception& error) {
    fmt::print(stderr, "fields_rate: {}\n", error.what());
    return 1;
}
