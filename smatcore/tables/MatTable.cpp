#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <matio.h>

#include "irsg/core/Errors.h"
#include "smatcore/data/ColumnName.h"
#include "smatcore/tables/TableFormats.h"
#include "smatcore/tables/TableWriters.h"

namespace smat {

namespace {

/// Of the pattern, below the strongest cell: what has no intensity has no decibels.
constexpr double floorBelowPeak_dB = 200.0;

/// Azimuths as MATLAB counts them, -180 to 180 deg from the nose to starboard, and where each
/// stands in the table; where -180 is there, 180 is the same direction again.
struct TurnedAzimuths {
    std::vector<double> values_deg;
    std::vector<std::size_t> places;

    explicit TurnedAzimuths(const std::vector<double>& azimuths_deg) {
        std::vector<std::size_t> order(azimuths_deg.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto turned = [&](std::size_t i) {
            return azimuths_deg[i] >= 180.0 ? azimuths_deg[i] - 360.0 : azimuths_deg[i];
        };
        std::ranges::stable_sort(order, {}, turned);
        for (const std::size_t i : order) {
            values_deg.push_back(turned(i));
            places.push_back(i);
        }
        if (values_deg.front() == -180.0 && values_deg.size() > 1) {
            values_deg.push_back(180.0);
            places.push_back(places.front());
        }
    }
};

class MatFile {
  public:
    explicit MatFile(const std::string& file)
        : file_(Mat_CreateVer(file.c_str(), "MATLAB 5.0 MAT-file, signature table of SMAT",
                              MAT_FT_MAT5),
                &Mat_Close) {}

    bool isOpen() const { return file_ != nullptr; }
    /// Columns first, as MATLAB has them.
    void add(const std::string& name, std::vector<std::size_t> sizes,
             const std::vector<double>& values) {
        while (sizes.size() < 2)
            sizes.push_back(1);
        put(Mat_VarCreate(name.c_str(), MAT_C_DOUBLE, MAT_T_DOUBLE, static_cast<int>(sizes.size()),
                          sizes.data(), const_cast<double*>(values.data()), MAT_F_DONT_COPY_DATA));
    }
    void add(const std::string& name, const std::string& text) {
        std::size_t sizes[2] = {1, text.size()};
        put(Mat_VarCreate(name.c_str(), MAT_C_CHAR, MAT_T_UTF8, 2, sizes,
                          const_cast<char*>(text.data()), MAT_F_DONT_COPY_DATA));
    }
    bool isWhole() const { return isWhole_; }

  private:
    void put(matvar_t* variable) {
        isWhole_ = isWhole_ && variable != nullptr &&
                   Mat_VarWrite(file_.get(), variable, MAT_COMPRESSION_NONE) == 0;
        Mat_VarFree(variable);
    }

    std::unique_ptr<mat_t, int (*)(mat_t*)> file_;
    bool isWhole_ = true;
};

/// A variable as MATLAB has it: elevation, azimuth, the axes that vary in the order of the table,
/// band.
std::vector<double> arranged(const SignatureTable& table, const TableVariable& variable,
                             const TurnedAzimuths& azimuths) {
    std::vector<double> values;
    // The last axis runs slowest in MATLAB, and fastest in the numbers of choices.
    const std::size_t choices = table.choices();
    std::vector<SignatureTable::Choice> order;
    for (std::size_t i = 0; i < choices; ++i)
        order.push_back(table.choice(i));
    std::ranges::sort(order, [](const auto& a, const auto& b) {
        return std::ranges::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
    });
    for (const ResultColumn* column : variable.ofBand)
        for (const SignatureTable::Choice& choice : order)
            for (const std::size_t azimuth : azimuths.places)
                for (std::size_t row = 0; row < table.elevations_deg().size(); ++row)
                    values.push_back(
                        column == nullptr
                            ? std::nan("")
                            : column->values[table.row(table.direction(row, azimuth), choice)]);
    return values;
}

const TableVariable& patternOf(const TableVariables& variables) {
    for (const char* wanted : {"contrast_intensity", "intensity", "source_intensity"}) {
        const auto found = std::ranges::find(variables.list, wanted, &TableVariable::name);
        if (found != variables.list.end())
            return *found;
    }
    throw irsg::InputError({"signature table", "header", "no intensity",
                            "a column contrast_intensity for the pattern"});
}

void writeInto(MatFile& file, const SignatureTable& table) {
    const TurnedAzimuths azimuths(table.azimuths_deg());
    const TableVariables variables = variablesOf(table);
    std::vector<std::size_t> sizes{table.elevations_deg().size(), azimuths.values_deg.size()};
    std::string layout = "elevation x azimuth";
    for (const SignatureTable::Axis& axis : table.axes()) {
        sizes.push_back(axis.values.size());
        layout += " x " + axis.key;
    }
    if (variables.bands.size() > 1) {
        sizes.push_back(variables.bands.size());
        layout += " x band";
    }

    const TableVariable& pattern = patternOf(variables);
    const std::vector<double> values = arranged(table, pattern, azimuths);
    double most = 0.0;
    for (const double value : values)
        most = std::isfinite(value) ? std::max(most, std::abs(value)) : most;
    const double floor_dB =
        std::floor((most > 0.0 ? 10.0 * std::log10(most) : 0.0) - floorBelowPeak_dB);
    std::vector<double> sizes_dB, signs;
    std::size_t negative = 0;
    for (const double value : values) {
        sizes_dB.push_back(std::isnan(value) ? value : decibelOf(value, floor_dB));
        signs.push_back(value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0);
        negative += value < 0.0 ? 1 : 0;
    }
    file.add("Azimuth", {1, azimuths.values_deg.size()}, azimuths.values_deg);
    file.add("Elevation", {1, table.elevations_deg().size()}, table.elevations_deg());
    file.add("Pattern", sizes, sizes_dB);
    file.add("Sign", sizes, signs);
    file.add("Floor_dB", {1, 1}, {floor_dB});
    file.add("NegativeCells", {1, 1}, {static_cast<double>(negative)});
    file.add("Quantity", pattern.title + " (" + pattern.name + ")");
    file.add("Layout", layout);
    file.add(
        "Note",
        fmt::format("Pattern: 10 log10 of the size of {} in {}, dB (dBW/sr), not below Floor_dB "
                    "= {:.6g}. {} of {} cells are negative, darker than their background: Sign "
                    "is -1 there, and the value is Sign .* 10.^(Pattern/10). Azimuth in deg "
                    "from the nose to starboard, -180 to 180, both ends being the same "
                    "direction; elevation in deg, up.",
                    pattern.name, pattern.unit, floor_dB, negative, values.size()));
    for (const SignatureTable::Axis& axis : table.axes())
        file.add("axis_" + axis.key, {1, axis.values.size()}, axis.values);
    for (std::size_t i = 0; i < variables.bands.size(); ++i)
        if (!variables.bands[i].empty())
            file.add(fmt::format("band_{}", i + 1), variables.bands[i]);
    for (const TableVariable& variable : variables.list) {
        file.add(variable.name, sizes, arranged(table, variable, azimuths));
        file.add("unit_" + variable.name, variable.unit.empty() ? "1" : variable.unit);
    }
    std::string provenance;
    for (const auto& [key, value] : table.table().provenance.entries)
        provenance += key + ": " + value + "\n";
    if (!provenance.empty())
        file.add("Provenance", provenance);
}

bool write(const std::string& name, const void* of) {
    MatFile file(name);
    if (!file.isOpen())
        return false;
    writeInto(file, *static_cast<const SignatureTable*>(of));
    return file.isWhole();
}

std::string matBytes(const SignatureTable& table) {
    std::string bytes = bytesWritten(write, &table);
    // The head says when it was written; equal tables are to be equal files.
    constexpr std::size_t headText = 116;
    std::string head = "MATLAB 5.0 MAT-file, signature table of SMAT";
    head.resize(headText, ' ');
    return bytes.replace(0, std::min(headText, bytes.size()), head);
}

} // namespace

} // namespace smat

extern "C" std::string* smatMatTable(const smat::SignatureTable& table) {
    return new std::string(smat::matBytes(table));
}
