#include <algorithm>

#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Steps between neighbouring wavenumbers.
std::pair<double, double> steps_per_cm(const std::vector<double>& wavenumbers_per_cm) {
    double least = wavenumbers_per_cm[1] - wavenumbers_per_cm[0];
    double most = least;
    for (std::size_t i = 2; i < wavenumbers_per_cm.size(); ++i) {
        least = std::min(least, wavenumbers_per_cm[i] - wavenumbers_per_cm[i - 1]);
        most = std::max(most, wavenumbers_per_cm[i] - wavenumbers_per_cm[i - 1]);
    }
    return {least, most};
}

AtmosphereFactList listOf(const std::vector<std::string>& texts) {
    AtmosphereFactList list;
    for (const std::string& text : texts)
        list.push_back({text});
    return list;
}

std::int64_t numberOf(std::size_t count) {
    return static_cast<std::int64_t>(count);
}

std::string lineOf(const SpectralRun& run) {
    const RunGeometry& geometry = run.geometry;
    return "  " + run.source + ": " + name(run.kind) + ", sensor " +
           general(geometry.sensorAltitude_m) + " m, target " + general(geometry.targetAltitude_m) +
           " m, range " + general(geometry.range_m, 7) + " m, elevation " +
           general(degrees(geometry.elevation_rad), 4) + " deg";
}

AtmosphereFacts factsOf(const SpectralRun& run) {
    AtmosphereFacts cards;
    for (const auto& [card, value] : run.cards)
        cards.push_back({card, {value}});
    return {{"source", {run.source}},
            {"kind", {std::string(name(run.kind))}},
            {"sensor_altitude_m", {run.geometry.sensorAltitude_m}},
            {"target_altitude_m", {run.geometry.targetAltitude_m}},
            {"range_m", {run.geometry.range_m}},
            {"elevation_rad", {run.geometry.elevation_rad}},
            {"cards", {std::move(cards)}}};
}

std::string lineOf(const InterpolationError& error) {
    const std::string what = "  " + error.quantity + " over " + error.axis;
    return error.isKnown()
               ? what + ": worst " + general(error.worst, 2) + ", rms " + general(error.rms, 2) +
                     " (" + std::to_string(error.nodes) + " nodes)"
               : what + ": not known, no run lies between two others";
}

AtmosphereFacts factsOf(const InterpolationError& error) {
    AtmosphereFacts facts = {
        {"quantity", {error.quantity}}, {"axis", {error.axis}}, {"nodes", {numberOf(error.nodes)}}};
    if (error.isKnown()) {
        facts.push_back({"worst", {error.worst}});
        facts.push_back({"rms", {error.rms}});
    }
    return facts;
}

} // namespace

AtmosphereDescription TabulatedAtmosphere::describe() const {
    const std::vector<double>& wavenumbers_per_cm = runs_.front().wavenumbers_per_cm;
    const auto [least, most] = steps_per_cm(wavenumbers_per_cm);
    const std::vector<InterpolationError> errors = interpolationErrors();
    AtmosphereFactList runs, errorList;

    std::vector<std::string> lines;
    lines.push_back(counted(wavenumbers_per_cm.size(), "wavenumber") + ", " +
                    general(wavenumbers_per_cm.front()) + " to " +
                    general(wavenumbers_per_cm.back()) + " cm-1, steps of " + general(least, 4) +
                    (most - least < 1e-6 ? "" : " to " + general(most, 4)) + " cm-1");
    std::ranges::copy(spans(), std::back_inserter(lines));
    lines.push_back(counted(runs_.size(), "run"));
    for (const SpectralRun& run : runs_) {
        lines.push_back(lineOf(run));
        runs.push_back({factsOf(run)});
    }
    lines.emplace_back("error of each node predicted from its neighbours (absolute for "
                       "transmittance, else of the largest value)");
    for (const InterpolationError& error : errors) {
        lines.push_back(lineOf(error));
        errorList.push_back({factsOf(error)});
    }
    for (const std::string& warning : warnings())
        lines.push_back("warning: " + warning);

    AtmosphereFacts facts = {{"wavenumbers", {numberOf(wavenumbers_per_cm.size())}},
                             {"first_cm-1", {wavenumbers_per_cm.front()}},
                             {"last_cm-1", {wavenumbers_per_cm.back()}},
                             {"least_step_cm-1", {least}},
                             {"largest_step_cm-1", {most}},
                             {"runs", {std::move(runs)}},
                             {"spans", {listOf(spans())}},
                             {"interpolation_errors", {std::move(errorList)}},
                             {"warnings", {listOf(warnings())}}};
    return {std::move(lines), {{"table", {std::move(facts)}}}};
}

} // namespace irsg
