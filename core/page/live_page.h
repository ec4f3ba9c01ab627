#pragma once

#include <cstdint>
#include <string>

#include "core/image/picture.h"

namespace vvr {

/// What the page of a stream shows.
struct LivePageContent {
    std::string name;   ///< of the stream, for people
    std::string state;  ///< of the connection, in a line for people
    std::string span;   ///< length of time in the picture, e.g. "80 s"
    Picture picture;
    Metadata settings;          ///< of the picture
    std::int64_t written = 0;   ///< seconds since 1970
    double brick_seconds = 10;  ///< from one picture to the next
};

/// A page that shows the newest picture, reloads itself for the next one, and says when none has come for long. It
/// needs no other file.
std::string make_live_page(const LivePageContent& content);

}  // namespace vvr
