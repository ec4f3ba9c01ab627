// Runs a harness where there is no libFuzzer: on each file of its corpus, then on as many inputs that are made of them
// by chance. The same seed makes the same inputs.
//
//   fuzz_seeds [--runs N] [--seed S] FOLDER
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/input.h"

namespace {

namespace fs = std::filesystem;

using Random = std::mt19937_64;
using Corpus = std::vector<std::string>;

constexpr std::size_t longest = 1 << 16;

constexpr std::array<std::string_view, 24> pieces{"0",
                                                  "-1",
                                                  "1e300",
                                                  "nan",
                                                  "inf",
                                                  "99999999999999999999",
                                                  "\"",
                                                  "{",
                                                  "}",
                                                  "[",
                                                  "]",
                                                  ",",
                                                  ":",
                                                  ";",
                                                  "/",
                                                  "../",
                                                  "%",
                                                  "#",
                                                  "\n",
                                                  "\\u0000",
                                                  "null",
                                                  "\xff",
                                                  "\xe2\x80\xae",
                                                  "="};

std::size_t below(Random& random, std::size_t limit) {
    return limit == 0 ? 0 : random() % limit;
}

void change(Random& random, const Corpus& corpus, std::string& input) {
    const std::size_t at = below(random, input.size() + 1);
    const std::size_t length = below(random, std::size_t{1} << below(random, 8));
    switch (random() % 6) {
        case 0:
            if (at < input.size()) input[at] = static_cast<char>(input[at] ^ (1 << random() % 8));
            break;
        case 1:
            if (at < input.size()) input[at] = static_cast<char>(random());
            break;
        case 2:
            input.erase(at, length);
            break;
        case 3:
            input.insert(at, pieces[below(random, pieces.size())]);
            break;
        case 4: {
            const std::string& other = corpus[below(random, corpus.size())];
            input.insert(at, other.substr(below(random, other.size() + 1), length));
            break;
        }
        default: {
            const std::string part = input.substr(at, length);
            for (std::size_t times = below(random, 40); times > 0 && input.size() < longest; --times)
                input.insert(at, part);
        }
    }
    if (input.size() > longest) input.resize(longest);
}

/// \returns seconds of a processor that it took
double run(std::string_view input) {
    // A copy of its own size, so that a checker of memory sees each read beyond its end.
    const std::vector<std::uint8_t> bytes(input.begin(), input.end());
    const std::clock_t begin = std::clock();
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    const double took = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    constexpr double too_long = 2;
    vvr::fuzz::require(took < too_long, "no input takes long");
    return took;
}

Corpus read_corpus(const fs::path& folder) {
    std::vector<fs::path> files{fs::directory_iterator(folder), {}};
    std::ranges::sort(files);
    Corpus corpus;
    for (const fs::path& file : files) {
        std::ifstream stream(file, std::ios::binary);
        corpus.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    }
    return corpus;
}

struct Plan {
    std::uint64_t runs = 0;
    std::uint64_t seed = 1;
    fs::path folder;
};

Plan plan_of(std::span<char*> arguments) {
    Plan plan;
    for (std::size_t k = 1; k < arguments.size(); ++k) {
        const std::string_view word = arguments[k];
        if (word == "--runs" && k + 1 < arguments.size()) {
            plan.runs = std::strtoull(arguments[++k], nullptr, 10);
        } else if (word == "--seed" && k + 1 < arguments.size()) {
            plan.seed = std::strtoull(arguments[++k], nullptr, 10);
        } else {
            plan.folder = word;
        }
    }
    return plan;
}

}  // namespace

int main(int argc, char** argv) {
    const Plan plan = plan_of(std::span(argv, static_cast<std::size_t>(argc)));
    const Corpus corpus = read_corpus(plan.folder);
    if (corpus.empty()) {
        std::fprintf(stderr, "'%s' has no inputs\n", plan.folder.c_str());
        return 1;
    }
    const auto begin = std::chrono::steady_clock::now();
    // Stays beside the program when it ends before its time: the input that did it. It is open all the time, as each
    // closing of a file that has become shorter waits for the disk.
    const std::string last = std::string(argv[0]) + ".last-input";
    std::ofstream kept(last, std::ios::binary);
    const auto run_and_keep = [&](const std::string& input) {
        kept.seekp(0);
        kept << input << std::flush;
        fs::resize_file(last, input.size());
        return run(input);
    };
    for (const std::string& input : corpus) run_and_keep(input);
    double slowest = 0;
    for (std::uint64_t k = 0; k < plan.runs; ++k) {
        Random random(plan.seed * 0x9e3779b97f4a7c15U + k);
        std::string input = corpus[below(random, corpus.size())];
        for (std::size_t changes = 1 + below(random, 6); changes > 0; --changes) change(random, corpus, input);
        slowest = std::max(slowest, run_and_keep(input));
    }
    fs::remove(last);
    std::printf("%zu inputs of the corpus, %llu changed by chance, seed %llu, %.1f s, the slowest %.0f ms\n",
                corpus.size(), static_cast<unsigned long long>(plan.runs), static_cast<unsigned long long>(plan.seed),
                std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), slowest * 1000);
    return 0;
}
