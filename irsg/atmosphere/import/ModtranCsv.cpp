#include "irsg/atmosphere/import/ModtranCsv.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "irsg/atmosphere/import/ModtranJson.h"
#include "irsg/atmosphere/import/Tape7.h"
#include "irsg/core/CsvTable.h"

namespace irsg {

namespace {

/// Rows of a file that belong to one run.
struct CsvBlock {
    std::vector<const CsvRow*> header;
    std::vector<const CsvRow*> rows;
};

bool isNumbers(const CsvRow& row) {
    return !row.cells.empty() && fortranNumber(row.cells.front().text).has_value();
}

bool isTerminator(const CsvRow& row) {
    return fortranNumber(row.cells.front().text) == -9999.0;
}

std::vector<CsvBlock> blocksOf(const CsvTable& table) {
    std::vector<CsvBlock> blocks(1);
    for (const CsvRow& row : table.rows()) {
        if (!isNumbers(row)) {
            const CsvCell& first = row.cells.front();
            const bool holdsText = !first.text.empty() || row.cells.size() > 1;
            if (!blocks.back().rows.empty() && holdsText) {
                // A word in the first column of a row as wide as its table is a bad number.
                const bool looksLikeRow =
                    row.cells.size() == blocks.back().rows.back()->cells.size() &&
                    row.cells.size() > 1 && isNumbers({row.line, {row.cells[1]}});
                if (!looksLikeRow) {
                    blocks.emplace_back();
                    blocks.back().header.push_back(&row);
                    continue;
                }
                blocks.back().rows.push_back(&row);
                continue;
            }
            blocks.back().header.push_back(&row);
        } else if (isTerminator(row)) {
            if (!blocks.back().rows.empty())
                blocks.emplace_back();
        } else {
            blocks.back().rows.push_back(&row);
        }
    }
    std::erase_if(blocks,
                  [](const CsvBlock& block) { return block.rows.empty() && block.header.empty(); });
    return blocks;
}

/// Name of a column: the cell of one header line, or of all of them from the top.
std::optional<RunColumn> columnOf(const CsvBlock& block, std::size_t column) {
    std::string joined;
    for (const CsvRow* line : block.header) {
        if (column >= line->cells.size())
            continue;
        const std::string& text = line->cells[column].text;
        if (const std::optional<RunColumn> known = runColumn(text))
            return known;
        joined += (joined.empty() ? "" : " ") + text;
        if (const std::optional<RunColumn> known = runColumn(joined))
            return known;
    }
    return std::nullopt;
}

/// What the header says about its spectral axis.
std::optional<SpectralUnit> unitOf(const CsvBlock& block) {
    for (const CsvRow* line : block.header) {
        std::string text = line->cells.front().text;
        std::ranges::transform(text, text.begin(), [](char c) {
            return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
        });
        if (text.find("cm-1") != text.npos || text.find("cm^-1") != text.npos)
            return SpectralUnit::wavenumber;
        if (text.find("micron") != text.npos || text.find("[um]") != text.npos || text == "um")
            return SpectralUnit::micrometre;
        if (text.find("nanom") != text.npos || text.find("[nm]") != text.npos || text == "nm")
            return SpectralUnit::nanometre;
    }
    return std::nullopt;
}

SpectralRun readBlock(const CsvTable& csv, const CsvBlock& block, const ModtranCase* documented,
                      std::vector<Diagnostic>& diagnostics) {
    ModtranCase settings = documented ? *documented : ModtranCase();
    SpectralRun run;
    const std::size_t before = diagnostics.size();
    const int line = block.header.empty() ? 1 : block.header.front()->line;
    for (const CsvComment& comment : csv.comments())
        if (const std::optional<double> value = parseNumber(comment.value))
            settings.cards[comment.key] = *value;
    const auto kind = settings.cards.find("IEMSCT");
    if (kind == settings.cards.end() || !settings.cards.contains("ITYPE")) {
        diagnostics.push_back(csv.diagnostic(
            "no word about the line of sight",
            "the input document beside the CSV (CSVPRNT names it), or comments # ITYPE, # IEMSCT, "
            "# H1, # H2, # ANGLE, # RANGE"));
        return run;
    }
    if (kind->second != 0.0 && kind->second != 1.0 && kind->second != 2.0 && kind->second != 3.0) {
        diagnostics.push_back(csv.diagnostic("IEMSCT " + numberText(kind->second), "0, 1, 2 or 3"));
        return run;
    }
    run.kind = static_cast<RunKind>(static_cast<int>(kind->second));
    run.cards = settings.cards;
    placeRun(run, csv.file(), "", diagnostics);

    RunTable table{.file = csv.file(),
                   .positions = {},
                   .columns = {},
                   .unit = settings.unit,
                   .transmittanceRounding = 0.0,
                   .sumsIncluded = true};
    const std::optional<SpectralUnit> stated = unitOf(block);
    if (stated && documented && *stated != settings.unit) {
        diagnostics.push_back(csv.diagnostic(line, "a spectral unit in the header",
                                             "the one of SPECTRAL.XFLAG of the input document"));
    }
    table.unit = stated.value_or(settings.unit);
    if (block.header.empty() || block.rows.empty()) {
        diagnostics.push_back(csv.diagnostic(line, "no header or no rows",
                                             "names of columns and rows of numbers below them"));
        return run;
    }
    std::vector<std::pair<RunColumn, std::size_t>> places;
    for (std::size_t i = 0; i < block.rows.front()->cells.size(); ++i) {
        const std::optional<RunColumn> column = columnOf(block, i);
        if (column && !table.columns.contains(*column)) {
            table.columns[*column] = {};
            places.emplace_back(*column, i);
        }
        for (const CsvRow* header : block.header) {
            if (i < header->cells.size() &&
                (runColumn(header->cells[i].text) == std::optional(RunColumn::thermal))) {
                table.sumsIncluded = header->cells[i].text.find("pth") != std::string::npos ||
                                     header->cells[i].text.find("PTH") != std::string::npos;
            }
        }
    }
    for (const CsvRow* row : block.rows) {
        if (row->cells.size() != block.rows.front()->cells.size()) {
            diagnostics.push_back(csv.diagnostic(
                row->line, std::to_string(row->cells.size()) + " cells",
                std::to_string(block.rows.front()->cells.size()) + " as in the first row"));
            continue;
        }
        table.positions.push_back("line " + std::to_string(row->line));
        for (const auto& [column, place] : places) {
            const CsvCell& cell = row->cells[place];
            double value = std::numeric_limits<double>::quiet_NaN();
            if (const std::optional<double> number = fortranNumber(cell.text))
                value = *number;
            else if (!cell.text.empty())
                diagnostics.push_back(csv.diagnostic(cell, "a finite number"));
            table.columns[column].push_back(value);
        }
    }
    if (diagnostics.size() == before)
        fillRun(run, table, diagnostics);
    return run;
}

} // namespace

std::vector<SpectralRun> readModtranCsv(const std::filesystem::path& file) {
    const CsvTable csv = CsvTable::read(file, CsvHead::all);
    if (csv.rows().empty())
        throw InputError({file.string(), "", "an empty table", "results of a MODTRAN run"});
    const std::vector<ModtranCase> cases = modtranCasesBeside(file, &ModtranCase::csvName);
    const std::vector<CsvBlock> blocks = blocksOf(csv);
    std::vector<Diagnostic> diagnostics;
    if (!cases.empty() && cases.size() != blocks.size()) {
        throw InputError(csv.diagnostic(std::to_string(blocks.size()) + " tables of numbers",
                                        "one for each of the " + std::to_string(cases.size()) +
                                            " cases that the input document has for this file"));
    }
    std::vector<SpectralRun> runs;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        runs.push_back(readBlock(csv, blocks[i], cases.empty() ? nullptr : &cases[i], diagnostics));
        const std::string which =
            cases.empty() || cases[i].name.empty() ? std::to_string(i + 1) : cases[i].name;
        runs.back().source =
            file.filename().string() + (blocks.size() > 1 ? ", case " + which : "");
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return runs;
}

bool isModtranCsv(std::string_view text) {
    const std::size_t line = text.find('\n', std::min<std::size_t>(16384, text.size()));
    std::optional<CsvTable> table;
    try {
        table = CsvTable::parse(text.substr(0, line), "", CsvHead::all);
    } catch (const InputError&) {
        return false;
    }
    const std::vector<CsvBlock> blocks = blocksOf(*table);
    if (blocks.empty() || blocks.front().header.empty())
        return false;
    std::size_t known = 0;
    bool transmits = false;
    std::size_t columns = 0;
    for (const CsvRow* header : blocks.front().header)
        columns = std::max(columns, header->cells.size());
    for (std::size_t i = 0; i < columns; ++i) {
        const std::optional<RunColumn> column = columnOf(blocks.front(), i);
        known += column ? 1u : 0u;
        transmits = transmits || column == RunColumn::transmittance;
    }
    return transmits && known >= 2;
}

} // namespace irsg
