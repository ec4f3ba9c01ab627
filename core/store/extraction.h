#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/fields/field.h"
#include "core/fields/field_source.h"
#include "core/fields/reference.h"
#include "core/store/manifest.h"

namespace vvr::store {

/// Says whether data files could be written to `folder`: it isn't there, is empty, or holds an extraction of ours.
/// \throws Error io with the next step
void check_data_folder(const std::filesystem::path& folder);

/// Writes the data files of Fig. 3 to a directory. Until `close`, its manifest says that it isn't finished; without
/// `close` nothing of it stays.
class DataFolder {
  public:
    /// Makes the folder, or empties it of an older extraction.
    /// \param colour whether every frame's picture is kept
    /// \param flow_every flow and seeds are kept of frames whose index is a multiple of it; 0 = of none
    /// \throws Error io
    DataFolder(std::filesystem::path folder, std::int64_t flow_every, bool colour);
    ~DataFolder();
    DataFolder(const DataFolder&) = delete;
    DataFolder& operator=(const DataFolder&) = delete;

    /// The next frame, in colour, and its field.
    void add(const video::Frame& frame, const fields::Field& field);

    /// Writes the rest, and the manifest last. What only this class knows is filled in here:
    /// its frames, their interval of flow, whether their pictures are kept, and whether there is a reference.
    void close(Manifest manifest, const fields::Reference& reference);

  private:
    void write(const std::filesystem::path& file, std::span<const std::byte> bytes) const;
    bool remove_data() const;  ///< whether all of them are gone

    std::filesystem::path folder_;
    std::int64_t flow_every_;
    bool colour_;
    bool made_ = false;
    bool closed_ = false;
    std::vector<StoredFrame> frames_;
    Plane<Bgr> last_;
};

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
