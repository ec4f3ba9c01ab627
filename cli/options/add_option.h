#pragma once

#include "cli/options/command_line.h"
#include "cli/options/value.h"
#include "core/base/setting.h"

namespace vvr::options {

/// Adds an option of the group for each setting that it is called with. The variable holds the default and receives the
/// value. It can visit lists of settings (cli/plan/settings.h), whose further arguments it passes on to
/// cli/options/value.h.
class AddOptions {
  public:
    AddOptions(CommandLine& line, Group group) : line_(line), group_(group) {}

    template <class Variable>
    void operator()(const Setting& setting, Variable& variable, const OptionExtra& extra = {}) const {
        line_.add(group_, setting, value_of(setting, variable), extra);
    }

    template <class Variable>
    void operator()(const Setting& setting, Variable& variable, const app::Word& word) const {
        line_.add(group_, setting, value_of(setting, variable, word));
    }

    /// The name of a row of a table.
    template <class Variable, class Rows>
    void operator()(const Setting& setting, Variable& variable, const Rows& rows) const {
        line_.add(group_, setting, choice_of(setting, variable, rows, line_.is_for_streams()));
    }

    /// The names of rows with an enumerator.
    template <class Variable, class Rows, class Enum, class Row>
    void operator()(const Setting& setting, Variable& variable, const Rows& rows, Enum Row::*member) const {
        line_.add(group_, setting, choice_of(setting, variable, rows, member));
    }

    /// A number whose default is that of a row which another setting chooses.
    template <class Variable, class Row, class Rows, class Default>
    void operator()(const Setting& setting, Variable& variable, const Choice<Row>& chosen, const Rows& rows,
                    Default default_of) const {
        line_.add(group_, setting, value_of(setting, variable, chosen, rows, default_of));
    }

  private:
    CommandLine& line_;
    Group group_;
};

}  // namespace vvr::options
