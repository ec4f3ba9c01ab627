#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/bricks/layer.h"

namespace vvr::bricks {

/// Pixels times frames in which a layer shows something that was not there, more than its two halves do: what is lost
/// when neighbours become one layer. A layer of n frames in which u pixels are ever occupied shows n·u. Nothing is lost
/// where nothing moves.
double merge_loss(const Layer& a, const Layer& b);

/// Decides which neighbours among layers of unequal length are joined, so that the layers go where something moves.
class LayerMerger {
  public:
    /// What the layers' values are, which says how two join.
    void set_values(fields::Values values) { values_ = values; }

    /// A layer was added behind the others.
    void add(const std::vector<Layer>& layers);

    /// Joins the two neighbours whose joining loses least. Of those that lose nothing it is the shortest two; and where
    /// only few layers are left for the time in which nothing moves, they stay.
    /// \param idle layers without motion that are to stay, if possible
    void merge_cheapest(std::vector<Layer>& layers, std::size_t idle);

    /// Joins the shortest two neighbours in which nothing moves.
    /// \returns false when there are none
    bool merge_idle(std::vector<Layer>& layers);

  private:
    void merge_at(std::vector<Layer>& layers, std::size_t i);

    fields::Values values_ = fields::Values::strength;

    std::vector<double> losses_;  ///< of each layer and the one after it
};

/// Whether nothing moves in a layer.
inline bool is_idle(const Layer& layer) {
    return layer.moving == 0;
}

}  // namespace vvr::bricks
