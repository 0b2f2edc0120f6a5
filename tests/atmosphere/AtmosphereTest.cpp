#include "irsg/atmosphere/Atmosphere.h"

#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

using namespace irsg;

namespace {

/// Supports nothing, over 3 to 5 um.
class Nothing : public Atmosphere {
  public:
    std::string name() const override { return "nothing"; }
    SpectralRange base() const override { return {3.0, 5.0}; }
    bool supports(AtmosphereProperty property) const override {
        return property == AtmosphereProperty::transmittance;
    }
};

const SpectralRange mwir{3.0, 5.0};

} // namespace

TEST(Atmosphere, AcceptsWhatItSupportsIfTheBaseHoldsTheWholeRange) {
    const Nothing air;
    EXPECT_TRUE(air.accept({3.0, 5.0}, AtmosphereProperty::transmittance));
    EXPECT_TRUE(air.accept({3.5, 4.5}, AtmosphereProperty::transmittance));
    EXPECT_FALSE(air.accept({2.999, 5.0}, AtmosphereProperty::transmittance));
    EXPECT_FALSE(air.accept({3.0, 5.001}, AtmosphereProperty::transmittance));
    EXPECT_FALSE(air.accept({3.0, 5.0}, AtmosphereProperty::pathRadiance));
}

TEST(Atmosphere, BeingAskedForWhatIsNotSupportedIsOurFault) {
    const Nothing air;
    const SunPosition sun;
    EXPECT_THROW((void)air.transmittance({}, mwir), LogicError);
    EXPECT_THROW((void)air.pathRadiance({}, sun, mwir), LogicError);
    EXPECT_THROW((void)air.backgroundRadiance({}, sun, mwir), LogicError);
    EXPECT_THROW((void)air.solarIrradiance(0.0, sun, mwir), LogicError);
    EXPECT_THROW((void)air.upwardFlux(0.0, sun, mwir), LogicError);
    EXPECT_THROW((void)air.downwardFlux(0.0, sun, mwir), LogicError);
    try {
        (void)air.ambientTemperature_K(0.0);
        FAIL() << "answered";
    } catch (const LogicError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("nothing"));
        EXPECT_THAT(error.what(), testing::HasSubstr("ambient temperature"));
    }
}

TEST(Atmosphere, EveryPropertyHasANameOfItsOwn) {
    std::set<std::string> names;
    for (const AtmosphereProperty property : allAtmosphereProperties) {
        EXPECT_TRUE(names.insert(name(property)).second);
    }
    EXPECT_EQ(names.size(), std::size(allAtmosphereProperties));
}

TEST(SunPosition, IsUpAboveTheHorizonOnly) {
    EXPECT_TRUE((SunPosition{0.0, 1e-6}).isUp());
    EXPECT_FALSE((SunPosition{0.0, 0.0}).isUp());
    EXPECT_FALSE((SunPosition{0.0, -0.1}).isUp());
}
