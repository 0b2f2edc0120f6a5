#include "irsg/core/CsvTable.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "irsg/core/BinaryFormats.h"
#include "irsg/core/ColumnWords.h"
#include "irsg/core/Diagnostics.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/Remarks.h"
#include "irsg/core/Utf8.h"

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

/// One word of letters and underscores, with or without a unit in brackets.
bool isOneWord(std::string_view key) {
    const std::size_t bracket = key.find_first_of("[(");
    const std::string_view word = trimmed(key.substr(0, bracket));
    const bool isClosed =
        bracket == std::string_view::npos || key.ends_with(']') || key.ends_with(')');
    return !word.empty() && isClosed && std::ranges::all_of(word, [](unsigned char c) {
        return c == '_' || c >= 0x80 || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    });
}

/// Whether what stands behind an equals sign is a value and no formula.
bool isValue(std::string_view text) {
    if (parseNumber(text))
        return true;
    for (const std::string_view sign : {"*", "^", "=", " / ", " + ", " - "})
        if (text.find(sign) != std::string_view::npos)
            return false;
    return !text.empty();
}

/// `# key: value` and `# key = value`; the rest of the line where it is neither.
CsvComment readComment(std::string_view line, int number) {
    line.remove_prefix(1);
    const auto split = [&](std::size_t at) {
        return CsvComment{std::string(trimmed(line.substr(0, at))),
                          std::string(trimmed(line.substr(at + 1))), number};
    };
    const std::size_t colon = line.find(':'), equal = line.find('=');
    if (equal < colon && isOneWord(trimmed(line.substr(0, equal))) &&
        isValue(trimmed(line.substr(equal + 1))))
        return split(equal);
    if (colon == std::string_view::npos)
        return {"", std::string(trimmed(line)), number};
    return split(colon);
}

/// The line of a comment that a spreadsheet saved, as it was before: without quotes around its
/// first cell. `width` is the number of its cells.
std::string commentText(std::string_view line, char separator, std::size_t& width) {
    std::vector<ColumnCell> cells;
    width = 1;
    if (!splitColumns(line, separator, cells))
        return std::string(line);
    width = separator == ' ' ? 1 : cells.size();
    const bool isAlone = std::all_of(cells.begin() + 1, cells.end(), [](const ColumnCell& cell) {
        return cell.text.empty() && cell.rest.empty();
    });
    return isAlone && cells.front().isQuoted ? textOf(cells.front()) : std::string(line);
}

/// The cells of a line; no value where a quote is never closed. Numbers with a decimal point among
/// those with decimal commas are added to `pointed`.
std::optional<CsvRow> readRow(std::string_view line, int number, const ColumnDialect& dialect,
                              std::vector<ColumnCell>& cells, std::vector<CsvCell>& pointed) {
    if (!splitColumns(line, dialect.separator, cells))
        return std::nullopt;
    CsvRow row{number, {}};
    row.cells.reserve(cells.size());
    for (const ColumnCell& cell : cells) {
        std::string text = textOf(cell);
        const auto column = static_cast<int>(row.cells.size()) + 1;
        if (!parseNumber(text)) {
            if (auto plain = cellNumber(cell, dialect))
                text = *std::move(plain);
        } else if (dialect.decimal == ',' && text.find('.') != std::string::npos) {
            pointed.push_back({text, number, column});
        }
        row.cells.push_back({std::move(text), number, column});
    }
    return row;
}

/// NaN and infinity are numbers here, though they are words.
bool holdsNumber(const CsvCell& cell) {
    return plainNumber(cell.text, '.').has_value();
}

/// The unit that a cell of a row of units holds, "" where it is dimensionless; no value for a name.
std::optional<std::string> unitIn(const CsvCell& cell) {
    std::string_view text = cell.text;
    if (text.empty() || columnUnit(text) == "")
        return "";
    const bool isSquare = text.starts_with('[') && text.ends_with(']');
    const bool isRound = text.starts_with('(') && text.ends_with(')');
    if (isSquare || isRound)
        return std::string(trimmed(text.substr(1, text.size() - 2)));
    return columnUnit(text) ? std::optional(std::string(text)) : std::nullopt;
}

/// How many cells of a row are units, of those that hold anything.
struct UnitCount {
    std::size_t units = 0, cells = 0;
    bool areAll() const { return units == cells; }
    bool areMost() const { return 2 * units > cells; }
};
UnitCount countUnits(const CsvRow& row) {
    UnitCount count;
    for (const CsvCell& cell : row.cells) {
        count.units += !cell.text.empty() && unitIn(cell) ? 1 : 0;
        count.cells += cell.text.empty() ? 0 : 1;
    }
    return count;
}

/// Whether a row holds the units of the names above it, which get them in brackets: all of its
/// cells are units, or most are, of which the names have few.
bool takeUnits(const CsvRow& units, CsvRow& names) {
    const UnitCount count = countUnits(units);
    if (!count.areAll() && (!count.areMost() || countUnits(names).areMost()))
        return false;
    std::vector<std::string> texts;
    for (const CsvCell& cell : units.cells)
        texts.push_back(unitIn(cell).value_or(cell.text));
    for (std::size_t i = 0; i < texts.size() && i < names.cells.size(); ++i)
        if (!texts[i].empty())
            names.cells[i].text += (names.cells[i].text.empty() ? "[" : " [") + texts[i] + "]";
    return true;
}

/// How many cells there are up to the last that is not empty.
std::size_t filledWidth(const CsvRow& row) {
    std::size_t width = row.cells.size();
    while (width > 0 && row.cells[width - 1].text.empty())
        --width;
    return width;
}

bool isEmpty(const CsvRow& row) {
    for (const CsvCell& cell : row.cells)
        if (!cell.text.empty())
            return false;
    return true;
}

/// A line drawn below names: -----, =====.
bool isRule(const CsvRow& row) {
    return filledWidth(row) == 1 && row.cells.front().text.size() > 2 &&
           row.cells.front().text.find_first_not_of("-=_+") == std::string::npos;
}

std::optional<double> numberOr(std::string_view text, Diagnostic diagnostic,
                               std::vector<Diagnostic>& diagnostics) {
    const auto value = parseNumber(text);
    if (!value)
        diagnostics.push_back(std::move(diagnostic));
    return value;
}

} // namespace

CsvTable CsvTable::read(const std::filesystem::path& file, CsvHead head) {
    CsvTable table = parse(readFile(file, largestTable_B), file.string(), head);
    table.remark();
    return table;
}

CsvTable CsvTable::parse(std::string_view bytes, std::string name, CsvHead head) {
    CsvTable table;
    table.file_ = std::move(name);
    std::string decoded;
    std::string_view text = utf8Of(bytes, decoded);
    table.isLatin1_ = !decoded.empty() && !isUtf16(bytes);
    if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos)
        throw InputError({table.file_, "byte " + std::to_string(nul),
                          std::string(foundInPlaceOfText(bytes)), "plain text"});
    table.dialect_ = columnDialectOf(text, table.file_);

    std::vector<Diagnostic> diagnostics;
    std::vector<ColumnCell> cells;
    std::vector<std::size_t> commentWidths;
    std::vector<CsvCell> pointed;
    for (int number = 1; !text.empty(); ++number) {
        const std::string_view line = takeLine(text);
        const std::string_view content = trimmed(line);
        if (content.empty() || (number == 1 && statedSeparator(content)))
            continue;
        if (isCommentLine(content)) {
            std::size_t width = 1;
            table.comments_.push_back(
                readComment(commentText(content, table.dialect_.separator, width), number));
            commentWidths.push_back(width);
        } else if (auto row = readRow(line, number, table.dialect_, cells, pointed); !row) {
            diagnostics.push_back(
                table.diagnostic(number, std::string(content), "a closing quote on the same line"));
            keepFirstDiagnostics(diagnostics);
        } else if (!isEmpty(*row)) {
            table.rows_.push_back(std::move(*row));
        }
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    table.trimComments(commentWidths);
    if (head == CsvHead::names) {
        table.leaveOutHeadLines();
        table.trimRows();
    }
    // 1.234 may be a thousand there.
    for (const CsvCell& cell : pointed)
        if (!table.rows_.empty() && cell.line >= table.rows_.front().line) {
            diagnostics.push_back(
                {table.file_, linePosition(cell.line) + ", column " + std::to_string(cell.column),
                 shown(cell.text), "a decimal comma, as in other rows"});
            keepFirstDiagnostics(diagnostics);
        }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return table;
}

/// A spreadsheet makes all rows as wide as the widest: separators that only do this belong to no
/// comment.
void CsvTable::trimComments(const std::vector<std::size_t>& widths) {
    std::size_t widest = 1;
    for (const CsvRow& row : rows_)
        widest = std::max(widest, row.cells.size());
    for (std::size_t i = 0; i < comments_.size(); ++i) {
        if (widest < 2 || widths[i] != widest)
            continue;
        for (std::string* const text : {&comments_[i].key, &comments_[i].value})
            text->erase(text->find_last_not_of(std::string(" \t") + dialect_.separator) + 1);
    }
}

void CsvTable::leaveOutHeadLines() {
    const auto isWords = [](const CsvRow& row) {
        return std::ranges::none_of(row.cells, holdsNumber);
    };
    const auto isNumbers = [](const CsvRow& row) {
        return std::ranges::all_of(
            row.cells, [](const CsvCell& cell) { return cell.text.empty() || holdsNumber(cell); });
    };
    const auto numbers = std::ranges::find_if(rows_, isNumbers);
    if (numbers == rows_.end() || numbers - rows_.begin() < 2)
        return;
    // The first rows of numbers may lack their last cells.
    std::size_t width = 0;
    auto names = numbers;
    for (auto whole = numbers; whole != rows_.end() && isNumbers(*whole) && names == numbers;
         ++whole)
        if (filledWidth(*whole) > width) {
            width = filledWidth(*whole);
            for (auto row = rows_.begin(); row != numbers; ++row)
                if (isWords(*row) && filledWidth(*row) == width)
                    names = row;
        }
    if (names == numbers)
        width = filledWidth(*numbers);
    const auto above = numbers - 1;
    if (names == numbers && filledWidth(*above) == width && !holdsNumber(above->cells.front()))
        names = above;
    if (names == numbers)
        return;
    if (names != rows_.begin() && isWords(*(names - 1)) && filledWidth(*(names - 1)) == width &&
        takeUnits(*names, *(names - 1)))
        names = rows_.erase(names) - 1;
    headLines_.assign(rows_.begin(), names);
    rows_.erase(rows_.begin(), names);
    while (rows_.size() > 1 && isRule(rows_[1]))
        rows_.erase(rows_.begin() + 1);
}

/// Cells that are empty in every row belong to no column, where they are the last.
void CsvTable::trimRows() {
    if (rows_.size() < 2)
        return;
    std::size_t widest = 0;
    for (const CsvRow& row : rows_)
        widest = std::max(widest, filledWidth(row));
    for (CsvRow& row : rows_)
        if (row.cells.size() > widest)
            row.cells.erase(row.cells.begin() + static_cast<std::ptrdiff_t>(widest),
                            row.cells.end());
}

void CsvTable::remark() const {
    if (!dialect_.isPlain())
        remarkOn(file_, dialect_.words());
    if (isLatin1_)
        remarkOn(file_, latin1Words);
    if (headLines_.empty())
        return;
    const int last = headLines_.back().line;
    remarkOn(file_, "lines up to line " + std::to_string(last) +
                        " are left out as head lines; the columns are named in line " +
                        std::to_string(rows_.front().line));
}

const CsvComment* CsvTable::comment(std::string_view key) const {
    for (const CsvComment& comment : comments_)
        if (comment.key == key)
            return &comment;
    const ColumnHead head = columnHead(key);
    for (const CsvComment& comment : comments_)
        if (!comment.key.empty() && columnHead(comment.key) == head)
            return &comment;
    return nullptr;
}

Diagnostic CsvTable::diagnostic(const CsvCell& cell, std::string expected) const {
    return {file_, linePosition(cell.line) + ", column " + std::to_string(cell.column),
            shown(written(cell.text)), std::move(expected)};
}

/// A number as the file writes it.
std::string CsvTable::written(const std::string& number) const {
    std::string text = number;
    if (dialect_.decimal == ',' && parseNumber(text))
        std::ranges::replace(text, '.', ',');
    return text;
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
    const std::optional<std::string> plain =
        parseNumber(comment.value) ? comment.value : plainNumber(comment.value, dialect_.decimal);
    return numberOr(plain.value_or(comment.value),
                    diagnostic(comment.line, comment.value, expected), diagnostics);
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
