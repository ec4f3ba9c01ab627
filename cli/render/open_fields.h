#pragma once

#include <memory>
#include <string>

#include "cli/command_line.h"
#include "cli/options/render_settings.h"
#include "core/fields/field_source.h"

namespace vvr {

/// The fields that a command works on.
struct OpenedFields {
    std::unique_ptr<FieldSource> source;
    Metadata extracted;  ///< options that were decided when the fields were extracted; empty for a clip
};

/// Opens a clip, the directory of an extraction, or several with consecutive parts.
/// \throws Error usage as well where options contradict those of the extraction
OpenedFields open_fields(const RenderSettings& settings, const CommandLine& line);

/// Whether the value of an option may be the name of a file, in which a part of the settings stands.
bool may_name_file(const std::string& option);

/// The value of an option without the folder, where it may be a file's name: what is passed on should not tell where
/// its maker keeps files.
std::string without_folder(const std::string& option, const std::string& value);

}  // namespace vvr
