#include "irsg/gas/GasSpectrum.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "irsg/core/Wording.h"
#include "irsg/gas/Soot.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr double shortest_um = 1.0, longest_um = 200.0;
constexpr double finest_per_cm = 1.0, coarsest_per_cm = 100.0;
constexpr double hottestBackground_K = 3000.0;
constexpr double tableStep_per_cm = 5.0; // wider cells are means of several places
constexpr std::size_t soot = hotGasCount;

bool isThere(const GasRequest& request, std::size_t gas) {
    return std::ranges::any_of(
        request.layers, [&](const GasLayer& layer) { return layer.moleFraction[gas] > 0.0; });
}

/// Where lines alone are to answer, the band must not go where only RADCAL knows of absorption.
void checkReach(const GasRequest& request, double lower_per_cm, double upper_per_cm) {
    if (request.source != GasSource::lines)
        return;
    const GasAnswers all = gasAnswers(GasSource::automatic);
    std::vector<Diagnostic> diagnostics;
    for (std::size_t gas = 0; gas < hotGasCount; ++gas) {
        const NarrowBandTable* const lines = all[gas].first.table.get();
        const NarrowBandTable* const radcal = all[gas].beyond.table.get();
        if (!isThere(request, gas) || !radcal)
            continue;
        const double from = std::max(lower_per_cm, radcal->lower_per_cm());
        const double to = std::min(upper_per_cm, radcal->upper_per_cm());
        if (from < to && (from < lines->lower_per_cm() || to > lines->upper_per_cm()))
            diagnostics.push_back(
                {"band", hotGasNames[gas],
                 numberText(request.band.min_um) + "-" + numberText(request.band.max_um) + " um",
                 "a band within " +
                     roundedText(wavelengthFromWavenumber_um(lines->upper_per_cm()), 3) + "-" +
                     roundedText(wavelengthFromWavenumber_um(lines->lower_per_cm()), 3) +
                     " um, where lines answer, or the source auto"});
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
}

/// Radiances of layers and what is behind them, place by place.
class Column {
  public:
    Column(const GasRequest& request, const GasAnswers& answers)
        : request_(request),
          answers_(answers),
          depths_(request.layers.size() + 1),
          planck_(request.layers.size() + 1) {
        for (std::size_t gas = 0; gas < hotGasCount; ++gas)
            for (const GasLayer& layer : request.layers)
                halfWidths_per_cm_[gas].push_back(
                    collisionHalfWidth_per_cm(static_cast<HotGas>(gas), layer));
    }

    /// Adds the values at a wavenumber times `weight` to a cell.
    void add(double wavenumber_per_cm, double weight, GasSpectrum::Cell& cell) {
        const double wavelength_um = wavelengthFromWavenumber_um(wavenumber_per_cm);
        const std::vector<GasLayer>& layers = request_.layers;
        for (std::size_t i = 0; i < layers.size(); ++i)
            planck_[i] = planckRadiance_W_m2_sr_um(wavelength_um, layers[i].temperature_K);
        planck_.back() = request_.background_K
                             ? planckRadiance_W_m2_sr_um(wavelength_um, *request_.background_K)
                             : 0.0;
        for (std::size_t gas = 0; gas < hotGasCount; ++gas)
            fillGas(gas, wavenumber_per_cm);
        for (std::size_t i = 0; i < layers.size(); ++i)
            depths_[i + 1][soot] =
                depths_[i][soot] + sootAbsorption_per_m(wavelength_um, layers[i].soot_ppmv * 1e-6) *
                                       layers[i].length_m;
        const double all = radiance(gasEmitterCount);
        cell.radiance_W_m2_sr_um += weight * all;
        cell.transmittance += weight * std::exp(-depth(layers.size(), gasEmitterCount));
        double error = 0.0;
        for (std::size_t emitter = 0; emitter < gasEmitterCount; ++emitter) {
            if (depths_.back()[emitter] == 0.0)
                continue;
            const double added = all - radiance(emitter);
            cell.added_W_m2_sr_um[emitter] += weight * added;
            error += std::abs(added) * statedError(emitter, wavenumber_per_cm);
        }
        cell.error_W_m2_sr_um += weight * error;
    }

  private:
    /// Optical depth of one gas from the sensor to the end of each layer.
    void fillGas(std::size_t gas, double wavenumber_per_cm) {
        const NarrowBandTable& table = *answers_[gas].at(wavenumber_per_cm).table;
        NarrowBandSum sum;
        for (std::size_t i = 0; i < request_.layers.size(); ++i) {
            const GasLayer& layer = request_.layers[i];
            depths_[i + 1][gas] = depths_[i][gas];
            if (layer.moleFraction[gas] == 0.0)
                continue;
            sum.add(narrowBandLayer(table, layer, halfWidths_per_cm_[gas][i], wavenumber_per_cm));
            depths_[i + 1][gas] = std::max(depths_[i][gas], sum.opticalDepth(table.law()));
        }
    }

    /// To the end of a layer; without one emitter, or with all.
    double depth(std::size_t layers, std::size_t without) const {
        double sum = 0.0;
        for (std::size_t emitter = 0; emitter < gasEmitterCount; ++emitter)
            if (emitter != without)
                sum += depths_[layers][emitter];
        return sum;
    }

    double radiance(std::size_t without) const {
        double sum = 0.0, before = 0.0;
        for (std::size_t i = 0; i < request_.layers.size(); ++i) {
            const double behind = depth(i + 1, without);
            // The difference of two transmittances, also of thin layers.
            sum += planck_[i] * std::exp(-before) * -std::expm1(before - behind);
            before = behind;
        }
        return sum + planck_.back() * std::exp(-before);
    }

    /// The largest of those of the layers that hold the emitter.
    double statedError(std::size_t emitter, double wavenumber_per_cm) const {
        if (emitter == soot)
            return statedSootError;
        double largest = 0.0;
        const GasTableOfSource& answer = answers_[emitter].at(wavenumber_per_cm);
        for (const GasLayer& layer : request_.layers)
            if (layer.moleFraction[emitter] > 0.0)
                largest = std::max(largest, statedGasError(answer, static_cast<HotGas>(emitter),
                                                           wavenumber_per_cm, layer.temperature_K));
        return largest;
    }

    const GasRequest& request_;
    const GasAnswers& answers_;
    std::array<std::vector<double>, hotGasCount> halfWidths_per_cm_;
    std::vector<std::array<double, gasEmitterCount>> depths_; ///< to the end of each layer
    std::vector<double> planck_;                              ///< of layers, then the background
};

double integral(const std::vector<GasSpectrum::Cell>& cells,
                const std::function<double(const GasSpectrum::Cell&)>& value) {
    double sum = 0.0;
    for (const GasSpectrum::Cell& cell : cells)
        sum += value(cell) * (wavelengthFromWavenumber_um(cell.lower_per_cm) -
                              wavelengthFromWavenumber_um(cell.upper_per_cm));
    return sum;
}

} // namespace

std::string gasEmitterName(std::size_t emitter) {
    return emitter == soot ? "soot" : hotGasNames.at(emitter);
}

std::vector<Diagnostic> gasRequestDiagnostics(const GasRequest& request) {
    std::vector<Diagnostic> diagnostics;
    if (request.layers.empty())
        diagnostics.push_back({"layers", "", "none", "at least one layer of gas"});
    for (std::size_t i = 0; i < request.layers.size(); ++i)
        std::ranges::move(gasLayerDiagnostics(request.layers[i], "layer " + std::to_string(i + 1)),
                          std::back_inserter(diagnostics));
    const SpectralRange& band = request.band;
    if (!(band.min_um >= shortest_um && band.max_um <= longest_um && band.min_um < band.max_um))
        diagnostics.push_back(
            {"band", "", numberText(band.min_um) + "-" + numberText(band.max_um) + " um",
             "a band within " + numberText(shortest_um) + "-" + numberText(longest_um) + " um"});
    if (!(request.step_per_cm >= finest_per_cm && request.step_per_cm <= coarsest_per_cm))
        diagnostics.push_back({"step", "", numberText(request.step_per_cm),
                               "a number from " + numberText(finest_per_cm) + " to " +
                                   numberText(coarsest_per_cm) + " cm-1"});
    if (request.background_K &&
        !(*request.background_K >= 1.0 && *request.background_K <= hottestBackground_K))
        diagnostics.push_back(
            {"background", "", numberText(*request.background_K),
             "a temperature from 1 to " + numberText(hottestBackground_K) + " K"});
    return diagnostics;
}

double GasSpectrum::bandRadiance_W_m2_sr() const {
    return integral(cells, [](const Cell& cell) { return cell.radiance_W_m2_sr_um; });
}

double GasSpectrum::bandAdded_W_m2_sr(std::size_t emitter) const {
    return integral(cells, [&](const Cell& cell) { return cell.added_W_m2_sr_um.at(emitter); });
}

double GasSpectrum::bandError_W_m2_sr() const {
    return integral(cells, [](const Cell& cell) { return cell.error_W_m2_sr_um; });
}

double GasSpectrum::bandTransmittance() const {
    return integral(cells, [](const Cell& cell) { return cell.transmittance; }) /
           integral(cells, [](const Cell&) { return 1.0; });
}

GasSpectrum gasSpectrum(const GasRequest& request) {
    if (std::vector<Diagnostic> diagnostics = gasRequestDiagnostics(request); !diagnostics.empty())
        throw InputError(std::move(diagnostics));
    GasSpectrum result;
    result.answers = gasAnswers(request.source);
    const double lower_per_cm = wavenumberFromWavelength_per_cm(request.band.max_um);
    const double upper_per_cm = wavenumberFromWavelength_per_cm(request.band.min_um);
    checkReach(request, lower_per_cm, upper_per_cm);
    const double step = request.step_per_cm;
    Column column(request, result.answers);
    for (double n = std::floor(lower_per_cm / step + 0.5); (n - 0.5) * step < upper_per_cm; ++n) {
        GasSpectrum::Cell cell;
        cell.lower_per_cm = std::max(lower_per_cm, (n - 0.5) * step);
        cell.upper_per_cm = std::min(upper_per_cm, (n + 0.5) * step);
        if (!(cell.upper_per_cm > cell.lower_per_cm))
            continue;
        cell.wavenumber_per_cm = 0.5 * (cell.lower_per_cm + cell.upper_per_cm);
        cell.transmittance = 0.0;
        const auto places = static_cast<int>(std::max(1.0, std::round(step / tableStep_per_cm)));
        for (int i = 0; i < places; ++i)
            column.add(std::lerp(cell.lower_per_cm, cell.upper_per_cm, (i + 0.5) / places),
                       1.0 / places, cell);
        result.cells.push_back(cell);
    }
    return result;
}

} // namespace irsg
