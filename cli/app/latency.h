#pragma once

#include <cstddef>
#include <deque>

namespace vvr::app {

/// How long pictures took from the last frame that they show to the disk: of the last thousand, so that days of them
/// need no memory.
class Latency {
  public:
    void add(double seconds);

    /// 0 where there was none.
    double median() const;
    double longest() const;

  private:
    static constexpr std::size_t kept = 1000;

    std::deque<double> last_;
};

}  // namespace vvr::app
