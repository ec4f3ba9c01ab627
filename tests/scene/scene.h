#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/plane.h"

// Synthetic surveillance scenes of which everything is known: what moves, where, how fast. The same options give the
// same pixels on every machine.
namespace vvr::generator {

struct Options {
    Size size{384, 288};
    int frames = 0;  ///< 0 = as many as the scene has by itself; another number runs its story faster or slower
    double rate = 25;
    std::uint64_t seed = 1;
    double detail = 0;  ///< fine texture of the hall, which does not move: standard deviation in grey levels
    double noise = 0;   ///< of the camera: standard deviation in grey levels
    double drift = 0;   ///< of the light: grey levels from the first frame to the last
    double jump = 0;    ///< of the light: grey levels, at frame `jump_at` and from there on
    int jump_at = 0;
    double u = 1.5;       ///< motion of `shifted_texture`, pixels per frame to the right
    double v = 0.75;      ///< and down
    double omega = 0.05;  ///< `spinning_sphere`: radians a frame, clockwise on the screen
};

/// \param frames as many as the scene has by itself
inline Options with_frames(Options options, double frames) {
    if (options.frames <= 0) options.frames = static_cast<int>(frames);
    return options;
}

/// Something in the scene at one frame.
struct Object {
    std::string name;
    double x = 0;  ///< its middle, in pixels; the centre of the first pixel is 0
    double y = 0;
    double vx = 0;  ///< motion to the next frame, pixels
    double vy = 0;
    Plane<std::uint8_t> mask;  ///< 255 where it is to be seen, else 0
};

struct Truth {
    std::vector<Object> objects;
    Plane<float> u;  ///< flow, pixels per frame to the right; empty in scenes with no exact one
    Plane<float> v;  ///< and down

    /// \returns nothing if the object is not there
    const Object* find(std::string_view name) const {
        const auto found = std::ranges::find(objects, name, &Object::name);
        return found == objects.end() ? nullptr : &*found;
    }
};

/// What a scene shows before the camera adds its noise, and the light its changes.
class Story {
  public:
    Story() = default;
    virtual ~Story() = default;
    Story(const Story&) = delete;
    Story& operator=(const Story&) = delete;

    virtual Plane<Bgr> paint(int frame) const = 0;
    virtual Truth truth(int frame) const = 0;
};

class Scene {
  public:
    Scene(const Options& options, std::shared_ptr<const Story> story) : options_(options), story_(std::move(story)) {}

    Size size() const { return options_.size; }
    int frames() const { return options_.frames; }
    double rate() const { return options_.rate; }

    /// Any frame, in any order.
    Plane<Bgr> frame(int i) const;
    Truth truth(int i) const { return story_->truth(i); }

  private:
    Options options_;
    std::shared_ptr<const Story> story_;
};

/// A scene of two functions: what it shows in a frame, and what is there.
Scene told(const Options& options, std::function<Plane<Bgr>(int)> paint, std::function<Truth(int)> truth);

/// As in the paper's LeftBag: a person walks in with a bag, puts it down, leaves; comes back much later for it.
/// Objects "person" and "bag". 1600 frames.
Scene make_left_bag(const Options& options = {});

/// As in the paper's LeftBox: a person walks in with a box, puts it down, walks around it, and leaves; the box stays.
/// Objects "person" and "bag". 800 frames.
Scene make_left_box(const Options& options = {});

/// When and where `make_left_bag` puts the bag down and takes it up again.
struct LeftBag {
    int put_down = 0;  ///< the first frame on which the bag stands by itself
    int taken_up = 0;  ///< the first frame on which it is carried again
    double x = 0;      ///< the bag's middle while it stands, pixels
    double y = 0;
};
LeftBag left_bag_facts(const Options& options = {});

/// Six people of different sizes and speeds, some crossing. 600 frames.
Scene make_walkers(const Options& options = {});

/// Two people who walk towards each other and pass, the one in front hiding the other for a while. 600 frames.
Scene make_two_walkers_cross(const Options& options = {});

/// As in the paper's FallOnFloor: a person walks in, falls, lies still, gets up and leaves. Object "person". 600
/// frames.
Scene make_fall_on_floor(const Options& options = {});

/// When and where the person of `make_fall_on_floor` lies.
struct FallOnFloor {
    int falls = 0;    ///< the first frame on which the person is not upright
    int lies = 0;     ///< the first frame on the floor, without motion from here on
    int gets_up = 0;  ///< the first frame that moves again
    double x = 0;     ///< the middle of the body on the floor, pixels
    double y = 0;
};
FallOnFloor fall_on_floor_facts(const Options& options = {});

/// A textured disc that turns about the view axis (the paper's Fig. 7). Exact flow. 100 frames.
Scene make_spinning_sphere(const Options& options = {});

/// A texture that moves by (u, v) pixels per frame everywhere. Exact flow. 50 frames.
Scene make_shifted_texture(const Options& options = {});

/// Nothing happens. 100 frames.
Scene make_still(const Options& options = {});

/// A disc on an even ground, at another place each second. Object "disc". 250 frames.
Scene make_one_object_a_second(const Options& options = {});

/// A scene by the part of its function's name after "make_".
///
/// \throws std::invalid_argument, with the names that there are
Scene make_scene(std::string_view name, const Options& options = {});

}  // namespace vvr::generator
