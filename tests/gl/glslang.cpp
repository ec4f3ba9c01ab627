// Has glslang check the shaders of every program, with each layout, colour and shading: it is stricter than Mesa. Fails
// too if a file in glsl/ belongs to no program.
//
//     glslang VALIDATOR FOLDER
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include <fmt/format.h>

#include "gl/program.h"
#include "shaders.h"

namespace {

using namespace vvr;

std::vector<gl::ProgramSource> all_programs() {
    std::vector<gl::ProgramSource> programs = {gl::line_program(), gl::floor_program(), gl::resolve_program()};
    for (const gl::Channels channels : {gl::Channels::colour, gl::Channels::pixel_data}) {
        programs.push_back(gl::arrow_program(channels));
        programs.push_back(gl::traceline_program(channels));
        programs.push_back(gl::frame_program(channels));
        for (const space::LayoutRow& row : space::layouts()) {
            const auto layout = row.make(space::shape_for({4, 3}));
            for (const gl::VolumeColourRow& colour : gl::volume_colours) {
                for (const gl::VolumeShadingRow& shading : gl::volume_shadings) {
                    programs.push_back(gl::volume_program(*layout, colour.colour, shading.shading, channels));
                }
            }
        }
    }
    return programs;
}

std::filesystem::path write(const std::filesystem::path& path, const std::vector<gl::ShaderChunk>& pieces) {
    std::ofstream(path) << gl::shader_text(pieces);
    return path;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    const std::filesystem::path folder = argv[2];
    std::filesystem::create_directories(folder);
    std::set<std::string_view> unused;
    for (const auto& [file, text] : shaders::files) unused.insert(file);
    int failed = 0;
    int number = 0;
    for (const gl::ProgramSource& program : all_programs()) {
        const auto vertex = write(folder / fmt::format("{}.vert", number), program.vertex);
        const auto fragment = write(folder / fmt::format("{}.frag", number), program.fragment);
        std::string files;
        for (const auto* pieces : {&program.vertex, &program.fragment}) {
            for (const gl::ShaderChunk& piece : *pieces) {
                unused.erase(piece.file);
                files += fmt::format(" {}", piece.file);
            }
        }
        const std::string command = fmt::format("'{}' -l '{}' '{}'", argv[1], vertex.string(), fragment.string());
        if (std::system(command.c_str()) != 0) {
            fmt::print(stderr, "glslang refuses {}:{}\n", program.name, files);
            ++failed;
        }
        ++number;
    }
    for (const std::string_view file : unused) fmt::print(stderr, "glsl/{} belongs to no program\n", file);
    fmt::print("{} programs, {} refused\n", number, failed);
    return failed == 0 && unused.empty() ? 0 : 1;
}
