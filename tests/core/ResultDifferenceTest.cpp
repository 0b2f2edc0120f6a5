#include "smatcore/data/ResultDifference.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

namespace smat {
namespace {

using irsg::Quantity;
using testing::HasSubstr;

ResultTable over(Quantity axis, const std::vector<double>& x, const std::vector<double>& y,
                 Quantity measured = Quantity::contrastIntensity) {
    ResultTable table;
    table.add(axis);
    table.add(measured);
    for (std::size_t i = 0; i < x.size(); ++i) {
        table.addRow({x[i], y[i]});
    }
    return table;
}

ResultTable polar(double step_deg, double level, const std::string& type) {
    ResultTable table;
    table.provenance.add("analysis", "polar");
    table.provenance.add("polar.type", type);
    table.add(Quantity::angle);
    table.add(Quantity::azimuth);
    table.add(Quantity::contrastIntensity);
    for (double angle = 0.0; angle < 360.0; angle += step_deg) {
        table.addRow({angle, angle, level + angle});
    }
    return table;
}

std::string refusal(const ResultTable& a, const ResultTable& b) {
    try {
        differenceOf({"first", &a}, {"second", &b});
    } catch (const irsg::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(ResultDifferenceTest, ADifferenceWarnsOfWhatEitherSideDoesThere) {
    auto a = over(Quantity::range, {0.0, 10.0}, {0.0, 20.0});
    auto b = over(Quantity::range, {5.0, 8.0, 20.0}, {6.0, 9.0, 21.0});
    EXPECT_TRUE(differenceOf({"a", &a}, {"b", &b}).warnings().empty());
    a.setWarning(1, "far");
    b.setWarning(0, "cut");
    EXPECT_THAT(differenceOf({"a", &a}, {"b", &b}).warnings(),
                testing::ElementsAre("a: far; b: cut", "a: far", "a: far"));
    // The last row of a turn goes on with its first.
    auto first = polar(90.0, 1.0, "camera-azimuth"), second = polar(45.0, 1.0, "camera-azimuth");
    first.setWarning(0, "cut");
    EXPECT_THAT(differenceOf({"a", &first}, {"b", &second}).warnings(),
                testing::ElementsAre("a: cut", "a: cut", "", "", "", "", "", "a: cut"));
}

TEST(ResultDifferenceTest, SubtractsLinesExactlyOnTheNodesOfBoth) {
    // 2 x on [0, 10] minus x + 1 on [5, 20]: x - 1 on [5, 10].
    const auto a = over(Quantity::range, {0.0, 10.0}, {0.0, 20.0});
    const auto b = over(Quantity::range, {5.0, 8.0, 20.0}, {6.0, 9.0, 21.0});
    const ResultTable difference = differenceOf({"a", &a}, {"b", &b});
    EXPECT_THAT(difference.columns()[0].values, testing::ElementsAre(5.0, 8.0, 10.0));
    EXPECT_THAT(difference.find("difference_contrast_intensity")->values,
                testing::ElementsAre(testing::DoubleEq(4.0), testing::DoubleEq(7.0),
                                     testing::DoubleEq(9.0)));
    const auto* relative = difference.find("relative_difference_contrast_intensity");
    EXPECT_EQ(relative->unit, "%");
    EXPECT_DOUBLE_EQ(relative->values[1], 100.0 * 7.0 / 9.0);
    EXPECT_EQ(relative->axisTitle(), "Relative difference of contrast intensity (%)");
}

TEST(ResultDifferenceTest, OfAResultWithItselfIsZero) {
    const auto a = over(Quantity::time, {0.0, 1.0, 4.0}, {3.0, -2.0, 0.0});
    const ResultTable difference = differenceOf({"a", &a}, {"a", &a});
    EXPECT_THAT(difference.find("difference_contrast_intensity")->values, testing::Each(0.0));
    // Nothing is relative to 0.
    EXPECT_TRUE(std::isnan(difference.find("relative_difference_contrast_intensity")->values[2]));
}

TEST(ResultDifferenceTest, ChangesItsSignWithTheOrder) {
    const auto a = over(Quantity::range, {1.0, 2.0}, {5.0, 9.0});
    const auto b = over(Quantity::range, {1.0, 3.0}, {4.0, 4.0});
    const auto forth = differenceOf({"a", &a}, {"b", &b});
    const auto back = differenceOf({"b", &b}, {"a", &a});
    for (std::size_t i = 0; i < forth.rowCount(); ++i) {
        EXPECT_DOUBLE_EQ(forth.columns()[1].values[i], -back.columns()[1].values[i]) << i;
    }
}

TEST(ResultDifferenceTest, TakesSpectraThatDescendInWavelength) {
    ResultTable a, b;
    for (ResultTable* table : {&a, &b}) {
        table->add(Quantity::wavenumber);
        table->add(Quantity::wavelength);
        table->add(Quantity::spectralIntensity);
        const double level = table == &a ? 3.0 : 1.0;
        for (const double wavenumber : {2000.0, 2500.0, 3200.0}) {
            table->addRow({wavenumber, 1e4 / wavenumber, level * wavenumber});
        }
    }
    const auto difference = differenceOf({"a", &a}, {"b", &b});
    EXPECT_EQ(difference.columns()[0].key, "wavelength");
    EXPECT_THAT(difference.columns()[1].values,
                testing::ElementsAre(testing::DoubleEq(6400.0), testing::DoubleEq(5000.0),
                                     testing::DoubleEq(4000.0)));
}

TEST(ResultDifferenceTest, GoesRoundAPolarPlotOfAnotherStep) {
    const auto coarse = polar(10.0, 100.0, "model-yaw");
    const auto fine = polar(5.0, 50.0, "model-yaw");
    const auto difference = differenceOf({"coarse", &coarse}, {"fine", &fine});
    EXPECT_EQ(difference.rowCount(), 72U);
    EXPECT_EQ(polarTypeOf(difference), "model-yaw");
    // Between 350 and 360 degrees the coarse one goes back to its first sample.
    const auto* column = difference.find("difference_contrast_intensity");
    EXPECT_DOUBLE_EQ(column->values.back(), (450.0 + 100.0) / 2.0 - 405.0);
    EXPECT_DOUBLE_EQ(column->values[3], 50.0);
}

TEST(ResultDifferenceTest, LeavesAGapBesideAMissingSample) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const auto a = over(Quantity::range, {1.0, 2.0, 3.0, 4.0}, {1.0, none, 1.0, 1.0});
    const auto b = over(Quantity::range, {1.0, 1.5, 3.5, 4.0}, {0.0, 0.0, 0.0, 0.0});
    const auto difference = differenceOf({"a", &a}, {"b", &b});
    const auto& values = difference.columns()[1].values;
    EXPECT_EQ(values[0], 1.0);
    EXPECT_TRUE(std::isnan(values[1]));
    EXPECT_TRUE(std::isnan(values[2]));
    EXPECT_EQ(values[4], 1.0);
}

TEST(ResultDifferenceTest, KeepsTheProvenanceOfBoth) {
    const auto a = polar(90.0, 1.0, "model-yaw");
    const auto difference = differenceOf({"day", &a}, {"night", &a});
    EXPECT_EQ(difference.provenance.value("name"), "day - night");
    EXPECT_EQ(difference.provenance.value("b"), "night");
    EXPECT_EQ(difference.provenance.value("a.analysis"), "polar");
}

TEST(ResultDifferenceTest, RefusesWhatDoesNotFitInOneSentence) {
    const auto range = over(Quantity::range, {1.0, 2.0}, {1.0, 2.0});
    const auto time = over(Quantity::time, {1.0, 2.0}, {1.0, 2.0});
    const auto far = over(Quantity::range, {5.0, 9.0}, {1.0, 2.0});
    const auto back = over(Quantity::range, {1.0, 3.0, 2.0}, {1.0, 2.0, 3.0});
    const auto other = over(Quantity::range, {1.0, 2.0}, {1.0, 2.0}, Quantity::irradiance);
    const auto yaw = polar(30.0, 1.0, "model-yaw");
    const auto azimuth = polar(30.0, 1.0, "camera-azimuth");
    EXPECT_THAT(refusal(range, time), HasSubstr("expected range [m], as in first"));
    EXPECT_THAT(refusal(range, far), HasSubstr("an overlap with first, 1 to 2 m"));
    EXPECT_THAT(refusal(range, back), HasSubstr("turns back"));
    EXPECT_THAT(refusal(range, other), HasSubstr("irradiance [W m-2]"));
    EXPECT_THAT(refusal(yaw, azimuth), HasSubstr("camera-azimuth"));
    EXPECT_THAT(refusal(range, ResultTable()), HasSubstr("without columns"));
}

} // namespace
} // namespace smat
