#pragma once

#include <cstdint>
#include <string>

#include "core/image/picture.h"

namespace vvr {

/// What stands in the page of a stream.
struct LivePageContent {
    std::string name;   ///< of the stream, as people are to read it
    std::string state;  ///< how it goes, in a line
    std::string span;   ///< how much time the picture shows, "80 s" say
    Picture picture;
    Metadata settings;          ///< that made it
    std::int64_t written = 0;   ///< seconds since 1970
    double brick_seconds = 10;  ///< from one picture to the next
};

/// A page that shows the newest picture, loads itself again for the next one, and says when none has come for long. It
/// needs no other file.
std::string make_live_page(const LivePageContent& content);

}  // namespace vvr
