// What others do with the same work.
//
//     peers flow                 every flow method, on scenes whose flow is known: time and error, as JSON
//     peers motion WIDTH HEIGHT  the loop that people script: a background model, opening, the largest blob; raw BGR
//                                frames on stdin, the number of frames with motion on stdout
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/background_segm.hpp>

#include "core/fields/flow.h"
#include "tests/bench/in_turn.h"
#include "tests/scene/scene.h"

namespace {

using namespace vvr;

struct Method {
    const char* name;
    const char* method;
    const char* solver;
};
constexpr Method methods[] = {{"Horn–Schunck, pyramid (the default)", "horn-schunck", "pyramid"},
                              {"Horn–Schunck, 60 Jacobi steps", "horn-schunck", "jacobi"},
                              {"OpenCV's dense inverse search", "dis", "pyramid"},
                              {"OpenCV's Farneback", "farneback", "pyramid"}};

struct Case {
    std::string name;
    generator::Scene scene;
};

std::vector<Case> cases() {
    const auto shifted = [](double u, double v) {
        generator::Options options{.noise = 1, .u = u, .v = v};
        return generator::make_shifted_texture(options);
    };
    generator::Options noisy{.noise = 1};
    return {{"texture, 0.8 px", shifted(0.7, 0.4)},
            {"texture, 4 px", shifted(3.5, -2)},
            {"spinning disc", generator::make_spinning_sphere(noisy)}};
}

Plane<std::uint8_t> grey_of(const Plane<Bgr>& picture) {
    Plane<std::uint8_t> grey(picture.size());
    std::ranges::transform(picture.pixels(), grey.pixels().begin(), [](const Bgr& p) {
        return static_cast<std::uint8_t>(std::lround(0.114 * p[0] + 0.587 * p[1] + 0.299 * p[2]));
    });
    return grey;
}

/// Degrees between (u, v, 1) and the truth, mean over what moves.
double error_of(const fields::Flow& flow, const generator::Truth& truth) {
    constexpr int border = 16;
    double sum = 0;
    int count = 0;
    for (int j = border; j < flow.u.height() - border; ++j) {
        for (int i = border; i < flow.u.width() - border; ++i) {
            const double u = truth.u.at(i, j), v = truth.v.at(i, j), a = flow.u.at(i, j), b = flow.v.at(i, j);
            if (u == 0 && v == 0) continue;
            const double cosine = (u * a + v * b + 1) / std::sqrt((u * u + v * v + 1) * (a * a + b * b + 1));
            sum += std::acos(std::min(1.0, cosine)) * 180 / std::numbers::pi;
            ++count;
        }
    }
    return sum / std::max(1, count);
}

/// A method with all that its flow of one frame takes.
struct Estimate {
    std::unique_ptr<fields::FlowMethod> method;
    std::vector<Plane<std::uint8_t>> frames;
    std::vector<fields::FlowFrame> prepared;
    fields::Flow flow;

    Estimate(const Method& row, const generator::Scene& scene, int middle) {
        fields::FlowOptions options{.method = row.method, .solver = row.solver};
        method = fields::make_flow(options);
        for (int k = -method->reach(); k <= method->reach(); ++k) frames.push_back(grey_of(scene.frame(middle + k)));
        for (const Plane<std::uint8_t>& frame : frames) prepared.push_back(method->prepare(frame));
    }

    // One frame is made ready for each flow: the others were for the frames before.
    void run() {
        prepared.back() = method->prepare(frames.back());
        std::vector<const fields::FlowFrame*> about;
        for (const fields::FlowFrame& frame : prepared) about.push_back(&frame);
        flow = (*method)(about, {0, 0, frames.front().width(), frames.front().height()});
    }
};

void flow() {
    constexpr int middle = 20;
    constexpr int runs = 9;
    nlohmann::json report = nlohmann::json::array();
    for (const Case& c : cases()) {
        std::vector<Estimate> estimates;
        for (const Method& row : methods) estimates.emplace_back(row, c.scene, middle);
        std::vector<std::function<void()>> works;
        for (Estimate& estimate : estimates) works.push_back([&estimate] { estimate.run(); });
        const auto seconds = bench::in_turn(works, runs);
        const generator::Truth truth = c.scene.truth(middle);
        for (std::size_t i = 0; i < estimates.size(); ++i) {
            report.push_back({{"scene", c.name},
                              {"method", methods[i].name},
                              {"seconds", seconds[i]},
                              {"degrees", error_of(estimates[i].flow, truth)}});
        }
    }
    fmt::print("{}\n", report.dump());
}

void motion(int width, int height) {
    const auto model = cv::createBackgroundSubtractorMOG2();
    cv::Mat frame(height, width, CV_8UC3), mask, labels, stats, middles;
    const cv::Mat kernel = cv::getStructuringElement(cv::MORPH_ELLIPSE, {3, 3});
    const std::size_t bytes = frame.total() * frame.elemSize();
    int moving = 0;
    while (std::fread(frame.data, 1, bytes, stdin) == bytes) {
        model->apply(frame, mask);
        cv::threshold(mask, mask, 200, 255, cv::THRESH_BINARY);
        cv::morphologyEx(mask, mask, cv::MORPH_OPEN, kernel);
        const int blobs = cv::connectedComponentsWithStats(mask, labels, stats, middles);
        for (int i = 1; i < blobs; ++i) {
            if (stats.at<int>(i, cv::CC_STAT_AREA) < 100) continue;
            ++moving;
            break;
        }
    }
    fmt::print("{}\n", moving);
}

}  // namespace

// NOLINTNEXTLINE(bugprone-exception-escape): a wrong number ends it
int main(int argc, char** argv) {
    // As many threads as the fields of one frame have.
    cv::setNumThreads(argc == 2 ? 1 : 0);
    if (argc == 2 && argv[1] == std::string("flow")) {
        flow();
    } else if (argc == 4 && argv[1] == std::string("motion")) {
        motion(std::stoi(argv[2]), std::stoi(argv[3]));
    } else {
        fmt::print(stderr, "usage: peers flow | peers motion WIDTH HEIGHT\n");
        return 1;
    }
    return 0;
}
