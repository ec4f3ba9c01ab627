#include "cli/options/files_stay.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <sys/stat.h>

#include <fmt/format.h>

#include "cli/app/golden.h"
#include "core/base/error.h"
#include "core/image/name_pattern.h"
#include "core/video/input_files.h"

namespace vvr::options {

namespace {

namespace fs = std::filesystem;

/// What makes a file the same one, whatever its names: links are followed.
using FileId = std::pair<dev_t, ino_t>;

std::optional<FileId> id_of(const fs::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return FileId{status.st_dev, status.st_ino};
}

/// The files that are there already and that a run would write, each with the option and the name that was given.
class Outputs {
  public:
    void add(const OptionValue& option, const fs::path& path) {
        std::error_code none;
        if (fs::is_directory(path, none)) {
            // An older extraction in it is replaced as a whole; a folder of anything else is refused.
            if (!fs::exists(path / "manifest.json", none)) return;
            fs::recursive_directory_iterator entry(path, fs::directory_options::skip_permission_denied, none);
            for (; !none && entry != fs::recursive_directory_iterator(); entry.increment(none)) put(*entry, option);
            return;
        }
        put(path, option);
        for (const fs::path& file : files_of_pattern(path)) put(file, option);
    }

    bool empty() const { return files_.empty(); }

    /// \param given the name by which the user gave what is read
    void refuse(const fs::path& read, const std::string& given) const {
        const std::optional<FileId> id = id_of(read);
        if (!id) return;
        const auto found = files_.find(*id);
        if (found == files_.end()) return;
        throw Error(ErrorKind::usage, fmt::format("{} '{}' would replace what is read, '{}'; choose another name",
                                                  found->second.first, found->second.second, given));
    }

  private:
    void put(const fs::path& path, const OptionValue& option) {
        if (const std::optional<FileId> id = id_of(path)) {
            const std::string flag = option.name == "output" ? "-o" : "--" + option.name;
            files_.emplace(*id, std::pair(flag, option.value));
        }
    }

    /// What is there of a series or an animation.
    static std::vector<fs::path> files_of_pattern(const fs::path& path) {
        std::vector<fs::path> files;
        try {
            const image::NamePattern pattern(path);
            const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
            std::error_code none;
            if (!pattern.has_field()) return {};
            for (fs::directory_iterator entry(folder, none); !none && entry != fs::directory_iterator();
                 entry.increment(none)) {
                if (pattern.may_be(entry->path().filename().string())) files.push_back(entry->path());
            }
        } catch (const Error&) {
            return {};  // who takes the name says what is wrong with it
        }
        return files;
    }

    std::map<FileId, std::pair<std::string, std::string>> files_;
};

}  // namespace

void check_no_input_overwritten(const CommandLine& line) {
    Outputs outputs;
    const std::vector<OptionValue> given = line.given(all_groups);
    const bool blessed = std::ranges::find(given, "bless", &OptionValue::name) != given.end();
    std::vector<std::string> inputs = line.arguments();
    if (!line.config().file.empty()) inputs.push_back(line.config().file.string());
    for (const OptionValue& option : line.values(all_groups)) {
        if (option.value.empty()) continue;
        const bool compared = option.use == FileUse::compared;
        if (option.use == FileUse::written || (compared && blessed)) outputs.add(option, option.value);
        if (option.use == FileUse::read || (compared && !blessed)) inputs.push_back(option.value);
        if (compared && !blessed) outputs.add(option, app::candidate_of(option.value));
    }
    if (outputs.empty()) return;
    for (const std::string& input : inputs) {
        for (const fs::path& file : video::files_of_input(input)) outputs.refuse(file, input);
    }
}

}  // namespace vvr::options
