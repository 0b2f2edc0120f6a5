#include "irsg/radiometry/DotProducts.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

using namespace irsg;

namespace {

/// first, first + 1, ... : sums of their products are whole numbers that a double holds.
std::vector<double> wholeNumbers(std::size_t count, double first) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < count; ++i) {
        numbers.push_back(first + static_cast<double>(i));
    }
    return numbers;
}

double sumOneByOne(const double* a, const double* b, std::size_t count) {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

} // namespace

TEST(SumOfProducts, IsExactForWholeNumbersOfAnyLength) {
    for (std::size_t count = 0; count < 70; ++count) {
        const std::vector<double> a = wholeNumbers(count, 1.0), b = wholeNumbers(count, -20.0);
        EXPECT_EQ(dotProduct(a.data(), b.data(), count), sumOneByOne(a.data(), b.data(), count))
            << count;
    }
}

TEST(DotProducts, AreThoseOfEveryVectorWithEveryOther) {
    constexpr std::size_t most = 70, from = 3;
    std::vector<std::vector<double>> vectors, others;
    for (std::size_t v = 0; v < mostTogether; ++v) {
        vectors.push_back(wholeNumbers(most, 5.0 * static_cast<double>(v) - 11.0));
    }
    for (std::size_t k = 0; k < 3; ++k) {
        others.push_back(wholeNumbers(from + most, 7.0 * static_cast<double>(k) - 30.0));
    }
    std::vector<const double*> ofOthers;
    ofOthers.reserve(others.size());
    for (const std::vector<double>& other : others) {
        ofOthers.push_back(other.data());
    }

    for (const std::size_t width : {1U, 2U, 4U, 8U}) {
        for (std::size_t count = 0; count < most; ++count) {
            std::vector<const double*> ofVectors;
            for (std::size_t v = 0; v < width; ++v) {
                ofVectors.push_back(vectors[v].data());
            }
            std::vector<double> sums(width * others.size(), std::nan(""));
            dotProducts(ofVectors, ofOthers, from, count, sums.data());
            for (std::size_t k = 0; k < others.size(); ++k) {
                for (std::size_t v = 0; v < width; ++v) {
                    EXPECT_EQ(sums[k * width + v],
                              sumOneByOne(ofVectors[v], ofOthers[k] + from, count))
                        << width << " vectors of " << count << ": " << v << " with " << k;
                }
            }
        }
    }
}

TEST(DotProducts, AreTheSameToTheLastBitHoweverManyAreTakenTogether) {
    constexpr std::size_t count = 131;
    std::vector<double> a, b;
    for (std::size_t i = 0; i < count; ++i) {
        a.push_back(std::sin(static_cast<double>(i)));
        b.push_back(std::exp(-0.1 * static_cast<double>(i)));
    }
    const std::vector<const double*> other{b.data()};
    double alone = 0.0;
    dotProducts(std::vector<const double*>{a.data()}, other, 0, count, &alone);
    for (const std::size_t width : {2U, 4U, 8U}) {
        std::vector<double> sums(width);
        dotProducts(std::vector<const double*>(width, a.data()), other, 0, count, sums.data());
        EXPECT_EQ(sums, std::vector<double>(width, alone)) << width;
    }
    EXPECT_NEAR(alone, sumOneByOne(a.data(), b.data(), count), 1e-15);
}

TEST(DotProducts, RefuseNumbersOfVectorsThatTheyAreNotMadeFor) {
    const std::vector<double> a{1.0};
    const std::vector<const double*> three(3, a.data());
    double sums[3];
    EXPECT_THROW(dotProducts(three, three, 0, 1, sums), LogicError);
}

TEST(Products, AreMadeInPlaceAndSplitWithoutLoss) {
    const std::vector<double> a = wholeNumbers(21, 1.0), parts(21, 0.25);
    std::vector<double> squares = a;
    fillProducts(squares.data(), a.data(), a.size(), squares.data());
    std::vector<double> first(a.size()), second(a.size());
    splitProducts(squares.data(), a.data(), parts.data(), a.size(), first.data(), second.data());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(squares[i], a[i] * a[i]);
        EXPECT_EQ(second[i], 0.25 * squares[i] * a[i]);
        EXPECT_EQ(first[i] + second[i], squares[i] * a[i]);
    }
}
