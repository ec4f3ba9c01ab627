// What a worker of an archive tells, which a clip may have taken over.
#include <algorithm>

#include "cli/workers/worker_message.h"
#include "tests/fuzz/input.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace vvr;
    const workers::WorkerMessage message = workers::decode_message(fuzz::text_of(data, size));
    const auto is_line = [](const std::string& text) {
        return text.size() <= 600 && std::ranges::none_of(text, [](unsigned char c) { return c < 0x20 || c == 0x7F; });
    };
    fuzz::require(is_line(message.text) && std::ranges::all_of(message.warnings, is_line), "what is told is in lines");
    const std::string written = workers::encode(message);
    fuzz::require(written.size() < workers::longest_message, "a message is shorter than a pipe holds");
    const workers::WorkerMessage again = workers::decode_message(written);
    fuzz::require(again.code == message.code && again.warnings.size() == message.warnings.size(),
                  "a message is read as it is written");
    return 0;
}
