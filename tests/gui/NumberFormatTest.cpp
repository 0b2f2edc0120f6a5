#include "gui/widgets/NumberFormat.h"

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

} // namespace
} // namespace smat::gui
