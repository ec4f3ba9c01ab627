#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gl/context.h"

namespace vvr::gl {

/// One way to get an OpenGL context; gl/context.cpp holds the table.
struct Backend {
    std::string name;
    std::string what;
    std::unique_ptr<Context> (*open)(int device, bool debug);
    std::vector<std::string> (*devices)();  ///< what `device` counts; empty for a backend without devices
    std::string advice;                     ///< the command that makes it work on Debian
    bool gpu = false;                       ///< opens the devices of a graphics card
};

Backend egl_hardware_backend();
Backend egl_software_backend();
Backend osmesa_backend();

}  // namespace vvr::gl
