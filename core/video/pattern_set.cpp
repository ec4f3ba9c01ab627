#include "core/video/pattern_set.h"

#include <numeric>

#include "core/base/error.h"

namespace vvr::video {

namespace {

re2::RE2::Options options_of(std::span<const re2::RE2* const> expressions) {
    re2::RE2::Options options = expressions.front()->options();
    options.set_max_mem(16 << 20);  // an automaton for all of them has more states than one for each
    return options;
}

}  // namespace

PatternSet::PatternSet(std::span<const re2::RE2* const> expressions)
    : count_(expressions.size()), set_(options_of(expressions), re2::RE2::ANCHOR_BOTH) {
    for (const re2::RE2* const expression : expressions) set_.Add(expression->pattern(), nullptr);
    if (!set_.Compile())
        throw Error(ErrorCode::out_of_memory, "RE2::Set::Compile: no memory for the patterns of names");
}

std::vector<std::size_t> PatternSet::matching(std::string_view text) const {
    std::vector<int> found;
    re2::RE2::Set::ErrorInfo error{re2::RE2::Set::kNoError};
    set_.Match(re2::StringPiece(text.data(), text.size()), &found, &error);
    std::vector<std::size_t> indices(found.begin(), found.end());
    if (error.kind != re2::RE2::Set::kNoError) {  // the states didn't fit: each may match
        indices.resize(count_);
        std::iota(indices.begin(), indices.end(), std::size_t{0});
    }
    return indices;
}

}  // namespace vvr::video
