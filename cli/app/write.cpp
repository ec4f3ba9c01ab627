#include "cli/app/write.h"

#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/app/event_tables.h"
#include "cli/app/golden.h"
#include "cli/app/input.h"
#include "cli/app/overlay.h"
#include "cli/app/report.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_text.h"
#include "core/base/plane.h"
#include "core/base/text.h"
#include "core/footage/recorder_names.h"
#include "core/footage/recording.h"
#include "core/image/picture.h"
#include "core/media/container.h"
#include "core/page/html.h"
#include "core/tracking/event_table.h"

namespace vvr::app {

namespace {

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
std::string table_of(const nlohmann::ordered_json& report) {
    const nlohmann::ordered_json& input = report.at("input");
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

namespace fs = std::filesystem;

namespace {

/// The page's place in the archive of an index in a parent folder. An archive names a page after its clip.
page::PageIndex index_of(const fs::path& page, const fs::path& index) {
    const std::string below = page::relative_url(index, page);
    return {page::relative_url(page, index), below.substr(0, below.size() - page.extension().string().size())};
}

/// The camera to show on the page; empty if it is unknown, or in the title already.
std::string page_camera_of(const RenderJob& job, const media::VideoInfo& info) {
    const bool titled = !job.look.title.empty() || !info.segments.empty();
    return job.output.page_camera.empty() && titled ? std::string() : camera_of(job, info);
}

/// The file name to show in small print; empty if the page already shows it.
std::string file_name_of(const RenderJob& job, const media::VideoInfo& info, const page::PageContent& content) {
    if (job.input.names.size() > 1) {
        const std::string files = counted(std::ssize(job.input.names), "file");
        return info.unread > 0 ? fmt::format("{}, {} could not be read", files, info.unread) : files;
    }
    const std::string file = shown_name(job.input.names.front());
    return content.camera.empty() && content.name == file ? "" : file;
}

/// The file extension for pieces cut from the clip; empty = unknown.
std::string cut_extension(const std::string& file, double rate) {
    std::error_code none;
    if (!fs::is_regular_file(file, none)) return {};
    try {
        return std::string(media::extension_for(media::open_input(file), rate));
    } catch (const Error&) {
        return {};
    }
}

}  // namespace

std::string page_text(const RunContext& context, image::Picture picture, const image::Metadata& settings,
                      page::Moments moments, const std::optional<page::LiveState>& live,
                      std::span<const WrittenPiece> pieces) {
    const auto& [plan, seen, composed, run] = context;
    const RenderJob& job = plan.job;
    std::error_code none;
    const fs::path& path = job.output.page_place.empty() ? page_of(job.output) : job.output.page_place;
    const std::string& input = job.input.names.front();
    page::PageContent content;
    content.name = plan.title;
    content.camera = page_camera_of(job, seen.info);
    content.heading = job.output.page_heading;
    content.file = file_name_of(job, seen.info, content);
    for (const media::SegmentPlace& segment : seen.info.segments) {
        if (segment.end <= segment.begin) continue;  // entirely overlapped by another file
        content.segments.push_back(
            {page::relative_url(path, segment.path), segment.begin, segment.end - segment.begin});
    }
    for (const WrittenPiece& piece : pieces) {
        content.pieces.push_back({page::relative_url(path, job.output.pieces.place / piece.file), piece.facts.begin,
                                  piece.facts.until - piece.facts.begin});
    }
    const bool is_file = !live && content.segments.empty() && fs::is_regular_file(input, none);
    if (is_file) content.clip_url = page::relative_url(path, input);
    const std::string& first_file = content.segments.empty() ? input : seen.info.segments.front().path;
    if (!live) content.piece_extension = cut_extension(first_file, job.input.rate);
    content.names = job.input.name_patterns;
    content.shown = seen.info.size;
    content.field = plan.clip.field_size;
    content.picture = std::move(picture);
    content.settings = settings;
    content.time_direction = job.layout->time_direction;
    content.moments = std::move(moments);
    content.span = job.fields.span;
    content.missing = seen.missing;
    content.clock = plan.clock;
    if (seen.events) {
        content.events = seen.events->events;
        for (const tracking::Event& event : *content.events) content.deeds.push_back(annotation::deed_of(event));
        if (plan.products.series) content.numbers = seen.events->numbers;
        content.colours = composed.objects.colours;
        content.not_chosen = seen.not_chosen.size();
        if (plan.products.portraits) content.portraits = annotation::portraits_of(seen.events->events, seen.crops);
    }
    content.live = live;
    content.unseen = unseen_of(plan, seen);
    if (live) content.unseen.dropped = live->dropped;
    if (!job.output.page_index.empty()) content.index = index_of(path, job.output.page_index);
    content.overlay = overlay_of(plan, seen, composed);
    return page::make_page(content);
}

void add_lettering(FinishedPicture& finished) {
    if (!finished.context.plan.products.only_page)
        annotation::draw(finished.picture, finished.context.composed.lettering);
}

void Writer::write(FinishedPicture&& finished) {
    const Plan& plan = finished.context.plan;
    const OutputOptions& output = plan.job.output;
    const bool also_page = !page_of(output).empty() && !plan.products.only_page;
    image::Picture bare = also_page ? finished.picture : image::Picture{};
    add_lettering(finished);
    image::Picture& picture = finished.picture;
    const image::Metadata record = record_of(finished.context);
    if (on_picture_) on_picture_(picture, record);
    if (!output.golden.path.empty()) last_ = {picture.pixels};
    files_.add_thumbnail(picture, plan.job.look.theme.background);
    page::Moments moments = watched_ == nullptr ? page::Moments{} : watched_->take();
    if (!moments.problem.empty()) {
        observer_.warn(fmt::format("the page has stills but no video preview, because FFmpeg could not encode one: {}",
                                   moments.problem));
    }
    const std::optional<ShownEvents>& shown = finished.context.seen.events;
    const std::span<const tracking::Event> events =
        shown ? std::span<const tracking::Event>(shown->events) : std::span<const tracking::Event>();
    files_.add_still(page::best_still(moments.stills, events));
    if (files_.wants_stills()) {
        const std::optional<page::ContactSheet> sheet = page::contact_sheet(moments.stills, events);
        files_.add_stills(sheet);
        if (sheet) tiles_ = sheet->seconds;
    }
    if (!output.pieces.folder.empty()) {
        const RunContext& context = finished.context;
        kept_ = keep_events(context.plan, context.seen, camera_of(context.plan.job, context.seen.info), observer_);
    }
    if (page_of(output).empty()) {
        files_.add(finished.number, std::move(picture), record);
        return;
    }
    if (!also_page) {
        bare = std::move(picture);
    } else if (!is_page(output.path)) {
        files_.add(finished.number, std::move(picture), record);
    }
    files_.add_page(page_text(finished.context, std::move(bare), record, std::move(moments), {}, kept_.pieces));
}

void Writer::finish(const RunContext& context, double seconds) {
    const OutputOptions& output = context.plan.job.output;
    const std::vector<std::string> advice = advice_on(context.plan, context.seen);
    log_warnings(context, advice, observer_);
    files_.close();
    observer_.info(fmt::format("{}, {:.1f} s", result_text(context), seconds));
    if (context.plan.products.events && context.seen.events)
        observer_.info(events_summary(context.seen.events->events, context.seen.not_chosen.size(), context.plan.clock));
    if (!output.report.empty() || !output.events_csv.empty()) {
        const std::string report = format_report(context, advice, seconds, {tiles_, kept_.problem, kept_.code});
        if (!output.report.empty()) write_text(output.report, report, observer_);
        if (!output.events_csv.empty()) write_text(output.events_csv, table_of(parse_json(report)), observer_);
    }
    if (!output.tracks.empty()) write_text(output.tracks, tracks_table(context), observer_);
    if (!output.golden.path.empty()) compare_with_golden(output.golden, last_, record_of(context), observer_);
}

}  // namespace vvr::app
