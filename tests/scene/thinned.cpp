#include "tests/scene/thinned.h"

#include <memory>
#include <utility>

namespace vvr::generator {
namespace {

class Thinned final : public Story {
  public:
    Thinned(Scene whole, int every, int first) : whole_(std::move(whole)), every_(every), first_(first) {}

    Plane<Bgr> paint(int frame) const override { return whole_.frame(first_ + frame * every_); }

    Truth truth(int frame) const override {
        Truth truth = whole_.truth(first_ + frame * every_);
        for (Object& object : truth.objects) {
            object.vx *= every_;
            object.vy *= every_;
        }
        return truth;
    }

  private:
    Scene whole_;
    int every_;
    int first_;
};

}  // namespace

Scene make_thinned(const Scene& whole, int every, int first) {
    Options options;
    options.size = whole.size();
    options.frames = (whole.frames() - first + every - 1) / every;
    options.rate = whole.rate() / every;
    return {options, std::make_shared<Thinned>(whole, every, first)};
}

}  // namespace vvr::generator
