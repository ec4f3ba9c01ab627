#include "cli/app/picture_output.h"

#include <span>
#include <utility>

#include "core/base/fit_into.h"
#include "core/base/standard_output.h"
#include "core/image/atomic_file.h"
#include "core/image/resized.h"

namespace vvr::app {

namespace {

constexpr int pictures_per_second = 20;  // a whole number of a GIF's hundredths of a second each
constexpr int thumbnail_side = 400;
constexpr int thumbnail_quality = 80;

}  // namespace

PictureOutput::PictureOutput(const OutputOptions& options, Observer& observer)
    : observer_(observer),
      name_(name_of(options)),
      page_(page_of(options)),
      thumbnail_(options.thumbnail),
      still_(options.still) {
    if (options.path.empty() || is_standard_output(options.path)) return;
    const auto held = observer.guard();
    if (image::is_animation(options.path) || is_page(options.path)) {
        image::check_file_path(options.path);
    } else {
        image::check_picture_path(name_.at(0));
    }
    if (image::is_animation(options.path)) animation_.emplace(options.path, pictures_per_second);
}

void PictureOutput::add(int number, image::Picture picture, const image::Metadata& metadata) {
    if (name_.path().empty()) return;
    if (animation_) {
        animation_->add(picture);
        return;
    }
    if (is_standard_output(name_.path())) {
        write_standard_output(image::encode_picture("standard-output.png", std::move(picture), metadata));
        return;
    }
    const auto held = observer_.guard();
    image::write_picture(name_.at(number), std::move(picture), metadata);
}

void PictureOutput::add_thumbnail(const image::Picture& picture) {
    if (thumbnail_.empty()) return;
    image::Picture small{image::resized(picture.pixels, fit_into(picture.pixels.size(), thumbnail_side)),
                         picture.encoding};
    const std::vector<std::byte> encoded = image::encode_picture(thumbnail_, std::move(small), {}, thumbnail_quality);
    const auto held = observer_.guard();
    image::replace_file(thumbnail_, encoded);
}

void PictureOutput::add_still(const std::optional<page::Still>& still) {
    if (still_.empty() || !still) return;
    const std::vector<std::byte> encoded = image::encode_picture(still_, still->picture, thumbnail_quality);
    const auto held = observer_.guard();
    image::replace_file(still_, encoded);
}

void PictureOutput::add_page(const std::string& text) {
    const auto held = observer_.guard();
    image::replace_file(page_, std::as_bytes(std::span(text)));
}

void PictureOutput::close() {
    if (!animation_) return;
    const auto held = observer_.guard();
    animation_->close();
}

}  // namespace vvr::app
