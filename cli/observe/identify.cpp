#include "cli/observe/identify.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <span>
#include <utility>

#include "core/annotation/objects.h"
#include "core/fields/opencv_threads.h"
#include "core/tracking/event_options.h"

namespace vvr::app {

namespace {

constexpr auto& limit = tracking::thresholds.detector;
constexpr std::size_t most_events = 200;  // per clip, the most important ones: a look takes 50 to 100 ms

double area_of(const PixelBox& box) {
    return box.empty() ? 0 : static_cast<double>(box.width()) * box.height();
}

/// The overlap of two boxes as a share of both together.
double overlap_of(const PixelBox& a, const PixelBox& b) {
    const double both = area_of(intersection(a, b));
    return both > 0 ? both / (area_of(a) + area_of(b) - both) : 0;
}

/// The detection that shows the object, rather than its neighbour; nothing if none does.
std::optional<detector::Detection> detection_of(const PixelBox& object, std::span<const detector::Detection> all) {
    const auto best =
        std::ranges::max_element(all, {}, [&](const detector::Detection& one) { return overlap_of(object, one.box); });
    if (best == all.end()) return std::nullopt;
    // Of a person, the fields may show only the legs.
    const double part = area_of(intersection(object, best->box)) / std::max(1.0, area_of(object));
    if (part < limit.overlap && overlap_of(object, best->box) < limit.overlap) return std::nullopt;
    return *best;
}

}  // namespace

std::shared_ptr<detector::Detector> open_detector(const DetectorOptions& options) {
    return options.model.empty() ? nullptr : std::make_shared<detector::Detector>(options.model, options.trial);
}

const DetectorUse& ObjectClassifier::identify(tracking::Findings& found, const annotation::Crops& crops) {
    const auto begin = std::chrono::steady_clock::now();
    const fields::OpenCvThreads threads(threads_);
    std::vector<std::vector<tracking::Look>> looks(found.events.size());
    std::vector<std::size_t> order = annotation::by_importance(found.events);
    order.resize(std::min(order.size(), most_events));
    Answers current;
    use_.events = 0;
    for (const std::size_t k : order) {
        looks[k] = looks_at(found.events[k], crops, current);
        use_.events += looks[k].empty() ? 0 : 1;
    }
    answers_ = std::move(current);
    tracking::identify(found, looks);
    use_.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return use_;
}

/// \param current receives the answers
std::vector<tracking::Look> ObjectClassifier::looks_at(const tracking::Event& event, const annotation::Crops& crops,
                                                       Answers& current) {
    // The frames do not show what only the empty scene has.
    const bool only_scene = event.in_scene.has_value() || row_of(event.kind).is_of_scene;
    const bool is_claim = row_of(event.kind).is_thing;
    std::vector<tracking::Look> looks;
    for (const auto& [track, crop] : crops.all(event)) {
        if (std::ssize(looks) == most_looks || (only_scene && crop->score() != annotation::score_of_scene)) break;
        // One answer is enough, except to refute a claim; without one, another moment may give it.
        if (!is_claim && !looks.empty() && looks.back().what != nullptr) break;
        const std::pair key(track, crop->score());
        const auto known = answers_.find(key);
        looks.push_back(known != answers_.end() ? known->second : look_at(*crop));
        current[key] = looks.back();
    }
    return looks;
}

tracking::Look ObjectClassifier::look_at(const annotation::Crop& crop) {
    ++use_.looks;
    const annotation::ObjectPicture shown = crop.surroundings();
    const auto all = detector_->detect(detector::view_of(shown.picture), static_cast<float>(limit.score));
    const std::optional<detector::Detection> found = detection_of(shown.object, all);
    if (!found) return {};
    return {&detector::object_classes()[static_cast<std::size_t>(found->class_id)], found->score, crop.at(),
            shown.in_field(found->box)};
}

std::vector<PixelBox> ObjectClassifier::living_in(const media::Frame& frame) {
    const auto begin = std::chrono::steady_clock::now();
    const fields::OpenCvThreads threads(threads_);
    ++use_.frames;
    std::vector<PixelBox> boxes;
    const Plane<Bgr> picture = media::picture_of(frame);
    for (const detector::Detection& one :
         detector_->detect(detector::view_of(picture), static_cast<float>(limit.score))) {
        const detector::ObjectClass& what = detector::object_classes()[static_cast<std::size_t>(one.class_id)];
        if (detector::lives_or_drives(what.group)) boxes.push_back(one.box);
    }
    use_.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return boxes;
}

}  // namespace vvr::app
