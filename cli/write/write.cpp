#include "cli/write/write.h"

#include <map>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cli/observe/objects.h"
#include "cli/plan/video_scale.h"
#include "cli/write/golden.h"
#include "core/base/atomic_file.h"
#include "core/base/file.h"
#include "core/base/json_text.h"
#include "core/base/plane.h"
#include "core/base/text.h"
#include "core/image/picture.h"
#include "core/tracking/event.h"
#include "core/tracking/event_line.h"

namespace vvr::app {

namespace {

// The events of a clip as a table, for tools that evaluate trackers.

/// The text of a `--tracks` file in the format of MOT Challenge: frame, number of the event, left, top, width, height,
/// 1, -1, -1, -1. Frames and places count from 1; places are in pixels of the video.
std::string tracks_table(const RunContext& context) {
    const auto& [plan, seen, composed, run] = context;
    if (!seen.events) return {};
    const std::vector<std::optional<std::size_t>> events = tracking::events_of_tracks(seen.events->events);
    // A track may begin before the object came, when its place differed from the empty scene.
    std::map<std::pair<std::int64_t, std::size_t>, PixelBox> boxes;
    for (const TrackBox& one : seen.track_boxes) {
        if (one.track >= events.size() || !events[one.track]) continue;
        const tracking::Event& event = seen.events->events[*events[one.track]];
        if (one.frame < event.first.frame || one.frame > event.last.frame) continue;
        const auto [at, is_new] = boxes.try_emplace({one.frame, *events[one.track]}, one.box);
        if (!is_new) at->second = bounding_box(at->second, one.box);
    }
    // The fields don't show an object that the empty scene has, so its track ends before it lies there.
    for (std::size_t k = 0; k < seen.events->events.size(); ++k) {
        const tracking::Event& event = seen.events->events[k];
        if (!event.in_scene) continue;
        for (std::int64_t frame = event.first.frame; frame <= event.last.frame; ++frame) {
            boxes.try_emplace({frame, k}, event.in_scene->box);
        }
    }
    const VideoScale scale(plan.read.clip.field_size, seen.info.size);
    std::string text;
    for (const auto& [place, field_box] : boxes) {
        const PixelBox box = scale(field_box);
        text += fmt::format("{},{},{},{},{},{},1,-1,-1,-1\n", place.first + 1, seen.events->numbers[place.second],
                            box.left + 1, box.top + 1, box.width(), box.height());
    }
    return text;
}

constexpr int pictures_per_second = 20;  // a GIF's frame time is a whole number of hundredths of a second
constexpr int thumbnail_side = 400;
constexpr int thumbnail_quality = 80;
constexpr int sheet_quality = 66;

void write_text(const std::filesystem::path& file, const std::string& text, Observer& observer) {
    const auto bytes = std::as_bytes(std::span(text));
    const auto held = observer.guard();
    if (is_standard_output(file)) {
        write_standard_output(bytes);
    } else {
        replace_file(file, bytes);
    }
}

/// The text of an `--events-csv` file.
std::string table_of(const Json& report) {
    const Json& input = report.at("input");
    const auto& camera = input.at("camera");
    std::string text = tracking::events_table_heading();
    if (report.at("events").is_null()) return text;
    return text + tracking::events_table_lines(
                      report, {camera.is_null() ? "" : camera.get<std::string>(), input.at("name").get<std::string>()});
}

}  // namespace

PictureOutput::PictureOutput(const OutputOptions& options, Observer& observer)
    : observer_(observer),
      name_(name_of(options)),
      page_(page_of(options)),
      thumbnail_(options.thumbnail),
      still_(options.still),
      stills_(options.stills) {
    if (options.path.empty() || is_standard_output(options.path)) return;
    const auto held = observer.guard();
    if (image::is_animation(options.path) || is_page(options.path)) {
        check_file_path(options.path);
    } else {
        image::check_picture_path(name_.at(0));
    }
    if (image::is_animation(options.path)) animation_.emplace(options.path, pictures_per_second);
}

void PictureOutput::add(int number, image::Picture picture, const image::Metadata& metadata) {
    if (name_.path().empty()) return;
    if (animation_) {
        animation_->add(picture);
        return;
    }
    if (is_standard_output(name_.path())) {
        write_standard_output(image::encode_picture("standard-output.png", std::move(picture), metadata));
        return;
    }
    const auto held = observer_.guard();
    image::write_picture(name_.at(number), std::move(picture), metadata);
}

void PictureOutput::add_thumbnail(const image::Picture& picture, const glm::vec3& ground) {
    if (thumbnail_.empty()) return;
    image::Picture small{image::resized(picture.pixels, fit_into(picture.pixels.size(), thumbnail_side))};
    for (image::Rgba& pixel : small.pixels.pixels()) pixel += image::Rgba(ground, 1) * (1 - pixel.a);
    const std::vector<std::byte> encoded = image::encode_picture(thumbnail_, std::move(small), {}, thumbnail_quality);
    const auto held = observer_.guard();
    replace_file(thumbnail_, encoded);
}

void PictureOutput::add_still(const std::optional<page::Still>& still) {
    if (still_.empty() || !still) return;
    const std::vector<std::byte> encoded = image::encode_picture(still_, still->picture, thumbnail_quality);
    const auto held = observer_.guard();
    replace_file(still_, encoded);
}

void PictureOutput::add_stills(const std::optional<page::ContactSheet>& sheet) {
    if (stills_.empty() || !sheet) return;
    const std::vector<std::byte> encoded = image::encode_picture(stills_, sheet->picture, sheet_quality);
    const auto held = observer_.guard();
    replace_file(stills_, encoded);
}

void PictureOutput::add_page(const std::string& text) {
    const auto held = observer_.guard();
    replace_file(page_, std::as_bytes(std::span(text)));
}

void PictureOutput::close() {
    if (!animation_) return;
    const auto held = observer_.guard();
    animation_->close();
}

void add_lettering(FinishedPicture& finished) {
    if (!finished.context.plan.look.only_page) annotation::draw(finished.picture, finished.context.composed.lettering);
}

void Writer::write(FinishedPicture&& finished, Kept&& kept) {
    const Plan& plan = finished.context.plan;
    const bool has_page = !plan.page.path.empty();
    const bool is_alone = !has_page || !plan.look.only_page;
    page::PageContent content = std::move(kept.page);
    if (has_page && is_alone) content.picture = finished.picture;
    add_lettering(finished);
    image::Picture& picture = finished.picture;
    const image::Metadata record = record_of(finished.context);
    if (on_picture_) on_picture_(picture, record);
    if (!plan.output.files.golden.path.empty()) last_ = {picture.pixels};
    files_.add_thumbnail(picture, plan.look.theme.background);
    if (!kept.moments.problem.empty()) {
        observer_.warn(fmt::format("the page has stills but no video preview, because FFmpeg could not encode one: {}",
                                   kept.moments.problem));
    }
    const std::optional<ShownEvents>& shown = finished.context.seen.events;
    const std::span<const tracking::Event> events =
        shown ? std::span<const tracking::Event>(shown->events) : std::span<const tracking::Event>();
    files_.add_still(page::best_still(kept.moments.stills, events));
    if (files_.wants_stills()) {
        const std::optional<page::ContactSheet> sheet = page::contact_sheet(kept.moments.stills, events);
        files_.add_stills(sheet);
        if (sheet) tiles_ = sheet->seconds;
    }
    if (has_page && !is_alone) content.picture = std::move(picture);
    if (is_alone && !(has_page && is_page(plan.output.files.path)))
        files_.add(finished.number, std::move(picture), record);
    if (!has_page) return;
    content.settings = record;
    content.moments = std::move(kept.moments);
    files_.add_page(page::make_page(content));
}

void Writer::finish(const RunContext& context, double seconds, const KeptEvents& kept) {
    const OutputOptions& output = context.plan.output.files;
    const std::vector<std::string> advice = advice_on(context.plan, context.seen);
    log_warnings(context, advice, observer_);
    files_.close();
    observer_.info(fmt::format("{}, {:.1f} s", result_text(context), seconds));
    if (context.plan.field.lists_events && context.seen.events)
        observer_.info(
            events_summary(context.seen.events->events, context.seen.not_chosen.size(), context.plan.read.clock));
    if (!output.report.empty() || !output.events_csv.empty()) {
        const std::string report = format_report(context, advice, seconds, {tiles_, kept.problem, kept.code});
        if (!output.report.empty()) write_text(output.report, report, observer_);
        if (!output.events_csv.empty()) write_text(output.events_csv, table_of(parse_json(report)), observer_);
    }
    if (!output.tracks.empty()) write_text(output.tracks, tracks_table(context), observer_);
    if (!output.golden.path.empty()) compare_with_golden(output.golden, last_, record_of(context), observer_);
}

}  // namespace vvr::app
