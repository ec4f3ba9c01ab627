#pragma once

#include <mutex>
#include <string>

#include <spdlog/sinks/base_sink.h>

namespace vvr::cli {

/// Appends lines to a file, each in one write, so that several programs can share it. When the file at its path is
/// another than the one that is open, or there is none any more, it is opened anew.
class LogFile final : public spdlog::sinks::base_sink<std::mutex> {
  public:
    /// \throws Error io
    explicit LogFile(std::string path);
    ~LogFile() override;
    LogFile(const LogFile&) = delete;
    LogFile& operator=(const LogFile&) = delete;

  protected:
    void sink_it_(const spdlog::details::log_msg& message) override;
    void flush_() override {}

  private:
    bool is_still_there() const;

    std::string path_;
    int fd_;
};

}  // namespace vvr::cli
