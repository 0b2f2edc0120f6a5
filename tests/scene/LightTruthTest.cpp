// Inter-reflection of hard surfaces against the path tracer of tests/support, on bodies that are
// turned, scaled, cut and taken apart at random. bench_exchange prints all of them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "tests/support/ExchangeCase.h"
#include "tests/support/RaysTest.h"

using namespace irsg;
using namespace irsg::test;

namespace {

class LightTruthTest : public RaysTest {};

std::string titleOf(const ExchangeCase& one) {
    return one.name + ", " + one.variant;
}

/// How far the total may be off, as a part of the truth, of the cases that the library is right on.
const std::map<std::string, double> tolerances{
    {"corner, sun, 45°", 5e-3},
    {"walls, sun, 90°", 3e-3},
    {"walls, sun, 270°", 4e-3},
    {"edge, from behind", 3e-3},
    {"tube, L/D 1, emissivity 0.3", 2e-3},
    {"cone, of 20°, emissivity 0.3", 2e-3},
    {"cone, of 20°, emissivity 0.7", 1.5e-3},
    {"lip, 1 cm2, 1500 K", 4e-3},
    {"box, 600 K over a plate", 3e-3},
    {"box, 600 K over a plate, low", 3e-3},
    {"ball, sun, one entity", 3e-3},
    {"ball, sun, two entities", 3e-3},
    {"sheets, 5e-05 m apart", 1e-3},
    {"sheets, 0.001 m apart", 1e-3},
};

struct Measured {
    double value = 0.0;
    double error = 0.0; ///< as it is stated
};

Measured measured(const ExchangeCase& one) {
    const ObjectRadiometry all =
        Renderer{}
            .render(sceneOf(one), viewOf(one), Outputs::reports().withErrors())
            .reports.front()
            .all;
    return {all.intensity_W_sr, all.errors->intensity_W_sr.sum()};
}

/// What a number of a varied body is divided by.
double unitOf(const VariedCase& other) {
    return other.body.place_m ? 1.0 : other.scale * other.scale;
}

} // namespace

TEST_F(LightTruthTest, HardSurfacesAreThoseOfThePathTracer) {
    std::size_t checked = 0;
    for (const NamedCases& named : hardSurfaces()) {
        for (const ExchangeCase& one : named.make()) {
            const auto tolerance = tolerances.find(titleOf(one));
            if (tolerance == tolerances.end()) {
                continue;
            }
            ++checked;
            const TracedLight truth = truthOf(one, {.relativeError = 1e-3});
            for (unsigned seed = 0; seed < 3; ++seed) {
                const VariedCase other =
                    seed == 0 ? VariedCase{one, 1.0, "as it is"} : varied(one, seed);
                const Measured found = measured(other.body);
                const double value = found.value / unitOf(other);
                const double stated = found.error / unitOf(other);
                std::printf("  %s, %s: %.6g, truth %.6g: %+.3f %%, stated %.3f %%\n",
                            titleOf(one).c_str(), other.how.c_str(), value, truth.total.value,
                            100.0 * (value / truth.total.value - 1.0),
                            100.0 * stated / truth.total.value);
                EXPECT_NEAR(value, truth.total.value,
                            tolerance->second * truth.total.value + 2.0 * truth.total.error)
                    << titleOf(one) << ", " << other.how;
                EXPECT_NEAR(value, truth.total.value, stated + 2.0 * truth.total.error)
                    << titleOf(one) << ", " << other.how;
            }
        }
    }
    EXPECT_EQ(checked, tolerances.size());
}

TEST_F(LightTruthTest, TheTruthTurnsWithTheBody) {
    for (const NamedCases& named : hardSurfaces()) {
        for (const ExchangeCase& one : named.make()) {
            const TracedLight truth = truthOf(one, {.relativeError = 1e-3});
            const VariedCase other = varied(one, 7);
            const TracedLight there = truthOf(other.body, {.relativeError = 1e-3});
            // The viewer is not as far away in terms of the body.
            EXPECT_NEAR(there.total.value / unitOf(other), truth.total.value,
                        4.0 * std::hypot(truth.total.error, there.total.error / unitOf(other)) +
                            1e-3 * truth.total.value)
                << titleOf(one) << ", " << other.how;
        }
    }
}

TEST_F(LightTruthTest, TheTruthIsThatOfClosedForms) {
    int known = 0;
    for (const NamedCases& named : hardSurfaces()) {
        for (const ExchangeCase& one : named.make()) {
            if (!one.closedForm) {
                continue;
            }
            ++known;
            const TracedLight truth = truthOf(one, {.relativeError = 3e-4});
            EXPECT_NEAR(truth.total.value, *one.closedForm,
                        4.0 * truth.total.error + 5e-4 * *one.closedForm)
                << titleOf(one);
        }
    }
    EXPECT_GE(known, 8);
}
