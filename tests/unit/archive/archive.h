#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/archive/clips.h"
#include "core/archive/output_files.h"
#include "core/archive/sidecar.h"
#include "core/base/digest.h"
#include "tests/support/temp_folder.h"

namespace vvr::test {

namespace fs = std::filesystem;

/// A text in which one part is another.
inline std::string replaced(std::string text, const std::string& part, const std::string& with) {
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), with);
}

/// An archive: a folder of clips, and one of what is made of them.
class Archive : public ::testing::Test {
  protected:
    Archive() {
        fs::create_directories(in());
        fs::create_directories(out());
    }

    fs::path in() const { return folder_ / "in"; }
    fs::path out() const { return folder_ / "out"; }

    static void write(const fs::path& path, const std::string& text = "x") {
        fs::create_directories(path.parent_path());
        std::ofstream(path) << text;
    }

    /// The file of a claim to `name`, as one who was killed leaves it, with any text in it.
    fs::path leave_claim(const std::string& name, const std::string& text) const {
        fs::path file = out() / fmt::format(".vvr-{:016x}.lock", fnv1a(name));
        write(file, text);
        return file;
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
    TempFolder folder_;
};

}  // namespace vvr::test
