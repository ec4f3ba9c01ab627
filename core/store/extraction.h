#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/lock_file.h"
#include "core/fields/field.h"
#include "core/fields/field_source.h"
#include "core/fields/reference.h"
#include "core/store/manifest.h"

namespace vvr::store {

/// Checks that data files can be written to `folder`: it doesn't exist, is empty, or holds an extraction, and no other
/// run is writing to it.
/// \throws Error io if they can't
void check_data_folder(const std::filesystem::path& folder);

/// Writes the data files of Fig. 3 to a folder. Until `close`, the manifest marks them as unfinished. A complete
/// extraction in the folder stays as it is until `close`; until then, the new data are in a hidden folder in it.
/// Destruction without `close` removes the new data. While it lives, it holds the lock of the folder.
class DataFolder {
  public:
    /// Creates the folder, or deletes an unfinished extraction in it.
    /// \param flow_every store flow and seeds of frames whose index is a multiple of it; 0 = never
    /// \throws Error io if the folder can't be written, or another run is writing to it
    DataFolder(std::filesystem::path folder, std::int64_t flow_every);
    ~DataFolder();
    DataFolder(const DataFolder&) = delete;
    DataFolder& operator=(const DataFolder&) = delete;

    /// Adds the next frame and its field.
    void add(const video::Frame& frame, const fields::Field& field);

    /// Writes the remaining files, the manifest last, when the data are on the disk. Sets the manifest's `frames`,
    /// `flow_every`, `colour` and `reference`. If it throws, an older extraction stays.
    void close(Manifest manifest, const fields::Reference& reference);

  private:
    void write(const std::filesystem::path& file, std::span<const std::byte> bytes) const;
    void replace_older(const std::string& manifest) const;
    bool remove_data() const;  ///< \returns whether everything could be removed

    std::filesystem::path folder_;
    std::filesystem::path place_;  ///< of the new data until `close`: the folder, or one in it
    std::int64_t flow_every_;
    std::optional<LockFile> lock_;
    bool created_ = false;
    bool closed_ = false;
    std::vector<StoredFrame> frames_;
    Plane<Bgr> last_;
};

/// Reads the fields that `vvr extract` wrote, from one folder, or from several with consecutive parts of a clip.
class StoredFields final : public fields::FieldSource {
  public:
    /// Reads the manifests. Data files are read and checked on demand.
    /// \throws Error io or not_video for an invalid manifest, usage for parts that don't belong together
    explicit StoredFields(std::span<const std::string> folders);

    /// The clip as its container described it if the parts cover it, else the stored part.
    const video::VideoInfo& info() const override { return info_; }
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
    video::VideoInfo info_;
};

}  // namespace vvr::store
