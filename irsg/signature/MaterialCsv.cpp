#include "irsg/signature/MaterialCsv.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/FileReplacement.h"
#include "irsg/signature/CsvAxis.h"

namespace irsg {

namespace {

constexpr std::array<const char*, 3> properties = {"emissivity", "transmissivity", "reflectivity"};
constexpr SpectralRange greyAxis{0.3, 30.0};

/// The column of each property, or none.
using Columns = std::array<std::optional<std::size_t>, 3>;

Columns columnsOf(const CsvTable& table, const CsvColumns& columns,
                  std::vector<Diagnostic>& diagnostics) {
    Columns found;
    for (std::size_t i = 0; i < columns.names.size(); ++i) {
        const auto property = std::ranges::find(properties, columns.names[i].text);
        if (property == properties.end()) {
            diagnostics.push_back(table.diagnostic(
                columns.names[i], "'emissivity', 'transmissivity' or 'reflectivity'"));
        } else {
            found[static_cast<std::size_t>(property - properties.begin())] = i;
        }
    }
    return found;
}

void checkFractions(const CsvTable& table, const CsvColumns& columns,
                    std::vector<Diagnostic>& diagnostics) {
    for (const auto& column : columns.cells) {
        for (const CsvCell& cell : column) {
            const double value = parseNumber(cell.text).value_or(0.0);
            if (value < 0.0 || value > 1.0) {
                diagnostics.push_back(table.diagnostic(
                    cell, value > 1.5 && value <= 100.0 ? "a fraction from 0 to 1, not percent"
                                                        : "a value from 0 to 1"));
            }
        }
    }
}

struct Fractions {
    double emissivity = 1.0;
    double transmissivity = 0.0;
};

/// The two that are kept, from those that are given.
Fractions close(const std::array<std::optional<double>, 3>& given) {
    const auto& [emissivity, transmissivity, reflectivity] = given;
    if (emissivity && transmissivity)
        return {*emissivity, *transmissivity};
    if (emissivity)
        return {*emissivity, reflectivity ? 1.0 - *emissivity - *reflectivity : 0.0};
    const double passed = transmissivity.value_or(0.0);
    return {1.0 - passed - reflectivity.value_or(0.0), passed};
}

std::string sumText(const std::array<std::optional<double>, 3>& given) {
    double sum = 0.0;
    std::string names;
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (given[i]) {
            sum += *given[i];
            names += (names.empty() ? "" : " + ") + std::string(properties[i]);
        }
    }
    return names + " = " + numberText(std::round(sum * 1e9) / 1e9);
}

} // namespace

void readMaterialCsv(const std::filesystem::path& file, Material& material) {
    const CsvTable table = CsvTable::read(file);
    std::vector<Diagnostic> diagnostics;
    const CsvColumns columns = readColumns(table, 2, diagnostics);
    const SpectralAxis axis = readSpectralAxis(table, columns, diagnostics);
    const Columns where = columnsOf(table, columns, diagnostics);
    if (diagnostics.empty()) {
        checkSpectralAxis(table, columns, diagnostics);
        checkFractions(table, columns, diagnostics);
    }

    // Row by row, what is given and what follows from it.
    std::vector<double> emissivity;
    std::vector<double> transmissivity;
    for (std::size_t i = 0; diagnostics.empty() && i < columns.axis.size(); ++i) {
        std::array<std::optional<double>, 3> given;
        for (std::size_t property = 0; property < given.size(); ++property)
            if (where[property])
                given[property] = columns.values[*where[property]][i];
        const Fractions closed = close(given);
        const double left = 1.0 - closed.emissivity - closed.transmissivity;
        const bool impossible =
            left < -1e-9 || closed.emissivity < -1e-9 || closed.transmissivity < -1e-9;
        const bool open =
            given[0] && given[1] && given[2] && std::abs(left - *given[2]) > closureTolerance;
        if (impossible || open) {
            diagnostics.push_back(table.diagnostic(columns.axisCells[i].line, sumText(given),
                                                   open ? "a sum of 1" : "a sum of at most 1"));
        }
        emissivity.push_back(std::max(closed.emissivity, 0.0));
        transmissivity.push_back(std::max(closed.transmissivity, 0.0));
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));

    std::vector<double> wavelengths_um = wavelengthsOf(columns, axis);
    if (wavelengths_um.back() < wavelengths_um.front()) {
        std::ranges::reverse(wavelengths_um);
        std::ranges::reverse(emissivity);
        std::ranges::reverse(transmissivity);
    }
    const bool opaque = std::ranges::all_of(transmissivity, [](double t) { return t == 0.0; });
    material.transmissivity = opaque ? Spectrum()
                                     : Spectrum(wavelengths_um, std::move(transmissivity),
                                                Spectrum::Outside::hold, table.file());
    material.emissivity = Spectrum(std::move(wavelengths_um), std::move(emissivity),
                                   Spectrum::Outside::hold, table.file());
}

void writeMaterialCsv(const Material& material, const std::filesystem::path& file) {
    const Spectrum* const spectra[] = {&material.emissivity, &material.transmissivity};
    std::vector<double> axis_um;
    for (const Spectrum* const spectrum : spectra) {
        axis_um.insert(axis_um.end(), spectrum->wavelengths_um().begin(),
                       spectrum->wavelengths_um().end());
    }
    if (axis_um.empty())
        axis_um = {greyAxis.min_um, greyAxis.max_um};
    std::ranges::sort(axis_um);
    axis_um.erase(std::ranges::unique(axis_um).begin(), axis_um.end());

    std::string text = "um,emissivity,transmissivity,reflectivity\n";
    for (const double wavelength_um : axis_um) {
        text += numberText(wavelength_um);
        for (const double value :
             {material.emissivity.at(wavelength_um), material.transmissivity.at(wavelength_um),
              std::max(material.reflectivityAt(wavelength_um), 0.0)}) {
            text += "," + numberText(value);
        }
        text += "\n";
    }
    writeFileDurably(file, text);
}

} // namespace irsg
