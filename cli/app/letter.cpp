#include "cli/app/letter.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/app/legend.h"
#include "core/base/text.h"
#include "core/glance/portraits.h"
#include "core/glance/scene_map.h"
#include "core/glance/time_strip.h"
#include "core/labels/ruler.h"

namespace vvr::app {

namespace {

/// Tells gaps between the requested parts from losses of signal.
std::vector<labels::TimeGap> explained_gaps(const video::FrameSpan& span, const bricks::Volume& volume) {
    std::vector<labels::TimeGap> gaps = labels::time_gaps(volume);
    if (span.parts.empty()) return gaps;
    constexpr double little = 1;  // seconds
    for (labels::TimeGap& gap : gaps) {
        double asked = 0;
        for (const video::FrameSpan::Part& part : span.parts) {
            asked += std::max(0.0, std::min(part.end, gap.end) - std::max(part.begin, gap.begin));
        }
        const bool left_out = gap.end - gap.begin - asked > little;
        if (left_out) gap.reason = asked > little ? "left out, no signal" : "left out";
    }
    return gaps;
}

/// Adds text around the volume, the most important first. Later items get the room that is left.
class Letterer {
  public:
    Letterer(const Plan& plan, const Observation& seen, const Composition& composed)
        : plan_(plan),
          seen_(seen),
          composed_(composed),
          sheet_(composed.framing.sheet),
          camera_(composed.framing.camera),
          ink_(rgba(plan.job.look.theme.ink)),
          pale_(rgba(plan.job.look.theme.pale_ink)),
          lines_(rgba(plan.job.look.theme.lines)),
          background_(plan.picture.background) {}

    labels::Lettering write() {
        lettering_.font_missing = sheet_.text > 0 && !image::measure_text("0", sheet_.text);
        add_title_and_legend();
        if (sheet_.text == 0) return std::move(lettering_);
        add_ruler();
        if (composed_.still) add_stillness();
        if (plan_.shows(Part::explanation)) add_explanation();
        if (plan_.shows(Part::ends)) {
            add_end("first frame", *seen_.first, seen_.begin.seconds, sheet_.first, false);
            add_end("last frame", *seen_.last, seen_.end().seconds, sheet_.last, true);
        }
        add_objects();
        return std::move(lettering_);
    }

  private:
    void add_title_and_legend() {
        const std::vector<labels::LegendEntry> legend =
            plan_.shows(Part::legend) ? legend_of(plan_) : std::vector<labels::LegendEntry>{};
        const bool in_one_band = !legend.empty() && sheet_.legend == sheet_.title;
        const int right = sheet_.title.right - (in_one_band ? labels::brief_width(legend, sheet_) : 0);
        labels::label_title(plan_.title, length_text(), right, sheet_, ink_, pale_, lettering_);
        labels::label_legend(legend, sheet_, pale_, lettering_);
    }

    std::string length_text() const {
        const std::int64_t frames = seen_.volume.frames() - seen_.volume.missing();
        std::string text =
            fmt::format("{}, {}", counted(frames, "frame"),
                        labels::format_interval_and_zone(seen_.begin.seconds, seen_.end().seconds, plan_.clock));
        double idle = 0;
        for (const bricks::CompressedIdle& stretch : composed_.squeezed) idle += stretch.seconds;
        if (idle > 0) text += fmt::format(", {} without motion drawn short", labels::format_duration(idle));
        return text;
    }

    void add_ruler() {
        const labels::TimeEdge& edge = composed_.framing.edge;
        if (plan_.shows(Part::ruler)) {
            labels::label_gaps(explained_gaps(plan_.job.fields.span, seen_.volume), *plan_.layout, edge, camera_,
                               sheet_, rgba(plan_.job.look.theme.fast), lettering_);
            // Before the ticks: it is most important where the clock leaps.
            labels::label_breaks(labels::time_breaks(seen_.volume, breaks_shown), *plan_.layout, edge, camera_, sheet_,
                                 pale_, lettering_);
        }
        labels::label_ruler(seen_.volume, *plan_.layout, edge, composed_.ticks, camera_, sheet_, ink_, lettering_);
    }

    /// Writes into the middle of an empty volume, which would otherwise look like an error.
    void add_stillness() {
        const PixelBox& box = sheet_.volume;
        lettering_.add(labels::make_centred_label("nothing moves", sheet_.text * 2, (box.left + box.right) / 2.0,
                                                  (box.top + box.bottom) / 2.0, pale_),
                       sheet_.between, 0);
    }

    void add_explanation() {
        // Only the default layout is an arc.
        const bool is_arc = plan_.job.layout == space::layouts().front();
        const bool varies =
            !composed_.squeezed.empty() || (seen_.volume.is_nonuniform() && !labels::time_gaps(seen_.volume).empty());
        const std::string time = fmt::format("Time runs{} from left to right{}", is_arc ? " along the arc," : "",
                                             varies ? ", with room where something moves" : "");
        const std::array<std::string, 3> texts{
            time +
                ". Each cut through it is the camera's view at that moment. A number and its colour are the same "
                "object everywhere.",
            time + "; each cut through it is the view at that moment.", time + "."};
        labels::add_first_that_fits(texts, sheet_.small, sheet_.explanation.left,
                                    sheet_.explanation.bottom - sheet_.small / 2,
                                    sheet_.explanation.inflated(0, sheet_.small / 4), pale_, lettering_);
    }

    /// A frame at an end of the volume. The text above says which one it is, and its time.
    void add_end(std::string_view what, const video::Frame& frame, double seconds, const PixelBox& box, bool right) {
        Plane<Bgr> picture = video::picture_of(frame);
        if (picture.empty() || box.empty()) return;
        lettering_.pictures.push_back({box.inflated(-1, -1), std::move(picture), lines_, 1});
        const std::string text = fmt::format("{}, {}", what, labels::format_moment(seconds, plan_.clock));
        const auto label_at = [&](int x) {
            return labels::make_label(text, sheet_.small, x, box.top - sheet_.small / 2, pale_);
        };
        const labels::Label label = label_at(box.left);
        lettering_.labels.push_back(right ? label_at(box.right - label.box.width()) : label);
    }

    /// Portraits, map and strip beside the volume, and numbers inside it.
    void add_objects() {
        const glance::Objects& objects = composed_.objects;
        const glance::Trails trails(seen_.volume, *plan_.layout, camera_, sheet_.picture);
        if (plan_.shows(Part::map) && !seen_.scene.empty()) {
            const Size field = plan_.clip.field_size;
            const PixelBox box = glance::map_box(*plan_.layout, camera_, sheet_.picture, sheet_.map_area,
                                                 static_cast<double>(field.width) / field.height);
            glance::draw_map(objects, seen_.scene, field, box, sheet_.small, background_, lettering_);
        }
        if (plan_.shows(Part::portraits))
            glance::label_portraits(objects, seen_.crops, trails, sheet_, ink_, pale_, lettering_);
        if (plan_.shows(Part::numbers)) {
            glance::label_numbers(objects, trails, sheet_, lettering_);
            glance::label_stays(objects, trails, sheet_, background_, lettering_);
        }
        if (plan_.shows(Part::strip)) {
            glance::label_strip(objects, seen_.begin.seconds, seen_.end().seconds, composed_.still, sheet_,
                                {ink_, pale_, lines_, background_}, lettering_);
        }
    }

    const Plan& plan_;
    const Observation& seen_;
    const Composition& composed_;
    const labels::Sheet& sheet_;
    const space::Camera& camera_;
    image::Rgba ink_;
    image::Rgba pale_;
    image::Rgba lines_;
    image::Rgba background_;
    labels::Lettering lettering_;
};

}  // namespace

labels::Lettering letter(const Plan& plan, const Observation& seen, const Composition& composed) {
    return Letterer(plan, seen, composed).write();
}

}  // namespace vvr::app
