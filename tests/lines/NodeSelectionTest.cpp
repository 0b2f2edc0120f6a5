#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "tools/atmosphere-tables/lines/NodeSelection.h"

namespace irsg::lbl {
namespace {

/// Transmittances exp(-k u) of absorbers spread evenly in ln k over many amounts.
TrainingMatrix spread(std::size_t candidates, std::size_t rows) {
    TrainingMatrix matrix;
    matrix.rows = rows;
    matrix.target.assign(rows, 0.0);
    matrix.rowWeights.assign(rows, 1.0);
    for (std::size_t c = 0; c < candidates; ++c) {
        const double k =
            std::exp(-6.0 + 12.0 * static_cast<double>(c) / static_cast<double>(candidates - 1));
        for (std::size_t r = 0; r < rows; ++r) {
            const double amount =
                std::exp(-5.0 + 10.0 * static_cast<double>(r) / static_cast<double>(rows - 1));
            matrix.columns.push_back(static_cast<float>(std::exp(-k * amount)));
            matrix.target[r] += std::exp(-k * amount) / static_cast<double>(candidates);
        }
    }
    return matrix;
}

TEST(NodeSelection, FindsTheNodesOfWhichTheTargetIsMade) {
    TrainingMatrix matrix = spread(40, 60);
    for (std::size_t r = 0; r < matrix.rows; ++r) {
        matrix.target[r] = 0.3 * static_cast<double>(matrix.column(7)[r]) +
                           0.7 * static_cast<double>(matrix.column(29)[r]);
    }
    const NodeSelection chosen = selectNodes(matrix, {1e-6, 1e-5, 10});
    ASSERT_EQ(chosen.columns, (std::vector<std::size_t>{7, 29}));
    EXPECT_NEAR(chosen.weights[0], 0.3, 1e-5);
    EXPECT_NEAR(chosen.weights[1], 0.7, 1e-5);
    EXPECT_LT(chosen.largestError, 1e-5);
}

TEST(NodeSelection, NeedsOneNodeWhereNothingVaries) {
    TrainingMatrix matrix = spread(20, 30);
    for (std::size_t c = 0; c < 20; ++c) {
        for (std::size_t r = 0; r < 30; ++r) {
            matrix.columns[c * 30 + r] = 0.5f;
        }
    }
    matrix.target.assign(30, 0.5);
    const NodeSelection chosen = selectNodes(matrix, {1e-4, 1e-3, 5});
    EXPECT_EQ(chosen.columns.size(), 1u);
    EXPECT_DOUBLE_EQ(chosen.weights[0], 1.0);
    EXPECT_EQ(chosen.rmsError, 0.0);
}

TEST(NodeSelection, ComesCloserWithEveryNode) {
    const TrainingMatrix matrix = spread(60, 80);
    double last = 1.0;
    for (std::size_t most = 1; most <= 6; ++most) {
        const NodeSelection chosen = selectNodes(matrix, {1e-9, 1e-9, most});
        EXPECT_EQ(chosen.columns.size(), most);
        EXPECT_LT(chosen.rmsError, last);
        EXPECT_NEAR(std::accumulate(chosen.weights.begin(), chosen.weights.end(), 0.0), 1.0, 1e-12);
        for (const double weight : chosen.weights) {
            EXPECT_GT(weight, 0.0);
        }
        last = chosen.rmsError;
    }
    EXPECT_LT(last, 0.004);
}

TEST(NodeSelection, StopsAtTheGoal) {
    const TrainingMatrix matrix = spread(60, 80);
    const NodeSelection coarse = selectNodes(matrix, {0.02, 1.0, 20});
    const NodeSelection fine = selectNodes(matrix, {0.002, 1.0, 20});
    EXPECT_LT(coarse.columns.size(), fine.columns.size());
    EXPECT_LE(coarse.rmsError, 0.0201);
    EXPECT_LE(fine.rmsError, 0.00201);
}

} // namespace
} // namespace irsg::lbl
