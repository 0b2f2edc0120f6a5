#include "smatcore/tools/RadiativeOutput.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "irsg/core/Errors.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/radiance/SceneAtmosphere.h"
#include "irsg/radiometry/Units.h"

namespace smat {

namespace {

using irsg::AtmosphereProperty;
using irsg::Quantity;
using irsg::Spectrum;

const RadiativeQuantity& entryOf(AtmosphereProperty property) {
    const auto& known = radiativeQuantities();
    const auto found = std::ranges::find(known, property, &RadiativeQuantity::property);
    if (found == known.end()) {
        throw irsg::LogicError(std::string("a radiative output has no spectrum of ") +
                               irsg::name(property));
    }
    return *found;
}

/// What a quantity needs of the geometry, or "" where it has it.
std::string missingFor(AtmosphereProperty property, const PathGeometry& geometry) {
    switch (irsg::geometryOf(property)) {
    case irsg::QueryGeometry::path:
        return geometry.path ? ""
                             : "a sensor altitude, with a range and an elevation of the line of "
                               "sight or a target altitude, or with an elevation to space";
    case irsg::QueryGeometry::sight:
        return geometry.sight ? "" : "a sensor altitude and an elevation of the line of sight";
    default:
        return geometry.targetAltitude_m
                   ? ""
                   : "a target altitude, or a sensor altitude, an elevation of the line of sight "
                     "and a range";
    }
}

/// One request on its way to a table.
class Output {
  public:
    Output(const irsg::Environment& environment, const RadiativeRequest& request)
        : environment_(environment), request_(request), geometry_(solveGeometry(request.geometry)) {
        // What is behind a target is behind its apparent direction.
        if (geometry_.path && geometry_.sight && !request.geometry.losElevation_deg)
            geometry_.sight->elevation_rad =
                environment.targetView(*geometry_.path, request.band).elevation_rad;
    }

    RadiativeOutput make() {
        const std::vector<AtmosphereProperty> asked = answerable();
        for (const AtmosphereProperty property : asked)
            spectra_.emplace_back(property, ask(property));
        if (std::ranges::find(asked, AtmosphereProperty::transmittance) != asked.end())
            askLastMetres();
        fillTable();
        summarise();
        writeProvenance();
        return std::move(result_);
    }

  private:
    /// The quantities that geometry and air have a value for.
    std::vector<AtmosphereProperty> answerable() {
        std::vector<AtmosphereProperty> asked;
        std::vector<irsg::Diagnostic> diagnostics;
        for (const AtmosphereProperty property : request_.quantities) {
            const std::string missing = missingFor(property, geometry_);
            const bool hasAtmosphere = environment_.find(request_.band, property) != nullptr ||
                                       (property == AtmosphereProperty::backgroundRadiance &&
                                        environment_.defaultBackground.has_value());
            if (missing.empty() && (hasAtmosphere || !request_.leaveOutMissing)) {
                asked.push_back(property);
            } else if (request_.leaveOutMissing) {
                result_.warnings.push_back(std::string(irsg::name(property)) + " is left out: " +
                                           (missing.empty()
                                                ? "no atmosphere has it over the band"
                                                : "its geometry is not given: " + missing));
            } else {
                diagnostics.push_back(
                    {"geometry", irsg::name(property), "too little to know it", missing});
            }
        }
        if (!diagnostics.empty())
            throw irsg::InputError(std::move(diagnostics));
        if (asked.empty())
            sayWhyNothing();
        return asked;
    }

    /// Nothing is left of all quantities: the air says why for the first that the geometry would
    /// have allowed.
    void sayWhyNothing() {
        for (const AtmosphereProperty property : request_.quantities)
            if (missingFor(property, geometry_).empty())
                ask(property);
        throw irsg::InputError(
            irsg::Diagnostic{.file = "geometry",
                             .position = "",
                             .value = "too little for any quantity",
                             .expected = missingFor(AtmosphereProperty::transmittance, geometry_)});
    }

    std::string bandText() const {
        return fmt::format("{}-{} um", request_.band.min_um, request_.band.max_um);
    }

    Spectrum ask(AtmosphereProperty property) {
        const irsg::AtmosphericQuery query{.quantity = property,
                                           .path = geometry_.path.value_or(irsg::AtmosphericPath{}),
                                           .sight = geometry_.sight.value_or(irsg::LineOfSight{}),
                                           .altitude_m = geometry_.targetAltitude_m.value_or(0.0),
                                           .sun = environment_.sun};
        irsg::Provided<Spectrum> answer = environment_.spectrum(query, request_.band);
        result_.providedBy.push_back(std::string(irsg::name(property)) + ": " + answer.providedBy);
        return std::move(answer.value);
    }

    /// The way to the reference distances of measured spectra.
    void askLastMetres() {
        for (const double distance_m : request_.referenceDistances_m) {
            const bool isKnown = std::ranges::any_of(
                last_, [&](const auto& known) { return known.first == distance_m; });
            if (isKnown || !(distance_m > 0.0) || !(distance_m < geometry_.path->range_m))
                continue;
            irsg::AtmosphericQuery query = irsg::AtmosphericQuery::transmittance(
                irsg::nearTarget(*geometry_.path, distance_m));
            last_.emplace_back(distance_m, environment_.spectrum(query, request_.band).value);
        }
    }

    void fillTable() {
        std::vector<const Spectrum*> all;
        for (const auto& [property, spectrum] : spectra_)
            all.push_back(&spectrum);
        for (const auto& [distance_m, spectrum] : last_)
            all.push_back(&spectrum);
        const std::vector<double> axis = irsg::mergeAxes(all, request_.band);
        std::vector<std::vector<double>> values;
        result_.table.add(Quantity::wavenumber);
        result_.table.add(Quantity::wavelength);
        for (const auto& [property, spectrum] : spectra_) {
            result_.table.add(entryOf(property).quantity);
            values.push_back(spectrum.sample(axis));
        }
        for (const auto& [distance_m, spectrum] : last_) {
            result_.table.add("transmittance_last_" + irsg::numberText(distance_m) + "m", "");
            values.push_back(spectrum.sample(axis));
        }
        for (std::size_t i = axis.size(); i-- > 0;) {
            std::vector<double> row = {irsg::wavenumberFromWavelength_per_cm(axis[i]), axis[i]};
            for (const std::vector<double>& column : values)
                row.push_back(column[i]);
            result_.table.addRow(row);
        }
    }

    void summarise() {
        for (const auto& [property, spectrum] : spectra_) {
            const Spectrum* const factors[] = {&spectrum};
            const double integral = irsg::integrateProduct(factors, request_.band);
            const irsg::QuantityInfo& info = irsg::info(entryOf(property).quantity);
            if (info.unit.empty()) {
                result_.summary.push_back({"band_mean_" + std::string(info.key),
                                           integral / request_.band.width_um(), ""});
            } else {
                // "W m-2 sr-1 um-1" over um.
                const std::string unit(info.unit.substr(0, info.unit.rfind(' ')));
                result_.summary.push_back({"in_band_" + std::string(info.key), integral, unit});
            }
        }
        if (geometry_.targetAltitude_m)
            takeAmbientTemperature();
    }

    /// That of an atmosphere; the default of an environment is no property of the air.
    void takeAmbientTemperature() {
        for (const auto& atmosphere : environment_.atmospheres()) {
            if (atmosphere->supports(AtmosphereProperty::ambientTemperature)) {
                result_.summary.push_back(
                    {"ambient_temperature",
                     atmosphere->ambientTemperature_K(*geometry_.targetAltitude_m), "K"});
                result_.providedBy.push_back(
                    std::string(irsg::name(AtmosphereProperty::ambientTemperature)) + ": " +
                    atmosphere->name());
                return;
            }
        }
    }

    void writeProvenance() {
        Provenance& provenance = result_.table.provenance;
        const auto number = [&](const char* key, double value) {
            provenance.add(key, irsg::numberText(value));
        };
        // Angles were degrees before they were radians: twelve digits give back what was typed.
        const auto angle = [&](const char* key, double value_rad) {
            provenance.add(key, fmt::format("{:.12g}", irsg::degrees(value_rad)));
        };
        provenance.add("program", irsg::programWithVersion());
        provenance.add("analysis", name(AnalysisKind::radiative));
        if (!request_.commandLine.empty())
            provenance.add("command", request_.commandLine);
        for (const auto& atmosphere : environment_.atmospheres())
            provenance.add("atmosphere", atmosphere->name());
        provenance.add("band", bandText());
        if (geometry_.sight || geometry_.path) {
            number("sensor_altitude [m]", geometry_.path ? geometry_.path->sensorAltitude_m
                                                         : geometry_.sight->sensorAltitude_m);
        }
        if (geometry_.path) {
            number("target_altitude [m]", geometry_.path->targetAltitude_m);
            number("range [m]", geometry_.path->range_m);
        } else if (geometry_.targetAltitude_m) {
            number("target_altitude [m]", *geometry_.targetAltitude_m);
        }
        if (geometry_.sight)
            angle("los_elevation [deg]", geometry_.sight->elevation_rad);
        if (geometry_.sight || geometry_.path) {
            angle("los_azimuth [deg]",
                  geometry_.sight ? geometry_.sight->azimuth_rad : geometry_.path->azimuth_rad);
        }
        angle("sun_azimuth [deg]", environment_.sun.azimuth_rad);
        angle("sun_elevation [deg]", environment_.sun.elevation_rad);
        if (environment_.sun.distance_au != 1.0)
            number("sun_distance [au]", environment_.sun.distance_au);
        for (const SummaryItem& item : result_.summary) {
            provenance.add(item.unit.empty() ? item.label : item.label + " [" + item.unit + "]",
                           irsg::numberText(item.value));
        }
        for (const std::string& answer : result_.providedBy)
            provenance.add("answered by", answer);
        for (const std::string& warning : result_.warnings)
            provenance.add("warning", warning);
    }

    const irsg::Environment& environment_;
    const RadiativeRequest& request_;
    PathGeometry geometry_;
    std::vector<std::pair<AtmosphereProperty, Spectrum>> spectra_;
    std::vector<std::pair<double, Spectrum>> last_; ///< transmittance of so many metres
    RadiativeOutput result_;
};

} // namespace

const std::vector<RadiativeQuantity>& radiativeQuantities() {
    static const std::vector<RadiativeQuantity> entries = {
        {"transmittance", AtmosphereProperty::transmittance, Quantity::transmittance},
        {"path", AtmosphereProperty::pathRadiance, Quantity::pathRadiance},
        {"background", AtmosphereProperty::backgroundRadiance, Quantity::backgroundRadiance},
        {"sun", AtmosphereProperty::solarIrradiance, Quantity::solarIrradiance},
        {"up", AtmosphereProperty::upwardFlux, Quantity::upwardFlux},
        {"down", AtmosphereProperty::downwardFlux, Quantity::downwardFlux},
        {"scattering", AtmosphereProperty::scatteringOpticalDepth,
         Quantity::scatteringOpticalDepth}};
    return entries;
}

RadiativeOutput radiativeOutput(const irsg::Environment& environment,
                                const RadiativeRequest& request) {
    return Output(environment, request).make();
}

} // namespace smat
