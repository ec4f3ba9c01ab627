// Lists of seeds, and what is chosen of them.
#include "core/fields/seeds.h"

#include "core/fields/seed_list.h"
#include "tests/fuzz/input.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace vvr;
    const std::string_view text = fuzz::text_of(data, size);
    const auto list = fuzz::parsed([&] { return fields::parse_seeds(text, "list.txt"); });
    if (list)
        fuzz::require(fields::parse_seeds(fields::format_seeds(*list), "again") == *list,
                      "a list is read as it is written");
    fuzz::parsed([&] { return fields::parse_seed_selection(std::string(text)).count; });
    return 0;
}
