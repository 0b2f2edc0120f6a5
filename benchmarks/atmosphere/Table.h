#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace irsg::accuracy {

/// Where results go: tables as Markdown on the standard output, curves as CSV in a folder.
struct Output {
    std::filesystem::path shared; ///< folder with data/atmosphere/
    std::filesystem::path folder; ///< for CSV; empty: none
    std::filesystem::path truth;  ///< transmittances and radiances computed line by line

    std::filesystem::path data() const { return shared / "data" / "atmosphere"; }
};

/// "%.4f" of a number.
std::string text(const char* format, double value);

/// A table that is printed when all of its rows are known.
class Table {
  public:
    Table(std::string title, std::vector<std::string> columns);

    void add(std::vector<std::string> cells);
    void print() const;

  private:
    std::string title_;
    std::vector<std::string> columns_;
    std::vector<std::vector<std::string>> rows_;
};

/// Writes columns of numbers as NAME.csv. Throws InputError where the file cannot be written.
struct Curve {
    std::string column;
    std::vector<double> values;
};
void writeCurves(const Output& output, const std::string& name, const std::string& title,
                 const std::vector<Curve>& curves);

/// The sections of the program.
void modtranTables(const Output& output);
void lowtranTables(const Output& output);
void lineByLineTables(const Output& output);
void widebandTables(const Output& output);
void sunTables(const Output& output);
void speedTables(const Output& output);

} // namespace irsg::accuracy
