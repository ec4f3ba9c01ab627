#pragma once

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "core/base/error.h"

// What the harnesses share. A crash, an exception that is no Error, or something that does not hold ends the program.
namespace vvr::fuzz {

/// What a harness does with an input. Each defines it.
void check(std::string_view input);

/// Ends the program where something does not hold that has to hold for every input.
inline void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

/// What a parser makes of an input; nothing where it refuses it with an Error that says something of the input.
template <class Parse>
auto parsed(Parse parse) -> std::optional<decltype(parse())> {
    try {
        return parse();
    } catch (const Error& error) {
        const ErrorKind kind = error.kind();
        require(kind == ErrorKind::usage || kind == ErrorKind::io || kind == ErrorKind::not_video,
                "the kind of the error");
        require(!std::string_view(error.what()).empty(), "the error says something");
        return std::nullopt;
    }
}

}  // namespace vvr::fuzz
