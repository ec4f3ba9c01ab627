#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/app/golden.h"
#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/output.h"
#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/image/comparison.h"
#include "core/image/picture_file.h"

namespace vvr::commands {

namespace {

constexpr Setting json_option{"json", "", "for programs: null where there is no number"};

class Compare final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        line.arguments(names_, "A B", "two picture files");
        line.flag(options::Group::output, json_, json_option);
        options::add_comparison_options(line, options_);
        line.examples({{"vvr compare golden.png out.png", "status 7 if they differ by more than the tolerance"},
                       {"vvr compare golden.png out.png --diff diff.png", "where they differ"},
                       {"vvr compare golden.png out.png --tolerance 0 --tolerance-percent 0 --tolerance-patch 0 --json",
                        "the same in every sample, with numbers for programs"}});
    }

    cli::ExitStatus run(const options::CommandLine&, const cli::Environment& environment) override {
        if (names_.size() != 2) {
            throw Error(ErrorCode::input_unsuitable,
                        fmt::format("compare takes two pictures, and was given {}: vvr compare A B", names_.size()));
        }
        options::check(options_);
        const image::Samples a = image::without_pixel_data(image::read_samples(names_[0]));
        const image::Samples b = image::without_pixel_data(image::read_samples(names_[1]));
        const image::Comparison comparison = image::compare(a, b, options_.tolerance);
        cli::print(json_ ? json_of_files(comparison) : app::numbers_of(comparison));
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
        nlohmann::ordered_json json{{"a", names_[0]}, {"b", names_[1]}};
        json.update(app::json_of(comparison));
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
