#include "core/dataset/stored_fields.h"

#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/dataset/plane_files.h"
#include "core/fields/flo_file.h"
#include "core/fields/planes.h"
#include "core/fields/seed_list.h"
#include "core/fields/settings.h"
#include "core/image/picture_codec.h"

namespace vvr::dataset {

namespace fs = std::filesystem;

namespace {

fields::Reference read_scene(const std::filesystem::path& path, Size size) {
    fields::Planes scene{Plane<std::uint8_t>(size), read_colour(path, size)};
    std::ranges::transform(scene.colour.pixels(), scene.grey.pixels().begin(),
                           [](const Bgr& bgr) { return static_cast<std::uint8_t>(fields::brightness_of(bgr)); });
    return scene;
}

using Settings = image::Metadata;

bool is_time_range(const std::string& option) {
    return option == "start" || option == "end";
}

bool same_clip(const media::VideoInfo& a, const media::VideoInfo& b) {
    return a.container == b.container && a.codec == b.codec && a.size == b.size && a.rate == b.rate &&
           a.duration == b.duration && a.frames == b.frames;
}

/// Why two folders are not consecutive parts of one clip; empty if they are.
std::string difference(const Manifest& a, const Manifest& b) {
    if (a.field_size != b.field_size) {
        return fmt::format("their fields have {}x{} and {}x{} pixels", a.field_size.width, a.field_size.height,
                           b.field_size.width, b.field_size.height);
    }
    if (a.colour != b.colour) return "only one has the frames' pictures";
    if (!same_clip(a.clip, b.clip)) return "they are of different clips";
    if (a.flow_every != b.flow_every)
        return fmt::format("they have the flow of every {} and every {} frames", a.flow_every, b.flow_every);
    for (const Settings* settings : {&a.settings, &b.settings}) {
        for (const auto& [option, value] : *settings) {
            const std::string one = image::value_of(a.settings, option);
            const std::string other = image::value_of(b.settings, option);
            if (!is_time_range(option) && one != other) return fmt::format("{} is '{}' and '{}'", option, one, other);
        }
    }
    // Where the limit of two parts is in a gap of the recording, frames are missing on both sides of it.
    const bool meet = a.span.stop && *a.span.stop == b.span.first && b.span.start == 0;
    if (!meet && b.frames.front().index != a.frames.back().index + 1) {
        return fmt::format("the first ends with frame {}, the second begins with frame {}", a.frames.back().index,
                           b.frames.front().index);
    }
    return "";
}

Settings merged(const Manifest& first, const Manifest& last) {
    Settings settings;
    for (const auto& [option, value] : first.settings) {
        if (option != "end") settings.emplace_back(option, value);
    }
    const std::string end = image::value_of(last.settings, "end");
    if (!end.empty()) settings.emplace_back("end", end);
    return settings;
}

}  // namespace

StoredFields::StoredFields(std::span<const std::string> folders) {
    for (const std::string& folder : folders) {
        const fs::path file = fs::path(folder) / stored::manifest;
        Part part{folder, parse_manifest(read_file(file.string()), file.string())};
        if (!parts_.empty()) {
            const std::string what = difference(parts_.back().manifest, part.manifest);
            if (!what.empty()) {
                throw Error(ErrorCode::extraction_unsuitable,
                            fmt::format("'{}' and '{}' are not consecutive parts of one extraction: {}; give the parts "
                                        "of one clip in order",
                                        parts_.back().folder.string(), folder, what));
            }
        }
        parts_.push_back(std::move(part));
    }
    const Manifest& first = parts_.front().manifest;
    const Manifest& last = parts_.back().manifest;
    settings_ = merged(first, last);
    info_ = first.clip;
    info_.name = parts_.front().folder.string();
    const bool whole = first.frames.front().index == 0 && image::value_of(settings_, "end").empty();
    if (!whole) {
        info_.frames = last.frames.back().index - first.frames.front().index + 1;
        info_.duration = info_.rate > 0 ? static_cast<double>(info_.frames) / info_.rate : 0;
    }
}

std::int64_t StoredFields::expected_frames() const {
    const Manifest& last = parts_.back().manifest;
    media::FrameSpan span = parts_.front().manifest.span;
    span.end = last.span.end;
    span.stop = last.span.stop;
    return media::expected_frames(last.clip, span);
}

std::int64_t StoredFields::interval(std::int64_t asked) const {
    const std::int64_t every = std::max<std::int64_t>(1, parts_.front().manifest.flow_every);
    return (asked + every - 1) / every * every;
}

fields::Field StoredFields::read_field(const Part& part, const StoredFrame& frame,
                                       const fields::FieldNeeds& needs) const {
    fields::Field field;
    field.index = frame.index;
    field.pts = frame.pts;
    field.before = frame.before;
    field.view = static_cast<std::size_t>(frame.view);
    field.scalar = read_grey(part.folder / stored::scalar_file(frame.index), field_size());
    const bool asked = frame.index % needs.every == 0;
    const auto fail = [](const fs::path& file, const std::string& what) {
        throw Error(ErrorCode::file_invalid, fmt::format("'{}': {}; run `vvr extract` again", file.string(), what));
    };
    if (needs.flow_of_every_frame || (asked && (needs.seeds || needs.flow))) {
        if (!frame.seeds) fail(part.folder / stored::manifest, fmt::format("frame {} has no 'seeds'", frame.index));
    }
    if (asked && needs.seeds) {
        const fs::path file = part.folder / stored::seed_file(frame.index);
        fields::SeedList list = fields::read_seeds(file.string());
        if (list.frame != frame.index)
            fail(file, fmt::format("it has the seeds of frame {}, not of frame {}", list.frame, frame.index));
        if (list.size != field_size()) {
            fail(file, fmt::format("its field has {}x{} pixels, not {}x{}", list.size.width, list.size.height,
                                   field_size().width, field_size().height));
        }
        if (std::ssize(list.seeds) != *frame.seeds) {
            fail(file, fmt::format("it has {} seeds, but the manifest says {}", list.seeds.size(), *frame.seeds));
        }
        field.seeds = std::move(list.seeds);
    }
    if (needs.flow_of_every_frame || (asked && (needs.flow || needs.seeds))) {
        const fs::path file = part.folder / stored::flow_file(frame.index);
        field.flow = fields::read_flo(file.string());
        if (field.flow.u.size() != field_size()) {
            fail(file, fmt::format("it has {}x{} pixels, not {}x{}", field.flow.u.width(), field.flow.u.height(),
                                   field_size().width, field_size().height));
        }
        if (const fields::Seed* const seed = fields::misfit(field.seeds, field.flow)) {
            const std::string folder = part.folder.string();
            throw Error(ErrorCode::extraction_unsuitable,
                        fmt::format("'{}': its seeds are not of this flow: one at {}, {} has {}, {}; for seeds of this "
                                    "flow, run `vvr seeds {} -o LISTS` and give --seeds LISTS",
                                    file.string(), seed->x, seed->y, seed->u, seed->v, folder),
                        {setting::seeds.name});
        }
    }
    return field;
}

fields::FieldSummary StoredFields::read(const fields::FieldNeeds& needs, const fields::FieldSink& sink) {
    if (needs.flow_of_every_frame && parts_.front().manifest.flow_every != 1) {
        throw Error(ErrorCode::extraction_unsuitable,
                    fmt::format("'{}' does not have the flow of each frame, which these colours need; extract it again "
                                "with the flow of each frame, or render the clip itself",
                                info_.name),
                    {setting::flow_every.name});
    }
    if ((needs.seeds || needs.flow) && parts_.front().manifest.flow_every == 0) {
        throw Error(ErrorCode::extraction_unsuitable,
                    fmt::format("'{}' has no flow, which arrows and tracelines need; extract it again with flow, or do "
                                "not show them",
                                info_.name),
                    {"show"});
    }
    if (needs.colour && !parts_.front().manifest.colour) {
        throw Error(ErrorCode::extraction_unsuitable,
                    fmt::format("'{}' does not have the frames' colours; extract it again, or render the clip itself",
                                info_.name));
    }
    fields::FieldSummary summary;
    for (const Part& part : parts_) summary.damaged += part.manifest.damaged;
    const Part& some = parts_.front();
    if (some.manifest.colour && some.manifest.reference) {
        summary.reference = read_scene(some.folder / stored::reference, field_size());
        for (std::int64_t view = 1; view <= some.manifest.views; ++view)
            summary.reference.others.push_back(read_scene(some.folder / stored::view_file(view), field_size()));
        if (needs.scene) needs.scene(summary.reference);
    }
    for (const Part& part : parts_) {
        for (const StoredFrame& stored : part.manifest.frames) {
            media::Frame frame{.index = stored.index, .pts = stored.pts, .grey = {}, .colour = {}};
            const bool first = &stored == &parts_.front().manifest.frames.front();
            const bool last = &stored == &parts_.back().manifest.frames.back();
            if (needs.colour) {
                frame.colour = read_colour(part.folder / stored::colour_file(stored.index), field_size());
            } else if (first || last) {
                frame.colour = read_colour(part.folder / (first ? stored::first : stored::last), field_size());
            }
            ++summary.frames;
            sink(std::make_shared<const media::Frame>(std::move(frame)), read_field(part, stored, needs));
        }
    }
    return summary;
}

}  // namespace vvr::dataset
