#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace smat::tables {

/// What every table from LOWTRAN 7 says of its origin.
inline constexpr const char* lowtran =
    "# source: LOWTRAN 7, AFGL-TR-88-0177 (F. X. Kneizys, E. P. Shettle, L. W. Abreu, J. H. "
    "Chetwynd, G. P. Anderson, W. O. Gallery, J. E. A. Selby, S. A. Clough, 1988, US Air Force "
    "Geophysics Laboratory, public domain)\n";

/// A table of numbers with named columns, as the public data come.
struct Table {
    std::string file;
    std::vector<std::string> names;
    std::vector<std::vector<double>> columns;

    /// Throws InputError where there is none of that name.
    const std::vector<double>& column(const std::string& name) const;
    /// Linear between the rows of an ascending first column; 0 outside.
    double at(const std::string& name, double first) const;
};

/// Throws InputError naming every row of another length and every cell that is no number.
Table readTable(const std::filesystem::path& file);

/// Columns on their way into one of our tables.
class Writer {
  public:
    /// `source`: # lines that every table of this origin carries.
    explicit Writer(std::string source = lowtran) : source_(std::move(source)) {}
    void add(std::string name, std::vector<double> values);
    /// Rows whose first column lies in the limits, after the header's # lines; says so on standard
    /// output. Throws InputError where the file cannot be written.
    void write(const std::filesystem::path& file, const std::string& header, double lowest,
               double highest) const;

  private:
    std::string source_;
    std::vector<std::string> names_;
    std::vector<std::vector<double>> columns_;
};

} // namespace smat::tables
