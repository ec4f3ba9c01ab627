#include "gl/library.h"

#include <dlfcn.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/loading.h"

namespace vvr::gl {

Library::Library(const std::vector<std::string>& names) {
    std::string why;
    for (const std::string& name : names) {
        // Mesa and its LLVM register handlers that must outlive us: a real dlclose crashes at exit with some drivers.
        constexpr int how = RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE;
        if (void* handle = while_loading([&] { return dlopen(name.c_str(), how); })) {
            handle_ = std::shared_ptr<void>(handle, [](void* library) { dlclose(library); });
            name_ = name;
            return;
        }
        why = dlerror();
    }
    throw Error(ErrorKind::backend, fmt::format("cannot load {}: {}", fmt::join(names, " or "), why));
}

void* Library::symbol(const char* name) const {
    void* address = dlsym(handle_.get(), name);
    if (address == nullptr) throw Error(ErrorKind::backend, fmt::format("{} has no function {}", name_, name));
    return address;
}

}  // namespace vvr::gl
