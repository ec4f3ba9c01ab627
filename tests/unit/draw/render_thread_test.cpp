#include <atomic>
#include <set>

#include <gtest/gtest.h>

#include "cli/draw/draw.h"
#include "core/base/error.h"
#include "tests/support/errors.h"

namespace vvr {
namespace {

TEST(RenderThread, DoesAllWorkInOrderOnAThreadOfItsOwn) {
    std::vector<int> done;
    std::set<std::thread::id> threads;
    {
        app::RenderThread thread;
        for (int i = 0; i < 5; ++i) {
            thread.start([&, i](app::GlSession&) {
                done.push_back(i);
                threads.insert(std::this_thread::get_id());
            });
        }
    }
    EXPECT_EQ(done, (std::vector<int>{0, 1, 2, 3, 4})) << "its end waits for the work";
    EXPECT_EQ(threads.size(), 1U);
    EXPECT_FALSE(threads.contains(std::this_thread::get_id()));
}

TEST(RenderThread, PassesTheFirstErrorToAllWhoWait) {
    app::RenderThread thread;
    auto first = thread.start([](app::GlSession&) { throw Error(ErrorCode::backend, "no OpenGL"); });
    bool done = false;
    for (int i = 0; i < 2; ++i) {
        test::expect_error(ErrorCode::backend, [&] { thread.run([&](app::GlSession&) { done = true; }); },
                           {"no OpenGL"});
    }
    EXPECT_FALSE(done);
    EXPECT_THROW(first.get(), Error);
}

TEST(RenderThread, LetsOneTaskWait) {
    std::promise<void> go;
    std::atomic<int> given = 0;
    std::jthread giver;
    {
        app::RenderThread thread;
        std::promise<void> begun;
        thread.start([&](app::GlSession&) {
            begun.set_value();
            go.get_future().wait();
        });
        begun.get_future().wait();
        giver = std::jthread([&] {
            for (int i = 0; i < 3; ++i) {
                thread.start([](app::GlSession&) {});
                ++given;
            }
        });
        while (given == 0) std::this_thread::yield();
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        EXPECT_EQ(given, 1) << "the second waits for room";
        go.set_value();
        giver.join();
    }
    EXPECT_EQ(given, 3);
}

}  // namespace
}  // namespace vvr
