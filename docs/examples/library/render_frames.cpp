// Draws frames that are in memory, shows the progress, and lists the events: render_frames PICTURE [SECONDS]
// With SECONDS, it cancels the render after this time.
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <vector>

#include <vvr/vvr.h>

namespace {

constexpr int width = 320;
constexpr int height = 240;
constexpr int frames = 150;

// A grey room, through which a white box moves to the right.
void paint(std::int64_t index, std::vector<std::uint8_t>& pixels) {
    pixels.assign(std::size_t{3} * width * height, 90);
    const int left = static_cast<int>(index) * (width - 40) / frames;
    for (int y = 100; y < 160; ++y) {
        for (int x = left; x < left + 40; ++x) {
            for (int channel = 0; channel < 3; ++channel) pixels[3 * (y * width + x) + channel] = 240;
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::cerr << "usage: render_frames PICTURE [SECONDS]\n";
        return 1;
    }
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    const double limit = argc > 2 ? std::atof(argv[2]) : 1e9;

    std::vector<std::uint8_t> pixels;
    vvr::FrameSequence sequence;
    sequence.width = width;
    sequence.height = height;
    sequence.format = vvr::PixelFormat::bgr;
    sequence.frames_per_second = 25;
    sequence.frames = frames;
    sequence.read = [&](std::int64_t index, vvr::FrameView& frame) {
        if (index >= frames) return false;
        paint(index, pixels);
        frame = {pixels.data(), 3 * width, static_cast<double>(index) / 25};
        return true;
    };
    vvr::RenderOptions options;
    options.events = true;
    options.pixel_data = true;
    options.progress = [&](const vvr::Progress& progress) {
        const char* const what = progress.stage == vvr::Progress::Stage::reading ? "frames" : "parts of the picture";
        if (progress.done == progress.total) std::cout << progress.done << ' ' << what << '\n';
        return std::chrono::duration<double>(Clock::now() - begin).count() < limit;
    };
    try {
        const vvr::Rendering done = vvr::render_image(sequence, {{"size", "640x400"}, {"title", "a box"}}, options);
        for (const vvr::Event& event : done.events) {
            std::cout << event.number << ": " << event.kind << ' ' << event.direction << ", " << event.first_seconds
                      << " s to " << event.last_seconds << " s\n";
        }
        std::size_t shown = 0;
        for (const float frame : done.pixel_data.frame) shown += frame >= 0 ? 1 : 0;
        std::cout << shown << " of " << done.pixel_data.frame.size() << " pixels show a frame\n";
        vvr::write_image(argv[1], done.image);
    } catch (const vvr::Failure& failure) {
        std::cerr << failure.what() << " [" << failure.code() << "]\n";
        return 2 + static_cast<int>(failure.kind());
    }
}
