#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/command_line.h"
#include "cli/options/job_options.h"
#include "cli/write/golden.h"
#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/image/comparison.h"
#include "core/image/picture_file.h"

namespace vvr::commands {

namespace {

constexpr std::array<std::string_view, 5> verdicts{"same", "size", "channels", "not-finite", "values"};

/// The numbers for people, one per line.
std::string numbers_of(const image::Comparison& comparison) {
    if (!comparison.has_numbers()) return {};
    std::string text;
    const auto line = [&text](const char* name, const std::string& value) {
        text += fmt::format("{:<6} {}\n", name, value);
    };
    line("mean", fmt::format("{:.6f}", comparison.mean));
    line("max", fmt::format("{:.6f}", comparison.max));
    line("rms", fmt::format("{:.6f}", comparison.rms));
    line("psnr", std::isinf(comparison.psnr) ? "infinite" : fmt::format("{:.2f} dB", comparison.psnr));
    line("off", fmt::format("{} of {} pixels, {:.4f} %", comparison.off, comparison.pixels.pixels().size(),
                            comparison.percent));
    line("patch", fmt::format("{:.6f}", comparison.patch));
    return text;
}

/// The numbers as JSON; null if not computed.
Json json_of(const image::Comparison& comparison) {
    const auto number = [&](double value) {
        return comparison.has_numbers() && std::isfinite(value) ? Json(value) : nullptr;
    };
    const auto pair = [](const image::PixelPair& of) {
        return Json{{"x", of.column}, {"y", of.row}, {"difference", of.difference}, {"a", of.a}, {"b", of.b}};
    };
    return {{"same", comparison.verdict == image::Verdict::same},
            {"verdict", verdicts.at(static_cast<std::size_t>(comparison.verdict))},
            {"reason", comparison.reason},
            {"mean", number(comparison.mean)},
            {"max", number(comparison.max)},
            {"rms", number(comparison.rms)},
            {"psnr_db", number(comparison.psnr)},
            {"pixels_off", comparison.has_numbers() ? Json(comparison.off) : Json()},
            {"percent_off", number(comparison.percent)},
            {"patch", number(comparison.patch)},
            {"worst", list_of(comparison.worst, pair)}};
}

class Compare final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        line.arguments(names_, "A B", "two picture files");
        options::AddOptions(line, options::Group::output)(json_option, json_);
        options::add_comparison_options(line, options_);
        line.examples({{"vvr compare golden.png out.png", "exit with 7 if they differ by more than the tolerance"},
                       {"vvr compare golden.png out.png --diff diff.png", "show where they differ"},
                       {"vvr compare golden.png out.png --tolerance 0 --json",
                        "every sample must be the same; numbers for programs"}});
    }

    cli::ExitStatus run(const options::CommandLine&, const cli::Environment& environment) override {
        if (names_.size() != 2) {
            throw Error(ErrorCode::input_unsuitable,
                        fmt::format("compare needs exactly two pictures, not {}; use: vvr compare A B", names_.size()));
        }
        options::check(options_);
        const image::Samples a = image::without_pixel_data(image::read_samples(names_[0]));
        const image::Samples b = image::without_pixel_data(image::read_samples(names_[1]));
        const image::Comparison comparison = image::compare(a, b, options_.tolerance);
        cli::print(json_ ? json_of_files(comparison) : numbers_of(comparison));
        cli::Console console(environment, false);
        if (comparison.has_numbers() && !options_.diff.empty()) {
            const auto held = console.guard();
            image::write_picture(options_.diff, image::difference_picture(a, comparison));
        }
        if (comparison.verdict == image::Verdict::same) return cli::ExitStatus::done;
        app::show_difference(comparison, options_.tolerance, "A", "B", console);
        throw Error(ErrorCode::picture_differs,
                    fmt::format("'{}' and '{}' differ: {}", names_[0], names_[1], comparison.reason));
    }

  private:
    std::string json_of_files(const image::Comparison& comparison) const {
        Json json{{"a", names_[0]}, {"b", names_[1]}};
        json.update(json_of(comparison));
        return json_text(json, 2) + "\n";
    }

    std::vector<std::string> names_;
    bool json_ = false;
    app::ComparisonOptions options_;
};

}  // namespace

std::unique_ptr<Command> make_compare() {
    return std::make_unique<Compare>();
}

}  // namespace vvr::commands
