#include "cli/app/brick_films.h"

#include <algorithm>
#include <ctime>
#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/page/html.h"

namespace vvr::app {

namespace fs = std::filesystem;

BrickFilms::BrickFilms(const Plan& plan, const media::VideoInfo& info, Observer& observer)
    : page_(page_of(plan.output.files)), window_(plan.volume.window), info_(info), observer_(observer) {
    if (page_.empty()) return;
    std::error_code none;
    for (std::int64_t place = 0; place < places(); ++place) {
        const fs::path file = file_at(place, fs::path(info.name).extension().string());
        if (fs::equivalent(file, info.name, none))
            throw Error(
                ErrorCode::output_replaces_input,
                fmt::format("the films of the page would overwrite the input '{}'; use another name", info.name));
    }
}

void BrickFilms::add(const media::SharedFrame& frame) {
    if (page_.empty()) return;
    if (!video_) {
        const std::int64_t frames = window_.brick_frames();
        video_.emplace(info_.size, page::ExpectedLength{frames, static_cast<double>(frames) / info_.rate},
                       page::Preview::Use::instead);
        begin_ = frame->pts;
    }
    end_ = frame->pts + 1 / info_.rate;
    video_->add(frame);
}

void BrickFilms::end_brick() {
    if (!video_) return;
    const std::optional<page::EncodedVideo> film = video_->finish();
    const std::string problem = video_->problem();
    video_.reset();
    if (!problem.empty() && !std::exchange(has_failed_, true))
        observer_.warn(fmt::format("the page has no film, because FFmpeg could not encode one: {}", problem));
    if (!film) return;
    const fs::path file = file_at(next_++ % places(), "." + film->type.substr(film->type.find('/') + 1));
    {
        const auto held = observer_.guard();
        replace_file(file, film->bytes);
    }
    // A browser may have kept what the file was before.
    films_.push_back(
        {fmt::format("{}?{}", page::relative_url(page_, file), std::time(nullptr)), begin_, end_ - begin_});
    if (std::ssize(films_) > window_.bricks) films_.pop_front();
}

std::vector<page::PageContent::Segment> BrickFilms::since(double seconds) const {
    std::vector<page::PageContent::Segment> shown;
    std::ranges::copy_if(films_, std::back_inserter(shown),
                         [&](const auto& film) { return film.begin + film.length > seconds; });
    return shown;
}

fs::path BrickFilms::file_at(std::int64_t place, const std::string& extension) const {
    fs::path name = page_.stem();
    name += fmt::format(".film-{}{}", place, extension);
    return page_.parent_path() / name;
}

}  // namespace vvr::app
