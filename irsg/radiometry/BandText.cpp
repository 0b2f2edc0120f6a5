#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "irsg/core/CsvTable.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

enum class AxisUnit { micrometres, wavenumbers };

/// How far a response that is linear in cm-1 may stray from its straight pieces in um, relative to
/// its largest value.
constexpr double conversionTolerance = 1e-7;

std::optional<AxisUnit> axisUnitOf(const std::string& header) {
    if (header == "um" || header == "wavelength [um]")
        return AxisUnit::micrometres;
    if (header == "cm-1" || header == "wavenumber [cm-1]")
        return AxisUnit::wavenumbers;
    return std::nullopt;
}

struct ResponseNodes {
    std::vector<double> axis;
    std::vector<double> values;
};

/// The two columns below the header; diagnostics are added for every cell that is wrong.
ResponseNodes readNodes(const CsvTable& table, std::vector<Diagnostic>& diagnostics) {
    ResponseNodes nodes;
    for (std::size_t i = 1; i < table.rows().size(); ++i) {
        const CsvRow& row = table.rows()[i];
        if (row.cells.size() != 2) {
            diagnostics.push_back(
                table.diagnostic(row.line, std::to_string(row.cells.size()) + " cells",
                                 "two cells: the wavelength or wavenumber and the response"));
            continue;
        }
        const auto x = table.number(row.cells[0], diagnostics, "a positive number");
        const auto y = table.number(row.cells[1], diagnostics, "a response of at least 0");
        if (x && *x <= 0.0) {
            diagnostics.push_back(table.diagnostic(row.cells[0], "a positive number"));
        } else if (x && !nodes.axis.empty() && *x <= nodes.axis.back()) {
            diagnostics.push_back(
                table.diagnostic(row.cells[0], "more than " + numberText(nodes.axis.back()) +
                                                   ": the axis ascends strictly"));
        }
        if (y && *y < 0.0)
            diagnostics.push_back(table.diagnostic(row.cells[1], "a response of at least 0"));
        if (x && y) {
            nodes.axis.push_back(*x);
            nodes.values.push_back(*y);
        }
    }
    return nodes;
}

/// Nodes over ascending wavenumbers as nodes over ascending wavelengths.
ResponseNodes inWavelength(const ResponseNodes& wavenumbers) {
    // Over a step of wavenumbers from nu to nu + d, the chord in wavelength of what is linear in
    // wavenumber is wrong by less than |dR| d / 4 nu, and by n^2 times less on n equal parts.
    const double largest = *std::ranges::max_element(wavenumbers.values);
    ResponseNodes result;
    const auto add = [&result](double wavenumber_per_cm, double value) {
        const double wavelength_um = wavelengthFromWavenumber_um(wavenumber_per_cm);
        if (result.axis.empty() || wavelength_um > result.axis.back()) {
            result.axis.push_back(wavelength_um);
            result.values.push_back(value);
        }
    };
    for (std::size_t i = wavenumbers.axis.size() - 1; i > 0; --i) {
        const double high = wavenumbers.axis[i];
        const double low = wavenumbers.axis[i - 1];
        const double deviation = std::abs(wavenumbers.values[i] - wavenumbers.values[i - 1]) *
                                 (high - low) / (4.0 * low);
        const double parts = deviation > 0.0
                                 ? std::ceil(std::sqrt(deviation / (conversionTolerance * largest)))
                                 : 1.0;
        for (double part = 0.0; part < parts; part += 1.0) {
            const double t = part / parts;
            add(std::lerp(high, low, t),
                std::lerp(wavenumbers.values[i], wavenumbers.values[i - 1], t));
        }
    }
    add(wavenumbers.axis.front(), wavenumbers.values.front());
    return result;
}

} // namespace

Band Band::fromCsv(const std::filesystem::path& file) {
    const CsvTable table = CsvTable::read(file);
    if (table.rows().empty())
        throw InputError(table.diagnostic("no rows", "a header and at least two rows of numbers"));
    std::vector<Diagnostic> diagnostics;
    const CsvRow& header = table.rows().front();
    const auto unit = axisUnitOf(header.cells.front().text);
    if (!unit) {
        diagnostics.push_back(table.diagnostic(header.cells.front(),
                                               "'um', 'cm-1', 'wavelength [um]' or "
                                               "'wavenumber [cm-1]'"));
    }
    if (header.cells.size() != 2) {
        diagnostics.push_back(
            table.diagnostic(header.line, std::to_string(header.cells.size()) + " cells",
                             "two cells: the wavelength or wavenumber and the response"));
    }

    ResponseNodes nodes = readNodes(table, diagnostics);
    if (diagnostics.empty() && nodes.axis.size() < 2) {
        diagnostics.push_back(
            table.diagnostic(std::to_string(nodes.axis.size()) + " rows of numbers",
                             "at least two rows of numbers"));
    }
    if (diagnostics.empty() && *std::ranges::max_element(nodes.values) <= 0.0) {
        diagnostics.push_back(
            table.diagnostic("a response that is 0 everywhere", "a positive area"));
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    if (*unit == AxisUnit::wavenumbers)
        nodes = inWavelength(nodes);
    return fromResponse(
        {std::move(nodes.axis), std::move(nodes.values), Spectrum::Outside::zero, table.file()},
        file.filename().string());
}

Band Band::fromText(const std::string& text) {
    // The dash between two numbers is the one that neither opens the text nor follows an exponent.
    for (std::size_t dash = text.find('-', 1); dash != std::string::npos;
         dash = text.find('-', dash + 1)) {
        const auto min_um = parseNumber(text.substr(0, dash));
        const auto max_um = parseNumber(text.substr(dash + 1));
        if (min_um && max_um && *min_um > 0.0 && *min_um < *max_um)
            return topHat(*min_um, *max_um);
    }
    throw InputError({"band", "", "'" + text + "'",
                      "MINIMUM-MAXIMUM in um with 0 < MINIMUM < MAXIMUM, such as 3-5"});
}

} // namespace irsg
