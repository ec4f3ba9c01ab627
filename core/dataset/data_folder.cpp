#include "core/dataset/data_folder.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/dataset/plane_files.h"
#include "core/fields/flo_file.h"
#include "core/fields/seed_list.h"

namespace vvr::dataset {

namespace fs = std::filesystem;

namespace {

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
constexpr std::array data_names{stored::scalar,    stored::flow,  stored::seeds, stored::colour,
                                stored::reference, stored::views, stored::first, stored::last};

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
    for (const char* name : {stored::scalar, stored::flow, stored::seeds, stored::colour, stored::views}) {
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

void DataFolder::add(const media::Frame& frame, const fields::Field& field) {
    StoredFrame stored{field.index, field.pts, {}, static_cast<std::int64_t>(field.view), field.before};
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
    const auto write_scene = [&](const fs::path& name, const fields::Reference& scene) {
        write(name, bytes_of(scene.colour.empty() ? encode_grey(scene.grey) : encode_colour(scene.colour)));
    };
    manifest.reference = !reference.grey.empty();
    manifest.views = std::ssize(reference.others);
    if (manifest.reference) write_scene(stored::reference, reference);
    for (std::int64_t view = 1; view <= manifest.views; ++view)
        write_scene(stored::view_file(view), reference.of_view(static_cast<std::size_t>(view)));
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

}  // namespace vvr::dataset
