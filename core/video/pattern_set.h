#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <re2/re2.h>
#include <re2/set.h>

namespace vvr::video {

/// The options of regular expressions for the names of files: a name is bytes, of any value.
re2::RE2::Options name_options();

/// Many regular expressions that are matched in one pass over a text, instead of one pass each.
class PatternSet {
  public:
    /// \param expressions in the syntax of RE2
    explicit PatternSet(std::span<const std::string> expressions);

    /// The indices of the expressions that may match the whole text: at least those of all that do.
    std::vector<std::size_t> matching(std::string_view text) const;

  private:
    std::size_t count_;
    re2::RE2::Set set_;
};

}  // namespace vvr::video
