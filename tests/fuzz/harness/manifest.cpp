// Manifests of data folders.
#include "core/dataset/manifest.h"

#include "core/fields/filter.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view text) {
    const auto manifest = parsed([&] { return dataset::parse_manifest(text, "manifest.json"); });
    if (!manifest) return;
    const dataset::Manifest again = dataset::parse_manifest(dataset::format_manifest(*manifest), "again");
    require(again.frames == manifest->frames, "frames are read as they are written");
    for (const auto& [name, value] : again.settings) {
        if (name == "filter") fields::row_of(Name<fields::FilterRow>{value});
    }
    require(again.settings.size() == manifest->settings.size(), "settings too");
}
