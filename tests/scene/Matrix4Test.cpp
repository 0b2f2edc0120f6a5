#include "irsg/geometry/view/Matrix4.h"

#include <gtest/gtest.h>

using namespace irsg;

namespace {

const Matrix4 turn{{{{0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}}; // x to y
const Matrix4 shift{{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {10, 20, 30, 1}}}};
const Matrix4 project{{{{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 1, -1}, {0, 0, 1, 0}}}}; // w = -z

} // namespace

TEST(Matrix4, OfAProductDoesTheFirstOneFirst) {
    EXPECT_EQ(Matrix4().place({1, 2, 3}), (Vec3{1, 2, 3}));
    EXPECT_EQ((turn * shift).place({1, 2, 3}), (Vec3{8, 21, 33}));
    EXPECT_EQ((shift * turn).place({1, 2, 3}), (Vec3{-22, 11, 33}));
    EXPECT_EQ((turn * shift).place({1, 2, 3}), shift.place(turn.place({1, 2, 3})));
}

TEST(Matrix4, GivesTheFourthCoordinateThatOthersAreDividedBy) {
    EXPECT_EQ((shift * project).homogeneous({1, 2, -40}), (std::array<double, 4>{22, 44, -9, 10}));
    EXPECT_EQ((turn * shift).homogeneous({1, 2, 3})[3], 1.0);
}
