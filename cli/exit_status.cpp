#include "cli/exit_status.h"

#include <algorithm>
#include <array>

namespace vvr::cli {

namespace {

struct Row {
    ErrorKind kind;
    ExitStatus status;
};

constexpr std::array table{
    Row{ErrorKind::usage, ExitStatus::usage},         Row{ErrorKind::io, ExitStatus::io},
    Row{ErrorKind::not_video, ExitStatus::not_video}, Row{ErrorKind::backend, ExitStatus::backend},
    Row{ErrorKind::limit, ExitStatus::limit},         Row{ErrorKind::partial, ExitStatus::partial},
    Row{ErrorKind::differs, ExitStatus::differs},
};

}  // namespace

ExitStatus exit_status(ErrorKind kind) {
    const auto row = std::ranges::find(table, kind, &Row::kind);
    return row == table.end() ? ExitStatus::bug : row->status;
}

}  // namespace vvr::cli
