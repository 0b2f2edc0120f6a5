#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

/// A comma separated file as text that knows its places, so that whoever reads numbers out of it
/// can say file, line and column of each that is wrong.
///
/// Accepted: UTF-8 with or without byte order mark; lines that end in LF, CRLF or CR; cells in
/// double quotes (a quote inside is doubled) on one line; blank lines and lines of nothing but
/// commas, which are skipped. Rows may differ in length: the reader of the table decides whether
/// that is wrong.
class CsvTable {
  public:
    /// Throws InputError where the file cannot be read, is not text (a NUL byte), is larger than
    /// 256 MiB or has a quote that is never closed.
    static CsvTable read(const std::filesystem::path& file);
    /// The same from memory; `name` stands for the file in diagnostics.
    static CsvTable parse(std::string_view text, std::string name);

    const std::string& file() const { return file_; }
    const std::vector<CsvRow>& rows() const { return rows_; }
    const std::vector<CsvComment>& comments() const { return comments_; }
    /// The first comment of that key, or null.
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
    std::string file_;
    std::vector<CsvRow> rows_;
    std::vector<CsvComment> comments_;
};

/// The finite number that is the whole of `text` ("1", "-2.5e3", "+4"), whatever the locale; no
/// value for anything else, nan, inf and overflow included. Underflow gives 0.
std::optional<double> parseNumber(std::string_view text);

/// `text` without blanks and tabs at its ends.
std::string_view trimmed(std::string_view text);

} // namespace irsg
