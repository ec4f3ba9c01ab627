// Sidecars of an archive, and the names in them.
#include "core/archive/sidecar.h"

#include "core/base/file.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view input) {
    const std::string text(input);
    require(archive::path_of_text(archive::text_of_path(text)) == text, "a path comes back from its text");
    const auto sidecar = archive::parse_sidecar(text);
    if (!sidecar) return;
    require(is_plain_path(sidecar->clip.path), "the clip is below its folder");
    const std::string written = archive::format_sidecar(*sidecar);
    const auto again = archive::parse_sidecar(written);
    require(again && archive::format_sidecar(*again) == written, "a sidecar is read as it is written");
}
