// What a worker of an archive tells, which a clip may have taken over.
#include <algorithm>

#include "cli/workers/worker_message.h"
#include "tests/fuzz/input.h"

void vvr::fuzz::check(std::string_view input) {
    const workers::WorkerMessage message = workers::decode_message(input);
    const auto is_line = [](const std::string& text) {
        return text.size() <= 600 && std::ranges::none_of(text, [](unsigned char c) { return c < 0x20 || c == 0x7F; });
    };
    require(is_line(message.text) && std::ranges::all_of(message.warnings, is_line), "what is told is in lines");
    const std::string written = workers::encode(message);
    require(written.size() < workers::longest_message, "a message is shorter than a pipe holds");
    const workers::WorkerMessage again = workers::decode_message(written);
    require(again.code == message.code && again.warnings.size() == message.warnings.size(),
            "a message is read as it is written");
}
