#include "irsg/signature/SpectrumCsv.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/FileReplacement.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/CsvAxis.h"

namespace irsg {

namespace {

std::optional<SpectralRadianceUnit> readUnit(const CsvTable& table,
                                             std::optional<SpectralRadianceUnit> given,
                                             std::vector<Offence>& offences) {
    if (given) {
        return given;
    }
    const CsvComment* const comment = table.comment("unit");
    if (comment == nullptr) {
        offences.push_back(
            table.offence("no unit of radiance",
                          "a line '# unit: W cm-2 sr-1 (cm-1)-1', or the unit chosen on import"));
        return std::nullopt;
    }
    try {
        return SpectralRadianceUnit::parse(comment->value);
    } catch (const InputError& error) {
        offences.push_back(
            table.offence(comment->line, comment->value, error.offences().front().expected));
        return std::nullopt;
    }
}

double readDistance_m(const CsvTable& table, std::optional<double> given_m,
                      std::vector<Offence>& offences) {
    constexpr const char* expected = "a distance of at least 0 m";
    if (given_m) {
        if (!(*given_m >= 0.0) || !std::isfinite(*given_m)) {
            offences.push_back(
                {table.file(), "reference distance", numberText(*given_m), expected});
        }
        return *given_m;
    }
    const CsvComment* const comment = table.comment("reference_distance_m");
    if (comment == nullptr) {
        return 0.0;
    }
    const double distance_m = table.number(*comment, offences, expected).value_or(0.0);
    if (distance_m < 0.0) {
        offences.push_back(table.offence(comment->line, comment->value, expected));
    }
    return distance_m;
}

} // namespace

UserSpectrum readSpectrumCsv(const std::filesystem::path& file,
                             std::optional<SpectralRadianceUnit> unit,
                             std::optional<double> referenceDistance_m) {
    const CsvTable table = CsvTable::read(file);
    std::vector<Offence> offences;
    const CsvColumns columns = readColumns(table, 2, offences);
    const SpectralAxis axis = readSpectralAxis(table, columns, offences);
    const auto radianceUnit = readUnit(table, unit, offences);
    UserSpectrum spectrum;
    spectrum.referenceDistance_m = readDistance_m(table, referenceDistance_m, offences);
    if (offences.empty()) {
        checkSpectralAxis(table, columns, offences);
    }
    if (!offences.empty()) {
        throw InputError(std::move(offences));
    }

    // The axis in um, with what makes a value of each node one in W m-2 sr-1 um-1.
    std::vector<double> wavelengths_um = wavelengthsOf(columns, axis);
    std::vector<double> factors;
    for (std::size_t i = 0; i < wavelengths_um.size(); ++i) {
        const double wavenumber_cm1 = axis == SpectralAxis::wavenumber
                                          ? columns.axis[i]
                                          : wavenumberFromWavelength_cm1(wavelengths_um[i]);
        factors.push_back(radianceUnit->perWavenumber
                              ? perMicrometreFromPerWavenumber(radianceUnit->toW_m2, wavenumber_cm1)
                              : radianceUnit->toW_m2);
    }
    const bool descending = wavelengths_um.back() < wavelengths_um.front();
    if (descending) {
        std::ranges::reverse(wavelengths_um);
    }

    spectrum.name = file.stem().string();
    spectrum.importedUnit = radianceUnit->text();
    for (std::size_t i = 0; i < columns.names.size(); ++i) {
        std::vector<double> radiance;
        for (std::size_t k = 0; k < factors.size(); ++k) {
            radiance.push_back(columns.values[i][k] * factors[k]);
        }
        if (descending) {
            std::ranges::reverse(radiance);
        }
        const std::string& name = columns.names[i].text;
        spectrum.components.push_back(
            {name, Spectrum(wavelengths_um, std::move(radiance), Spectrum::Outside::zero,
                            table.file() + ": " + name)});
    }
    return spectrum;
}

void writeSpectrumCsv(const UserSpectrum& spectrum, const std::filesystem::path& file) {
    if (spectrum.components.empty()) {
        throw LogicError("a spectrum without components cannot be written");
    }
    const auto& axis_um = spectrum.components.front().radiance.wavelengths_um();
    std::string text = "# unit: " + SpectralRadianceUnit{}.text() +
                       "\n# reference_distance_m: " + numberText(spectrum.referenceDistance_m) +
                       "\num";
    for (const SpectrumComponent& component : spectrum.components) {
        if (component.radiance.wavelengths_um() != axis_um) {
            throw LogicError("components of '" + spectrum.name + "' without one shared axis");
        }
        text += "," + csvCell(component.name);
    }
    text += "\n";
    for (std::size_t i = 0; i < axis_um.size(); ++i) {
        text += numberText(axis_um[i]);
        for (const SpectrumComponent& component : spectrum.components) {
            text += "," + numberText(component.radiance.values()[i]);
        }
        text += "\n";
    }

    writeFileDurably(file, text);
}

} // namespace irsg
