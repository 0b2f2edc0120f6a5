#include "irsg/image/Histogram.h"

#include <numeric>

#include <gtest/gtest.h>

#include "tests/image/ImageFixtures.h"

namespace irsg {
namespace {

using test::infinity;
using test::nanValue;

RadianceImage rowOf(std::vector<float> values) {
    RadianceImage image(static_cast<int>(values.size()), 1);
    image.primary().values = std::move(values);
    return image;
}

std::vector<std::size_t> countsOf(const Histogram& histogram) {
    return histogram.counts;
}

TEST(Histogram, CountsEveryPixelOnceTheLastEdgeIncluded) {
    const RadianceImage image = rowOf({0.0F, 0.5F, 1.0F, 1.5F, 2.0F, 4.0F, 4.0F});
    const Histogram histogram = imageHistogram(image, image.primary(), 4);
    EXPECT_EQ(countsOf(histogram), (std::vector<std::size_t>{2, 2, 1, 2}));
    EXPECT_EQ(histogram.edges, (std::vector<double>{0.0, 1.0, 2.0, 3.0, 4.0}));
}

TEST(Histogram, KeepsWhatHasNoPlaceApart) {
    const RadianceImage image =
        rowOf({nanValue, infinity, -infinity, -1.0F, 0.0F, 1.0F, 10.0F, 100.0F, 50.0F});
    const Histogram linear = imageHistogram(image, image.primary(), 10);
    EXPECT_EQ(linear.nan, 1u);
    EXPECT_EQ(linear.below, 1u);
    EXPECT_EQ(linear.above, 1u);
    const Histogram logarithmic = imageHistogram(image, image.primary(), 2, true);
    EXPECT_EQ(logarithmic.below, 3u);
    EXPECT_NEAR(logarithmic.edges[1], 10.0, 1e-9);
    EXPECT_EQ(logarithmic.edges.back(), 100.0);
    EXPECT_EQ(countsOf(logarithmic), (std::vector<std::size_t>{1, 3}));
}

TEST(Histogram, EveryFiniteValueIsInTheBinWhoseEdgesHoldIt) {
    RadianceImage image(101, 7);
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        image.primary().values[i] = 0.1F * static_cast<float>(i % 97) - 3.0F;
    }
    const Histogram histogram = imageHistogram(image, image.primary(), 37);
    std::vector<std::size_t> expected(37, 0);
    for (const float value : image.primary().values) {
        std::size_t bin = 0;
        while (bin + 1 < expected.size() && value >= histogram.edges[bin + 1]) {
            ++bin;
        }
        ++expected[bin];
    }
    EXPECT_EQ(histogram.counts, expected);
}

TEST(Histogram, LivesWithOneValueWithNoneAndWithARectangle) {
    const RadianceImage constant = rowOf({5.0F, 5.0F, 5.0F});
    const Histogram one = imageHistogram(constant, constant.primary(), 5);
    EXPECT_EQ(std::accumulate(one.counts.begin(), one.counts.end(), std::size_t{0}), 3u);
    const RadianceImage nothing = rowOf({nanValue, nanValue});
    EXPECT_EQ(imageHistogram(nothing, nothing.primary(), 5, true).nan, 2u);
    EXPECT_EQ(imageHistogram(constant, constant.primary(), 3, false, PixelRectangle{1, 0, 2, 1})
                  .counts[1],
              2u);
    EXPECT_THROW(imageHistogram(constant, constant.primary(), 3, false, PixelRectangle{2, 0, 2, 1}),
                 InputError);
    EXPECT_THROW(imageHistogram(constant, constant.primary(), 0), LogicError);
}

} // namespace
} // namespace irsg
