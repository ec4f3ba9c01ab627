#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace vvr::image {

/// The name of an output file with at most one field for a number. The field is in the last part of the path:
/// `{frame:4}` or `{brick:4}` (at least 4 digits; without `:4`, as many as needed), `####` (two or more `#`, one per
/// digit) or `%04d`.
class NamePattern {
  public:
    NamePattern() = default;

    /// \throws Error usage for two fields, or an unknown field in braces
    explicit NamePattern(const std::filesystem::path& path);

    /// A name without a field, even if `path` contains the text of one.
    static NamePattern literal(const std::filesystem::path& path);

    bool has_field() const { return has_field_; }

    /// What the numbers count: "frame", "brick", or empty if unspecified.
    const std::string& counts() const { return counts_; }

    /// The path for a number. Without a field, the path itself.
    std::filesystem::path at(std::int64_t number) const;

    /// Whether a file name in the same folder matches the pattern.
    bool may_be(const std::string& file) const;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    bool has_field_ = false;
    std::string before_;  ///< text before the field in the last part of the path
    std::string after_;
    std::string counts_;
    int digits_ = 0;
};

}  // namespace vvr::image
