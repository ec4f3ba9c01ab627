#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands/command.h"
#include "cli/options/job_options.h"
#include "cli/print.h"
#include "cli/render/open_fields.h"
#include "cli/render/plan.h"
#include "core/json_text.h"
#include "core/labels/time_ticks.h"
#include "core/shown_text.h"
#include "core/words.h"

namespace vvr {

namespace {

std::string text_of(Size size) {
    return fmt::format("{}x{}", size.width, size.height);
}

std::string or_unknown(double value, const std::string& text) {
    return value > 0 ? text : "unknown";
}

std::string as_text(const FieldSource& source, const Plan& plan) {
    const VideoInfo& info = source.info();
    std::string text = shown_text(without_secrets(info.name)) + "\n";
    const auto line = [&text](const char* name, const std::string& value) {
        text += fmt::format("  {:<8} {}\n", name, value);
    };
    line("format", fmt::format("{}, {}", info.container, info.codec));
    line("size", text_of(info.size));
    line("rate", or_unknown(info.rate, fmt::format("{:.6g} frames per second", info.rate)));
    line("frames", or_unknown(static_cast<double>(info.frames), fmt::format("{}, as the container says", info.frames)));
    line("span", or_unknown(info.duration, fmt::format("{:.3f} s", info.duration)));
    if (info.created) line("recorded", format_clock(*info.created) + " UTC");
    text += "a render of it\n";
    line("fields", text_of(source.field_size()));
    line("volume", fmt::format("{}{}, {} each", plan.frames > 0 ? "" : "up to ", counted(plan.layers, "layer"),
                               counted(plan.step, "frame")));
    line("bricks", fmt::to_string(plan.bricks));
    line("memory", fmt::format("at most about {} MB", plan.bytes / 1'000'000));
    return text;
}

std::string as_json(const FieldSource& source, const Plan& plan) {
    const VideoInfo& info = source.info();
    const auto known = [](auto value) { return value > 0 ? nlohmann::ordered_json(value) : nlohmann::ordered_json(); };
    const nlohmann::ordered_json json{
        {"name", info.name},
        {"container", info.container},
        {"codec", info.codec},
        {"width", info.size.width},
        {"height", info.size.height},
        {"rate", known(info.rate)},
        {"frames", known(info.frames)},
        {"seconds", known(info.duration)},
        {"recorded", info.created ? nlohmann::ordered_json(format_clock(*info.created)) : nlohmann::ordered_json()},
        {"render",
         {{"field_width", source.field_size().width},
          {"field_height", source.field_size().height},
          {"frames", known(plan.frames)},
          {"step", plan.step},
          {"layers", plan.layers},
          {"bricks", plan.bricks},
          {"memory_bytes", plan.bytes}}},
    };
    return json_text(json, 2) + "\n";
}

constexpr Setting json_option{"json", "", "for programs: null where the container does not say"};

class Info final : public Command {
  public:
    void add_options(CommandLine& line) override {
        line.flag(Group::output, json_, json_option);
        add_input_options(line, job_.input, "INPUT...", clip_or_extraction_input);
        add_layout_options(line, job_.input);
        add_picture_options(line, job_);
        line.examples({{"vvr info clip.avi", "what the clip is, and what a picture of it would need"},
                       {"vvr info clip.avi --json", "the same for programs"},
                       {"vvr info clip.avi --field-size source", "what larger fields would need"}});
    }

    ExitStatus run(const CommandLine& line, const Environment&) override {
        require_input(job_.input);
        finish(line, job_, false);
        validate(job_);
        const OpenedFields fields = open_fields(job_);
        const Plan plan = make_plan(job_, {}, *fields.source);
        print(json_ ? as_json(*fields.source, plan) : as_text(*fields.source, plan));
        return ExitStatus::done;
    }

  private:
    RenderJob job_;
    bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_info() {
    return std::make_unique<Info>();
}

}  // namespace vvr
