#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <unistd.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/archive/clips.h"
#include "core/archive/output_files.h"
#include "core/archive/sidecar.h"
#include "core/base/digest.h"

namespace vvr::test {

namespace fs = std::filesystem;

/// An archive: a folder of clips, and one of what is made of them.
class Archive : public ::testing::Test {
  protected:
    Archive() : top_(fs::temp_directory_path() / fmt::format("vvr-archive-{}", ::getpid())) {
        fs::remove_all(top_);
        fs::create_directories(in());
        fs::create_directories(out());
    }
    ~Archive() override { fs::remove_all(top_); }
    Archive(const Archive&) = delete;
    Archive& operator=(const Archive&) = delete;

    fs::path in() const { return top_ / "in"; }
    fs::path out() const { return top_ / "out"; }

    static void write(const fs::path& path, const std::string& text = "x") {
        fs::create_directories(path.parent_path());
        std::ofstream(path) << text;
    }

    /// The file of a claim to `name`, as one who was killed leaves it, with any text in it.
    fs::path leave_claim(const std::string& name, const std::string& text) const {
        char file[64];
        std::snprintf(file, sizeof file, ".vvr-%016lx.lock", static_cast<unsigned long>(fnv1a(name)));
        write(out() / file, text);
        return out() / file;
    }

    std::vector<std::string> found(const archive::ClipNames& names = archive::ClipNames()) const {
        std::vector<std::string> paths;
        for (const archive::Clip& clip : archive::scan_archive(in(), out(), names).clips) paths.push_back(clip.path);
        return paths;
    }

    archive::Sidecar done(const std::string& clip,
                          const std::vector<archive::OutputKind>& files = {archive::OutputKind::picture}) const {
        archive::Sidecar sidecar;
        sidecar.clip = {clip, 3, 1'000'000'000};
        sidecar.settings = std::string("s");
        sidecar.version = "1.2.3";
        sidecar.files = files;
        for (const archive::OutputKind kind : files) write(archive::output_path(out(), clip, kind));
        fs::create_directories(archive::sidecar_path(out(), clip).parent_path());
        archive::write_sidecar(out(), sidecar);
        return sidecar;
    }

  private:
    fs::path top_;
};

}  // namespace vvr::test
