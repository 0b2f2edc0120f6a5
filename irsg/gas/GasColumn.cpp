#include "irsg/gas/GasColumn.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "irsg/gas/Soot.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

std::vector<GasLayer> checkedPerMetre(std::vector<GasLayer> gases) {
    std::vector<Diagnostic> diagnostics;
    for (std::size_t i = 0; i < gases.size(); ++i) {
        gases[i].length_m = 1.0;
        std::ranges::move(gasLayerDiagnostics(gases[i], "gas " + std::to_string(i + 1)),
                          std::back_inserter(diagnostics));
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return gases;
}

} // namespace

GasColumns::GasColumns(const std::vector<GasLayer>& gases, std::vector<double> wavenumbers_per_cm)
    : gases_(checkedPerMetre(gases)),
      wavenumbers_per_cm_(std::move(wavenumbers_per_cm)),
      perMetre_(wavenumbers_per_cm_.size() * gases_.size() * hotGasCount),
      laws_(wavenumbers_per_cm_.size()) {
    const GasAnswers answers = gasAnswers(GasSource::automatic);
    for (std::size_t place = 0; place < wavenumbers_per_cm_.size(); ++place) {
        const double wavenumber_per_cm = wavenumbers_per_cm_[place];
        for (const GasLayer& gas : gases_)
            soot_per_m_.push_back(
                gas.soot_ppmv > 0.0
                    ? sootAbsorption_per_m(wavelengthFromWavenumber_um(wavenumber_per_cm),
                                           gas.soot_ppmv * 1e-6)
                    : 0.0);
        for (std::size_t emitter = 0; emitter < hotGasCount; ++emitter) {
            const NarrowBandTable& table = *answers[emitter].at(wavenumber_per_cm).table;
            laws_[place][emitter] = table.law();
            for (std::size_t g = 0; g < gases_.size(); ++g) {
                const GasLayer& gas = gases_[g];
                if (gas.moleFraction[emitter] == 0.0)
                    continue;
                const NarrowBandLayer layer = narrowBandLayer(
                    table, gas, collisionHalfWidth_per_cm(static_cast<HotGas>(emitter), gas),
                    wavenumber_per_cm);
                perMetre_[(place * gases_.size() + g) * hotGasCount + emitter] = {
                    layer.depth, layer.depth * layer.collision, layer.depth * layer.doppler};
            }
        }
    }
}

template <typename Take>
void GasColumns::walk(std::span<const GasStretch> column, std::size_t first,
                      const Take& take) const {
    for (std::size_t place = 0; place < wavenumbers_per_cm_.size(); ++place) {
        std::array<NarrowBandSum, hotGasCount> sums;
        std::array<double, hotGasCount> depths{};
        double soot = 0.0, before = 0.0;
        for (std::size_t i = 0; i < column.size(); ++i) {
            const auto& [gas, length_m] = column[i];
            soot += soot_per_m_[place * gases_.size() + gas] * length_m;
            double behind = soot;
            for (std::size_t emitter = 0; emitter < hotGasCount; ++emitter) {
                const PerMetre& of = perMetre(gas, emitter, place);
                if (of.depth > 0.0) {
                    sums[emitter].add(of.depth * length_m, of.byCollision * length_m,
                                      of.byDoppler * length_m);
                    depths[emitter] = std::max(depths[emitter],
                                               sums[emitter].opticalDepth(laws_[place][emitter]));
                }
                behind += depths[emitter];
            }
            if (i >= first)
                take(gas, place, std::exp(-before) * -std::expm1(before - behind));
            before = behind;
        }
    }
}

std::vector<std::vector<double>> GasColumns::shares(std::span<const GasStretch> column,
                                                    std::size_t first) const {
    std::vector<std::vector<double>> shares(gases_.size(),
                                            std::vector<double>(wavenumbers_per_cm_.size(), 0.0));
    walk(column, first,
         [&](std::size_t gas, std::size_t place, double share) { shares[gas][place] += share; });
    return shares;
}

double GasColumns::weighted(std::span<const GasStretch> column,
                            std::span<const double> weights) const {
    double sum = 0.0;
    walk(column, 0, [&](std::size_t gas, std::size_t place, double share) {
        sum += weights[place * gases_.size() + gas] * share;
    });
    return sum;
}

} // namespace irsg
