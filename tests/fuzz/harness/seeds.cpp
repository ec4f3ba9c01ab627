// Lists of seeds, and what is chosen of them.
#include "core/fields/seeds.h"

#include "core/fields/seed_list.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view text) {
    const auto list = parsed([&] { return fields::parse_seeds(text, "list.txt"); });
    if (list)
        require(fields::parse_seeds(fields::format_seeds(*list), "again") == *list, "a list is read as it is written");
    parsed([&] { return fields::parse_seed_selection(std::string(text)).count; });
}
