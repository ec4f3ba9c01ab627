// Has glslang check the shaders of every program, with each layout, colour and shading: it is stricter than Mesa. Fails
// too if a file in glsl/ belongs to no program.
//
//     glslang VALIDATOR FOLDER
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include <fmt/format.h>

#include "gl/program_sources.h"
#include "shaders.h"

namespace {

using namespace vvr;

std::vector<ProgramSource> all_programs() {
    std::vector<ProgramSource> programs = {line_program(), floor_program(), resolve_program()};
    for (const Channels channels : {Channels::colour, Channels::pixel_data}) {
        programs.push_back(arrow_program(channels));
        programs.push_back(traceline_program(channels));
        programs.push_back(frame_program(channels));
        for (const LayoutRow& row : layouts()) {
            const auto layout = row.make(shape_for({4, 3}));
            for (const VolumeColourRow& colour : volume_colours()) {
                for (const VolumeShadingRow& shading : volume_shadings()) {
                    programs.push_back(volume_program(*layout, colour.colour, shading.shading, channels));
                }
            }
        }
    }
    return programs;
}

std::filesystem::path write(const std::filesystem::path& path, const std::vector<ShaderPiece>& pieces) {
    std::ofstream(path) << shader_text(pieces);
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
    for (const ProgramSource& program : all_programs()) {
        const auto vertex = write(folder / fmt::format("{}.vert", number), program.vertex);
        const auto fragment = write(folder / fmt::format("{}.frag", number), program.fragment);
        std::string files;
        for (const auto* pieces : {&program.vertex, &program.fragment}) {
            for (const ShaderPiece& piece : *pieces) {
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
