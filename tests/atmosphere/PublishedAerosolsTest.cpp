#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/ParticleParts.h"
#include "tests/atmosphere/AerosolSupport.h"
#include "tests/support/SharedMaterial.h"

namespace irsg {
namespace {

using namespace aerosoltest;

struct LowtranPath {
    const char* name;
    double from_m, to_m, length_m; ///< along one altitude when from_m equals to_m
};
constexpr LowtranPath level{"5 km at the ground", 0, 0, 5000};
constexpr LowtranPath low{"slant 0 to 5 km", 0, 5000, 7071.07};
constexpr LowtranPath high{"slant 3 to 10 km", 3000, 10000, 14000};
constexpr LowtranPath zenith{"zenith", 0, 100000, 100000};

struct LowtranRow {
    const char* atmosphere;
    AerosolModel model;
    double visibility_km;
    const LowtranPath& path;
    std::array<double, 4> transmittance; ///< by aerosol at 10, 5, 2.5 and 2 um
    std::array<double, 4> absorptance;
};

using enum AerosolModel;

// clang-format off
/// Results of LOWTRAN 7 (20 cm-1, mean of a triangle) at wavelengths of its aerosol tables.
const LowtranRow lowtranRows[] = {
    {"us76", rural, 23, level, {0.9307, 0.9344, 0.9072, 0.8889}, {0.0312, 0.0105, 0.0159, 0.0149}},
    {"us76", rural, 5, level, {0.7047, 0.7184, 0.6220, 0.5632}, {0.1430, 0.0503, 0.0751, 0.0704}},
    {"us76", maritime, 23, level, {0.9172, 0.8261, 0.7199, 0.6719}, {0.0184, 0.0083, 0.0128, 0.0069}},
    {"tropical", rural, 23, level, {0.9322, 0.9298, 0.9036, 0.8829}, {0.0306, 0.0116, 0.0140, 0.0130}},
    {"tropical", rural, 5, level, {0.7103, 0.7015, 0.6103, 0.5449}, {0.1407, 0.0552, 0.0666, 0.0620}},
    {"tropical", maritime, 23, level, {0.8923, 0.7580, 0.6581, 0.6064}, {0.0380, 0.0220, 0.0133, 0.0088}},
    {"mlw", maritime, 23, level, {0.8855, 0.7419, 0.6443, 0.5931}, {0.0423, 0.0251, 0.0135, 0.0093}},
    {"us76", rural, 23, low, {0.9688, 0.9710, 0.9572, 0.9472}, {0.0145, 0.0049, 0.0074, 0.0069}},
    {"us76", rural, 5, low, {0.8690, 0.8760, 0.8258, 0.7923}, {0.0606, 0.0208, 0.0312, 0.0292}},
    {"us76", maritime, 23, low, {0.9626, 0.9207, 0.8670, 0.8402}, {0.0094, 0.0041, 0.0061, 0.0036}},
    {"us76", rural, 23, high, {0.9979, 0.9989, 0.9961, 0.9931}, {0.0019, 0.0007, 0.0011, 0.0010}},
    {"us76", rural, 23, zenith, {0.9772, 0.9787, 0.9686, 0.9606}, {0.0109, 0.0040, 0.0055, 0.0051}},
    {"us76", rural, 5, zenith, {0.9049, 0.9101, 0.8726, 0.8467}, {0.0439, 0.0152, 0.0224, 0.0209}},
    {"tropical", rural, 5, zenith, {0.9064, 0.9056, 0.8691, 0.8408}, {0.0433, 0.0163, 0.0204, 0.0190}},
    {"mlw", rural, 23, high, {0.9988, 0.9993, 0.9977, 0.9959}, {0.0012, 0.0004, 0.0006, 0.0006}},
    {"mlw", maritime, 23, zenith, {0.9705, 0.9330, 0.8940, 0.8719}, {0.0097, 0.0054, 0.0043, 0.0027}},
};
// clang-format on

TEST(PublishedAerosols, AgreeWithResultsOfLowtran7) {
    constexpr std::array<double, 4> wavelengths_um = {10.0, 5.0, 2.5, 2.0};
    double horizontal = 0.0;
    double slant = 0.0;
    for (const LowtranRow& row : lowtranRows) {
        ParticleSettings wanted = settings(row.model, 1e3 * row.visibility_km);
        wanted.winter = std::string(row.atmosphere) == "mlw";
        const auto layers = particleLayers(wanted, humidityOf(row.atmosphere));
        const std::string what = std::string(row.atmosphere) + ", visibility " +
                                 std::to_string(row.visibility_km) + " km, " + row.path.name + ", ";
        for (std::size_t i = 0; i < wavelengths_um.size(); ++i) {
            ParticleOptics tau;
            if (row.path.from_m == row.path.to_m) {
                tau = at(layers, row.path.from_m, wavelengths_um[i]);
                tau.extinction *= row.path.length_m;
                tau.absorption *= row.path.length_m;
            } else {
                tau = depth(layers, row.path.from_m, row.path.to_m, wavelengths_um[i]);
                tau.extinction *= row.path.length_m / (row.path.to_m - row.path.from_m);
                tau.absorption *= row.path.length_m / (row.path.to_m - row.path.from_m);
            }
            // LOWTRAN starts from its table, 0.3 % below Koschmieder at 23 km, reckons humidity by
            // a formula of its own, and takes all optics of a slant path at one mean humidity.
            const double tolerance = row.path.from_m == row.path.to_m ? 2.5e-3 : 5e-3;
            EXPECT_NEAR(std::exp(-tau.extinction), row.transmittance[i], tolerance)
                << what << wavelengths_um[i] << " um";
            EXPECT_NEAR(1.0 - std::exp(-tau.absorption), row.absorptance[i], 1e-3)
                << what << wavelengths_um[i] << " um";
            double& worst = row.path.from_m == row.path.to_m ? horizontal : slant;
            worst = std::max(worst, std::abs(std::exp(-tau.extinction) - row.transmittance[i]));
        }
    }
    RecordProperty("horizontal", std::to_string(horizontal));
    RecordProperty("slant", std::to_string(slant));
}

TEST(PublishedAerosols, AgreeWithTheAerosolColumnsOfModtran) {
    const auto file =
        smat::test::sharedMaterial("data/atmosphere/modtran/pyradi/horizon5kmtropical.fl7");
    if (file.empty()) {
        GTEST_SKIP() << "the MODTRAN outputs of the shared material are not here";
    }

    // Tropical air, rural aerosol of 23 km, 5 km at the ground. MODTRAN starts from the table's
    // 0.158 km-1 where Koschmieder says 0.1585: up to 1.2e-3 in transmittance.
    const auto layers = particleLayers(settings(AerosolModel::rural, 23e3), humidityOf("tropical"));
    std::ifstream stream(file);
    std::string line;
    for (int i = 0; i < 13; ++i) {
        std::getline(stream, line);
    }
    int count = 0;
    double worst = 0.0, square = 0.0;
    while (std::getline(stream, line)) {
        std::istringstream words(line);
        std::vector<double> row;
        for (double value; words >> value;) {
            row.push_back(value);
        }
        if (row.size() < 12) {
            continue;
        }
        const ParticleOptics tau = at(layers, 0.0, 1e4 / row[0]);
        const double transmittance = std::exp(-5000.0 * tau.extinction) - row[9];
        worst = std::max(worst, std::abs(transmittance));
        square += transmittance * transmittance;
        EXPECT_NEAR(transmittance, 0.0, 2e-3) << row[0] << " cm-1";
        const double absorption = std::exp(-5000.0 * tau.absorption) - row[11];
        EXPECT_NEAR(absorption, 0.0, row[0] < 10000.0 ? 2e-3 : 1.5e-2) << row[0] << " cm-1";
        ++count;
    }
    EXPECT_GT(count, 9000);
    EXPECT_LT(std::sqrt(square / count), 1.2e-3);
    RecordProperty("rms", std::to_string(std::sqrt(square / count)));
    RecordProperty("worst", std::to_string(worst));
}

TEST(PublishedAerosols, TheNavyAerosolAlbedoAndAsymmetryAreThoseOfModtran) {
    // MODTRAN 5.3: subarctic winter, air mass 3, wind 20 now and 8 m/s over 24 h, 80.46 %.
    const particles::WindAerosol navy = particles::navyMaritime(3, 20.0, 8.0, 0.8046);
    const ParticleLayer layer{"", {}, {}, navy.optics.wavelengths_um, navy.optics.values};
    const ParticleOptics green = layer.opticsAt(0.55);
    EXPECT_NEAR(1.0 - green.absorption / green.extinction, 0.999670, 2e-5);
    EXPECT_NEAR(green.asymmetry, 0.772073, 1e-3);
}

TEST(PublishedAerosols, TheAirAboveTheBoundaryLayerIsThatOfModtran) {
    // MODTRAN 5.3, autumn/winter, visibility 31 km: extinction at 0.55 um in km-1.
    ParticleSettings wanted = settings(AerosolModel::navyMaritime, 31e3);
    wanted.winter = true;
    const auto layers = particleLayers(wanted, dry);
    const std::vector<std::pair<double, double>> published = {
        {0, 0.1144},  {1, 0.07157},   {2, 0.04485},   {3, 0.01965},   {4, 0.009338},  {5, 0.00485},
        {8, 0.00141}, {10, 0.000787}, {11, 0.000714}, {20, 0.000423}, {30, 0.0000332}};
    for (const auto& [z_km, value] : published) {
        EXPECT_NEAR(extinction550At(layers, 1e3 * z_km) * 1e3 / value, 1.0, 5e-3) << z_km;
    }
}

} // namespace
} // namespace irsg
