#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/setting.h"

namespace vvr::gl {

class Context;

/// One way to get an OpenGL context; gl/context.cpp holds the table.
struct Backend {
    std::string name;
    std::string help;
    std::unique_ptr<Context> (*open)(int device, bool debug) = nullptr;  ///< null = the first other one that works
    std::vector<std::string> (*devices)() = nullptr;  ///< what `device` counts; empty for a backend without devices
    std::string advice{};                             ///< the command that makes it work on Debian
    bool gpu = false;                                 ///< opens the devices of a graphics card
};

/// The table; the first row is "auto", which tries the others in order.
const std::vector<Backend>& backends();

Backend egl_hardware_backend();
Backend egl_software_backend();
Backend osmesa_backend();

const Backend& row_of(Name<Backend> name);

}  // namespace vvr::gl
