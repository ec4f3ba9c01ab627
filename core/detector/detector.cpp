#include "core/detector/detector.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/core/parallel/parallel_backend.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/dnn.hpp>

#include "core/base/cv_view.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/memory.h"
#include "core/base/text.h"
#include "core/detector/model_file.h"

namespace vvr::detector {

namespace {

constexpr std::uintmax_t most_model_bytes = most_bytes::data;

// Boxes that overlap by more (intersection over union) are of one object; the value of YOLOX's own programs.
constexpr float same_object = 0.45F;

// The best boxes before suppression, whose time is the square of their number.
constexpr int most_candidates = 1000;

/// Keeps OpenCV from writing to stderr what its exceptions say too.
class QuietOpenCv {
  public:
    QuietOpenCv() : level_(cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT)) {}
    ~QuietOpenCv() { cv::utils::logging::setLogLevel(level_); }
    QuietOpenCv(const QuietOpenCv&) = delete;
    QuietOpenCv& operator=(const QuietOpenCv&) = delete;

  private:
    cv::utils::logging::LogLevel level_;
};

/// Runs OpenCV's loops on the calling thread. A forked child needs it: TBB's threads are not there, and one of them may
/// have held TBB's lock, so setNumThreads(1) may wait for ever.
class SequentialLoops final : public cv::parallel::ParallelForAPI {
  public:
    void parallel_for(int tasks, FN_parallel_for_body_cb_t body, void* data) override { body(0, tasks, data); }
    int getThreadNum() const override { return 0; }
    int getNumThreads() const override { return 1; }
    int setNumThreads(int /*threads*/) override { return 1; }
    const char* getName() const override { return "sequential"; }
};

/// What OpenCV says of a model: the first line, without names of its own files.
std::string text_of(const cv::Exception& error) {
    std::string_view text = error.err;
    text = text.substr(0, text.find(": OpenCV("));
    if (text.starts_with("> ")) text.remove_prefix(2);
    text = text.substr(0, std::min<std::size_t>(text.find('\n'), 200));
    return fmt::format("OpenCV cannot run it: {}", shown_text(text));
}

/// Of detections that overlap only the one with the highest score, highest first.
std::vector<Detection> best_of_each(std::span<const Detection> detections) {
    std::vector<cv::Rect> boxes;
    std::vector<float> scores;
    for (const Detection& detection : detections) {
        boxes.emplace_back(detection.box.left, detection.box.top, detection.box.width(), detection.box.height());
        scores.push_back(detection.score);
    }
    std::vector<int> kept;
    cv::dnn::NMSBoxes(boxes, scores, 0, same_object, kept, 1, most_candidates);
    std::vector<Detection> best;
    for (const int index : kept) best.push_back(detections[static_cast<std::size_t>(index)]);
    return best;
}

}  // namespace

/// A model as OpenCV has it.
class Detector::Network {
  public:
    Network(std::string_view bytes, Size input)
        : net_(cv::dnn::readNetFromONNX(bytes.data(), bytes.size())), input_(input) {
        net_.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
        net_.setPreferableTarget(cv::dnn::DNN_TARGET_CPU);
        const std::vector<int> shape = output_shape();
        format_ = find_format(shape, input);
        if (format_ == nullptr) {
            throw Error(ErrorCode::not_a_model, fmt::format("its output has the shape [{}], which does not fit {}",
                                                            fmt::join(shape, ", "), known_shapes(input)));
        }
    }

    static void try_once(std::string_view bytes, Size input);

    const Format& format() const { return *format_; }
    Size input() const { return input_; }

    /// The output for an image of the input's size: one row of numbers per box.
    std::span<const float> run(const Plane<Bgr>& image, ChannelOrder order) {
        const cv::Mat blob = cv::dnn::blobFromImage(cv_view(image), format_->scale, cv::Size(), cv::Scalar(),
                                                    order != format_->order, false, CV_32F);
        net_.setInput(blob);
        output_ = net_.forward();
        const auto count = static_cast<std::size_t>(rows_of(*format_, input_)) * static_cast<std::size_t>(row_length());
        if (output_.type() != CV_32FC1 || !output_.isContinuous() || output_.total() != count) {
            throw Error(ErrorCode::not_a_model, "its output differs from what its operators declare");
        }
        return {output_.ptr<float>(), count};
    }

  private:
    std::vector<int> output_shape() const {
        const std::vector<int> outputs = net_.getUnconnectedOutLayers();
        if (outputs.size() != 1) {
            throw Error(ErrorCode::not_a_model, fmt::format("it has {} outputs, not one", outputs.size()));
        }
        std::vector<cv::dnn::MatShape> before;
        std::vector<cv::dnn::MatShape> after;
        net_.getLayerShapes(cv::dnn::MatShape{1, 3, input_.height, input_.width}, outputs.front(), before, after);
        return after.empty() ? std::vector<int>() : after.front();
    }

    static std::string known_shapes(Size input) {
        std::string text;
        for (const Format& format : formats()) {
            text += fmt::format("{}{}'s [1, {}, {}]", text.empty() ? "" : ", ", format.name, rows_of(format, input),
                                row_length());
        }
        return text;
    }

    cv::dnn::Net net_;
    Size input_;
    const Format* format_ = nullptr;
    cv::Mat output_;
};

/// Runs a model once, in a process for that alone.
void Detector::Network::try_once(std::string_view bytes, Size input) {
    cv::parallel::setParallelForBackend(std::make_shared<SequentialLoops>(), false);
    try {
        Network(bytes, input).run(Plane<Bgr>(input), ChannelOrder::bgr);
    } catch (const cv::Exception& error) {
        throw Error(ErrorCode::not_a_model, text_of(error));
    }
}

Detector::Detector(const std::filesystem::path& model, Trial trial) {
    const QuietOpenCv quiet;
    const std::string bytes = read_file(model.string(), most_model_bytes);
    std::optional<std::string> failure;
    try {
        const Size input = check_model(bytes);
        if (trial == Trial::in_child) failure = failure_in_child([&] { Network::try_once(bytes, input); });
        if (!failure) network_ = std::make_unique<Network>(bytes, input);
    } catch (const cv::Exception& error) {
        if (is_out_of_memory(error)) throw;  // no fault of the model
        failure = text_of(error);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::not_a_model) throw;
        failure = error.what();
    }
    if (failure) {
        throw Error(ErrorCode::not_a_model,
                    fmt::format("cannot use '{}' as a detector: {}; give a {} model in ONNX format", model.string(),
                                *failure, formats().front().name));
    }
}

Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;

std::string_view Detector::format() const {
    return network_->format().name;
}

Size Detector::input() const {
    return network_->input();
}

std::vector<Detection> Detector::detect(const ImageView& image, float threshold) {
    if (image.size.width <= 0 || image.size.height <= 0) return {};
    const Size input = network_->input();
    std::vector<Candidate> candidates;
    try {
        const QuietOpenCv quiet;
        const auto output = network_->run(letterboxed(image, input), image.order);
        candidates = decode(network_->format(), output, input, threshold);
    } catch (const cv::Exception& error) {
        if (is_out_of_memory(error)) throw;
        throw Error(ErrorCode::not_a_model, fmt::format("the detector fails: {}; give another model", text_of(error)));
    }
    const Letterbox letterbox(image.size, input);
    std::vector<Detection> detections;
    for (const Candidate& candidate : candidates) {
        const PixelBox box = letterbox.to_image(candidate.box, image.size);
        if (!box.empty()) detections.push_back({box, candidate.class_id, candidate.score});
    }
    return best_of_each(detections);
}

}  // namespace vvr::detector
