#include "core/image/jpeg_encoder.h"

#include <array>
#include <csetjmp>
#include <cstddef>
#include <cstdio>  // jpeglib.h takes it for granted
#include <cstdlib>

#include <jpeglib.h>

#include <fmt/format.h>
// after it
#include <jerror.h>

#include "core/error.h"

namespace vvr {
namespace {

// A comment's length is in two bytes, which it counts too.
constexpr std::size_t longest_comment = 65533;

/// libjpeg's writer, which says what is wrong and gives up by a call that must not return.
class Writer {
  public:
    Writer() {
        state_.err = jpeg_std_error(&errors_);
        state_.client_data = this;
        errors_.error_exit = &Writer::give_up;
        errors_.output_message = [](j_common_ptr) {};
    }
    ~Writer() {
        jpeg_destroy_compress(&state_);
        std::free(bytes_);
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    std::vector<unsigned char> write(const JpegImage& image) {
        if (!try_to_write(image)) {
            throw Error(errors_.msg_code == JERR_OUT_OF_MEMORY ? ErrorKind::limit : ErrorKind::io,
                        fmt::format("cannot encode a JPEG file of {}x{}: {}", image.size.width, image.size.height,
                                    message_.data()));
        }
        return {bytes_, bytes_ + count_};
    }

  private:
    /// Nothing in here has a destructor, for the jump would pass it by.
    bool try_to_write(const JpegImage& image) {
        if (setjmp(failed_) != 0) return false;
        jpeg_create_compress(&state_);
        jpeg_mem_dest(&state_, &bytes_, &count_);
        state_.image_width = static_cast<JDIMENSION>(image.size.width);
        state_.image_height = static_cast<JDIMENSION>(image.size.height);
        state_.input_components = 3;
        state_.in_color_space = JCS_RGB;
        jpeg_set_defaults(&state_);
        jpeg_set_quality(&state_, image.quality, TRUE);
        jpeg_start_compress(&state_, TRUE);
        if (!image.comment.empty()) {
            const std::size_t length = image.comment.size() < longest_comment ? image.comment.size() : longest_comment;
            jpeg_write_marker(&state_, JPEG_COM, reinterpret_cast<const JOCTET*>(image.comment.data()),
                              static_cast<unsigned>(length));
        }
        const std::size_t stride = 3 * static_cast<std::size_t>(image.size.width);
        while (state_.next_scanline < state_.image_height) {
            // libjpeg takes no const rows, and writes none of them.
            auto* row = const_cast<JSAMPROW>(image.values.data() + state_.next_scanline * stride);
            jpeg_write_scanlines(&state_, &row, 1);
        }
        jpeg_finish_compress(&state_);
        return true;
    }

    [[noreturn]] static void give_up(j_common_ptr state) {
        auto* const writer = static_cast<Writer*>(state->client_data);
        state->err->format_message(state, writer->message_.data());
        std::longjmp(writer->failed_, 1);
    }

    jpeg_compress_struct state_{};
    jpeg_error_mgr errors_{};
    std::jmp_buf failed_{};
    std::array<char, JMSG_LENGTH_MAX> message_{};
    unsigned char* bytes_ = nullptr;
    unsigned long count_ = 0;
};

}  // namespace

std::vector<unsigned char> encode_jpeg(const JpegImage& image) {
    return Writer().write(image);
}

}  // namespace vvr
