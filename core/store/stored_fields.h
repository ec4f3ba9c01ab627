#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/fields/field_source.h"
#include "core/store/manifest.h"

namespace vvr::store {

/// Fields that `vvr extract` wrote, to one directory or to several with the consecutive parts of a clip.
class StoredFields final : public fields::FieldSource {
  public:
    /// Reads the manifests; the data files are read, and checked, when their turn comes.
    /// \throws Error io or not_video for a manifest that can't be, usage for parts that don't belong together
    explicit StoredFields(std::span<const std::string> folders);

    /// Of the whole clip, as its container told, where the parts begin and end where it does; else of what is here.
    const video::VideoInfo& info() const override { return info_; }
    Size field_size() const override { return parts_.front().manifest.field_size; }

    /// What the clip itself would have given, so that both make the same picture.
    std::int64_t expected_frames() const override;
    std::int64_t interval(std::int64_t asked) const override;
    bool has_pictures() const override { return parts_.front().manifest.colour; }

    /// \throws Error io for a file that is missing or isn't what the manifest says, usage when flow or seeds are
    ///         needed and were not extracted
    fields::FieldSummary read(const fields::FieldNeeds& needs, const fields::FieldSink& sink) override;

    /// The options that made the fields, of all parts together.
    const std::vector<std::pair<std::string, std::string>>& settings() const { return settings_; }

  private:
    struct Part {
        std::filesystem::path folder;
        Manifest manifest;
    };

    fields::Field read_field(const Part& part, const StoredFrame& frame, const fields::FieldNeeds& needs) const;

    std::vector<Part> parts_;
    std::vector<std::pair<std::string, std::string>> settings_;
    video::VideoInfo info_;
};

}  // namespace vvr::store
