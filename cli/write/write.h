#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/excerpt/keep_events.h"
#include "cli/plan/observer.h"
#include "cli/write/report.h"
#include "core/image/name_pattern.h"
#include "core/image/picture_file.h"
#include "core/image/video_encoder.h"
#include "core/page/moments.h"
#include "core/page/page.h"

namespace vvr::app {

/// A picture that is ready to be written.
struct FinishedPicture {
    int number = 0;  ///< from 0; in a series, the number of its brick
    image::Picture picture;
    RunContext context;
};

/// Called for each picture of a run, in order.
using PictureSink = std::function<void(FinishedPicture&&)>;

/// Writes the pictures of a render: to one or several files, an animation, a page, or nowhere.
class PictureOutput {
  public:
    /// Checks everything that can be checked without a picture.
    /// \throws Error usage or io
    PictureOutput(const OutputOptions& options, Observer& observer);

    void add(int number, image::Picture picture, const image::Metadata& metadata);

    /// Writes a small version of the picture, if requested.
    /// \param ground behind a transparent picture
    void add_thumbnail(const image::Picture& picture, const glm::vec3& ground);

    /// Writes a frame of the clip, if requested and available.
    void add_still(const std::optional<page::Still>& still);

    /// Writes the contact sheet of the events, if requested and available.
    void add_stills(const std::optional<page::ContactSheet>& sheet);

    bool wants_stills() const { return !stills_.empty(); }

    /// Writes the page, in place of the picture or beside it.
    void add_page(const std::string& text);

    /// Call it after the last picture.
    void close();

  private:
    Observer& observer_;
    image::NamePattern name_;
    std::filesystem::path page_;
    std::filesystem::path thumbnail_;
    std::filesystem::path still_;
    std::filesystem::path stills_;
    std::optional<image::AnimationFile> animation_;
};

/// Draws the text over a picture, unless only a page shows it, which writes its own.
void add_lettering(FinishedPicture& finished);

/// Called for each picture of a run, with the metadata of its file.
using PictureCallback = std::function<void(const image::Picture& picture, const image::Metadata& record)>;

/// Writes the outputs of a run: pictures and their companions, a report, and the comparison with a golden picture.
class Writer {
  public:
    /// \param on_picture called with each picture before it is written; may be empty
    Writer(PictureOutput& files, const PictureCallback& on_picture, Observer& observer)
        : files_(files), on_picture_(on_picture), observer_(observer) {}

    /// What a page and stills show beside the picture.
    struct Kept {
        page::PageContent page{};  ///< without picture, settings and moments
        page::Moments moments{};
    };

    void write(FinishedPicture&& picture, Kept&& kept);

    /// Call it after the last picture.
    /// \param seconds duration of the run
    /// \param kept the pieces of the events
    /// \throws Error differs after everything has been written
    void finish(const RunContext& context, double seconds, const KeptEvents& kept);

  private:
    PictureOutput& files_;
    const PictureCallback& on_picture_;
    Observer& observer_;
    image::Picture last_;        ///< for the comparison with the golden picture
    std::vector<double> tiles_;  ///< times of the contact sheet, seconds
};

}  // namespace vvr::app
