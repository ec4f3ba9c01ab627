#include "core/fields/opencv_threads.h"

#include <condition_variable>
#include <mutex>

#include <opencv2/core/utility.hpp>

namespace vvr::fields {

namespace {

/// Who uses OpenCV in this process.
struct Users {
    std::mutex mutex;
    std::condition_variable all_gone;
    int count = 0;
    bool single = false;  ///< they have one thread
    int before = 0;       ///< the number to which the last one resets
};

Users& users() {
    static Users all;
    return all;
}

}  // namespace

OpenCvThreads::OpenCvThreads(int threads) {
    Users& all = users();
    std::unique_lock lock(all.mutex);
    if (threads == 1) all.all_gone.wait(lock, [&] { return all.count == 0 || all.single; });
    if (all.count++ > 0) return;
    all.before = cv::getNumThreads();
    all.single = threads == 1;
    if (threads > 0) cv::setNumThreads(threads);
}

OpenCvThreads::~OpenCvThreads() {
    Users& all = users();
    const std::scoped_lock lock(all.mutex);
    if (--all.count > 0) return;
    cv::setNumThreads(all.before);
    all.all_gone.notify_all();
}

}  // namespace vvr::fields
