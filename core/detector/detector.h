#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/plane.h"
#include "core/detector/formats.h"

namespace vvr::detector {

/// An object in an image.
struct Detection {
    PixelBox box;      ///< in pixels of the image
    int class_id = 0;  ///< index in object_classes()
    float score = 0;   ///< 0..1

    friend bool operator==(const Detection&, const Detection&) = default;
};

/// Whether a model is tried before it is used.
enum class Trial {
    in_child,  ///< in a child process: OpenCV crashes on some models
    none,      ///< for a process that may crash, and that may start no other
};

/// A network that finds objects in an image: people, vehicles, animals and things. OpenCV runs it on the processor. The
/// same image has the same answer each time, for any number of threads.
///
/// Not thread-safe: each thread needs one of its own.
class Detector {
  public:
    /// Reads a model in ONNX format, at most 1 GB, of a family of formats(). Make it before other threads start, as it
    /// forks.
    /// \throws Error not_a_model if the file is no such model, or crashes, hangs or fills memory in its trial;
    ///         as read_file if it can't be read
    explicit Detector(const std::filesystem::path& model, Trial trial = Trial::in_child);
    ~Detector();
    Detector(Detector&&) noexcept;
    Detector& operator=(Detector&&) noexcept;
    Detector(const Detector&) = delete;
    Detector& operator=(const Detector&) = delete;

    /// The model's family: "YOLOX".
    std::string_view format() const;

    /// The size to which images are scaled.
    Size input() const;

    /// The objects of an image, highest score first. Of boxes that overlap, whatever their classes, only the best
    /// remains.
    /// \param threshold least score, 0..1
    std::vector<Detection> detect(const ImageView& image, float threshold);

  private:
    class Network;
    std::unique_ptr<Network> network_;
};

/// What a child process may use before it is ended.
struct TrialLimits {
    int megabytes = 4096;     ///< in addition to what the process has already
    int seconds = 60;         ///< of processor time
    int clock_seconds = 600;  ///< a busy machine gives a process a small part of its time
};

/// Runs an action in a child process, so that a crash ends only the child. The child has one thread, and its stderr
/// goes nowhere.
/// \returns why the action failed: the text of its exception, or how the child ended. Nothing if it succeeded.
/// \throws Error limit if no child can be started
std::optional<std::string> failure_in_child(const std::function<void()>& action, const TrialLimits& limits = {});

}  // namespace vvr::detector
