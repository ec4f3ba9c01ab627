#include "core/page/preview.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/image/picture.h"

namespace vvr::page {

namespace {

constexpr int ticks = 1000;  // per second, as in WebM

std::int64_t step_for(const ExpectedLength& expected) {
    return std::max<std::int64_t>(1, (expected.frames + Preview::most_frames - 1) / Preview::most_frames);
}

constexpr std::array long_sides{384, 256};  // pixels, per Use
constexpr int key_seconds = 5;              // key frame interval: a seek decodes up to this much

std::size_t place_of(Preview::Use use) {
    return static_cast<std::size_t>(use);
}

/// The first row with an installed encoder; null if there is none.
const image::VideoRow* installed_row() {
    const auto row = std::ranges::find_if(image::video_rows(), [](const auto& each) {
        return *each.preview != '\0' && image::has_encoder(each.encoder);
    });
    return row == image::video_rows().end() ? nullptr : &*row;
}

}  // namespace

std::string_view preview_encoder() {
    const image::VideoRow* const row = installed_row();
    return row == nullptr ? std::string_view() : row->encoder;
}

Preview::Preview(Size clip, const ExpectedLength& expected, Use use)
    : use_(use), size_(fit_into(clip, long_sides[place_of(use)])), expected_(expected) {
    video_.step = step_for(expected);
    const double kept = static_cast<double>(expected.frames) / static_cast<double>(video_.step);
    given_up_ = video_.step > 1 && kept < least_rate * expected.seconds;
}

void Preview::begin() {
    const image::VideoRow* const row = installed_row();
    if (row == nullptr) {
        given_up_ = true;
        return;
    }
    // The bit rate uses most of the size limit; `add` checks whether the encoder exceeds the limit.
    constexpr double highest = 1'500'000;
    const double seconds = std::max(1.0, expected_.seconds);
    const auto bits = static_cast<std::int64_t>(std::min(highest, 0.85 * 8 * most_bytes / seconds));
    const double rate = static_cast<double>(expected_.frames) / static_cast<double>(video_.step) / seconds;
    const int pictures = static_cast<int>(std::clamp(std::round(rate), 1.0, 60.0));
    const bool constrained_by_rate = std::string_view(row->muxer) == "webm";
    const std::string limit =
        constrained_by_rate ? fmt::format("b={}", bits) : fmt::format("maxrate={},bufsize={}", bits, 2 * bits);
    video_.type = fmt::format("video/{}", row->muxer);
    encoder_ = std::make_unique<image::VideoEncoder>(
        *row, fmt::format("crf={},{},{}", row->preview_crf[place_of(use_)], row->preview, limit), "preview", size_,
        ticks, pictures, key_seconds * pictures);
}

void Preview::add(std::int64_t frame, double seconds, const Plane<Bgr>& picture) {
    if (given_up_) return;
    try {
        encode(frame, seconds, picture);
    } catch (const Error& error) {
        give_up(error.what());
    }
}

void Preview::give_up(const std::string& problem) {
    given_up_ = true;
    problem_ = problem;
    encoder_.reset();
}

void Preview::encode(std::int64_t frame, double seconds, const Plane<Bgr>& picture) {
    if (taken_ == 0) {
        begin();
        if (given_up_) return;
        first_frame_ = frame;
        video_.begin = seconds;
    }
    if ((frame - first_frame_) % video_.step != 0) return;
    std::int64_t tick = std::llround((seconds - video_.begin) * ticks);
    if (taken_ > 0) tick = std::max(tick, last_tick_ + 1);  // timestamps must increase
    last_tick_ = tick;
    encoder_->add(image::resized(picture, size_), tick);
    ++taken_;
    if (encoder_->bytes() <= most_bytes && taken_ <= 2 * most_frames) return;
    given_up_ = true;
    encoder_.reset();
}

std::optional<EncodedVideo> Preview::finish() {
    if (given_up_ || taken_ == 0) return std::nullopt;
    try {
        video_.bytes = encoder_->finish();
    } catch (const Error& error) {
        give_up(error.what());
        return std::nullopt;
    }
    if (video_.bytes.size() > most_bytes) return std::nullopt;
    return std::move(video_);
}

PreviewThread::PreviewThread(Size clip, const ExpectedLength& expected, Preview::Use use)
    : preview_(clip, expected, use) {
    frames_.set_capacity(1);
    thread_ = std::jthread([this] { encode(); });
}

PreviewThread::~PreviewThread() {
    end();
}

std::optional<EncodedVideo> PreviewThread::finish() {
    end();
    if (error_) std::rethrow_exception(error_);
    return preview_.finish();
}

void PreviewThread::encode() {
    media::SharedFrame frame;
    for (frames_.pop(frame); frame; frames_.pop(frame)) {
        if (error_) continue;  // takes the rest, so that nobody waits
        try {
            preview_.add(frame->index, frame->pts, frame->colour.empty() ? media::picture_of(*frame) : frame->colour);
        } catch (...) {
            error_ = std::current_exception();
        }
    }
}

void PreviewThread::end() {
    if (!thread_.joinable()) return;
    frames_.push(nullptr);
    thread_.join();
}

}  // namespace vvr::page
