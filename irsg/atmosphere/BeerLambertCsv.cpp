#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/Vacuum.h"
#include "irsg/core/ColumnWords.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Remarks.h"
#include "irsg/radiometry/CurveSampling.h"
#include "irsg/radiometry/SpectralHead.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr std::string_view wavelengthHeader = "wavelength [um]";
constexpr std::string_view extinctionHeader = "extinction [km-1]";
constexpr std::string_view extinctionInMetresHeader = "extinction [m-1]";
constexpr std::string_view solarHeader = "solar_irradiance [W m-2 um-1]";
constexpr std::string_view downHeader = "down_flux [W m-2 um-1]";
constexpr std::string_view upHeader = "up_flux [W m-2 um-1]";
constexpr std::string_view skyHeader = "sky_radiance [W m-2 sr-1 um-1]";
constexpr std::array knownHeaders = {wavelengthHeader, extinctionHeader, extinctionInMetresHeader,
                                     solarHeader,      downHeader,       upHeader,
                                     skyHeader};

constexpr std::string_view atmosphereKey = "air_temperature [K]";
constexpr std::string_view groundKey = "ground_temperature [K]";
constexpr std::string_view skyKey = "sky_temperature [K]";
constexpr std::array knownKeys = {
    std::string_view("name"),   atmosphereKey,           groundKey, skyKey, std::string_view("sun"),
    std::string_view("source"), std::string_view("note")};

/// Air on earth is warmer (the mesopause in summer, 130 K, is its coldest).
constexpr double coldest_K = 100.0;

template <std::size_t count>
std::string listOf(const std::array<std::string_view, count>& words) {
    std::string text;
    for (const std::string_view word : words)
        text += (text.empty() ? "'" : ", '") + std::string(word) + "'";
    return text;
}

template <std::size_t count>
bool holds(const std::array<std::string_view, count>& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

/// A key that looks like a setting: one lower-case word, perhaps with a unit in brackets, or one of
/// ours in another unit.
bool looksLikeSetting(std::string_view key) {
    const std::string_view word = trimmed(key.substr(0, key.find('[')));
    const std::string name = columnHead(key).name;
    return (!word.empty() && word.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == word.npos) ||
           std::ranges::any_of(knownKeys, [&](std::string_view known) {
               return !name.empty() && columnHead(known).name == name;
           });
}

/// One file on its way from cells to parameters; gathers the diagnostics as it goes.
class Reader {
  public:
    explicit Reader(const std::filesystem::path& file)
        : table_(CsvTable::read(file)),
          defaultName_("Beer-Lambert (" + file.filename().string() + ")") {}

    BeerLambertParameters read() {
        readSettings();
        readColumns();
        if (!diagnostics_.empty())
            throw InputError(std::move(diagnostics_));
        for (const std::string& remark : doubtful_)
            remarkOn(table_.file(), remark);
        if (!air_K_)
            remarkOn(table_.file(), "has no '" + std::string(atmosphereKey) + "': the air has " +
                                        numberText(BeerLambertParameters().airTemperature_K) +
                                        " K");
        return parameters();
    }

  private:
    void readSettings() {
        for (const CsvComment& comment : table_.comments()) {
            const std::string_view key = keyOf(comment);
            if (key.empty()) {
                if (looksLikeSetting(comment.key)) {
                    diagnostics_.push_back(table_.diagnostic(comment.line, comment.key,
                                                             "one of " + listOf(knownKeys)));
                }
            } else if (key != "note" && key != "source" && table_.comment(key) != &comment) {
                diagnostics_.push_back(
                    table_.diagnostic(comment.line, comment.key,
                                      "this key once, not again after line " +
                                          std::to_string(table_.comment(key)->line)));
            }
        }
        air_K_ = temperature(atmosphereKey);
        ground_K_ = temperature(groundKey);
        sky_K_ = temperature(skyKey);
        if (const CsvComment* sun = table_.comment("sun")) {
            if (sun->value != "nominal" && sun->value != "none") {
                diagnostics_.push_back(
                    table_.diagnostic(sun->line, sun->value, "'nominal' or 'none' for the sun"));
            }
        }
        if (const CsvComment* name = table_.comment("name"); name && name->value.empty())
            diagnostics_.push_back(table_.diagnostic(name->line, "", "a name"));
    }

    /// The key that a comment has in any of its spellings; "" for none.
    static std::string_view keyOf(const CsvComment& comment) {
        for (const std::string_view known : knownKeys)
            if (!comment.key.empty() && columnHead(comment.key) == columnHead(known))
                return known;
        return {};
    }

    std::optional<double> temperature(std::string_view key) {
        const CsvComment* comment = table_.comment(key);
        if (!comment)
            return std::nullopt;
        const std::string expected = "a temperature of at least 0 K";
        const auto value = table_.number(*comment, diagnostics_, expected);
        if (value && *value < 0.0) {
            diagnostics_.push_back(table_.diagnostic(comment->line, comment->value, expected));
            return std::nullopt;
        }
        if (value && *value > 0.0 && *value < coldest_K)
            doubtful_.push_back("line " + std::to_string(comment->line) + ": " + comment->key +
                                " is " + comment->value + " K, below " + numberText(coldest_K) +
                                " K, colder than any air; degrees Celsius taken for K?");
        return value;
    }

    void readColumns() {
        if (table_.rows().empty()) {
            diagnostics_.push_back(
                table_.diagnostic("no rows", "a header and at least two rows of numbers"));
            return;
        }
        const CsvRow& header = table_.rows().front();
        names_.clear();
        for (const CsvCell& cell : header.cells) {
            names_.push_back(nameOf(cell));
            if (!holds(knownHeaders, names_.back()))
                diagnostics_.push_back(table_.diagnostic(cell, "one of " + listOf(knownHeaders)));
            else if (columns_.contains(names_.back()))
                diagnostics_.push_back(table_.diagnostic(cell, "each column once"));
            columns_[names_.back()];
        }
        for (const std::string_view required : {wavelengthHeader, extinctionHeader}) {
            if (!columns_.contains(std::string(required))) {
                diagnostics_.push_back(
                    table_.diagnostic(header.line, header.cells.front().text,
                                      "a column '" + std::string(required) + "'"));
            }
        }
        const CsvComment* sun = table_.comment("sun");
        if (sun && columns_.contains(std::string(solarHeader))) {
            diagnostics_.push_back(table_.diagnostic(sun->line, sun->value,
                                                     "either this key or the column '" +
                                                         std::string(solarHeader) + "', not both"));
        }
        for (std::size_t i = 1; i < table_.rows().size(); ++i)
            readRow(table_.rows()[i]);
        if (table_.rows().size() < 3) {
            diagnostics_.push_back(
                table_.diagnostic(std::to_string(table_.rows().size() - 1) + " rows of numbers",
                                  "at least two rows of numbers"));
        }
    }

    /// The head that we give a column: any of a spectral axis is that of wavelengths.
    std::string nameOf(const CsvCell& cell) {
        if (const auto axis = spectralHead(cell.text); axis && axis->axis) {
            axis_ = *axis->axis;
            return std::string(wavelengthHeader);
        }
        ColumnHead head = columnHead(cell.text);
        if (head.name == "k")
            head.name = "extinction";
        if (head == columnHead(extinctionInMetresHeader)) {
            extinctionFactor_ = 1.0;
            return std::string(extinctionHeader);
        }
        for (const std::string_view known : knownHeaders)
            if (columnHead(known) == head)
                return std::string(known);
        return cell.text;
    }

    void readRow(const CsvRow& row) {
        if (row.cells.size() != names_.size()) {
            diagnostics_.push_back(
                table_.diagnostic(row.line, std::to_string(row.cells.size()) + " cells",
                                  std::to_string(names_.size()) + " cells as in the header"));
            return;
        }
        for (std::size_t k = 0; k < row.cells.size(); ++k) {
            const bool isAxis = names_[k] == wavelengthHeader;
            const std::string expected = isAxis ? std::string("a value above 0 ") + axisUnit(axis_)
                                                : "a number of at least 0";
            const auto value = table_.number(row.cells[k], diagnostics_, expected);
            if (!value)
                continue;
            std::vector<double>& column = columns_[names_[k]];
            const double number = isAxis && *value > 0.0 ? wavelengthOn_um(axis_, *value) : *value;
            const bool descends = column.size() > 1 && column[1] < column[0];
            if (*value < 0.0 || (isAxis && *value == 0.0)) {
                diagnostics_.push_back(table_.diagnostic(row.cells[k], expected));
            } else if (isAxis && !column.empty() &&
                       (number == column.back() ||
                        (column.size() > 1 && (number < column.back()) != descends))) {
                diagnostics_.push_back(table_.diagnostic(
                    row.cells[k], "an axis that " + std::string(descends ? "descends" : "ascends") +
                                      " strictly in um, as above"));
            }
            column.push_back(number);
        }
    }

    std::vector<double> ascending(const std::string& header) const {
        const std::vector<double>& axis = columns_.at(std::string(wavelengthHeader));
        std::vector<double> values = columns_.at(header);
        if (axis.back() < axis.front())
            std::ranges::reverse(values);
        return values;
    }

    /// The spectrum of a column, or no value where the file has none.
    std::optional<Spectrum> spectrum(std::string_view header, double factor = 1.0) const {
        if (!columns_.contains(std::string(header)))
            return std::nullopt;
        std::vector<double> values = ascending(std::string(header));
        for (double& value : values)
            value *= factor;
        return Spectrum(ascending(std::string(wavelengthHeader)), std::move(values),
                        Spectrum::Outside::hold, table_.file());
    }

    BeerLambertParameters parameters() const {
        BeerLambertParameters result;
        const CsvComment* name = table_.comment("name");
        result.name = name ? name->value : defaultName_;
        result.airTemperature_K = air_K_.value_or(result.airTemperature_K);
        result.groundTemperature_K = ground_K_.value_or(result.airTemperature_K);
        result.extinction_per_m = *spectrum(extinctionHeader, extinctionFactor_);

        // What the file does not give follows from its temperatures.
        const std::vector<double> axis = ascending(std::string(wavelengthHeader));
        const SpectralRange base{axis.front(), axis.back()};
        const double overhead_K = sky_K_.value_or(result.airTemperature_K);
        const auto down = spectrum(downHeader);
        const auto up = spectrum(upHeader);
        result.downwardFlux_W_m2_um = down ? *down : sampledPlanck(overhead_K, base, pi);
        result.upwardFlux_W_m2_um = up ? *up : sampledPlanck(result.groundTemperature_K, base, pi);
        result.skyRadiance_W_m2_sr_um = spectrum(skyHeader);
        if (!result.skyRadiance_W_m2_sr_um && sky_K_)
            result.skyRadiance_W_m2_sr_um = sampledPlanck(*sky_K_, base);
        const CsvComment* sun = table_.comment("sun");
        if (const auto solar = spectrum(solarHeader))
            result.solarIrradiance_W_m2_um = *solar;
        else if (!sun || sun->value == "nominal")
            result.solarIrradiance_W_m2_um = extraterrestrialSolarIrradiance(base);
        return result;
    }

    CsvTable table_;
    std::string defaultName_;
    std::vector<Diagnostic> diagnostics_;
    SpectralAxis axis_ = SpectralAxis::wavelength;
    double extinctionFactor_ = 1e-3;                     ///< of a value in the file, m-1
    std::vector<std::string> names_;                     ///< of the columns, as we call them
    std::map<std::string, std::vector<double>> columns_; ///< the axis in um
    std::vector<std::string> doubtful_; ///< remarks on values that are rather in another unit
    std::optional<double> air_K_;
    std::optional<double> ground_K_;
    std::optional<double> sky_K_;
};

} // namespace

BeerLambert BeerLambert::fromCsv(const std::filesystem::path& file) {
    return BeerLambert(Reader(file).read());
}

} // namespace irsg
