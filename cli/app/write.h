#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cli/app/drawn.h"
#include "cli/app/job.h"
#include "cli/app/observer.h"
#include "core/image/film.h"
#include "core/image/name_pattern.h"
#include "core/image/picture_file.h"
#include "core/page/moments.h"
#include "core/page/page.h"
#include "core/page/stills.h"

namespace vvr::app {

/// Writes the pictures of a render: to one file, to a file each, to one that is animated, to a page, or nowhere.
class PictureOutput {
  public:
    /// What can fail without a picture fails here.
    /// \throws Error usage or io
    PictureOutput(const OutputOptions& options, Observer& observer);

    void add(int number, image::Picture picture, const image::Metadata& metadata);

    /// The picture once more, small, where that is asked for.
    void add_thumbnail(const image::Picture& picture);

    /// A frame of the clip, where that is asked for and there is one.
    void add_still(const std::optional<page::Still>& still);

    /// Instead of the picture, or beside it.
    void add_page(const std::string& text);

    /// After the last picture.
    void close();

  private:
    Observer& observer_;
    image::NamePattern name_;
    std::filesystem::path page_;
    std::filesystem::path thumbnail_;
    std::filesystem::path still_;
    std::optional<image::AnimationFile> animation_;
};

/// The text of a page of one picture.
/// \param settings of the picture
/// \param live of a stream
std::string page_text(const Drawn& drawn, image::Picture picture, const image::Metadata& settings,
                      page::Moments moments, const std::optional<page::LiveState>& live = {});

/// Takes each picture of a run, with what its file records.
using PictureTaker = std::function<void(const image::Picture& picture, const image::Metadata& record)>;

/// Writes what a run gives: its pictures, what goes with them, a report, and the comparison with a golden picture.
class Writer {
  public:
    /// \param watched sees the fields on their way; null where there is neither a page nor a still
    /// \param taken gets each picture before its file does; may be empty
    Writer(PictureOutput& files, page::WatchedFields* watched, const PictureTaker& taken, Observer& observer)
        : files_(files), watched_(watched), taken_(taken), observer_(observer) {}

    void write(FinishedPicture&& picture);

    /// After the last picture.
    /// \param seconds that all of it took
    /// \throws Error differs after all has been written
    void finish(const Drawn& drawn, double seconds);

  private:
    PictureOutput& files_;
    page::WatchedFields* watched_;
    const PictureTaker& taken_;
    Observer& observer_;
    image::Picture last_;  ///< to be compared with a golden one
};

}  // namespace vvr::app
