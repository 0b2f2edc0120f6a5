// Apparent emissivities of diffuse grey isothermal cavities.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "irsg/radiometry/Units.h"
#include "tests/support/LightScenes.h"
#include "tests/support/RaysTest.h"
#include "tests/support/RevolvedMeshes.h"

using namespace irsg;
using namespace irsg::test;

namespace {

class CavitiesTest : public RaysTest {};

/// The cavity by zones (Siegel and Howell, Thermal Radiation Heat Transfer, ch. 6): bands around
/// the axis of constant radiosity, whose view factors follow from those between the discs at their
/// edges, which see each other whole in a cavity that is convex inside.
class Zones {
  public:
    Zones(const Profile& profile, double emissivity) : profile_(profile) {
        const std::size_t bands = profile.size() - 1;
        std::vector<double> area(bands), factor(bands * bands);
        for (std::size_t i = 0; i < bands; ++i) {
            const double dr = profile[i + 1][0] - profile[i][0];
            const double dz = profile[i + 1][1] - profile[i][1];
            area[i] = pi * (profile[i][0] + profile[i + 1][0]) * std::hypot(dr, dz);
        }
        for (std::size_t i = 0; i < bands; ++i) {
            double others = 0.0;
            for (std::size_t j = 0; j < bands; ++j) {
                if (i == j) {
                    continue;
                }
                const std::size_t low = std::min(i, j), high = std::max(i, j);
                const double exchanged = discs(low + 1, high) - discs(low, high) -
                                         discs(low + 1, high + 1) + discs(low, high + 1);
                factor[i * bands + j] = exchanged / area[i];
                others += exchanged / area[i];
            }
            // What is left of all: the opening and the band itself.
            const double out = (discs(i + 1, bands) - discs(i, bands)) / area[i];
            factor[i * bands + i] = 1.0 - others - out;
        }
        radiosity_.assign(bands, 1.0);
        for (int step = 0; step < 300; ++step) {
            for (std::size_t i = 0; i < bands; ++i) {
                double sum = 0.0;
                for (std::size_t j = 0; j < bands; ++j) {
                    sum += factor[i * bands + j] * radiosity_[j];
                }
                radiosity_[i] = emissivity + (1.0 - emissivity) * sum;
            }
        }
    }
    /// Of what is seen from far away on the axis.
    double normal() const {
        double sum = 0.0, area = 0.0;
        for (std::size_t i = 0; i < radiosity_.size(); ++i) {
            const double seen = std::pow(profile_[i + 1][0], 2) - std::pow(profile_[i][0], 2);
            sum += seen * radiosity_[i];
            area += seen;
        }
        return sum / area;
    }

    /// Of the last band, at the rim.
    double atRim() const { return radiosity_.back(); }

  private:
    /// Area times view factor between two discs (Howell, A Catalog of Radiation Heat Transfer
    /// Configuration Factors, C-41).
    double discs(std::size_t i, std::size_t j) const {
        const double a = profile_[i][0], b = profile_[j][0], h = profile_[j][1] - profile_[i][1];
        const double sum = a * a + b * b + h * h;
        // That is pi / 2 (sum - root), without its cancellation.
        const double root = std::sqrt(std::max(sum * sum - 4.0 * a * a * b * b, 0.0));
        return sum + root > 0.0 ? 2.0 * pi * a * a * b * b / (sum + root) : 0.0;
    }

    Profile profile_;
    std::vector<double> radiosity_;
};

constexpr std::array<double, 3> emissivities{0.5, 0.7, 0.9};

/// Intensities on the axis from afar, as parts of that of black walls.
std::array<double, 3> normalEmissivities(const Triangles& mesh) {
    const std::shared_ptr<const Model> model = modelOf(oneSided(mesh));
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = Environment::vacuum();
    irsg.view.sensor = sensorOf(32, 32, 0.3);
    const auto intensity = [&](double emissivity, int bounces) {
        Entity entity = entityOf(model, greyDatabase(emissivity, 500.0));
        entity.pose.position_m.z = standingAltitude_m;
        entity.referencePoint_m = Vec3{};
        irsg.scene.settings = lightSettings(bounces);
        irsg.scene.entities = {entity};
        const Vec3 at{0, 0, standingAltitude_m};
        irsg.view.viewpoint = Viewpoint::lookAt(at + Vec3{0, 0, 1000}, at, {0, 1, 0}, {0, 1, 0});
        return irsg.measure().all.intensity_W_sr;
    };
    const double black = intensity(1.0, 0);
    std::array<double, 3> all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i] = intensity(emissivities[i], convergedBounces) / black;
    }
    return all;
}

void expectEmissivity(const std::string& name, double found, double expected) {
    std::printf("  %-36s %.5f, expected %.5f: %+.3f %%\n", name.c_str(), found, expected,
                100 * (found / expected - 1));
    EXPECT_NEAR(found / expected, 1.0, 2e-3) << name;
}

std::string nameOf(const char* kind, double size, double emissivity) {
    char text[64];
    std::snprintf(text, sizeof text, "%s %g, emissivity %g", kind, size, emissivity);
    return text;
}

Profile joinedProfiles(Profile a, const Profile& b) {
    a.insert(a.end(), b.begin() + 1, b.end());
    return a;
}

const IrCodes code{1, 1};
} // namespace

TEST_F(CavitiesTest, CylindersHaveTheApparentEmissivityOfTheirZones) {
    for (const double depth : {1.0, 4.0}) {
        const std::array<double, 3> found =
            normalEmissivities(joined(revolved(line(0, 0, 1, 0, 12), 96, code),
                                      revolved(line(1, 0, 1, depth, 16), 96, code)));
        for (std::size_t i = 0; i < found.size(); ++i) {
            const Zones zones(joinedProfiles(line(0, 0, 1, 0, 150), line(1, 0, 1, depth, 250)),
                              emissivities[i]);
            expectEmissivity(nameOf("cylinder, depth / radius", depth, emissivities[i]), found[i],
                             zones.normal());
        }
    }
}

TEST_F(CavitiesTest, ConesHaveTheApparentEmissivityOfTheirZones) {
    for (const double halfAngle_deg : {20.0, 45.0}) {
        const double depth = 1.0 / std::tan(radians(halfAngle_deg));
        const std::array<double, 3> found =
            normalEmissivities(revolved(line(0, 0, 1, depth, 32), 96, code));
        for (std::size_t i = 0; i < found.size(); ++i) {
            expectEmissivity(nameOf("cone, half angle", halfAngle_deg, emissivities[i]), found[i],
                             Zones(line(0, 0, 1, depth, 400), emissivities[i]).normal());
        }
    }
}

// Sparrow and Jonsson 1962, "Absorption and emission characteristics of diffuse spherical
// enclosures": with an opening of half angle phi, seen from the centre, the wall takes
// (1 + cos phi) / 2 of the sphere, and every place of it sees as much of it. From the front faces,
// through those of the shoulder that are seen from behind, all of the wall is seen.
TEST_F(CavitiesTest, SpheresHaveTheApparentEmissivityOfSparrowAndJonsson) {
    for (const double opening_deg : {30.0, 60.0}) {
        const double wall = 0.5 * (1.0 + std::cos(radians(opening_deg)));
        const std::array<double, 3> found =
            normalEmissivities(revolved(arc(1, 0, 0, pi - radians(opening_deg), 48), 96, code));
        for (std::size_t i = 0; i < found.size(); ++i) {
            expectEmissivity(nameOf("sphere, opening", opening_deg, emissivities[i]), found[i],
                             emissivities[i] / (1.0 - (1.0 - emissivities[i]) * wall));
        }
    }
}

// The zones themselves: half as wide they are off by less than half as much.
TEST(ZonesOfCavitiesTest, AreStableAndConverge) {
    const auto coneOf = [](int bands) { return Zones(line(0, 0, 1, 3, bands), 0.5).normal(); };
    const double coarse = coneOf(100), fine = coneOf(200), finest = coneOf(400);
    EXPECT_LT(std::abs(finest - fine), 0.5 * std::abs(fine - coarse));
    EXPECT_LT(std::abs(finest - fine), 2e-4);
}

// Buckley 1927, "On the radiation from the inside of a circular cylinder" (Phil. Mag. 4, 753-762):
// the rim of a cylinder without end has the root of the wall's emissivity.
TEST(ZonesOfCavitiesTest, HaveTheRimOfBuckleysCylinder) {
    Profile profile = line(0, 0, 1, 0, 40);
    constexpr int bands = 200;
    for (int i = 1; i <= bands; ++i) { // close together at the rim
        const double left = 1.0 - static_cast<double>(i) / bands;
        profile.push_back({1.0, 40.0 * (1.0 - left * left * left)});
    }
    for (const double emissivity : emissivities) {
        EXPECT_NEAR(Zones(profile, emissivity).atRim() / std::sqrt(emissivity), 1.0, 5e-5);
    }
}
