// JSON of anybody: however deep, it is read or none.
#include <string>

#include "core/base/json_text.h"
#include "tests/fuzz/input.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace vvr;
    const nlohmann::ordered_json json = parse_json(fuzz::text_of(data, size));
    if (json.is_discarded()) return 0;
    const std::string text = json_text(json);
    fuzz::require(json_text(parse_json(text)) == text, "JSON is read as it is written");
    return 0;
}
