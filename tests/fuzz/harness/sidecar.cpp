// Sidecars of an archive, and the names in them.
#include "core/archive/sidecar.h"

#include "core/base/file.h"
#include "tests/fuzz/input.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace vvr;
    const std::string text(fuzz::text_of(data, size));
    fuzz::require(archive::path_of_text(archive::text_of_path(text)) == text, "a path comes back from its text");
    const auto sidecar = archive::parse_sidecar(text);
    if (!sidecar) return 0;
    fuzz::require(is_plain_path(sidecar->clip.path), "the clip is below its folder");
    const std::string written = archive::format_sidecar(*sidecar);
    const auto again = archive::parse_sidecar(written);
    fuzz::require(again && archive::format_sidecar(*again) == written, "a sidecar is read as it is written");
    return 0;
}
