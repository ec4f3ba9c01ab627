#pragma once

#include <filesystem>
#include <span>

#include "core/fields/field.h"
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

}  // namespace vvr::store
