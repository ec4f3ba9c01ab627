#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace vvr {

/// The name of an output file, with at most one field that numbers fill in. A field stands in the last part of the
/// path and is `{frame:4}`, `{brick:4}` (the number is the least count of digits; without `:4`, as many as it takes),
/// `####` (two or more, as many digits) or `%04d`.
class NamePattern {
  public:
    NamePattern() = default;

    /// \throws Error usage when there are two fields, or braces around anything else
    explicit NamePattern(const std::filesystem::path& path);

    /// A name that is none but itself, whatever stands in it.
    static NamePattern literal(const std::filesystem::path& path);

    bool has_field() const { return has_field_; }

    /// What the numbers count: "frame", "brick", or nothing where the field doesn't say.
    const std::string& counts() const { return counts_; }

    /// The file for a number; the name as it stands where there is no field.
    std::filesystem::path at(std::int64_t number) const;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    bool has_field_ = false;
    std::string before_;  ///< of the last part of the path
    std::string after_;
    std::string counts_;
    int digits_ = 0;
};

}  // namespace vvr
