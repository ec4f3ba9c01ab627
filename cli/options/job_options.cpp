#include "cli/options/job_options.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/app/settings.h"
#include "cli/options/add_option.h"
#include "cli/options/presets.h"
#include "core/base/error.h"
#include "core/fields/settings.h"
#include "core/video/recorder_names.h"

namespace vvr::options {

void add_input_options(CommandLine& line, app::InputOptions& options, const std::string& name,
                       const std::string& help) {
    line.arguments(options.names, name, help);
    app::each_input_setting(options, AddOptions(line, Group::input));
    add_hwaccel_option(line, options.hwaccel);
}

void add_name_options(CommandLine& line, app::InputOptions& options) {
    AddOptions(line, Group::input)(setting::names, options.name_patterns,
                                   {.help = fmt::format("{}", fmt::join(video::known_recorders(), ", "))});
}

void add_decode_option(CommandLine& line, app::InputOptions& options) {
    AddOptions(line, Group::input)(setting::decode, options.decode, video::frame_choices());
}

void add_recording_options(CommandLine& line, app::InputOptions& options, const std::string& help) {
    line.find_camera(options.camera);
    add_input_options(line, options, "INPUT...", help);
    add_name_options(line, options);
    AddOptions(line, Group::input)(setting::join, options.join);
    add_decode_option(line, options);
    // Only the plan of an archive's worker sets it.
    line.plan_setting("input-problem", [&options](const std::string& words) { options.problems.push_back(words); });
}

void add_span_options(CommandLine& line, video::FrameSpan& span) {
    app::each_span_setting(span, AddOptions(line, Group::input));
}

void add_field_options(CommandLine& line, fields::FieldOptions& options) {
    fields::each_field_setting(options, AddOptions(line, Group::fields));
}

void add_detector_option(CommandLine& line, app::DetectorOptions& detector) {
    AddOptions(line, Group::fields)(setting::detector, detector.model);
    // The run that started this worker has tried the model, and a worker may start no process.
    line.plan_setting("detector-tried", [&detector](const std::string&) { detector.trial = detector::Trial::none; });
}

void add_preset_option(CommandLine& line, Group group) {
    line.value(group, setting::preset, "",
               [names = names_of(line.fitting(presets()))](const std::string& given) {
                   // It was applied before parsing.
                   if (std::ranges::find(names, given) == names.end())
                       refuse_choice(setting::preset.name, given, names);
               },
               {.values = values_of(line.fitting(presets()))});
}

void add_thread_options(CommandLine& line, int& threads) {
    AddOptions(line, Group::run)(setting::threads, threads);
}

void add_hwaccel_option(CommandLine& line, Choice<video::HwaccelRow>& hwaccel) {
    AddOptions(line, Group::run)(setting::hwaccel, hwaccel, video::hwaccels());
}

void add_backend_options(CommandLine& line, app::BackendOptions& backend) {
    app::each_backend_setting(backend, AddOptions(line, Group::run));
}

void add_picture_options(CommandLine& line, app::RenderJob& job) {
    add_span_options(line, job.fields.span);
    AddOptions(line, Group::input)(setting::step, job.bricks.step);
    add_field_options(line, job.fields);
    app::each_seed_list_setting(job, AddOptions(line, Group::fields));
    add_detector_option(line, job.detector);
    app::each_brick_setting(job.bricks, AddOptions(line, Group::bricks));
    app::each_view_setting(job, AddOptions(line, Group::view));
    app::each_look_setting(job, AddOptions(line, Group::look));
    add_preset_option(line, Group::look);
    add_thread_options(line, job.fields.threads);
    add_backend_options(line, job.backend);
    job.backend.debug = std::getenv("VVR_GL_DEBUG") != nullptr;
}

image::Metadata record_of(const app::InputOptions& input, const fields::FieldOptions& fields) {
    image::Metadata record;
    app::each_input_setting(input, Record(record));
    app::each_recording_setting(input, Record(record));
    app::each_span_setting(fields.span, Record(record));
    fields::each_field_setting(fields, Record(record));
    std::erase_if(record, [](const auto& one) { return one.second.empty(); });
    return record;
}

void finish(const CommandLine& line, app::RenderJob& job, bool series) {
    if (line.has(setting::brick) && line.has(setting::window) && !series) {
        throw Error(ErrorCode::options_conflict,
                    "--brick and --window exclude each other if one picture shows the whole clip; drop one of them, or "
                    "write a series: -o out.{brick:4}.png");
    }
    app::each_picture_setting(job, Record(job.settings));
    // A stream has fewer settings.
    const std::vector<OptionValue> options = line.values(picture_groups);
    std::erase_if(job.settings, [&](const auto& one) {
        return std::ranges::find(options, one.first, &OptionValue::name) == options.end();
    });
    // What is recorded can be given again: with --brick, there is no --window.
    if (line.has(setting::brick) && !series)
        std::erase_if(job.settings, [](const auto& one) { return one.first == setting::window.name; });
    for (const OptionValue& option : line.given(all_groups)) {
        // The trails of events that are left out are grey.
        if (option.name == setting::preset.name || option.name == setting::events.name)
            job.settings.emplace_back(option.name, option.value);
    }
    // The given settings of the fields, with which an extraction must agree.
    const auto record_given = [&](const Setting& setting, const auto&... value) {
        if (line.has(setting)) Record(job.given)(setting, value...);
    };
    app::each_input_setting(job.input, record_given);
    app::each_span_setting(job.fields.span, record_given);
    fields::each_field_setting(job.fields, record_given);
}

}  // namespace vvr::options
