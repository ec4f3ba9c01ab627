#pragma once

#include <cstdlib>
#include <ctime>

namespace vvr::test {

/// The local time zone while it lives. Then it is UTC again.
class InZone {
  public:
    explicit InZone(const char* zone) { set(zone); }
    ~InZone() { set("UTC"); }
    InZone(const InZone&) = delete;
    InZone& operator=(const InZone&) = delete;

  private:
    static void set(const char* zone) {
        ::setenv("TZ", zone, 1);
        ::tzset();
    }
};

}  // namespace vvr::test
