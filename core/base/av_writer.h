#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <span>

struct AVIOContext;

namespace vvr {

/// Puts bytes at a place of a file, over what is there. What lies between the file's end and that place becomes 0.
using WriteAt = std::function<void(std::int64_t offset, std::span<const std::byte> bytes)>;

/// Where libav's muxers write. They are C, so what `write_at` throws is kept for `check`.
class AvWriter {
  public:
    /// \throws std::bad_alloc
    explicit AvWriter(WriteAt write_at);
    ~AvWriter();
    AvWriter(const AvWriter&) = delete;
    AvWriter& operator=(const AvWriter&) = delete;

    AVIOContext* context() const { return context_.get(); }

    /// Bytes of the file so far.
    std::int64_t size() const { return size_; }

    /// Writes what is still held back.
    /// \throws whatever `write_at` threw
    void flush();

    /// Throws what `write_at` threw, if it did.
    void check() const;

  private:
    static int write(void* self, std::uint8_t* bytes, int size);
    static std::int64_t seek(void* self, std::int64_t offset, int whence);

    struct Free {
        void operator()(AVIOContext* context) const;
    };

    WriteAt write_at_;
    std::int64_t at_ = 0;
    std::int64_t size_ = 0;
    std::exception_ptr failed_;
    std::unique_ptr<AVIOContext, Free> context_;
};

}  // namespace vvr
