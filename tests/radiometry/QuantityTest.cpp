#include "irsg/core/Quantity.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

using namespace irsg;

TEST(Quantity, HeadersCarryTheUnitWhereThereIsOne) {
    EXPECT_EQ(columnHeader(Quantity::contrastIntensity), "contrast_intensity [W sr-1]");
    EXPECT_EQ(columnHeader(Quantity::wavelength), "wavelength [um]");
    EXPECT_EQ(columnHeader(Quantity::angle), "angle [deg]");
    EXPECT_EQ(columnHeader(Quantity::totalIrradiance), "irradiance_total [W m-2]");
    EXPECT_EQ(columnHeader(Quantity::pixels), "pixels");
}

TEST(Quantity, TitlesCarryTheUnitAsPlotsWriteIt) {
    EXPECT_EQ(axisTitle(Quantity::contrastIntensity), "Contrast intensity (W·sr⁻¹)");
    EXPECT_EQ(axisTitle(Quantity::transmittance), "Transmittance");
}

TEST(Quantity, EveryOneHasAKeyOfItsOwnAndALabel) {
    std::set<std::string_view> keys;
    for (int i = 0; i <= static_cast<int>(Quantity::dimensionless); ++i) {
        const QuantityInfo& entry = info(static_cast<Quantity>(i));
        EXPECT_TRUE(keys.insert(entry.key).second) << entry.key;
        EXPECT_FALSE(entry.label.empty());
        EXPECT_EQ(entry.unit.empty(), entry.prettyUnit.empty());
    }
    EXPECT_THROW((void)info(static_cast<Quantity>(1000)), LogicError);
}
