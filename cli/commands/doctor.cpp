#include <algorithm>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <OpenImageIO/oiioversion.h>
#include <fmt/format.h>
#include <opencv2/core/version.hpp>

extern "C" {
#include <libavutil/ffversion.h>
}

#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/observe/identify.h"
#include "cli/options/command_line.h"
#include "cli/options/job_options.h"
#include "cli/workers/sandbox.h"
#include "core/base/json_text.h"
#include "core/base/version.h"
#include "core/base/wall_clock.h"
#include "core/image/text.h"
#include "core/media/hwaccel.h"
#include "core/page/preview.h"
#include "gl/context.h"

namespace vvr::commands {

namespace {

struct LibraryVersion {
    std::string name;
    std::string version;
};

/// The versions with which vvr was built. Asking the libraries would need to load them.
std::vector<LibraryVersion> library_versions() {
    return {{"FFmpeg", FFMPEG_VERSION}, {"OpenImageIO", OIIO_VERSION_STRING}, {"OpenCV", CV_VERSION}};
}

std::string describe(const gl::BackendReport& report) {
    std::string text =
        fmt::format("{:<14} {}: {}\n", report.name, report.works ? "works" : "does not work", report.what);
    const auto line = [&text](const std::string& name, const std::string& value) {
        if (!value.empty()) text += fmt::format("    {:<10} {}\n", name, value);
    };
    line("renderer", report.renderer);
    line("version", report.version);
    line("reason", report.reason);
    line("fix with", report.advice);
    for (std::size_t i = 0; i < report.devices.size(); ++i) line(fmt::format("device {}", i), report.devices[i]);
    return text;
}

Json json_of(const gl::BackendReport& report) {
    return {{"name", report.name},
            {"what", report.what},
            {"works", report.works},
            {"renderer", or_null(report.renderer)},
            {"version", or_null(report.version)},
            {"reason", or_null(report.reason)},
            {"fix_with", or_null(report.advice)},
            {"devices", report.devices}};
}

/// The detector that a config file or the command line sets.
struct DetectorReport {
    std::filesystem::path model;  ///< empty = none
    std::string format;           ///< empty = it can't be used
    Size input;                   ///< of its images
    std::optional<Error> error{};
};

DetectorReport look_at(const app::DetectorOptions& options) {
    DetectorReport report{options.model, {}, {}};
    try {
        if (const auto detector = app::open_detector(options)) {
            report.format = detector->format();
            report.input = detector->input();
        }
    } catch (const Error& error) {
        report.error = error;
    }
    return report;
}

std::string describe(const DetectorReport& report) {
    if (report.model.empty()) return "none: events have no classes; --detector MODEL.onnx sets one";
    if (report.error) return fmt::format("does not work: {}", report.error->what());
    return fmt::format("{}, {}x{} pixels: {}", report.format, report.input.width, report.input.height,
                       report.model.string());
}

Json json_of(const DetectorReport& report) {
    if (report.model.empty()) return {};
    const bool works = !report.error;
    const auto side = [&](int pixels) { return works ? Json(pixels) : Json(); };
    return {{"model", report.model.string()},      {"works", works},
            {"format", or_null(report.format)},    {"width", side(report.input.width)},
            {"height", side(report.input.height)}, {"reason", works ? Json() : Json(report.error->what())}};
}

/// Whether a kind of hardware can decode here.
struct DecoderReport {
    std::string_view name;
    std::optional<Error> error{};
};

std::vector<DecoderReport> look_for_decoders() {
    std::vector<DecoderReport> found;
    for (const media::HwaccelRow& row : media::hwaccels()) {
        if (row.device == AV_HWDEVICE_TYPE_NONE) continue;
        DecoderReport& report = found.emplace_back(DecoderReport{row.name});
        try {
            media::open_device(row);
        } catch (const Error& error) {
            report.error = error;
        }
    }
    return found;
}

Json json_of(const DecoderReport& report) {
    const bool works = !report.error;
    return {{"name", report.name}, {"works", works}, {"reason", works ? Json() : Json(report.error->what())}};
}

/// What this machine lends to pictures and archives.
struct Surroundings {
    std::string font = image::font_name();  ///< empty = none
    std::string zone = zone_text(std::time(nullptr));
    std::string encoder = std::string(page::preview_encoder());  ///< of the preview in pages; empty = none
    std::string sandbox = workers::Sandbox(workers::SandboxMode::automatic, {}).summary();
    std::vector<DecoderReport> decoders = look_for_decoders();
};

std::string describe(const Surroundings& here) {
    std::string decoders;
    for (const DecoderReport& report : here.decoders) {
        decoders +=
            fmt::format("{}{}: {}", decoders.empty() ? "" : "; ", report.name, report.error ? "not found" : "works");
    }
    return fmt::format("font           {}\n",
                       here.font.empty() ? "none: pictures have no text; install fonts-dejavu-core" : here.font) +
           fmt::format("page video     {}\n",
                       here.encoder.empty() ? "none: pages have no video; install a libavcodec with libx264 or libvpx"
                                            : here.encoder) +
           fmt::format("time zone      {}\n", here.zone) + fmt::format("sandbox        {}\n", here.sandbox) +
           fmt::format("hwaccel        {}\n", decoders);
}

/// The backend that `--backend auto` uses: the first that works.
auto used_backend(const std::vector<gl::BackendReport>& reports) {
    return std::ranges::find_if(reports, &gl::BackendReport::works);
}

std::string as_json(const std::vector<gl::BackendReport>& reports, const DetectorReport& detector,
                    const Surroundings& here) {
    const auto json_of_each = [](const auto& report) { return json_of(report); };
    const auto drawn = used_backend(reports);
    return json_text({{"vvr", version()},
                      {"libraries", object_of(library_versions())},
                      {"font", or_null(here.font)},
                      {"page_video", or_null(here.encoder)},
                      {"time_zone", here.zone},
                      {"sandbox", here.sandbox},
                      {"hwaccel", list_of(here.decoders, json_of_each)},
                      {"draws_with", drawn == reports.end() ? Json() : Json(drawn->name)},
                      {"detector", json_of(detector)},
                      {"backends", list_of(reports, json_of_each)}},
                     2) +
           "\n";
}

std::string as_text(const std::vector<gl::BackendReport>& reports, const DetectorReport& detector,
                    const Surroundings& here) {
    std::string text = version_text() + describe(here);
    const auto drawn = used_backend(reports);
    text += fmt::format("draws with     {}\n", drawn == reports.end()
                                                   ? "nothing: no backend works; see below how to fix it"
                                                   : fmt::format("{}: {}", drawn->name, drawn->renderer));
    text += fmt::format("detector       {}\n", describe(detector));
    // List working backends first: without a GPU, a failing GPU backend is not a problem.
    std::vector<gl::BackendReport> sorted = reports;
    std::stable_partition(sorted.begin(), sorted.end(), [](const gl::BackendReport& report) { return report.works; });
    for (const gl::BackendReport& report : sorted) text += fmt::format("\n{}", describe(report));
    return text;
}

class Doctor final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        options::AddOptions(line, options::Group::output)(json_option, json_);
        options::add_thread_options(line, threads_);
        options::add_hwaccel_option(line, hwaccel_);
        options::add_backend_options(line, backend_);
        options::add_detector_option(line, detector_);
        line.examples({{"vvr doctor", "which OpenGL works here, and what to install for the rest"},
                       {"vvr doctor --json", "the same for programs"},
                       {"vvr doctor --backend software", "check this backend; exit with 4 if it does not work"}});
    }

    cli::ExitStatus run(const options::CommandLine&, const cli::Environment&) override {
        const DetectorReport detector = look_at(detector_);  // before there are threads
        const std::vector<gl::BackendReport> reports = gl::probe_backends();
        const Surroundings here;
        cli::print(json_ ? as_json(reports, detector, here) : as_text(reports, detector, here));
        if (detector.error) throw Error(*detector.error);
        const auto asked_decoder = std::ranges::find(here.decoders, hwaccel_->name, &DecoderReport::name);
        if (asked_decoder != here.decoders.end() && asked_decoder->error) throw Error(*asked_decoder->error);
        if (std::ranges::any_of(reports, &gl::BackendReport::works)) {
            const bool asked = backend_.row != app::BackendOptions().row || backend_.device >= 0;
            if (asked) gl::open_context(backend_.row, backend_.device);
            return cli::ExitStatus::done;
        }
        throw Error(ErrorCode::opengl_unavailable,
                    "no OpenGL backend works, so vvr cannot draw; the commands above fix that");
    }

  private:
    bool json_ = false;
    app::BackendOptions backend_;
    Choice<media::HwaccelRow> hwaccel_{media::hwaccels().front()};
    app::DetectorOptions detector_;
    int threads_ = 0;  // unused; accepted because config files may set it for all commands
};

}  // namespace

std::string version_text() {
    std::string text = fmt::format("vvr {}\n", version());
    for (const LibraryVersion& library : library_versions())
        text += fmt::format("{} {}\n", library.name, library.version);
    return text;
}

std::unique_ptr<Command> make_doctor() {
    return std::make_unique<Doctor>();
}

}  // namespace vvr::commands
