#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"

// What a run and its workers exchange: the plan on the worker's stdin, and the worker's message through a pipe of its
// own.
namespace vvr::workers {

/// Long option names and their values.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// The task of a worker.
struct WorkerPlan {
    std::string command;  ///< of vvr, such as "render"
    std::vector<std::string> inputs{};
    Settings settings{};
};

/// What a worker reports about its run. Untrusted: a malicious clip may have taken over the worker.
struct WorkerMessage {
    std::optional<ErrorCode> code{};  ///< of the error that ended it
    std::string text{};               ///< of that error, one line
    std::vector<std::string> warnings{};
};

/// Maximum number of warnings in a message.
inline constexpr std::size_t most_warnings = 20;

/// The longest message in bytes.
inline constexpr std::size_t longest_message = 60'000;

/// The plan as CBOR: paths may have bytes that JSON can't hold.
std::string encode(const WorkerPlan& plan);

/// \throws std::exception for anything that `encode` did not write
WorkerPlan decode_plan(std::string_view bytes);

/// The message as JSON. Texts that are too long are cut.
std::string encode(WorkerMessage message);

/// Accepts any text. Members that are missing or malformed stay empty.
WorkerMessage decode_message(std::string_view text);

/// An untrusted text as one line: control characters become spaces, and the length is limited.
std::string one_line(std::string text);

/// The environment variable that makes a process a worker.
inline constexpr std::string_view worker_variable = "VVR_WORKER";

/// The value of that variable.
/// \param parent a file descriptor that the worker inherits, for its message
/// \param confined whether a CallFilter is in force
std::string worker_value(int parent, bool confined);

/// Written to stderr when the sandbox fails: by begin_worker, or by the child process before exec.
inline constexpr std::string_view no_sandbox_text = "vvr: the system denied a worker its sandbox; try --sandbox off\n";
inline constexpr int not_begun_status = 127;

/// In a worker: gives up the system calls that only startup needs, and reports to the parent that the worker has begun.
/// The parent can then distinguish a worker that never began from one that a clip crashed.
///
/// \returns the descriptor for send_to_parent; nothing if this process is not a worker
std::optional<int> begin_worker();

/// In a worker: reads the plan from stdin.
/// \throws std::exception when it is malformed
WorkerPlan read_plan();

/// What a worker writes before its message, once for each hundredth of its frames that it has read.
inline constexpr char progress_mark = '.';
inline constexpr int most_marks = 100;

/// In a worker: tells the parent how much of its clip it has read.
class ProgressToParent {
  public:
    explicit ProgressToParent(int parent) : parent_(parent) {}

    /// \param part 0 to 1; it may exceed 1 if a header is wrong
    void operator()(double part);

  private:
    int parent_;
    int sent_ = 0;
};

/// In a worker that ends: sends its message.
void send_to_parent(int parent, WorkerMessage message);

}  // namespace vvr::workers
