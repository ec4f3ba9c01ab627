// Text that others wrote, as it is shown, and addresses.
#include <algorithm>

#include "core/base/text.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view text) {
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
    const std::string shown = shown_text(text);
    require(std::ranges::none_of(shown, is_control), "nothing controls a terminal");
    require(shown.find("\xe2\x80\xae") == std::string::npos, "nothing turns the direction");
    for (std::string_view rest = shown; !rest.empty();) {
        const auto character = first_character(rest);
        require(character.has_value(), "what is shown is UTF-8");
        rest.remove_prefix(character->length);
    }
    require(redact_secrets(text).size() <= text.size(), "secrets are left out");
}
