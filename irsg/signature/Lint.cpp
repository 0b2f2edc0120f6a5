#include "irsg/signature/Lint.h"

#include <set>

#include "irsg/core/Errors.h"
#include "irsg/signature/Findings.h"
#include "irsg/signature/LintEntries.h"
#include "irsg/signature/LintErrors.h"
#include "irsg/signature/LintFields.h"

namespace irsg {

namespace {

/// A repair can bring another fault to light; more rounds than this would go in a circle.
constexpr int mostRounds = 8;

/// What no field of an entry says: of the database, and names of spectra and components.
void lintTexts(const SignatureDatabase& database, std::vector<Finding>& findings) {
    const auto check = [&](const std::string& entry, const std::string& place,
                           const std::string& text) {
        Findings ofEntry(findings, entry);
        lintText(place, text, ofEntry);
    };
    check("title", "", database.title);
    check("notes", "", database.notes);
    for (const auto& [name, spectrum] : database.spectra) {
        check(spectrumPath(name), "", name);
        for (const SpectrumComponent& component : spectrum.components)
            check(spectrumPath(name), ".components", component.name);
    }
}

} // namespace

void lintCoverage(const SignatureDatabase& database, const SpectralRange& band,
                  std::vector<Finding>& findings) {
    const std::string wanted =
        "nodes from " + numberText(band.min_um) + " to " + numberText(band.max_um) + " um";
    const auto check = [&](const std::string& entry, const std::string& place,
                           const Spectrum& spectrum, const std::string& consequence) {
        if (!spectrum.covers(band)) {
            const auto& axis = spectrum.wavelengths_um();
            const bool apart = axis.back() <= band.min_um || axis.front() >= band.max_um;
            Findings(findings, entry)
                .warning(place, numberText(axis.front()) + " to " + numberText(axis.back()) + " um",
                         wanted + ": " + consequence + (apart ? ": no node is near it" : ""));
        }
    };
    for (const auto& [index, material] : database.materials) {
        forEachField<Spectrum>(materialFields(),
                               [&, &index = index, &of = material](const auto& field, auto member) {
                                   check(materialPath(index), std::string(".") + field.key,
                                         of.*member, "a picture over this band is refused");
                               });
    }
    for (const auto& [name, spectrum] : database.spectra) {
        // The components share their axis.
        if (!spectrum.components.empty()) {
            check(spectrumPath(name), "", spectrum.components.front().radiance,
                  "nothing is emitted outside");
        }
    }
}

std::vector<Finding> lint(const SignatureDatabase& database, const LintScope& scope) {
    std::vector<Finding> findings;
    lintTexts(database, findings);
    for (const auto& [index, material] : database.materials)
        lintMaterial(index, material, scope.bands, findings);
    for (const auto& [index, entry] : database.temperatures) {
        lintTerms(index, entry, findings);
        lintEmission(index, entry, database, findings);
    }
    for (const auto& [name, spectrum] : database.spectra)
        lintSpectrum(name, spectrum, scope.bands, findings);
    for (const SpectralRange& band : scope.bands)
        lintCoverage(database, band, findings);
    lintUse(database, scope.models, findings);
    lintStates(database, scope.states, findings);
    return findings;
}

std::vector<Finding> lint(const SignatureDatabase& database, const SpectralRange& band) {
    return lint(database, LintScope{.bands = {band}});
}

std::vector<Finding> repairAll(SignatureDatabase& database, const LintScope& scope) {
    std::vector<Finding> repaired;
    std::set<std::string> before;
    for (int round = 0; round < mostRounds; ++round) {
        // One repair a place and a round: the next may no longer be right once the first is made.
        std::set<std::string> touched;
        for (const Finding& finding : lint(database, scope)) {
            const bool wanted = finding.repair && !finding.removes;
            if (wanted && before.insert(finding.place + "|" + finding.value).second &&
                touched.insert(finding.place).second) {
                finding.repair(database);
                repaired.push_back(finding);
            }
        }
        if (touched.empty())
            break;
    }
    return repaired;
}

std::vector<Diagnostic> lintErrors(const SignatureDatabase& database, const std::string& file) {
    constexpr std::string_view prefix = "expected ";
    std::vector<Diagnostic> diagnostics;
    for (const Finding& finding : lint(database)) {
        if (finding.isError()) {
            diagnostics.push_back(
                {file, finding.place, finding.value,
                 finding.reason.substr(prefix.size()) +
                     (finding.remedy.empty() ? "" : " (" + finding.remedy + ")")});
        }
    }
    return diagnostics;
}

void throwOnLintErrors(const SignatureDatabase& database, const std::string& file) {
    if (auto diagnostics = lintErrors(database, file); !diagnostics.empty())
        throw InputError(std::move(diagnostics));
}

} // namespace irsg
