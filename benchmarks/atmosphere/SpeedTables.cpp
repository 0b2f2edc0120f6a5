#include <algorithm>
#include <chrono>
#include <numbers>
#include <optional>

#include "benchmarks/atmosphere/Table.h"
#include "irsg/atmosphere/ck/SensorCkData.h"

namespace irsg::accuracy {

namespace {

/// The median time of a call, ms.
template <typename Call>
double median_ms(int times, Call call) {
    std::vector<double> all;
    for (int i = 0; i < times; ++i) {
        const auto start = std::chrono::steady_clock::now();
        call();
        all.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                .count());
    }
    std::ranges::nth_element(all, all.begin() + times / 2);
    return all[static_cast<std::size_t>(times / 2)];
}

} // namespace

void speedTables(const Output&) {
    constexpr SpectralRange range{3.0, 5.0};
    constexpr AirPath path{3000.0, 10000.0, 14e3};
    Table table("Times of one core, medians, 3-5 µm, path from 3 to 10 km altitude, 14 km long: "
                "transmittance and thermal path radiance",
                {"scattering", "what", "ms", "of the later spectra"});
    GasTable::shipped();
    for (const ScatteringMode mode : {ScatteringMode::single, ScatteringMode::twoStream}) {
        AirModel air{Profile::model(ModelAtmosphere::usStandard1976), {}};
        air.particles = particleLayers({}, air.profile);
        air.scattering = mode;
        const SunPosition sun{0.0, -0.5 * std::numbers::pi};
        std::optional<RadiativeTransfer> transfer;
        std::vector<std::pair<std::string, double>> rows;
        auto spectra = [&] {
            const NodeSet set = transfer->nodesOf(range);
            transfer->spectrum(range, transfer->transmittance(set, path));
            transfer->spectrum(range, transfer->pathRadiance(set, path, sun));
        };
        double created_ms = 0.0;
        const double first_ms = median_ms(9, [&] {
            created_ms += median_ms(1, [&] { transfer.emplace(air, GasTable::shipped()); });
            spectra();
        });
        const double later_ms = median_ms(101, spectra);
        rows.emplace_back("first spectra, with the air and the levels they touch", first_ms);
        rows.emplace_back("of which the air itself", created_ms / 9.0);
        rows.emplace_back("later spectra, 5 cm⁻¹", later_ms);

        CkRequest request;
        request.band = Band::topHat(range.min_um, range.max_um);
        request.sun = sun;
        std::optional<SensorCkData> ck;
        const double prepare_ms =
            median_ms(3, [&] { ck.emplace(SensorCkData::prepare(*transfer, request)); });
        auto wideband = [&] {
            transfer->transmittance(ck->nodes(), path);
            transfer->pathRadiance(ck->nodes(), path, sun);
        };
        wideband();
        rows.emplace_back("wideband, " + std::to_string(ck->size()) + " terms",
                          median_ms(501, wideband));
        rows.emplace_back("preparation of the wideband terms", prepare_ms);
        for (const auto& [what, ms] : rows)
            table.add({mode == ScatteringMode::single ? "single" : "two-stream", what,
                       text("%.3g", ms), text("%.3g", ms / later_ms)});
    }
    table.print();
}

} // namespace irsg::accuracy
