#pragma once

#include "core/error.h"
#include "gl/context.h"

namespace vvr {

/// While it lives, the context is no thread's; afterwards it is current again where it was. For a thread that calls
/// what draws from other threads.
class ContextForOthers {
  public:
    explicit ContextForOthers(Context& context) : context_(context) { context_.release(); }
    ~ContextForOthers() {
        try {
            context_.take();
        } catch (const Error&) {
            // Without its context nothing more is drawn; the next check of OpenGL says so.
        }
    }
    ContextForOthers(const ContextForOthers&) = delete;
    ContextForOthers& operator=(const ContextForOthers&) = delete;

  private:
    Context& context_;
};

/// While it lives, a context that is no thread's is current in this one.
class BorrowedContext {
  public:
    explicit BorrowedContext(Context& context) : context_(context) { context_.take(); }
    ~BorrowedContext() { context_.release(); }
    BorrowedContext(const BorrowedContext&) = delete;
    BorrowedContext& operator=(const BorrowedContext&) = delete;

  private:
    Context& context_;
};

}  // namespace vvr
