#pragma once

#include <cstddef>
#include <span>

namespace irsg {

/// Products and their sums over long vectors, several places at once: in the vectors that the
/// processor has, and in an order that is the same on every machine.

/// Sum of a[i] b[i].
double dotProduct(const double* a, const double* b, std::size_t count);

/// The most vectors that dotProducts takes at once.
inline constexpr std::size_t mostTogether = 8;

/// The same of each of `vectors`, 1, 2, 4 or 8 of them, with each of `others`, which are read from
/// place `from` on: sums[k * vectors.size() + v] of vector v with the k-th. The more vectors, the
/// less is read for each sum.
void dotProducts(std::span<const double* const> vectors, std::span<const double* const> others,
                 std::size_t from, std::size_t count, double* sums);

/// products[i] = a[i] b[i]; it may be one of them.
void fillProducts(const double* a, const double* b, std::size_t count, double* products);

/// Splits products in two: second[i] = parts[i] a[i] b[i], first[i] what is left of a[i] b[i].
void splitProducts(const double* a, const double* b, const double* parts, std::size_t count,
                   double* first, double* second);

} // namespace irsg
