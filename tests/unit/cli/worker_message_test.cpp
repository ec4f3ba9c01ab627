#include "cli/workers/worker_message.h"

#include <string>

#include <gtest/gtest.h>

namespace vvr {
namespace {

TEST(WorkerPlan, KeepsEveryByte) {
    const workers::WorkerPlan plan{"render", {"-", "in/\xFF\n.avi"}, {{"title", "a=\"b\""}, {"output", "--help"}}};
    const workers::WorkerPlan read = workers::decode_plan(workers::encode(plan));
    EXPECT_EQ(read.command, plan.command);
    EXPECT_EQ(read.inputs, plan.inputs);
    EXPECT_EQ(read.settings, plan.settings);
}

TEST(WorkerMessage, IsReadAsItWasWritten) {
    const auto read = workers::decode_message(workers::encode({ErrorCode::not_video, "no video", {"one", "two"}}));
    EXPECT_EQ(read.code, ErrorCode::not_video);
    EXPECT_EQ(read.text, "no video");
    EXPECT_EQ(read.warnings, (std::vector<std::string>{"one", "two"}));
    EXPECT_FALSE(workers::decode_message(workers::encode(workers::WorkerMessage())).code);
}

TEST(WorkerMessage, IsNoLongerThanAPipeHolds) {
    const std::vector<std::string> warnings(1000, std::string(100'000, '\xFF'));
    EXPECT_LT(workers::encode({ErrorCode::bug, std::string(1'000'000, '"'), warnings}).size(),
              workers::longest_message);
}

TEST(WorkerMessage, IsEmptyWhereItIsNone) {
    for (const std::string& text :
         {std::string(), std::string("x"), std::string("[]"), std::string("7"), std::string(60'000, '['),
          std::string(R"({"code": 7, "text": ["x"], "warnings": "x"})"), std::string(R"({"code": "x"})")}) {
        const workers::WorkerMessage read = workers::decode_message(text);
        EXPECT_FALSE(read.code) << text;
        EXPECT_TRUE(read.text.empty() && read.warnings.empty()) << text;
    }
    const auto forged = workers::decode_message(R"({"text": "one\nvvr: two\u001b[2J", "warnings": [{}, "\r"]})");
    EXPECT_EQ(forged.text, "one vvr: two [2J");
    EXPECT_EQ(forged.warnings, std::vector<std::string>{""});
}

TEST(WorkerMessage, HasNoMoreWarningsThanItMay) {
    std::string forged = R"({"warnings": ["0")";
    for (int i = 1; i < 1000; ++i) forged += R"(, "x")";
    EXPECT_EQ(workers::decode_message(forged + "]}").warnings.size(), workers::most_warnings);
}

}  // namespace
}  // namespace vvr
