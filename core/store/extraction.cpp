#include "core/store/extraction.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/lock_file.h"
#include "core/base/plane.h"
#include "core/fields/flo_file.h"
#include "core/fields/planes.h"
#include "core/fields/seed_list.h"
#include "core/fields/settings.h"
#include "core/image/picture_codec.h"
#include "core/image/png.h"

namespace vvr::store {

namespace {

namespace fs = std::filesystem;

std::vector<std::byte> encode(Size size, int channels, std::span<const std::uint8_t> values) {
    // Differences are mostly empty, so the fastest level without a filter compresses them well enough.
    return image::png_codec().encode({.format = "png",
                                      .name = "a plane.png",
                                      .size = size,
                                      .colours = channels,
                                      .png_level = 1,
                                      .png_filter = image::png_filter::none,
                                      .values = std::as_bytes(values)});
}

void swap_red_and_blue(Plane<Bgr>& plane) {
    for (Bgr& pixel : plane.pixels()) std::swap(pixel[0], pixel[2]);
}

std::vector<std::byte> encode_grey(const Plane<std::uint8_t>& plane) {
    return encode(plane.size(), 1, plane.pixels());
}

/// Encodes a colour plane.
std::vector<std::byte> encode_colour(const Plane<Bgr>& plane) {
    Plane<Bgr> rgb = plane;
    swap_red_and_blue(rgb);
    return encode(plane.size(), 3, {rgb.pixels().front().data(), 3 * rgb.pixels().size()});
}

/// Reads an 8-bit plane with one channel.
/// \throws Error io if it can't be read, or has another format or size
Plane<std::uint8_t> read_grey(const std::filesystem::path& path, Size size) {
    check_is_file(path.string(), most_bytes::data);
    auto plane = Plane<std::uint8_t>::for_overwrite(size);
    image::read_png_bytes(path, 1, plane.size(), plane.pixels());
    return plane;
}

/// Reads a plane with three channels.
/// \throws Error as `read_grey`
Plane<Bgr> read_colour(const std::filesystem::path& path, Size size) {
    check_is_file(path.string(), most_bytes::data);
    auto plane = Plane<Bgr>::for_overwrite(size);
    image::read_png_bytes(path, 3, plane.size(), {plane.pixels().front().data(), 3 * plane.pixels().size()});
    swap_red_and_blue(plane);
    return plane;
}

fields::Reference read_scene(const std::filesystem::path& path, Size size) {
    fields::Planes scene{Plane<std::uint8_t>(size), read_colour(path, size)};
    std::ranges::transform(scene.colour.pixels(), scene.grey.pixels().begin(),
                           [](const Bgr& bgr) { return static_cast<std::uint8_t>(fields::brightness_of(bgr)); });
    return scene;
}

struct CloseFile {
    // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): the std::unique_ptr with this deleter owns it
    void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void fail(const fs::path& path, int error) {
    throw system_error(error, fmt::format("cannot write '{}'", path.string()),
                       "free some space, fix its permissions or choose another folder");
}

template <class Bytes>
std::span<const std::byte> bytes_of(const Bytes& bytes) {
    return std::as_bytes(std::span(bytes.data(), bytes.size()));
}

/// All that is stored beside the manifest.
constexpr std::array data_names{stored::scalar,    stored::flow,     stored::seeds, stored::colour,
                                stored::reference, stored::infrared, stored::first, stored::last};

/// Folders in a folder of data, while an older extraction is replaced: the new data, and the older ones.
constexpr const char* new_data = ".vvr-new";
constexpr const char* older_data = ".vvr-older";

/// Waits until all files of the file system are on the disk. To sync each file takes longer than everything else.
/// \param place a folder in that file system
void sync_files(const fs::path& place) {
    const Descriptor folder(::open(place.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.get() < 0 || ::syncfs(folder.get()) != 0) fail(place, errno);
}

/// Whether the folder has nothing but what a run leaves that is killed before its first manifest is complete.
/// \throws Error io if it can't be listed
bool has_only_leftovers(const fs::path& folder) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        const fs::path& path = entry->path();
        if (!is_temporary_of(stored::manifest, path) && !LockFile::is_lock_of(stored::manifest, path)) return false;
    }
    if (error)
        throw system_error(error.value(), fmt::format("cannot list the folder '{}'", folder.string()),
                           "fix its permissions or choose another folder");
    return true;
}

/// Two runs that write the same names would mix their data, and one that fails would remove the data of the other.
/// \throws Error file_locked if another run is writing to the folder
LockFile lock_folder(const fs::path& folder) {
    std::optional<LockFile> lock = LockFile::try_take(folder, stored::manifest);
    if (!lock) {
        throw Error(ErrorCode::file_locked,
                    fmt::format("cannot write to '{}': another `vvr extract` is writing to this folder; wait until it "
                                "has ended, or choose another folder",
                                folder.string()));
    }
    return std::move(*lock);
}

}  // namespace

void check_data_folder(const fs::path& folder) {
    std::error_code error;
    if (!fs::exists(folder, error)) {
        const fs::path whole = folder.lexically_normal();  // drops a trailing slash
        check_file_path(whole.has_filename() ? whole : whole.parent_path());
        return;
    }
    if (!fs::is_directory(folder)) {
        throw Error(ErrorCode::not_a_folder,
                    fmt::format("cannot write to '{}': it is not a folder; choose another name", folder.string()));
    }
    if (!has_only_leftovers(folder) && !is_replaceable(folder)) {
        throw Error(ErrorCode::folder_not_empty, fmt::format("cannot write to '{}': the folder has files that `vvr "
                                                             "extract` did not write; choose a new or empty folder",
                                                             folder.string()));
    }
    check_file_path(folder / stored::manifest);
    lock_folder(folder);  // released at once: this run may take long to its first frame, or never have one
}

DataFolder::DataFolder(fs::path folder, std::int64_t flow_every) : folder_(std::move(folder)), flow_every_(flow_every) {
    check_data_folder(folder_);
    std::error_code error;
    created_ = fs::create_directory(folder_, error);
    if (error) fail(folder_, error.value());
    lock_.emplace(lock_folder(folder_));
    fs::remove_all(folder_ / new_data, error);
    fs::remove_all(folder_ / older_data, error);
    if (has_complete_data(folder_)) {
        place_ = folder_ / new_data;
        fs::create_directory(place_, error);
        if (error) fail(place_, error.value());
    } else {
        place_ = folder_;
        // With this manifest, the next run recognises the folder if this run is killed.
        replace_file(folder_ / stored::manifest, bytes_of(unfinished_manifest()));
        remove_data();
    }
    for (const char* name : {stored::scalar, stored::flow, stored::seeds, stored::colour}) {
        fs::create_directory(place_ / name, error);
        if (error) fail(folder_ / name, error.value());
    }
}

DataFolder::~DataFolder() {
    std::error_code none;
    if (place_ != folder_) {
        fs::remove_all(folder_ / new_data, none);
        fs::remove_all(folder_ / older_data, none);
        return;
    }
    // Keeps the manifest if files remain, so that the next run recognises the folder.
    if (closed_ || !remove_data()) return;
    fs::remove(folder_ / stored::manifest, none);
    lock_.reset();  // its file is in the folder
    if (created_) fs::remove(folder_, none);
}

bool DataFolder::remove_data() const {
    bool removed = true;
    for (const char* name : data_names) {
        std::error_code error;
        fs::remove_all(folder_ / name, error);
        removed = removed && !error;
    }
    return removed;
}

/// Puts the new data in the place of the older ones. All is on the disk before, so that only renames follow, which can
/// be undone. The manifest is unfinished meanwhile: so the next run recognises the folder if this one is killed.
void DataFolder::replace_older(const std::string& manifest) const {
    const fs::path older = folder_ / older_data;
    const fs::path place = folder_ / stored::manifest;
    std::error_code error;
    fs::create_directory(older, error);
    if (!error) fs::copy_file(place, older / stored::manifest, error);
    if (error) fail(older, error.value());
    write(stored::manifest, bytes_of(manifest));
    write("unfinished.json", bytes_of(unfinished_manifest()));
    sync_files(place_);
    std::vector<std::pair<fs::path, fs::path>> moves{{place_ / "unfinished.json", place}};
    for (const char* name : data_names) {
        if (fs::exists(fs::symlink_status(folder_ / name, error))) moves.emplace_back(folder_ / name, older / name);
    }
    for (const char* name : data_names) {
        if (fs::exists(place_ / name, error)) moves.emplace_back(place_ / name, folder_ / name);
    }
    moves.emplace_back(place_ / stored::manifest, place);
    std::size_t moved = 0;
    while (moved < moves.size()) {
        fs::rename(moves[moved].first, moves[moved].second, error);
        if (error) break;
        ++moved;
    }
    if (moved == moves.size()) return;
    std::error_code none;
    while (moved > 1) {
        --moved;
        fs::rename(moves[moved].second, moves[moved].first, none);
    }
    fs::rename(older / stored::manifest, place, none);
    fail(folder_, error.value());
}

// Doesn't sync each file as `replace_file` does; `close` syncs them all. The manifest is written last and marks the
// folder as complete.
void DataFolder::write(const fs::path& file, std::span<const std::byte> bytes) const {
    const fs::path path = place_ / file;
    std::unique_ptr<std::FILE, CloseFile> out(std::fopen(path.c_str(), "wb"));
    if (!out || std::fwrite(bytes.data(), 1, bytes.size(), out.get()) != bytes.size()) fail(folder_ / file, errno);
    if (std::fclose(out.release()) != 0) fail(folder_ / file, errno);
}

void DataFolder::add(const video::Frame& frame, const fields::Field& field) {
    StoredFrame stored{field.index, field.pts, {}, field.infrared};
    write(stored::scalar_file(field.index), bytes_of(encode_grey(field.scalar)));
    write(stored::colour_file(field.index), bytes_of(encode_colour(frame.colour)));
    // Some filters compute flow for every frame.
    if (flow_every_ > 0 && field.index % flow_every_ == 0 && !field.flow.u.empty()) {
        write(stored::flow_file(field.index), bytes_of(fields::encode_flo(field.flow)));
        write(stored::seed_file(field.index),
              bytes_of(fields::format_seeds({field.index, field.scalar.size(), field.seeds})));
        stored.seeds = std::ssize(field.seeds);
    }
    if (frames_.empty()) {
        write(stored::first, bytes_of(encode_colour(frame.colour)));
    } else {
        stored.gap = field.index - frames_.back().index - 1;
    }
    frames_.push_back(stored);
    last_ = frame.colour;
}

void DataFolder::close(Manifest manifest, const fields::Reference& reference) {
    write(stored::last, bytes_of(encode_colour(last_)));
    const auto write_scene = [&](const char* name, const fields::Reference& scene) {
        write(name, bytes_of(scene.colour.empty() ? encode_grey(scene.grey) : encode_colour(scene.colour)));
    };
    manifest.reference = !reference.grey.empty();
    manifest.infrared = reference.infrared != nullptr;
    if (manifest.reference) write_scene(stored::reference, reference);
    if (manifest.infrared) write_scene(stored::infrared, *reference.infrared);
    manifest.flow_every = flow_every_;
    manifest.colour = true;
    manifest.frames = frames_;
    if (place_ != folder_) {
        replace_older(format_manifest(manifest));
    } else {
        sync_files(folder_);
        replace_file(folder_ / stored::manifest, bytes_of(format_manifest(manifest)));
    }
    closed_ = true;
}

namespace {

using Settings = image::Metadata;

bool is_time_range(const std::string& option) {
    return option == "start" || option == "end";
}

bool same_clip(const video::VideoInfo& a, const video::VideoInfo& b) {
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
    video::FrameSpan span = parts_.front().manifest.span;
    span.end = last.span.end;
    span.stop = last.span.stop;
    return vvr::video::expected_frames(last.clip, span);
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
    field.infrared = frame.infrared;
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
        if (some.manifest.infrared) {
            summary.reference.infrared =
                std::make_shared<const fields::Reference>(read_scene(some.folder / stored::infrared, field_size()));
        }
        if (needs.scene) needs.scene(summary.reference);
    }
    for (const Part& part : parts_) {
        for (const StoredFrame& stored : part.manifest.frames) {
            video::Frame frame{.index = stored.index, .pts = stored.pts, .grey = {}, .colour = {}};
            const bool first = &stored == &parts_.front().manifest.frames.front();
            const bool last = &stored == &parts_.back().manifest.frames.back();
            if (needs.colour) {
                frame.colour = read_colour(part.folder / stored::colour_file(stored.index), field_size());
            } else if (first || last) {
                frame.colour = read_colour(part.folder / (first ? stored::first : stored::last), field_size());
            }
            ++summary.frames;
            sink(std::make_shared<const video::Frame>(std::move(frame)), read_field(part, stored, needs));
        }
    }
    return summary;
}

}  // namespace vvr::store
