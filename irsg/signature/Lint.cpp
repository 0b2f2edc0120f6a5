#include <algorithm>
#include <cmath>
#include <set>

#include "irsg/signature/EntryJson.h"
#include "irsg/signature/LintErrors.h"
#include "irsg/signature/LintSpectrum.h"
#include "irsg/signature/Utf8.h"

namespace irsg {

namespace {

using Severity = Finding::Severity;

/// Rounding that emissivity + transmissivity may carry above 1.
constexpr double sumTolerance = 1e-9;
constexpr double coldestSurface_K = 100.0;
constexpr double hottestSurface_K = 4000.0;

class Linter {
  public:
    explicit Linter(const SignatureDatabase& database) : database_(database) {}

    std::vector<Finding> run() {
        checkTexts();
        for (const auto& [index, material] : database_.materials) {
            checkMaterial(materialPath(index), material);
        }
        for (const auto& [index, entry] : database_.temperatures) {
            checkTerms(temperaturePath(index), entry);
            checkEmission(temperaturePath(index), entry);
        }
        for (const auto& [name, spectrum] : database_.spectra) {
            lintSpectrum(name, spectrum, findings_);
        }
        return std::move(findings_);
    }

  private:
    void error(std::string place, std::string value, const std::string& expected,
               std::string repair = "") {
        findings_.push_back({Severity::error, std::move(place), std::move(value),
                             "expected " + expected, std::move(repair)});
    }
    void warning(std::string place, std::string value, const std::string& expected,
                 std::string repair = "") {
        findings_.push_back({Severity::warning, std::move(place), std::move(value),
                             "expected " + expected, std::move(repair)});
    }

    void checkText(const std::string& path, const std::string& text) {
        if (!isUtf8(text)) {
            error(path, "bytes that are not UTF-8", "text in UTF-8");
        }
    }

    void checkTexts() {
        checkText("title", database_.title);
        checkText("notes", database_.notes);
        for (const auto& [index, material] : database_.materials) {
            checkText(materialPath(index) + ".name", material.name);
            checkText(materialPath(index) + ".notes", material.notes);
        }
        for (const auto& [index, entry] : database_.temperatures) {
            checkText(temperaturePath(index) + ".name", entry.name);
            checkText(temperaturePath(index) + ".notes", entry.notes);
            checkText(temperaturePath(index) + ".userSpectrum", entry.userSpectrum);
            for (const ComponentFactor& factor : entry.factors) {
                checkText(temperaturePath(index) + ".factors", factor.component);
            }
        }
        for (const auto& [name, spectrum] : database_.spectra) {
            checkText(spectrumPath(name), name);
            checkText(spectrumPath(name) + ".importedUnit", spectrum.importedUnit);
            checkText(spectrumPath(name) + ".notes", spectrum.notes);
            for (const SpectrumComponent& component : spectrum.components) {
                checkText(spectrumPath(name) + ".components", component.name);
            }
        }
    }

    void checkMaterial(const std::string& path, const Material& material) {
        const bool each = checkFraction(path + ".emissivity", material.emissivity) &
                          checkFraction(path + ".transmissivity", material.transmissivity);
        if (each) {
            checkSum(path, material);
        }
        if (!(material.nAngleFactor >= 0.0) || !std::isfinite(material.nAngleFactor)) {
            error(path + ".nAngleFactor", numberText(material.nAngleFactor),
                  "a number of at least 0");
        }
    }

    /// One finding a spectrum, at its worst node.
    bool checkFraction(const std::string& path, const Spectrum& spectrum) {
        if (!spectrum.isConstant() && spectrum.outside() != Spectrum::Outside::hold) {
            error(path, "a spectrum that is zero outside its axis",
                  "a surface property that holds its end values");
        }
        const auto& values = spectrum.values();
        double worst = 0.0;
        std::size_t where = values.size();
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double excess =
                std::isfinite(values[i]) ? std::max(-values[i], values[i] - 1.0) : HUGE_VAL;
            if (excess > worst) {
                worst = excess;
                where = i;
            }
        }
        if (where == values.size()) {
            return true;
        }
        const std::string at = spectrum.isConstant()
                                   ? ""
                                   : " at " + numberText(spectrum.wavelengths_um()[where]) + " um";
        error(path + at, numberText(values[where]), "a value from 0 to 1");
        return false;
    }

    void checkSum(const std::string& path, const Material& material) {
        std::vector<double> nodes_um = {1.0};
        for (const Spectrum* const each : {&material.emissivity, &material.transmissivity}) {
            nodes_um.insert(nodes_um.end(), each->wavelengths_um().begin(),
                            each->wavelengths_um().end());
        }
        const double worst_um = *std::ranges::min_element(
            nodes_um, {}, [&](double node_um) { return material.reflectivityAt(node_um); });
        const double reflectivity = material.reflectivityAt(worst_um);
        if (reflectivity < -sumTolerance) {
            const bool grey =
                material.emissivity.isConstant() && material.transmissivity.isConstant();
            error(path + (grey ? "" : " at " + numberText(worst_um) + " um"),
                  "emissivity + transmissivity = " + numberText(1.0 - reflectivity),
                  "a sum of at most 1", "lower one of the two");
        }
    }

    bool checkFinite(const std::string& path, double value) {
        if (!std::isfinite(value)) {
            error(path, numberText(value), "a finite number");
        }
        return std::isfinite(value);
    }

    void refuseLoop(const std::string& path, const LookupTable& table) {
        if (table.loop()) {
            error(path, "a table in loop mode", "a loop over time alone",
                  "switch the loop mode off");
        }
    }

    void checkTerms(const std::string& path, const TemperatureEntry& entry) {
        const TemperatureTerms& terms = entry.terms;
        const std::string at = path + ".terms.";
        const bool finite = checkFinite(at + "base_K", terms.base_K) &
                            checkFinite(at + "ambientFactor", terms.ambientFactor) &
                            checkFinite(at + "recoveryFactor", terms.recoveryFactor) &
                            checkFinite(at + "ambientOffset_K", terms.ambientOffset_K);
        refuseLoop(at + "power", terms.power);
        refuseLoop(at + "altitude_m", terms.altitude);
        refuseLoop(at + "mach", terms.mach);
        if (finite && entry.mode == EmissionMode::temperature) {
            checkRange(path, terms);
        }
    }

    /// The temperature at rest, and the coldest and hottest that the tables allow around it.
    void checkRange(const std::string& path, const TemperatureTerms& terms) {
        const double rest_K = surfaceTemperature_K(terms, EntityState{});
        const std::string celsius = "degrees Celsius taken for K? Add 273.15 to base_K";
        if (!(rest_K > 0.0)) {
            error(path, numberText(rest_K) + " K at rest", "a temperature above 0 K", celsius);
            return;
        }
        if (rest_K < coldestSurface_K || rest_K > hottestSurface_K) {
            warning(path, numberText(rest_K) + " K at rest",
                    "a temperature from 100 to 4000 K in air of 288.15 K",
                    rest_K < coldestSurface_K ? celsius : "");
            return;
        }
        double coldest_K = rest_K;
        double hottest_K = rest_K;
        const std::pair<const LookupTable*, double> terms_K[] = {
            {&terms.time, timeTerm_K(terms, EntityState{})},
            {&terms.power, powerTerm_K(terms, EntityState{})},
            {&terms.altitude, altitudeTerm_K(terms, EntityState{})},
            {&terms.mach, machTerm_K(terms, EntityState{})}};
        for (const auto& [table, now_K] : terms_K) {
            if (!table->empty()) {
                coldest_K += std::ranges::min(table->y()) - now_K;
                hottest_K += std::ranges::max(table->y()) - now_K;
            }
        }
        if (coldest_K < coldestSurface_K) {
            warning(path, numberText(coldest_K) + " K where the tables are lowest",
                    "a temperature of at least 100 K");
        }
        if (hottest_K > hottestSurface_K) {
            warning(path, numberText(hottest_K) + " K where the tables are highest",
                    "a temperature of at most 4000 K");
        }
    }

    void checkEmission(const std::string& path, const TemperatureEntry& entry) {
        const bool used = entry.mode == EmissionMode::userSpectrum;
        const auto spectrum = database_.spectra.find(entry.userSpectrum);
        const bool known = spectrum != database_.spectra.end();
        if (used && !known) {
            error(path + ".userSpectrum", "'" + entry.userSpectrum + "'",
                  "the name of a user-defined spectrum of this database");
        }
        std::set<std::string> seen;
        for (std::size_t i = 0; i < entry.factors.size(); ++i) {
            const ComponentFactor& factor = entry.factors[i];
            const std::string at = path + ".factors[" + std::to_string(i) + "]";
            if (used && known && spectrum->second.find(factor.component) == nullptr) {
                error(at + ".component", "'" + factor.component + "'",
                      "a component of the spectrum '" + entry.userSpectrum + "'");
            }
            if (!seen.insert(factor.component).second) {
                error(at + ".component", "'" + factor.component + "' a second time",
                      "one factor a component");
            }
            checkFactor(at, factor);
        }
    }

    void checkFactor(const std::string& path, const ComponentFactor& factor) {
        if (checkFinite(path + ".constant", factor.constant) && factor.constant < 0.0) {
            error(path + ".constant", numberText(factor.constant), "a factor of at least 0");
        }
        refuseLoop(path + ".angle_deg", factor.angle);
        for (const auto& [name, table] :
             {std::pair(".time_s", &factor.time), std::pair(".angle_deg", &factor.angle)}) {
            if (!table->empty() && std::ranges::min(table->y()) < 0.0) {
                error(path + name, numberText(std::ranges::min(table->y())),
                      "factors of at least 0");
            }
        }
        const auto& angles_deg = factor.angle.x();
        if (!factor.angle.empty() && (angles_deg.front() < 0.0 || angles_deg.back() > 180.0)) {
            error(path + ".angle_deg",
                  numberText(angles_deg.front()) + " to " + numberText(angles_deg.back()) + " deg",
                  "angles from 0 to 180 deg");
        }
    }

    const SignatureDatabase& database_;
    std::vector<Finding> findings_;
};

} // namespace

std::vector<Finding> lint(const SignatureDatabase& database) {
    return Linter(database).run();
}

std::vector<Finding> lint(const SignatureDatabase& database, const SpectralRange& band) {
    std::vector<Finding> findings = lint(database);
    const std::string wanted =
        "nodes from " + numberText(band.min_um) + " to " + numberText(band.max_um) + " um";
    const auto check = [&](const std::string& place, const Spectrum& spectrum,
                           const std::string& consequence) {
        if (!spectrum.covers(band)) {
            const auto& axis = spectrum.wavelengths_um();
            findings.push_back({Severity::warning, place,
                                numberText(axis.front()) + " to " + numberText(axis.back()) + " um",
                                "expected " + wanted + ": " + consequence, ""});
        }
    };
    for (const auto& [index, material] : database.materials) {
        const std::string held = "the end value is held outside";
        check(materialPath(index) + ".emissivity", material.emissivity, held);
        check(materialPath(index) + ".transmissivity", material.transmissivity, held);
    }
    for (const auto& [name, spectrum] : database.spectra) {
        // The components share their axis.
        if (!spectrum.components.empty()) {
            check(spectrumPath(name), spectrum.components.front().radiance,
                  "nothing is emitted outside");
        }
    }
    return findings;
}

std::vector<Offence> lintErrors(const SignatureDatabase& database, const std::string& file) {
    constexpr std::string_view prefix = "expected ";
    std::vector<Offence> offences;
    for (const Finding& finding : lint(database)) {
        if (finding.severity == Severity::error) {
            offences.push_back(
                {file, finding.place, finding.value, finding.reason.substr(prefix.size())});
        }
    }
    return offences;
}

void throwOnLintErrors(const SignatureDatabase& database, const std::string& file) {
    if (auto offences = lintErrors(database, file); !offences.empty()) {
        throw InputError(std::move(offences));
    }
}

} // namespace irsg
