#include "cli/options/job_options.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/options/config_file.h"
#include "core/base/error.h"
#include "core/dataset/plane_files.h"
#include "core/fields/settings.h"
#include "core/footage/recorder_names.h"

namespace vvr::options {

namespace {

/// Options of the groups of a picture that say nothing of the picture.
constexpr std::array not_of_picture{setting::preset.name, setting::duration.name, setting::patience.name};

/// Settings of groups of the fields that an extraction does not record.
constexpr std::array not_extracted{setting::names.name,   setting::join.name,  setting::decode.name,
                                   setting::step.name,    setting::seeds.name, setting::seed_flags.name,
                                   setting::detector.name};

}  // namespace

void add_input_options(CommandLine& line, app::InputOptions& options, const std::string& name,
                       const std::string& help) {
    line.arguments(options.names, name, help);
    const AddOptions add(line, Group::input);
    add(setting::field_size, options.field_size, app::Word{"source"});
    add(setting::rate, options.rate, app::Word{""});
    add(setting::track, options.track, app::Word{""});
    add(setting::aspect, options.aspect);
    add_hwaccel_option(line, options.hwaccel);
}

void add_name_options(CommandLine& line, app::InputOptions& options) {
    AddOptions(line, Group::input)(setting::names, options.name_patterns,
                                   {.help = fmt::format("{}", fmt::join(footage::known_recorders(), ", "))});
}

void add_decode_option(CommandLine& line, app::InputOptions& options) {
    AddOptions(line, Group::input)(setting::decode, options.decode, media::frame_choices());
}

void add_recording_options(CommandLine& line, app::InputOptions& options, const std::string& help) {
    line.find_camera(options.camera);
    add_input_options(line, options, "INPUT...", help);
    add_name_options(line, options);
    AddOptions(line, Group::input)(setting::join, options.join);
    add_decode_option(line, options);
    AddOptions(line, Group::plan)({"input-problem", "", ""}, options.problems);
}

void add_span_options(CommandLine& line, media::FrameSpan& span) {
    const AddOptions add(line, Group::input);
    add(setting::start, span);
    add(setting::end, span);
    add(setting::between, span.asked.between);
}

void add_field_options(CommandLine& line, fields::FieldOptions& options) {
    options.read_given = dataset::read_scalar;
    fields::each_field_setting(options, AddOptions(line, Group::fields));
    // A filter that is given too is set later.
    line.after(setting::field, [&options] { options.filter = "given"; });
}

void add_detector_option(CommandLine& line, app::DetectorOptions& detector) {
    AddOptions(line, Group::fields)(setting::detector, detector.model);
    // The run that started this worker has tried the model, and a worker may start no process.
    line.add(
        Group::plan, {"detector-tried", "", ""},
        {[&detector](const std::string&) { detector.trial = detector::Trial::none; }, [] { return std::string(); }});
}

void add_preset_option(CommandLine& line, Group group) {
    line.add(
        group, setting::preset,
        choice_of(
            setting::preset, presets(), line.is_for_streams(), [](const Preset&) {}, [] { return std::string(); }));
}

void add_thread_options(CommandLine& line, int& threads) {
    AddOptions(line, Group::run)(setting::threads, threads);
}

void add_hwaccel_option(CommandLine& line, Choice<media::HwaccelRow>& hwaccel) {
    AddOptions(line, Group::run)(setting::hwaccel, hwaccel, media::hwaccels());
}

void add_backend_options(CommandLine& line, app::BackendOptions& backend) {
    AddOptions(line, Group::run)(setting::backend, backend);
}

void add_picture_options(CommandLine& line, app::RenderJob& job) {
    add_span_options(line, job.fields.span);
    AddOptions(line, Group::input)(setting::step, job.bricks.step);
    add_field_options(line, job.fields);
    const AddOptions add_field(line, Group::fields);
    add_field(setting::seeds, job.seeds);
    add_field(setting::seed_flags, job.seed_flags);
    add_detector_option(line, job.detector);
    app::each_brick_setting(job.bricks, AddOptions(line, Group::bricks));
    app::each_view_setting(job, AddOptions(line, Group::view));
    app::each_look_setting(job, AddOptions(line, Group::look));
    add_preset_option(line, Group::look);
    add_thread_options(line, job.fields.threads);
    add_backend_options(line, job.backend);
    job.backend.debug = std::getenv("VVR_GL_DEBUG") != nullptr;
}

image::Metadata record_of_fields(const CommandLine& line) {
    image::Metadata record = line.record(std::array{Group::input, Group::fields});
    std::erase_if(record, [](const auto& one) { return one.second.empty(); });
    return record;
}

void finish(const CommandLine& line, app::RenderJob& job, bool series) {
    if (line.has(setting::brick) && line.has(setting::window) && !series) {
        throw Error(ErrorCode::options_conflict,
                    "--brick and --window exclude each other if one picture shows the whole clip; drop one of them, or "
                    "write a series: -o out.{brick:4}.png");
    }
    job.settings = line.record(picture_groups);
    std::erase_if(job.settings, [](const auto& one) { return std::ranges::count(not_of_picture, one.first) > 0; });
    // What is recorded can be given again: with --brick, there is no --window.
    if (line.has(setting::brick) && !series)
        std::erase_if(job.settings, [](const auto& one) { return one.first == setting::window.name; });
    for (const OptionValue& option : line.given(all_groups)) {
        // The trails of events that are left out are grey.
        if (option.name == setting::preset.name || option.name == setting::events.name)
            job.settings.emplace_back(option.name, option.value);
    }
    // The given settings of the fields, with which an extraction must agree.
    for (const OptionValue& option : line.given(std::array{Group::input, Group::fields})) {
        if (std::ranges::find(not_extracted, option.name) == not_extracted.end())
            job.given.emplace_back(option.name, image::value_of(job.settings, option.name));
    }
}

}  // namespace vvr::options
