#include "cli/options/input.h"

#include <memory>

#include <fmt/format.h>

#include "cli/options/option.h"

namespace vvr {

namespace {

Size parse_field_size(const std::string& text) {
    return text == "source" ? Size{-1, -1} : parse_size(text);
}

std::optional<double> in(Time::Unit unit, const std::optional<Time>& time) {
    return time && time->unit == unit ? std::optional(time->value) : std::nullopt;
}

}  // namespace

void add_clip_options(CLI::App& app, InputOptions& options) {
    app.add_option("INPUT", options.names,
                   "a video file, a folder or pattern of pictures (frames/%05d.png), - for stdin")
        ->type_name("");
    add_option(app, group::input, options.field_size,
               {"--field-size", "WxH", "", "size of the fields, or 'source'; long side 384 if not given"},
               parse_field_size);
    add_number(app, group::input, options.rate, {0.001, 100'000},
               {"--rate", "FPS", "", "frames a second of pictures and raw streams"});
}

void add_options(CLI::App& app, InputOptions& options) {
    add_clip_options(app, options);
    add_option(app, group::input, options.start, {"--start", "TIME", "0", "first frame: 250, 12.5s or 00:00:12.5"},
               parse_time);
    add_option(app, group::input, options.end, {"--end", "TIME", "", "where to stop, itself left out"}, parse_time);
}

const std::string& only_input(const InputOptions& options) {
    if (options.names.empty()) {
        throw Error(ErrorKind::usage, "no INPUT: give a video file, a folder of pictures, or - for stdin");
    }
    if (options.names.size() > 1) {
        throw Error(ErrorKind::usage, fmt::format("'{}' is one argument too many: only directories that `vvr extract` "
                                                  "wrote, one part of a clip each, can be several",
                                                  options.names[1]));
    }
    return options.names.front();
}

std::unique_ptr<FrameSource> open_clip(const InputOptions& options, bool colour, int threads) {
    SourceOptions source;
    source.field_size = options.field_size;
    source.colour = colour;
    source.threads = threads;
    source.rate = options.rate;
    return open_source(only_input(options), source);
}

FrameSpan span_of(const InputOptions& options) {
    const auto number = [](double value) { return static_cast<std::int64_t>(value); };
    FrameSpan span;
    span.start = in(Time::Unit::seconds, options.start).value_or(0);
    span.end = in(Time::Unit::seconds, options.end);
    span.first = number(in(Time::Unit::frames, options.start).value_or(0));
    if (const auto stop = in(Time::Unit::frames, options.end)) span.stop = number(*stop);
    if ((span.end && *span.end <= span.start) || (span.stop && *span.stop <= span.first)) {
        throw Error(ErrorKind::usage, "--end has to come after --start");
    }
    return span;
}

}  // namespace vvr
