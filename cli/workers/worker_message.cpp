#include "cli/workers/worker_message.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "cli/workers/sandbox.h"
#include "core/base/json_text.h"

namespace vvr::workers {

namespace {

constexpr std::size_t longest_line = 600;
static_assert((most_warnings + 2) * longest_line * 4 < longest_message, "four: each byte may need U+FFFD in its place");

std::string text_in(const Json& json, const char* name) {
    const auto member = json.find(name);
    return member != json.end() && member->is_string() ? one_line(member->get<std::string>()) : "";
}

}  // namespace

std::string encode(const WorkerPlan& plan) {
    std::string bytes;
    Json::to_cbor(Json{plan.command, plan.inputs, plan.settings}, bytes);
    return bytes;
}

WorkerPlan decode_plan(std::string_view bytes) {
    const Json json = Json::from_cbor(bytes);
    return {json.at(0).get<std::string>(), json.at(1).get<std::vector<std::string>>(), json.at(2).get<Settings>()};
}

std::string encode(WorkerMessage message) {
    Json json{{"text", one_line(std::move(message.text))}, {"warnings", Json::array()}};
    if (message.code) json["code"] = row_of(*message.code).name;
    message.warnings.resize(std::min(message.warnings.size(), most_warnings));
    for (std::string& warning : message.warnings) json["warnings"].push_back(one_line(std::move(warning)));
    return json_text(json);
}

WorkerMessage decode_message(std::string_view text) {
    const Json json = parse_json(text);
    if (!json.is_object()) return {};
    WorkerMessage message{find_error_code(text_in(json, "code")), text_in(json, "text")};
    const auto warnings = json.find("warnings");
    if (warnings == json.end() || !warnings->is_array()) return message;
    for (const Json& warning : *warnings) {
        if (message.warnings.size() == most_warnings) break;
        if (warning.is_string()) message.warnings.push_back(one_line(warning.get<std::string>()));
    }
    return message;
}

std::string one_line(std::string text) {
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
    text.erase(text.find_last_not_of(' ') + 1);
    return text.substr(0, longest_line);
}

namespace {

constexpr std::string_view open_mark = ":open";
constexpr std::string_view shut_mark = ":shut";

}  // namespace

std::string worker_value(int parent, bool confined) {
    return fmt::format("{}{}", parent, confined ? shut_mark : open_mark);
}

std::optional<int> begin_worker() {
    const char* const variable = std::getenv(worker_variable.data());
    if (variable == nullptr) return std::nullopt;
    const std::string value = variable;
    ::unsetenv(worker_variable.data());
    int parent = -1;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), parent);
    const std::string_view mark(end, static_cast<std::size_t>(value.data() + value.size() - end));
    if (error != std::errc() || parent <= STDERR_FILENO || (mark != open_mark && mark != shut_mark))
        return std::nullopt;
    if (mark == shut_mark && !block_startup_calls()) {
        [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, no_sandbox_text.data(), no_sandbox_text.size());
        ::_exit(not_begun_status);
    }
    ::fcntl(parent, F_SETFD, FD_CLOEXEC);
    [[maybe_unused]] const ssize_t written = ::write(parent, "", 1);
    return parent;
}

WorkerPlan read_plan() {
    std::string bytes;
    std::array<char, 65536> room{};
    for (;;) {
        const ssize_t count = ::read(STDIN_FILENO, room.data(), room.size());
        if (count <= 0) return decode_plan(bytes);
        bytes.append(room.data(), static_cast<std::size_t>(count));
    }
}

void ProgressToParent::operator()(double part) {
    const int marks = static_cast<int>(std::clamp(part, 0.0, 1.0) * most_marks);
    if (marks <= sent_) return;
    const std::string text(static_cast<std::size_t>(marks - sent_), progress_mark);
    sent_ = marks;
    [[maybe_unused]] const ssize_t written = ::write(parent_, text.data(), text.size());
}

void send_to_parent(int parent, WorkerMessage message) {
    const std::string text = encode(std::move(message));
    [[maybe_unused]] const ssize_t written = ::write(parent, text.data(), text.size());
}

}  // namespace vvr::workers
