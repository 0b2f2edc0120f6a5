#include "tools/atmosphere-tables/lines/LineListFile.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include <zlib.h>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"

namespace irsg::lbl {

namespace {

/// HITRAN's number of each gas.
constexpr std::array<int, lineGasCount> moleculeNumbers = {1, 2, 3, 4, 5, 6, 7};

std::optional<double> field(const std::string& record, std::size_t first, std::size_t length) {
    return parseNumber(trimmed(std::string_view(record).substr(first, length)));
}

/// The isotopologue's column is one character: 1 to 9, 0 for the tenth, A and B for the next two.
std::optional<int> isotopologueOf(char c) {
    if (c >= '1' && c <= '9')
        return c - '0';
    if (c == '0')
        return 10;
    if (c == 'A' || c == 'B')
        return 11 + (c - 'A');
    return std::nullopt;
}

std::optional<Line> lineOf(const std::string& record, Gas gas) {
    if (record.size() < 67)
        return std::nullopt;
    const auto molecule = field(record, 0, 2);
    const auto isotopologue = isotopologueOf(record[2]);
    const auto wavenumber = field(record, 3, 12), intensity = field(record, 15, 10);
    const auto air = field(record, 35, 5), self = field(record, 40, 5);
    const auto energy = field(record, 45, 10), exponent = field(record, 55, 4);
    const auto shift = field(record, 59, 8);
    if (!molecule || *molecule != moleculeNumbers[static_cast<std::size_t>(gas)] || !isotopologue ||
        !wavenumber || *wavenumber < 0.0 || !intensity || *intensity < 0.0 || !air || !self ||
        !energy || !exponent || !shift)
        return std::nullopt;
    Line line;
    line.wavenumber_per_cm = *wavenumber;
    line.intensity = *intensity;
    line.lowerEnergy_per_cm = std::max(*energy, 0.0); // -1 marks one that is not known
    line.airWidth_cm_atm = static_cast<float>(*air);
    line.selfWidth_cm_atm = static_cast<float>(*self > 0.0 ? *self : *air);
    line.widthExponent = static_cast<float>(*exponent);
    line.airShift_cm_atm = static_cast<float>(*shift);
    line.isotopologue = *isotopologue;
    return line;
}

} // namespace

std::vector<std::string> readTextLines(const std::filesystem::path& file) {
    std::unique_ptr<gzFile_s, decltype(&gzclose)> in(gzopen(file.c_str(), "rb"), &gzclose);
    if (!in)
        throw InputError(Diagnostic{file.string(), "", "no file that can be read", "a text file"});
    std::string text;
    std::array<char, 1 << 16> buffer;
    int count = 0;
    while ((count = gzread(in.get(), buffer.data(), static_cast<unsigned>(buffer.size()))) > 0)
        text.append(buffer.data(), static_cast<std::size_t>(count));
    // Only closing tells of a file that stops within its compressed stream.
    if (gzclose(in.release()) != Z_OK || count < 0)
        throw InputError(Diagnostic{file.string(), "byte " + std::to_string(text.size()),
                                    "damaged compression", "a gzip file that is whole"});
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        if (!lines.back().empty() && lines.back().back() == '\r')
            lines.back().pop_back();
        begin = end + 1;
    }
    return lines;
}

LineList readLineList(Gas gas, const std::filesystem::path& file) {
    LineList list{gas, {}, {}};
    std::vector<Diagnostic> diagnostics;
    int number = 0;
    for (const std::string& record : readTextLines(file)) {
        ++number;
        if (record.empty())
            continue;
        if (const auto line = lineOf(record, gas))
            list.lines.push_back(*line);
        else
            diagnostics.push_back(
                {file.string(), "line " + std::to_string(number), "'" + record.substr(0, 67) + "'",
                 "a HITRAN record of " + std::string(gasNames[static_cast<std::size_t>(gas)])});
        if (diagnostics.size() == 10)
            break;
    }
    if (list.lines.empty() && diagnostics.empty())
        diagnostics.push_back({file.string(), "", "no line", "HITRAN records"});
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    std::ranges::stable_sort(list.lines, {}, &Line::wavenumber_per_cm);
    return list;
}

} // namespace irsg::lbl
