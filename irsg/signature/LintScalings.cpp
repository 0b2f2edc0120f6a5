#include "irsg/signature/LintScalings.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Collect.h"
#include "irsg/signature/Findings.h"
#include "irsg/signature/LintEntries.h"
#include "irsg/signature/SurfaceTemperature.h"

namespace irsg {

namespace {

/// Draws that nine in ten times stay within this part of [min, max] do not fill it.
constexpr double narrowPart = 0.01;
/// A scale of this size or more is rather percent than a fraction.
constexpr double percentScale = 10.0;

/// To five digits: what was computed is told no closer.
std::string shortText(double value) {
    if (value == 0.0)
        return "0";
    const double step = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 4.0);
    return numberText(step < 1.0 ? std::round(value / step) / std::round(1.0 / step)
                                 : std::round(value / step) * step);
}

/// The scales of one file.
class ScalingLint {
  public:
    ScalingLint(const SignatureDatabase& database, const ModelUse& model, const ScalingUse& use,
                ScalingKind kind, std::vector<Finding>& findings)
        : database_(database),
          model_(model),
          kind_(kind),
          file_(kind == ScalingKind::temperature ? use.temperatureFile : use.emissivityFile),
          findings_(findings) {}

    void lint(int index, const Distribution& scale) {
        if (scale.isFixed() && scale.minimum() == 1.0)
            return; // nothing is scaled: what saving a database writes for every entry
        index_ = index;
        lintFill(scale);
        if (const std::string why = idleBecause(); !why.empty())
            warn("a scale without effect", why, "take the scale out, or give it another index");
        else if (kind_ == ScalingKind::temperature)
            lintTemperature(scale);
        else if (!emitsSpectraAlone())
            lintEmissivity(scale);
    }

  private:
    void warn(std::string value, const std::string& expected, std::string repair) {
        const std::string entry =
            kind_ == ScalingKind::temperature ? temperaturePath(index_) : materialPath(index_);
        Finding& found = Findings(findings_, entry).warning("", std::move(value), expected);
        found.place = file_ + " " + std::to_string(index_);
        found.remedy = std::move(repair);
    }

    std::string idleBecause() const {
        const bool isTemperature = kind_ == ScalingKind::temperature;
        const auto entry = database_.temperatures.find(index_);
        if (isTemperature ? entry == database_.temperatures.end()
                          : !database_.materials.contains(index_)) {
            return "an index that the database has";
        }
        if (isTemperature && entry->second.mode == EmissionMode::userSpectrum)
            return "an index with a temperature; that of a user-defined spectrum is not scaled";
        const auto& faces = isTemperature ? model_.temperatureFaces : model_.materialFaces;
        const auto& fallback = isTemperature ? model_.fallbackTemperature : model_.fallbackMaterial;
        return faces.contains(index_) || fallback == index_ ? ""
                                                            : "an index on faces of " + model_.name;
    }

    /// Whether all faces of the material emit a user-defined spectrum, which is multiplied as it
    /// is.
    bool emitsSpectraAlone() const {
        const auto of = model_.temperaturesOfMaterial.find(index_);
        return of != model_.temperaturesOfMaterial.end() &&
               std::ranges::all_of(of->second, [this](int temperature) {
                   const auto entry = database_.temperatures.find(temperature);
                   return entry != database_.temperatures.end() &&
                          entry->second.mode == EmissionMode::userSpectrum;
               });
    }

    void lintFill(const Distribution& scale) {
        if (scale.isFixed())
            return;
        const double low = scale.at(0.05), high = scale.at(0.95);
        if (high - low >= narrowPart * (scale.maximum() - scale.minimum()))
            return;
        warn("nine draws in ten from " + shortText(low) + " to " + shortText(high),
             "draws that fill " + numberText(scale.minimum()) + " to " +
                 numberText(scale.maximum()) + ": the distribution " +
                 std::string(info(scale.kind()).name) + " does not reach all of it",
             "min and max where the distribution is, or other parameters");
    }

    void lintTemperature(const Distribution& scale) {
        // The terms themselves are looked at elsewhere.
        const double rest_K = surfaceTemperature_K(database_.temperatures.at(index_).terms, {});
        if (!(rest_K >= coldestSurface_K && rest_K <= hottestSurface_K))
            return;
        for (const double end : {scale.minimum(), scale.maximum()}) {
            const double scaled_K = rest_K * end;
            if (scaled_K >= coldestSurface_K && scaled_K <= hottestSurface_K)
                continue;
            const bool percent = scale.minimum() >= percentScale;
            warn(shortText(rest_K) + " K at rest, times " + numberText(end) + ": " +
                     shortText(scaled_K) + " K",
                 "100 to 4000 K" +
                     std::string(percent ? "; the scale looks like percent for a fraction" : ""),
                 percent ? "divide min and max by 100"
                         : "min of at least " + shortText(coldestSurface_K / rest_K) +
                               ", max of at most " + shortText(hottestSurface_K / rest_K));
            return;
        }
    }

    void lintEmissivity(const Distribution& scale) {
        const Material& material = database_.materials.at(index_);
        // The part that emissivity takes of what transmissivity leaves is largest at a node of
        // either.
        double most = 0.0, at_um = 0.0;
        std::vector<double> nodes_um = material.emissivity.wavelengths_um();
        const std::vector<double>& more_um = material.transmissivity.wavelengths_um();
        nodes_um.insert(nodes_um.end(), more_um.begin(), more_um.end());
        const bool isSpectral = !nodes_um.empty();
        if (!isSpectral)
            nodes_um.push_back(1.0); // grey: the same everywhere
        for (const double wavelength_um : nodes_um) {
            const double left = 1.0 - material.transmissivity.at(wavelength_um);
            const double part = left > 0.0 ? material.emissivity.at(wavelength_um) / left : 0.0;
            if (part > most) {
                most = part;
                at_um = wavelength_um;
            }
        }
        // Within rounding: 0.8 times 1.25 is 1. A sum beyond 1 is an error of the material itself.
        if (!(most <= 1.0 + 1e-6) || most * scale.maximum() <= 1.0 + 1e-9)
            return;
        const double emissivity = material.emissivity.at(at_um);
        const double limit = 1.0 - material.transmissivity.at(at_um);
        const bool percent = scale.minimum() >= percentScale;
        warn("emissivity " + numberText(emissivity) +
                 (isSpectral ? " at " + numberText(at_um) + " um" : "") + ", times " +
                 numberText(scale.maximum()) + ": " + shortText(emissivity * scale.maximum()),
             "at most " + shortText(limit) + (limit < 1.0 ? ", one less transmissivity" : "") +
                 "; what lies above is cut off there" +
                 (percent ? "; the scale looks like percent for a fraction" : ""),
             percent ? "divide min and max by 100" : "max of at most " + shortText(1.0 / most));
    }

    const SignatureDatabase& database_;
    const ModelUse& model_;
    ScalingKind kind_;
    const std::string& file_;
    std::vector<Finding>& findings_;
    int index_ = 0;
};

} // namespace

ScalingUse scalingUseOf(const std::filesystem::path& model) {
    ScalingUse use;
    const auto take = [&](ScalingKind kind, std::string& name, ScalingTable& table) {
        const auto file = scalingFile(model, kind);
        name = file.filename().string();
        if (std::filesystem::exists(file))
            collect(use.diagnostics, [&] { table = readScalingFile(file, kind); });
    };
    take(ScalingKind::temperature, use.temperatureFile, use.scalings.temperatures);
    take(ScalingKind::emissivity, use.emissivityFile, use.scalings.emissivities);
    return use;
}

std::vector<Finding> lintScalings(const SignatureDatabase& database, const ModelUse& model,
                                  const ScalingUse& use) {
    std::vector<Finding> findings;
    for (const Diagnostic& diagnostic : use.diagnostics) {
        Finding& found =
            Findings(findings, "model").error("", diagnostic.value, diagnostic.expected);
        found.place = std::filesystem::path(diagnostic.file).filename().string() +
                      (diagnostic.position.empty() ? "" : ", " + diagnostic.position);
        found.remedy = "repair the file where it was made; without it nothing is scaled";
    }
    for (const ScalingKind kind : {ScalingKind::temperature, ScalingKind::emissivity}) {
        ScalingLint lint(database, model, use, kind, findings);
        for (const auto& [index, entry] : use.scalings.of(kind))
            lint.lint(index, entry.distribution);
    }
    return findings;
}

} // namespace irsg
