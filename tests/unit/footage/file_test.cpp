#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include <fcntl.h>
#include <sys/stat.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

extern "C" {
#include <libavformat/avformat.h>
#include <libavutil/mem.h>
}

#include "core/footage/input_files.h"
#include "core/footage/open_source.h"
#include "core/footage/recorder_names.h"
#include "core/footage/recording.h"
#include "core/media/packet_copy.h"
#include "tests/support/errors.h"
#include "tests/support/zone.h"
#include "tests/unit/media/clips.h"

namespace vvr {
namespace {

using namespace test;

struct FileEncoding {
    std::string name;
    std::string arguments;
    std::string container;
    std::string codec;
};

class Encodings : public testing::TestWithParam<FileEncoding> {};

TEST_P(Encodings, GiveEveryFrameInOrderWithItsTime) {
    const TempFolder folder;
    const auto& encoding = GetParam();
    const auto source = footage::open_source(counting_clip(folder, encoding.name, encoding.arguments));
    EXPECT_EQ(source->info().container, encoding.container);
    EXPECT_EQ(source->info().codec, encoding.codec);
    EXPECT_EQ(source->info().size, (Size{64, 48}));
    EXPECT_NEAR(source->info().rate, 25, 0.01);
    EXPECT_NEAR(source->info().duration, 4, 0.1);
    EXPECT_NEAR(static_cast<double>(source->info().frames), 100, 3);

    const auto frames = read_all(*source);
    ASSERT_EQ(frames.size(), 100u);
    EXPECT_EQ(source->damaged(), 0);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_EQ(frames[i].index, static_cast<std::int64_t>(i));
        EXPECT_NEAR(frames[i].pts, static_cast<double>(i) / 25, 0.0011);
        EXPECT_NEAR(middle_of(frames[i]), level(frames[i].index), 2);
    }
    source->rewind();
    EXPECT_EQ(fingerprint(read_all(*source)), fingerprint(frames));
}

INSTANTIATE_TEST_SUITE_P(Video, Encodings,
                         testing::Values(FileEncoding{"clip.avi", "-c:v mpeg4 -q:v 2", "avi", "mpeg4"},
                                         FileEncoding{"clip.mp4", "-c:v libx264 -qp 4 -g 12 -bf 3", "mov", "h264"},
                                         FileEncoding{"clip.mkv",
                                                      "-c:v libx264 -qp 4 -g 12 -bf 3 -x264-params open-gop=1",
                                                      "matroska", "h264"},
                                         FileEncoding{"clip.ts", "-c:v libx264 -qp 4 -g 25 -bf 2", "mpegts", "h264"},
                                         FileEncoding{"lossless.mkv", "-c:v ffv1", "matroska", "ffv1"},
                                         FileEncoding{"motion.avi", "-c:v mjpeg -q:v 2", "avi", "mjpeg"}),
                         [](const auto& test) {
                             std::string name = test.param.name;
                             std::replace(name.begin(), name.end(), '.', '_');
                             return name;
                         });

TEST(VideoFile, KeepsTheTimesOfAVariableFrameRate) {
    const TempFolder folder;
    // Every frame up to 40, then each tenth.
    const auto name =
        counting_clip(folder, "vfr.mkv", "-vf \"select='lt(n,40)+not(mod(n,10))'\" -vsync vfr -c:v libx264 -qp 4");
    const auto frames = read_all(*footage::open_source(name));
    ASSERT_EQ(frames.size(), 46u);
    EXPECT_NEAR(frames[39].pts, 39 / 25.0, 0.002);
    EXPECT_NEAR(frames[41].pts, 50 / 25.0, 0.002);
    EXPECT_NEAR(frames[45].pts, 90 / 25.0, 0.002);
    EXPECT_EQ(frames[45].index, 45);
}

TEST(VideoFile, TimesCountFromTheFirstFrame) {
    const TempFolder folder;
    const auto name = counting_clip(folder, "late.mkv", "-c:v libx264 -output_ts_offset 3600");
    const auto source = footage::open_source(name);
    EXPECT_DOUBLE_EQ(source->next()->pts, 0);
    // In Matroska, the header states the time of the end.
    EXPECT_NEAR(source->info().duration, 4, 1e-6);
    EXPECT_EQ(source->info().frames, 100);
}

struct Place {
    double seconds;
    std::int64_t first;
};

class Seeking : public testing::TestWithParam<std::tuple<std::string, Place>> {};

TEST_P(Seeking, GoesOnWithTheFramesOfTheWholeClip) {
    static const TempFolder folder;
    const auto& [encoding, place] = GetParam();
    const auto file = std::to_string(std::hash<std::string>()(encoding)) + ".mkv";
    const auto name = std::filesystem::exists(folder / file) ? folder / file : counting_clip(folder, file, encoding);
    const auto all = read_all(*footage::open_source(name));
    const auto source = footage::open_source(name);
    for (int pass = 0; pass < 2; ++pass) {
        source->seek(place.seconds);
        const auto frames = read_all(*source);
        ASSERT_FALSE(frames.empty());
        // Where nothing tells a frame's number the clip is read from its beginning.
        EXPECT_TRUE(frames.front().index == 0 || frames.front().index == place.first) << frames.front().index;
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const auto& same = all[static_cast<std::size_t>(frames.front().index) + i];
            EXPECT_EQ(frames[i].index, same.index);
            EXPECT_DOUBLE_EQ(frames[i].pts, same.pts);
            EXPECT_EQ(fingerprint({frames[i]}), fingerprint({same}));
        }
        EXPECT_EQ(frames.back().index, all.back().index);
        EXPECT_EQ(source->damaged(), 0);
    }
    source->seek(1000);
    const auto none = source->next();
    EXPECT_TRUE(!none || none->index == 0);
    source->rewind();
    EXPECT_EQ(read_all(*source).size(), all.size());
}

INSTANTIATE_TEST_SUITE_P(Video, Seeking,
                         testing::Combine(testing::Values("-c:v libx264 -qp 4 -g 12 -bf 3",
                                                          "-c:v libx264 -g 12 -bf 3 -x264-params open-gop=1",
                                                          "-c:v libx264 -g 1000 -x264-params intra-refresh=1"),
                                          testing::Values(Place{-1, 0}, Place{0, 0}, Place{1.0, 25}, Place{2.5, 63},
                                                          Place{3.96, 99})));

TEST(VideoFile, TurnsPicturesUpright) {
    const TempFolder folder;
    generator::Options options;
    options.frames = 2;
    options.size = {64, 32};
    options.u = options.v = 0;
    const auto scene = generator::make_shifted_texture(options);
    write_scene(scene, folder / "flat.y4m");
    ffmpeg("-i " + quoted(folder / "flat.y4m") + " -c:v libx264 -qp 0 " + quoted(folder / "flat.mp4"));
    const auto flat = read_all(*footage::open_source(folder / "flat.mp4"));
    for (const int degrees : {90, 180, 270}) {
        const auto name = folder / ("turned" + std::to_string(degrees) + ".mp4");
        // FFmpeg 6 has an option for it; FFmpeg 7 ignores the tag.
        const bool has_option = avformat_version() >= AV_VERSION_INT(60, 0, 0);
        ffmpeg((has_option ? "-display_rotation " + std::to_string(degrees) : "") + " -i " +
               quoted(folder / "flat.mp4") + " -c copy " +
               (has_option ? "" : "-metadata:s:v rotate=" + std::to_string(degrees)) + " " + quoted(name));
        // What ffmpeg itself makes of the turn.
        ffmpeg("-i " + quoted(name) + " -c:v ffv1 " + quoted(folder / "truth.mkv"));
        const auto source = footage::open_source(name);
        const auto turned = read_all(*source);
        const auto truth = read_all(*footage::open_source(folder / "truth.mkv"));
        EXPECT_EQ(source->info().size, degrees == 180 ? (Size{64, 32}) : (Size{32, 64}));
        EXPECT_EQ(fingerprint(turned), fingerprint(truth)) << degrees;
        EXPECT_NE(fingerprint(turned), fingerprint(flat)) << degrees;
    }
}

TEST(VideoFile, MakesPixelsSquare) {
    const TempFolder folder;
    EXPECT_EQ(footage::open_source(counting_clip(folder, "wide.mkv", "-c:v ffv1 -aspect 16:9"))->info().size,
              (Size{85, 48}));
    EXPECT_EQ(footage::open_source(counting_clip(folder, "tall.mkv", "-c:v ffv1 -aspect 1:1"))->info().size,
              (Size{64, 64}));
}

/// Two clips of four seconds, one after another, whose clocks both begin at the same time.
std::string clip_whose_clock_goes_back(const TempFolder& folder) {
    const std::string part = read_bytes(counting_clip(folder, "part.ts", "-c:v libx264 -qp 4 -g 25 -bf 2"));
    write_bytes(folder / "whole.ts", part + part);
    return folder / "whole.ts";
}

TEST(VideoFile, IsMeasuredByItsPackets) {
    const TempFolder folder;
    for (const std::string& name :
         {counting_clip(folder, "clip.mp4", "-c:v libx264 -qp 4 -g 25 -bf 3"),
          counting_clip(folder, "clip.avi", "-c:v mpeg4 -q:v 2"), clip_whose_clock_goes_back(folder)}) {
        const auto frames = read_all(*footage::open_source(name));
        EXPECT_NEAR(media::length_of(media::open_input(name), 25), frames.back().pts + 0.04, 0.045) << name;
    }
    EXPECT_NEAR(media::length_of(media::open_input(folder / "whole.ts"), 25), 8, 0.05);
}

TEST(VideoFile, BeganWhenItWasLastWrittenLessItsLength) {
    const TempFolder folder;
    const std::string clip = counting_clip(folder, "clip.avi", "-c:v mpeg4 -q:v 2");
    const auto told = footage::open_source(clip);
    const auto written = static_cast<std::int64_t>(*modified_at(clip));
    EXPECT_EQ(told->info().modified, written - 4);
    const auto untold = footage::open_source(counting_clip(folder, "clip.h264", "-c:v libx264 -qp 4"));
    EXPECT_EQ(untold->info().duration, 0);
    EXPECT_FALSE(untold->info().modified) << "a length of 0 is none";
}

TEST(VideoFile, BeganInTheHourThatFitsItsLength) {
    const TempFolder folder;
    const InZone berlin("Europe/Berlin");
    constexpr std::int64_t first = 1792886400;  // 2026-10-25 02:00 CEST; it is 02:00 again an hour later
    constexpr std::int64_t hour = 3600;
    const std::string name = folder / "gate/2026-10-25_02-00-00.mp4";
    std::filesystem::create_directory(folder / "gate");
    const auto begin_if_written = [&](std::int64_t when) {
        const timespec times[] = {{when, 0}, {when, 0}};
        EXPECT_EQ(::utimensat(AT_FDCWD, name.c_str(), times, 0), 0);
        return footage::segment_from_name(name, footage::RecorderNames()).begin;
    };
    ffmpeg("-f lavfi -i color=size=64x48:rate=1/60:duration=3600 -c:v mpeg4 " + quoted(name));
    EXPECT_EQ(begin_if_written(first + hour), first) << "the file is an hour long";
    EXPECT_EQ(begin_if_written(first + 2 * hour), first + hour);
    write_bytes(name, "of no known length");
    EXPECT_EQ(begin_if_written(first + hour), first) << "it was not written before it began";
    EXPECT_EQ(begin_if_written(first + hour + 600), first + hour);
}

TEST(VideoFile, TakesTinyAndOddSizes) {
    const TempFolder folder;
    for (const Size size : {Size{1, 1}, Size{1, 40}, Size{40, 1}, Size{33, 17}}) {
        media::SourceOptions options{.colour = true};
        const auto name = folder / "odd.y4m";
        write_counting(size, 3, name);
        const auto source = footage::open_source(name, options);
        const auto frames = read_all(*source);
        ASSERT_EQ(frames.size(), 3u);
        EXPECT_EQ(frames[0].grey.size(), size);
        EXPECT_EQ(frames[0].colour.size(), size);
        EXPECT_NEAR(middle_of(frames[2]), level(2), 1);
        EXPECT_EQ(source->sample(8).size(), 3u);
    }
}

TEST(VideoFile, TakesOneFrame) {
    const TempFolder folder;
    const auto source = footage::open_source(counting_clip(folder, "one.mp4", "-frames:v 1 -c:v libx264"));
    EXPECT_EQ(source->sample(5).size(), 1u);
    EXPECT_EQ(read_all(*source).size(), 1u);
}

TEST(VideoFile, TakesEightThousandPixels) {
    const TempFolder folder;
    ffmpeg("-f lavfi -i color=gray:s=7680x4320:r=1:d=2 -c:v libx264 -preset ultrafast " + quoted(folder / "8k.mp4"));
    const auto frames = read_all(*footage::open_source(folder / "8k.mp4"));
    ASSERT_EQ(frames.size(), 2u);
    EXPECT_EQ(frames[0].grey.size(), (Size{384, 216}));
}

TEST(VideoFile, NamesWithColonsAndPercentsAreFiles) {
    const TempFolder folder;
    const auto name = counting_clip(folder, "clip.mkv", "-c:v ffv1 -frames:v 3");
    for (const std::string odd : {"cam:1.mkv", "100%d.mkv", "a*b.mkv", "file:x.mkv"}) {
        std::filesystem::copy_file(name, folder / odd);
        EXPECT_EQ(read_all(*footage::open_source(folder / odd)).size(), 3u) << odd;
    }
}

TEST(Sample, SpreadsOverAClipOfFewKeyFrames) {
    const TempFolder folder;
    const auto source = footage::open_source(counting_clip(folder, "clip.mkv", "-c:v libx264 -qp 4 -g 1000"));
    const auto frames = source->sample(20);
    EXPECT_LE(frames.size(), 20u);
    EXPECT_GE(frames.size(), 7u);
    EXPECT_DOUBLE_EQ(frames.front().pts, 0);
    EXPECT_GT(frames.back().pts, 3.4);
    for (const auto& frame : frames) EXPECT_NEAR(middle_of(frame), level(std::lround(frame.pts * 25)), 2);
    EXPECT_EQ(read_all(*source).size(), 100u);
}

TEST(Sample, TakesKeyFramesWhereThereAreEnough) {
    const TempFolder folder;
    const auto name = counting_clip(folder, "clip.mkv", "-c:v libx264 -qp 4 -g 5 -bf 2 -sc_threshold 0");
    const auto source = footage::open_source(name);
    const auto frames = source->sample(8);
    EXPECT_LE(frames.size(), 8u);
    EXPECT_GE(frames.size(), 4u);
    for (const auto& frame : frames) {
        EXPECT_EQ(std::lround(frame.pts * 25) % 5, 0);
        EXPECT_NEAR(middle_of(frame), level(std::lround(frame.pts * 25)), 2);
    }
    EXPECT_EQ(read_all(*source).front().index, 0);
}

TEST(Sample, SpreadsOverTheFootageOnBothSidesOfAGap) {
    for (const char* group : {"1000", "5"}) {
        const TempFolder folder;
        const std::string codec = std::string("-c:v libx264 -qp 4 -sc_threshold 0 -g ") + group;
        const std::string first = counting_clip(folder, "gate_20261121080000.mkv", codec);
        const std::string second = counting_clip(folder, "gate_20261121120000.mkv", codec);
        std::vector<std::string> warnings;
        const auto source = footage::open_sources({first, second}, {}, footage::RecorderNames(), warnings);
        const auto frames = source->sample(20);
        const auto before = std::ranges::count_if(frames, [](const media::Frame& frame) { return frame.pts < 4; });
        EXPECT_GE(before, 5) << group;
        EXPECT_GE(std::ssize(frames) - before, 5) << group;
    }
}

TEST(Sample, TakesFewerKeyFramesIfTheyAreEvenlySpread) {
    const TempFolder folder;
    const auto name = counting_clip(folder, "clip.mkv", "-c:v libx264 -qp 4 -g 5 -sc_threshold 0");
    const auto frames = footage::open_source(name)->sample(39);
    EXPECT_EQ(frames.size(), 20u);
    for (const auto& frame : frames) EXPECT_EQ(std::lround(frame.pts * 25) % 5, 0);
    EXPECT_GT(footage::open_source(name)->sample(41).size(), 20u) << "20 are less than half";

    const auto uneven = counting_clip(folder, "uneven.mkv",
                                      "-c:v libx264 -qp 4 -g 1000 -sc_threshold 0 -force_key_frames 'expr:lt(n,20)'");
    EXPECT_GT(footage::open_source(uneven)->sample(39).back().pts, 3.4);
}

TEST(Sample, HasTheFramesThatThePassHas) {
    const TempFolder folder;
    for (const std::string codec : {"mpeg4 -q:v 1 -bf 0", "mpeg4 -q:v 1 -bf 2", "libx264 -qp 4 -bf 0",
                                    "libx264 -qp 4 -bf 3", "libx264 -qp 4 -bf 3 -x264-params open-gop=1:b-adapt=0"}) {
        const auto source =
            footage::open_source(counting_clip(folder, "clip.mkv", "-c:v " + codec + " -g 23 -sc_threshold 0"));
        const auto all = read_all(*source);
        ASSERT_EQ(all.size(), 100u) << codec;
        for (const int count : {12, 31, 100}) {
            const auto frames = source->sample(count);
            EXPECT_GT(std::ssize(frames), count / 3) << codec;
            for (const auto& frame : frames) {
                const auto same = std::ranges::find(all, frame.pts, &media::Frame::pts);
                ASSERT_NE(same, all.end()) << codec << " at " << frame.pts;
                EXPECT_EQ(middle_of(frame), middle_of(*same)) << codec << " at " << frame.pts;
            }
        }
        EXPECT_EQ(source->sample(100).size(), 100u) << codec;
    }
}

/// Lets libav allocate no larger block while it exists.
class LibavLimit {
  public:
    explicit LibavLimit(std::size_t bytes) { av_max_alloc(bytes); }
    ~LibavLimit() { av_max_alloc(std::numeric_limits<int>::max()); }
    LibavLimit(const LibavLimit&) = delete;
    LibavLimit& operator=(const LibavLimit&) = delete;
};

TEST(Sample, ReportsThatMemoryEndedWhileItDecodesAKeyFrame) {
    const TempFolder folder;
    const auto clip = folder / "clip.avi";
    ffmpeg("-f lavfi -i testsrc2=size=640x480:rate=10:duration=2 -c:v mjpeg " + quoted(clip));
    const auto source = footage::open_source(clip);
    const LibavLimit limit(200'000);  // bytes: more than libavformat needs, and less than a frame
    test::expect_error(ErrorCode::out_of_memory, [&] { source->sample(8); });
}

TEST(Sample, DoesNotTrustTheHeadersDuration) {
    const TempFolder folder;
    // An AVI cut in the middle still has the frame count of the whole in its header.
    const auto whole = counting_clip(folder, "clip.avi", "-c:v mjpeg -q:v 2");
    const auto source = footage::open_source(cut(folder, whole, 0.5));
    const auto frames = source->sample(10);
    EXPECT_GE(frames.size(), 4u);
    EXPECT_GT(frames.back().pts, 1.2);
}

/// Frames from here to the end.
int count(media::FrameSource& source) {
    int frames = 0;
    while (source.next()) ++frames;
    return frames;
}

// A disk that is unmounted, or a recorder that makes room, between the first look and the pass that counts.
TEST(RecordingSource, SaysThatItsFilesHaveGone) {
    const TempFolder folder;
    const std::string day = folder / "day";
    std::filesystem::create_directory(day);
    counting_clip(folder, "clip.avi", "-c:v mpeg4");
    for (const char* name : {"2026-11-21_10-00-00.avi", "2026-11-21_10-00-04.avi"}) {
        std::filesystem::copy_file(folder / "clip.avi", std::filesystem::path(day) / name);
    }
    std::vector<std::string> warnings;
    const auto source = footage::open_sources({day}, {}, footage::RecorderNames(), warnings);
    EXPECT_EQ(count(*source), 200);

    std::filesystem::rename(day, folder / "away");
    source->rewind();
    test::expect_error(ErrorCode::io, [&] { source->next(); }, {"2 files"});

    std::filesystem::rename(folder / "away", day);
    std::filesystem::remove(std::filesystem::path(day) / "2026-11-21_10-00-04.avi");
    source->rewind();
    EXPECT_EQ(count(*source), 100) << "what is left is read";
    EXPECT_EQ(source->problems().size(), 1U) << "and the rest is named";
}

TEST(VideoFile, ReadsFramesAgain) {
    const test::TempFolder folder;
    const std::string encoding = "-c:v libx264 -g 10 -bf 2 -pix_fmt yuv420p -qp 1";
    for (int part = 0; part < 2; ++part) {
        const std::string name = fmt::format("2026-11-21_08-00-{:02}.mp4", 10 * part);
        test::counting_clip(folder, name, encoding);
    }
    std::vector<std::string> warnings;
    for (const bool joined : {false, true}) {
        const std::vector<std::string> names{joined ? folder / "*.mp4" : folder / "2026-11-21_08-00-00.mp4"};
        const auto source = footage::open_sources(names, {}, footage::RecorderNames(), warnings);
        std::vector<double> all;
        while (const auto frame = source->next()) all.push_back(frame->pts);
        ASSERT_EQ(all.size(), joined ? 200U : 100U);
        std::vector<double> asked{all[0], all[31], all[77], all[77] + 0.01, all[99]};
        if (joined) asked.push_back(all[131]);
        std::vector<double> got;
        media::Scaler scale(*source);
        source->read_again(asked, [&](const std::shared_ptr<media::DecodedFrame>& frame) {
            got.push_back(frame->pts);
            const auto place = static_cast<std::int64_t>(std::ranges::find(all, frame->pts) - all.begin());
            EXPECT_NEAR(scale(*frame).grey.at(20, 20), test::level(place % 100), 2) << frame->pts;
        });
        asked.erase(asked.begin() + 3);  // no frame's time
        EXPECT_EQ(got, asked);
    }
}

}  // namespace
}  // namespace vvr
