#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/compose/compose.h"
#include "core/annotation/portraits.h"
#include "core/annotation/ruler.h"
#include "core/annotation/scene_map.h"
#include "core/annotation/time_strip.h"
#include "core/base/text.h"
#include "core/fields/field.h"
#include "core/fields/region.h"
#include "core/scene/slices.h"
#include "core/scene/theme.h"
#include "core/tracking/colouring.h"

namespace vvr::app {

namespace {

image::Rgba rgba(const glm::vec3& colour) {
    return {colour.x, colour.y, colour.z, 1};
}

std::vector<image::Rgba> gradient(const glm::vec3& from, const glm::vec3& to) {
    constexpr int steps = 64;
    std::vector<image::Rgba> colours;
    for (int i = 0; i < steps; ++i) colours.push_back(rgba(glm::mix(from, to, static_cast<float>(i) / (steps - 1))));
    return colours;
}

/// The colours of values, as seen through an object about as thick as a person's track.
std::vector<image::Rgba> transfer_gradient(const scene::TransferFunction& transfer, int low,
                                           const glm::vec4& background) {
    std::vector<image::Rgba> colours;
    for (int value = low; value < 256; ++value) {
        const glm::dvec4 at = transfer.at(value);
        const auto opacity = static_cast<float>(1 - std::exp(-at.w * scene::opacity_unit_distance * 2));
        const glm::vec4 colour = glm::vec4(glm::vec3(at) * opacity, opacity) + background * (1 - opacity);
        colours.push_back({colour.x, colour.y, colour.z, colour.w});
    }
    return colours;
}

int first_visible(const scene::TransferFunction& transfer) {
    int value = 0;
    while (value < 255 && !transfer.visible({0, static_cast<std::uint8_t>(value)})) ++value;
    return value;
}

std::vector<image::Rgba> colours_of_objects(const scene::Theme& theme) {
    std::vector<image::Rgba> colours;
    for (const glm::vec3& colour : theme.objects) colours.push_back(rgba(colour));
    return colours;
}

/// One entry per band: its colour and meaning.
std::vector<annotation::LegendEntry> legend_of_bands(const scene::TransferFunction& transfer) {
    constexpr std::array<std::pair<fields::Band, std::string_view>, 3> bands{
        {{fields::Band::newly_covered, "newly covered"},
         {fields::Band::still_covered, "still covered"},
         {fields::Band::uncovered, "uncovered"}}};
    std::vector<annotation::LegendEntry> entries;
    for (const auto& [band, name] : bands) {
        const glm::dvec4 at = transfer.at(static_cast<int>(band));
        if (at.w > 0) entries.push_back({{rgba(glm::vec3(at))}, std::string(name), std::string(name)});
    }
    return entries;
}

/// The entries for volume colours that don't come from the transfer function.
std::vector<annotation::LegendEntry> legend_of_colour(const ComposePlan& plan) {
    const ColourRow& row = *plan.volume.colour;
    if (row.needs_pictures) return {{{}, "in the video's own colours", "video"}};
    if (row.drawn == gl::VolumeColour::time) {
        std::vector<image::Rgba> colours;
        for (const glm::vec4& colour : scene::time_colours()) colours.push_back(rgba(glm::vec3(colour)));
        return {{std::move(colours), "time, from the first moment to the last", "time"}};
    }
    if (row.of_direction) {
        constexpr int spokes = 48;
        std::vector<image::Rgba> colours;
        for (int i = 0; i < spokes; ++i) {
            const double angle = 2 * std::numbers::pi * i / spokes;
            colours.push_back(rgba(scene::direction_colour({std::cos(angle), -std::sin(angle)})));
        }
        return {{std::move(colours), "which way it moves in the view of the camera", "direction", true},
                {{rgba(plan.look.theme.unowned)}, "at rest", "at rest"}};
    }
    if (row.needs_flow) {
        return {
            {gradient(plan.look.theme.slow, plan.look.theme.fast), "how fast it moves: slow to fast", "slow to fast"}};
    }
    const scene::TransferFunction& transfer = plan.volume.second_transfer;
    const fields::FilterRow& second = *plan.volume.colour->filter;
    if (second.traits.values == fields::Values::band) return legend_of_bands(transfer);
    std::vector<image::Rgba> colours;
    for (int value = second.traits.values == fields::Values::sign ? 1 : 0; value < 256; ++value) {
        colours.push_back(rgba(glm::vec3(transfer.at(value))));
    }
    return {{std::move(colours), fmt::format("colour: {}, little to much", second.help), std::string(second.name)}};
}

/// The entries for colours from the transfer function.
std::vector<annotation::LegendEntry> legend_of_transfer(const ComposePlan& plan) {
    const fields::FilterRow& filter = *plan.field.filter;
    switch (filter.traits.values) {
        case fields::Values::band:
            return legend_of_bands(plan.look.drawn_transfer);
        case fields::Values::sign:
            return {{transfer_gradient(plan.look.drawn_transfer, 1, plan.look.picture.background),
                     "darker to brighter than the empty scene", "darker to brighter"}};
        case fields::Values::strength:
            break;
    }
    return {
        {transfer_gradient(plan.look.drawn_transfer, first_visible(plan.look.transfer), plan.look.picture.background),
         fmt::format("{}: little to much", filter.help), std::string(filter.name)}};
}

/// Whether two objects of the picture have the same colour.
bool shares_colours(const Composition& composed) {
    const auto& colours = composed.objects.colours;
    for (auto one = colours.begin(); one != colours.end(); ++one) {
        if (std::find(one + 1, colours.end(), *one) != colours.end()) return true;
    }
    return false;
}

std::vector<annotation::LegendEntry> legend_of_volume(const ComposePlan& plan, const Observation& seen,
                                                      const Composition& composed) {
    if (plan.volume.colour->drawn == gl::VolumeColour::transfer) return legend_of_transfer(plan);
    if (!plan.volume.colours_objects()) return legend_of_colour(plan);
    std::string meaning = shares_colours(composed) ? "colours of objects" : "a colour for each object";
    // In a series, voxels get their colours before it is known where their object stays.
    if (!plan.volume.series)
        meaning += shares_colours(composed) ? ", striped where one stayed" : ", striped where it stayed";
    const bool is_light = plan.look.shows(Part::strip) &&
                          std::ranges::any_of(unseen_of(plan, seen).intervals, [](const condition::Interval& interval) {
                              return interval.kind == condition::Kind::light;
                          });
    return {{colours_of_objects(plan.look.theme), meaning, "objects"},
            {{rgba(plan.look.theme.unowned)},
             is_light ? "other changes, of light where hatched" : "other changes",
             "other"}};
}

/// The legend: the meaning of a picture's colours.
std::vector<annotation::LegendEntry> legend_of(const ComposePlan& plan, const Observation& seen,
                                               const Composition& composed) {
    std::vector<annotation::LegendEntry> entries;
    if (plan.look.shows(Part::volume)) entries = legend_of_volume(plan, seen, composed);
    const gl::GlyphStyle& style = plan.look.picture.glyphs;
    const auto flow = [&](const std::string& what) {
        return annotation::LegendEntry{gradient(style.slow_colour, style.fast_colour),
                                       fmt::format("{}: slow to fast", what), "slow to fast"};
    };
    if (plan.look.shows(Part::arrows) || (plan.look.shows(Part::directions) && !plan.volume.colours_objects())) {
        entries.push_back(flow("which way it went"));
    } else if (plan.look.shows(Part::tracelines)) {
        entries.push_back(flow("paths of the flow"));
    }
    return entries;
}

/// Adds text around the volume, the most important first. Later items get the room that is left.
class Annotator {
  public:
    Annotator(const ComposePlan& plan, const Observation& seen, const Composition& composed)
        : plan_(plan),
          seen_(seen),
          composed_(composed),
          sheet_(composed.framing.sheet),
          camera_(composed.framing.camera),
          ink_(rgba(plan.look.theme.ink)),
          pale_(rgba(plan.look.theme.pale_ink)),
          lines_(rgba(plan.look.theme.lines)),
          background_(plan.look.picture.background) {}

    annotation::Lettering write() {
        lettering_.font_missing = sheet_.text > 0 && !image::measure_text("0", sheet_.text);
        add_title_and_legend();
        if (sheet_.text == 0) return std::move(lettering_);
        add_ruler();
        if (composed_.nothing_moves) add_nothing_moves();
        if (plan_.look.shows(Part::explanation)) add_explanation();
        if (plan_.look.shows(Part::ends)) {
            add_end("first frame", *seen_.first, seen_.begin.seconds, sheet_.first, false);
            add_end("last frame", *seen_.last, seen_.end().seconds, sheet_.last, true);
            annotation::label_stills(composed_.objects, seen_.stills, plan_.read.clip.field_size, sheet_, pale_, lines_,
                                     lettering_);
        }
        add_objects();
        add_seen_from_behind();
        return std::move(lettering_);
    }

  private:
    void add_title_and_legend() {
        const std::vector<annotation::LegendEntry> legend = plan_.look.shows(Part::legend)
                                                                ? legend_of(plan_, seen_, composed_)
                                                                : std::vector<annotation::LegendEntry>{};
        const bool in_one_band = !legend.empty() && sheet_.legend == sheet_.title;
        const int right = sheet_.title.right - (in_one_band ? annotation::brief_width(legend, sheet_) : 0);
        annotation::label_title(plan_.look.title, length_text(), right, sheet_, ink_, pale_, lettering_);
        annotation::label_legend(legend, sheet_, pale_, lettering_);
    }

    std::string length_text() const {
        const std::int64_t frames = seen_.volume.frames() - seen_.volume.missing();
        std::string text = fmt::format(
            "{}, {}", counted(frames, "frame"),
            annotation::format_interval_and_zone(seen_.begin.seconds, seen_.end().seconds, plan_.read.clock));
        double idle = 0;
        for (const volume::CompressedIdle& stretch : composed_.compressed_idle) idle += stretch.seconds;
        if (idle > 0) text += fmt::format("; {} without motion are shortened", annotation::format_duration(idle));
        const auto moment = [this](double seconds) { return annotation::format_moment(seconds, plan_.read.clock); };
        for (const std::string& words : words_of(unseen_of(plan_, seen_), moment)) text += "; " + words;
        return text;
    }

    void add_ruler() {
        if (!plan_.look.shows(Part::ruler)) return;
        const annotation::TimeEdge& edge = composed_.framing.edge;
        const std::vector<annotation::TimeGap> gaps = explained_gaps(plan_, seen_);
        const bool is_lost =
            std::ranges::any_of(gaps, [](const annotation::TimeGap& gap) { return gap.reason.ends_with("no signal"); });
        annotation::label_gaps(gaps, *plan_.look.layout, edge, camera_, sheet_,
                               is_lost ? rgba(plan_.look.theme.fast) : pale_, lettering_);
        const std::span<const annotation::TimeTick> ticks = composed_.ticks;
        const auto label = [&](std::span<const annotation::TimeTick> some) {
            annotation::label_ticks(seen_.volume, *plan_.look.layout, edge, some, camera_, sheet_, ink_, lettering_);
        };
        // The texts that matter most come first, as later ones have to fit between them.
        if (!ticks.empty()) label(ticks.first(1));
        if (ticks.size() > 1) label(ticks.last(1));
        annotation::label_breaks(annotation::time_breaks(seen_.volume, breaks_shown), *plan_.look.layout, edge, camera_,
                                 sheet_, pale_, lettering_);
        if (ticks.size() > 2) label(ticks.subspan(1, ticks.size() - 2));
    }

    /// Writes into the middle of an empty volume, which would otherwise look like an error.
    void add_nothing_moves() {
        const PixelBox& box = sheet_.volume;
        const std::string text = plan_.field.has_region ? "nothing moves in the region of interest" : "nothing moves";
        lettering_.add(annotation::make_centred_label(text, sheet_.text * 2, (box.left + box.right) / 2.0,
                                                      (box.top + box.bottom) / 2.0, pale_),
                       sheet_.between, 0);
    }

    void add_explanation() {
        // Only the default layout is an arc.
        const bool is_arc = plan_.look.shape == space::layouts().front();
        const std::string time =
            fmt::format("Time runs{} from left to right{}", is_arc ? " along the arc," : "",
                        annotation::is_uneven(seen_.volume) ? ", with more room where something moves" : "");
        const std::array<std::string, 3> texts{
            time + ". Each cut through it is the camera's view at that moment. " +
                (shares_colours(composed_) ? "A number is the same object everywhere; colours repeat."
                                           : "A number and its colour are the same object everywhere."),
            time + "; each cut through it is the view at that moment.", time + "."};
        annotation::add_first_that_fits(texts, sheet_.small, sheet_.explanation.left,
                                        sheet_.explanation.bottom - sheet_.small / 2,
                                        sheet_.explanation.inflated(0, sheet_.small / 4), pale_, lettering_);
    }

    /// A frame at an end of the volume. The text above says which one it is, and its time.
    void add_end(std::string_view what, const media::Frame& frame, double seconds, const PixelBox& box, bool right) {
        Plane<Bgr> picture = media::picture_of(frame);
        if (picture.empty() || box.empty()) return;
        lettering_.pictures.push_back({box.inflated(-1, -1), std::move(picture), lines_, 1});
        const std::string time = annotation::format_moment_and_day(seconds, plan_.read.clock);
        annotation::Label label = annotation::make_label(fmt::format("{}, {}", what, time), sheet_.small, box.left,
                                                         box.top - sheet_.small / 2, pale_);
        // Between stills there is less room, and their order says which one it is.
        if (!sheet_.stills.empty() && label.box.width() > box.width())
            label = annotation::make_label(time, sheet_.small, box.left, label.y, pale_);
        if (right)
            label = annotation::make_label(label.text, sheet_.small, box.right - label.box.width(), label.y, pale_);
        lettering_.labels.push_back(label);
    }

    /// Portraits, map and strip beside the volume, and numbers inside it.
    void add_objects() {
        const annotation::Objects& objects = composed_.objects;
        const annotation::Trails trails(seen_.volume, *plan_.look.layout, camera_, sheet_.picture);
        std::set<std::size_t> numbered;
        const auto add_numbered = [&](const std::vector<std::size_t>& events) {
            numbered.insert(events.begin(), events.end());
        };
        if (plan_.look.shows(Part::map) && !seen_.scene.empty()) {
            const Size field = plan_.read.clip.field_size;
            const PixelBox box = annotation::map_box(*plan_.look.layout, camera_, sheet_.picture, sheet_.map_area,
                                                     static_cast<double>(field.width) / field.height);
            add_numbered(annotation::draw_map(objects, seen_.scene, field, box, sheet_.small, background_, lettering_));
        }
        if (plan_.look.shows(Part::strip)) {
            const std::vector<annotation::Period> unexplained =
                annotation::unexplained_periods(seen_.volume, seen_.identify);
            const footage::Unseen unseen = unseen_of(plan_, seen_);
            const annotation::StripContent content{seen_.findings,      unexplained,         seen_.not_chosen,
                                                   seen_.begin.seconds, seen_.end().seconds, composed_.nothing_moves,
                                                   unseen.intervals};
            add_numbered(
                annotation::label_strip(objects, content, sheet_, {ink_, pale_, lines_, background_}, lettering_));
        }
        // Without map and strip, all objects get a number.
        if (numbered.empty()) {
            for (std::size_t k = 0; k < objects.events.size(); ++k) numbered.insert(k);
        }
        if (plan_.look.shows(Part::portraits))
            annotation::label_portraits(objects, numbered, seen_.crops, trails, sheet_, ink_, pale_, lettering_);
        if (!plan_.look.shows(Part::numbers)) return;
        annotation::label_numbers(objects, numbered, trails, sheet_, lettering_);
        annotation::label_stays(objects, trails, sheet_, background_, lettering_);
    }

    /// Frames at the ends whose far side the camera sees look like in a mirror: says so below them.
    void add_seen_from_behind() {
        const auto& frames = composed_.scene.frames;
        if (frames.empty()) return;
        const int size = sheet_.small;
        for (const double t : {frames.front().t, frames.back().t}) {
            const auto pixel = [&](double x, double y) {
                return camera_.pixel(plan_.look.layout->p_from_c({x, y, t}), sheet_.picture);
            };
            const glm::dvec2 left = pixel(1, 0);
            const glm::dvec2 right = pixel(0, 0);
            const glm::dvec2 across = pixel(0, 1) - pixel(1, 1);
            const glm::dvec2 down = left - pixel(1, 1);
            if (across.x * down.y - across.y * down.x > -25.0 * size * size) continue;  // or from its edge
            // Below it; or in it, if the words have room there.
            const auto add = [&](const char* words, double y, double room) {
                annotation::Label label = annotation::make_centred_label(words, size, (left.x + right.x) / 2, y, pale_);
                label.halo = background_;
                return label.box.width() <= room && lettering_.add(label, sheet_.between, size / 4);
            };
            const double inside = std::min(left.y, right.y) - size;
            const double room = std::abs(left.x - right.x);
            if (add("seen from behind", std::max(left.y, right.y) + size, sheet_.between.width())) continue;
            if (!add("seen from behind", inside, room)) add("from behind", inside, room);
        }
    }

    const ComposePlan& plan_;
    const Observation& seen_;
    const Composition& composed_;
    const annotation::Sheet& sheet_;
    const space::Camera& camera_;
    image::Rgba ink_;
    image::Rgba pale_;
    image::Rgba lines_;
    image::Rgba background_;
    annotation::Lettering lettering_;
};

}  // namespace

std::vector<annotation::TimeGap> explained_gaps(const ComposePlan& plan, const Observation& seen) {
    std::vector<annotation::TimeGap> gaps = annotation::time_gaps(seen.volume);
    // A camera that records only motion has many, and the times need the room.
    std::ranges::stable_sort(gaps, std::greater{}, [](const annotation::TimeGap& gap) { return gap.end - gap.begin; });
    constexpr std::size_t most = 4;
    if (gaps.size() > most) gaps.resize(most);
    for (annotation::TimeGap& gap : gaps)
        gap.reason = media::reason_for_gap(plan.read.span, seen.info.segments, seen.missing, gap.begin, gap.end);
    return gaps;
}

annotation::Lettering annotate(const ComposePlan& plan, const Observation& seen, const Composition& composed) {
    return Annotator(plan, seen, composed).write();
}

}  // namespace vvr::app
