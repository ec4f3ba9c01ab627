#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "core/media/frame.h"
#include "core/tracking/event.h"

namespace vvr::annotation {

/// A square picture of an object and its surroundings.
struct ObjectPicture {
    Plane<Bgr> picture;
    PixelBox object;      ///< bounding box within `picture`
    double scale = 1;     ///< pixels of `picture` per field pixel
    glm::ivec2 origin{};  ///< field pixel at the top left of `picture`

    /// A box within `picture` in field pixels.
    PixelBox in_field(const PixelBox& box) const;
};

/// A crop of a frame around an object. Most are replaced by a better one soon, so they are compressed late. Reading one
/// always goes through JPEG, so its pixels do not depend on whether it has been compressed yet.
class Crop {
  public:
    /// \param portrait its box is within the frame
    Crop(const tracking::Portrait& portrait, const media::Frame& frame);

    /// The object with as much around it as a portrait shows.
    ObjectPicture still() const;

    /// The object with more around it, as detectors of objects need it: 2.5 times its longer side, if the frame has as
    /// much, and at most `longest_side` pixels.
    ObjectPicture surroundings() const;

    const Moment& at() const { return at_; }
    double score() const { return score_; }  ///< of the portrait
    std::size_t bytes() const { return jpeg_.size() + sizeof(Bgr) * raw_.pixels().size(); }

    /// Whether it is not compressed yet.
    bool is_raw() const { return !raw_.empty(); }

    /// \throws Error io or out_of_memory, as `image::compress`
    void compress();

    static constexpr int longest_side = 560;  ///< a still of 336 pixels, as in a picture of 3840x2160

  private:
    Moment at_;
    double score_;
    Plane<Bgr> raw_;               ///< of the surroundings; empty once compressed
    std::vector<std::byte> jpeg_;  ///< likewise; empty before
    double scale_ = 1;             ///< pixels per field pixel
    glm::ivec2 origin_{};          ///< of the surroundings, field pixels
    PixelBox object_;              ///< within the surroundings, in field pixels
    PixelBox still_;               ///< likewise
};

/// A place before something came to it or went from it, and after.
struct BeforeAndAfter {
    Crop before;
    Crop after;
};

/// The score of a crop of the empty scene, which shows what was there better than any frame.
inline constexpr double score_of_scene = std::numeric_limits<double>::max();

/// Keeps the best crop of each track while the fields are read, because frames aren't kept.
class Crops {
  public:
    /// \param per_track at most this many: the best, and the best at earlier moments, a second apart
    explicit Crops(int per_track = 1) : per_track_(per_track) {}

    /// Crops a track's object from a frame and replaces the track's earlier crop.
    /// \param portrait its time must be the frame's
    /// \throws Error io or out_of_memory, as `image::compress`
    void keep(std::size_t track, const tracking::Portrait& portrait, const media::Frame& frame);

    /// Keeps what shows at a glance that an event's thing came or went.
    void keep_pair(const tracking::Event& event, BeforeAndAfter pair) {
        pairs_.insert_or_assign(event.tracks.front(), std::move(pair));
    }

    /// What `keep_pair` kept; null = nothing.
    const BeforeAndAfter* find_pair(const tracking::Event& event) const;

    /// Removes the crops of the tracks for which `is_over(track)` is true, if they were taken before a time.
    void forget_before(double seconds, const std::function<bool(std::size_t track)>& is_over);

    /// The crop of an event: at its portrait's time if kept, else the best of its tracks. Null if none is kept.
    const Crop* find(const tracking::Event& event) const;

    /// The crops of an event: the best of each track, then those of earlier moments; of both the best first.
    std::vector<std::pair<std::size_t, const Crop*>> all(const tracking::Event& event) const;

    /// Memory of all crops.
    std::size_t bytes() const { return bytes_; }

    // A day at a busy gate has thousands of tracks; a picture has room for about ten, and a page for 200. Crops have
    // about 30 kB.
    static constexpr std::size_t max_crops = 1024;
    static constexpr std::size_t max_bytes = 32'000'000;
    static constexpr std::size_t max_raw_bytes = 8'000'000;

  private:
    using Key = std::pair<std::size_t, int>;  ///< the track; 0 = its best, then ever earlier moments

    void make_room(std::size_t track);
    void remove(std::map<Key, Crop>::iterator place);
    void compress_oldest();

    int per_track_;
    std::map<Key, Crop> crops_;
    std::map<std::size_t, BeforeAndAfter> pairs_;  ///< by an event's first track
    std::size_t bytes_ = 0;
    std::size_t raw_bytes_ = 0;  ///< of those that are not compressed yet
};

/// A square still per event, for lists: smaller if there are many events, empty if an event has no crop.
std::vector<Plane<Bgr>> portraits_of(std::span<const tracking::Event> events, const Crops& crops);

/// The square part of a frame that a still of an object shows: the object with some of its surroundings.
PixelBox still_box(const PixelBox& object, Size frame);

}  // namespace vvr::annotation
