#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/detector/onnx.h"
#include "tests/unit/detector/tiny_model.h"

namespace vvr::detector {
namespace {

using test::ProtobufWriter;
using test::TinyModel;

/// What is said against a model.
std::string complaint(std::string_view bytes) {
    try {
        check_model(bytes);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::not_a_model);
        return error.what();
    }
    return "none";
}

/// A model whose graph has one part more than the tiny one.
std::string with_part(std::uint64_t field, std::string_view part) {
    return ProtobufWriter().bytes(7, ProtobufWriter().bytes(field, part).text()).text();
}

std::string tensor_of(std::uint64_t side, std::uint64_t type, std::string_view raw) {
    return ProtobufWriter().number(1, side).number(2, type).bytes(8, "w").bytes(9, raw).text();
}

TEST(ModelFile, SaysTheSizeOfItsImages) {
    EXPECT_EQ(check_model(TinyModel().onnx()), (Size{64, 64}));
    EXPECT_EQ(check_model(TinyModel{.side = 96}.onnx()), (Size{96, 96}));
}

TEST(ModelFile, IsNoOtherFile) {
    EXPECT_EQ(complaint(""), "it is empty");
    EXPECT_EQ(complaint("\x08\x07"), "it is not an ONNX file");
    EXPECT_EQ(complaint("This is a text.\n"), "it is not an ONNX file, or a damaged one: a field has an unknown type");
    EXPECT_EQ(complaint(std::string(100, '\xff')), "it is not an ONNX file, or a damaged one: a number is too long");
    const std::string model = TinyModel().onnx();
    EXPECT_EQ(complaint(std::string_view(model).substr(0, model.size() / 2)),
              "it is not an ONNX file, or a damaged one: a field is cut");
}

TEST(ModelFile, HasAsManyWeightsAsItsShapesSay) {
    constexpr std::uint64_t floats = 1;
    const std::string_view damaged = "it is damaged: the shape of 'w' does not match its numbers";
    EXPECT_EQ(complaint(with_part(5, tensor_of(2, floats, "1234567"))), damaged);
    EXPECT_EQ(complaint(with_part(5, tensor_of(3, floats, "12345678"))), damaged);
    EXPECT_EQ(complaint(with_part(5, tensor_of(std::uint64_t{1} << 62U, floats, "12345678"))), damaged);
    EXPECT_EQ(complaint(with_part(5, tensor_of(~std::uint64_t{0}, floats, "12345678"))), damaged);
    EXPECT_EQ(complaint(with_part(5, tensor_of(2, floats, "12345678") + ProtobufWriter().real(4, 1).text())), damaged);
    const std::string numbers = ProtobufWriter().real(4, 1).text();
    EXPECT_EQ(complaint(with_part(5, tensor_of(2, floats, "") + numbers + numbers)), damaged) << "in two places";
    EXPECT_EQ(complaint(with_part(5, tensor_of(2, floats, "12345678"))), "it has 0 inputs, not one image");
    EXPECT_EQ(complaint(with_part(5, tensor_of(4, 10, "12345678"))),
              "its weights are of type 10, which OpenCV does not read; export it with 32-bit floats");
    EXPECT_EQ(complaint(with_part(5, tensor_of(2, floats, "") + ProtobufWriter().bytes(13, "w.bin").text())),
              "its weights are in another file; export it as one file");
}

TEST(ModelFile, HasOnlyKnownOperators) {
    const auto with_name = [](std::string_view name, std::string_view replacement) {
        std::string model = TinyModel().onnx();
        return model.replace(model.find(name), name.size(), replacement);
    };
    EXPECT_EQ(complaint(with_name("Transpose", "Transpos\n")),
              "it needs the operator 'Transpos\\n', which no supported detector uses");
    EXPECT_EQ(complaint(with_name("Conv", "Relu")), "it is damaged: the operator 'Relu' has 3 inputs");
    EXPECT_EQ(complaint(with_name("constants", "constantS")),
              "it is damaged: no earlier operator produces 'constants', an input of the operator 'Conv'");
}

TEST(ModelFile, HasNoLoops) {
    const std::string loop =
        ProtobufWriter().bytes(4, "Constant").bytes(5, ProtobufWriter().bytes(6, "").text()).text();
    EXPECT_EQ(complaint(TinyModel{.last_node = loop}.onnx()), "it has loops or conditions, which no detector needs");
}

TEST(ModelFile, HasOneColourImageAsItsInput) {
    EXPECT_EQ(complaint(TinyModel{.side = 60}.onnx()),
              "its images have 60x60 pixels; export it for a fixed size of multiples of 32, at most 2048");
    EXPECT_EQ(complaint(TinyModel{.side = 4096}.onnx()),
              "its images have 4096x4096 pixels; export it for a fixed size of multiples of 32, at most 2048");
    EXPECT_EQ(complaint(with_part(11, ProtobufWriter().bytes(1, "tokens").text())),
              "its input has the shape [], but one colour image has [1, 3, height, width]");
}

}  // namespace
}  // namespace vvr::detector
