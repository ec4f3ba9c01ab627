#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace re2 {
class RE2;
}

namespace vvr::video {

/// A time as written in a file name.
struct NamedTime {
    std::int64_t clock = 0;             ///< seconds since 1970-01-01 00:00 on the recorder's clock
    std::optional<std::int64_t> ahead;  ///< offset from UTC, seconds; none = local time

    friend bool operator==(const NamedTime&, const NamedTime&) = default;
};

/// The meaning of a field in a pattern.
enum class NameField {
    text,
    camera,
    number,
    year,
    year_of_century,
    month,
    day,
    hour,
    minute,
    second,
    epoch,
    epoch_ms,
    zone,
    count
};

/// The values of a pattern's fields in a file name.
struct NameFields {
    std::string camera{};
    std::array<std::optional<std::int64_t>, static_cast<std::size_t>(NameField::count)> values{};
    bool contradicts = false;  ///< the name has two values of one field

    const std::optional<std::int64_t>& operator[](NameField field) const {
        return values[static_cast<std::size_t>(field)];
    }

    /// The time in the name. Empty if there is none or it doesn't exist, such as February 30.
    /// \param utc whether a time without a time zone is in UTC
    std::optional<NamedTime> time(bool utc) const;
};

/// A pattern of file names, text with fields, compiled to a regular expression. Matching takes time linear in the
/// name's length, so untrusted names are safe.
class RecorderPattern {
  public:
    enum class Words {
        fields,         ///< the fields in docs/archive.md
        fields_and_own  ///< also the fields of known recorders' patterns
    };

    /// \throws Error usage for an unknown field, or if no field is the camera or a time
    explicit RecorderPattern(std::string_view pattern, Words words = Words::fields);

    /// Empty if the path doesn't match.
    /// \param path matched by its last folders, as many as the pattern has
    std::optional<NameFields> read(std::string_view path) const;

  private:
    std::shared_ptr<const re2::RE2> expression_;
    std::vector<NameField> captures_;
};

}  // namespace vvr::video
