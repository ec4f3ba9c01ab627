// vvr-scene NAME OUT: writes a synthetic scene as a clip.
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include <CLI/CLI.hpp>

#include "tests/scene/scene.h"
#include "tests/scene/y4m.h"

// NOLINTNEXTLINE(bugprone-exception-escape): what it can't do ends it
int main(int argc, char** argv) {
    using namespace vvr;
    CLI::App app("writes a synthetic scene as a clip", "vvr-scene");
    std::string name, out;
    generator::Options options;
    std::pair size(options.size.width, options.size.height);
    std::pair velocity(options.u, options.v);
    app.add_option("NAME", name, "a scene; a wrong name lists them")->required();
    app.add_option("OUT", out, "a file of type y4m; - = standard output")->required();
    app.add_option("--size", size, "WxH")->delimiter('x')->check(CLI::Range(1, 8192));
    app.add_option("--frames", options.frames);
    app.add_option("--rate", options.rate);
    app.add_option("--seed", options.seed);
    app.add_option("--detail", options.detail);
    app.add_option("--noise", options.noise);
    app.add_option("--drift", options.drift);
    app.add_option("--jump", options.jump);
    app.add_option("--jump-at", options.jump_at);
    app.add_option("--velocity", velocity, "U,V")->delimiter(',');
    app.add_option("--omega", options.omega);
    CLI11_PARSE(app, argc, argv);
    options.size = {size.first, size.second};
    std::tie(options.u, options.v) = velocity;
    try {
        const generator::Scene scene = generator::make_scene(name, options);
        if (out == "-") {
            std::ios::sync_with_stdio(false);
            generator::write_y4m(scene, std::cout);
            return 0;
        }
        std::ofstream file(out, std::ios::binary);
        if (!file) throw std::runtime_error("cannot write '" + out + "': check the folder and its permissions");
        generator::write_y4m(scene, file);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "vvr-scene: " << error.what() << '\n';
        return 1;
    }
}
