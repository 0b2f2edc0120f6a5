#pragma once

#include <cstddef>
#include <vector>

namespace irsg {

/// Complex numbers on a grid, top row first, real and imaginary parts apart.
struct ComplexPlane {
    ComplexPlane(std::size_t columns, std::size_t rows)
        : width(columns), height(rows), re(columns * rows), im(columns * rows) {}

    std::size_t width, height;
    std::vector<double> re, im;
};

/// The least number from `size` on with no prime factor but 2, 3 and 5; at least 1.
std::size_t smoothSize(std::size_t size);

/// The discrete Fourier transform in both directions, in place: sum of f exp(-2 pi i k x / n), of
/// the inverse exp(+...) and divided by the number of points. Sides have the factors 2, 3 and 5
/// alone (LogicError). Stockham's order, so that nothing is permuted (van Loan, Computational
/// Frameworks for the Fast Fourier Transform, 1.7). The result does not depend on the number of
/// threads.
void transform(ComplexPlane& plane);
void transformBack(ComplexPlane& plane);

} // namespace irsg
