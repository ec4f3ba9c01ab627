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
#include <nlohmann/json.hpp>
#include <opencv2/core/version.hpp>

extern "C" {
#include <libavutil/ffversion.h>
}

#include "cli/app/identify.h"
#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/add_option.h"
#include "cli/options/job_options.h"
#include "cli/workers/sandbox.h"
#include "core/base/json_text.h"
#include "core/base/version.h"
#include "core/base/wall_clock.h"
#include "core/image/text.h"
#include "core/page/preview.h"
#include "core/video/hwaccel.h"
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

nlohmann::ordered_json json_of(const gl::BackendReport& report) {
    const auto known = [](const std::string& text) {
        return text.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(text);
    };
    return {{"name", report.name},
            {"what", report.what},
            {"works", report.works},
            {"renderer", known(report.renderer)},
            {"version", known(report.version)},
            {"reason", known(report.reason)},
            {"fix_with", known(report.advice)},
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

nlohmann::ordered_json json_of(const DetectorReport& report) {
    if (report.model.empty()) return {};
    const bool works = !report.error;
    const auto side = [&](int pixels) { return works ? nlohmann::ordered_json(pixels) : nlohmann::ordered_json(); };
    return {{"model", report.model.string()},
            {"works", works},
            {"format", works ? nlohmann::ordered_json(report.format) : nlohmann::ordered_json()},
            {"width", side(report.input.width)},
            {"height", side(report.input.height)},
            {"reason", works ? nlohmann::ordered_json() : nlohmann::ordered_json(report.error->what())}};
}

/// Why each row of hardware decoders can't be opened; empty = it can.
std::vector<std::pair<std::string_view, std::string>> look_for_decoders() {
    std::vector<std::pair<std::string_view, std::string>> found;
    for (const video::HwaccelRow& row : video::hwaccels()) {
        if (row.device == AV_HWDEVICE_TYPE_NONE) continue;
        found.emplace_back(row.name, "");
        try {
            video::open_device(row);
        } catch (const Error& error) {
            found.back().second = error.what();
        }
    }
    return found;
}

/// What this machine lends to pictures and archives.
struct Surroundings {
    std::string font = image::font_name();  ///< empty = none
    std::string zone = zone_text(std::time(nullptr));
    std::string encoder = std::string(page::preview_encoder());  ///< of the preview in pages; empty = none
    std::string sandbox = workers::Sandbox(workers::SandboxMode::automatic, {}).summary();
    std::vector<std::pair<std::string_view, std::string>> decoders = look_for_decoders();
};

std::string describe(const Surroundings& here) {
    std::string decoders;
    for (const auto& [name, reason] : here.decoders)
        decoders += fmt::format("{}{}: {}", decoders.empty() ? "" : "; ", name, reason.empty() ? "works" : "not found");
    return fmt::format("font           {}\n",
                       here.font.empty() ? "none: pictures have no text; install fonts-dejavu-core" : here.font) +
           fmt::format("page video     {}\n",
                       here.encoder.empty() ? "none: pages have no video; install a libavcodec with libx264 or libvpx"
                                            : here.encoder) +
           fmt::format("time zone      {}\n", here.zone) + fmt::format("sandbox        {}\n", here.sandbox) +
           fmt::format("hwaccel        {}\n", decoders);
}

/// The backend that `--backend auto` uses: the first that works.
auto drawn_with(const std::vector<gl::BackendReport>& reports) {
    return std::ranges::find_if(reports, &gl::BackendReport::works);
}

std::string as_json(const std::vector<gl::BackendReport>& reports, const DetectorReport& detector,
                    const Surroundings& here) {
    nlohmann::ordered_json libraries = nlohmann::ordered_json::object();
    for (const LibraryVersion& library : library_versions()) libraries[library.name] = library.version;
    nlohmann::ordered_json backends = nlohmann::ordered_json::array();
    for (const gl::BackendReport& report : reports) backends.push_back(json_of(report));
    nlohmann::ordered_json decoders = nlohmann::ordered_json::array();
    for (const auto& [name, reason] : here.decoders) {
        const bool works = reason.empty();
        decoders.push_back({{"name", name},
                            {"works", works},
                            {"reason", works ? nlohmann::ordered_json() : nlohmann::ordered_json(reason)}});
    }
    const auto drawn = drawn_with(reports);
    return json_text(
               {{"vvr", version()},
                {"libraries", libraries},
                {"font", here.font.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(here.font)},
                {"page_video", here.encoder.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(here.encoder)},
                {"time_zone", here.zone},
                {"sandbox", here.sandbox},
                {"hwaccel", decoders},
                {"draws_with", drawn == reports.end() ? nlohmann::ordered_json() : nlohmann::ordered_json(drawn->name)},
                {"detector", json_of(detector)},
                {"backends", backends}},
               2) +
           "\n";
}

std::string as_text(const std::vector<gl::BackendReport>& reports, const DetectorReport& detector,
                    const Surroundings& here) {
    std::string text = version_text() + describe(here);
    const auto drawn = drawn_with(reports);
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
        if (hwaccel_->device != AV_HWDEVICE_TYPE_NONE) video::open_device(*hwaccel_);
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
    Choice<video::HwaccelRow> hwaccel_{video::hwaccels().front()};
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
