#include "irsg/atmosphere/import/Tape7.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

namespace irsg {

namespace {

constexpr std::size_t shortestHeader = 10; ///< lines from card 1 to the one before the names
constexpr std::size_t longestHeader = 400; ///< with user profiles

struct NamedColumn {
    std::string name;
    std::size_t begin = 0; ///< one past the end of the column before
    std::size_t end = 0;
};

bool isColumnNames(const std::string& line) {
    const std::string_view first = field(line, 0, 10);
    return first.starts_with("FREQ") || first.starts_with("WAVLEN") || first.starts_with("WAVEL");
}

bool isTerminator(const std::string& line) {
    const std::optional<double> value = fortranNumber(field(line, 0, 12));
    return value && *value == -9999.0;
}

std::vector<NamedColumn> columnsOf(const std::string& line) {
    std::vector<NamedColumn> found;
    for (std::size_t i = 0; i < line.size();) {
        if (line[i] == ' ') {
            ++i;
            continue;
        }
        const std::size_t end = std::min(line.find(' ', i), line.size());
        found.push_back({line.substr(i, end - i), i, end});
        i = end;
    }
    return found;
}

/// One run on its way from lines to columns.
class Tape7Reader {
  public:
    Tape7Reader(const TextLines& text, std::vector<Diagnostic>& diagnostics)
        : text_(text), diagnostics_(diagnostics) {}

    /// Reads the run that begins at line `at` and moves `at` behind it.
    SpectralRun read(std::size_t& at, const std::string& source) {
        run_.source = source;
        first_ = at;
        names_ = first_;
        while (names_ < text_.lines.size() && names_ < first_ + longestHeader &&
               !isColumnNames(text_.lines[names_])) {
            ++names_;
        }
        if (names_ >= text_.lines.size() || !isColumnNames(text_.lines[names_]) ||
            names_ < first_ + shortestHeader) {
            diagnostics_.push_back(text_.diagnostic(
                std::min(names_, text_.lines.size() - 1), "a header that is cut or foreign",
                "the cards of a MODTRAN run and a line that begins with FREQ after at least " +
                    std::to_string(shortestHeader) + " lines"));
            at = text_.lines.size();
            return run_;
        }
        const std::size_t before = diagnostics_.size();
        run_.cards = tape7Cards(text_, first_, names_, diagnostics_);
        if (diagnostics_.size() == before)
            readKind();
        if (diagnostics_.size() == before) {
            placeRun(run_, text_.file, "line " + std::to_string(names_ - 4), diagnostics_);
            readColumns();
        }
        std::size_t row = names_ + 1;
        if (diagnostics_.size() == before) {
            row = run_.kind == RunKind::transmittance ? names_ + 2 : names_ + 1;
            row = readRows(row);
        } else {
            while (row < text_.lines.size() && !isTerminator(text_.lines[row]))
                ++row;
        }
        if (diagnostics_.size() == before)
            fillRun(run_, table_, diagnostics_);
        if (diagnostics_.size() == before)
            warnOfEnd(row < text_.lines.size());
        at = row + 1;
        return run_;
    }

  private:
    void readKind() {
        const double kind = run_.cards["IEMSCT"];
        if (kind != 0.0 && kind != 1.0 && kind != 2.0 && kind != 3.0) {
            diagnostics_.push_back(
                text_.diagnostic(first_, "IEMSCT " + numberText(kind),
                                 "0 (transmittance), 1 or 2 (radiance) or 3 (solar irradiance)"));
            return;
        }
        run_.kind = static_cast<RunKind>(static_cast<int>(kind));
    }

    void readColumns() {
        const std::string& line = text_.lines[names_];
        table_.file = text_.file;
        if (!field(line, 0, 10).starts_with("FREQ"))
            table_.unit = SpectralUnit::micrometre;
        table_.sumsIncluded = line.find("THRML_EM") == std::string::npos &&
                              line.find("MULT_SCAT") == std::string::npos;
        if (run_.kind == RunKind::sunlight) {
            // Names do not stand over their columns: F8.2, F8.4, 2 E9.2, and the optical depth.
            columns_ = {{"FREQ", 0, 8},
                        {"TRANS", 8, 16},
                        {"SOL TR", 16, 25},
                        {"SOLAR", 25, 34},
                        {"DEPTH", 34, std::string::npos}};
            if (line.find("SOL TR") == std::string::npos) {
                diagnostics_.push_back(
                    text_.diagnostic(names_, line, "FREQ, TRANS, SOL TR and SOLAR for IEMSCT 3"));
            }
            return;
        }
        if (run_.kind == RunKind::transmittance) {
            joinUnitsLine();
        } else {
            columns_ = columnsOf(line);
            joinWords();
        }
        for (std::size_t i = 0; i < columns_.size(); ++i)
            columns_[i].begin = i == 0 ? 0 : columns_[i - 1].end;
    }

    /// "H2O" over "CONT" is the column "H2O CONT". Long names touch, the words below them do not.
    void joinUnitsLine() {
        const bool isThere = names_ + 1 < text_.lines.size();
        columns_ = isThere ? columnsOf(text_.lines[names_ + 1]) : std::vector<NamedColumn>();
        if (columns_.empty() || columns_.front().name != "CM-1") {
            diagnostics_.push_back(
                text_.diagnostic(names_ + 1, isThere ? text_.lines[names_ + 1] : "the end",
                                 "a second line of column names for IEMSCT 0, which "
                                 "begins with CM-1"));
            return;
        }
        std::size_t begin = 0;
        for (NamedColumn& column : columns_) {
            column.name = std::string(field(text_.lines[names_], begin, column.end - begin)) + " " +
                          column.name;
            begin = column.end;
        }
    }

    /// Older versions print "TOT TRANS" where newer print "TOT_TRANS".
    void joinWords() {
        for (std::size_t i = 0; i + 1 < columns_.size(); ++i) {
            const std::string joined = columns_[i].name + " " + columns_[i + 1].name;
            if (!runColumn(columns_[i].name) &&
                (runColumn(joined) || joined == "DRCT RFLT" || joined == "REF SOL" ||
                 joined == "DIR EM" || joined == "TOA SUN")) {
                columns_[i].name = joined;
                columns_[i].end = columns_[i + 1].end;
                columns_.erase(columns_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
            }
        }
    }

    std::size_t readRows(std::size_t row) {
        for (const NamedColumn& column : columns_) {
            const std::optional<RunColumn> known = runColumn(column.name);
            places_.push_back(known && !table_.columns.contains(*known) ? known : std::nullopt);
            if (places_.back())
                table_.columns[*known] = {};
        }
        for (; row < text_.lines.size() && !isTerminator(text_.lines[row]); ++row) {
            if (text_.lines[row].empty())
                continue;
            if (isLastOfFile(row) && lacksCells(row)) {
                run_.warnings.push_back("the last row is cut and was left out");
                continue;
            }
            readRow(row);
        }
        return row;
    }

    bool isLastOfFile(std::size_t row) const {
        return std::all_of(text_.lines.begin() + static_cast<std::ptrdiff_t>(row) + 1,
                           text_.lines.end(), [](const std::string& line) { return line.empty(); });
    }

    /// A cut row has blanks or half a number where the rows before it have what a run needs.
    bool lacksCells(std::size_t row) const {
        const RunColumn last = run_.kind == RunKind::transmittance ? RunColumn::transmittance
                               : run_.kind == RunKind::sunlight    ? RunColumn::sunTransmitted
                                                                   : RunColumn::total;
        for (std::size_t i = 0; i < columns_.size(); ++i)
            if (places_[i] == last)
                return text_.lines[row].size() < columns_[i].end;
        return false;
    }

    void readRow(std::size_t row) {
        const std::string& line = text_.lines[row];
        table_.positions.push_back("line " + std::to_string(row + 1));
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            if (!places_[i])
                continue;
            const std::string_view cell =
                field(line, columns_[i].begin, columns_[i].end - columns_[i].begin);
            double value = std::numeric_limits<double>::quiet_NaN();
            if (const std::optional<double> number = fortranNumber(cell)) {
                value = *number;
            } else if (!cell.empty()) {
                diagnostics_.push_back(text_.diagnostic(row, "'" + std::string(cell) + "'",
                                                        "a number for " + columns_[i].name));
            }
            table_.columns[*places_[i]].push_back(value);
            if (places_[i] == RunColumn::transmittance && table_.positions.size() == 1) {
                const std::size_t point = cell.find('.');
                const std::size_t digits = point == cell.npos ? 0 : cell.size() - point - 1;
                table_.transmittanceRounding = 0.5 * std::pow(10.0, -static_cast<double>(digits));
            }
        }
    }

    void warnOfEnd(bool terminated) {
        const double last = run_.wavenumbers_per_cm.back();
        const double asked = run_.cards["V2"];
        // A complete table ends within a step of what was asked, whatever follows it, and one that
        // is closed within a slit more.
        const bool isWhole =
            table_.unit == SpectralUnit::wavenumber &&
            last + run_.cards["DV"] + (terminated ? run_.cards["FWHM"] : 0.0) >= asked;
        if (isWhole)
            return;
        if (!terminated) {
            run_.warnings.push_back("the file stops at " + numberText(last) +
                                    " cm-1 without -9999; its cards ask for " +
                                    numberText(run_.cards["V1"]) + " to " + numberText(asked) +
                                    " cm-1");
        } else if (table_.unit == SpectralUnit::wavenumber) {
            run_.warnings.push_back("the data end at " + numberText(last) +
                                    " cm-1; the cards ask for " + numberText(run_.cards["V1"]) +
                                    " to " + numberText(asked) + " cm-1");
        }
    }

    const TextLines& text_;
    std::vector<Diagnostic>& diagnostics_;
    SpectralRun run_;
    RunTable table_;
    std::size_t first_ = 0;
    std::size_t names_ = 0;
    std::vector<NamedColumn> columns_;
    std::vector<std::optional<RunColumn>> places_;
};

} // namespace

std::vector<SpectralRun> readTape7(const std::filesystem::path& file) {
    return parseTape7(TextLines::read(file));
}

std::vector<SpectralRun> parseTape7(const TextLines& text) {
    std::vector<Diagnostic> diagnostics;
    std::vector<SpectralRun> runs;
    std::size_t at = 0;
    while (true) {
        while (at < text.lines.size() && text.lines[at].empty())
            ++at;
        if (at >= text.lines.size())
            break;
        const std::string file = std::filesystem::path(text.file).filename().string();
        runs.push_back(
            Tape7Reader(text, diagnostics)
                .read(at, runs.empty() ? file : file + ", run " + std::to_string(runs.size() + 1)));
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return runs;
}

} // namespace irsg
