#include "core/volume/volume.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"

namespace vvr::volume {

namespace {

/// Share of the layers for time without motion, as 1/n: while the clip is read, and at the end.
constexpr std::size_t idle_share_read = 8;
constexpr std::size_t idle_share = 4;

/// Share of the layers, as 1/n, that are too new to be merged as time without motion: an object is known only when it
/// has gone some way.
constexpr std::size_t undecided_share = 4;

}  // namespace

Volume::Volume(Size size, const VolumeOptions& options)
    : size_(size), options_(options), merger_(options.values), next_thinning_(options.capacity * options.step) {
    if (options.capacity < 2 || options.step < 1 || options.seed_interval < 1) {
        throw Error(
            ErrorCode::option_value_out_of_range,
            fmt::format(
                "a volume needs at least 2 layers, 1 frame per layer and 1 frame between seeds, not {}, {} and {}",
                options.capacity, options.step, options.seed_interval));
    }
}

/// Whether the last layer takes more frames. If there is no room for another layer, merges pairs first.
bool Volume::continues_layer() {
    if (options_.nonuniform || layers_.empty()) return false;
    if (layers_.back().frames == options_.step && layers() == options_.capacity) merge_pairs();
    return layers_.back().frames < options_.step;
}

void Volume::add_layer(Layer layer) {
    if (!options_.nonuniform) {
        layers_.push_back(std::move(layer));
        return;
    }
    const auto most = static_cast<std::size_t>(room());
    if (layers_.size() >= most) {
        const std::size_t undecided = options_.marked_late ? most / undecided_share : 0;
        merger_.merge_cheapest(layers_, most / idle_share_read, layers_.size() - undecided);
    }
    layers_.push_back(std::move(layer));
    merger_.add(layers_);
}

void Volume::add(const fields::Field& field, const Plane<Bgr>& colour, std::span<const fields::LabelRun> owners,
                 bool moves) {
    if (field.scalar.size() != size_) {
        throw Error(ErrorCode::not_video,
                    fmt::format("the field of frame {} has {}x{} pixels, not {}x{} as the frames before it",
                                field.index, field.scalar.width(), field.scalar.height(), size_.width, size_.height));
    }
    if (frames_ == 0) coloured_ = !colour.empty();
    if (colour.size() != (coloured_ ? size_ : Size{})) {
        throw Error(
            ErrorCode::not_video,
            fmt::format("the picture of frame {} has {}x{} pixels, not {}x{} as the frames before it", field.index,
                        colour.width(), colour.height(), coloured_ ? size_.width : 0, coloured_ ? size_.height : 0));
    }
    SparsePlane scalar(field.scalar);
    OwnerPlane owner = owners_in(owners, scalar);
    Layer layer{field.index,   field.index,       1,      field.pts,       field.pts, 0,
                moves ? 1 : 0, std::move(scalar), colour, std::move(owner)};
    if (continues_layer()) {
        merge(layers_.back(), layer, options_.values);
    } else {
        add_layer(std::move(layer));
    }
    if (field.index % options_.seed_interval == 0) {
        seeded_.push_back({frames_, field.index});
        for (const fields::Seed& seed : field.seeds) seeds_.push_back({frames_, seed});
        if (options_.keep_flow && !field.flow.u.empty()) flow_.add(frames_, field.flow);
    }
    ++frames_;
    if (options_.nonuniform && frames_ == next_thinning_) {
        next_thinning_ *= 2;
        thin_seeds();
    }
}

void Volume::remove_track(std::size_t track) {
    const std::uint16_t number = owners_.number_of(track);
    if (number == 0) return;
    for (Layer& layer : layers_) {
        const OwnerPlane owners = layer.owner;
        owners.for_each_run([&](int column, int row, std::span<const std::uint16_t> run) {
            for (std::size_t i = 0; i < run.size(); ++i) {
                if (run[i] != number) continue;
                layer.owner.set(column + static_cast<int>(i), row, 0);
                layer.scalar.set(column + static_cast<int>(i), row, 0);
            }
        });
    }
}

void Volume::clear(const PixelBox& box) {
    for (Layer& layer : layers_) {
        for (int j = box.top; j < box.bottom; ++j) {
            for (int i = box.left; i < box.right; ++i) {
                if (layer.scalar.at(i, j) == 0) continue;
                layer.scalar.set(i, j, 0);
                if (!layer.owner.empty()) layer.owner.set(i, j, 0);
            }
        }
    }
}

void Volume::insert_track(std::size_t track, const PixelBox& box, const Plane<std::uint8_t>& values, double first,
                          double last) {
    const std::uint16_t number = owners_.number_of(track);
    if (number == 0) return;
    for (Layer& layer : layers_) {
        if (layer.last_pts < first || layer.pts > last) continue;
        for (int j = 0; j < values.height(); ++j) {
            for (int i = 0; i < values.width(); ++i) {
                const std::uint8_t value = values.at(i, j);
                if (value <= layer.scalar.at(box.left + i, box.top + j)) continue;
                layer.scalar.set(box.left + i, box.top + j, value);
                layer.owner.set(box.left + i, box.top + j, number);
            }
        }
    }
}

void Volume::add_gap(std::int64_t index, std::int64_t count, double pts, double apart) {
    while (count > 0) {
        const bool goes_on = continues_layer();
        const std::int64_t room = goes_on ? options_.step - layers_.back().frames : options_.step;
        const std::int64_t taken = options_.nonuniform ? count : std::min(count, room);
        const double last_pts = pts + static_cast<double>(taken - 1) * apart;
        if (goes_on) {
            Layer& layer = layers_.back();
            layer.frames += taken;
            layer.missing += taken;
            layer.last_frame = index + taken - 1;
            layer.last_pts = last_pts;
        } else {
            add_layer({index, index + taken - 1, taken, pts, last_pts, taken, 0, SparsePlane(size_),
                       coloured_ ? Plane<Bgr>(size_) : Plane<Bgr>{},
                       options_.keep_owners ? OwnerPlane(size_) : OwnerPlane{}});
        }
        index += taken;
        count -= taken;
        pts += static_cast<double>(taken) * apart;
        frames_ += taken;
    }
}

void Volume::mark_motion(double first, double last) {
    if (!options_.nonuniform) return;
    for (auto layer = layers_.rbegin(); layer != layers_.rend() && layer->last_pts >= first; ++layer) {
        if (layer->pts > last) continue;
        const double length = layer->last_pts - layer->pts;
        const double both = std::min(last, layer->last_pts) - std::max(first, layer->pts);
        const double share = length > 0 ? both / length : 1;
        const auto frames = std::llround(share * static_cast<double>(layer->frames - layer->missing));
        layer->moving = std::max<std::int64_t>({layer->moving, frames, 1});
    }
}

void Volume::forget_motion() {
    for (Layer& layer : layers_) layer.moving = 0;
}

void Volume::settle() {
    if (!options_.nonuniform) return;
    merger_.restart(layers_);
    while (layers() > options_.capacity)
        merger_.merge_cheapest(layers_, static_cast<std::size_t>(options_.capacity) / idle_share, layers_.size());
    for (;;) {
        const auto idle = static_cast<std::size_t>(std::ranges::count_if(layers_, is_idle));
        if (idle == layers_.size() || idle * idle_share <= layers_.size() ||
            !merger_.merge_idle(layers_, layers_.size()))
            return;
    }
}

std::int64_t Volume::step() const {
    if (!options_.nonuniform) return options_.step;
    return std::max<std::int64_t>(
        1, std::llround(static_cast<double>(frames_) / std::max<double>(1, static_cast<double>(layers()))));
}

/// The owners of a field's pixels; empty if the volume doesn't keep owners.
OwnerPlane Volume::owners_in(std::span<const fields::LabelRun> runs, const SparsePlane& scalar) {
    if (!options_.keep_owners) return {};
    if (owners_.room() < runs.size()) {
        std::vector<bool> used(std::size_t{1} << 16U);
        for (const Layer& layer : layers_) {
            layer.owner.for_each_run([&](int, int, std::span<const std::uint16_t> numbers) {
                for (const std::uint16_t number : numbers) used[number] = true;
            });
        }
        owners_.keep_only(used);
    }
    return owners_.pixels_of(runs, scalar);
}

std::int64_t Volume::missing() const {
    std::int64_t missing = 0;
    for (const Layer& layer : layers_) missing += layer.missing;
    return missing;
}

double Volume::t_of_frame(double frame) const {
    // The last layer may have fewer frames than the others, but has the same thickness.
    if (!options_.nonuniform) return (frame + 0.5) / static_cast<double>(span() * options_.step);
    double before = frame + 0.5;
    std::int64_t at = 0;
    while (at + 1 < layers() && before >= static_cast<double>(layer(at).frames)) {
        before -= static_cast<double>(layer(at++).frames);
    }
    const double share = layers_.empty() ? 0 : before / static_cast<double>(layer(at).frames);
    return (static_cast<double>(at) + share) / static_cast<double>(span());
}

/// The last layer that begins at or before the time, or the first layer.
std::int64_t Volume::layer_of(double seconds) const {
    const auto after = std::ranges::upper_bound(layers_, seconds, {}, &Layer::pts);
    return std::max<std::int64_t>(0, after - layers_.begin() - 1);
}

double Volume::t_of_seconds(double seconds) const {
    const std::int64_t low = layer_of(seconds);
    const Layer& at = layer(low);
    const auto frames = static_cast<double>(at.frames);
    // A layer lasts until the next one begins. The duration of the last layer comes from its own frames.
    double length = low + 1 < layers() ? layer(low + 1).pts - at.pts : 0;
    if (length <= 0 && at.frames > 1) length = (at.last_pts - at.pts) * frames / (frames - 1);
    const double share = length > 0 ? std::clamp((seconds - at.pts) / length, 0.0, 1.0) : 0.5;
    return t_end() * (static_cast<double>(low) + share) / static_cast<double>(layers());
}

glm::dvec3 Volume::c_of(const glm::dvec3& point) const {
    return {1 - (point.x + 0.5) / size_.width, 1 - (point.y + 0.5) / size_.height, t_of_frame(point.z)};
}

glm::dvec3 Volume::c_vector(const glm::dvec3& vector) const {
    return {-vector.x / size_.width, -vector.y / size_.height,
            vector.z / static_cast<double>(options_.nonuniform ? frames_ : span() * options_.step)};
}

bool Volume::seeded(std::int64_t frame) const {
    return std::ranges::binary_search(seeded_, frame, {}, &SeededFrame::frame);
}

void Volume::drop_front(std::int64_t layers) {
    const auto end = layers_.begin() + static_cast<std::ptrdiff_t>(std::min(layers, this->layers()));
    std::int64_t frames = 0;
    for (auto layer = layers_.begin(); layer != end; ++layer) frames += layer->frames;
    layers_.erase(layers_.begin(), end);
    frames_ -= frames;
    std::erase_if(seeds_, [frames](const FrameSeed& seed) { return seed.frame < frames; });
    for (FrameSeed& seed : seeds_) seed.frame -= frames;
    std::erase_if(seeded_, [frames](const SeededFrame& seeded) { return seeded.frame < frames; });
    for (SeededFrame& seeded : seeded_) seeded.frame -= frames;
    flow_.drop_front(frames);
}

void Volume::merge_pairs() {
    std::vector<Layer> merged;
    merged.reserve(layers_.size());
    for (std::size_t i = 0; i < layers_.size(); i += 2) {
        Layer layer = std::move(layers_[i]);
        if (i + 1 < layers_.size()) merge(layer, layers_[i + 1], options_.values);
        merged.push_back(std::move(layer));
    }
    layers_ = std::move(merged);
    options_.step *= 2;
    thin_seeds();
}

void Volume::thin_seeds() {
    options_.seed_interval *= 2;
    // By the frame's index in the clip, like flow, so that both match if reading begins in the middle of the clip.
    std::erase_if(seeded_, [this](const SeededFrame& seeded) { return seeded.index % options_.seed_interval != 0; });
    std::erase_if(seeds_, [this](const FrameSeed& seed) { return !seeded(seed.frame); });
    flow_.erase_if([this](std::int64_t frame) { return !seeded(frame); });
}

std::vector<CompressedIdle> compressed_stretches(const Volume& volume) {
    if (!volume.is_nonuniform()) return {};
    const double all = volume.layer(volume.layers() - 1).last_pts - volume.layer(0).pts;
    const double share = volume.t_end() / static_cast<double>(volume.layers());
    std::vector<CompressedIdle> stretches;
    for (std::int64_t i = 0; i < volume.layers();) {
        std::int64_t end = i;
        // A long idle layer may include the last frames of earlier motion.
        constexpr std::int64_t least_share = 10;
        const auto counts = [](const Layer& layer) {
            return layer.moving * least_share <= layer.frames && 2 * layer.missing < layer.frames;
        };
        while (end < volume.layers() && counts(volume.layer(end))) ++end;
        if (end == i) {
            ++i;
            continue;
        }
        const double till = end < volume.layers() ? volume.layer(end).pts : volume.layer(end - 1).last_pts;
        const double seconds = till - volume.layer(i).pts;
        const double room = static_cast<double>(end - i) / static_cast<double>(volume.layers());
        if (room * all < seconds / 2) {
            stretches.push_back(
                {share * static_cast<double>(i), share * static_cast<double>(end), volume.layer(i).pts, seconds});
        }
        i = end;
    }
    constexpr double visible_share = 0.01;  // of all the time; less makes no visible difference
    double sum = 0;
    for (const CompressedIdle& stretch : stretches) sum += stretch.seconds;
    if (sum < visible_share * all) stretches.clear();
    return stretches;
}

}  // namespace vvr::volume
