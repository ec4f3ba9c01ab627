#include "core/page/page.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/footage/open_source.h"
#include "core/media/frame.h"
#include "core/media/frame_source.h"
#include "core/page/html.h"
#include "core/page/page_data.h"
#include "tests/support/planes.h"
#include "tests/support/temp_folder.h"

namespace vvr {
namespace {

std::span<const std::byte> bytes_of(const std::string& text) {
    return std::as_bytes(std::span(text));
}

TEST(PageText, DoesNothingInHtml) {
    EXPECT_EQ(page::html_text("<b a=\"x\" b='y'>&amp;ü</b>"),
              "&lt;b a=&quot;x&quot; b=&#39;y&#39;&gt;&amp;amp;ü&lt;/b&gt;");
}

TEST(PageText, MeansTheSameInAScript) {
    const nlohmann::json name = "</script><!--&\\\"";
    const std::string text = page::script_json(name.dump());
    EXPECT_EQ(text.find_first_of("<>&"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(text), name);
}

TEST(PageText, IsBase64AsOthersMakeIt) {
    EXPECT_EQ(page::base64(bytes_of("")), "");
    EXPECT_EQ(page::base64(bytes_of("a")), "YQ==");
    EXPECT_EQ(page::data_url("text/plain", bytes_of("any carnal pleas")),
              "data:text/plain;base64,YW55IGNhcm5hbCBwbGVhcw==");
    // Longer than what is encoded at a time: no padding in between.
    std::string large;
    large.resize(10'000'001, 'a');
    const std::string text = page::base64(bytes_of(large));
    EXPECT_EQ(text.size(), (large.size() + 2) / 3 * 4);
    EXPECT_EQ(text.find('='), text.size() - 1);
    EXPECT_EQ(text.substr(0, 8), "YWFhYWFh");
}

TEST(PageText, IsHashedForThePolicy) {
    EXPECT_EQ(page::policy_hash(""), "'sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU='");
    EXPECT_EQ(page::policy_hash("abc"), "'sha256-ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0='");
}

TEST(PageText, LeadsFromThePageToTheClip) {
    EXPECT_EQ(page::relative_url("out.html", "clip.avi"), "./clip.avi");
    EXPECT_EQ(page::relative_url("pages/out.html", "clips/a b.avi"), "./../clips/a%20b.avi");
    EXPECT_EQ(page::relative_url("/a/b/c.html", "/a/d.avi"), "./../d.avi");
    EXPECT_EQ(page::relative_url("/a/./b/../c.html", "/a/b/d.avi"), "./b/d.avi");
    EXPECT_EQ(page::relative_url("out.html", "javascript:x?#%\"<ü\xFF"), "./javascript%3Ax%3F%23%25%22%3C%C3%BC%FF");
}

TEST(PageText, IsFilledOnce) {
    EXPECT_EQ(page::fill("a {{x}} b {{y z}}{{x}}", {{"x", "{{y z}}"}, {"y z", "}}"}}), "a {{y z}} b }}{{y z}}");
    EXPECT_THROW(page::fill("{{z}}", {{"x", ""}}), std::out_of_range);
    EXPECT_THROW(page::fill("{{x", {{"x", ""}}), std::out_of_range);
}

double worst_of(const std::vector<page::ConstantRateFrames>& times, const std::vector<double>& truth) {
    double worst = 0;
    std::size_t frame = 0;
    for (const page::ConstantRateFrames& steady : times) {
        for (std::int64_t k = 0; k < steady.count; ++k, ++frame) {
            EXPECT_EQ(steady.first + k, static_cast<std::int64_t>(frame));
            worst = std::max(worst, std::abs(steady.at(steady.first + k) - truth[frame]));
        }
    }
    EXPECT_EQ(frame, truth.size());
    return worst;
}

TEST(Timeline, IsShortForASteadyClip) {
    for (const double rate : {25.0, 30000.0 / 1001, 59.94}) {
        for (const double rounding : {0.0, 1e-3}) {
            page::Timeline line;
            std::vector<double> truth;
            for (int i = 0; i < 200'000; ++i) {
                const double exact = i / rate;
                truth.push_back(rounding > 0 ? std::round(exact / rounding) * rounding : exact);
                line.add(i, truth.back());
            }
            EXPECT_EQ(line.stretches().size(), 1U) << rate << " rounded to " << rounding;
            EXPECT_LE(worst_of(line.stretches(), truth), page::Timeline::tolerance * 1.001);
        }
    }
}

TEST(Timeline, IsExactForAClipThatVaries) {
    std::mt19937 random(1);
    page::Timeline line;
    std::vector<double> truth;
    double now = 3;
    for (int i = 0; i < 5000; ++i) {
        truth.push_back(now);
        line.add(i, now);
        now += i % 700 < 400 ? 0.04 : 0.001 * static_cast<double>(random() % 200);  // sometimes not at all
    }
    EXPECT_LE(worst_of(line.stretches(), truth), page::Timeline::tolerance * 1.001);
}

TEST(Timeline, OfOneFrame) {
    page::Timeline line;
    EXPECT_TRUE(line.stretches().empty());
    line.add(7, 2.5);
    ASSERT_EQ(line.stretches().size(), 1U);
    EXPECT_EQ(line.stretches().front().at(7), 2.5);
}

media::SharedFrame frame_of(std::int64_t index, double seconds, const Plane<Bgr>& picture) {
    return std::make_shared<const media::Frame>(
        media::Frame{index, seconds, Plane<std::uint8_t>(picture.size()), picture});
}

TEST(Stills, KeepTheFramesInWhichMostGoesOn) {
    constexpr int frames = 10'000;
    page::Stills stills({8, 6});
    for (int i = 0; i < frames; ++i) {
        const Plane<Bgr> picture({16, 12}, {static_cast<std::uint8_t>(i % 256), 0, 0});
        stills.add(frame_of(i, i / 25.0, picture), i % 61 == 30 ? 9 : 0);
    }
    const std::vector<page::Still> kept = stills.take();
    EXPECT_LE(kept.size(), page::Stills::most);
    EXPECT_GE(kept.size(), page::Stills::most / 2 - 1);
    std::int64_t before = -1;
    for (const page::Still& still : kept) {
        EXPECT_GT(still.frame, before);
        EXPECT_LE(still.frame - before, 2 * 128) << "a gap in which there is no still";
        EXPECT_EQ(still.picture.size(), (Size{8, 6}));
        EXPECT_EQ(still.picture.at(3, 3)[0], still.frame % 256);
        EXPECT_EQ(still.seconds, static_cast<double>(still.frame) / 25);
        if (still.frame < frames - 128) {
            EXPECT_EQ(still.frame % 61, 30) << still.frame << " is not the frame with most in it";
        }
        before = still.frame;
    }
}

TEST(Stills, AreAllFramesOfAShortClip) {
    page::Stills stills({8, 6});
    for (int i = 0; i < 5; ++i) stills.add(frame_of(i, i, Plane<Bgr>({4, 3})), 0);
    EXPECT_EQ(stills.take().size(), 5U);
}

TEST(Preview, HoldsTheFramesAtTheirTimes) {
    const Size size{64, 48};
    page::Preview preview(size, {50, 5});
    std::vector<double> times;
    for (int i = 0; i < 50; ++i) {
        times.push_back(0.1 * i + (i % 3 == 0 ? 0.03 : 0));
        preview.add(i, 4 + times.back(), Plane<Bgr>({128, 96}, {static_cast<std::uint8_t>(5 * i), 128, 128}));
    }
    const auto film = preview.finish();
    ASSERT_TRUE(film);
    EXPECT_NEAR(film->begin, 4.03, 1e-9);
    EXPECT_EQ(film->step, 1);
    const test::TempFolder folder;
    test::write_bytes(folder / "film", {reinterpret_cast<const char*>(film->bytes.data()), film->bytes.size()});
    const auto source = footage::open_source(folder / "film", {});
    EXPECT_EQ(source->info().size, size);
    int count = 0;
    while (const auto frame = source->next()) {
        EXPECT_NEAR(frame->pts, times[static_cast<std::size_t>(count)] - 0.03, 1e-3);
        ++count;
    }
    EXPECT_EQ(count, 50);
}

TEST(Preview, TakesNotEveryFrameOfALongClip) {
    page::Preview preview({16, 16}, {4 * page::Preview::most_frames, 4.0 * page::Preview::most_frames / 25});
    for (int i = 0; i < 100; ++i) preview.add(i, i / 25.0, Plane<Bgr>({16, 16}));
    const auto film = preview.finish();
    ASSERT_TRUE(film);
    EXPECT_EQ(film->step, 4);
}

TEST(Preview, IsNoneOfAClipThatIsTooLong) {
    page::Preview preview({16, 16}, {90'000 * 2, 3600 * 2});
    for (int i = 0; i < 100; ++i) preview.add(i, i / 25.0, Plane<Bgr>({16, 16}));
    EXPECT_FALSE(preview.finish());
}

TEST(Preview, IsNoneWhereItWouldBeLarge) {
    // A header that promises 50 frames, and noise without end.
    const Size size{384, 288};
    page::Preview preview(size, {50, 2});
    for (unsigned i = 0; i < 700; ++i) preview.add(i, i / 25.0, test::noise(size, i));
    const auto film = preview.finish();
    EXPECT_TRUE(!film || film->bytes.size() <= page::Preview::most_bytes);
}

TEST(Preview, TakesFramesOfOneTime) {
    page::Preview preview({16, 16}, {20, 1});
    for (int i = 0; i < 20; ++i) preview.add(i, i < 10 ? 0 : 0.5, Plane<Bgr>({16, 16}));
    EXPECT_TRUE(preview.finish()) << preview.problem();
}

TEST(Preview, OfNothingIsNone) {
    EXPECT_FALSE(page::Preview({16, 16}, {}).finish());
}

page::PageContent small_content() {
    page::PageContent content;
    content.shown = content.field = {8, 6};
    content.picture.pixels = Plane<image::Rgba>({20, 10}, {1, 1, 1, 1});
    content.picture.pixel_data.frame = Plane<float>({20, 10}, -1);
    content.moments.times = {{5, 3, 0.2, 0.04}};
    return content;
}

TEST(Page, HasLastingNumbersWithoutScriptsToo) {
    page::PageContent content = small_content();
    content.events.emplace(2);
    content.numbers = {57, 60};
    const std::string page = page::make_page(content);
    EXPECT_NE(page.find("<li>57. "), std::string::npos);
    EXPECT_NE(page.find("<li>60. "), std::string::npos);
    EXPECT_EQ(page.find("<li>1. "), std::string::npos);
    content.numbers.clear();
    EXPECT_NE(page::make_page(content).find("<li>2. "), std::string::npos);
}

TEST(Page, HasTheTimesOfAnEventFromBeforeItsFrames) {
    page::PageContent content = small_content();
    content.events.emplace(1);
    content.events->front().first = {1, -20.5};
    content.events->front().last = {6, 0.24};
    const nlohmann::ordered_json event = page::page_data(content)["events"][0];
    EXPECT_EQ(event["begin"], -20.5);
    EXPECT_EQ(event["end"], 0.24);
}

TEST(Page, NamesNothingThatIsNotInIt) {
    page::PageContent content = small_content();
    content.name = "</title><script>";
    content.moments.stills.push_back({5, 0.2, Plane<Bgr>({8, 6})});
    const std::string page = page::make_page(content);
    EXPECT_EQ(page, page::make_page(content));
    EXPECT_EQ(page.find("http"), page.find("http-equiv"));
    EXPECT_NE(page.find("<title>&lt;/title&gt;&lt;script&gt;</title>"), std::string::npos);
    std::size_t scripts = 0;
    for (auto place = page.find("<script"); place != std::string::npos; place = page.find("<script", place + 1))
        ++scripts;
    EXPECT_EQ(scripts, 10U);
}

}  // namespace
}  // namespace vvr
