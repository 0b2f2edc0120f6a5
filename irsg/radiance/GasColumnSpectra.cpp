#include "irsg/radiance/GasColumnSpectra.h"

#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/AtmosphereNodes.h"
#include "irsg/core/Errors.h"
#include "irsg/core/RecentlyUsed.h"
#include "irsg/gas/GasThroughAir.h"
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

/// What brings spectra on an axis to the nodes of computed air; null for another sampling.
std::shared_ptr<const AxisToNodes>
toNodesOf(const std::shared_ptr<const SpectralSampling>& sampling,
          const std::vector<double>& wavelengths_um) {
    const AtmosphereNodes* nodes = AtmosphereNodes::of(*sampling);
    if (nodes == nullptr)
        return nullptr;
    struct KnownNodes {
        std::weak_ptr<const SpectralSampling> sampling;
        std::vector<double> wavelengths_um;
        std::shared_ptr<const AxisToNodes> toNodes;
    };
    static std::mutex mutex;
    static RecentlyUsed<KnownNodes> known{32};
    const std::lock_guard lock(mutex);
    const auto isIt = [&](const KnownNodes& one) {
        return one.sampling.lock() == sampling && one.wavelengths_um == wavelengths_um;
    };
    const auto make = [&] {
        return KnownNodes{sampling, wavelengths_um,
                          std::make_shared<const AxisToNodes>(nodes->fromAxis(wavelengths_um))};
    };
    return known.of(isIt, make).toNodes;
}

} // namespace

class GasesOnWavenumbers {
  public:
    GasesOnWavenumbers(const std::map<IrCodes, GasLayer>& gases,
                       const std::vector<double>& wavenumbers_per_cm)
        : gases_(gases), layers_(layersOf(gases)), columns_(layers_, wavenumbers_per_cm) {
        for (const auto& [codes, gas] : gases_)
            numbers_.emplace(codes, numbers_.size());
    }

    const std::map<IrCodes, std::size_t>& numbers() const { return numbers_; }
    bool areOf(const std::map<IrCodes, GasLayer>& gases,
               const std::vector<double>& wavenumbers_per_cm) const {
        return gases == gases_ && wavenumbers_per_cm == columns_.wavenumbers_per_cm();
    }
    using Shares = std::vector<std::vector<double>>;
    /// Of a column by its number, by gas: see GasColumns.
    std::shared_ptr<const Shares> sharesOf(int number) {
        return kept(shares_, number, [&](const GasColumnKey& key) {
            return columns_.shares(stretchesOf(key), key.before);
        });
    }
    std::vector<double> transmittance(const AirBeforeGas& air) {
        return lines().transmittance(air.state, air.length_m);
    }
    std::vector<LineCorrelation> correlations(int number, const std::vector<double>& air) {
        const GasColumnsLineByLine& lines = this->lines();
        return lines.correlations(
            *kept(ofLines_, number,
                  [&](const GasColumnKey& key) { return lines.of(stretchesOf(key), key.before); }),
            air);
    }

  private:
    /// By number. More than an entity has of its own and in the light between surfaces.
    template <typename Value>
    using Recent = RecentlyUsed<std::pair<int, std::shared_ptr<const Value>>>;
    static constexpr std::size_t most = 96;

    template <typename Value, typename Make>
    std::shared_ptr<const Value> kept(Recent<Value>& all, int number, const Make& make) {
        const auto isIt = [&](const auto& one) { return one.first == number; };
        {
            const std::lock_guard lock(mutex_);
            if (const auto* found = all.find(isIt))
                return found->second;
        }
        auto made = std::make_shared<const Value>(make(gasColumn(number)));
        const std::lock_guard lock(mutex_);
        return all.of(isIt, [&] { return std::pair(number, made); }).second;
    }
    static std::vector<GasLayer> layersOf(const std::map<IrCodes, GasLayer>& gases) {
        std::vector<GasLayer> layers;
        layers.reserve(gases.size());
        for (const auto& [codes, gas] : gases)
            layers.push_back(gas);
        return layers;
    }
    std::vector<GasStretch> stretchesOf(const GasColumnKey& key) const {
        std::vector<GasStretch> stretches;
        stretches.reserve(key.stretches.size());
        for (const GasColumnKey::Stretch& stretch : key.stretches)
            stretches.push_back({numbers_.at(stretch.codes), stretch.length_m});
        return stretches;
    }
    const GasColumnsLineByLine& lines() {
        std::call_once(hasLines_, [&] {
            const std::vector<double>& wavenumbers_per_cm = columns_.wavenumbers_per_cm();
            lines_.emplace(layers_, wavenumbers_per_cm,
                           std::vector<double>(wavenumbers_per_cm.size(), step_per_cm));
        });
        return *lines_;
    }

    std::map<IrCodes, GasLayer> gases_;
    std::map<IrCodes, std::size_t> numbers_;
    std::vector<GasLayer> layers_;
    GasColumns columns_;
    std::once_flag hasLines_;
    std::optional<GasColumnsLineByLine> lines_; ///< made where there is air
    std::mutex mutex_;
    Recent<Shares> shares_{most};
    Recent<GasColumnsLineByLine::Column> ofLines_{most};
};

namespace {

std::shared_ptr<GasesOnWavenumbers> gasesOn(const std::map<IrCodes, GasLayer>& gases,
                                            const std::vector<double>& wavenumbers_per_cm) {
    using Known = std::shared_ptr<GasesOnWavenumbers>;
    static std::mutex mutex;
    static RecentlyUsed<Known> known{6};
    const std::lock_guard lock(mutex);
    return known.of(
        [&](const Known& one) { return one->areOf(gases, wavenumbers_per_cm); },
        [&] { return std::make_shared<GasesOnWavenumbers>(gases, wavenumbers_per_cm); });
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

GasColumnSpectra::GasColumnSpectra(const std::map<int, OfEntity>& entities,
                                   const SpectralRange& range, std::vector<Nodes> bands)
    : bands_(std::move(bands)) {
    const std::vector<double> wavenumbers_per_cm = wavenumbersAbout_per_cm(range);
    wavelengths_um_ = wavelengthsOf_um(wavenumbers_per_cm);
    for (const Nodes& band : bands_)
        toNodes_.push_back(toNodesOf(band.sampling, wavelengths_um_));
    for (const auto& [entity, of] : entities) {
        Known& known = entities_[entity];
        known.gases = gasesOn(of.gases, wavenumbers_per_cm);
        if (of.air && of.air->length_m > 0.0)
            known.air = known.gases->transmittance(*of.air);
    }
}

GasColumnSpectra::Values GasColumnSpectra::sampled(const std::vector<double>& plain,
                                                   const std::vector<double>& throughAir) const {
    const std::vector<double> unchanged(plain.rbegin(), plain.rend());
    const std::vector<double> changed(throughAir.rbegin(), throughAir.rend());
    Values values;
    for (std::size_t band = 0; band < bands_.size(); ++band) {
        const auto onNodes = [&](const std::vector<double>& of) {
            return toNodes_[band] ? toNodes_[band]->sampled(of)
                                  : bands_[band].sampling->sampled(Spectrum(wavelengths_um_, of));
        };
        const std::vector<double> ofBand = onNodes(unchanged);
        values.plain.insert(values.plain.end(), ofBand.begin(), ofBand.end());
        if (changed.empty())
            continue;
        const std::vector<double> own = bands_[band].hasAir ? onNodes(changed) : ofBand;
        values.throughAir.insert(values.throughAir.end(), own.begin(), own.end());
    }
    return values;
}

std::unique_ptr<GasColumnSpectra::Column> GasColumnSpectra::make(const Known& entity,
                                                                 int number) const {
    const auto through = [](std::vector<double> values,
                            const std::vector<LineCorrelation>& correlations,
                            double LineCorrelation::*of) {
        for (std::size_t i = 0; i < correlations.size(); ++i)
            values[i] *= correlations[i].*of;
        return correlations.empty() ? std::vector<double>() : values;
    };
    std::vector<LineCorrelation> correlations;
    if (!entity.air.empty())
        correlations = entity.gases->correlations(number, entity.air);
    auto column = std::make_unique<Column>();
    const GasColumnKey& key = gasColumn(number);
    const std::shared_ptr<const GasesOnWavenumbers::Shares> shares = entity.gases->sharesOf(number);
    std::vector<double> transmittance(wavelengths_um_.size(), 1.0);
    for (const auto& [codes, gas] : entity.gases->numbers()) {
        const bool isThere =
            std::ranges::find(key.stretches, codes, &GasColumnKey::Stretch::codes) !=
            key.stretches.end();
        if (!isThere)
            continue;
        const std::vector<double>& own = (*shares)[gas];
        for (std::size_t i = 0; i < transmittance.size(); ++i)
            transmittance[i] -= own[i];
        column->shares.emplace(
            codes, sampled(own, through(own, correlations, &LineCorrelation::radiance)));
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
    std::unique_ptr<Column> made = make(*gas, number);
    const std::lock_guard lock(mutex_);
    return *entities_.at(entity).byNumber.try_emplace(number, std::move(made)).first->second;
}

} // namespace irsg
