#include "tests/scene/scene_source.h"

#include <algorithm>
#include <utility>

#include "core/media/scaler.h"

extern "C" {
#include <libavutil/frame.h>
}

#include "core/media/scaler.h"

namespace vvr::generator {
namespace {

media::AvFrame to_av(const Plane<Bgr>& picture) {
    media::AvFrame frame(av_frame_alloc());
    if (!frame) throw std::bad_alloc();
    frame->width = picture.width();
    frame->height = picture.height();
    frame->format = AV_PIX_FMT_BGR24;
    if (av_frame_get_buffer(frame.get(), 0) < 0) throw std::bad_alloc();
    for (int j = 0; j < picture.height(); ++j) {
        const auto row = std::as_bytes(picture.row(j));
        std::copy(row.begin(), row.end(), reinterpret_cast<std::byte*>(frame->data[0] + j * frame->linesize[0]));
    }
    return frame;
}

class SceneSource final : public media::FrameSource {
  public:
    SceneSource(Scene scene, const media::SourceOptions& options)
        : scene_(std::move(scene)),
          info_{"scene",        "scene", "none", scene_.size(), scene_.rate(), scene_.frames() / scene_.rate(),
                scene_.frames()},
          field_size_(media::field_size_for(scene_.size(), options.field_size)),
          colour_(options.colour) {}

    const media::VideoInfo& info() const override { return info_; }
    Size field_size() const override { return field_size_; }
    bool colour() const override { return colour_; }
    std::int64_t damaged() const override { return 0; }
    void rewind() override { next_ = 0; }

    std::unique_ptr<media::DecodedFrame> next() override {
        if (next_ >= scene_.frames()) return nullptr;
        const int i = next_++;
        return std::make_unique<media::DecodedFrame>(
            media::DecodedFrame{i, i / scene_.rate(), {}, to_av(scene_.frame(i))});
    }

  private:
    Scene scene_;
    media::VideoInfo info_;
    Size field_size_;
    bool colour_;
    int next_ = 0;
};

}  // namespace

std::unique_ptr<media::FrameSource> open_scene(Scene scene, const media::SourceOptions& options) {
    return std::make_unique<SceneSource>(std::move(scene), options);
}

}  // namespace vvr::generator
