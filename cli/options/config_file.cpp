#include "cli/options/config_file.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/suggest.h"

namespace vvr {

std::vector<CLI::ConfigItem> ConfigFile::from_config(std::istream& input) const {
    std::vector<CLI::ConfigItem> kept;
    for (CLI::ConfigItem& item : CLI::ConfigTOML::from_config(input)) {
        const bool section_mark = item.name == "++" || item.name == "--";
        if (section_mark || (!item.parents.empty() && item.parents.front() != command_)) continue;
        item.parents.clear();
        const CLI::Option* option = app_.get_option_no_throw("--" + item.name);
        if (option == nullptr || !option->get_configurable()) {
            std::vector<std::string> names;
            for (const CLI::Option* known : app_.get_options()) {
                if (known->get_configurable() && !known->get_lnames().empty()) {
                    names.push_back(known->get_lnames().front());
                }
            }
            throw Error(ErrorKind::usage, fmt::format("the config file '{}' sets '{}', which `vvr {}` does not have{}",
                                                      file_, item.name, command_, did_you_mean(item.name, names)));
        }
        kept.push_back(std::move(item));
    }
    return kept;
}

}  // namespace vvr
