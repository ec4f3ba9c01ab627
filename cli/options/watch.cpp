#include "cli/options/watch.h"

#include <cctype>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/app/settings.h"
#include "cli/options/job_options.h"
#include "cli/options/output.h"
#include "cli/options/parse_value.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/fields/reference.h"
#include "core/image/picture_file.h"
#include "core/image/video_encoder.h"

namespace vvr::options {

namespace {

constexpr Setting output{"output", "FILE", "the picture, replaced after each brick"};

}  // namespace

void add_stream_options(CommandLine& line, app::StreamOptions& options) {
    line.value(Group::input, setting::duration, "",
               [&options](const std::string& given) { options.duration = parse_duration(given); });
    line.duration(Group::input, options.lag, setting::lag);
    line.duration(Group::input, options.patience, setting::patience);
}

std::string address_of(const std::string& input) {
    if (!input.starts_with('@')) return input;
    const std::string file = input.substr(1);
    std::istringstream lines(read_file(file, most_bytes::text));
    std::string address;
    std::getline(lines, address);
    while (!address.empty() && std::isspace(static_cast<unsigned char>(address.back())) != 0) address.pop_back();
    if (!address.empty()) return address;
    throw Error(
        ErrorCode::input_missing,
        fmt::format("the file '{}' holds no address; its first line is one, such as rtsp://camera/stream", file));
}

void add_stream_clock(CommandLine& line, app::StartTime& start) {
    line.value(Group::look, setting::stream_clock, "",
               [&start](const std::string& given) {
                   start = parse_start_time(given);
                   if (start.from == app::StartTime::From::given || start.from == app::StartTime::From::none) return;
                   throw Error(ErrorCode::choice_unknown, std::string(setting::start_time.not_live_reason));
               },
               {.defaults = std::string(setting::stream_clock.default_text)});
}

void add_stream_output(CommandLine& line, app::OutputOptions& options) {
    line.path(Group::output, options.path, output,
              {.letter = 'o',
               .help = fmt::format(": {}; a page that reloads itself: .html; a series, one file per brick, has a field "
                                   "in its name: {{brick:4}}, #### or %04d",
                                   fmt::join(image::picture_file_extensions(), " ")),
               .use = FileUse::written});
}

void check_stream(const app::RenderJob& job) {
    if (job.output.path.empty())
        throw Error(ErrorCode::output_missing, "no output: say where the picture goes with -o FILE");
    check(job.output);
    if (image::is_animation(job.output.path)) {
        throw Error(ErrorCode::output_format_unknown,
                    fmt::format("'{}': an animated file is written when it ends, and a stream does "
                                "not; take a picture, a page or a series",
                                job.output.path.string()));
    }
    const fields::ReferenceRow* const reference = job.fields.reference.row();
    struct {
        bool given;
        std::string option;
        const char* instead;
    } const refused[] = {
        {std::filesystem::is_directory(job.seeds), "--seeds",
         "a list for each frame is for a clip whose frames are known; give one list that all frames share"},
        {reference != nullptr && reference->needs_whole_clip, "--reference " + job.fields.reference.name(),
         "it takes the whole clip; take running, first or a picture"},
    };
    for (const auto& row : refused) {
        if (row.given) throw Error(ErrorCode::options_conflict, fmt::format("{}: {}", row.option, row.instead));
    }
}

}  // namespace vvr::options
