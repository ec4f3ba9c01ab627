"""Deliberate bugs, one of which mutate.py puts into the sources at a time. Each text to replace occurs once in its file."""

from typing import NamedTuple


class Break(NamedTuple):
    file: str
    old: str
    new: str
    test: str = ""  # of the command line, if only one of those notices it; runs first


BREAKS = [
    # core/base
    Break("core/base/file.cpp", "if (filled > most) refuse_length(path, most);", ""),
    Break("core/base/file.cpp", "wait ? LOCK_EX : LOCK_EX | LOCK_NB", "wait ? LOCK_SH : LOCK_SH | LOCK_NB"),
    Break("core/base/text.cpp", "host.rfind('@')", "host.find('@')"),
    Break("core/base/wall_clock.cpp", "best && !near && utc < *best", "best && !near && utc > *best"),
    # core/kernels
    Break("core/kernels/colour_rows.cpp", "luma[i] < 16 ? 0 : luma[i] - 16", "luma[i] < 16 ? 0 : luma[i] - 15"),
    Break("core/kernels/colour_rows.cpp", "fixed(-2 * (1 - red) * red / green * stretch)", "fixed(-2 * (1 - red) * blue / green * stretch)"),
    # core/detector
    Break("core/detector/letterbox.cpp", "pixel(box.left, image.width), pixel(box.top, image.height)",
          "pixel(box.left, image.height), pixel(box.top, image.width)"),
    Break("core/detector/onnx.cpp", "all == in_raw || (all == in_list && !raw)", "all == in_raw || all == in_list"),
    # core/video
    Break("core/video/frame_span.cpp", "pts >= *span.end - slack", "pts >= *span.end + slack"),
    Break("core/video/frame_span.cpp", "day_at(clock, begin) - 1; date", "day_at(clock, begin); date"),
    Break("core/video/crop.cpp", "(box.left + place.left) * ratio.x", "(box.left - place.left) * ratio.x"),
    Break("core/video/picture_source.cpp", "++damaged_;", ""),
    Break("core/video/packet_range.cpp", "if (packets[k].key && packets[k].stamp <= wanted) first = k;", "if (packets[k].key) first = k;"),
    Break("core/video/recorder_pattern.cpp", "return west ? -ahead : ahead;", "return west ? ahead : -ahead;"),
    # core/fields
    Break("core/fields/seeds.cpp", "std::min(then + 1, most)", "then + 1 + 0 * most"),
    Break("core/fields/region.cpp", "p = p >= 128 ? 255 : 0", "p = p > 128 ? 255 : 0"),
    Break("core/fields/blobs.cpp", "merge_neighbours(gaps, 0);", "merge_neighbours(gaps, 1);"),
    Break("core/fields/shadows.cpp", "shares.least > darkest && shares.most < 1", "shares.least > darkest && shares.most < 2"),
    Break("core/fields/motion.cpp", "if (differ(past_.front().occupancy, past_.back().occupancy)) last_", "if (differ(past_.front().occupancy, past_.back().occupancy) && !last_) last_"),
    # core/events
    Break("core/events/association.cpp", "if (*most < limit.shared_part * tracks", "if (*most > limit.shared_part * tracks"),
    Break("core/events/conclude.cpp", "kind == EventKind::taken ? bearer.begin.place : bearer.end.place",
          "kind == EventKind::taken ? bearer.end.place : bearer.begin.place"),
    Break("core/events/identify.cpp", "*other = places[**other]", "*other = order[**other]"),
    Break("core/events/path.cpp", "other.last.frame >= stay.first.frame;", "other.last.frame > stay.last.frame;"),
    Break("core/events/track.cpp", "(std::ssize(moments) - 1) * 9 / 10", "(std::ssize(moments) - 1) * 1 / 10"),
    # core/space
    Break("core/space/camera.cpp", "std::max({x.half() / tan_x, y.half() / tan_y, 1e-9 - z.low})", "std::max({x.half() / tan_x, 1e-9 - z.low})"),
    Break("core/space/horseshoe.cpp", "if (before_open_side) std::ranges::reverse(order);", ""),
    # core/bricks
    Break("core/bricks/brick.cpp", "if (at > 0) owners.spread(layers_[at - 1]->owner);", ""),
    Break("core/bricks/brick.cpp", "if (layer <= rest.first || layer", "if (layer < rest.first || layer"),
    # core/scene
    Break("core/scene/slices.cpp", "found == 2 && places[0] > places[1]", "found == 2 && places[0] < places[1]"),
    Break("core/scene/transfer_function.cpp", "values[0] <= points.back().value", "values[0] < points.back().value"),
    # core/image
    Break("core/base/atomic_file.cpp", "if (error != EWOULDBLOCK && sure && is_same_file(file, path))", "if (sure && is_same_file(file, path))"),
    Break("core/image/comparison.cpp", "constexpr int stride = patch_size / 2;", "constexpr int stride = patch_size;"),
    # core/labels
    Break("core/labels/time_ticks.cpp", "intervals.back().half_open = true;", ""),
    # core/glance
    Break("core/glance/time_strip.cpp", "until = std::max(until, period.end);", "until = period.end;"),
    Break("core/glance/crops.cpp", "crops_.size() > max_crops || bytes_ > max_bytes", "crops_.size() > max_crops && bytes_ > max_bytes"),
    Break("core/glance/objects.cpp", "!row_of(events[k].kind).is_thing, -weight_of", "row_of(events[k].kind).is_thing, -weight_of"),
    Break("core/glance/objects.cpp", "length > 0 ? (seconds - before.at.seconds) / length", "length > 0 ? (after->at.seconds - seconds) / length"),
    # core/store
    Break("core/store/manifest.cpp", "frame.pts < frames.back().pts", "frame.pts < frames.front().pts"),
    # core/page
    Break("core/page/moments.cpp", "if (taken_ > 0) tick = std::max(tick, last_tick_ + 1);", ""),
    # core/archive
    Break("core/archive/lock_file.cpp", "if (!is_same_file(file, path)) {", "if (file < 0) {"),
    Break("core/archive/prune.cpp", "::lstat(path.c_str(), &status) != 0 && (errno == ENOENT || errno == ENOTDIR)", "::lstat(path.c_str(), &status) != 0"),
    # gl
    Break("gl/framebuffer.cpp", "std::min(left + width, picture.width)", "left + width"),
    Break("gl/brick_window.cpp", "return same_before && same_after ?", "return same_before || same_after ?"),
    # cli
    Break("cli/app/window.cpp", "key.number -= plan_.window.brick_frames();", "key.number += plan_.window.brick_frames();"),
    Break("cli/commands/footage.cpp", "part.span.start = std::max(0.0, from - file.begin);", "part.span.start = std::max(0.0, file.begin - from);"),
    Break("cli/options/parse_value.cpp", "(!last && *value != std::floor(*value))", "(last && *value != std::floor(*value))"),
    Break("cli/workers/worker_message.cpp", "if (message.warnings.size() == most_warnings) break;", ""),
]
