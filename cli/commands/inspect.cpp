#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/glm.hpp>

#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/command_line.h"
#include "cli/options/job_options.h"
#include "cli/plan/input.h"
#include "cli/plan/observer.h"
#include "cli/plan/settings.h"
#include "core/annotation/time_ticks.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/wall_clock.h"
#include "core/fields/field.h"
#include "core/fields/field_source.h"
#include "core/fields/region.h"
#include "core/fields/settings.h"
#include "core/image/picture.h"
#include "core/image/picture_file.h"
#include "core/image/text.h"
#include "core/media/frame.h"
#include "core/media/frame_source.h"
#include "core/media/scaler.h"
#include "core/page/page.h"

namespace vvr::commands {

namespace {

/// One frame of a clip, and the output: a picture of its fields, or a page for drawing regions.
struct InspectJob {
    app::InputOptions input;
    fields::FieldOptions fields;
    std::optional<app::Time> frame;  ///< none = the middle of the clip, but at most a minute into it
    std::filesystem::path path;
};

/// The frame with that number, or the one shown at that time. Counts decoded frames from the first one and ignores the
/// container's numbers. Seeks back to the first frame.
/// \throws Error usage with the clip's length when the clip ends earlier
Moment find_frame(media::FrameSource& clip, const app::Time& time) {
    const bool by_number = time.unit == app::Time::Unit::frames;
    Moment found;
    double before = 0;
    bool past = false;
    while (const auto frame = clip.next()) {
        past = frame->index > 0 && (by_number ? static_cast<double>(frame->index) : frame->pts) > time.value;
        if (past) break;
        before = found.seconds;
        found = {frame->index, frame->pts};
    }
    clip.rewind();
    // The last frame is shown for as long as the previous one.
    const double end = found.seconds + (found.seconds - before);
    const bool shown =
        by_number ? time.value <= static_cast<double>(found.frame) : time.value <= found.seconds || time.value < end;
    if (past || shown) return found;
    throw Error(ErrorCode::option_value_out_of_range,
                fmt::format("frame: '{}' has {}, the last one at {:.3f} s; choose an earlier frame", clip.info().name,
                            counted(found.frame + 1, "frame"), found.seconds),
                {"frame"});
}

constexpr int whole_width = 1280;
constexpr int gap = 14;
constexpr int caption_height = 62;
constexpr int text_size = 19;
constexpr int panel_width = (whole_width - 4 * gap) / 3;

constexpr image::Rgba paper{1, 1, 1, 1};
constexpr image::Rgba ink{0.12F, 0.13F, 0.15F, 1};
constexpr image::Rgba pale_ink{0.42F, 0.44F, 0.47F, 1};
constexpr image::Rgba green{0.25F, 0.95F, 0.30F, 1};
constexpr image::Rgba yellow{1, 0.86F, 0.20F, 1};
constexpr image::Rgba orange{1, 0.45F, 0.05F, 1};

// Lines and arrows end where things will be after this many frames.
constexpr double frames_ahead = 4;
constexpr int line_interval = 5;  // field pixels
constexpr double least_flow = 0.25;

/// One of the three pictures: its position, and how field pixels map to it.
struct Panel {
    int left = 0;
    double scale = 1;

    glm::dvec2 at(double x, double y) const { return {left + (x + 0.5) * scale - 0.5, gap + (y + 0.5) * scale - 0.5}; }
};

image::Rgba colour_of(const Bgr& pixel) {
    return {static_cast<float>(pixel[2]) / 255, static_cast<float>(pixel[1]) / 255, static_cast<float>(pixel[0]) / 255,
            1};
}

/// Dark grey, so that lines stand out.
image::Rgba dimmed(const Bgr& pixel) {
    const image::Rgba colour = colour_of(pixel);
    const float grey = 0.42F * (0.30F * colour[0] + 0.59F * colour[1] + 0.11F * colour[2]) + 0.05F;
    return {grey, grey, grey, 1};
}

/// Fills a panel with the colours that `shade` gives field pixels, interpolated linearly.
template <class Shade>
void fill(image::Picture& picture, const Panel& panel, Size field, Shade shade) {
    Plane<image::Rgba> shades(field);
    for (int j = 0; j < field.height; ++j) {
        for (int i = 0; i < field.width; ++i) shades.at(i, j) = shade(i, j);
    }
    const int height = picture.pixels.height() - gap - caption_height;
    for (int j = 0; j < height; ++j) {
        const double y = std::clamp((j + 0.5) / panel.scale - 0.5, 0.0, field.height - 1.0);
        const int top = static_cast<int>(y);
        const int below = std::min(top + 1, field.height - 1);
        for (int i = 0; i < panel_width; ++i) {
            const double x = std::clamp((i + 0.5) / panel.scale - 0.5, 0.0, field.width - 1.0);
            const int left = static_cast<int>(x);
            const int right = std::min(left + 1, field.width - 1);
            const auto across = static_cast<float>(x - left);
            picture.pixels.at(panel.left + i, gap + j) = glm::mix(
                glm::mix(shades.at(left, top), shades.at(right, top), across),
                glm::mix(shades.at(left, below), shades.at(right, below), across), static_cast<float>(y - top));
        }
    }
}

void draw_flow(image::Picture& picture, const Panel& panel, const fields::Flow& flow) {
    for (int y = line_interval / 2; y < flow.u.height(); y += line_interval) {
        for (int x = line_interval / 2; x < flow.u.width(); x += line_interval) {
            const double u = flow.u.at(x, y);
            const double v = flow.v.at(x, y);
            if (std::hypot(u, v) < least_flow) continue;
            image::draw_line(picture, panel.at(x, y), panel.at(x + frames_ahead * u, y + frames_ahead * v), 1.3, green);
        }
    }
}

void draw_seeds(image::Picture& picture, const Panel& panel, const std::vector<fields::Seed>& seeds) {
    for (const fields::Seed& seed : seeds) {
        const glm::dvec2 from = panel.at(seed.x, seed.y);
        const glm::dvec2 to = panel.at(seed.x + frames_ahead * seed.u, seed.y + frames_ahead * seed.v);
        const glm::dvec2 back = (from - to) * std::min(0.4, 6 / std::max(glm::distance(from, to), 1e-9));
        const glm::dvec2 aside(-back.y, back.x);
        image::draw_line(picture, from, to, 1.4, yellow);
        image::draw_line(picture, to, to + back + 0.6 * aside, 1.4, yellow);
        image::draw_line(picture, to, to + back - 0.6 * aside, 1.4, yellow);
        image::draw_line(picture, from, from, 4.6, orange);
    }
}

/// Clears what was drawn beyond the panels' edges.
void clear_margins(image::Picture& picture) {
    Plane<image::Rgba>& pixels = picture.pixels;
    const int bottom = pixels.height() - caption_height;
    for (int j = 0; j < pixels.height(); ++j) {
        for (int i = 0; i < pixels.width(); ++i) {
            const bool beside = i % (panel_width + gap) < gap || i >= 3 * (panel_width + gap);
            if (beside || j < gap || j >= bottom) pixels.at(i, j) = paper;
        }
    }
}

/// The picture of a frame's fields, and whether a font for its captions was found.
struct Inspection {
    image::Picture picture;
    bool captions = true;
};

/// Fig. 4: the difference object, the flow as green lines and the seeds, side by side over the dimmed frame.
/// \param frame in colour
Inspection inspect(const media::Frame& frame, const fields::Field& field) {
    const Size size = field.scalar.size();
    const double scale = static_cast<double>(panel_width) / size.width;
    const int height = std::max(1, static_cast<int>(std::lround(size.height * scale)));
    Inspection result;
    result.picture.pixels = Plane<image::Rgba>({whole_width, gap + height + caption_height}, paper);

    std::array<Panel, 3> panels{};
    for (int k = 0; k < 3; ++k) panels[static_cast<std::size_t>(k)] = {gap + k * (panel_width + gap), scale};
    fill(result.picture, panels[0], size, [&](int i, int j) {
        const float strength = static_cast<float>(field.scalar.at(i, j)) / 255;
        if (strength <= 0) return dimmed(frame.colour.at(i, j));
        return glm::mix(colour_of(frame.colour.at(i, j)), orange, 0.25F + 0.45F * strength);
    });
    for (const std::size_t k : {1U, 2U}) {
        fill(result.picture, panels[k], size, [&](int i, int j) { return dimmed(frame.colour.at(i, j)); });
    }
    if (!field.flow.u.empty()) draw_flow(result.picture, panels[1], field.flow);
    draw_seeds(result.picture, panels[2], field.seeds);
    clear_margins(result.picture);

    const std::array<std::string, 3> captions{"(a) difference object",
                                              field.flow.u.empty() ? "(b) no flow" : "(b) flow",
                                              fmt::format("(c) {}", counted(std::ssize(field.seeds), "seed"))};
    const std::array<std::string, 3> notes{fmt::format("frame {}, {:.3f} s", field.index, field.pts),
                                           fmt::format("lines as long as {} frames", frames_ahead),
                                           fmt::format("arrows as long as {} frames", frames_ahead)};
    const int base = gap + height;
    for (std::size_t k = 0; k < panels.size(); ++k) {
        const int middle = panels[k].left + panel_width / 2;
        const bool written =
            image::draw_text_centred(result.picture, middle, base + 27, captions[k], text_size, ink) &&
            image::draw_text_centred(result.picture, middle, base + 49, notes[k], text_size * 3 / 4, pale_ink);
        result.captions = result.captions && written;
    }
    return result;
}

/// The frame in the clip's size and colours.
Plane<Bgr> picture_of(media::FrameSource& clip, const Moment& moment) {
    clip.seek(moment.seconds - 1);
    media::Scaler scale(clip);
    while (const auto frame = clip.next()) {
        if (frame->index >= moment.frame) return media::picture_of(scale(*frame));
    }
    throw Error(
        ErrorCode::no_frame,
        fmt::format("'{}': frame {} can no longer be decoded; check whether the file was changed during the run",
                    clip.info().name, moment.frame));
}

/// Regions as polygons. A mask picture can't be edited on a page, so it is left out with a warning.
std::string polygons_of(std::string_view setting, const std::string& area, app::Observer& observer) {
    std::string list = fields::polygon_list(setting, area);
    if (area.empty() || !list.empty()) return list;
    observer.warn(
        fmt::format("{} '{}' is a picture, which the page can't edit; the page begins without it", setting, area),
        {setting});
    return {};
}

/// The requested frame; by default the middle one, but early enough to be found quickly.
app::Time wanted_frame(const InspectJob& job, const media::VideoInfo& info) {
    constexpr double farthest = 60;
    return job.frame.value_or(app::Time{std::min(info.duration / 2, farthest), app::Time::Unit::seconds});
}

/// A hint for the case that the user chose no frame.
std::string_view about_choice(const InspectJob& job) {
    return job.frame ? "" : "; --frame TIME chooses another";
}

void write_region_editor(const InspectJob& job, app::Observer& observer) {
    app::InputOptions options = job.input;
    options.field_size = {-1, -1};
    page::RegionEditorContent content;
    content.roi = polygons_of(setting::roi.name, job.fields.roi, observer);
    content.mask = polygons_of(setting::mask.name, job.fields.mask, observer);
    std::vector<std::string> warnings;
    const auto clip = app::open_clip(options, true, job.fields.threads, warnings);
    app::report_warnings(warnings, {}, observer);
    const Moment found = find_frame(*clip, wanted_frame(job, clip->info()));
    content.name = app::shown_name(clip->info().name);
    content.moment = annotation::format_moment(found.seconds);
    content.frame = picture_of(*clip, found);
    const std::string text = page::make_region_editor(content);
    const auto held = observer.guard();
    replace_file(job.path, std::as_bytes(std::span(text)));
    observer.info(fmt::format("'{}': a page to draw regions on frame {} at {:.3f} s{}", job.path.string(), found.frame,
                              found.seconds, about_choice(job)));
}

/// Draws Fig. 4 for a frame: its difference object, flow and seeds side by side. A page gets only the frame, for
/// drawing regions on it, and starts with the regions of `fields`.
/// \throws Error usage, io, not_video, limit
void inspect(const InspectJob& job, app::Observer& observer) {
    if (app::is_page(job.path)) return write_region_editor(job, observer);
    constexpr bool colour = true;
    std::vector<std::string> warnings;
    const auto clip = app::open_clip(job.input, colour, job.fields.threads, warnings);
    const Moment found = find_frame(*clip, wanted_frame(job, clip->info()));
    // The other frames are only needed as neighbours.
    fields::FieldOptions fields = job.fields;
    fields.span.first = found.frame;
    fields.span.stop = found.frame + 1;
    Inspection inspection;
    const fields::FieldSummary summary =
        fields::compute_fields(*clip, fields, [&](const media::SharedFrame& frame, const fields::Field& field) {
            if (field.index == found.frame) inspection = inspect(*frame, field);
        });
    app::report_warnings(warnings, summary.problems, observer);
    const std::string name = job.path.string();
    if (!inspection.captions) {
        observer.warn(fmt::format(
            "fontconfig found no font, so '{}' has no captions; install one, such as fonts-dejavu-core", name));
    }
    const auto held = observer.guard();
    image::write_picture(job.path, inspection.picture);
    observer.info(fmt::format("'{}': frame {} at {:.3f} s{}", name, found.frame, found.seconds, about_choice(job)));
}

namespace inspect_text {
constexpr Setting output{"output", "FILE", "the picture"};
constexpr Setting frame{"frame", "TIME", "the frame; default: the middle of the clip, but at most 60s"};
}  // namespace inspect_text

class Inspect final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        options::AddOptions(line, options::Group::output)(
            inspect_text::output, job_.path,
            {.letter = 'o',
             .help = fmt::format(": {}; or a page to draw --roi and --mask on: .html",
                                 fmt::join(image::picture_file_extensions(), " ")),
             .use = options::FileUse::written});
        options::add_recording_options(line, job_.input, options::clip_input);
        options::AddOptions(line, options::Group::input)(inspect_text::frame, job_.frame);
        options::add_field_options(line, job_.fields);
        options::add_preset_option(line, options::Group::run);
        options::add_thread_options(line, job_.fields.threads);
        line.examples({{"vvr inspect clip.avi --frame 1s -o frame.png", "object, flow and seeds of the frame at 1 s"},
                       {"vvr inspect clip.avi -o roi.html", "a page to draw --roi and --mask on"},
                       {"vvr inspect clip.avi --frame 1s --threshold 40 -o strict.png", "the effect of a threshold"}});
    }

    cli::ExitStatus run(const options::CommandLine&, const cli::Environment& environment) override {
        app::require_input(job_.input);
        if (job_.path.empty())
            throw Error(ErrorCode::output_missing, "no output given; name the file for the picture with -o FILE");
        if (app::is_page(job_.path)) {
            check_file_path(job_.path);
        } else {
            image::check_picture_path(job_.path);
        }
        cli::Console console(environment, false);
        inspect(job_, console);
        return cli::ExitStatus::done;
    }

  private:
    InspectJob job_;
};

}  // namespace

std::unique_ptr<Command> make_inspect() {
    return std::make_unique<Inspect>();
}

}  // namespace vvr::commands
