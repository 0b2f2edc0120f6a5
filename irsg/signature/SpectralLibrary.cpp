#include "irsg/signature/SpectralLibrary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "irsg/core/ColumnText.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Remarks.h"
#include "irsg/core/Wording.h"
#include "irsg/radiometry/SpectralHead.h"
#include "irsg/signature/JcampText.h"
#include "irsg/signature/LibraryNodes.h"
#include "irsg/signature/RefractiveIndexText.h"

namespace irsg {

const char* const spectralLibraryNames =
    "ECOSTRESS, ASTER, USGS, JCAMP-DX, refractiveindex.info or DIRSIG .ems";

namespace {

using Quantity = LibrarySpectrum::Quantity;

constexpr double deletedBelow = -1e30; // -1.23e34 marks what USGS took out

/// What a word for the values means, and whether it counts in percent.
std::optional<std::pair<Quantity, double>> quantityOf(std::string_view words) {
    const std::string text = lowerCase(std::string(words));
    const double factor =
        text.find("percent") != std::string::npos || text.find('%') != text.npos ? 0.01 : 1.0;
    const auto holds = [&](const char* word) { return text.find(word) != std::string::npos; };
    if (holds("absorb") || holds("log") || holds("kubelka"))
        return std::nullopt;
    if (holds("emissivity") || holds("emittance"))
        return std::pair(Quantity::emissivity, factor);
    if (holds("transmi"))
        return std::pair(Quantity::transmissivity, factor);
    if (holds("reflect"))
        return std::pair(Quantity::reflectivity, factor);
    return std::nullopt;
}

bool beginsAsEcostress(std::string_view text) {
    const std::string beginning = beginningOf(text, 40);
    return beginning.find("x units:") != std::string::npos &&
           beginning.find("y units:") != std::string::npos;
}

LibrarySpectrum readEcostress(std::string_view text, const std::string& file) {
    LibrarySpectrum result{.format = "ECOSTRESS", .title = "", .columns = {}};
    std::map<std::string, std::pair<std::string, int>> keys;
    LibraryNodes nodes;
    for (int line = 1; !text.empty(); ++line) {
        const std::string_view content = trimmed(takeLine(text));
        const std::size_t colon = content.find(':');
        if (content.empty())
            continue;
        const std::vector<double> numbers = numbersOfLine(content);
        if (numbers.size() == 2)
            nodes.add(numbers[0], numbers[1], line);
        else if (nodes.positions.empty() && colon != std::string_view::npos)
            keys[lowerCase(std::string(trimmed(content.substr(0, colon))))] = {
                std::string(trimmed(content.substr(colon + 1))), line};
        else if (!nodes.positions.empty())
            refuseLibrary(file, line, "'" + std::string(content.substr(0, 60)) + "'",
                          "two numbers");
    }
    result.title = keys["name"].first;
    const auto& [xUnits, xLine] = keys["x units"];
    const auto& [yUnits, yLine] = keys["y units"];
    const auto head = spectralHead(xUnits);
    if (!head || !head->axis)
        refuseLibrary(file, xLine, "'" + xUnits + "'", spectralHeads());
    const auto quantity = quantityOf(yUnits);
    if (!quantity)
        refuseLibrary(file, yLine, "'" + yUnits + "'", "reflectance, emissivity or transmittance");
    const std::string stated = keys["number of x values"].first;
    if (const auto count = parseNumber(stated);
        count && *count != static_cast<double>(nodes.positions.size()))
        refuseLibrary(file, keys["number of x values"].second,
                      std::to_string(nodes.positions.size()) + " rows of numbers",
                      stated + ", as this line says");
    result.columns.push_back(
        libraryColumn(std::move(nodes), *head->axis, quantity->first, quantity->second, file));
    return result;
}

bool beginsAsUsgs(std::string_view text) {
    const std::string beginning = beginningOf(text, 16);
    return beginning.find("spectral library") != std::string::npos ||
           beginning.find("splib") != std::string::npos ||
           beginning.find("usgs") != std::string::npos;
}

LibrarySpectrum readUsgs(std::string_view text, const std::string& file) {
    LibrarySpectrum result{.format = "USGS", .title = "", .columns = {}};
    LibraryNodes nodes;
    std::string lastWords;
    std::size_t deleted = 0, single = 0;
    for (int line = 1; !text.empty(); ++line) {
        const std::string_view content = trimmed(takeLine(text));
        if (content.empty())
            continue;
        const std::vector<double> numbers = numbersOfLine(content);
        if (numbers.size() == 2 || numbers.size() == 3) {
            if (numbers[1] < deletedBelow)
                ++deleted;
            else
                nodes.add(numbers[0], numbers[1], line);
        } else if (numbers.size() == 1) {
            ++single;
        } else if (!nodes.positions.empty()) {
            refuseLibrary(file, line, "'" + std::string(content.substr(0, 60)) + "'",
                          "wavelength, reflectance and its deviation");
        } else {
            // The title is the first but one of the last words, where there are two.
            result.title = lastWords.empty() ? std::string(content) : lastWords;
            lastWords = content;
        }
    }
    if (single > nodes.positions.size())
        refuseLibrary(file, 0, "one column of values, whose wavelengths are in another file",
                      "columns of wavelength and reflectance side by side");
    if (deleted > 0)
        remarkOn(file, std::to_string(deleted) + " deleted values (-1.23e34) are left out");
    if (const auto axis = axisOfValues(nodes.positions, true)) {
        result.columns.push_back(
            libraryColumn(std::move(nodes), *axis, Quantity::reflectivity, 1.0, file));
        return result;
    }
    refuseLibrary(file, 0, "an axis of no wavelengths", "wavelengths in um or nm");
}

bool beginsAsJcamp(std::string_view text) {
    while (!text.empty()) {
        const std::string_view line = trimmed(takeLine(text));
        if (!line.empty() && !line.starts_with("$$"))
            return line.starts_with("##");
    }
    return false;
}

LibrarySpectrum readJcamp(std::string_view text, const std::string& file) {
    const JcampText jcamp = readJcampText(text, file);
    const auto axis = spectralHead(jcamp.xUnits);
    if (!axis || !axis->axis)
        refuseLibrary(file, jcamp.xUnitsLine, "'" + jcamp.xUnits + "'",
                      "1/CM, MICROMETERS or NANOMETERS");
    const auto quantity = quantityOf(jcamp.yUnits);
    if (!quantity)
        refuseLibrary(file, jcamp.yUnitsLine, "'" + jcamp.yUnits + "'",
                      "REFLECTANCE or TRANSMITTANCE, which need no thickness");
    LibrarySpectrum result{.format = "JCAMP-DX", .title = jcamp.title, .columns = {}};
    result.columns.push_back(libraryColumn({jcamp.x, jcamp.y, jcamp.lines}, *axis->axis,
                                           quantity->first, quantity->second, file));
    return result;
}

bool beginsAsEms(std::string_view text) {
    const std::size_t begin = text.find("CURVE_BEGIN");
    return begin != std::string_view::npos && begin < 65536;
}

LibrarySpectrum readEms(std::string_view text, const std::string& file) {
    LibrarySpectrum result{.format = "DIRSIG .ems", .title = "", .columns = {}};
    LibraryNodes nodes;
    std::size_t curves = 0, angles = 0;
    bool isInside = false, isTilted = false;
    for (int line = 1; !text.empty(); ++line) {
        const std::string_view content = trimmed(takeLine(text));
        if (content.empty())
            continue;
        if (content.starts_with("CURVE_BEGIN")) {
            isInside = true;
            ++curves;
            continue;
        }
        if (content.starts_with("CURVE_END")) {
            isInside = false;
            continue;
        }
        const std::vector<double> numbers = numbersOfLine(content);
        if (isInside && numbers.size() != 2)
            refuseLibrary(file, line, "'" + std::string(content.substr(0, 60)) + "'",
                          "wavelength or wavenumber and emissivity");
        if (isInside && curves == 1)
            nodes.add(numbers[0], numbers[1], line);
        if (!isInside && curves == 0 && line > 1 && numbers.size() == 1) {
            ++angles;
            isTilted = isTilted || numbers[0] != 1.0;
        }
    }
    if (curves > 1)
        remarkOn(file, "holds " + std::to_string(curves) + " curves; the first is read");
    if (isTilted)
        remarkOn(file, "its " + std::to_string(angles) +
                           " factors over angle are left out: the emissivity is that along the "
                           "normal");
    const bool areWavenumbers =
        !nodes.positions.empty() && std::ranges::min(nodes.positions) > 100.0;
    result.columns.push_back(libraryColumn(
        std::move(nodes), areWavenumbers ? SpectralAxis::wavenumber : SpectralAxis::wavelength,
        Quantity::emissivity, 1.0, file));
    return result;
}

} // namespace

std::optional<LibrarySpectrum> readSpectralLibrary(std::string_view text, const std::string& file) {
    constexpr struct {
        bool (*begins)(std::string_view text);
        LibrarySpectrum (*read)(std::string_view text, const std::string& file);
    } formats[] = {{beginsAsJcamp, readJcamp},
                   {beginsAsEcostress, readEcostress},
                   {beginsAsRefractiveIndex, readRefractiveIndex},
                   {beginsAsEms, readEms},
                   {beginsAsUsgs, readUsgs}};
    for (const auto& format : formats)
        if (format.begins(text))
            return format.read(text, file);
    return std::nullopt;
}

} // namespace irsg
