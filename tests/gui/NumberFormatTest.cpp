#include "gui/widgets/NumberFormat.h"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

namespace smat::gui {
namespace {

TEST(NumberFormat, RaisesThePowersOfUnits) {
    EXPECT_EQ(formattedUnit("W m-2 sr-1"), "W·m⁻²·sr⁻¹");
    EXPECT_EQ(formattedUnit("W cm-2 sr-1 (cm-1)-1"), "W·cm⁻²·sr⁻¹·(cm⁻¹)⁻¹");
    EXPECT_EQ(formattedUnit("uW cm-2"), "uW·cm⁻²");
}

TEST(NumberFormat, LeavesOtherWordsAsTheyAre) {
    for (const char* word : {"", "counts", "DN8", "a x-y", "digital number 12", "W/sr"}) {
        EXPECT_EQ(formattedUnit(word), word);
    }
}

TEST(NumberFormat, RoundsToTheDigitsThatOneReads) {
    const std::pair<double, const char*> rows[] = {{185065.0, "185100"},     {86366.5, "86370"},
                                                   {1.43419, "1.434"},       {0.854857, "0.8549"},
                                                   {-79.6394, "-79.64"},     {0.00012, "0.00012"},
                                                   {1.2346e-7, "1.235e-07"}, {6543210.0, "6543000"},
                                                   {2.5e9, "2.5e+09"},       {0.0, "0"},
                                                   {9999.9, "10000"}};
    for (const auto& [value, words] : rows) {
        EXPECT_EQ(sentenceNumber(value), words);
    }
    EXPECT_EQ(sentenceNumber(123.456, 2), "120");
    EXPECT_EQ(sentenceNumber(std::nan("")), "no value");
}

} // namespace
} // namespace smat::gui
