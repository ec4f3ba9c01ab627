#include "core/detector/detector.h"

#include <cstddef>
#include <filesystem>
#include <random>
#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/errors.h"
#include "tests/support/planes.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/detector/tiny_model.h"

namespace vvr::detector {
namespace {

using test::TinyModel;

/// A file of a model for one test.
class DetectorTest : public testing::Test {
  protected:
    std::string write(std::string_view bytes) const {
        test::write_bytes(file_, bytes);
        return file_;
    }

    void expect_refused(std::string_view bytes, std::string_view fact = "") const {
        test::expect_error(ErrorCode::not_a_model, [&] { const Detector detector(write(bytes)); }, {file_, fact});
    }

  private:
    test::TempFolder folder_;
    std::string file_ = folder_ / "model.onnx";
};

/// A black image of 64x64 pixels. The first pixel of one cell of 8 pixels has a colour.
Plane<Bgr> image_with(int column, int row, const Bgr& colour) {
    Plane<Bgr> image({64, 64}, Bgr{0, 0, 0});
    image.at(column * 8, row * 8) = colour;
    return image;
}

TEST_F(DetectorTest, FindsWhatTheModelTells) {
    Detector detector(write(TinyModel{.class_id = 16}.onnx()));
    EXPECT_EQ(detector.format(), "YOLOX");
    EXPECT_EQ(detector.input(), (Size{64, 64}));
    const auto found = detector.detect(view_of(image_with(3, 5, {204, 0, 0})), 0.5F);
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found[0].box, (PixelBox{20, 36, 36, 52}));
    EXPECT_EQ(found[0].class_id, 16);
    EXPECT_NEAR(found[0].score, 0.8F, 1e-4F);
    EXPECT_TRUE(detector.detect(view_of(image_with(3, 5, {204, 0, 0})), 0.81F).empty());
}

TEST_F(DetectorTest, ReturnsBoxesInPixelsOfTheImage) {
    Detector detector(write(TinyModel().onnx()));
    Plane<Bgr> image({256, 128}, Bgr{0, 0, 0});
    fill(image, {96, 64, 128, 96}, {255, 0, 0});
    // The image is a quarter of its size in the input: the cell is at 24, 16, and a box has 16 pixels there.
    const auto found = detector.detect(view_of(image), 0.5F);
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found[0].box, (PixelBox{80, 48, 144, 112}));
    EXPECT_TRUE(detector.detect({}, 0.5F).empty());
}

TEST_F(DetectorTest, ReadsBlueFirstForYolox) {
    Detector detector(write(TinyModel().onnx()));
    const auto image = image_with(1, 1, {0, 0, 255});
    ImageView view = view_of(image);
    EXPECT_TRUE(detector.detect(view, 0.5F).empty());
    view.order = ChannelOrder::rgb;
    EXPECT_EQ(detector.detect(view, 0.5F).size(), 1);
}

TEST_F(DetectorTest, ReadsRedFirstFrom0To1ForYolov5) {
    Detector detector(write(TinyModel{.box = {30, 20, 10, 8}, .full = 1, .copies = 3}.onnx()));
    EXPECT_EQ(detector.format(), "YOLOv5");
    EXPECT_TRUE(detector.detect(view_of(image_with(1, 1, {255, 0, 0})), 0.5F).empty());
    const auto found = detector.detect(view_of(image_with(1, 1, {0, 0, 255})), 0.5F);
    ASSERT_EQ(found.size(), 1) << "of three boxes at one place";
    EXPECT_EQ(found[0].box, (PixelBox{25, 16, 35, 24}));
    EXPECT_NEAR(found[0].score, 1, 1e-4F);
}

TEST_F(DetectorTest, KeepsTheBestOfBoxesThatOverlap) {
    Detector detector(write(TinyModel{.box = {0.5F, 0.5F, 2, 2}}.onnx()));
    auto image = image_with(2, 2, {200, 0, 0});
    image.at(24, 16) = {250, 0, 0};
    image.at(56, 56) = {220, 0, 0};
    const auto found = detector.detect(view_of(image), 0.5F);
    ASSERT_EQ(found.size(), 2);
    EXPECT_NEAR(found[0].score, 250 / 255.0, 1e-4);
    EXPECT_NEAR(found[1].score, 220 / 255.0, 1e-4);
}

TEST_F(DetectorTest, AnswersTheSameEachTime) {
    Detector detector(write(TinyModel().onnx()));
    Plane<Bgr> image({150, 170});
    std::mt19937 random(1);
    for (Bgr& pixel : image.pixels()) pixel = {static_cast<std::uint8_t>(random()), 0, 0};
    const auto first = detector.detect(view_of(image), 0.3F);
    EXPECT_GT(first.size(), 4);
    EXPECT_EQ(detector.detect(view_of(image), 0.3F), first);
    Detector moved = std::move(detector);
    EXPECT_EQ(moved.detect(view_of(image), 0.3F), first);
}

TEST_F(DetectorTest, SaysWhichFileCannotBeRead) {
    test::expect_error(ErrorCode::file_not_found, [] { const Detector detector("/no/such/model.onnx"); },
                       {"'/no/such/model.onnx'"});
}

TEST_F(DetectorTest, SaysWhyAFileIsNoModel) {
    expect_refused("");
    expect_refused("This is a text.\n");
}

TEST_F(DetectorTest, RefusesAFileThatIsTooLong) {
    const std::string file = write("x");
    std::filesystem::resize_file(file, (std::uintmax_t{1} << 30U) + 1);  // without blocks on the disk
    test::expect_error(ErrorCode::file_too_large, [&] { const Detector detector(file); });
}

TEST_F(DetectorTest, SaysWhichShapesItKnows) {
    for (const char* shape : {"[1, 85, 84]", "YOLOX's [1, 84, 85]", "YOLOv5's [1, 252, 85]"}) {
        expect_refused(TinyModel{.transposed = true}.onnx(), shape);
    }
    expect_refused(TinyModel{.numbers = 25}.onnx(), "[1, 84, 25]");
}

TEST_F(DetectorTest, SaysWhatOpenCvCannotRun) {
    std::string model = TinyModel().onnx();
    model.replace(model.find("kernel_shape"), 12, "kernel_scape");
    expect_refused(model, "OpenCV");
    for (const auto& [name, other] : {std::pair{"Transpose", "Transpos\n"}, {"Conv", "Loop"}}) {
        model = TinyModel().onnx();
        model.replace(model.find(name), std::string_view(name).size(), other);
        expect_refused(model);
    }
}

TEST_F(DetectorTest, SurvivesDamagedModels) {
    const std::string model = TinyModel().onnx();
    std::mt19937 random(7);
    std::size_t refused = 0;
    constexpr std::size_t tries = 300;
    for (std::size_t i = 0; i < tries; ++i) {
        std::string damaged = model;
        for (auto change = random() % 4 + 1; change > 0; --change) {
            damaged.at(random() % damaged.size()) = static_cast<char>(random() % 2 == 0 ? random() : 0);
        }
        try {
            Detector detector(write(damaged));
            detector.detect(view_of(image_with(3, 5, {255, 0, 0})), 0.5F);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::not_a_model);
            ++refused;
        }
    }
    EXPECT_GT(refused, tries / 20);
    EXPECT_LT(refused, tries) << "weights may be any";
}

}  // namespace
}  // namespace vvr::detector
