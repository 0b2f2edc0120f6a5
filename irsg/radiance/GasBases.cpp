#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <utility>

#include "irsg/core/RecentlyUsed.h"
#include "irsg/radiance/GasLines.h"
#include "irsg/radiance/GasZones.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// A part of the spectrum whose columns are found together: those of images, sweeps and spectra
/// within it are the same.
struct WideBand {
    double min_um, max_um, step_per_cm; ///< of the wavenumbers at which lines are compared
};
constexpr std::array<WideBand, 5> wideBands = {
    {{1.0, 2.4, 80.0}, {2.4, 5.3, 20.0}, {5.3, 7.6, 10.0}, {7.6, 14.5, 10.0}, {14.5, 200.0, 10.0}}};

std::vector<double> wavenumbersFor_per_cm(const std::vector<double>& wavelengths_um) {
    std::vector<double> wavenumbers_per_cm;
    for (auto band = wideBands.rbegin(); band != wideBands.rend(); ++band) {
        if (std::ranges::none_of(wavelengths_um, [&](double wavelength_um) {
                return wavelength_um >= band->min_um && wavelength_um < band->max_um;
            }))
            continue;
        const double first = wavenumberFromWavelength_per_cm(band->max_um),
                     last = wavenumberFromWavelength_per_cm(band->min_um);
        for (double n = std::ceil(first / band->step_per_cm); n * band->step_per_cm < last; ++n)
            wavenumbers_per_cm.push_back(n * band->step_per_cm);
    }
    return wavenumbers_per_cm;
}

struct KnownBasis {
    std::weak_ptr<const Mesh> mesh;
    std::map<IrCodes, GasLayer> gases;
    std::vector<double> wavenumbers_per_cm;
    std::shared_ptr<const GasColumnsOfEntity> columns;
};

} // namespace

std::shared_ptr<const GasColumnsOfEntity> gasColumnsOf(const std::shared_ptr<const Mesh>& mesh,
                                                       const std::map<IrCodes, GasLayer>& gases,
                                                       const std::vector<double>& wavelengths_um) {
    std::vector<double> wavenumbers_per_cm = wavenumbersFor_per_cm(wavelengths_um);
    static std::mutex mutex;
    static RecentlyUsed<KnownBasis> known{64};
    const std::lock_guard lock(mutex);
    const auto isIt = [&](const KnownBasis& one) {
        return one.mesh.lock() == mesh && one.wavenumbers_per_cm == wavenumbers_per_cm &&
               one.gases == gases;
    };
    if (const KnownBasis* found = known.find(isIt))
        return found->columns;
    std::vector<IrCodes> codes;
    std::vector<GasLayer> layers;
    for (const auto& [of, gas] : gases) {
        codes.push_back(of);
        layers.push_back(gas);
    }
    auto columns = std::make_shared<GasColumnsOfEntity>(
        GasColumnBasis(layers, wavenumbers_per_cm, *gasLines(mesh, codes)), std::vector<int>());
    for (const GasLine& line : columns->basis.columns()) {
        GasColumnKey key;
        for (const GasStretch& stretch : line)
            key.stretches.push_back({codes[stretch.gas], stretch.length_m});
        columns->numbers.push_back(gasColumnNumber(key));
    }
    return known.add({mesh, gases, std::move(wavenumbers_per_cm), std::move(columns)}).columns;
}

} // namespace irsg
