#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "cli/app/render.h"
#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/command_line.h"
#include "cli/options/job_options.h"
#include "cli/plan/input.h"
#include "cli/plan/make_plan.h"
#include "cli/plan/settings.h"
#include "core/annotation/time_ticks.h"
#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/base/wall_clock.h"
#include "core/dataset/manifest.h"
#include "core/footage/recorder_names.h"
#include "core/footage/recording.h"

namespace vvr::commands {

namespace {

/// The files of an input in order, each with its camera, start time, and the source of that time. Empty for inputs
/// without them, such as a stream or pictures.
std::vector<footage::Segment> list_clips(const app::InputOptions& options) {
    if (std::ranges::all_of(options.names, dataset::is_data_folder)) return {};
    const footage::RecorderNames layouts(options.name_patterns);
    std::vector<footage::Segment> clips;
    std::error_code none;
    if (auto recording = footage::find_recording(options.names, layouts, options.join, options.rate)) {
        clips = std::move(recording->segments);
    } else if (std::filesystem::is_regular_file(options.names.front(), none)) {
        clips = {footage::segment_from_name(options.names.front(), layouts)};
    }
    for (footage::Segment& clip : clips) {
        if (!options.camera.empty()) clip.camera = options.camera;
    }
    return clips;
}

/// "camera gate, 2026-11-21 20:00:00 UTC by file name (Frigate)"
std::string text_of(const footage::Segment& clip) {
    const std::string camera =
        clip.camera.empty() ? "camera not known (--camera-name names it)" : "camera " + shown_text(clip.camera);
    const std::string_view by = row_of(clip.begin_source).words;
    if (!clip.begin) return fmt::format("{}, {}", camera, by);
    const bool named = clip.begin_source == ClockSource::file_name;
    return fmt::format("{}, {} UTC {}{}", camera, annotation::format_clock(*clip.begin), by,
                       named ? fmt::format(" ({})", clip.scheme) : "");
}

std::string text_of(Size size) {
    return fmt::format("{}x{}", size.width, size.height);
}

std::string or_unknown(double value, const std::string& text) {
    return value > 0 ? text : "unknown";
}

/// All that is known about an input.
struct Facts {
    const fields::FieldSource& source;
    app::Extent extent;
    std::vector<footage::Segment> files;
    std::vector<std::string> warnings;
    std::optional<app::RenderTime> time{};  ///< none = not measured
};

/// "about 12 s on this machine, judging by the first 50 frames"
std::string text_of(const app::RenderTime& time) {
    if (time.frames_per_second <= 0) return "unknown: the first seconds have too few frames";
    const std::string takes =
        time.seconds > 0 ? fmt::format("about {}", annotation::format_duration(std::max(1.0, std::round(time.seconds))))
                         : fmt::format("1 s for about {:.0f} frames", time.frames_per_second);
    return fmt::format("{} on this machine, judging by the first {}", takes, counted(time.measured, "frame"));
}

std::string as_text(const Facts& facts) {
    const auto& [source, extent, files, warnings, time] = facts;
    const media::VideoInfo& info = source.info();
    std::string text = shown_text(redact_secrets(info.name)) + "\n";
    const auto line = [&text](const char* name, const std::string& value) {
        text += fmt::format("  {:<8} {}\n", name, value);
    };
    line("format", fmt::format("{}, {}", info.container, info.codec));
    line("size", text_of(info.size));
    line("rate", or_unknown(info.rate, fmt::format("{:.6g} frames per second", info.rate)));
    const char* const counted_by = files.size() > 1 ? "the containers and the gaps between the files" : "the container";
    line("frames", or_unknown(static_cast<double>(info.frames), fmt::format("{}, from {}", info.frames, counted_by)));
    line("span", or_unknown(info.duration, fmt::format("{:.3f} s", info.duration)));
    if (recording_time_is_known(info)) {
        line("recorded",
             fmt::format("{} UTC, {}", annotation::format_clock(*info.began), row_of(info.began_source).words));
    }
    if (info.created) {
        line("written",
             fmt::format("{} UTC, from the container{}", annotation::format_clock(*info.created),
                         recording_time_is_known(info)
                             ? ""
                             : "; it may have been recorded at another time (--start-time container uses this one)"));
    }
    for (const std::string& warning : warnings) line("note", warning);
    text += "a render of it\n";
    line("fields", text_of(source.field_size()));
    line("volume", fmt::format("{}{}, {} each", extent.frames > 0 ? "" : "up to ", counted(extent.layers, "layer"),
                               counted(extent.step, "frame")));
    line("bricks", fmt::to_string(extent.bricks));
    line("memory", fmt::format("at most about {} MB", extent.bytes / 1'000'000));
    if (time) line("time", text_of(*time));
    if (!files.empty())
        text += counted(std::ssize(files), "file") + (files.size() > 1 ? ", in the order of time" : "") + "\n";
    for (const footage::Segment& clip : files) text += fmt::format("  {}: {}\n", shown_text(clip.path), text_of(clip));
    return text;
}

Json json_of_file(const footage::Segment& clip) {
    return {{"file", clip.path},
            {"camera", or_null(clip.camera)},
            {"begin", clip.begin ? Json(annotation::format_clock(*clip.begin)) : Json()},
            {"recorded_by", row_of(clip.begin_source).name},
            {"layout", or_null(clip.scheme)}};
}

std::string as_json(const Facts& facts) {
    const auto& [source, extent, files, warnings, measured] = facts;
    const media::VideoInfo& info = source.info();
    const auto known = [](auto value) { return value > 0 ? Json(value) : Json(); };
    const auto time = [](std::optional<std::int64_t> utc) {
        return utc ? Json(annotation::format_clock(*utc)) : Json();
    };
    const Json json{
        {"name", info.name},
        {"container", info.container},
        {"codec", info.codec},
        {"width", info.size.width},
        {"height", info.size.height},
        {"rate", known(info.rate)},
        {"frames", known(info.frames)},
        {"seconds", known(info.duration)},
        {"recorded", recording_time_is_known(info) ? time(info.began) : time(std::nullopt)},
        {"recorded_by", recording_time_is_known(info) ? Json(row_of(info.began_source).name) : Json()},
        {"written", time(info.created)},
        {"warnings", warnings},
        {"render",
         {{"field_width", source.field_size().width},
          {"field_height", source.field_size().height},
          {"frames", known(extent.frames)},
          {"step", extent.step},
          {"layers", extent.layers},
          {"bricks", extent.bricks},
          {"memory_bytes", extent.bytes},
          {"seconds", measured ? known(measured->seconds) : Json()},
          {"frames_per_second", measured ? known(measured->frames_per_second) : Json()}}},
        {"files", list_of(files, json_of_file)},
    };
    return json_text(json, 2) + "\n";
}

namespace info_text {
constexpr Setting quick{"quick", "", "don't measure how long a render takes"};
}  // namespace info_text

class Info final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        const options::AddOptions add(line, options::Group::output);
        add(json_option, json_);
        add(info_text::quick, quick_);
        options::add_recording_options(line, job_.input, options::clip_or_extraction_input);
        options::add_picture_options(line, job_);
        line.examples({{"vvr info clip.avi", "the clip, and the memory and the time that a picture of it needs"},
                       {"vvr info clip.avi --json --quick", "for programs; without the time"},
                       {"vvr info clip.avi --field-size source", "the same for larger fields"}});
    }

    cli::ExitStatus run(const options::CommandLine& line, const cli::Environment&) override {
        app::require_input(job_.input);
        options::finish(line, job_, false);
        app::validate(job_);
        const app::OpenedFields fields = app::open_fields(job_);
        const app::Plan plan = app::make_plan(job_, fields.facts());
        Facts facts{*fields.source, plan.volume.extent, list_clips(job_.input), fields.warnings};
        // An extraction is drawn as a whole.
        if (!quick_ && fields.extracted.empty()) facts.time = measure(plan, facts.warnings);
        cli::print(json_ ? as_json(facts) : as_text(facts));
        return cli::ExitStatus::done;
    }

  private:
    /// What the clip has is shown even if it can't be drawn.
    std::optional<app::RenderTime> measure(const app::Plan& plan, std::vector<std::string>& warnings) const {
        try {
            return app::measure_render(job_, plan);
        } catch (const Error& error) {
            warnings.push_back(fmt::format("the time of a render was not measured: {}", error.what()));
            return std::nullopt;
        }
    }

    app::RenderJob job_;
    bool json_ = false;
    bool quick_ = false;
};

}  // namespace

std::unique_ptr<Command> make_info() {
    return std::make_unique<Info>();
}

}  // namespace vvr::commands
