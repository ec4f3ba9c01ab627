#pragma once

#include <memory>
#include <string>
#include <vector>

namespace vvr::gl {

/// A shared library opened at run time. It stays loaded until the program ends.
class Library {
  public:
    /// Opens the first of `names` that is there. \throws Error backend with the loader's own text
    explicit Library(const std::vector<std::string>& names);

    /// The function `name`, cast to its type. \throws Error backend when the library lacks it
    template <class Function>
    Function function(const char* name) const {
        return reinterpret_cast<Function>(symbol(name));
    }

  private:
    void* symbol(const char* name) const;

    std::shared_ptr<void> handle_;
    std::string name_;
};

}  // namespace vvr::gl
