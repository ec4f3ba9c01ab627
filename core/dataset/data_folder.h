#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/lock_file.h"
#include "core/base/plane.h"
#include "core/dataset/manifest.h"
#include "core/fields/field.h"
#include "core/fields/reference.h"

namespace vvr::dataset {

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
    void add(const media::Frame& frame, const fields::Field& field);

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

}  // namespace vvr::dataset
