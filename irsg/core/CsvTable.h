#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/core/ColumnText.h"
#include "irsg/core/Errors.h"

namespace irsg {

/// A cell without the blanks and quotes around it, and where it stands (both count from 1).
struct CsvCell {
    std::string text;
    int line = 0;
    int column = 0; ///< number of the field in its row
};

/// A row with at least one cell that is not empty.
struct CsvRow {
    int line = 0;
    std::vector<CsvCell> cells;
};

/// A line that begins with #. `# unit: W m-2` has the key "unit" and the value "W m-2"; a line
/// without a colon has an empty key and its whole text as value.
struct CsvComment {
    std::string key;
    std::string value;
    int line = 0;
};

/// Which rows a table keeps.
enum class CsvHead {
    names, ///< from the row of names on: head lines above it are left out
    all    ///< every row
};

/// A file of columns as text that knows its places, so that whoever reads numbers out of it
/// can say file, line and column of each that is wrong.
///
/// Accepted: UTF-8 with or without byte order mark, UTF-16 with one, else Latin-1; lines that end
/// in LF, CRLF or CR; columns between commas, semicolons, tabs or blanks and decimal points or
/// commas, whichever the whole text shows (columnDialectOf); numbers with exponents of D or digits
/// in groups of three (cellNumber); cells in double quotes (a quote inside is doubled) on one line;
/// blank lines and lines of nothing but separators, which are skipped; separators behind the last
/// cell of every row, as spreadsheets add them, behind comments too. Numbers stand in the cells as
/// parseNumber takes them. Rows may differ in length: the reader of the table decides whether that
/// is wrong.
///
/// The row of names is the last row without a number above the first row of numbers that has as
/// many cells; where none has, the row above the numbers.
class CsvTable {
  public:
    /// Throws InputError where the file cannot be read, is not text (a NUL byte), is larger than
    /// 256 MiB, has a quote that is never closed or can be read in two ways. Remarks on what it
    /// took that is not the plain form.
    static CsvTable read(const std::filesystem::path& file, CsvHead head = CsvHead::names);
    /// The same from memory, without remarks; `name` stands for the file in diagnostics.
    static CsvTable parse(std::string_view text, std::string name, CsvHead head = CsvHead::names);
    /// The remarks that read() makes: another separator or decimal sign, Latin-1, head lines left
    /// out.
    void remark() const;

    const std::string& file() const { return file_; }
    const std::vector<CsvRow>& rows() const { return rows_; }
    const std::vector<CsvComment>& comments() const { return comments_; }
    const ColumnDialect& dialect() const { return dialect_; }
    /// Lines that were left out above the row of names.
    const std::vector<CsvRow>& headLines() const { return headLines_; }
    /// The first comment of that key, else the first whose key means the same (columnHead), or
    /// null.
    const CsvComment* comment(std::string_view key) const;

    /// "FILE: line 7, column 2: found VALUE, expected EXPECTED".
    Diagnostic diagnostic(const CsvCell& cell, std::string expected) const;
    /// About a whole line: a row of the wrong length, a comment.
    Diagnostic diagnostic(int line, std::string value, std::string expected) const;
    /// About the whole file.
    Diagnostic diagnostic(std::string value, std::string expected) const;

    /// The finite number in a cell; otherwise adds a diagnostic and gives no value.
    std::optional<double> number(const CsvCell& cell, std::vector<Diagnostic>& diagnostics,
                                 const std::string& expected = "a finite number") const;
    /// The same for the value of a comment.
    std::optional<double> number(const CsvComment& comment, std::vector<Diagnostic>& diagnostics,
                                 const std::string& expected = "a finite number") const;

  private:
    void leaveOutHeadLines();
    void trimRows();
    void trimComments(const std::vector<std::size_t>& widths);
    std::string written(const std::string& number) const;

    std::string file_;
    ColumnDialect dialect_;
    bool isLatin1_ = false;
    std::vector<CsvRow> rows_, headLines_;
    std::vector<CsvComment> comments_;
};

/// The finite number that is the whole of `text` ("1", "-2.5e3", "+4"), whatever the locale; no
/// value for anything else, nan, inf and overflow included. Underflow gives 0.
std::optional<double> parseNumber(std::string_view text);

/// `text` without blanks and tabs at its ends.
std::string_view trimmed(std::string_view text);

} // namespace irsg
