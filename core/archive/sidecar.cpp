#include "core/archive/sidecar.h"

#include <span>

#include <fmt/format.h>

#include "core/archive/output_files.h"
#include "core/archive/pieces.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/file.h"

namespace vvr::archive {

namespace fs = std::filesystem;

void write_sidecar(const fs::path& out, const Sidecar& sidecar) {
    const std::string text = format_sidecar(sidecar);
    const fs::path file = sidecar_path(out, sidecar.clip.path);
    check_own_place(file);
    replace_link(file, std::as_bytes(std::span(text)));
}

std::optional<Sidecar> read_sidecar(const fs::path& out, const std::string& clip) {
    return read_sidecar_file(out, sidecar_path("", clip).string());
}

std::optional<Sidecar> read_sidecar_file(const fs::path& out, const std::string& file, std::string* problem) {
    const OwnText own = read_own(out / file, fmt::format("{{\n  \"{}\"", sidecar_mark), largest_sidecar);
    if (problem != nullptr) *problem = own.problem;
    if (!own.text) return std::nullopt;
    std::optional<Sidecar> sidecar = parse_sidecar(*own.text);
    return sidecar && sidecar_path("", sidecar->clip.path).string() == file ? sidecar : std::nullopt;
}

bool lacks_pieces(const Sidecar& sidecar) {
    return sidecar.state == Sidecar::State::done && sidecar.code && row_of(*sidecar.code).kind == ErrorKind::io;
}

bool is_limit_raised(const Sidecar& sidecar, const TryLimits& now) {
    if (!sidecar.limits || !sidecar.code) return false;
    if (*sidecar.code == ErrorCode::worker_timeout) return now.seconds == 0 || now.seconds > sidecar.limits->seconds;
    return row_of(*sidecar.code).kind == ErrorKind::limit && now.memory > sidecar.limits->memory;
}

Sidecar::Shown shown_by(const Sidecar& sidecar) {
    return sidecar.shows.value_or(Sidecar::Shown{sidecar.clip, sidecar.settings});
}

std::vector<std::string> remove_outputs(const fs::path& out, const Sidecar& sidecar) {
    std::vector<fs::path> files;
    for (const OutputKind kind : sidecar.files) files.push_back(output_path(out, sidecar.clip.path, kind));
    files.push_back(sidecar_path(out, sidecar.clip.path));
    std::vector<std::string> removed;
    for (const fs::path& piece : remove_pieces(pieces_folder(out, sidecar.clip.path), sidecar.pieces)) {
        removed.push_back(piece.lexically_relative(out).string());
    }
    for (const fs::path& file : files) {
        if (remove_own(file)) removed.push_back(file.lexically_relative(out).string());
    }
    return removed;
}

}  // namespace vvr::archive
