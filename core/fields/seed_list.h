#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/fields/field.h"
#include "core/fields/field_source.h"

namespace vvr::fields {

/// The seeds of one frame as they stand in a text file (§4.2: S_1, S_2, ...). The format is in docs/formats.md.
struct SeedList {
    std::int64_t frame = 0;  ///< index of the frame in the clip
    Size size;               ///< of the field
    std::vector<Seed> seeds;

    friend bool operator==(const SeedList&, const SeedList&) = default;
};

/// The file's text. Numbers have as many digits as it takes to read the same ones back.
std::string format_seeds(const SeedList& list);

/// \param name of the file, for the error text
/// \throws Error io with name and line for anything that isn't a seed list, for numbers that aren't finite, and for
///         points outside the field
SeedList parse_seeds(std::string_view text, const std::string& name);

/// \throws Error io as above, or when the file can't be read
SeedList read_seeds(const std::string& path);

/// Fields whose seeds stand in lists (the external list of §4.2), whatever else they come from.
class ListedSeeds final : public FieldSource {
  public:
    /// \param path a folder: every `.txt` in it is the list of one frame, and a frame without one has no seeds. Or a
    ///        file: a list that all frames share (§6), of which each takes the points where its own flow is fast enough
    /// \param options of which the least magnitude holds for shared points
    /// \param on_object shared points are seeds of the frames alone whose scalar isn't 0 there
    /// \throws Error io for a folder or file that can't be read, for what isn't a list of seeds, for two lists of one
    ///         frame, and for a list for fields of another size
    ListedSeeds(std::unique_ptr<FieldSource> fields, const std::string& path, const SeedOptions& options,
                bool on_object);

    const video::VideoInfo& info() const override { return fields_->info(); }
    Size field_size() const override { return fields_->field_size(); }
    std::int64_t expected_frames() const override { return fields_->expected_frames(); }

    /// A few lists have been chosen by someone, so all of them count; of many only those at the interval asked for.
    std::int64_t interval(std::int64_t asked) const override;
    bool has_pictures() const override { return fields_->has_pictures(); }

    /// \throws Error usage where a shared list needs flow, and none is computed
    FieldSummary read(const FieldNeeds& needs, const FieldSink& sink) override;

  private:
    void check_size(const SeedList& list, const std::string& file) const;
    std::vector<Seed> shared_seeds(const Field& field) const;

    std::unique_ptr<FieldSource> fields_;
    std::map<std::int64_t, SeedList> lists_;
    std::optional<SeedList> shared_;
    double min_magnitude_;
    bool on_object_;
};

}  // namespace vvr::fields
