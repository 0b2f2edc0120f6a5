#include "irsg/radiance/GasColumnSpectra.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr double step_per_cm = 5.0; // of the tables of gases

/// Ascending multiples of the step about a range.
std::vector<double> wavenumbersAbout_per_cm(const SpectralRange& range) {
    const double first = std::floor(wavenumberFromWavelength_per_cm(range.max_um) / step_per_cm);
    const double last = std::ceil(wavenumberFromWavelength_per_cm(range.min_um) / step_per_cm);
    std::vector<double> wavenumbers_per_cm;
    for (double n = std::max(first - 1.0, 1.0); n <= last + 1.0; ++n)
        wavenumbers_per_cm.push_back(n * step_per_cm);
    return wavenumbers_per_cm;
}

std::vector<double> wavelengthsOf_um(const std::vector<double>& wavenumbers_per_cm) {
    std::vector<double> wavelengths_um;
    for (std::size_t i = wavenumbers_per_cm.size(); i-- > 0;)
        wavelengths_um.push_back(wavelengthFromWavenumber_um(wavenumbers_per_cm[i]));
    return wavelengths_um;
}

} // namespace

GasLayer gasOf(const Material& material, double temperature_K) {
    GasLayer gas;
    gas.temperature_K = temperature_K;
    gas.pressure_atm = material.gasPressure_atm;
    gas.fraction(HotGas::CO2) = material.gasCO2;
    gas.fraction(HotGas::H2O) = material.gasH2O;
    gas.fraction(HotGas::CO) = material.gasCO;
    gas.fraction(HotGas::CH4) = material.gasCH4;
    gas.oxygenFraction = material.gasO2;
    gas.soot_ppmv = material.gasSoot_ppmv;
    return gas;
}

const Spectrum& gasKinks() {
    static const Spectrum kinks = [] {
        constexpr SpectralRange all{1.0, 200.0};
        std::vector<double> wavelengths_um = wavelengthsOf_um(wavenumbersAbout_per_cm(all));
        std::vector<double> values(wavelengths_um.size(), 0.0);
        return Spectrum(std::move(wavelengths_um), std::move(values));
    }();
    return kinks;
}

GasColumnSpectra::GasColumnSpectra(std::map<int, OfEntity> entities, const SpectralRange& range,
                                   Sampler sample)
    : sample_(std::move(sample)) {
    const std::vector<double> wavenumbers_per_cm = wavenumbersAbout_per_cm(range);
    wavelengths_um_ = wavelengthsOf_um(wavenumbers_per_cm);
    for (const auto& [entity, of] : entities) {
        Known& known = entities_[entity];
        std::vector<GasLayer> gases;
        for (const auto& [codes, gas] : of.gases) {
            known.numbers.emplace(codes, gases.size());
            gases.push_back(gas);
        }
        known.columns = std::make_unique<GasColumns>(gases, wavenumbers_per_cm);
        if (of.air && of.air->length_m > 0.0)
            known.throughAir = std::make_unique<GasColumnsThroughAir>(
                gases, wavenumbers_per_cm,
                std::vector<double>(wavenumbers_per_cm.size(), step_per_cm), of.air->state,
                of.air->length_m);
    }
}

GasColumnSpectra::Values GasColumnSpectra::sampled(const std::vector<double>& plain,
                                                   const std::vector<double>& throughAir) const {
    const auto spectrumOf = [&](const std::vector<double>& values) {
        return Spectrum(wavelengths_um_, {values.rbegin(), values.rend()});
    };
    const Spectrum own = spectrumOf(plain);
    Values values{sample_(own, own), {}};
    if (!throughAir.empty())
        values.throughAir = sample_(own, spectrumOf(throughAir));
    return values;
}

std::unique_ptr<GasColumnSpectra::Column> GasColumnSpectra::make(const Known& entity,
                                                                 const GasColumnKey& key) const {
    std::vector<GasStretch> stretches;
    for (const GasColumnKey::Stretch& stretch : key.stretches)
        stretches.push_back({entity.numbers.at(stretch.codes), stretch.length_m});
    const auto through = [](std::vector<double> values,
                            const std::vector<LineCorrelation>& correlations,
                            double LineCorrelation::*of) {
        for (std::size_t i = 0; i < correlations.size(); ++i)
            values[i] *= correlations[i].*of;
        return correlations.empty() ? std::vector<double>() : values;
    };
    std::vector<LineCorrelation> correlations;
    if (entity.throughAir)
        correlations = entity.throughAir->of(stretches, key.before);
    auto column = std::make_unique<Column>();
    const std::vector<std::vector<double>> shares = entity.columns->shares(stretches, key.before);
    std::vector<double> transmittance(wavelengths_um_.size(), 1.0);
    for (const auto& [codes, number] : entity.numbers) {
        const bool isThere =
            std::ranges::find(key.stretches, codes, &GasColumnKey::Stretch::codes) !=
            key.stretches.end();
        if (!isThere)
            continue;
        for (std::size_t i = 0; i < transmittance.size(); ++i)
            transmittance[i] -= shares[number][i];
        column->shares.emplace(codes, sampled(shares[number], through(shares[number], correlations,
                                                                      &LineCorrelation::radiance)));
    }
    column->transmittance = sampled(
        transmittance, through(transmittance, correlations, &LineCorrelation::transmittance));
    return column;
}

const GasColumnSpectra::Column& GasColumnSpectra::of(int entity, int number) const {
    const Known* gas = nullptr;
    {
        const std::lock_guard lock(mutex_);
        const auto found = entities_.find(entity);
        if (found == entities_.end())
            throw LogicError("a column of gas belongs to an entity without gas");
        gas = &found->second;
        if (const auto known = found->second.byNumber.find(number);
            known != found->second.byNumber.end())
            return *known->second;
    }
    std::unique_ptr<Column> made = make(*gas, gasColumn(number));
    const std::lock_guard lock(mutex_);
    return *entities_.at(entity).byNumber.try_emplace(number, std::move(made)).first->second;
}

} // namespace irsg
