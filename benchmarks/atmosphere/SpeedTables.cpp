#include <algorithm>
#include <chrono>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "benchmarks/atmosphere/Table.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/radiometry/Quadrature.h"

namespace irsg::accuracy {

namespace {

/// The least time of a call, ms: what else the machine does only adds to it.
template <typename Call>
double least_ms(int times, Call call) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < times; ++i) {
        const auto start = std::chrono::steady_clock::now();
        call();
        least = std::min(least, std::chrono::duration<double, std::milli>(
                                    std::chrono::steady_clock::now() - start)
                                    .count());
    }
    return least;
}

constexpr SpectralRange range{3.0, 5.0};
constexpr SunPosition night{0.0, -0.5 * std::numbers::pi};
constexpr double target_K = 300.0;

std::pair<Spectrum, Spectrum> spectra(const RadiativeTransfer& transfer,
                                      const AtmosphericPath& path) {
    const NodeSet set = transfer.nodesOf(range);
    return {transfer.spectrum(range, transfer.transmittance(set, path)),
            transfer.spectrum(range, transfer.pathRadiance(set, path, night))};
}

/// In-band radiance of a black target as the sensor sees it, in both modes.
double apparentBySpectra(const RadiativeTransfer& transfer, const Band& band,
                         const AtmosphericPath& path) {
    const auto [transmittance, radiance] = spectra(transfer, path);
    const Spectrum* axes[] = {&transmittance, &radiance};
    const SpectralQuadrature quadrature(band, axes);
    return quadrature.integrate(quadrature.planck(target_K), quadrature.sampled(transmittance)) +
           quadrature.integrate(quadrature.sampled(radiance));
}

double apparentByPoints(const RadiativeTransfer& transfer, const SensorCkData& ck,
                        const AtmosphericPath& path) {
    const std::vector<double> target = ck.planck(target_K);
    const std::vector<double> transmittance = transfer.transmittance(ck.nodes(), path);
    std::vector<double> radiance = transfer.pathRadiance(ck.nodes(), path, night);
    for (std::size_t i = 0; i < radiance.size(); ++i)
        radiance[i] += target[i] * transmittance[i];
    return ck.integrate(radiance);
}

} // namespace

void speedTables(const Output&) {
    Table table(
        "Times of one core, the least of many, 3-5 µm, path from 3 to 10 km altitude, 14 km "
        "long, at night: transmittance and thermal path radiance",
        {"scattering", "what", "spectral mode, ms", "wideband, ms", "ratio"});
    GasTable::shipped();
    const Band band = Band::topHat(range.min_um, range.max_um);
    for (const ScatteringMode mode : {ScatteringMode::single, ScatteringMode::twoStream}) {
        AtmosphericModel air{Profile::model(ModelAtmosphere::usStandard1976), {}};
        air.particles = particleLayers({}, air.profile);
        air.scattering = mode;
        const std::string name = mode == ScatteringMode::single ? "single" : "two-stream";
        AtmosphericPath path{3000.0, 10000.0, 14e3};
        std::optional<RadiativeTransfer> transfer;
        const double first_ms = least_ms(25, [&] {
            transfer.emplace(air, GasTable::shipped());
            spectra(*transfer, path);
        });
        table.add({name, "first call, with the air and the levels it touches",
                   text("%.3g", first_ms), "", ""});

        CkRequest request;
        request.band = band;
        request.sun = night;
        std::optional<SensorCkData> ck;
        const double prepare_ms =
            least_ms(3, [&] { ck.emplace(SensorCkData::prepare(*transfer, request)); });
        table.add({name, "preparation of " + std::to_string(ck->size()) + " points", "",
                   text("%.3g", prepare_ms), ""});

        auto compare = [&](const char* what, auto bySpectra, auto byPoints) {
            bySpectra();
            byPoints();
            const double spectra_ms = least_ms(301, bySpectra);
            const double points_ms = least_ms(3001, byPoints);
            table.add({name, what, text("%.3g", spectra_ms), text("%.3g", points_ms),
                       text("%.1f", spectra_ms / points_ms)});
        };
        auto points = [&] {
            transfer->transmittance(ck->nodes(), path);
            transfer->pathRadiance(ck->nodes(), path, night);
        };
        compare(
            "later calls", [&] { spectra(*transfer, path); }, points);
        compare(
            "later calls, another range each time",
            [&] {
                path.range_m += 0.1;
                spectra(*transfer, path);
            },
            [&] {
                path.range_m += 0.1;
                points();
            });
        compare(
            "apparent in-band radiance of a black target, later calls",
            [&] { apparentBySpectra(*transfer, band, path); },
            [&] { apparentByPoints(*transfer, *ck, path); });
    }
    table.print();
}

} // namespace irsg::accuracy
