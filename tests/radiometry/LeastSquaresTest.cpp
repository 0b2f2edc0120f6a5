#include "irsg/core/LeastSquares.h"

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

using namespace irsg;

namespace {

ColumnMatrix matrix(std::size_t rows, std::size_t columns, std::vector<double> byRow) {
    ColumnMatrix made(rows, columns);
    for (std::size_t i = 0; i < byRow.size(); ++i) {
        made.at(i / columns, i % columns) = byRow[i];
    }
    return made;
}

TEST(LeastSquares, SolvesWhatHasASolution) {
    const ColumnMatrix a = matrix(3, 2, {1, 2, 0, 1, 4, -1});
    const ColumnMatrix b = matrix(3, 2, {8, 1, 3, 0, 5, 4}); // of (2, 3) and (1, 0)
    const ColumnMatrix x = leastSquares(a, b, 1e-9);
    EXPECT_NEAR(x.at(0, 0), 2.0, 1e-12);
    EXPECT_NEAR(x.at(1, 0), 3.0, 1e-12);
    EXPECT_NEAR(x.at(0, 1), 1.0, 1e-12);
    EXPECT_NEAR(x.at(1, 1), 0.0, 1e-12);
}

TEST(LeastSquares, FitsAStraightLine) {
    // y = 1.4 + 3.6 x through (0, 1), (1, 6), (2, 9), (3, 11.2): normal equations by hand.
    const ColumnMatrix a = matrix(4, 2, {1, 0, 1, 1, 1, 2, 1, 3});
    const ColumnMatrix b = matrix(4, 1, {1, 6, 9, 11.2});
    const ColumnMatrix x = leastSquares(a, b, 1e-9);
    EXPECT_NEAR(x.at(0, 0), 1.76, 1e-9);
    EXPECT_NEAR(x.at(1, 0), 3.36, 1e-9);
}

TEST(LeastSquares, SharesBetweenEqualColumnsAndLeavesOutEmptyOnes) {
    const ColumnMatrix a = matrix(2, 3, {1, 1, 0, 2, 2, 0});
    const ColumnMatrix x = leastSquares(a, matrix(2, 1, {3, 6}), 1e-4);
    EXPECT_NEAR(x.at(0, 0), 1.5, 1e-6);
    EXPECT_NEAR(x.at(1, 0), 1.5, 1e-6);
    EXPECT_EQ(x.at(2, 0), 0.0);
    EXPECT_THROW(leastSquares(a, matrix(3, 1, {1, 2, 3}), 1e-4), LogicError);
}

} // namespace
