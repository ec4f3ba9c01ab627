#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "core/fields/seed_file.h"
#include "core/fields/field_source.h"

namespace vvr {

/// Fields whose seeds stand in a folder of lists (the external list of §4.2), whatever else they come from.
class ListedSeeds final : public FieldSource {
  public:
    /// Reads every `.txt` of the folder; a frame without a list has no seeds.
    /// \throws Error io for a folder or file that can't be read, for what isn't a list of seeds, for two lists of one
    ///         frame, and for a list for fields of another size
    ListedSeeds(std::unique_ptr<FieldSource> fields, const std::string& folder);

    const VideoInfo& info() const override { return fields_->info(); }
    Size field_size() const override { return fields_->field_size(); }
    std::int64_t expected_frames() const override { return fields_->expected_frames(); }

    /// A few lists have been chosen by someone, so all of them count; of many only those at the interval asked for.
    std::int64_t interval(std::int64_t asked) const override;
    bool has_pictures() const override { return fields_->has_pictures(); }

    FieldSummary read(const FieldNeeds& needs, const FieldSink& sink) override;

  private:
    std::unique_ptr<FieldSource> fields_;
    std::map<std::int64_t, SeedList> lists_;
};

}  // namespace vvr
