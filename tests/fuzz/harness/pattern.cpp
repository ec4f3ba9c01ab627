// Names of outputs with a field for a number.
#include "core/image/name_pattern.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view input) {
    const std::string text(input);
    const auto pattern = parsed([&] { return image::NamePattern(text); });
    if (!pattern) return;
    const auto first = pattern->at(1);
    require(pattern->has_field() == (first != pattern->at(2)), "names differ where there is a field");
    require(first.parent_path() == std::filesystem::path(text).parent_path(), "a name stays in its folder");
}
