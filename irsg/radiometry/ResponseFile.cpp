#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "irsg/core/BoundedValues.h"
#include "irsg/core/ColumnWords.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/Remarks.h"
#include "irsg/core/Utf8.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/SpectralHead.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// How far a response that is linear in cm-1 may stray from its straight pieces in um, relative to
/// its largest value.
constexpr double conversionTolerance = 1e-7;

/// The columns of a response, in the order and units of the file.
struct ResponseNodes {
    std::vector<double> axis;
    std::vector<double> values;
    std::vector<CsvCell> valueCells = {};
};

/// The two columns from row `first` on; diagnostics are added for every cell that is wrong.
ResponseNodes readNodes(const CsvTable& table, std::size_t first,
                        std::vector<Diagnostic>& diagnostics) {
    ResponseNodes nodes;
    for (std::size_t i = first; i < table.rows().size(); ++i) {
        const CsvRow& row = table.rows()[i];
        if (row.cells.size() != 2) {
            diagnostics.push_back(
                table.diagnostic(row.line, std::to_string(row.cells.size()) + " cells",
                                 "two cells: the wavelength or wavenumber and the response"));
            continue;
        }
        const auto x = table.number(row.cells[0], diagnostics, "a positive number");
        const auto y = table.number(row.cells[1], diagnostics, "a response of at least 0");
        const std::vector<double>& axis = nodes.axis;
        const bool descends = axis.size() > 1 && axis[1] < axis[0];
        if (x && *x <= 0.0) {
            diagnostics.push_back(table.diagnostic(row.cells[0], "a positive number"));
        } else if (x && !axis.empty() &&
                   (*x == axis.back() || (axis.size() > 1 && (*x < axis.back()) != descends))) {
            diagnostics.push_back(table.diagnostic(
                row.cells[0], (descends ? "less than " : "more than ") + numberText(axis.back()) +
                                  ": the axis " + (descends ? "descends" : "ascends") +
                                  " strictly"));
        }
        if (x && y) {
            nodes.axis.push_back(*x);
            nodes.values.push_back(*y);
            nodes.valueCells.push_back(row.cells[1]);
        }
    }
    return nodes;
}

std::string placeOf(const CsvCell& cell) {
    return "line " + std::to_string(cell.line) + ", column " + std::to_string(cell.column);
}

/// What the values of a response are divided by, after its head: 100 for percent, 1 for fractions
/// and where there is no head. A unit that is none of a fraction is a diagnostic; words in brackets
/// that are no known unit are a remark.
double unitOfResponse(const CsvTable& table, const CsvCell& head,
                      std::vector<Diagnostic>& diagnostics) {
    const ColumnHead column = columnHead(head.text);
    if (column.unit == "%")
        return 100.0;
    const std::string plain(trimmed(plainHead(head.text)));
    const bool hasBrackets = plain.ends_with(']') || plain.ends_with(')');
    const std::string_view unit = hasBrackets ? std::string_view(column.unit) : plain;
    // A/W, V / W, mA/mW, A W-1.
    const std::size_t slash = unit.rfind('/');
    const std::string_view below =
        slash == std::string_view::npos ? unit : trimmed(unit.substr(slash + 1));
    const bool isPerWatt =
        slash == std::string_view::npos
            ? unit.ends_with("W-1") || unit.ends_with("W^-1")
            : below == "W" || (below.size() == 2 && below[1] == 'W' &&
                               std::string_view("munkM").find(below[0]) != below.npos);
    if (isPerWatt || (hasBrackets && !unit.empty() && columnUnit(unit)))
        diagnostics.push_back(
            table.diagnostic(head, "a response from 0 to 1 without a unit, or with [%]: values per "
                                   "watt and others divided by their largest one"));
    else if (hasBrackets && !unit.empty())
        remarkOn(table.file(),
                 "the response in '" + std::string(unit) + "' is taken as a fraction from 0 to 1");
    return 1.0;
}

/// Fractions from values in percent (`divisor` 100) or fractions. Noise about zero (relative to the
/// largest value) and about one becomes the bound, other values outside are refused.
void takeFractions(const CsvTable& table, ResponseNodes& nodes, double divisor,
                   std::vector<Diagnostic>& diagnostics) {
    if (nodes.values.empty())
        return;
    const double largest = std::max(*std::ranges::max_element(nodes.values), 0.0);
    BoundedValues fromBelow(0.0, largest, boundTolerance * largest);
    BoundedValues fromAbove(0.0, divisor, boundTolerance * divisor);
    for (std::size_t i = 0; i < nodes.values.size(); ++i) {
        const CsvCell& cell = nodes.valueCells[i];
        double& value = nodes.values[i];
        const auto taken = value < 0.0       ? fromBelow.take(value, placeOf(cell))
                           : value > divisor ? fromAbove.take(value, placeOf(cell))
                                             : std::optional(value);
        if (!taken)
            diagnostics.push_back(table.diagnostic(
                cell, value < 0.0 ? "a response of at least 0"
                      : divisor == 1.0 && value > 1.5 && value <= 100.5
                          ? "a fraction from 0 to 1, not percent without [%] in its head"
                          : "a response from 0 to " + numberText(divisor)));
        value = taken.value_or(0.0) / divisor;
    }
    if (diagnostics.empty()) {
        fromBelow.remark(table.file());
        fromAbove.remark(table.file());
    }
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

/// The same in um, ascending.
ResponseNodes inMicrometres(ResponseNodes nodes, SpectralAxis axis) {
    if (nodes.axis.back() < nodes.axis.front()) {
        std::ranges::reverse(nodes.axis);
        std::ranges::reverse(nodes.values);
    }
    if (axis == SpectralAxis::wavenumber)
        return inWavelength(nodes);
    for (double& position : nodes.axis)
        position = wavelengthOn_um(axis, position);
    return nodes;
}

/// A filter file of MODTRAN: in its first line a letter for the unit of the first column (N: nm,
/// M: um, W: cm-1), then for each channel a line of words and rows of numbers between blanks.
class ModtranFilter {
  public:
    explicit ModtranFilter(std::string_view text) : rest_(text) {}

    static bool begins(std::string_view text) {
        const std::string_view head = trimmed(takeLine(text));
        const bool hasLetter = !head.empty() &&
                               std::string_view("NMWnmw").find(head[0]) != std::string_view::npos &&
                               (head.size() == 1 || head[1] == ' ' || head[1] == '\t');
        std::vector<ColumnCell> cells;
        const ColumnDialect blanks{' ', '.'};
        const std::string_view name = takeLine(text);
        if (!hasLetter || trimmed(name).empty() ||
            (splitColumns(name, ' ', cells) && isNumberRow(cells, blanks)))
            return false;
        return splitColumns(takeLine(text), ' ', cells) && cells.size() >= 2 &&
               isNumberRow(cells, blanks);
    }

    /// The first channel as a table of two columns with a head.
    std::string firstChannel(const std::string& file) {
        const char letter = trimmed(takeLine(rest_))[0];
        std::vector<std::string> names;
        std::string table = letter == 'N' || letter == 'n'   ? "nm,response\n"
                            : letter == 'M' || letter == 'm' ? "um,response\n"
                                                             : "cm-1,response\n";
        std::vector<ColumnCell> cells;
        while (!rest_.empty()) {
            const std::string_view line = takeLine(rest_);
            const bool isSound = splitColumns(line, ' ', cells);
            if (isSound && cells.empty()) {
                table += names.size() <= 1 ? "\n" : "";
            } else if (isSound && isNumberRow(cells, {' ', '.'})) {
                if (names.size() > 1)
                    continue;
                const std::size_t width = std::min<std::size_t>(cells.size(), 2);
                for (std::size_t i = 0; i < width; ++i)
                    table += (i > 0 ? "," : "") + textOf(cells[i]);
                table += "\n";
            } else if (names.empty()) {
                names.emplace_back(trimmed(line));
                table += "\n"; // lines keep their numbers
            } else {
                names.emplace_back(trimmed(line));
            }
        }
        if (names.size() > 1)
            remarkOn(file, "holds " + std::to_string(names.size()) + " channels; '" + names[0] +
                               "' is read, '" + names[1] + "' and what follows it are left out");
        return table;
    }

  private:
    std::string_view rest_;
};

/// The axis of a head, or of the values where there is none.
std::optional<SpectralAxis> axisOf(const CsvTable& table, bool hasHead,
                                   const std::vector<double>& axis,
                                   std::vector<Diagnostic>& diagnostics) {
    const CsvCell& corner = table.rows().front().cells.front();
    const std::optional<SpectralHead> head = hasHead ? spectralHead(corner.text) : SpectralHead{};
    if (!head) {
        diagnostics.push_back(table.diagnostic(corner, spectralHeads()));
        return std::nullopt;
    }
    if (head->isInAir)
        remarkOn(table.file(), "wavelengths in air are taken as those in vacuum");
    if (head->axis)
        return head->axis;
    const auto guessed = axisOfValues(axis, hasHead);
    if (!guessed)
        diagnostics.push_back(
            table.diagnostic(corner, "a head that names the unit: " + spectralHeads()));
    else
        remarkOn(table.file(),
                 std::string(hasHead ? "the head names no unit" : "there is no head") +
                     ": the first column is taken as wavelengths in " + axisUnit(*guessed) +
                     ", as its values suggest");
    return guessed;
}

CsvTable tableOf(const std::filesystem::path& file) {
    const std::string bytes = readFile(file);
    std::string decoded;
    const std::string_view text = utf8Of(bytes, decoded);
    if (ModtranFilter::begins(text)) {
        ModtranFilter filter(text);
        return CsvTable::parse(filter.firstChannel(file.string()), file.string());
    }
    CsvTable table = CsvTable::parse(bytes, file.string());
    table.remark();
    return table;
}

} // namespace

Band Band::fromCsv(const std::filesystem::path& file) {
    const CsvTable table = tableOf(file);
    if (table.rows().empty())
        throw InputError(table.diagnostic("no rows", "a header and at least two rows of numbers"));
    std::vector<Diagnostic> diagnostics;
    const CsvRow& header = table.rows().front();
    const bool hasHead = !parseNumber(header.cells.front().text);
    if (header.cells.size() != 2) {
        diagnostics.push_back(
            table.diagnostic(header.line, std::to_string(header.cells.size()) + " cells",
                             "two cells: the wavelength or wavenumber and the response"));
    }

    ResponseNodes nodes = readNodes(table, hasHead ? 1 : 0, diagnostics);
    const auto axis = axisOf(table, hasHead, nodes.axis, diagnostics);
    const double divisor = hasHead && header.cells.size() == 2
                               ? unitOfResponse(table, header.cells[1], diagnostics)
                               : 1.0;
    takeFractions(table, nodes, divisor, diagnostics);
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
    if (divisor != 1.0)
        remarkOn(table.file(), "the response is in percent");
    nodes = inMicrometres(std::move(nodes), *axis);
    return fromResponse(
        {std::move(nodes.axis), std::move(nodes.values), Spectrum::Outside::zero, table.file()},
        file.filename().string());
}

} // namespace irsg
