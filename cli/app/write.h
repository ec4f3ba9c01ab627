#pragma once

#include <optional>
#include <string>

#include "cli/app/job.h"
#include "cli/app/observer.h"
#include "cli/app/report.h"
#include "core/image/film.h"
#include "core/image/name_pattern.h"
#include "core/image/picture_file.h"
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
std::string page_text(const RenderJob& job, const RenderReport& report, image::Picture picture,
                      const image::Metadata& settings, page::Moments moments,
                      const std::optional<page::LiveState>& live = {});

}  // namespace vvr::app
