// Draws a clip with libvvr: render_a_clip CLIP PICTURE [SIZE]
#include <iostream>
#include <string>

#include <vvr/vvr.h>

int main(int argc, char** argv) {
    if (argc < 3) {
        std::cerr << "usage: render_a_clip CLIP PICTURE [SIZE]\n";
        return 1;
    }
    try {
        const std::string clip = argv[1];
        const vvr::ClipInfo info = vvr::read_clip_info(clip);
        std::cout << "vvr " << vvr::library_version() << ": " << info.codec << ", " << info.width << 'x' << info.height
                  << ", " << info.seconds << " s\n";

        const vvr::Settings settings{{"size", argc > 3 ? argv[3] : "1280x800"}};
        const vvr::Rendering done = vvr::render_image(clip, settings);
        for (const std::string& warning : done.warnings) std::cerr << "warning: " << warning << '\n';

        vvr::write_image(argv[2], done.image);
        std::cout << done.frames << " frames in " << argv[2] << '\n';
    } catch (const vvr::Failure& failure) {
        std::cerr << failure.what() << " [" << failure.code() << "]\n";
        return 2 + static_cast<int>(failure.kind());
    }
}
