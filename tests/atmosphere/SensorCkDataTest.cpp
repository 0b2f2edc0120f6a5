#include <cmath>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "irsg/atmosphere/ck/CkNodes.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/core/CacheStore.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Quadrature.h"
#include "tests/support/DecimalCommas.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

RadiativeTransfer atmosphereOf(ModelAtmosphere model) {
    AtmosphericModel air{Profile::model(model), {}};
    ParticleSettings particles;
    particles.visibility_m = 23e3;
    air.particles = particleLayers(particles, air.profile);
    return RadiativeTransfer(air, GasTable::shipped());
}

/// Hot carbon dioxide: a band of lines 1.6 cm-1 apart, as the air's own are.
Spectrum plume() {
    std::vector<double> wavelengths_um, radiance;
    for (double nu = 2420.0; nu >= 2080.0; nu -= 0.4) {
        const double envelope = std::exp(-std::pow((nu - 2290.0) / 70.0, 2.0));
        const double lines = 1.0 + 0.9 * std::cos(2.0 * 3.14159265 * nu / 1.6);
        wavelengths_um.push_back(1e4 / nu);
        radiance.push_back((1.0 - std::exp(-2.0 * envelope * lines)) *
                           planckRadiance_W_m2_sr_um(1e4 / nu, 1200.0));
    }
    return Spectrum(wavelengths_um, radiance, Spectrum::Outside::zero, "plume");
}

/// Paths that are none of those trained on.
std::vector<AtmosphericPath> paths() {
    std::vector<AtmosphericPath> all;
    for (const double range_m : {11.0, 70.0, 800.0, 3500.0, 11e3, 47e3}) {
        for (const auto& [sensor_m, target_m] :
             {std::pair{20.0, 40.0}, std::pair{30.0, 30.0}, std::pair{1500.0, 1500.0},
              std::pair{2200.0, 2500.0}, std::pair{8000.0, 7700.0}, std::pair{5000.0, 2000.0}}) {
            if (range_m > 1.1 * std::abs(sensor_m - target_m) &&
                !(sensor_m < 100.0 && range_m > 4e4)) {
                all.push_back({sensor_m, target_m, range_m});
            }
        }
    }
    all.push_back({10.0, 10e3, 22e3});
    all.push_back({11e3, 300.0, 18e3});
    all.push_back({15e3, 9e3, 130e3});
    all.push_back({50.0, 4000.0, 9e3});
    return all;
}

struct BandCase {
    const char* name;
    double min_um, max_um;
};
void PrintTo(const BandCase& row, std::ostream* out) {
    *out << row.name;
}

class Wideband : public testing::TestWithParam<BandCase> {};

TEST_P(Wideband, GivesApparentRadianceWithinHalfAPercent) {
    const BandCase& test = GetParam();
    const Band band = Band::topHat(test.min_um, test.max_um);
    const SunPosition sun{0.0, 0.7};
    const Spectrum hot = plume();
    const bool hasPlume = test.min_um < 4.3 && test.max_um > 4.3;
    double worst = 0.0, trained = 0.0, heldOut = 0.0;
    std::size_t points = 0, nodes = 0;
    for (int model = 1; model <= 6; ++model) {
        const RadiativeTransfer transfer = atmosphereOf(static_cast<ModelAtmosphere>(model));
        CkRequest request;
        request.band = band;
        request.sun = sun;
        if (hasPlume) {
            request.radiances = {&hot};
        }
        const SensorCkData ck = SensorCkData::prepare(transfer, request);
        points = std::max(points, ck.size());
        trained = std::max(trained, ck.largestError());
        heldOut = std::max(heldOut, ck.heldOutError());
        EXPECT_GT(ck.heldOutError(), ck.heldOutRms());
        EXPECT_LT(ck.heldOutRms(), 0.002);
        const NodeSet spectral = transfer.nodesOf(band.range());
        nodes = spectral.nodes.size();
        const std::vector<double> hotPoints = ck.sampled(hot);
        for (const AtmosphericPath& path : paths()) {
            const Spectrum transmittance =
                transfer.spectrum(band.range(), transfer.transmittance(spectral, path));
            const Spectrum radiance =
                transfer.spectrum(band.range(), transfer.pathRadiance(spectral, path, sun));
            std::vector<const Spectrum*> axes = {&transmittance, &radiance};
            if (hasPlume) {
                axes.push_back(&hot);
            }
            const SpectralQuadrature quadrature(band, axes);
            const std::vector<double> tau = quadrature.sampled(transmittance);
            const double pathInBand = quadrature.integrate(quadrature.sampled(radiance));

            const std::vector<double> ckTau = transfer.transmittance(ck.nodes(), path);
            const double ckPath = ck.integrate(transfer.pathRadiance(ck.nodes(), path, sun));
            auto compare = [&](const std::vector<double>& source,
                               const std::vector<double>& ckSource, const char* what) {
                std::vector<double> product = ckSource;
                for (std::size_t i = 0; i < product.size(); ++i) {
                    product[i] *= ckTau[i];
                }
                const double expected = quadrature.integrate(source, tau) + pathInBand;
                const double found = ck.integrate(product) + ckPath;
                worst = std::max(worst, std::abs(found / expected - 1.0));
                EXPECT_NEAR(found / expected, 1.0, 0.005)
                    << what << ", atmosphere " << model << ", " << path.sensorAltitude_m << " to "
                    << path.targetAltitude_m << " m over " << path.range_m << " m";
            };
            for (const double temperature_K :
                 {220.0, 250.0, 275.0, 350.0, 500.0, 900.0, 1500.0, 2200.0}) {
                compare(quadrature.planck(temperature_K), ck.planck(temperature_K), "grey");
            }
            if (hasPlume) {
                compare(quadrature.sampled(hot), hotPoints, "plume");
            }
        }
    }
    std::cout << test.name << ": largest error " << 100.0 * worst << " %, at most " << points
              << " points for " << nodes << " nodes, trained to " << 100.0 * trained
              << " %, held out " << 100.0 * heldOut << " %\n";
}

INSTANTIATE_TEST_SUITE_P(Bands, Wideband,
                         testing::Values(BandCase{"ThreeToFive", 3.0, 5.0},
                                         BandCase{"EightToTwelve", 8.0, 12.0},
                                         BandCase{"OneAndAHalfToTwoAndAHalf", 1.5, 2.5},
                                         BandCase{"FourPointOneToFourPointFive", 4.1, 4.5}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(SensorCkData, HoldsWhatASensorNeeds) {
    const RadiativeTransfer transfer = atmosphereOf(ModelAtmosphere::midlatitudeSummer);
    const Band band = Band::fromResponse(Spectrum({3.4, 3.9, 4.4}, {0.0, 1.0, 0.0}));
    CkRequest request;
    request.band = band;
    const SensorCkData ck = SensorCkData::prepare(transfer, request);
    EXPECT_LT(ck.largestError(), 0.01);
    EXPECT_LE(ck.rmsError(), ck.largestError());
    ASSERT_EQ(ck.weights_um().size(), ck.size());
    for (std::size_t i = 0; i < ck.size(); ++i) {
        EXPECT_GT(ck.weights_um()[i], 0.0);
        EXPECT_GE(ck.wavelengths_um()[i], 3.39);
        EXPECT_LE(ck.wavelengths_um()[i], 4.41);
        if (i > 0) {
            EXPECT_GT(ck.wavelengths_um()[i], ck.wavelengths_um()[i - 1]);
        }
    }
    // The table of black bodies by points: report section on wideband, 200 to 2200 K.
    for (double temperature_K = 220.0; temperature_K <= 2200.0; temperature_K += 110.0) {
        EXPECT_NEAR(ck.integrate(ck.planck(temperature_K)) /
                        bandRadiance_W_m2_sr(band, temperature_K),
                    1.0, 0.005);
    }
    EXPECT_THROW((void)ck.integrate(std::vector<double>{1.0}), LogicError);
}

TEST(SensorCkData, WorksWithOnePoint) {
    CkRequest request;
    request.band = Band::topHat(10.0, 10.2);
    request.mostPoints = 1;
    const SensorCkData ck =
        SensorCkData::prepare(atmosphereOf(ModelAtmosphere::usStandard1976), request);
    EXPECT_EQ(ck.size(), 1u);
    // One wavelength serves no path well; it weighs as much as the band is wide, roughly.
    EXPECT_NEAR(ck.weights_um()[0], 0.2, 0.1);
}

TEST(SensorCkData, AreTheSameFromWhatWasKept) {
    const RadiativeTransfer transfer = atmosphereOf(ModelAtmosphere::usStandard1976);
    CkRequest request;
    request.band = Band::topHat(9.9, 10.2);
    const SensorCkData made = SensorCkData::prepare(transfer, request);
    const auto read =
        SensorCkData::fromCached(CkNodes(transfer, request.band), request.band, made.cacheText());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->wavelengths_um(), made.wavelengths_um());
    EXPECT_EQ(read->weights_um(), made.weights_um());
    EXPECT_EQ(read->nodes().nodes, made.nodes().nodes);
    EXPECT_EQ(read->heldOutError(), made.heldOutError());
    EXPECT_EQ(read->range().min_um, made.range().min_um);
    const Spectrum slope({9.0, 11.0}, {0.2, 0.8});
    EXPECT_EQ(read->sampled(slope), made.sampled(slope));
}

TEST(SensorCkData, AreKeptWithPointsUnderDecimalCommas) {
    const smat::test::TemporaryFolder folder;
    const RadiativeTransfer transfer = atmosphereOf(ModelAtmosphere::usStandard1976);
    CkRequest request;
    request.band = Band::topHat(9.9, 10.2);
    const SensorCkData made = SensorCkData::prepare(transfer, request);
    const std::string kept = made.cacheText(), key = CacheKey().add(0.5).text();
    const smat::test::DecimalCommas locale("de_DE", folder.path());
    if (!locale.isThere()) {
        GTEST_SKIP() << "de_DE cannot be made here (package locales)";
    }
    EXPECT_EQ(made.cacheText(), kept);
    EXPECT_EQ(CacheKey().add(0.5).text(), key);
    EXPECT_TRUE(SensorCkData::fromCached(CkNodes(transfer, request.band), request.band, kept));
}

TEST(SensorCkData, AreFoundByAllThatTheyDependOn) {
    auto keyOf = [](const CkRequest& request) {
        CacheKey key;
        addTo(key, request);
        return key.text();
    };
    const Spectrum grey = Spectrum::constant(0.9), paint({3.0, 5.0}, {0.9, 0.8});
    CkRequest request;
    request.band = Band::topHat(3.0, 5.0);
    std::set<std::string> keys = {keyOf(request)};
    auto another = [&](auto change) {
        CkRequest other = request;
        change(other);
        EXPECT_TRUE(keys.insert(keyOf(other)).second) << keys.size();
    };
    another([](CkRequest& r) { r.band = Band::topHat(3.0, 4.9); });
    another([](CkRequest& r) { r.band = Band::fromResponse(Spectrum({3.0, 5.0}, {1.0, 0.9})); });
    another([](CkRequest& r) { r.sun.elevation_rad += 1e-9; });
    another([](CkRequest& r) { r.sun.distance_au = 1.01; });
    another([](CkRequest& r) { r.paths = {{0.0, 0.0, 10.0}}; });
    another([&](CkRequest& r) { r.materials = {&grey}; });
    another([&](CkRequest& r) { r.materials = {&paint}; });
    another([&](CkRequest& r) { r.radiances = {&paint}; });
    another([](CkRequest& r) { r.largestError = 0.01; });
    another([](CkRequest& r) { r.mostPoints = 10; });
}

TEST(SensorCkData, AreNothingFromWhatIsDamaged) {
    const RadiativeTransfer transfer = atmosphereOf(ModelAtmosphere::usStandard1976);
    CkRequest request;
    request.band = Band::topHat(9.9, 10.2);
    const std::string text = SensorCkData::prepare(transfer, request).cacheText();
    for (std::size_t length = 0; length < text.size(); length += 7) {
        EXPECT_FALSE(SensorCkData::fromCached(CkNodes(transfer, request.band), request.band,
                                              text.substr(0, length)))
            << length;
    }
    for (std::size_t at = 0; at < text.size(); at += 11) {
        std::string bad = text;
        bad[at] = '?';
        EXPECT_FALSE(SensorCkData::fromCached(CkNodes(transfer, request.band), request.band, bad))
            << at;
    }
    EXPECT_FALSE(SensorCkData::fromCached(CkNodes(transfer, Band::topHat(4.0, 4.2)),
                                          Band::topHat(4.0, 4.2), text))
        << "another band";
}

} // namespace
} // namespace irsg
