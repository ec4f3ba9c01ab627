#include <gtest/gtest.h>

#include "core/base/memory.h"

/// GoogleTest's, with malloc as the program has it.
int main(int argc, char** argv) {
    vvr::tune_malloc();
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
