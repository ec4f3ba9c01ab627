/// For programs that LeakSanitizer checks: keeps every library loaded until the program ends. Of a leak in one that is
/// gone by then, such as an OpenGL driver's, it can't say whose it is, and tests/leaks.supp can't name it.
extern "C" [[gnu::visibility("default")]] int dlclose(void*) noexcept {
    return 0;
}
