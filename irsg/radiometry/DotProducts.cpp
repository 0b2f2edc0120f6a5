#include "irsg/radiometry/DotProducts.h"

#include <array>
#include <cstring>

#include "irsg/core/Errors.h"
#include "irsg/core/VectorClones.h"

namespace irsg {

namespace {

IRSG_VECTOR_CLONES double ofTwo(const double* a, const double* b, std::size_t count) {
    constexpr std::size_t lanes = 16, few = 4;
    std::array<double, lanes> sums{};
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes)
        for (std::size_t k = 0; k < lanes; ++k)
            sums[k] += a[i + k] * b[i + k];
    std::array<double, few> rest{};
    for (; i + few <= count; i += few)
        for (std::size_t k = 0; k < few; ++k)
            rest[k] += a[i + k] * b[i + k];
    double last = 0.0;
    for (; i < count; ++i)
        last += a[i] * b[i];
    return sumOf(sums) + sumOf(rest) + last;
}

struct Table {
    const double *const *vectors, *const *others;
    std::size_t number, from, count; // number of others
    double* sums;
};

constexpr std::size_t lanes = 4; // of a sum: one vector of AVX2
using Lanes = double __attribute__((vector_size(lanes * sizeof(double))));

/// Written for vectors: compilers mix up sums that they are to see as such themselves.
template <std::size_t width>
[[gnu::always_inline]] inline void fill(const Table& t) {
    for (std::size_t o = 0; o < t.number; ++o) {
        const double* const other = t.others[o] + t.from;
        Lanes sums[width] = {};
        std::size_t i = 0;
        for (; i + lanes <= t.count; i += lanes) {
            Lanes b;
            std::memcpy(&b, other + i, sizeof b);
            for (std::size_t v = 0; v < width; ++v) {
                Lanes a;
                std::memcpy(&a, t.vectors[v] + i, sizeof a);
                sums[v] += a * b;
            }
        }
        for (std::size_t v = 0; v < width; ++v) {
            double sum = (sums[v][0] + sums[v][2]) + (sums[v][1] + sums[v][3]);
            for (std::size_t k = i; k < t.count; ++k)
                sum += t.vectors[v][k] * other[k];
            t.sums[o * width + v] = sum;
        }
    }
}

IRSG_VECTOR_CLONES void fill1(const Table& table) {
    fill<1>(table);
}
IRSG_VECTOR_CLONES void fill2(const Table& table) {
    fill<2>(table);
}
IRSG_VECTOR_CLONES void fill4(const Table& table) {
    fill<4>(table);
}
IRSG_VECTOR_CLONES void fill8(const Table& table) {
    fill<8>(table);
}

IRSG_VECTOR_CLONES void productsOfAll(const double* a, const double* b, std::size_t count,
                                      double* products) {
    for (std::size_t i = 0; i < count; ++i)
        products[i] = a[i] * b[i];
}

IRSG_VECTOR_CLONES void splitAll(const double* a, const double* b, const double* parts,
                                 std::size_t count, double* __restrict first,
                                 double* __restrict second) {
    for (std::size_t i = 0; i < count; ++i) {
        const double product = a[i] * b[i];
        second[i] = parts[i] * product;
        first[i] = product - second[i];
    }
}

} // namespace

void fillProducts(const double* a, const double* b, std::size_t count, double* products) {
    productsOfAll(a, b, count, products);
}

void splitProducts(const double* a, const double* b, const double* parts, std::size_t count,
                   double* first, double* second) {
    splitAll(a, b, parts, count, first, second);
}

double dotProduct(const double* a, const double* b, std::size_t count) {
    return ofTwo(a, b, count);
}

void dotProducts(std::span<const double* const> vectors, std::span<const double* const> others,
                 std::size_t from, std::size_t count, double* sums) {
    const Table table{vectors.data(), others.data(), others.size(), from, count, sums};
    switch (vectors.size()) {
    case 1:
        return fill1(table);
    case 2:
        return fill2(table);
    case 4:
        return fill4(table);
    case mostTogether:
        return fill8(table);
    default:
        throw LogicError("sums of products are taken of 1, 2, 4 or 8 vectors at once");
    }
}

} // namespace irsg
