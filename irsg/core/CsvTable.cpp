#include "irsg/core/CsvTable.h"

#include <charconv>
#include <cmath>
#include <utility>

#include "irsg/core/Diagnostics.h"
#include "irsg/core/FileReading.h"

namespace irsg {

namespace {

constexpr std::uint64_t largestTable_B = std::uint64_t{256} << 20;
constexpr std::size_t longestQuote = 60;

/// What was found, fit for one line of an error message.
std::string shown(std::string_view text) {
    std::string result;
    for (const char c : text.substr(0, longestQuote))
        result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    if (text.size() > longestQuote)
        result += "...";
    return result.empty() ? "nothing" : "'" + result + "'";
}

std::string linePosition(int line) {
    return "line " + std::to_string(line);
}

/// The lines of a text in order, whatever ends them.
class Lines {
  public:
    explicit Lines(std::string_view text) : rest_(text) {}

    std::optional<std::string_view> next() {
        if (rest_.empty())
            return std::nullopt;
        const std::size_t end = rest_.find_first_of("\r\n");
        const std::string_view line = rest_.substr(0, end);
        if (end == std::string_view::npos) {
            rest_ = {};
        } else {
            const bool pair =
                rest_[end] == '\r' && end + 1 < rest_.size() && rest_[end + 1] == '\n';
            rest_.remove_prefix(end + (pair ? 2 : 1));
        }
        return line;
    }

  private:
    std::string_view rest_;
};

CsvComment readComment(std::string_view line, int number) {
    line.remove_prefix(1);
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos)
        return {"", std::string(trimmed(line)), number};
    return {std::string(trimmed(line.substr(0, colon))),
            std::string(trimmed(line.substr(colon + 1))), number};
}

/// A cell in quotes at the head of `rest`, which is left behind the closing quote; no value where
/// the quote is never closed.
std::optional<std::string> takeQuoted(std::string_view& rest) {
    std::string text;
    for (std::size_t i = 1; i < rest.size(); ++i) {
        if (rest[i] != '"') {
            text += rest[i];
        } else if (i + 1 < rest.size() && rest[i + 1] == '"') {
            text += rest[i++];
        } else {
            rest.remove_prefix(i + 1);
            return text;
        }
    }
    return std::nullopt;
}

/// The cells of a line, `usual` as a rule; no value where a quote is never closed.
std::optional<CsvRow> readRow(std::string_view line, int number, std::size_t usual) {
    CsvRow row{number, {}};
    row.cells.reserve(usual);
    for (bool more = true; more;) {
        // A quoted text may be followed by blanks alone, else it is taken as it stands.
        std::string text;
        std::string_view rest = trimmed(line);
        if (rest.starts_with('"')) {
            const auto quoted = takeQuoted(rest);
            if (!quoted)
                return std::nullopt;
            text = *quoted;
            line = rest;
        }
        const std::size_t comma = line.find(',');
        text += trimmed(line.substr(0, comma));
        row.cells.push_back({std::move(text), number, static_cast<int>(row.cells.size()) + 1});
        more = comma != std::string_view::npos;
        line.remove_prefix(more ? comma + 1 : line.size());
    }
    return row;
}

bool isEmpty(const CsvRow& row) {
    for (const CsvCell& cell : row.cells)
        if (!cell.text.empty())
            return false;
    return true;
}

std::optional<double> numberOr(std::string_view text, Diagnostic diagnostic,
                               std::vector<Diagnostic>& diagnostics) {
    const auto value = parseNumber(text);
    if (!value)
        diagnostics.push_back(std::move(diagnostic));
    return value;
}

} // namespace

CsvTable CsvTable::read(const std::filesystem::path& file) {
    return parse(readFile(file, largestTable_B), file.string());
}

CsvTable CsvTable::parse(std::string_view text, std::string name) {
    CsvTable table;
    table.file_ = std::move(name);
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos)
        throw InputError({table.file_, "byte " + std::to_string(nul), "a NUL byte", "plain text"});

    std::vector<Diagnostic> diagnostics;
    Lines lines(text);
    std::size_t width = 1; // of the last row
    for (int number = 1; const auto line = lines.next(); ++number) {
        const std::string_view content = trimmed(*line);
        if (content.empty())
            continue;
        if (content.starts_with('#')) {
            table.comments_.push_back(readComment(content, number));
        } else if (auto row = readRow(content, number, width); !row) {
            diagnostics.push_back(
                table.diagnostic(number, std::string(content), "a closing quote on the same line"));
            keepFirstDiagnostics(diagnostics);
        } else if (!isEmpty(*row)) {
            width = row->cells.size();
            table.rows_.push_back(std::move(*row));
        }
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return table;
}

const CsvComment* CsvTable::comment(std::string_view key) const {
    for (const CsvComment& comment : comments_)
        if (comment.key == key)
            return &comment;
    return nullptr;
}

Diagnostic CsvTable::diagnostic(const CsvCell& cell, std::string expected) const {
    return {file_, linePosition(cell.line) + ", column " + std::to_string(cell.column),
            shown(cell.text), std::move(expected)};
}

Diagnostic CsvTable::diagnostic(int line, std::string value, std::string expected) const {
    return {file_, linePosition(line), shown(value), std::move(expected)};
}

Diagnostic CsvTable::diagnostic(std::string value, std::string expected) const {
    return {file_, "", std::move(value), std::move(expected)};
}

std::optional<double> CsvTable::number(const CsvCell& cell, std::vector<Diagnostic>& diagnostics,
                                       const std::string& expected) const {
    return numberOr(cell.text, diagnostic(cell, expected), diagnostics);
}

std::optional<double> CsvTable::number(const CsvComment& comment,
                                       std::vector<Diagnostic>& diagnostics,
                                       const std::string& expected) const {
    return numberOr(comment.value, diagnostic(comment.line, comment.value, expected), diagnostics);
}

std::optional<double> parseNumber(std::string_view text) {
    const std::string_view number = trimmed(text);
    const bool plus = number.size() > 1 && number[0] == '+' && number[1] != '-';
    const char* const begin = number.data() + (plus ? 1 : 0);
    const char* const end = number.data() + number.size();

    // Outside the range of double, the wider type tells an underflow from an overflow.
    double value = 0.0;
    auto [stop, error] = std::from_chars(begin, end, value);
    if (error == std::errc::result_out_of_range) {
        long double wide = 0.0L;
        error = std::from_chars(begin, end, wide).ec;
        value = std::abs(wide) < 1.0L ? 0.0 : HUGE_VAL;
    }
    if (error != std::errc{} || stop != end || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

} // namespace irsg
