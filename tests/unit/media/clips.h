#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/media/frame_source.h"
#include "core/media/scaler.h"
#include "tests/scene/scene.h"
#include "tests/scene/y4m.h"
#include "tests/support/temp_folder.h"

// Clips for the tests of core/media, made when they are needed with the ffmpeg program.
namespace vvr::test {

inline std::string quoted(const std::string& word) {
    return "'" + word + "'";
}

inline void ffmpeg(const std::string& arguments) {
    const std::string command = "timeout 60 ffmpeg -nostdin -v error -y " + arguments;
    if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
}

/// The grey level of frame `i` of a counting clip.
inline int level(std::int64_t i) {
    return static_cast<int>(20 + 2 * i);
}

inline void write_scene(const generator::Scene& scene, const std::string& name) {
    std::ofstream file(name, std::ios::binary);
    generator::write_y4m(scene, file);
}

inline void write_painted(Size size, int frames, std::function<Plane<Bgr>(int)> paint, const std::string& name) {
    write_scene(generator::told({.size = size, .frames = frames}, std::move(paint), {}), name);
}

/// Writes frames of one grey level each, so that a decoded frame tells which one it is.
inline void write_counting(Size size, int frames, const std::string& name) {
    const auto paint = [size](int frame) {
        const auto grey = static_cast<std::uint8_t>(level(frame));
        return Plane<Bgr>(size, {grey, grey, grey});
    };
    write_painted(size, frames, paint, name);
}

/// Writes a counting clip of 100 frames, 25 a second, encoded as `encoding` says.
inline std::string counting_clip(const TempFolder& folder, const std::string& name, const std::string& encoding,
                                 Size size = {64, 48}) {
    const std::string raw = folder / (name + ".y4m");
    write_counting(size, 100, raw);
    ffmpeg("-i " + quoted(raw) + " " + encoding + " " + quoted(folder / name));
    return folder / name;
}

/// A clip with detail and motion, which gives damage something to spoil.
inline std::string walkers_clip(const TempFolder& folder, const std::string& name, const std::string& encoding) {
    const std::string raw = folder / "walkers.y4m";
    if (!std::filesystem::exists(raw)) {
        generator::Options options{.size = {192, 144}, .frames = 75, .noise = 3};
        write_scene(generator::make_walkers(options), raw);
    }
    ffmpeg("-i " + quoted(raw) + " " + encoding + " " + quoted(folder / name));
    return folder / name;
}

/// The first part of a file, as if its disk had been full.
inline std::string cut(const TempFolder& folder, const std::string& name, double part) {
    const auto bytes = read_bytes(name);
    std::string out = folder / ("cut" + std::filesystem::path(name).extension().string());
    write_bytes(out, bytes.substr(0, static_cast<std::size_t>(static_cast<double>(bytes.size()) * part)));
    return out;
}

/// A file with random bytes in the middle third.
inline std::string spoiled(const TempFolder& folder, const std::string& name) {
    auto bytes = read_bytes(name);
    std::mt19937 random(7);
    for (std::size_t i = bytes.size() / 3; i < bytes.size() * 2 / 3; i += 499)
        bytes[i] = static_cast<char>(random() & 0xff);
    std::string out = folder / ("spoiled" + std::filesystem::path(name).extension().string());
    write_bytes(out, bytes);
    return out;
}

/// All frames that are left in a source, scaled.
inline std::vector<media::Frame> read_all(media::FrameSource& source) {
    media::Scaler scale(source);
    std::vector<media::Frame> frames;
    while (const auto decoded = source.next()) frames.push_back(scale(*decoded));
    return frames;
}

inline int middle_of(const media::Frame& frame) {
    return frame.grey.at(frame.grey.width() / 2, frame.grey.height() / 2);
}

/// One number for the grey values of all frames.
inline std::size_t fingerprint(const std::vector<media::Frame>& frames) {
    std::size_t sum = 14695981039346656037u;
    for (const auto& frame : frames)
        for (const auto value : frame.grey.pixels()) sum = (sum ^ value) * 1099511628211u;
    return sum;
}

}  // namespace vvr::test
