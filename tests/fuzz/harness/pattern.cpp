// Names of outputs with a field for a number.
#include "core/image/name_pattern.h"
#include "tests/fuzz/input.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace vvr;
    const std::string text(fuzz::text_of(data, size));
    const auto pattern = fuzz::parsed([&] { return image::NamePattern(text); });
    if (!pattern) return 0;
    const auto first = pattern->at(1);
    fuzz::require(pattern->has_field() == (first != pattern->at(2)), "names differ where there is a field");
    fuzz::require(first.parent_path() == std::filesystem::path(text).parent_path(), "a name stays in its folder");
    return 0;
}
