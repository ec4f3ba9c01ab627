// Manifests of data folders.
#include "core/store/manifest.h"

#include "core/fields/filter.h"
#include "tests/fuzz/input.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace vvr;
    const std::string_view text = fuzz::text_of(data, size);
    const auto manifest = fuzz::parsed([&] { return store::parse_manifest(text, "manifest.json"); });
    if (!manifest) return 0;
    const store::Manifest again = store::parse_manifest(store::format_manifest(*manifest), "again");
    fuzz::require(again.frames == manifest->frames, "frames are read as they are written");
    for (const auto& [name, value] : again.settings) {
        if (name == "filter") fields::row_of(Name<fields::FilterRow>{value});
    }
    fuzz::require(again.settings.size() == manifest->settings.size(), "settings too");
    return 0;
}
