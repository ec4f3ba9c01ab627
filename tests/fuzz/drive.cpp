// Runs a harness where there is no libFuzzer, on each file of its corpus: fuzz_seeds FOLDER
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "tests/fuzz/input.h"

int main(int argc, char** argv) {
    int inputs = 0;
    for (const auto& file : std::filesystem::directory_iterator(argc > 1 ? argv[1] : ".")) {
        std::ifstream stream(file.path(), std::ios::binary);
        // A copy of its own size, so that a checker of memory sees each read beyond its end.
        const std::vector<char> bytes(std::istreambuf_iterator<char>(stream), {});
        std::printf("%s\n", file.path().c_str());
        vvr::fuzz::check({bytes.data(), bytes.size()});
        ++inputs;
    }
    return inputs == 0 ? 1 : 0;
}
