#include "irsg/atmosphere/import/TextLines.h"

#include <algorithm>

#include "irsg/core/BinaryFormats.h"
#include "irsg/core/ColumnText.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/Utf8.h"

namespace irsg {

namespace {

constexpr std::uint64_t largestText_B = 512u << 20;

} // namespace

std::string readTextFile(const std::filesystem::path& file) {
    std::string text = readFile(file, largestText_B);
    if (std::string decoded = decodedUtf16(text); !decoded.empty())
        text = std::move(decoded);
    if (const std::size_t zero = text.find('\0'); zero != std::string::npos) {
        throw InputError({file.string(), "byte " + std::to_string(zero),
                          std::string(foundInPlaceOfText(text)), "text, not binary data"});
    }
    return text;
}

TextLines TextLines::read(const std::filesystem::path& file) {
    return parse(readTextFile(file), file.string());
}

TextLines TextLines::parse(std::string_view text, std::string file) {
    if (const std::size_t zero = text.find('\0'); zero != text.npos) {
        throw InputError({file, "byte " + std::to_string(zero),
                          std::string(foundInPlaceOfText(text)), "text, not binary data"});
    }
    TextLines result{std::move(file), {}};
    for (text = withoutByteOrderMark(text); !text.empty();) {
        const std::string_view line = takeLine(text);
        result.lines.emplace_back(line.substr(0, line.find_last_not_of(" \t") + 1));
    }
    if (std::ranges::all_of(result.lines, [](const std::string& line) { return line.empty(); }))
        throw InputError({result.file, "", "an empty file", "results of a run"});
    return result;
}

Diagnostic TextLines::diagnostic(std::size_t index, std::string value, std::string expected) const {
    return {file, "line " + std::to_string(index + 1), std::move(value), std::move(expected)};
}

std::string_view field(std::string_view line, std::size_t first, std::size_t columns) {
    return first < line.size() ? trimmed(line.substr(first, columns)) : std::string_view();
}

std::optional<double> fortranNumber(std::string_view text) {
    text = trimmed(text);
    if (const std::optional<double> plain = parseNumber(text))
        return plain;
    const std::optional<std::string> repaired = plainNumber(text, '.');
    return repaired ? parseNumber(*repaired) : std::nullopt;
}

} // namespace irsg
