#include "irsg/atmosphere/import/TextLines.h"

#include <algorithm>

#include "irsg/core/CsvTable.h"
#include "irsg/core/FileReading.h"

namespace irsg {

namespace {

constexpr std::uint64_t largestText_B = 512u << 20;

} // namespace

std::string readTextFile(const std::filesystem::path& file) {
    std::string text = readFile(file, largestText_B);
    if (const std::size_t zero = text.find('\0'); zero != std::string::npos) {
        throw InputError(
            {file.string(), "byte " + std::to_string(zero), "a NUL byte", "text, not binary data"});
    }
    return text;
}

TextLines TextLines::read(const std::filesystem::path& file) {
    return parse(readTextFile(file), file.string());
}

TextLines TextLines::parse(std::string_view text, std::string file) {
    if (const std::size_t zero = text.find('\0'); zero != text.npos) {
        throw InputError(
            {file, "byte " + std::to_string(zero), "a NUL byte", "text, not binary data"});
    }
    TextLines result{std::move(file), {}};
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
        result.lines.emplace_back(line);
        text.remove_prefix(std::min(end + 1, text.size()));
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
    std::string repaired(text);
    if (const std::size_t letter = repaired.find_first_of("dD"); letter != std::string::npos) {
        repaired[letter] = 'e';
    } else if (const std::size_t sign = repaired.find_last_of("+-");
               sign != std::string::npos && sign > 0 &&
               repaired.find_first_of("eE") == std::string::npos) {
        repaired.insert(sign, "e");
    }
    return parseNumber(repaired);
}

} // namespace irsg
