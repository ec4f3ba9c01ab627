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

/// A time as a name has it.
struct NamedTime {
    std::int64_t clock = 0;             ///< seconds since 1970-01-01 00:00 on the recorder's clock
    std::optional<std::int64_t> ahead;  ///< seconds that this clock is ahead of UTC; none = it is on the local wall

    friend bool operator==(const NamedTime&, const NamedTime&) = default;
};

/// What a part of a pattern stands for.
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

/// What a name said in the fields of a pattern.
struct NameFields {
    std::string camera{};
    std::array<std::optional<std::int64_t>, static_cast<std::size_t>(NameField::count)> values{};
    bool contradicts = false;  ///< it says two things of one field

    const std::optional<std::int64_t>& operator[](NameField field) const {
        return values[static_cast<std::size_t>(field)];
    }

    /// The time that it tells; nothing when it tells none, or one that no calendar has.
    /// \param utc whether a time without a zone is in UTC
    std::optional<NamedTime> time(bool utc) const;
};

/// A way to name files, text with fields, as a regular expression. It takes time in proportion to the name's length,
/// whoever wrote the name.
class RecorderPattern {
  public:
    enum class Words {
        fields,         ///< those that docs/archive.md lists
        fields_and_own  ///< those of the rows of known recorders too
    };

    /// \throws Error usage for an unknown field, or when no field tells the camera or the time
    explicit RecorderPattern(std::string_view pattern, Words words = Words::fields);

    /// \param path of which as many of the last folders are looked at as the pattern has
    std::optional<NameFields> read(std::string_view path) const;

  private:
    std::shared_ptr<const re2::RE2> expression_;
    std::vector<NameField> captures_;
};

}  // namespace vvr::video
