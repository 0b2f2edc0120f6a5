#include <cmath>

#include <gtest/gtest.h>

#include "irsg/atmosphere/ck/SparseWeights.h"

namespace irsg {
namespace {

SparseProblem problem(std::size_t rows, std::size_t columns) {
    SparseProblem p;
    p.columnCount = columns;
    for (std::size_t r = 0; r < rows; ++r) {
        for (std::size_t c = 0; c < columns; ++c) {
            p.matrix.push_back(
                static_cast<float>(std::exp(-std::exp(-3.0 + 0.2 * static_cast<double>(c)) * 0.05 *
                                            static_cast<double>(r + 1))));
        }
    }
    p.target.assign(rows, 0.0);
    return p;
}

TEST(SparseWeights, FindsTheColumnsOfWhichTheTargetIsMade) {
    SparseProblem p = problem(50, 30);
    for (std::size_t r = 0; r < p.rows(); ++r) {
        p.target[r] =
            0.5 * static_cast<double>(p.row(r)[4]) + 2.0 * static_cast<double>(p.row(r)[22]);
    }
    const SparseWeights found = sparseWeights(p, 1e-4, 30);
    EXPECT_LE(found.largestError, 1e-4);
    EXPECT_LE(found.columns.size(), 5u);
    double sum = 0.0;
    for (const double weight : found.weights) {
        EXPECT_GT(weight, 0.0);
        sum += weight;
    }
    EXPECT_NEAR(sum, 2.5, 0.01);
}

TEST(SparseWeights, UsesNoMoreThanItMay) {
    SparseProblem p = problem(60, 40);
    for (std::size_t c = 0; c < 40; ++c) {
        for (std::size_t r = 0; r < p.rows(); ++r) {
            p.target[r] += static_cast<double>(p.row(r)[c]) / 40.0;
        }
    }
    double last = 1.0;
    for (const std::size_t most : {1u, 2u, 3u, 4u}) {
        const SparseWeights found = sparseWeights(p, 0.0, most);
        EXPECT_LE(found.columns.size(), most);
        EXPECT_LT(found.rmsError, last);
        last = found.rmsError;
    }
}

TEST(SparseWeights, GivesNothingForATargetThatNoPositiveWeightServes) {
    SparseProblem p = problem(20, 10);
    p.target.assign(20, -1.0);
    const SparseWeights found = sparseWeights(p, 1e-6, 10);
    EXPECT_TRUE(found.columns.empty());
    EXPECT_DOUBLE_EQ(found.largestError, 1.0);
}

} // namespace
} // namespace irsg
