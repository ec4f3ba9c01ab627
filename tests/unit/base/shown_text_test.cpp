#include <gtest/gtest.h>

#include "core/base/text.h"

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

}  // namespace
}  // namespace vvr
