#include "core/base/memory.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <latch>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <typeinfo>
#include <vector>

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <opencv2/core.hpp>

namespace vvr {

std::int64_t machine_memory() {
    return std::int64_t{sysconf(_SC_PHYS_PAGES)} * sysconf(_SC_PAGESIZE);
}

std::int64_t control_group_memory(const std::filesystem::path& membership, const std::filesystem::path& groups) {
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    constexpr std::string_view of_version_2 = "0::/";
    std::ifstream lines(membership);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(of_version_2)) continue;
        std::filesystem::path group = line.substr(of_version_2.size());
        for (;; group = group.parent_path()) {
            // A number, or "max". The root group of a machine has no such file, but that of a container has one.
            std::int64_t limit = 0;
            if (std::ifstream(groups / group / "memory.max") >> limit) least = std::min(least, limit);
            if (group.empty()) break;
        }
    }
    return least;
}

std::int64_t own_memory_limit() {
    rlim_t least = std::numeric_limits<std::int64_t>::max();
    for (const auto kind : {RLIMIT_AS, RLIMIT_DATA}) {
        rlimit limit{};
        if (::getrlimit(kind, &limit) == 0) least = std::min(least, limit.rlim_cur);
    }
    return static_cast<std::int64_t>(least);
}

bool is_memory_available(std::int64_t bytes) {
    void* const room = ::mmap(nullptr, static_cast<std::size_t>(bytes), PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (room == MAP_FAILED) return false;
    ::munmap(room, static_cast<std::size_t>(bytes));
    return true;
}

namespace {

constexpr int larger_than_a_brick = 16 << 20;  // bytes; a texture of Mesa's software rasteriser is such a block

/// Grows malloc's heap, and requests huge pages there: some kernels give them only on request, and a page fault is slow
/// in a virtual machine. The memory is used only once it is written.
void grow_heap(int bytes) {
    constexpr std::size_t huge_page = 2 << 20;
    constexpr int default_padding = 128 << 10;
    void* begin = ::sbrk(0);
    mallopt(M_TOP_PAD, bytes);
    {  // volatile, as the compiler may leave out memory that nothing uses
        const std::unique_ptr<volatile char[]> block(new (std::nothrow) volatile char[larger_than_a_brick / 2]);
        if (block) block[0] = 0;
    }
    mallopt(M_TOP_PAD, default_padding);
    auto grown = static_cast<std::size_t>(static_cast<const char*>(::sbrk(0)) - static_cast<const char*>(begin));
    if (std::align(huge_page, huge_page, begin, grown) != nullptr) ::madvise(begin, grown, MADV_HUGEPAGE);
}

}  // namespace

void tune_malloc() {
    constexpr int heap = 8 * larger_than_a_brick;
    // One heap for all threads: planes are often freed by another thread than the one that allocated them, and each
    // heap would keep its own.
    mallopt(M_ARENA_MAX, 1);
    mallopt(M_MMAP_THRESHOLD, larger_than_a_brick);
    mallopt(M_TRIM_THRESHOLD, 2 * heap);  // the heap as it is grown here, and as much again
    grow_heap(heap);
}

void trim_heap() {
    malloc_trim(0);
}

bool is_out_of_memory(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return true;
    if (const auto* const system = dynamic_cast<const std::system_error*>(&error)) {
        return system->code() == std::errc::resource_unavailable_try_again ||
               system->code() == std::errc::not_enough_memory;
    }
    if (const auto* const opencv = dynamic_cast<const cv::Exception*>(&error)) {
        return opencv->code == cv::Error::StsNoMem;
    }
    // oneTBB throws a plain runtime_error if it can't start a thread: "pthread_create has failed: ...".
    return typeid(error) == typeid(std::runtime_error) && std::string_view(error.what()).starts_with("pthread_");
}

void check_threads(unsigned count) {
    std::latch all_there(1);
    std::vector<std::jthread> threads;
    threads.reserve(count);
    try {
        for (unsigned i = 0; i < count; ++i) threads.emplace_back([&] { all_there.wait(); });
    } catch (...) {
        all_there.count_down();
        throw;
    }
    all_there.count_down();
}

}  // namespace vvr
