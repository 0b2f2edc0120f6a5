#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/core/Quantity.h"
#include "smatcore/data/Provenance.h"

namespace irsg {
class JsonReader;
}

namespace smat {

/// One column of numbers with what they mean.
struct ResultColumn {
    std::string key;  ///< "contrast_intensity"
    std::string unit; ///< "W sr-1", "" when dimensionless
    std::vector<double> values;

    /// "contrast_intensity [W sr-1]".
    std::string header() const;
    /// "Contrast intensity (W·sr⁻¹)", from the quantity of that key where there is one.
    std::string axisTitle() const;
    bool operator==(const ResultColumn&) const = default;
};

/// What an analysis measured: columns of equal length, the first is the abscissa, and the
/// provenance that tells how it came to be.
class ResultTable {
  public:
    Provenance provenance;

    ResultColumn& add(irsg::Quantity quantity);
    /// A column of another name; in a table with rows its values are 0.
    ResultColumn& add(std::string key, std::string unit);
    const std::vector<ResultColumn>& columns() const { return columns_; }
    std::size_t rowCount() const { return columns_.empty() ? 0 : columns_.front().values.size(); }
    bool empty() const { return rowCount() == 0; }
    /// Null where there is none.
    const ResultColumn* find(std::string_view key) const;
    const ResultColumn* find(irsg::Quantity quantity) const;
    /// One value per column (LogicError otherwise), and what the row warns of, "" for nothing.
    void addRow(const std::vector<double>& values, std::string warning = {});
    /// The same before row `at`; behind all where it is the number of rows.
    void insertRow(std::size_t at, const std::vector<double>& values, std::string warning = {});
    /// What each row warns of, "" for nothing; empty where no row warns of anything.
    const std::vector<std::string>& warnings() const { return warnings_; }
    /// That of one row. LogicError for a row that is not there.
    std::string warningOf(std::size_t row) const;
    /// Changes it.
    void setWarning(std::size_t row, std::string warning);

    /// `# key: value` lines, a header row, then numbers that read back exactly. Rows that warn of
    /// something give a last column `warning` of texts.
    std::string toCsv() const;
    std::string toJson() const;
    /// Writes .json for that extension, CSV for any other. Throws InputError.
    void save(const std::filesystem::path& file) const;
    /// Reads either form back. Throws InputError with every diagnostic: a missing header, ragged
    /// rows, cells that are no numbers.
    static ResultTable load(const std::filesystem::path& file);
    /// That of a JSON text, which may hold more besides.
    static ResultTable fromJson(const irsg::JsonReader& json);

    bool operator==(const ResultTable&) const = default;

  private:
    static ResultTable fromCsv(const std::filesystem::path& file);

    std::vector<ResultColumn> columns_;
    std::vector<std::string> warnings_; // as of warnings()
};

} // namespace smat
