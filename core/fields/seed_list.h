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

/// The seeds of one frame, as in a text file (§4.2: S_1, S_2, …). docs/formats.md has the format.
struct SeedList {
    std::int64_t frame = 0;  ///< number of the frame in the clip
    Size size;               ///< of the field
    std::vector<Seed> seeds;

    friend bool operator==(const SeedList&, const SeedList&) = default;
};

/// The text of a file. Numbers have enough digits to be read back unchanged.
std::string format_seeds(const SeedList& list);

/// Reads a seed list from a file's text.
/// \param name of the file, for error messages
/// \throws Error io with name and line for an invalid list, for numbers that aren't finite, and for points outside the
///        field
SeedList parse_seeds(std::string_view text, const std::string& name);

/// \throws Error io as above, or if the file can't be read
SeedList read_seeds(const std::string& path);

/// The first seed whose flow is not that of the field at its place; null = they all fit.
const Seed* misfit(const std::vector<Seed>& seeds, const Flow& flow);

/// Fields of any source, with seeds from lists (the external list of §4.2).
class ListedSeeds final : public FieldSource {
  public:
    /// \param path a folder, in which each `.txt` is the list of one frame (a frame without a list has no seeds); or
    ///        one file, a list that all frames share (§6), whose points count where the frame's own flow is fast enough
    /// \param options of which only the minimum magnitude is used, for shared points
    /// \param on_object whether shared points count only where the frame's scalar isn't 0
    /// \param compares whether the seeds are compared with the flow of the fields, which is stored
    /// \throws Error io for a folder or file that can't be read, for an invalid list, for two lists of one frame, and
    ///        for a list for fields of another size
    ListedSeeds(std::unique_ptr<FieldSource> fields, const std::string& path, const SeedOptions& options,
                bool on_object, bool compares = false);

    const media::VideoInfo& info() const override { return fields_->info(); }
    Size field_size() const override { return fields_->field_size(); }
    std::int64_t expected_frames() const override { return fields_->expected_frames(); }

    /// All frames if there are only a few lists, because a person chose them; else the requested interval.
    std::int64_t interval(std::int64_t asked) const override;
    bool has_pictures() const override { return fields_->has_pictures(); }
    void read_again(std::span<const double> times, const std::function<void(const media::Frame&)>& sink) override {
        fields_->read_again(times, sink);
    }

    /// The summary has a problem if seeds have another flow than the fields.
    /// \throws Error usage if a shared list needs flow and none is computed
    FieldSummary read(const FieldNeeds& needs, const FieldSink& sink) override;

  private:
    void check_size(const SeedList& list, const std::string& file) const;
    std::vector<Seed> shared_seeds(const Field& field) const;

    std::unique_ptr<FieldSource> fields_;
    std::map<std::int64_t, SeedList> lists_;
    std::optional<SeedList> shared_;
    double min_magnitude_;
    bool on_object_;
    bool compares_;
    std::string path_;
};

}  // namespace vvr::fields
