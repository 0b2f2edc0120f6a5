#include <gtest/gtest.h>

#include "tests/support/TablesOfTests.h"

namespace irsg {
namespace {

TEST(FormatTables, HaveATestForEveryRow) {
    EXPECT_GE(test::expectTests("formats-images.md", {"OpenEXR", "TIFF"}, test::testsIn({"image"})),
              30U);
}

} // namespace
} // namespace irsg
