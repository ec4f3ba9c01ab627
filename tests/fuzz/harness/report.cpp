// Reports of a render, as an archive reads them.
#include <nlohmann/json.hpp>

#include "core/archive/sidecar.h"
#include "core/base/error.h"
#include "core/base/json_text.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view input) {
    try {
        for (const archive::FoundEvent& event : archive::found_events(parse_json(input), 50)) {
            require(archive::found_event_of(archive::json_of(event)) == event, "an event is read as it is written");
        }
    } catch (const nlohmann::json::exception&) {
        return;
    } catch (const Error& error) {  // of a kind that is not in the table
        require(error.kind() == ErrorKind::io, "an unknown kind is the report's fault");
    }
}
