// Reports of a render, as an archive reads them.
#include <nlohmann/json.hpp>

#include "core/archive/sidecar.h"
#include "core/base/error.h"
#include "core/base/json_text.h"
#include "tests/fuzz/input.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace vvr;
    try {
        for (const archive::FoundEvent& event : archive::found_events(parse_json(fuzz::text_of(data, size)), 50)) {
            fuzz::require(archive::found_event_of(archive::json_of(event)) == event,
                          "an event is read as it is written");
        }
    } catch (const nlohmann::json::exception&) {
        return 0;
    } catch (const Error& error) {  // of a kind that is not in the table
        fuzz::require(error.kind() == ErrorKind::io, "an unknown kind is the report's fault");
        return 0;
    }
    return 0;
}
