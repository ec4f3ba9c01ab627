#include "core/detector/model_file.h"

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/errors.h"
#include "tests/unit/detector/tiny_model.h"

namespace vvr::detector {
namespace {

using test::ProtobufWriter;
using test::TinyModel;

void expect_refused(const std::string& bytes, std::string_view fact = "") {
    test::expect_error(ErrorCode::not_a_model, [&] { check_model(bytes); }, {fact});
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
    const std::string model = TinyModel().onnx();
    for (const std::string& bytes : {std::string(), std::string("\x08\x07"), std::string("This is a text.\n"),
                                     std::string(100, '\xff'), model.substr(0, model.size() / 2)}) {
        expect_refused(bytes);
    }
}

TEST(ModelFile, HasAsManyWeightsAsItsShapesSay) {
    constexpr std::uint64_t floats = 1;
    const std::string number = ProtobufWriter().real(4, 1).text();
    const std::string numbers = number + number;
    const std::string external = ProtobufWriter().bytes(1, "location").bytes(2, "w.bin").text();
    for (const std::string& tensor :
         {tensor_of(2, floats, "1234567"), tensor_of(3, floats, "12345678"),
          tensor_of(std::uint64_t{1} << 62U, floats, "12345678"), tensor_of(~std::uint64_t{0}, floats, "12345678"),
          tensor_of(2, floats, "12345678") + number, tensor_of(3, floats, "") + numbers}) {
        expect_refused(with_part(5, tensor), "'w'");
    }
    expect_refused(with_part(5, tensor_of(2, floats, "12345678")), "0 inputs");
    expect_refused(with_part(5, tensor_of(4, 10, "12345678")), "type 10");
    expect_refused(with_part(5, tensor_of(2, floats, "") + ProtobufWriter().bytes(13, external).text()), "one file");
}

TEST(ModelFile, HasNoLoops) {
    const std::string loop =
        ProtobufWriter().bytes(4, "Constant").bytes(5, ProtobufWriter().bytes(6, "").text()).text();
    expect_refused(TinyModel{.last_node = loop}.onnx(), "loops");
}

TEST(ModelFile, HasOneColourImageAsItsInput) {
    expect_refused(TinyModel{.side = 60}.onnx(), "60x60");
    expect_refused(TinyModel{.side = 4096}.onnx(), "4096x4096");
    expect_refused(with_part(11, ProtobufWriter().bytes(1, "tokens").text()), "[]");
}

}  // namespace
}  // namespace vvr::detector
