#include "irsg/atmosphere/AtmosphereScatteringLut.h"

#include <cmath>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

constexpr const char* databaseName = "MTFDatabase";
constexpr const char* coefficientName = "ScatteringCoefficient";
constexpr double perKilometre = 1e-3;

} // namespace

AtmosphereScatteringLut::AtmosphereScatteringLut(std::filesystem::path database,
                                                 double coefficient_per_m)
    : database_(std::move(database)), coefficient_per_m_(coefficient_per_m) {
    if (!(coefficient_per_m >= 0.0) || !std::isfinite(coefficient_per_m))
        throw InputError({database_.string(), "scattering coefficient",
                          numberText(coefficient_per_m) + " m-1", "a finite number of at least 0"});
}

AtmosphereScatteringLut AtmosphereScatteringLut::fromKarma(const KarmaXml& document) {
    std::vector<Diagnostic> diagnostics;
    const KarmaParameter* database = document.find(databaseName);
    const KarmaParameter* coefficient = document.find(coefficientName);
    if (!database)
        diagnostics.push_back(
            document.diagnostic(databaseName, "nothing", "the path of an MTF database"));
    else if (database->kind != KarmaKind::string)
        diagnostics.push_back(document.diagnostic(*database,
                                                  std::string("a ") + irsg::name(database->kind),
                                                  "a string, the path of an MTF database"));
    if (coefficient &&
        (coefficient->kind != KarmaKind::number || !(coefficient->numbers.front() >= 0.0)))
        diagnostics.push_back(
            document.diagnostic(*coefficient,
                                coefficient->kind == KarmaKind::number
                                    ? numberText(coefficient->numbers.front())
                                    : std::string("a ") + irsg::name(coefficient->kind),
                                "a double of at least 0 km-1"));
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return AtmosphereScatteringLut(
        resolveKarmaPath(database->text, document.file(),
                         document.diagnostic(*database, "", "").position),
        coefficient ? perKilometre * coefficient->numbers.front() : 0.0);
}

std::string AtmosphereScatteringLut::name() const {
    return "AtmosphereScatteringLUT (" + database_.filename().string() + ")";
}

bool AtmosphereScatteringLut::supports(AtmosphereProperty property) const {
    return property == AtmosphereProperty::scatteringOpticalDepth && coefficient_per_m_ > 0.0;
}

AtmosphereDescription AtmosphereScatteringLut::describe() const {
    const std::string depth =
        coefficient_per_m_ > 0.0
            ? "scattering coefficient " + general(coefficient_per_m_ / perKilometre) + " km-1"
            : "scattering optical depth from the other atmospheres";
    return {{"MTF database " + database_.string(), depth},
            {{"mtf_database", {database_.string()}},
             {"scattering_coefficient_per_km", {coefficient_per_m_ / perKilometre}}}};
}

Spectrum AtmosphereScatteringLut::nativeSpectrum(const AtmosphericQuery& query,
                                                 const SpectralRange&) const {
    return Spectrum::constant(coefficient_per_m_ * query.path.range_m);
}

const AtmosphereScatteringLut* scatteringLutOf(const Environment& environment) {
    for (const auto& atmosphere : environment.atmospheres())
        if (const auto* lut = dynamic_cast<const AtmosphereScatteringLut*>(atmosphere.get()))
            return lut;
    return nullptr;
}

} // namespace irsg
