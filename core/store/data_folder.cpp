#include "core/store/data_folder.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/fields/flo_file.h"
#include "core/fields/seed_file.h"
#include "core/image/atomic_file.h"
#include "core/store/grey_file.h"

namespace vvr::store {
namespace {

namespace fs = std::filesystem;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void fail(const fs::path& path, int error) {
    throw Error(ErrorKind::io, fmt::format("cannot write '{}': {}; free some space, fix its permissions or choose "
                                           "another folder",
                                           path.string(), std::generic_category().message(error)));
}

template <class Bytes>
std::span<const std::byte> bytes_of(const Bytes& bytes) {
    return std::as_bytes(std::span(bytes.data(), bytes.size()));
}

}  // namespace

void check_data_folder(const fs::path& folder) {
    std::error_code error;
    if (!fs::exists(folder, error)) {
        const fs::path whole = folder.lexically_normal();  // which may end in a slash
        image::check_file_path(whole.has_filename() ? whole : whole.parent_path());
        return;
    }
    if (!fs::is_directory(folder)) {
        throw Error(ErrorKind::io,
                    fmt::format("cannot write to '{}': it is not a folder; choose another one", folder.string()));
    }
    if (!fs::is_empty(folder) && !is_replaceable(folder)) {
        throw Error(ErrorKind::io,
                    fmt::format("cannot write to '{}': it holds other files, and no manifest of `vvr extract`; choose "
                                "a new or an empty folder",
                                folder.string()));
    }
    image::check_file_path(folder / stored::manifest);
}

DataFolder::DataFolder(fs::path folder, std::int64_t flow_every, bool colour)
    : folder_(std::move(folder)), flow_every_(flow_every), colour_(colour) {
    check_data_folder(folder_);
    std::error_code error;
    made_ = fs::create_directory(folder_, error);
    if (error) fail(folder_, error.value());
    // From here on a run that is killed leaves a folder that the next one knows for its own.
    image::replace_file(folder_ / stored::manifest, bytes_of(unfinished_manifest()));
    remove_data();
    for (const char* name : {stored::scalar, stored::flow, stored::seeds, stored::colour}) {
        if (name == stored::colour && !colour_) continue;
        fs::create_directory(folder_ / name, error);
        if (error) fail(folder_ / name, error.value());
    }
}

DataFolder::~DataFolder() {
    // Without its manifest, what can't be removed would be another's to the next run.
    if (closed_ || !remove_data()) return;
    std::error_code none;
    fs::remove(folder_ / stored::manifest, none);
    if (made_) fs::remove(folder_, none);
}

bool DataFolder::remove_data() const {
    bool removed = true;
    for (const char* name : {stored::scalar, stored::flow, stored::seeds, stored::colour, stored::old_colour,
                             stored::reference, stored::first, stored::last}) {
        std::error_code error;
        fs::remove_all(folder_ / name, error);
        removed = removed && !error;
    }
    return removed;
}

// Not each file by itself to the disk, as `replace_file` does: that takes longer than all the rest. The manifest, which
// comes last, tells a whole folder from one that isn't.
void DataFolder::write(const fs::path& file, std::span<const std::byte> bytes) const {
    const fs::path path = folder_ / file;
    std::unique_ptr<std::FILE, CloseFile> out(std::fopen(path.c_str(), "wb"));
    if (!out || std::fwrite(bytes.data(), 1, bytes.size(), out.get()) != bytes.size()) fail(path, errno);
    if (std::fclose(out.release()) != 0) fail(path, errno);
}

void DataFolder::add(const video::Frame& frame, const fields::Field& field) {
    StoredFrame stored{field.index, field.pts, {}};
    write(stored::scalar_file(field.index), bytes_of(encode_grey(field.scalar)));
    if (colour_) write(stored::colour_file(field.index), bytes_of(encode_colour(frame.colour)));
    // Some filters make flow at every frame, wanted or not.
    if (flow_every_ > 0 && field.index % flow_every_ == 0 && !field.flow.u.empty()) {
        write(stored::flow_file(field.index), bytes_of(fields::encode_flo(field.flow)));
        write(stored::seed_file(field.index),
              bytes_of(fields::format_seeds({field.index, field.scalar.size(), field.seeds})));
        stored.seeds = std::ssize(field.seeds);
    }
    if (frames_.empty()) write(stored::first, bytes_of(encode_colour(frame.colour)));
    frames_.push_back(stored);
    last_ = frame.colour;
}

void DataFolder::close(Manifest manifest, const fields::Reference& reference) {
    write(stored::last, bytes_of(encode_colour(last_)));
    manifest.reference = !reference.grey.empty();
    if (manifest.reference) {
        write(stored::reference,
              bytes_of(reference.colour.empty() ? encode_grey(reference.grey) : encode_colour(reference.colour)));
    }
    manifest.flow_every = flow_every_;
    manifest.colour = colour_;
    manifest.frames = frames_;
    image::replace_file(folder_ / stored::manifest, bytes_of(format_manifest(manifest)));
    closed_ = true;
}

}  // namespace vvr::store
