#include "irsg/scattering/MtfFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/scattering/MtfBuild.h"
#include "tests/scattering/KnownHaze.h"

namespace irsg {
namespace {

std::shared_ptr<const PixelHaze> knownHaze(int support, double gain = 1.5) {
    return std::make_shared<const PixelHaze>(HazeFunction(KnownHaze{30.0, gain}.curve()), 1e-3,
                                             support);
}

/// Values between 0 and 1 without a pattern, the same everywhere.
std::vector<float> speckle(std::size_t count) {
    std::vector<float> values;
    std::uint32_t state = 12345;
    for (std::size_t i = 0; i < count; ++i) {
        state = state * 1664525u + 1013904223u;
        values.push_back(static_cast<float>(state >> 8) * 0x1p-24f);
    }
    return values;
}

std::vector<double> direct(const PixelHaze& haze, const HazeWindow& object,
                           const std::vector<float>& values, const HazeWindow& to) {
    std::vector<double> sums;
    for (int y = to.y; y < to.y + to.height; ++y) {
        for (int x = to.x; x < to.x + to.width; ++x) {
            double sum = 0.0;
            for (int v = 0; v < object.height; ++v) {
                for (int u = 0; u < object.width; ++u) {
                    sum += static_cast<double>(
                               values[static_cast<std::size_t>(v * object.width + u)]) *
                           haze.at(x - object.x - u, y - object.y - v);
                }
            }
            sums.push_back(sum);
        }
    }
    return sums;
}

struct Sizes {
    const char* name;
    HazeWindow object;
    int frameWidth, frameHeight, support;
};

const Sizes sizes[] = {
    {"even", {20, 24, 8, 8}, 64, 64, 16},
    {"odd", {11, 13, 7, 5}, 45, 51, 9},
    {"prime", {17, 19, 11, 13}, 61, 67, 23},
    {"not square", {3, 30, 40, 3}, 80, 41, 12},
    {"a row", {5, 0, 9, 1}, 37, 1, 10},
    {"a column", {0, 7, 1, 6}, 1, 29, 40},
    {"one pixel", {0, 0, 1, 1}, 1, 1, 5},
    {"at the left edge", {0, 10, 6, 6}, 50, 40, 20},
    {"in a corner", {44, 34, 6, 6}, 50, 40, 60},
    {"the whole frame", {0, 0, 31, 17}, 31, 17, 64},
    {"support beyond the frame", {30, 2, 5, 9}, 53, 47, 200},
};

TEST(MtfFilter, EqualsTheDirectSumForAllSizes) {
    for (const Sizes& one : sizes) {
        SCOPED_TRACE(one.name);
        MtfFilter filter(knownHaze(one.support));
        const HazeWindow to = one.object.grown(one.support, one.frameWidth, one.frameHeight);
        const std::vector<float> values = speckle(one.object.size());
        std::vector<float> sums(to.size(), 0.0f);
        filter.addHaze(one.object, values, to, sums);
        const std::vector<double> expected = direct(filter.haze(), one.object, values, to);
        const double largest = *std::ranges::max_element(expected);
        double worst = 0.0;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            worst = std::max(worst, std::abs(static_cast<double>(sums[i]) - expected[i]));
        }
        EXPECT_LE(worst, 1e-5 * largest);
        RecordProperty(std::string("worst over largest, ") + one.name,
                       std::to_string(worst / largest));
    }
}

TEST(MtfFilter, GivesTheEnergyOfTheMtfLessTheReportedCut) {
    for (const double gain : {0.3, 6.4, 500.0}) {
        const KnownHaze known{30.0, gain};
        MtfFilter filter(knownHaze(50, gain));
        const HazeWindow object{60, 60, 7, 4}, to = object.grown(50, 127, 124);
        const std::vector<float> values = speckle(object.size());
        std::vector<float> sums(to.size(), 0.0f);
        filter.addHaze(object, values, to, sums);
        double in = 0.0, out = 0.0;
        for (const float value : values) {
            in += static_cast<double>(value);
        }
        for (const float value : sums) {
            out += static_cast<double>(value);
        }
        const double gained = (in + out) / in;
        EXPECT_NEAR(gained / (known.curve().gain() - filter.haze().cut()), 1.0, 1e-6) << gain;
    }
}

TEST(MtfFilter, NeverWraps) {
    // A disc at the left edge: what the report's padding sends to the right half.
    MtfFilter filter(knownHaze(20));
    const HazeWindow object{0, 40, 12, 12}, all{0, 0, 100, 100};
    std::vector<float> sums(all.size(), 0.0f);
    filter.addHaze(object, std::vector<float>(object.size(), 1.0f), all, sums);
    double right = 0.0, largest = 0.0;
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 100; ++x) {
            const double value = static_cast<double>(sums[static_cast<std::size_t>(100 * y + x)]);
            largest = std::max(largest, value);
            if (x >= 32) {
                right = std::max(right, std::abs(value));
            }
        }
    }
    EXPECT_LT(right, 1e-6 * largest);
}

TEST(MtfFilter, SpreadsThePointRoundly) {
    // Of fog, from 3 pixels to where the taper begins: every pixel against the density at its
    // distance, and lattice points of equal distance against each other.
    MtfRecipe recipe;
    recipe.sizes = SizeDistribution::advectionFog();
    recipe.wavelength_um = 10.0;
    recipe.opticalDepths = {2.0};
    const HazeFunction function(buildMtf(recipe).database.at(2.0, "p"));
    const int support = 100, size = 2 * support + 1;
    auto haze = std::make_shared<const PixelHaze>(function, 1e-3, support);
    MtfFilter filter(haze);
    const HazeWindow point{support, support, 1, 1}, all{0, 0, size, size};
    std::vector<float> sums(all.size(), 0.0f);
    filter.addHaze(point, std::vector<float>{1.0f}, all, sums);
    const auto at = [&](int x, int y) {
        return static_cast<double>(
            sums[static_cast<std::size_t>((support + y) * size + support + x)]);
    };
    double worst = 0.0;
    for (int y = -support; y <= support; ++y) {
        for (int x = -support; x <= support; ++x) {
            const double r = std::hypot(x, y);
            if (r < 3.0 || r > haze->taperFrom_px() - 1.0) {
                continue;
            }
            worst =
                std::max(worst, std::abs(at(x, y) / (function.density_sr(1e-3 * r) * 1e-6) - 1.0));
        }
    }
    EXPECT_LE(worst, 0.01);
    const int equal[][4] = {{5, 0, 3, 4},    {7, 1, 5, 5},     {13, 0, 5, 12},  {25, 0, 7, 24},
                            {65, 0, 33, 56}, {65, 0, 52, -39}, {-50, 0, 30, 40}};
    for (const auto& [x0, y0, x1, y1] : equal) {
        EXPECT_NEAR(at(x0, y0) / at(x1, y1), 1.0, 0.01) << x0 << ' ' << y0;
    }
}

/// A picture that repeats itself in both directions, every frequency multiplied with the MTF as it
/// stands: no cut, no padding, the direct image included. `pitch_rad`: angle of a pixel.
std::vector<float> filteredPeriodically(const MtfCurve& curve, double pitch_rad, int width,
                                        int height, const std::vector<float>& image) {
    const std::size_t count = image.size(), columns = static_cast<std::size_t>(width) / 2 + 1;
    FftPlans& plans = FftPlans::shared();
    plans.prepare(width, height);
    const FftBuffer<float> reals = fftReals(count);
    const auto spectrum = fftComplex(columns * static_cast<std::size_t>(height));
    std::ranges::copy(image, reals.get());
    plans.forward(width, height, reals.get(), spectrum.get());
    for (int j = 0; j < height; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            const double down = static_cast<double>(std::min(j, height - j)) / height;
            const double across = static_cast<double>(i) / width;
            const double gain =
                curve.at(std::hypot(across, down) / pitch_rad) / static_cast<double>(count);
            spectrum[static_cast<std::size_t>(j) * columns + i] *= static_cast<float>(gain);
        }
    }
    plans.backward(width, height, spectrum.get(), reals.get());
    return {reals.get(), reals.get() + count};
}

TEST(MtfFilter, IsTheSameFilterInPeriodicAndInLinearMode) {
    // Two ways that share nothing but the curve, in the middle of a frame that the haze fits into.
    const KnownHaze known{300.0, 1.5};
    auto haze = std::make_shared<const PixelHaze>(HazeFunction(known.curve()), 1e-3, 120);
    MtfFilter filter(haze);
    constexpr int size = 256;
    std::vector<float> image(size * size, 0.0f);
    // A smooth spot, so that pixels and points are alike.
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            image[static_cast<std::size_t>(size * y + x)] = static_cast<float>(
                std::exp(-0.5 * (std::pow(x - 128.0, 2) + std::pow(y - 128.0, 2)) / 36.0));
        }
    }
    const std::vector<float> periodic =
        filteredPeriodically(known.curve(), 1e-3, size, size, image);
    std::vector<float> linear = image;
    filter.addHaze({0, 0, size, size}, image, {0, 0, size, size}, linear);
    for (const int x : {128, 130, 140, 160, 180}) {
        EXPECT_NEAR(periodic[static_cast<std::size_t>(size * 128 + x)],
                    linear[static_cast<std::size_t>(size * 128 + x)], 5e-3);
    }
}

TEST(MtfFilter, PlansASizeOnce) {
    MtfFilter filter(knownHaze(10));
    const HazeWindow object{20, 20, 9, 9}, to = object.grown(10, 60, 60);
    std::vector<float> sums(to.size(), 0.0f);
    const std::vector<float> values(object.size(), 1.0f);
    filter.addHaze(object, values, to, sums);
    const std::size_t planned = FftPlans::shared().planned();
    for (int i = 0; i < 5; ++i) {
        filter.addHaze(object, values, to, sums);
    }
    EXPECT_EQ(FftPlans::shared().planned(), planned);
}

TEST(MtfFilter, TakesSmallTransformsWhereTheWindowIsSmall) {
    const MtfFilter filter(knownHaze(64));
    const HazeWindow object{224, 224, 64, 64};
    EXPECT_EQ(filter.points(object, object.grown(64, 512, 512)), 192u * 192u);
    EXPECT_EQ(filter.haze().support_px(), 64);
}

TEST(MtfFilter, RefusesWindowsWithOtherNumbersOfPixels) {
    MtfFilter filter(knownHaze(4));
    std::vector<float> sums(9, 0.0f);
    EXPECT_THROW(filter.addHaze({0, 0, 2, 2}, std::vector<float>(3, 0.0f), {0, 0, 3, 3}, sums),
                 LogicError);
}

TEST(FftPlans, ChoosesSizesOfSmallFactors) {
    EXPECT_EQ(fastFftSize(1), 1);
    EXPECT_EQ(fastFftSize(11), 12);
    EXPECT_EQ(fastFftSize(127), 128);
    EXPECT_EQ(fastFftSize(575), 576);
    // Few in each octave: windows that grow by a pixel mostly keep their plan.
    EXPECT_EQ(fastFftSize(321), 384);
    EXPECT_EQ(fastFftSize(384), 384);
}

} // namespace
} // namespace irsg
