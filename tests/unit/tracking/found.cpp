#include "tests/unit/tracking/found.h"

#include <limits>
#include <ostream>
#include <utility>

#include "core/fields/field_source.h"
#include "core/tracking/path.h"
#include "tests/scene/scene_source.h"
#include "tests/support/planes.h"

namespace vvr::test {
namespace {

std::ostream& operator<<(std::ostream& out, const PixelBox& box) {
    return out << "[" << box.left << " " << box.top << " " << box.right << " " << box.bottom << "]";
}

std::ostream& operator<<(std::ostream& out, const tracking::Evidence& evidence) {
    return out << " difference " << evidence.difference << " edges " << evidence.edges << " of the scene "
               << evidence.scene_edges << " thickness " << evidence.thickness << " alone " << evidence.alone
               << " moved " << evidence.moved << " flicker " << evidence.flicker << " changed " << evidence.changed
               << " carried " << evidence.carried << " confidence " << evidence.confidence;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Found& found) {
    for (const tracking::Event& event : found.all.events) {
        out << "\n  " << tracking::name_of(event.kind) << " " << event.first.frame << " to " << event.last.frame << " "
            << event.box << " way " << event.path_length;
        for (const tracking::Stay& stay : event.stays) {
            out << " stay " << stay.first.frame << " to " << stay.last.frame << " " << stay.box;
        }
        if (event.from) out << " from " << *event.from;
        if (event.into) out << " into " << *event.into;
        if (event.by) out << " by " << *event.by;
        if (event.evidence) out << *event.evidence;
    }
    for (const tracking::Change& change : found.all.changes) {
        out << "\n  change " << change.first.frame << " to " << change.last.frame << " " << change.box
            << change.evidence;
    }
    for (const PixelBox& overlay : found.all.overlays) out << "\n  overlay " << overlay;
    return out << "\n";
}

generator::Options small(std::uint64_t seed, double noise) {
    generator::Options options{.size = {192, 144}, .seed = seed, .noise = noise};
    return options;
}

Found found_in(generator::Scene scene, const std::string& reference) {
    Found found{std::move(scene), {}, {}};
    media::SourceOptions source{.field_size = {-1, -1}, .colour = true};
    fields::FieldOptions fields{.reference = reference};
    fields.flow.method = "none";
    tracking::EventFinder finder(found.scene.size());
    const auto clip = generator::open_scene(found.scene, source);
    fields::compute_fields(
        *clip, fields,
        [&](const media::SharedFrame& frame, fields::Field&& field) {
            found.labels.push_back(
                finder.add({field.scalar, frame->grey, frame->colour}, {field.index, field.pts}).labels);
        },
        [&](const fields::Reference& empty) {
            const fields::Planes& planes = empty;
            finder.set_scenes({planes});
        });
    found.all = finder.finish();
    return found;
}

std::vector<tracking::EventKind> kinds_of(const std::vector<tracking::Event>& events) {
    std::vector<tracking::EventKind> kinds;
    for (const tracking::Event& event : events) kinds.push_back(event.kind);
    return kinds;
}

double distance_to(const tracking::Event& event, const generator::Scene& scene, const std::string& name) {
    double sum = 0;
    int count = 0;
    for (int f = 0; f < scene.frames(); f += 5) {
        if (f < event.first.frame || f > event.last.frame) continue;
        const generator::Truth truth = scene.truth(f);
        const generator::Object* const object = truth.find(name);
        if (object == nullptr) continue;
        sum += glm::distance(tracking::place_at(event.path, f), {object->x, object->y});
        ++count;
    }
    return count == 0 ? std::numeric_limits<double>::infinity() : sum / count;
}

generator::Interval visible(const generator::Scene& scene, const std::string& name) {
    constexpr int least = 30;  // pixels
    generator::Interval visible{-1, -1};
    for (int f = 0; f < scene.frames(); ++f) {
        const generator::Truth truth = scene.truth(f);
        const generator::Object* const object = truth.find(name);
        if (object == nullptr || test::lit(object->mask) < least) continue;
        if (visible.first < 0) visible.first = f;
        visible.last = f;
    }
    return visible;
}

}  // namespace vvr::test
