#include <gtest/gtest.h>

#include "tests/support/TablesOfTests.h"

namespace irsg {
namespace {

TEST(ModtranTables, HaveATestForEveryRow) {
    EXPECT_GE(test::expectTests("atmosphere-tabulated.md",
                                {"Features of tape7", "Features of MODTRAN 6 documents",
                                 "Features of MODTRAN 6 tables"},
                                test::testsIn({"atmosphere"})),
              30U);
}

} // namespace
} // namespace irsg
