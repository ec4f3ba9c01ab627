#pragma once

namespace vvr::fields {

/// Sets the number of OpenCV's threads, and resets it at the end. OpenCV has one number for the whole process, and
/// can't change it while it works. So if there are several objects at a time, that of the first holds. An object for a
/// single thread waits until those with more are gone: with more, results may differ.
class OpenCvThreads {
  public:
    /// \param threads 0 = OpenCV's default
    explicit OpenCvThreads(int threads);
    ~OpenCvThreads();
    OpenCvThreads(const OpenCvThreads&) = delete;
    OpenCvThreads& operator=(const OpenCvThreads&) = delete;
};

}  // namespace vvr::fields
