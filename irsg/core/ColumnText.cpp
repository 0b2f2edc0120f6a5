#include "irsg/core/ColumnText.h"

#include <algorithm>
#include <array>
#include <map>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"

namespace irsg {

namespace {

bool isBlank(char c) {
    return c == ' ' || c == '\t';
}

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

bool isNonFiniteWord(std::string_view text) {
    if (text.starts_with('-') || text.starts_with('+'))
        text.remove_prefix(1);
    const std::string word = lowerCase(std::string(text));
    return word == "nan" || word == "inf" || word == "infinity";
}

/// The place behind the closing quote of a text that begins with a quote; npos where there is none.
std::size_t behindQuote(std::string_view text) {
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] != '"')
            continue;
        if (i + 1 >= text.size() || text[i + 1] != '"')
            return i + 1;
        ++i;
    }
    return std::string_view::npos;
}

/// The end of a cell between blanks, with the brackets that follow it.
std::size_t endBetweenBlanks(std::string_view line) {
    std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    for (;;) {
        const std::size_t next = line.find_first_not_of(" \t", end);
        if (next == std::string_view::npos || (line[next] != '[' && line[next] != '('))
            return end;
        const std::size_t close = line.find(line[next] == '[' ? ']' : ')', next);
        if (close == std::string_view::npos)
            return end;
        end = std::min(line.find_first_of(" \t", close), line.size());
    }
}

bool splitAtBlanks(std::string_view line, std::vector<ColumnCell>& cells) {
    for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
        if (line.starts_with('"')) {
            const std::size_t end = behindQuote(line);
            if (end == std::string_view::npos)
                return false;
            cells.push_back({line.substr(1, end - 2), {}, true});
            line.remove_prefix(end);
        } else {
            const std::size_t end = endBetweenBlanks(line);
            cells.push_back({line.substr(0, end), {}, false});
            line.remove_prefix(end);
        }
    }
    return true;
}

/// What a line consists of, apart from what stands in quotes.
struct LineSigns {
    std::size_t commas = 0, semicolons = 0, tabs = 0, points = 0;
    bool innerBlank = false, quotes = false;
    bool commaBetweenDigits = false, commaThenBlank = false;
};

LineSigns signsOf(std::string_view line) {
    LineSigns signs;
    const std::string_view text = trimmed(line);
    bool inQuotes = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') {
            signs.quotes = true;
            inQuotes = !inQuotes;
        }
        if (inQuotes)
            continue;
        signs.semicolons += c == ';' ? 1 : 0;
        signs.tabs += c == '\t' ? 1 : 0;
        signs.points += c == '.' ? 1 : 0;
        signs.innerBlank = signs.innerBlank || isBlank(c);
        if (c != ',')
            continue;
        ++signs.commas;
        const bool behindDigit = i > 0 && isDigit(text[i - 1]);
        signs.commaBetweenDigits = signs.commaBetweenDigits ||
                                   (behindDigit && i + 1 < text.size() && isDigit(text[i + 1]));
        signs.commaThenBlank =
            signs.commaThenBlank || (behindDigit && i + 1 < text.size() && isBlank(text[i + 1]));
    }
    // A tab in front of a line is a blank.
    return signs;
}

/// The length of what may stand between groups of three digits, at the beginning of a text; 0 where
/// nothing does. A blank, one that does not break, an apostrophe, or `other`.
std::size_t groupSign(std::string_view text, char other) {
    if (text.empty())
        return 0;
    if (text[0] == ' ' || text[0] == '\'' || text[0] == other)
        return 1;
    for (const std::string_view sign : {"\u00a0", "\u2009", "\u202f", "\u2019"})
        if (text.starts_with(sign))
            return sign.size();
    return 0;
}

/// The text of a number without what stands between its groups of three digits; no value where it
/// has none, or digits in other groups. The sign that is not the decimal one groups digits only
/// before a decimal sign. `hasBlanks`: blanks did.
std::optional<std::string> withoutGroups(std::string_view text, char decimal, bool& hasBlanks) {
    text = trimmed(text);
    const std::size_t begin = std::min(text.find_first_of("0123456789"), text.size());
    const char other = text.find(decimal) == text.npos ? '\0' : decimal == ',' ? '.' : ',';
    std::string plain(text.substr(0, begin));
    std::string_view sign;
    std::size_t digits = 0, groups = 0;
    for (text.remove_prefix(begin); !text.empty();) {
        if (isDigit(text[0])) {
            plain += text[0];
            text.remove_prefix(1);
            ++digits;
            continue;
        }
        const std::size_t length = groupSign(text, other);
        const bool isSame = groups == 0 || text.substr(0, length) == sign;
        if (length == 0 || !isSame || digits == 0 || digits > 3 || (groups > 0 && digits != 3))
            break;
        sign = text.substr(0, length);
        hasBlanks = hasBlanks || sign == " ";
        text.remove_prefix(length);
        digits = 0;
        ++groups;
    }
    if (groups == 0 || digits != 3)
        return std::nullopt;
    return plain.append(text);
}

/// Whether blanks within a cell cannot separate it from others.
bool mayHoldBlanks(const ColumnCell& cell, const ColumnDialect& dialect) {
    return cell.isQuoted || (dialect.separator != ',' && dialect.separator != ' ');
}

/// How well a dialect reads a text.
struct Score {
    std::size_t numberRows = 0;
    int groupedLine = 0;      ///< of the first number with blanks between its digits; 0: none
    std::string_view grouped; ///< that number
    std::map<std::size_t, std::size_t> widths; ///< how many of these rows have how many cells

    std::size_t evenRows() const {
        std::size_t most = 0;
        for (const auto& [width, count] : widths)
            most = std::max(most, count);
        return most;
    }
    bool isAbove(const Score& other) const {
        return numberRows != other.numberRows ? numberRows > other.numberRows
                                              : evenRows() > other.evenRows();
    }
};

/// Calls with each line that may hold cells, and its number from 1.
template <typename Call>
void forEachRow(std::string_view text, Call&& call) {
    for (int number = 1; !text.empty(); ++number) {
        const std::string_view line = takeLine(text);
        if (!trimmed(line).empty() && !isCommentLine(line))
            call(line, number);
    }
}

Score scoreOf(std::string_view text, const ColumnDialect& dialect) {
    Score score;
    std::vector<ColumnCell> cells;
    forEachRow(text, [&](std::string_view line, int number) {
        if (!splitColumns(line, dialect.separator, cells) || !isNumberRow(cells, dialect))
            return;
        while (!cells.empty() && cells.back().text.empty())
            cells.pop_back();
        // One number a row tells nothing: `1,2` is one of a decimal comma, too.
        if (cells.size() < 2)
            return;
        ++score.numberRows;
        ++score.widths[cells.size()];
        for (const ColumnCell& cell : cells)
            if (score.groupedLine == 0 && !cell.isQuoted && cell.text.find(' ') != cell.text.npos) {
                score.groupedLine = number;
                score.grouped = cell.text;
            }
    });
    return score;
}

[[noreturn]] void refuseTwoWays(const std::string& file, int line, std::string_view value,
                                const std::string& expected) {
    constexpr std::size_t longest = 60;
    std::string shown(trimmed(value).substr(0, longest));
    if (trimmed(value).size() > longest)
        shown += "...";
    throw InputError({file, "line " + std::to_string(line),
                      "'" + shown + "', which can be read in two ways", expected});
}

/// Digits in groups of three behind each comma: "1,234".
bool mayBeThousands(std::string_view text) {
    std::size_t comma = text.find(',');
    if (comma == 0 || comma == std::string_view::npos || comma > 4)
        return false;
    while (comma != std::string_view::npos) {
        const std::size_t next = text.find(',', comma + 1);
        if (std::min(next, text.size()) - comma != 4)
            return false;
        comma = next;
    }
    return true;
}

/// Of a text whose numbers stand in quotes between commas.
void refuseThousands(std::string_view text, const std::string& file) {
    std::vector<ColumnCell> cells;
    bool allMay = true;
    int first = 0;
    std::string_view example;
    forEachRow(text, [&](std::string_view line, int number) {
        if (!splitColumns(line, ',', cells) || !isNumberRow(cells, {',', ','}))
            return;
        for (const ColumnCell& cell : cells)
            if (cell.isQuoted && cell.text.find(',') != std::string_view::npos) {
                allMay = allMay && mayBeThousands(cell.text);
                if (first == 0) {
                    first = number;
                    example = cell.text;
                }
            }
    });
    if (first != 0 && allMay)
        refuseTwoWays(file, first, example,
                      "numbers without commas, or decimal commas between semicolons");
}

/// Of a text of commas and decimal points, whose commas may be meant for decimal signs.
void refuseDoubtfulCommas(std::string_view text, const std::string& file) {
    const ColumnDialect plain;
    std::vector<ColumnCell> cells;
    bool anyPoint = false, allMixed = true, allPairs = true, leadingZero = false;
    int mixedLine = 0, zeroLine = 0;
    std::string_view mixed, zero;
    forEachRow(text, [&](std::string_view line, int number) {
        if (anyPoint || !splitColumns(line, ',', cells) || !isNumberRow(cells, plain))
            return;
        const LineSigns signs = signsOf(line);
        anyPoint = signs.points > 0;
        allMixed = allMixed && signs.commaBetweenDigits && signs.commaThenBlank;
        if (mixedLine == 0) {
            mixedLine = number;
            mixed = line;
        }
        allPairs = allPairs && cells.size() % 2 == 0;
        for (std::size_t i = 1; i < cells.size(); i += 2) {
            const std::string_view half = cells[i].text;
            if (!leadingZero && half.size() > 1 && half[0] == '0' && isDigit(half[1])) {
                leadingZero = true;
                zeroLine = number;
                zero = line;
            }
        }
    });
    const char* const expected = "decimal points, or semicolons, tabs or blanks between columns";
    if (anyPoint || mixedLine == 0)
        return;
    if (allMixed)
        refuseTwoWays(file, mixedLine, mixed, expected);
    if (allPairs && leadingZero)
        refuseTwoWays(file, zeroLine, zero, expected);
}

} // namespace

std::string ColumnDialect::words() const {
    std::string text = separator == ';'    ? "columns separated by semicolons"
                       : separator == '\t' ? "columns separated by tabs"
                       : separator == ' '  ? "columns separated by blanks"
                       : separator == '|'  ? "columns separated by vertical bars"
                                           : "columns separated by commas";
    if (decimal == ',')
        text += ", decimal commas";
    return text;
}

std::string_view takeLine(std::string_view& rest) {
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    const std::string_view line = rest.substr(0, end);
    const bool isPair = rest.substr(end).starts_with("\r\n");
    rest.remove_prefix(std::min(rest.size(), end + (isPair ? 2 : 1)));
    return line;
}

bool isCommentLine(std::string_view line) {
    line = trimmed(line);
    return line.starts_with('#') || line.starts_with("\"#");
}

std::optional<char> statedSeparator(std::string_view line) {
    line = trimmed(line);
    if (line.starts_with('"') && line.ends_with('"') && line.size() > 1)
        line = line.substr(1, line.size() - 2);
    if (line.size() != 5 || lowerCase(std::string(line.substr(0, 4))) != "sep=")
        return std::nullopt;
    const char separator = line[4];
    return separator == ',' || separator == ';' || separator == '\t' || separator == '|'
               ? std::optional(separator)
               : std::nullopt;
}

bool splitColumns(std::string_view line, char separator, std::vector<ColumnCell>& cells) {
    cells.clear();
    if (separator == ' ')
        return splitAtBlanks(line, cells);
    for (bool more = true; more;) {
        ColumnCell cell;
        const std::size_t begin =
            std::min(line.find_first_not_of(separator == '\t' ? " " : " \t"), line.size());
        if (begin < line.size() && line[begin] == '"') {
            const std::size_t end = behindQuote(line.substr(begin));
            if (end == std::string_view::npos)
                return false;
            cell.text = line.substr(begin + 1, end - 2);
            cell.isQuoted = true;
            line.remove_prefix(begin + end);
        }
        const std::size_t end = line.find(separator);
        (cell.isQuoted ? cell.rest : cell.text) = trimmed(line.substr(0, end));
        cells.push_back(cell);
        more = end != std::string_view::npos;
        line.remove_prefix(more ? end + 1 : line.size());
    }
    return true;
}

std::string textOf(const ColumnCell& cell) {
    if (!cell.isQuoted)
        return std::string(cell.text);
    std::string text;
    for (std::size_t i = 0; i < cell.text.size(); ++i) {
        text += cell.text[i];
        if (cell.text[i] == '"')
            ++i; // of two, which are one
    }
    return text.append(cell.rest);
}

std::optional<std::string> plainNumber(std::string_view cell, char decimal) {
    cell = trimmed(cell);
    if (isNonFiniteWord(cell))
        return std::string(cell);
    constexpr std::size_t longestNumber = 2000;
    if (cell.empty() || cell.size() > longestNumber)
        return std::nullopt;

    // Sign, digits with at most one decimal sign, and an exponent.
    std::string plain;
    std::size_t i = 0, digits = 0;
    bool hasDecimalSign = false;
    if (constexpr std::string_view minus = "\u2212"; cell.starts_with(minus)) {
        plain += '-';
        i += minus.size();
    } else if (cell[i] == '+' || cell[i] == '-') {
        plain += cell[i++];
    }
    for (; i < cell.size() && isDigit(cell[i]); ++i, ++digits)
        plain += cell[i];
    if (i < cell.size() && cell[i] == decimal) {
        plain += '.';
        hasDecimalSign = true;
        ++i;
        const std::size_t before = digits;
        for (; i < cell.size() && isDigit(cell[i]); ++i, ++digits)
            plain += cell[i];
        // A comma behind the last digit rather ends a cell.
        if (decimal == ',' && digits == before)
            return std::nullopt;
    }
    if (digits == 0)
        return std::nullopt;
    if (i == cell.size())
        return plain;
    const bool hasLetter = std::string_view("eEdD").find(cell[i]) != std::string_view::npos;
    const bool hasSignAlone = cell[i] == '+' || cell[i] == '-';
    if (!hasLetter && !hasSignAlone)
        return std::nullopt;
    i += hasLetter ? 1 : 0;
    plain += 'e';
    if (i < cell.size() && (cell[i] == '+' || cell[i] == '-')) {
        if (cell[i] == '-')
            plain += '-';
        ++i;
    }
    const std::size_t exponent = i;
    for (; i < cell.size() && isDigit(cell[i]); ++i)
        plain += cell[i];
    // Without a letter Fortran has three digits behind a decimal sign: others are dates and ranges.
    const std::size_t exponentDigits = i - exponent;
    if (i != cell.size() || exponentDigits == 0 ||
        (!hasLetter && (exponentDigits != 3 || !hasDecimalSign)))
        return std::nullopt;
    return plain;
}

std::optional<std::string> cellNumber(const ColumnCell& cell, const ColumnDialect& dialect) {
    if (!cell.rest.empty())
        return std::nullopt;
    if (auto plain = plainNumber(cell.text, dialect.decimal))
        return plain;
    // Between commas a number with a decimal comma is in quotes, others may have none.
    if (dialect.separator == ',' && dialect.decimal == ',' &&
        cell.text.find_first_of(".,") == std::string_view::npos)
        if (auto plain = plainNumber(cell.text, '.'))
            return plain;
    bool hasBlanks = false;
    const auto grouped = withoutGroups(cell.text, dialect.decimal, hasBlanks);
    if (!grouped || (hasBlanks && !mayHoldBlanks(cell, dialect)))
        return std::nullopt;
    return plainNumber(*grouped, dialect.decimal);
}

bool isNumberCell(const ColumnCell& cell, const ColumnDialect& dialect) {
    return cellNumber(cell, dialect).has_value();
}

bool isNumberRow(const std::vector<ColumnCell>& cells, const ColumnDialect& dialect) {
    std::size_t numbers = 0;
    for (const ColumnCell& cell : cells) {
        if (cell.text.empty() && cell.rest.empty())
            continue;
        if (!isNumberCell(cell, dialect))
            return false;
        ++numbers;
    }
    return numbers > 0;
}

ColumnDialect columnDialectOf(std::string_view text, const std::string& file) {
    // What there is to choose from.
    std::size_t mostCommas = 0;
    bool semicolons = false, tabs = false, bars = false, blanks = false, quotes = false,
         doubtful = false;
    std::optional<char> stated;
    forEachRow(text, [&](std::string_view line, int number) {
        if (number == 1 && (stated = statedSeparator(line)))
            return;
        const LineSigns signs = signsOf(line);
        mostCommas = std::max(mostCommas, signs.commas);
        semicolons = semicolons || signs.semicolons > 0;
        tabs = tabs || signs.tabs > 0;
        bars = bars || line.find('|') != line.npos;
        blanks = blanks || signs.innerBlank;
        quotes = quotes || signs.quotes;
        doubtful = doubtful || (signs.commas > 0 && signs.points == 0);
    });

    std::vector<ColumnDialect> candidates = {{',', '.'}};
    if (semicolons)
        candidates.insert(candidates.end(), {{';', '.'}, {';', ','}});
    if (tabs)
        candidates.insert(candidates.end(), {{'\t', '.'}, {'\t', ','}});
    if (bars)
        candidates.insert(candidates.end(), {{'|', '.'}, {'|', ','}});
    if (blanks || tabs)
        candidates.insert(candidates.end(), {{' ', '.'}, {' ', ','}});
    if (quotes)
        candidates.push_back({',', ','});
    if (stated) {
        std::erase_if(candidates,
                      [&](const ColumnDialect& one) { return one.separator != *stated; });
        if (candidates.empty())
            candidates = {{*stated, '.'}, {*stated, ','}};
    }

    // The best, of equal ones the first.
    ColumnDialect best = candidates.front();
    if (candidates.size() > 1) {
        Score highest = scoreOf(text, best);
        Score ofBlanks;
        for (std::size_t i = 1; i < candidates.size(); ++i) {
            Score score = scoreOf(text, candidates[i]);
            if (candidates[i].separator == ' ' && score.isAbove(ofBlanks))
                ofBlanks = score;
            if (score.isAbove(highest)) {
                highest = std::move(score);
                best = candidates[i];
            }
        }
        if (highest.groupedLine > 0 && !highest.isAbove(ofBlanks))
            refuseTwoWays(file, highest.groupedLine, highest.grouped,
                          "numbers without blanks in them, or semicolons between columns");
    }
    if (best == ColumnDialect{',', ','})
        refuseThousands(text, file);
    if (best.isPlain() && doubtful && mostCommas > 0)
        refuseDoubtfulCommas(text, file);
    return best;
}

} // namespace irsg
