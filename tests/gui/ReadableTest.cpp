#include "gui/widgets/Readable.h"

#include <gtest/gtest.h>

namespace smat::gui {
namespace {

TEST(Readable, RaisesThePowersOfUnits) {
    EXPECT_EQ(readableUnit("W m-2 sr-1"), "W·m⁻²·sr⁻¹");
    EXPECT_EQ(readableUnit("W cm-2 sr-1 (cm-1)-1"), "W·cm⁻²·sr⁻¹·(cm⁻¹)⁻¹");
    EXPECT_EQ(readableUnit("uW cm-2"), "uW·cm⁻²");
}

TEST(Readable, LeavesOtherWordsAsTheyAre) {
    for (const char* word : {"", "counts", "DN8", "a x-y", "digital number 12", "W/sr"}) {
        EXPECT_EQ(readableUnit(word), word);
    }
}

} // namespace
} // namespace smat::gui
