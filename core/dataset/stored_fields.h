#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/dataset/manifest.h"
#include "core/fields/field.h"
#include "core/fields/field_source.h"

namespace vvr::dataset {

/// Reads the fields that `vvr extract` wrote, from one folder, or from several with consecutive parts of a clip.
class StoredFields final : public fields::FieldSource {
  public:
    /// Reads the manifests. Data files are read and checked on demand.
    /// \throws Error io or not_video for an invalid manifest, usage for parts that don't belong together
    explicit StoredFields(std::span<const std::string> folders);

    /// The clip as its container described it if the parts cover it, else the stored part.
    const media::VideoInfo& info() const override { return info_; }
    Size field_size() const override { return parts_.front().manifest.field_size; }

    /// The same number as for the clip itself, so that both make the same picture.
    std::int64_t expected_frames() const override;
    std::int64_t interval(std::int64_t asked) const override;
    bool has_pictures() const override { return parts_.front().manifest.colour; }

    /// \throws Error io for a file that is missing or contradicts the manifest, usage if flow, seeds or colours are
    ///     needed but were not extracted
    fields::FieldSummary read(const fields::FieldNeeds& needs, const fields::FieldSink& sink) override;

    /// The options that made the fields, merged from all parts.
    const std::vector<std::pair<std::string, std::string>>& settings() const { return settings_; }

  private:
    struct Part {
        std::filesystem::path folder;
        Manifest manifest;
    };

    fields::Field read_field(const Part& part, const StoredFrame& frame, const fields::FieldNeeds& needs) const;

    std::vector<Part> parts_;
    std::vector<std::pair<std::string, std::string>> settings_;
    media::VideoInfo info_;
};

}  // namespace vvr::dataset
