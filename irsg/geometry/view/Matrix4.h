#pragma once

#include <array>
#include <cstddef>

#include "irsg/geometry/view/Vec3.h"

namespace irsg {

/// A 4 x 4 matrix by rows that acts on row vectors, p' = p M: its last row is a translation. It
/// lies in memory as OpenGL reads a matrix that acts on column vectors.
struct Matrix4 {
    std::array<std::array<double, 4>, 4> rows{
        {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

    double& operator()(std::size_t row, std::size_t column) { return rows[row][column]; }
    double operator()(std::size_t row, std::size_t column) const { return rows[row][column]; }
    /// The matrix that does this one first, and then the other.
    Matrix4 operator*(const Matrix4& then) const {
        Matrix4 both;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 4; ++k)
                both(i, k) = rows[i][0] * then(0, k) + rows[i][1] * then(1, k) +
                             rows[i][2] * then(2, k) + rows[i][3] * then(3, k);
        return both;
    }
    /// Of a place, with the fourth coordinate by which the others are to be divided; it is 1 where
    /// the last column is (0, 0, 0, 1).
    std::array<double, 4> homogeneous(const Vec3& p) const {
        std::array<double, 4> there{};
        for (std::size_t k = 0; k < 4; ++k)
            there[k] = p.x * rows[0][k] + p.y * rows[1][k] + p.z * rows[2][k] + rows[3][k];
        return there;
    }
    /// Of a place, where that is 1.
    Vec3 place(const Vec3& p) const {
        const auto [x, y, z, w] = homogeneous(p);
        return {x, y, z};
    }
    bool operator==(const Matrix4&) const = default;
};

} // namespace irsg
