#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "irsg/atmosphere/SpectraAtmosphere.h"
#include "irsg/core/BoundedValues.h"
#include "irsg/core/ColumnText.h"
#include "irsg/core/ColumnWords.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/Quantity.h"
#include "irsg/core/Utf8.h"
#include "irsg/radiometry/SpectralHead.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr std::pair<AtmosphereProperty, Quantity> columnsOfProperties[] = {
    {AtmosphereProperty::transmittance, Quantity::transmittance},
    {AtmosphereProperty::pathRadiance, Quantity::pathRadiance},
    {AtmosphereProperty::backgroundRadiance, Quantity::backgroundRadiance},
    {AtmosphereProperty::solarIrradiance, Quantity::solarIrradiance},
    {AtmosphereProperty::upwardFlux, Quantity::upwardFlux},
    {AtmosphereProperty::downwardFlux, Quantity::downwardFlux},
    {AtmosphereProperty::scatteringOpticalDepth, Quantity::scatteringOpticalDepth}};

constexpr std::string_view lastBegins = "transmittance_last_", lastEnds = "m";

/// Of a column of the transmittance of the last metres of the path, m; no value for another one.
std::optional<double> lastMetres(std::string_view title) {
    if (!title.starts_with(lastBegins) || !title.ends_with(lastEnds))
        return std::nullopt;
    title.remove_prefix(lastBegins.size());
    title.remove_suffix(lastEnds.size());
    const std::optional<double> distance_m = parseNumber(title);
    return distance_m && *distance_m > 0.0 ? distance_m : std::nullopt;
}

std::string knownSpectra() {
    std::string text =
        "'" + columnHeader(Quantity::wavenumber) + "', '" + columnHeader(Quantity::wavelength);
    for (const auto& [property, quantity] : columnsOfProperties)
        text += "', '" + columnHeader(quantity);
    return text + "', '" + std::string(lastBegins) + "50" + std::string(lastEnds) + "'";
}

/// One file on its way from cells to parameters; gathers the diagnostics as it goes.
class SpectraReader {
  public:
    explicit SpectraReader(const std::filesystem::path& file) : table_(CsvTable::read(file)) {
        const CsvComment* atmosphere = table_.comment("atmosphere");
        name_ =
            (atmosphere ? atmosphere->value + ", " : "") + "spectra of " + file.filename().string();
    }

    SpectraAtmosphereParameters read() {
        readColumns();
        SpectraAtmosphereParameters result = parameters();
        if (!diagnostics_.empty())
            throw InputError(std::move(diagnostics_));
        shares_.remark(table_.file());
        return result;
    }

  private:
    void readColumns() {
        if (table_.rows().size() < 3) {
            diagnostics_.push_back(table_.diagnostic(
                table_.rows().empty()
                    ? "no rows"
                    : std::to_string(table_.rows().size() - 1) + " rows of numbers",
                "a header and at least two rows of numbers"));
            throw InputError(std::move(diagnostics_));
        }
        const CsvRow& header = table_.rows().front();
        for (CsvCell cell : header.cells) {
            const auto axis = spectralHead(cell.text);
            wavelengths_ = axis && axis->axis && axis->axis != SpectralAxis::wavenumber
                               ? *axis->axis
                               : wavelengths_;
            titles_.push_back(cell.text = titleOf(cell.text));
            const bool isKnown = cell.text == columnHeader(Quantity::wavenumber) ||
                                 cell.text == columnHeader(Quantity::wavelength) ||
                                 lastMetres(cell.text) ||
                                 std::ranges::any_of(columnsOfProperties, [&](const auto& entry) {
                                     return cell.text == columnHeader(entry.second);
                                 });
            if (!isKnown)
                diagnostics_.push_back(table_.diagnostic(cell, "one of " + knownSpectra()));
            else if (columns_.contains(cell.text))
                diagnostics_.push_back(table_.diagnostic(cell, "each column once"));
            columns_[cell.text];
        }
        if (!columns_.contains(columnHeader(Quantity::wavelength))) {
            diagnostics_.push_back(
                table_.diagnostic(header.line, header.cells.front().text,
                                  "a column '" + columnHeader(Quantity::wavelength) + "'"));
        }
        for (std::size_t i = 1; i < table_.rows().size(); ++i)
            readRow(table_.rows()[i]);
        if (diagnostics_.empty())
            checkAxis();
    }

    /// The title that we give a column: any of a spectral axis of wavelengths is that in um.
    static std::string titleOf(const std::string& head) {
        if (const auto axis = spectralHead(head); axis && axis->axis)
            return columnHeader(axis->axis == SpectralAxis::wavenumber ? Quantity::wavenumber
                                                                       : Quantity::wavelength);
        for (const auto& [property, quantity] : columnsOfProperties)
            if (columnHead(head) == columnHead(columnHeader(quantity)))
                return columnHeader(quantity);
        return head;
    }

    void readRow(const CsvRow& row) {
        if (row.cells.size() != titles_.size()) {
            diagnostics_.push_back(
                table_.diagnostic(row.line, std::to_string(row.cells.size()) + " cells",
                                  std::to_string(titles_.size()) + " cells as in the header"));
            return;
        }
        for (std::size_t k = 0; k < row.cells.size(); ++k) {
            const std::string& title = titles_[k];
            const bool isAxis = title == columnHeader(Quantity::wavelength) ||
                                title == columnHeader(Quantity::wavenumber);
            const bool isShare =
                title == columnHeader(Quantity::transmittance) || lastMetres(title);
            const std::string expected = isAxis    ? "a number above 0"
                                         : isShare ? "a number from 0 to 1"
                                                   : "a number of at least 0";
            const auto value = table_.number(row.cells[k], diagnostics_, expected);
            const std::string place = "line " + std::to_string(row.line) + ", column " +
                                      std::to_string(row.cells[k].column);
            const auto taken = value && isShare ? shares_.take(*value, place) : value;
            if (value && (!taken || *taken < 0.0 || (isAxis && *taken == 0.0)))
                diagnostics_.push_back(table_.diagnostic(row.cells[k], expected));
            const bool isWavelength = title == columnHeader(Quantity::wavelength);
            columns_[title].push_back(isWavelength && taken ? wavelengthOn_um(wavelengths_, *taken)
                                                            : taken.value_or(0.0));
        }
    }

    /// Wavelengths go one way, and wavenumbers say the same.
    void checkAxis() {
        const std::vector<double>& axis = columns_.at(columnHeader(Quantity::wavelength));
        isDescending_ = axis.front() > axis.back();
        const auto wavenumbers = columns_.find(columnHeader(Quantity::wavenumber));
        for (std::size_t i = 0; i < axis.size(); ++i) {
            const int line = table_.rows()[i + 1].line;
            if (i > 0 && !(isDescending_ ? axis[i] < axis[i - 1] : axis[i] > axis[i - 1])) {
                diagnostics_.push_back(
                    table_.diagnostic(line, numberText(axis[i]) + " um",
                                      std::string(isDescending_ ? "less" : "more") + " than " +
                                          numberText(axis[i - 1]) + " um: wavelengths go one way"));
            }
            if (wavenumbers != columns_.end() &&
                !(std::abs(wavenumbers->second[i] * axis[i] - 1e4) <= 1e-2)) {
                diagnostics_.push_back(
                    table_.diagnostic(line, numberText(wavenumbers->second[i]) + " cm-1",
                                      "the wavenumber of " + numberText(axis[i]) + " um"));
            }
        }
    }

    std::vector<double> ascending(const std::string& header) const {
        std::vector<double> values = columns_.at(header);
        if (isDescending_)
            std::ranges::reverse(values);
        return values;
    }

    std::optional<double> setting(const char* key, double least, double most) {
        const CsvComment* comment = table_.comment(key);
        if (!comment)
            return std::nullopt;
        const std::string expected =
            std::isfinite(most) ? "a number from " + numberText(least) + " to " + numberText(most)
                                : "a number of at least " + numberText(least);
        const auto value = table_.number(*comment, diagnostics_, expected);
        if (value && !(*value >= least && *value <= most))
            diagnostics_.push_back(table_.diagnostic(comment->line, comment->value, expected));
        return value;
    }

    SpectraAtmosphereParameters parameters() {
        SpectraAtmosphereParameters result;
        result.name = name_;
        const auto sensor_m = setting("sensor_altitude [m]", 0.0, HUGE_VAL);
        const auto range_m = setting("range [m]", 0.0, HUGE_VAL);
        const auto elevation_deg = setting("los_elevation [deg]", -90.0, 90.0);
        const auto azimuth_deg = setting("los_azimuth [deg]", -360.0, 360.0);
        const auto sunAzimuth_deg = setting("sun_azimuth [deg]", -360.0, 360.0);
        const auto sunElevation_deg = setting("sun_elevation [deg]", -90.0, 90.0);
        result.targetAltitude_m = setting("target_altitude [m]", 0.0, HUGE_VAL);
        result.ambientTemperature_K = setting("ambient_temperature [K]", 0.0, HUGE_VAL);
        if (sensor_m && range_m && result.targetAltitude_m)
            result.path = AtmosphericPath{*sensor_m, *result.targetAltitude_m, *range_m};
        if (sensor_m && elevation_deg) {
            result.sight =
                LineOfSight{*sensor_m, radians(*elevation_deg), radians(azimuth_deg.value_or(0.0))};
        }
        if (sunElevation_deg) {
            result.sun =
                SunPosition{radians(sunAzimuth_deg.value_or(0.0)), radians(*sunElevation_deg)};
        }
        if (!diagnostics_.empty())
            return result;
        const auto spectrumOf = [&](const std::string& title) {
            return Spectrum(ascending(columnHeader(Quantity::wavelength)), ascending(title),
                            Spectrum::Outside::hold, table_.file());
        };
        for (const auto& [property, quantity] : columnsOfProperties)
            if (columns_.contains(columnHeader(quantity)))
                result.spectra.emplace(property, spectrumOf(columnHeader(quantity)));
        for (const auto& [title, values] : columns_)
            if (const auto distance_m = lastMetres(title))
                result.lastTransmittance.emplace(*distance_m, spectrumOf(title));
        return result;
    }

    CsvTable table_;
    std::string name_;
    std::vector<Diagnostic> diagnostics_;
    std::vector<std::string> titles_; ///< of the columns, as we call them
    SpectralAxis wavelengths_ = SpectralAxis::wavelength;
    std::map<std::string, std::vector<double>> columns_;
    bool isDescending_ = false;
    BoundedValues shares_{0.0, 1.0};
};

} // namespace

SpectraAtmosphere SpectraAtmosphere::fromCsv(const std::filesystem::path& file) {
    return SpectraAtmosphere(SpectraReader(file).read());
}

bool SpectraAtmosphere::isSpectraCsv(const std::filesystem::path& file) {
    std::error_code failure;
    if (!std::filesystem::is_regular_file(file, failure))
        return false;
    // What is asked for stands among the first lines.
    const std::string bytes = readFileBeginning(file, std::size_t{1} << 20);
    const std::string decoded = decodedUtf16(bytes);
    std::string_view rest = decoded.empty() ? withoutByteOrderMark(bytes) : decoded;
    while (!rest.empty()) {
        const std::string_view line = trimmed(takeLine(rest));
        if (!isCommentLine(line))
            break;
        const std::string_view text = trimmed(line.substr(line.find('#') + 1));
        if (text.starts_with("analysis:") &&
            trimmed(text.substr(std::string_view("analysis:").size())).starts_with("radiative")) {
            return true;
        }
    }
    return false;
}

} // namespace irsg
