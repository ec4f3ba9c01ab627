#include "cli/options/output_files.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include <sys/stat.h>

#include <fmt/format.h>

#include "cli/plan/settings.h"
#include "cli/write/golden.h"
#include "core/archive/output_files.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/footage/input_files.h"
#include "core/image/name_pattern.h"

namespace vvr::options {

namespace {

namespace fs = std::filesystem;

/// Identifies a file whatever its names. Symbolic links are followed.
using FileId = std::pair<dev_t, ino_t>;

std::optional<FileId> id_of(const fs::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return FileId{status.st_dev, status.st_ino};
}

std::string flag_of(const OptionValue& option) {
    return option.name == "output" ? "-o" : "--" + option.name;
}

/// The path without links and detours. It need not exist.
fs::path whole_path(const fs::path& path) {
    std::error_code none;
    return fs::weakly_canonical(fs::absolute(path, none), none);
}

/// Whether both paths name the same file. It need not exist. A device or a pipe may have several writers.
bool same_file(const fs::path& a, const fs::path& b) {
    std::error_code none;
    if (fs::is_other(a, none)) return false;
    if (fs::equivalent(a, b, none)) return true;
    return !a.empty() && !b.empty() && whole_path(a) == whole_path(b);
}

/// Whether an archive gives its files such names, the pieces of its clips too.
bool is_name_of_archive(const fs::path& file) {
    const std::string extension = extension_of(file);
    return !extension.empty() && (extension == ".js" || footage::is_video_name(file.string()) ||
                                  std::ranges::any_of(archive::output_rows, [&](const archive::OutputRow& row) {
                                      return row.extension.ends_with(extension);
                                  }));
}

/// Whether a file may be one of an output's: of a pattern, as 'out.3.png' of 'out.{brick}.png', or of a folder.
bool may_have(const OptionValue& output, const fs::path& path) {
    const fs::path below = whole_path(path).lexically_relative(whole_path(output.value));
    if (!below.empty() && below != "." && *below.begin() != "..")
        return output.use != FileUse::filled || is_name_of_archive(path);
    try {
        const image::NamePattern names(output.value);
        return names.has_field() && names.may_be(path.filename().string()) &&
               same_file(fs::absolute(names.path()).parent_path(), fs::absolute(path).parent_path());
    } catch (const Error&) {
        return false;  // a check of the name itself reports the error
    }
}

/// The existing files that a run would overwrite, each with its option and the name given.
class Outputs {
  public:
    void add(const OptionValue& option, const fs::path& path) {
        std::error_code none;
        if (fs::is_directory(path, none)) {
            // An older extraction is replaced as a whole. Any other folder is refused elsewhere.
            if (!fs::exists(path / "manifest.json", none)) return;
            fs::recursive_directory_iterator entry(path, fs::directory_options::skip_permission_denied, none);
            for (; !none && entry != fs::recursive_directory_iterator(); entry.increment(none)) put(*entry, option);
            return;
        }
        put(path, option);
        for (const fs::path& file : files_of_pattern(path)) put(file, option);
    }

    bool empty() const { return files_.empty(); }

    /// \param given the user's name for the input
    void refuse(const fs::path& read, const std::string& given) const {
        const std::optional<FileId> id = id_of(read);
        if (!id) return;
        const auto found = files_.find(*id);
        if (found == files_.end()) return;
        throw Error(ErrorCode::output_replaces_input,
                    fmt::format("{} '{}' would overwrite the input '{}'; use another name", found->second.first,
                                found->second.second, given));
    }

  private:
    void put(const fs::path& path, const OptionValue& option) {
        if (const std::optional<FileId> id = id_of(path)) {
            files_.emplace(*id, std::pair(flag_of(option), option.value));
        }
    }

    /// The existing files of a series or an animation.
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
            return {};  // a check of the name itself reports the error
        }
        return files;
    }

    std::map<FileId, std::pair<std::string, std::string>> files_;
};

}  // namespace

void check_outputs_differ(const CommandLine& line) {
    const bool blessed = line.has(setting::bless);
    std::vector<OptionValue> outputs = line.values(all_groups);
    std::error_code none;
    std::erase_if(outputs, [&](const OptionValue& option) {
        if (option.value.empty()) return true;
        if (option.use == FileUse::written || option.use == FileUse::filled) return false;
        // check_no_input_overwritten protects a golden picture that is there.
        return option.use != FileUse::compared || (!blessed && fs::exists(option.value, none));
    });
    for (auto a = outputs.begin(); a != outputs.end(); ++a) {
        for (auto b = a + 1; b != outputs.end(); ++b) {
            if (is_standard_output(a->value) && is_standard_output(b->value)) {
                throw Error(ErrorCode::options_conflict,
                            fmt::format("{} and {} both write to standard output; name a file for one of them",
                                        flag_of(*a), flag_of(*b)));
            }
            const bool is_of_first = may_have(*a, b->value);
            if (!is_of_first && !may_have(*b, a->value) && !same_file(a->value, b->value)) continue;
            throw Error(ErrorCode::options_conflict,
                        fmt::format("{} and {} both name '{}'; use another name for one of them", flag_of(*a),
                                    flag_of(*b), is_of_first ? b->value : a->value));
        }
    }
}

std::vector<std::string> inputs_of(const CommandLine& line) {
    std::vector<std::string> inputs = line.arguments();
    if (!line.config().file.empty()) inputs.push_back(line.config().file.string());
    for (const OptionValue& option : line.values(all_groups)) {
        const bool compared = option.use == FileUse::compared && !line.has(setting::bless);
        if (!option.value.empty() && (option.use == FileUse::read || compared)) inputs.push_back(option.value);
    }
    return inputs;
}

void check_no_input_overwritten(const CommandLine& line, std::span<const std::string> inputs) {
    Outputs outputs;
    const bool blessed = line.has(setting::bless);
    for (const OptionValue& option : line.values(all_groups)) {
        if (option.value.empty()) continue;
        const bool compared = option.use == FileUse::compared;
        if (option.use == FileUse::written || (compared && blessed)) outputs.add(option, option.value);
        if (compared && !blessed) outputs.add(option, app::candidate_of(option.value));
    }
    if (outputs.empty()) return;
    for (const std::string& input : inputs) {
        for (const fs::path& file : footage::files_of_input(input)) outputs.refuse(file, input);
    }
}

}  // namespace vvr::options
