#pragma once

#include <algorithm>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/options/command_line.h"
#include "cli/options/parse_value.h"
#include "cli/options/value_types.h"
#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/fields/options.h"
#include "core/image/picture.h"

// Visitors of the lists of settings (cli/app/settings.h).
namespace vvr::options {

/// Adds an option of the group to the command line for each setting that it visits. The member that it is given holds
/// the default and receives the value; its type decides how the value is parsed (cli/options/value_types.h).
class AddOptions {
  public:
    AddOptions(CommandLine& line, Group group) : line_(line), group_(group) {}

    template <class Value>
    void operator()(const Setting& setting, Value&& value) const {
        (*this)(setting, std::forward<Value>(value), help_of_values(value));
    }

    /// \param extra what the setting does not have
    template <class Value>
    void operator()(const Setting& setting, Value&& value, const OptionExtra& extra) const {
        using Type = std::remove_cvref_t<Value>;
        if constexpr (std::is_same_v<Type, bool>) {
            line_.flag(group_, value, setting, extra);
        } else if constexpr (std::is_same_v<Type, std::vector<std::string>>) {
            line_.list(group_, value, setting, extra);
        } else {
            constexpr bool is_path = std::is_same_v<Type, std::filesystem::path>;
            const bool is_output = extra.letter == 'o' || extra.use != FileUse::none;
            // A member is kept by reference, a value that refers to members by copy.
            line_.value(
                group_, setting, default_of(setting, value_text(setting, value)),
                [setting, needs_file = is_path && is_output && !extra.standard_output,
                 target = std::tuple<Value>(std::forward<Value>(value))](const std::string& text) mutable {
                    if (needs_file && text == "-") {
                        throw Error(ErrorCode::option_value,
                                    "'-' means standard input or output, which is not possible here; write ./- "
                                    "for a file of that name");
                    }
                    set_value(setting, text, std::get<0>(target));
                },
                extra);
        }
    }

    /// The name of a row. Help explains the rows.
    template <class Value, class Rows>
    void operator()(const Setting& setting, Value&& value, const Rows& rows) const {
        if constexpr (requires { value.or_file; }) {
            line_.value(group_, setting, name_of(value), [&value](const std::string& text) { value = text; },
                        {.help = std::string(value.or_file), .values = values_of(line_.fitting(rows))});
        } else {
            add_choice(setting, rows, name_of(value), [&value](const auto& row) { value = row; });
        }
    }

    /// The name of the row that has the enumerator.
    template <class Value, class Rows, class Row>
    void operator()(const Setting& setting, Value& value, const Rows& rows, Value Row::*member) const {
        add_choice(setting, rows, value_text(setting, value, rows, member),
                   [&value, member](const auto& row) { value = row.*member; });
    }

    /// The enumerators of some rows, as names separated by commas.
    template <class Value, class Rows, class Row>
    void operator()(const Setting& setting, std::set<Value>& values, const Rows& rows, Value Row::*member) const {
        line_.value(group_, setting, names_in(values, rows, member),
                    [setting, &values, &rows, member](const std::string& text) {
                        values.clear();
                        for (const std::string& word : split_list(text))
                            values.insert(choose(setting.name, word, rows).*member);
                    },
                    {.values = values_of(rows)});
    }

    /// A number whose default is that of a row which another setting chooses. Help lists the rows' defaults.
    template <class Value, class Row, class Rows, class Default>
    void operator()(const Setting& setting, Value& value, const Row& /*chosen*/, const Rows& rows,
                    Default default_of_row) const {
        const auto text = [&](const auto& row) { return fmt::to_string(default_of_row(row)); };
        (*this)(setting, value, OptionExtra{.defaults = defaults_of(rows, text)});
    }

  private:
    static std::string default_of(const Setting& setting, const std::string& text) {
        return setting.default_text.empty() ? text : std::string(setting.default_text);
    }

    /// \param rows of a table that stays
    template <class Rows, class Set>
    void add_choice(const Setting& setting, const Rows& rows, const std::string& chosen, Set set) const {
        const std::span table(std::data(rows), std::size(rows));
        const auto fitting = line_.fitting(table);
        line_.value(group_, setting, chosen,
                    [set, table, names = names_of(fitting), name = setting.name](const std::string& text) {
                        if (std::ranges::find(names, text) == names.end()) refuse_choice(name, text, names);
                        set(*std::ranges::find_if(table, [&](const auto& row) { return row.name == text; }));
                    },
                    {.values = values_of(fitting)});
    }

    CommandLine& line_;
    Group group_;
};

/// Records each setting that it visits: its name and its value, which may be empty.
class Record {
  public:
    explicit Record(image::Metadata& settings) : settings_(settings) {}

    template <class... Value>
    void operator()(const Setting& setting, const Value&... value) const {
        const OptionValue option{std::string(setting.name), value_text(setting, value...), setting.may_be_file};
        settings_.emplace_back(option.name, option.shown());
    }

  private:
    image::Metadata& settings_;
};

}  // namespace vvr::options
