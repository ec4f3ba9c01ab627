// Manifests of data folders.
#include "core/store/manifest.h"

#include "core/fields/filter.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view text) {
    const auto manifest = parsed([&] { return store::parse_manifest(text, "manifest.json"); });
    if (!manifest) return;
    const store::Manifest again = store::parse_manifest(store::format_manifest(*manifest), "again");
    require(again.frames == manifest->frames, "frames are read as they are written");
    for (const auto& [name, value] : again.settings) {
        if (name == "filter") fields::row_of(Name<fields::FilterRow>{value});
    }
    require(again.settings.size() == manifest->settings.size(), "settings too");
}
