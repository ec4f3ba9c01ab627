#include "cli/compose/page_content.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/annotation/portraits.h"
#include "core/annotation/ruler.h"
#include "core/annotation/scene_map.h"
#include "core/annotation/time_ticks.h"
#include "core/base/json_text.h"
#include "core/image/picture.h"
#include "core/image/picture_file.h"
#include "core/page/html.h"
#include "core/scene/reduced_volume.h"
#include "core/scene/theme.h"

namespace vvr::app {

namespace {

/// A page whose picture turns has at most 350 kB more: these, and arrows, colours and two stills.
constexpr std::size_t most_letters = 310'000;
constexpr int long_side = 128;  // voxels
constexpr std::int64_t most_layers = 400;
constexpr int end_side = 240;  // pixels
constexpr int end_quality = 66;

/// Four digits are finer than a pixel.
double rounded4(double value) {
    return std::round(value * 1e4) / 1e4;
}

template <class Vector>
Json json_of(const Vector& vector) {
    Json json = Json::array();
    for (int i = 0; i < Vector::length(); ++i) json.push_back(rounded4(static_cast<double>(vector[i])));
    return json;
}

/// The low bytes, then the high bytes: alike stands beside alike.
std::vector<std::uint8_t> bytes_of(std::span<const std::uint16_t> owners) {
    std::vector<std::uint8_t> bytes(owners.size() * 2);
    for (std::size_t k = 0; k < owners.size(); ++k) {
        bytes[k] = static_cast<std::uint8_t>(owners[k] & 0xFFU);
        bytes[owners.size() + k] = static_cast<std::uint8_t>(owners[k] >> 8U);
    }
    return bytes;
}

/// Which event of the page's list each voxel shows, as its index plus 1. A stream counts its events from its beginning.
volume::VoxelStyleLookup by_place(const ComposePlan& plan, const Observation& seen) {
    if (!plan.volume.series || !seen.events) return seen.identify;
    std::map<std::uint16_t, std::uint16_t> places;
    for (std::size_t k = 0; k < seen.events->numbers.size(); ++k)
        places[static_cast<std::uint16_t>(seen.events->numbers[k])] = static_cast<std::uint16_t>(k + 1);
    return [places = std::move(places), &seen](std::size_t track, const volume::Layer& layer) {
        volume::VoxelStyle style = seen.identify(track, layer);
        const auto found = places.find(style.number);
        style.number = found == places.end() ? std::uint16_t{0} : found->second;
        return style;
    };
}

/// Adds the voxels, as small as the page has room for.
/// \returns how many voxels of the volume each stands for
scene::Block add_voxels(const ComposePlan& plan, const Observation& seen, const Composition& composed, Json& json) {
    const volume::Volume& volume = seen.volume;
    const volume::VoxelStyleLookup identify = by_place(plan, seen);
    const int side = std::max(volume.size().width, volume.size().height);
    scene::Block block{std::max(1, (side + long_side / 2) / long_side),
                       (volume.layers() + most_layers - 1) / most_layers};
    for (;;) {
        const scene::ReducedVolume small =
            scene::reduced(volume, block, plan.look.drawn_transfer, composed.palette, identify);
        std::string levels = page::deflated_base64(small.levels);
        std::string owners = page::deflated_base64(bytes_of(small.owners));
        const double too_large = static_cast<double>(levels.size() + owners.size()) / most_letters;
        if (too_large <= 1 || block.side >= side) {
            const auto scale = [](auto count, auto one, auto blocks) {
                return static_cast<double>(count) / static_cast<double>(one * blocks);
            };
            json["size"] = {small.size.width, small.size.height, small.layers};
            json["scale"] = {scale(volume.size().width, block.side, small.size.width),
                             scale(volume.size().height, block.side, small.size.height),
                             scale(volume.layers(), block.depth, small.layers) / volume.t_end()};
            json["values"] = small.values;
            json["levels"] = std::move(levels);
            json["owners"] = std::move(owners);
            return block;
        }
        ++block.side;
        if (too_large > 2) block.depth = std::llround(std::ceil(static_cast<double>(block.depth) * too_large / 2));
    }
}

/// The first frame of each layer of voxels, then the last frame of the last one.
Json frames_of(const volume::Volume& volume, std::int64_t depth) {
    Json frames = Json::array();
    for (std::int64_t layer = 0; layer < volume.layers(); layer += depth)
        frames.push_back(volume.layer(layer).first_frame);
    frames.push_back(volume.layer(volume.layers() - 1).last_frame);
    return frames;
}

Json json_of_scheme(const scene::Theme& theme, float unowned) {
    std::vector<glm::vec4> palette = scene::object_palette(theme);
    palette.front().a = unowned;
    return {{"palette", list_of(palette, [](const glm::vec4& colour) { return json_of(colour); })},
            {"lines", json_of(theme.lines)},
            {"arrows", json_of(theme.ink)}};
}

/// Tail and tip in C-space.
Json json_of_arrow(const scene::Glyph& glyph, const space::Layout& layout) {
    Json json = json_of(layout.c_from_p(glyph.from));
    for (const Json& value : json_of(layout.c_from_p(glyph.from + glyph.vector))) json.push_back(value);
    return json;
}

std::string url_of_end(const scene::StandingFrame& end) {
    const Plane<Bgr> small = image::resized(end.picture, fit_into(end.picture.size(), end_side));
    return page::data_url("image/jpeg", image::encode_picture("end.jpg", small, end_quality));
}

/// How the picture shows the volume.
void add_look(const ComposePlan& plan, const Observation& seen, const Composition& composed, Json& json) {
    const LookPlan& look = plan.look;
    const space::LayoutShape& shape = look.layout->shape();
    const space::View& view = look.picture.view;
    const PixelBox& part = composed.framing.sheet.volume;
    json["layout"] = look.shape->name;
    json["shape"] = {shape.r_min, shape.r_max, shape.y_s};
    json["view"] = {view.azimuth, view.elevation, view.fov,
                    composed.framing.sheet.text > 0 ? sheet_margin : view.margin};
    json["part"] = {part.left, part.top, part.right, part.bottom};
    json["shows"] = {
        {"outline", look.shows(Part::outline)}, {"ribs", look.shows(Part::ribs)}, {"ruler", look.shows(Part::ruler)}};
    json["ticks"] = list_of(composed.ticks, [&](const annotation::TimeTick& tick) {
        return rounded4(seen.volume.t_of_seconds(tick.seconds));
    });
    json["end"] = seen.volume.t_end();
    json["relief"] = look.picture.shading == gl::VolumeShading::relief;
    json["extinction"] = Json::array();
    for (int value = 0; value < 256; ++value) json["extinction"].push_back(rounded4(look.drawn_transfer.at(value).w));
    const float unowned = composed.palette.front().a;
    const scene::Theme& dark = *std::ranges::find(scene::themes(), "dark", &scene::Theme::name);
    json["schemes"] = {json_of_scheme(look.theme, unowned), json_of_scheme(dark, unowned)};
    json["colours"] = seen.events ? seen.events->colours : std::vector<int>();
}

/// What stands in it.
void add_scene(const ComposePlan& plan, const scene::Scene& scene, Json& json) {
    const scene::GlyphMesh mesh = scene::arrow_mesh();
    json["arrow"] = {{"vertices", page::base64(std::as_bytes(std::span(mesh.vertices)))}, {"indices", mesh.indices}};
    json["thickness"] = plan.look.picture.glyphs.thickness;
    json["arrows"] =
        list_of(scene.arrows, [&](const scene::Glyph& glyph) { return json_of_arrow(glyph, *plan.look.layout); });
    const auto& frames = scene.frames;
    json["ends"] = frames.empty() ? Json::array() : Json{url_of_end(frames.front()), url_of_end(frames.back())};
    json["opacity"] = frames.empty() ? 0 : frames.front().opacity;
}

/// The volume that the page of a composition turns, as its script reads it (TurningVolume in core/web/page/data.js).
/// Null without objects, or if the user wants none.
Json turning_volume(const ComposePlan& plan, const Observation& seen, const Composition& composed) {
    const LookPlan& look = plan.look;
    const bool can_be = plan.volume.colours_objects() && seen.volume.layers() > 1 && look.shows(Part::volume) &&
                        look.picture.view.fov > 0 && !look.show.any(&PartRow::around_volume);
    if (!plan.page.turns || !can_be) return {};
    Json json;
    const scene::Block block = add_voxels(plan, seen, composed, json);
    json["frames"] = frames_of(seen.volume, block.depth);
    add_look(plan, seen, composed, json);
    add_scene(plan, composed.scene, json);
    return json;
}

/// Cross-sections of the volume, evenly spread over the time axis: enough for straight lines between them.
std::vector<page::Overlay::Section> sections_of(const ComposePlan& plan, const Observation& seen,
                                                const space::Camera& camera) {
    constexpr std::int64_t most = 192;
    const volume::Volume& volume = seen.volume;
    std::vector<page::Overlay::Section> sections;
    const std::int64_t count = std::min(most, volume.layers());
    for (std::int64_t k = 0; k <= count && count > 0; ++k) {
        const std::int64_t layer = k * volume.layers() / count;
        const bool at_end = layer == volume.layers();
        page::Overlay::Section section;
        section.seconds = at_end ? volume.layer(layer - 1).last_pts : volume.layer(layer).pts;
        const double t = at_end ? volume.t_end() : volume.t_of_layer(layer);
        // The corners of the frame in order: upper left, upper right, lower right, lower left.
        constexpr std::array<std::pair<double, double>, 4> corners{{{1, 1}, {0, 1}, {0, 0}, {1, 0}}};
        for (std::size_t corner = 0; corner < corners.size(); ++corner) {
            const auto& [x, y] = corners[corner];
            section.corners[corner] = camera.pixel(plan.look.layout->p_from_c({x, y, t}), plan.look.picture.size);
        }
        sections.push_back(section);
    }
    return sections;
}

/// The texts along the ruler, the most important first.
std::vector<page::Overlay::Note> notes_of(const ComposePlan& plan, const Observation& seen,
                                          const Composition& composed) {
    std::vector<page::Overlay::Note> notes;
    if (!plan.look.shows(Part::ruler)) return notes;
    const volume::Volume& volume = seen.volume;
    const Framing& framing = composed.framing;
    const auto add = [&](const std::string& text, double t) {
        const annotation::MarkInPicture mark =
            annotation::mark_in_picture(*plan.look.layout, framing.edge, t, framing.camera, plan.look.picture.size);
        notes.push_back({text, t, mark.end, mark.out});
    };
    for (const annotation::TimeGap& gap : explained_gaps(plan, seen)) add(gap.reason, (gap.t_begin + gap.t_end) / 2);
    const std::vector<annotation::TimeTick>& ticks = composed.ticks;
    if (!ticks.empty()) add(ticks.front().text, volume.t_of_seconds(ticks.front().seconds));
    for (std::size_t k = ticks.size(); k-- > 1;) add(ticks[k].text, volume.t_of_seconds(ticks[k].seconds));
    for (const annotation::TimeBreak& gap : annotation::time_breaks(volume, breaks_shown))
        add(fmt::format("{} idle", annotation::format_duration(gap.seconds)), gap.t);
    return notes;
}

/// The object in its still, with as much around it as the corners in a picture.
glm::dvec4 object_in(const annotation::ObjectPicture& still) {
    const glm::dvec2 size(still.picture.width(), still.picture.height());
    const double around = 2 * still.scale;
    const glm::dvec2 low = (glm::dvec2(still.object.left, still.object.top) - around) / size;
    const glm::dvec2 high = (glm::dvec2(still.object.right, still.object.bottom) + around) / size;
    return glm::clamp(glm::dvec4(low, high), 0.0, 1.0);
}

std::vector<page::Overlay::Portrait> portraits_of(const ComposePlan& plan, const Observation& seen,
                                                  const Composition& composed) {
    std::vector<page::Overlay::Portrait> portraits;
    if (!plan.look.shows(Part::portraits) || composed.framing.sheet.text == 0) return portraits;
    const annotation::Objects& objects = composed.objects;
    const annotation::Trails trails(seen.volume, *plan.look.layout, composed.framing.camera, plan.look.picture.size);
    std::vector<std::size_t> all(objects.events.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    for (const annotation::EventPortrait& placed : annotation::event_portraits(
             objects, std::set(all.begin(), all.end()), seen.crops, trails, composed.framing.sheet, {}, 0)) {
        portraits.push_back({placed.event, placed.still, object_in(placed.crop->still()), placed.to});
    }
    return portraits;
}

/// What the page draws over its picture: where moments, portraits and the map are in it.
page::Overlay overlay_of(const ComposePlan& plan, const Observation& seen, const Composition& composed) {
    const annotation::Sheet& sheet = composed.framing.sheet;
    page::Overlay overlay;
    overlay.sections = sections_of(plan, seen, composed.framing.camera);
    overlay.notes = notes_of(plan, seen, composed);
    overlay.portraits = portraits_of(plan, seen, composed);
    overlay.captions = sheet.captions;
    overlay.numbers = plan.look.shows(Part::numbers);
    if (plan.look.shows(Part::map) && !seen.scene.empty() && sheet.text > 0) {
        const Size field = plan.read.clip.field_size;
        overlay.map = annotation::map_box(*plan.look.layout, composed.framing.camera, sheet.picture, sheet.map_area,
                                          static_cast<double>(field.width) / field.height);
        if (!overlay.map.empty()) overlay.scene = image::resized(seen.scene, overlay.map.size());
    }
    return overlay;
}

/// The page's place in the archive of an index in a parent folder. An archive names a page after its clip.
page::PageIndex index_of(const std::filesystem::path& page, const std::filesystem::path& index) {
    const std::string below = page::relative_url(index, page);
    return {page::relative_url(page, index), below.substr(0, below.size() - page.extension().string().size())};
}

/// The file name to show in small print; empty if the page already shows it.
std::string file_name_of(const ComposePlan& plan, const media::VideoInfo& info, const page::PageContent& content) {
    const std::string& file = plan.page.file;
    if (plan.read.input.names.size() > 1)
        return info.unread > 0 ? fmt::format("{}, {} could not be read", file, info.unread) : file;
    return content.camera.empty() && content.name == file ? "" : file;
}

}  // namespace

page::PageContent page_content(const ComposePlan& plan, const Observation& seen, const Composition& composed) {
    const PagePlan& page = plan.page;
    const bool titled = page.is_titled || !seen.info.segments.empty();
    page::PageContent content;
    content.name = plan.look.title;
    content.camera = page.camera.empty() && titled ? std::string() : plan.read.camera;
    content.heading = page.heading;
    content.file = file_name_of(plan, seen.info, content);
    for (const media::SegmentPlace& segment : seen.info.segments) {
        if (segment.end <= segment.begin) continue;  // entirely overlapped by another file
        content.segments.push_back(
            {page::relative_url(page.path, segment.path), segment.begin, segment.end - segment.begin});
    }
    if (page.plays_file) content.clip_url = page::relative_url(page.path, plan.read.input.names.front());
    content.stretch = seen.info.stretch;
    content.piece_extension = page.file_ending;
    content.names = plan.read.input.name_patterns;
    content.shown = seen.info.size;
    content.field = plan.read.clip.field_size;
    content.span = plan.read.span;
    content.missing = seen.missing;
    content.clock = plan.read.clock;
    if (seen.events) {
        content.events = seen.events->events;
        for (const tracking::Event& event : *content.events)
            content.activities.push_back(annotation::activity_text(event));
        if (plan.volume.series) content.numbers = seen.events->numbers;
        content.colours = composed.objects.colours;
        content.not_chosen = seen.not_chosen.size();
        content.portraits = annotation::portraits_of(seen.events->events, seen.crops);
    }
    content.unseen = unseen_of(plan, seen);
    if (!page.index.empty()) content.index = index_of(page.path, page.index);
    content.overlay = overlay_of(plan, seen, composed);
    content.turning = turning_volume(plan, seen, composed);
    return content;
}

}  // namespace vvr::app
