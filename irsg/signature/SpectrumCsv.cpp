#include "irsg/signature/SpectrumCsv.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/CsvAxis.h"

namespace irsg {

namespace {

/// A unit within the head of a column, and what is left of the head: "CO2 [W m-2 sr-1 um-1]" is
/// CO2, and "radiance_mW/cm2/sr/nm" is radiance.
struct HeadUnit {
    std::string name, unit;
};
std::optional<HeadUnit> unitInHead(const std::string& head) {
    const auto isUnit = [](const std::string& text) {
        try {
            SpectralRadianceUnit::parse(text);
            return true;
        } catch (const InputError&) {
            return false;
        }
    };
    const std::size_t open = head.find_first_of("[(");
    if (open != std::string::npos && (head.ends_with(']') || head.ends_with(')'))) {
        const std::string inside = head.substr(open + 1, head.size() - open - 2);
        if (isUnit(inside))
            return HeadUnit{std::string(trimmed(head.substr(0, open))), inside};
    }
    for (const char separator : {'_', '/', ',', ' '}) {
        const std::size_t at = head.find(separator);
        if (at != std::string::npos && isUnit(head.substr(at + 1)))
            return HeadUnit{std::string(trimmed(head.substr(0, at))), head.substr(at + 1)};
    }
    return std::nullopt;
}

/// The unit that is given, else that of the comment, else the one that all heads name, which are
/// then left without it.
std::optional<SpectralRadianceUnit> readUnit(const CsvTable& table,
                                             std::optional<SpectralRadianceUnit> given,
                                             CsvColumns& columns,
                                             std::vector<Diagnostic>& diagnostics) {
    const CsvComment* const comment = table.comment("unit");
    std::optional<SpectralRadianceUnit> unit = given;
    if (!unit && comment != nullptr) {
        try {
            unit = SpectralRadianceUnit::parse(comment->value);
        } catch (const InputError& error) {
            diagnostics.push_back(table.diagnostic(comment->line, comment->value,
                                                   error.diagnostics().front().expected));
            return std::nullopt;
        }
    }
    for (CsvCell& name : columns.names) {
        const std::optional<HeadUnit> inHead = unitInHead(name.text);
        if (!inHead)
            continue;
        const auto own = SpectralRadianceUnit::parse(inHead->unit);
        if (unit && !given && *unit != own)
            diagnostics.push_back(table.diagnostic(name, "the unit " + unit->text() +
                                                             " that stands above or before it"));
        if (!unit)
            unit = own;
        name.text = inHead->name.empty() ? "radiance" : inHead->name;
    }
    if (!unit)
        diagnostics.push_back(table.diagnostic(
            "no unit of radiance",
            "a line '# unit: W cm-2 sr-1 (cm-1)-1', or the unit chosen on import"));
    return unit;
}

double readDistance_m(const CsvTable& table, std::optional<double> given_m,
                      std::vector<Diagnostic>& diagnostics) {
    constexpr const char* expected = "a distance of at least 0 m";
    if (given_m) {
        if (!(*given_m >= 0.0) || !std::isfinite(*given_m)) {
            diagnostics.push_back(
                {table.file(), "reference distance", numberText(*given_m), expected});
        }
        return *given_m;
    }
    const CsvComment* const comment = table.comment("reference_distance_m");
    if (comment == nullptr)
        return 0.0;
    const double distance_m = table.number(*comment, diagnostics, expected).value_or(0.0);
    if (distance_m < 0.0)
        diagnostics.push_back(table.diagnostic(comment->line, comment->value, expected));
    return distance_m;
}

} // namespace

UserSpectrum readSpectrumCsv(const std::filesystem::path& file,
                             std::optional<SpectralRadianceUnit> unit,
                             std::optional<double> referenceDistance_m) {
    const CsvTable table = CsvTable::read(file);
    std::vector<Diagnostic> diagnostics;
    CsvColumns columns = readColumns(table, 2, diagnostics);
    const SpectralAxis axis = readSpectralAxis(table, columns, diagnostics);
    const auto radianceUnit = readUnit(table, unit, columns, diagnostics);
    UserSpectrum spectrum;
    spectrum.referenceDistance_m = readDistance_m(table, referenceDistance_m, diagnostics);
    if (diagnostics.empty())
        checkSpectralAxis(table, columns, diagnostics);
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));

    // The axis in um, with what makes a value of each node one in W m-2 sr-1 um-1.
    std::vector<double> wavelengths_um = wavelengthsOf(columns, axis);
    std::vector<double> factors;
    for (std::size_t i = 0; i < wavelengths_um.size(); ++i) {
        const double wavenumber_per_cm = axis == SpectralAxis::wavenumber
                                             ? columns.axis[i]
                                             : wavenumberFromWavelength_per_cm(wavelengths_um[i]);
        factors.push_back(radianceUnit->perWavenumber ? perMicrometreFromPerWavenumber(
                                                            radianceUnit->toW_m2, wavenumber_per_cm)
                                                      : radianceUnit->toW_m2);
    }
    const bool descending = wavelengths_um.back() < wavelengths_um.front();
    if (descending)
        std::ranges::reverse(wavelengths_um);

    spectrum.name = file.stem().string();
    spectrum.importedUnit = radianceUnit->text();
    for (std::size_t i = 0; i < columns.names.size(); ++i) {
        std::vector<double> radiance;
        for (std::size_t k = 0; k < factors.size(); ++k)
            radiance.push_back(columns.values[i][k] * factors[k]);
        if (descending)
            std::ranges::reverse(radiance);
        const std::string& name = columns.names[i].text;
        spectrum.components.push_back(
            {name, Spectrum(wavelengths_um, std::move(radiance), Spectrum::Outside::zero,
                            table.file() + ": " + name)});
    }
    return spectrum;
}

void writeSpectrumCsv(const UserSpectrum& spectrum, const std::filesystem::path& file) {
    if (spectrum.components.empty())
        throw LogicError("a spectrum without components cannot be written");
    const auto& axis_um = spectrum.components.front().radiance.wavelengths_um();
    std::string text = "# unit: " + SpectralRadianceUnit{}.text() +
                       "\n# reference_distance_m: " + numberText(spectrum.referenceDistance_m) +
                       "\num";
    for (const SpectrumComponent& component : spectrum.components) {
        if (component.radiance.wavelengths_um() != axis_um)
            throw LogicError("components of '" + spectrum.name + "' without one shared axis");
        text += "," + csvCell(component.name);
    }
    text += "\n";
    for (std::size_t i = 0; i < axis_um.size(); ++i) {
        text += numberText(axis_um[i]);
        for (const SpectrumComponent& component : spectrum.components)
            text += "," + numberText(spectrum.calibrationFactor * component.radiance.values()[i]);
        text += "\n";
    }

    writeFileDurably(file, text);
}

} // namespace irsg
