#include "smatcore/tools/GasOutput.h"

#include <algorithm>

#include <fmt/format.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/core/AppendUnique.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/core/Quantity.h"
#include "irsg/gas/GasThroughAir.h"
#include "irsg/radiometry/Spectrum.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/AnalysisKind.h"
#include "smatcore/tools/GasLayerText.h"

namespace smat {

namespace {

using irsg::AtmosphereProperty;
using irsg::GasSpectrum;
using irsg::Quantity;

/// One request on its way to a table.
class Output {
  public:
    explicit Output(const GasOutputRequest& request)
        : request_(request), spectrum_(irsg::gasSpectrum(request.gas)) {}

    GasOutput make() {
        if (request_.path)
            askAtmosphere();
        fillTable();
        summarise();
        nameSources();
        writeProvenance();
        return std::move(result_);
    }

  private:
    const irsg::SpectralRange& band() const { return request_.gas.band; }

    void askAtmosphere() {
        const GasPath& path = *request_.path;
        const auto means = [&](AtmosphereProperty property) {
            const irsg::AtmosphericQuery query{.quantity = property,
                                               .path = {.sensorAltitude_m = path.sensorAltitude_m,
                                                        .targetAltitude_m = path.gasAltitude_m,
                                                        .range_m = path.range_m},
                                               .sun = path.environment.sun};
            const irsg::Provided<irsg::Spectrum> answer = path.environment.spectrum(query, band());
            answeredBy_.push_back(std::string(irsg::name(property)) + ": " + answer.providedBy);
            const irsg::Spectrum* const factors[] = {&answer.value};
            std::vector<double> values;
            for (const GasSpectrum::Cell& cell : spectrum_.cells) {
                const irsg::SpectralRange range{
                    irsg::wavelengthFromWavenumber_um(cell.upper_per_cm),
                    irsg::wavelengthFromWavenumber_um(cell.lower_per_cm)};
                values.push_back(irsg::integrateProduct(factors, range) / range.width_um());
            }
            return values;
        };
        transmittance_ = means(AtmosphereProperty::transmittance);
        pathRadiance_ = means(AtmosphereProperty::pathRadiance);
        correlate();
    }

    /// Lines of the gas coincide with lines of the air: known where the atmosphere tells what it
    /// is made of.
    void correlate() {
        const GasPath& path = *request_.path;
        correlations_.resize(spectrum_.cells.size());
        const irsg::Atmosphere* const answering =
            path.environment.find(band(), AtmosphereProperty::transmittance);
        const auto air = irsg::airOfPath(answering, {.sensorAltitude_m = path.sensorAltitude_m,
                                                     .targetAltitude_m = path.gasAltitude_m,
                                                     .range_m = path.range_m});
        if (!air) {
            result_.warnings.push_back(
                "radiance and transmittance are products with means of the atmosphere: " +
                std::string(answering ? answering->name() : "it") +
                " does not tell which gases it holds, so the coincidence of lines is left out");
            return;
        }
        correlations_ = irsg::lineCorrelations(request_.gas, spectrum_.cells, *air, path.range_m);
        isCorrelated_ = true;
    }

    /// What the atmosphere leaves of the radiance of a cell, and of its transmittance.
    double before(std::size_t cell) const {
        return request_.path ? transmittance_[cell] * correlations_[cell].radiance : 1.0;
    }
    double beforeTransmittance(std::size_t cell) const {
        return request_.path ? transmittance_[cell] * correlations_[cell].transmittance : 1.0;
    }

    /// Stated, of the coincidence of lines: what samples differ from line by line by.
    double correlationError() const { return isCorrelated_ ? 0.03 : 0.0; }

    bool isThere(std::size_t emitter) const {
        return std::ranges::any_of(request_.gas.layers, [&](const irsg::GasLayer& layer) {
            return emitter < irsg::hotGasCount ? layer.moleFraction[emitter] > 0.0
                                               : layer.soot_ppmv > 0.0;
        });
    }

    void fillTable() {
        ResultTable& table = result_.table;
        const std::string unit(irsg::info(Quantity::spectralRadiance).unit);
        table.add(Quantity::wavenumber);
        table.add(Quantity::wavelength);
        table.add(Quantity::spectralRadiance);
        table.add(Quantity::transmittance);
        table.add("error_spectral_radiance", unit);
        for (std::size_t e = 0; e < irsg::gasEmitterCount; ++e)
            if (isThere(e))
                table.add("spectral_radiance_added_" + irsg::gasEmitterName(e), unit);
        if (request_.path) {
            table.add("spectral_radiance_product", unit);
            table.add("spectral_radiance_source", unit);
            table.add("transmittance_gas", "");
            table.add("transmittance_atmosphere", "");
            table.add(Quantity::pathRadiance);
        }
        for (std::size_t i = 0; i < spectrum_.cells.size(); ++i) {
            const GasSpectrum::Cell& cell = spectrum_.cells[i];
            const double tau = before(i);
            std::vector<double> row = {
                cell.wavenumber_per_cm, irsg::wavelengthFromWavenumber_um(cell.wavenumber_per_cm),
                cell.radiance_W_m2_sr_um * tau, cell.transmittance * beforeTransmittance(i),
                (cell.error_W_m2_sr_um + correlationError() * cell.radiance_W_m2_sr_um) * tau};
            for (std::size_t e = 0; e < irsg::gasEmitterCount; ++e)
                if (isThere(e))
                    row.push_back(cell.added_W_m2_sr_um[e] * tau);
            if (request_.path)
                row.insert(row.end(),
                           {cell.radiance_W_m2_sr_um * transmittance_[i], cell.radiance_W_m2_sr_um,
                            cell.transmittance, transmittance_[i], pathRadiance_[i]});
            table.addRow(row);
        }
    }

    /// Integral over the band of a column of the table.
    double integral(std::string_view key) const {
        const ResultColumn* const column = result_.table.find(key);
        double sum = 0.0;
        for (std::size_t i = 0; i < spectrum_.cells.size(); ++i)
            sum += column->values[i] *
                   (irsg::wavelengthFromWavenumber_um(spectrum_.cells[i].lower_per_cm) -
                    irsg::wavelengthFromWavenumber_um(spectrum_.cells[i].upper_per_cm));
        return sum;
    }

    void summarise() {
        const std::string unit(irsg::info(Quantity::radiance).unit);
        const auto add = [&](const std::string& label, double value, const std::string& of) {
            result_.summary.push_back({label, value, of});
        };
        add("band_radiance", integral("spectral_radiance"), unit);
        add("error_band_radiance", integral("error_spectral_radiance"), unit);
        add("band_transmittance", integral("transmittance") / band().width_um(), "");
        for (std::size_t e = 0; e < irsg::gasEmitterCount; ++e)
            if (isThere(e))
                add("band_radiance_added_" + irsg::gasEmitterName(e),
                    integral("spectral_radiance_added_" + irsg::gasEmitterName(e)), unit);
        if (request_.gas.source != irsg::GasSource::radcal) {
            irsg::GasRequest other = request_.gas;
            other.source = irsg::GasSource::radcal;
            const GasSpectrum radcal = irsg::gasSpectrum(other);
            add("band_radiance_source_radcal", radcal.bandRadiance_W_m2_sr(), unit);
            for (std::size_t i = 0; i < radcal.cells.size(); ++i)
                result_.radcal_W_m2_sr_um.push_back(radcal.cells[i].radiance_W_m2_sr_um *
                                                    before(i));
        }
        if (request_.path) {
            add("band_radiance_product", integral("spectral_radiance_product"), unit);
            add("band_radiance_source", integral("spectral_radiance_source"), unit);
            add("band_path_radiance", integral("path_radiance"), unit);
        }
    }

    void nameSources() {
        for (std::size_t g = 0; g < irsg::hotGasCount; ++g) {
            std::vector<std::string> words;
            for (const GasSpectrum::Cell& cell : spectrum_.cells)
                if (isThere(g))
                    irsg::appendUnique(
                        words, irsg::gasSourceNames[static_cast<std::size_t>(
                                   spectrum_.answers[g].at(cell.wavenumber_per_cm).source)]);
            result_.answeredBy[g] = fmt::format("{}", fmt::join(words, ", "));
        }
    }

    void writeProvenance() {
        Provenance& provenance = result_.table.provenance;
        provenance.add("program", irsg::programWithVersion());
        provenance.add("analysis", name(AnalysisKind::gas));
        if (!request_.commandLine.empty())
            provenance.add("command", request_.commandLine);
        for (const irsg::GasLayer& layer : request_.gas.layers)
            provenance.add("layer", gasLayerText(layer));
        provenance.add("band", fmt::format("{}-{} um", band().min_um, band().max_um));
        provenance.add("step [cm-1]", irsg::numberText(request_.gas.step_per_cm));
        if (request_.gas.background_K)
            provenance.add("background_temperature [K]",
                           irsg::numberText(*request_.gas.background_K));
        for (std::size_t g = 0; g < irsg::hotGasCount; ++g)
            if (isThere(g))
                provenance.add("source of " + irsg::gasEmitterName(g),
                               irsg::describe(spectrum_.answers[g]));
        if (const GasPath* const path = request_.path ? &*request_.path : nullptr) {
            for (const auto& atmosphere : path->environment.atmospheres())
                provenance.add("atmosphere", atmosphere->name());
            provenance.add("gas_altitude [m]", irsg::numberText(path->gasAltitude_m));
            provenance.add("sensor_altitude [m]", irsg::numberText(path->sensorAltitude_m));
            provenance.add("range [m]", irsg::numberText(path->range_m));
            provenance.add("correlation of lines",
                           isCorrelated_ ? "line by line at wavenumbers 0.2 cm-1 apart" : "none");
            for (const std::string& answer : answeredBy_)
                provenance.add("answered by", answer);
        }
        for (const SummaryItem& item : result_.summary)
            provenance.add(item.unit.empty() ? item.label : item.label + " [" + item.unit + "]",
                           irsg::numberText(item.value));
        for (const std::string& warning : result_.warnings)
            provenance.add("warning", warning);
    }

    const GasOutputRequest& request_;
    GasSpectrum spectrum_;
    std::vector<double> transmittance_, pathRadiance_; ///< of the atmosphere, cell by cell
    std::vector<irsg::LineCorrelation> correlations_;  ///< likewise
    bool isCorrelated_ = false;
    std::vector<std::string> answeredBy_;
    GasOutput result_;
};

} // namespace

GasOutput gasOutput(const GasOutputRequest& request) {
    return Output(request).make();
}

} // namespace smat
