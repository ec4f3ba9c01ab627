#include "core/video/pattern_set.h"

#include <numeric>

#include "core/base/error.h"

namespace vvr::video {

namespace {

re2::RE2::Options set_options() {
    re2::RE2::Options options = name_options();
    options.set_max_mem(16 << 20);  // an automaton for all of them has more states than one for each
    return options;
}

}  // namespace

re2::RE2::Options name_options() {
    re2::RE2::Options options(re2::RE2::Latin1);
    options.set_log_errors(false);
    options.set_dot_nl(true);
    return options;
}

PatternSet::PatternSet(std::span<const std::string> expressions)
    : count_(expressions.size()), set_(set_options(), re2::RE2::ANCHOR_BOTH) {
    for (const std::string& expression : expressions) set_.Add(expression, nullptr);
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
