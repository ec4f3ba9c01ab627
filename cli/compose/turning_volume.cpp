#include "cli/compose/turning_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

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

/// Adds the voxels, as small as the page has room for.
/// \returns how many voxels of the volume each stands for
scene::Block add_voxels(const ComposePlan& plan, const Observation& seen, const Composition& composed, Json& json) {
    const volume::Volume& volume = seen.volume;
    const int side = std::max(volume.size().width, volume.size().height);
    scene::Block block{std::max(1, (side + long_side / 2) / long_side),
                       (volume.layers() + most_layers - 1) / most_layers};
    for (;;) {
        const scene::ReducedVolume small =
            scene::reduced(volume, block, plan.look.drawn_transfer, composed.palette, seen.identify);
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

}  // namespace

Json turning_volume(const ComposePlan& plan, const Observation& seen, const Composition& composed) {
    const LookPlan& look = plan.look;
    const bool can_be = !plan.volume.series && plan.volume.colours_objects() && seen.volume.layers() > 1 &&
                        look.shows(Part::volume) && look.picture.view.fov > 0 &&
                        !look.show.any(&PartRow::around_volume);
    if (!plan.page.turns || !can_be) return {};
    Json json;
    const scene::Block block = add_voxels(plan, seen, composed, json);
    json["frames"] = frames_of(seen.volume, block.depth);
    add_look(plan, seen, composed, json);
    add_scene(plan, composed.scene, json);
    return json;
}

}  // namespace vvr::app
