#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/video/av.h"

namespace vvr::video {

/// An open file descriptor.
class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int get() const { return fd_; }

  private:
    int fd_;
};

/// Where the bytes of a video come from. Copies share the descriptor, each reader keeps its own place in it.
struct Input {
    std::string name;                        ///< as the user gave it, for messages
    std::string url;                         ///< what libav opens, where there is no descriptor
    std::shared_ptr<const Descriptor> file;  ///< a regular file

    // Of a live stream only:
    std::shared_ptr<const Descriptor> pipe{};  ///< to be read once, as it comes
    std::string format{};                      ///< libav's name of a device's; empty = found out
    std::shared_ptr<Watchdog> watchdog{};      ///< ends reads
};

/// Whether it is read from this machine's files, not from a server.
bool is_local(const Input& input);

/// Finds out what `name` is: `-` for stdin, a file, a named pipe or a URL. What can't be read twice is spooled.
///
/// \throws Error io when it can't be read or spooled, not_video for an empty one, usage for a terminal
Input open_input(const std::string& name);

/// The same for one who reads it as it comes, so that nothing is spooled; a camera's device counts too. The name that
/// it has from then on holds no password.
///
/// \throws Error io when it can't be read, or when a named pipe gives nothing within the watchdog's patience, usage for
/// a terminal or a device where libav's devices aren't installed
Input open_live_input(const std::string& name, std::shared_ptr<Watchdog> watchdog);

/// Opens a file that has to be a regular one.
///
/// \throws Error io
Input open_file(const std::string& path);

/// Whether `name` reads as a URL: a scheme of letters and "://".
bool is_url(const std::string& name);

/// Gives libav the bytes of a regular file.
class FileReader {
  public:
    explicit FileReader(std::shared_ptr<const Descriptor> file);

    AVIOContext* context() { return context_.get(); }

  private:
    static int read(void* self, std::uint8_t* buffer, int size);
    static std::int64_t seek(void* self, std::int64_t offset, int whence);

    std::shared_ptr<const Descriptor> file_;
    std::int64_t position_ = 0;
    av::Ptr<AVIOContext> context_;
};

/// Gives libav the bytes of a pipe as they come, without a way back.
class PipeReader {
  public:
    PipeReader(std::shared_ptr<const Descriptor> pipe, std::shared_ptr<const Watchdog> watchdog);

    AVIOContext* context() { return context_.get(); }

  private:
    static int read(void* self, std::uint8_t* buffer, int size);

    std::shared_ptr<const Descriptor> pipe_;
    std::shared_ptr<const Watchdog> watchdog_;
    av::Ptr<AVIOContext> context_;
};

}  // namespace vvr::video
