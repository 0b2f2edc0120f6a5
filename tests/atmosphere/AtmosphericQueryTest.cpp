#include "irsg/atmosphere/path/AtmosphericQuery.h"

#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "irsg/radiometry/Units.h"

using namespace irsg;

namespace {

const AtmosphericPath path{100.0, 2000.0, 5000.0, 0.25};
const SunPosition sun{1.0, 0.5};

} // namespace

TEST(AtmosphericQuery, KeysDifferInWhateverTheAnswerDependsOn) {
    std::set<AtmosphericQueryKey> keys;
    const auto isNew = [&](const AtmosphericQuery& query) {
        return keys.insert(query.key(true)).second;
    };
    EXPECT_TRUE(isNew(AtmosphericQuery::transmittance(path)));
    EXPECT_TRUE(isNew(AtmosphericQuery::scatteringOpticalDepth(path)));
    EXPECT_TRUE(isNew(AtmosphericQuery::transmittance({2000.0, 100.0, 5000.0})));
    EXPECT_TRUE(isNew(AtmosphericQuery::transmittance({100.0, 2000.0, 5001.0})));
    EXPECT_TRUE(isNew(AtmosphericQuery::pathRadiance(path, sun)));
    EXPECT_TRUE(isNew(AtmosphericQuery::pathRadiance(path, {1.0, 0.6})));
    EXPECT_TRUE(isNew(AtmosphericQuery::pathRadiance(path, {1.1, 0.5})));
    EXPECT_TRUE(isNew(AtmosphericQuery::pathRadiance(path, {1.0, 0.5, 0.99})));
    EXPECT_TRUE(isNew(AtmosphericQuery::backgroundRadiance({100.0, 0.1, 0.0}, sun)));
    EXPECT_TRUE(isNew(AtmosphericQuery::backgroundRadiance({100.0, 0.2, 0.0}, sun)));
    EXPECT_TRUE(isNew(AtmosphericQuery::backgroundRadiance({100.0, 0.2, 0.3}, sun)));
    EXPECT_TRUE(isNew(AtmosphericQuery::solarIrradiance(100.0, sun)));
    EXPECT_TRUE(isNew(AtmosphericQuery::upwardFlux(100.0, sun)));
    EXPECT_TRUE(isNew(AtmosphericQuery::downwardFlux(100.0, sun)));
    EXPECT_TRUE(isNew(AtmosphericQuery::downwardFlux(101.0, sun)));
    EXPECT_FALSE(isNew(AtmosphericQuery::pathRadiance(path, sun)));
}

TEST(AtmosphericQuery, KeysHoldNothingElse) {
    AtmosphericPath turned = path;
    turned.azimuth_rad = 2.0;
    // Transmittance knows no sun and no azimuth, even if it is told.
    AtmosphericQuery query = AtmosphericQuery::transmittance(path);
    query.sun = {2.0, -0.4};
    query.altitude_m = 77.0;
    EXPECT_EQ(query.key(true), AtmosphericQuery::transmittance(turned).key(true));
    // A path radiance that does not depend on the azimuth has the same key all around.
    EXPECT_EQ(AtmosphericQuery::pathRadiance(path, sun).key(false),
              AtmosphericQuery::pathRadiance(turned, {2.5, sun.elevation_rad}).key(false));
    EXPECT_NE(AtmosphericQuery::pathRadiance(path, sun).key(true),
              AtmosphericQuery::pathRadiance(turned, sun).key(true));
    EXPECT_EQ(AtmosphericQuery::solarIrradiance(5.0, {0.0, 0.5}).key(true),
              AtmosphericQuery::solarIrradiance(5.0, {3.0, 0.5}).key(true));
}

TEST(AtmosphericQuery, TheAzimuthCountsFromTheSunOnEitherSide) {
    const auto away_rad = [](double view_rad, double sun_rad) {
        AtmosphericPath turned = path;
        turned.azimuth_rad = view_rad;
        return AtmosphericQuery::pathRadiance(turned, {sun_rad, 0.5}).azimuthFromSun_rad();
    };
    EXPECT_DOUBLE_EQ(away_rad(0.25, 1.0), 0.75);
    EXPECT_DOUBLE_EQ(away_rad(1.0, 0.25), 0.75);
    EXPECT_NEAR(away_rad(radians(350.0), radians(10.0)), radians(20.0), 1e-15);
    EXPECT_NEAR(away_rad(radians(-170.0), radians(170.0)), radians(20.0), 1e-15);
    EXPECT_DOUBLE_EQ(away_rad(pi, 0.0), pi);
    EXPECT_EQ(AtmosphericQuery::upwardFlux(0.0, {2.0, 0.5}).azimuthFromSun_rad(), 0.0);
}

TEST(AtmosphereProperty, HasOneKindOfPlace) {
    std::map<QueryGeometry, int> counts;
    for (const AtmosphereProperty property : allAtmosphereProperties) {
        ++counts[geometryOf(property)];
    }
    EXPECT_EQ(counts[QueryGeometry::path], 3);
    EXPECT_EQ(counts[QueryGeometry::sight], 1);
    EXPECT_EQ(counts[QueryGeometry::altitude], 4);
}
