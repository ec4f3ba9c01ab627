// vvr-scene NAME OUT: writes a synthetic scene as a clip.
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "tests/scene/scene.h"
#include "tests/scene/y4m.h"

namespace {

using namespace vvr;

constexpr const char* usage =
    "usage: vvr-scene NAME OUT.y4m|-|OUT_%05d.png [--size WxH] [--frames N] [--rate R] [--seed N]\n"
    "                 [--detail SIGMA] [--noise SIGMA] [--drift LEVELS] [--jump LEVELS --jump-at FRAME]\n"
    "                 [--velocity U,V] [--omega RADIANS]\n"
    "NAME: left_bag, left_box, fall_on_floor, walkers, two_walkers_cross, spinning_sphere, shifted_texture, still,\n"
    "      one_object_a_second, walks_by, walks_by_shaken, stands, comes_closer, group_splits, train, taken_box, "
    "rain,\n"
    "      crowd, clock\n";

void write_picture(const std::string& name, const Plane<Bgr>& picture) {
    std::vector<std::uint8_t> rgb;
    for (const Bgr& colour : picture.pixels()) rgb.insert(rgb.end(), {colour[2], colour[1], colour[0]});
    const auto out = OIIO::ImageOutput::create(name);
    const OIIO::ImageSpec spec(picture.width(), picture.height(), 3, OIIO::TypeDesc::UINT8);
    if (!out || !out->open(name, spec) || !out->write_image(OIIO::TypeDesc::UINT8, rgb.data()) || !out->close())
        throw std::runtime_error("cannot write '" + name + "': " + (out ? out->geterror() : OIIO::geterror()));
}

/// "dir/frame_%05d.png" and 7 to "dir/frame_00007.png".
std::string numbered(const std::string& pattern, int number) {
    const auto percent = pattern.find('%');
    const auto end = pattern.find('d', percent);
    const std::string width = pattern.substr(percent + 1, end - percent - 1);
    if (end == std::string::npos || width.find_first_not_of("0123456789") != std::string::npos)
        throw std::invalid_argument("'" + pattern + "': the number is written %d or %05d");
    std::string digits = std::to_string(number);
    const std::size_t wanted = width.empty() ? 0 : std::stoul(width);
    if (digits.size() < wanted) digits.insert(0, wanted - digits.size(), '0');
    return pattern.substr(0, percent) + digits + pattern.substr(end + 1);
}

void write(const generator::Scene& scene, const std::string& out) {
    if (out == "-") {
        std::ios::sync_with_stdio(false);
        generator::write_y4m(scene, std::cout);
    } else if (out.find('%') != std::string::npos) {
        for (int i = 0; i < scene.frames(); ++i) write_picture(numbered(out, i), scene.frame(i));
    } else {
        std::ofstream file(out, std::ios::binary);
        if (!file) throw std::runtime_error("cannot write '" + out + "': check the folder and its permissions");
        generator::write_y4m(scene, file);
    }
}

generator::Options parse(const std::vector<std::string>& words) {
    generator::Options options;
    if (words.size() % 2 != 0) throw std::invalid_argument("'" + words.back() + "' has no value");
    for (std::size_t i = 0; i < words.size(); i += 2) {
        const std::string& key = words[i];
        const std::string& value = words[i + 1];
        const auto pair = [&](char between) {
            const auto at = value.find(between);
            if (at == std::string::npos) throw std::invalid_argument("'" + value + "' for " + key + " is not a pair");
            return std::pair(std::stod(value.substr(0, at)), std::stod(value.substr(at + 1)));
        };
        if (key == "--size") {
            const auto [width, height] = pair('x');
            if (!(width >= 1 && height >= 1 && width <= 8192 && height <= 8192))
                throw std::invalid_argument("'" + value + "': a size is from 1x1 to 8192x8192");
            options.size = {static_cast<int>(width), static_cast<int>(height)};
        } else if (key == "--frames") {
            options.frames = std::stoi(value);
        } else if (key == "--rate") {
            options.rate = std::stod(value);
        } else if (key == "--seed") {
            options.seed = std::stoull(value);
        } else if (key == "--detail") {
            options.detail = std::stod(value);
        } else if (key == "--noise") {
            options.noise = std::stod(value);
        } else if (key == "--drift") {
            options.drift = std::stod(value);
        } else if (key == "--jump") {
            options.jump = std::stod(value);
        } else if (key == "--jump-at") {
            options.jump_at = std::stoi(value);
        } else if (key == "--velocity") {
            std::tie(options.u, options.v) = pair(',');
        } else if (key == "--omega") {
            options.omega = std::stod(value);
        } else {
            throw std::invalid_argument("no option '" + key + "'");
        }
    }
    return options;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    try {
        if (words.size() < 2) throw std::invalid_argument("a scene and a file to write are needed");
        write(generator::make_scene(words[0], parse({words.begin() + 2, words.end()})), words[1]);
        return EXIT_SUCCESS;
    } catch (const std::logic_error& error) {
        std::cerr << "vvr-scene: " << error.what() << '\n' << usage;
        return 1;
    } catch (const std::exception& error) {
        std::cerr << "vvr-scene: " << error.what() << '\n';
        return 2;
    }
}
