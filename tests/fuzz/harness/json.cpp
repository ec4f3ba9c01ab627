// JSON of anybody: however deep, it is read or none.
#include <string>

#include "core/base/json_text.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view input) {
    const nlohmann::ordered_json json = parse_json(input);
    if (json.is_discarded()) return;
    const std::string text = json_text(json);
    require(json_text(parse_json(text)) == text, "JSON is read as it is written");
}
