#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"

// What passes between a run and its workers, as data: the plan on the worker's stdin, and what came of it through a
// pipe of its own.
namespace vvr::workers {

/// Long names of options, and their values.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// What a worker is to do.
struct WorkerPlan {
    std::string command;  ///< of vvr
    std::vector<std::string> inputs{};
    Settings settings{};
};

/// What a worker says of its run. A clip may have taken it over, so that it says what it likes.
struct WorkerMessage {
    std::optional<ErrorCode> code{};  ///< of the error that ended it
    std::string text{};               ///< of that error, in a line
    std::vector<std::string> warnings{};
};

/// Bytes of a message at most, which is less than a pipe holds: nobody has to read while it is written.
inline constexpr std::size_t longest_message = 60'000;

/// A plan as bytes. Paths and texts in it may have any, which JSON has not: it is CBOR.
std::string encode(const WorkerPlan& plan);

/// \throws std::exception for what `encode` does not make
WorkerPlan decode_plan(std::string_view bytes);

/// As JSON. What is too long is left out.
std::string encode(WorkerMessage message);

/// Whatever the text is: what is not in it, or is not as it should be, is left empty.
WorkerMessage decode_message(std::string_view text);

/// A text for people in one line of a length that can be shown, whoever wrote it.
std::string one_line(std::string text);

/// The environment variable by which a worker is told that it is one.
inline constexpr std::string_view worker_variable = "VVR_WORKER";

/// What that variable says.
/// \param parent a descriptor that the worker inherits, to tell what comes of it
/// \param confined whether a CallFilter is around it
std::string worker_value(int parent, bool confined);

/// What begin_worker says on stderr where it can't, and so does a child that can't become a worker.
inline constexpr std::string_view no_sandbox_text =
    "vvr: the system lets no worker into its sandbox; try --sandbox off\n";
inline constexpr int not_begun_status = 127;

/// In a worker: gives up what it needed to begin, and tells its parent that it has begun. So whatever comes later, a
/// worker that never began is known from one that a clip has ended.
/// \returns the descriptor for tell_parent; nothing in a process that is no worker
std::optional<int> begin_worker();

/// In a worker: what it is to do.
/// \throws std::exception
WorkerPlan read_plan();

/// In a worker that ends: what came of it.
void tell_parent(int parent, WorkerMessage message);

}  // namespace vvr::workers
