#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/base/file.h"
#include "core/media/av.h"

namespace vvr::media {

/// The source of a video's bytes. Copies share the descriptor, but each reader has its own position.
struct Input {
    std::string name;                        ///< as the user gave it, for messages
    std::string url;                         ///< opened by libav if there is no descriptor
    std::shared_ptr<const Descriptor> file;  ///< a regular file

    // Live streams only:
    std::shared_ptr<const Descriptor> pipe{};  ///< read once, as data arrive
    std::string format{};                      ///< libav's name of a device's format; empty = probed
    std::shared_ptr<Watchdog> watchdog{};      ///< interrupts reads

    int track = 0;  ///< of its video tracks, from 1; 0 = libav's choice
};

/// Whether the input is a local file, not a server.
bool is_local(const Input& input);

/// As `open_input`, and chooses one of its video tracks.
/// \param track as Input::track
Input open_track(const std::string& name, int track);

/// Opens `-` (stdin), a file, a named pipe or a URL. Pipes are spooled, because they can be read only once.
///
/// \throws Error io if it can't be read or spooled, not_video if it is empty, usage for a terminal
Input open_input(const std::string& name);

/// Opens a live input, including a camera device, without spooling it. `Input::name` has no password.
///
/// \throws Error io if it can't be read, or if the watchdog expires before a named pipe has data; usage for a terminal,
///         or for a device if libavdevice isn't installed
Input open_live_input(const std::string& name, std::shared_ptr<Watchdog> watchdog);

/// Opens a regular file.
///
/// \throws Error io if it can't be read or isn't a regular file
Input open_file(const std::string& path);

/// Whether `name` begins with a URL scheme and "://".
bool is_url(const std::string& name);

/// Lets libav read a regular file, with seeking.
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

/// Lets libav read a pipe as data arrive, without seeking.
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

}  // namespace vvr::media
