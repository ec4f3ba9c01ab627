// What people are told: texts without secrets, and names that they may have meant.
#include "core/base/text.h"

#include <array>
#include <string>

#include <gtest/gtest.h>

#include "core/base/json_text.h"
#include "core/base/setting.h"
#include "tests/support/errors.h"

namespace vvr {
namespace {

TEST(ShownText, TellsNoSecrets) {
    EXPECT_EQ(redact_secrets("rtsp://user:pass@cam:554/live?token=1"), "rtsp://cam:554/live");
    EXPECT_EQ(redact_secrets("rtsp://user:p@ss@cam/live"), "rtsp://cam/live");
    EXPECT_EQ(redact_secrets("tcp://127.0.0.1:5000?listen=1"), "tcp://127.0.0.1:5000");
    EXPECT_EQ(redact_secrets("udp://@:5000"), "udp://:5000");
    EXPECT_EQ(redact_secrets("http://host"), "http://host");
    EXPECT_EQ(redact_secrets("http://host/a@b.ts"), "http://host/a@b.ts");
}

TEST(ShownText, OfJsonKeepsItsValue) {
    const std::string name = "T\u00fcr \u009b2J \u202e \x7f \U0001f6aa \n";
    const nlohmann::ordered_json json{{"name", name}};
    const std::string text = json_text(json, 2);
    EXPECT_EQ(text, "{\n  \"name\": \"T\u00fcr \\u009b2J \\u202e \\u007f \U0001f6aa \\n\"\n}");
    EXPECT_EQ(parse_json(text), json);
}

const std::array<std::string, 4> names{"render", "info", "doctor", "horn-schunck"};

TEST(SuggestTest, CountsEdits) {
    EXPECT_EQ(edit_distance("", "abc"), 3U);
    EXPECT_EQ(edit_distance("render", "render"), 0U);
    EXPECT_EQ(edit_distance("redner", "render"), 1U);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(SuggestTest, FindsTheNearestName) {
    EXPECT_EQ(nearest_name("redner", names), "render");
    EXPECT_EQ(nearest_name("doc", names), "doctor");
    EXPECT_EQ(nearest_name("horn", names), "horn-schunck");
    EXPECT_EQ(nearest_name("xyzzy", names), "");
    EXPECT_EQ(nearest_name("", names), "");
}

TEST(SuggestTest, Asks) {
    EXPECT_EQ(did_you_mean("inof", names), " (did you mean 'info'?)");
    EXPECT_EQ(did_you_mean("xyzzy", names), "");
}

TEST(Choose, NamesTheSettingTheValueTheNearestAndAll) {
    struct Row {
        std::string_view name;
    };
    const std::array<Row, 2> rows{{{"pyramid"}, {"jacobi"}}};
    EXPECT_EQ(&choose("solver", "jacobi", rows), &rows[1]);
    test::expect_error(ErrorCode::choice_unknown, [&] { choose("solver", "pyramids", rows, ", or a file"); },
                       {"solver: 'pyramids'", "'pyramid'?", ": pyramid, jacobi, or a file"});
}

}  // namespace
}  // namespace vvr
