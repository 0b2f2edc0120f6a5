#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "tools/atmosphere-tables/ContinuumTables.h"
#include "tools/atmosphere-tables/DataTable.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"

namespace smat::tables {

namespace {

constexpr double amagat2 = 2.686780111e19 * 2.686780111e19;

/// What was measured at one temperature, cm-1 amagat-2 over ascending wavenumbers.
struct Measurement {
    std::vector<double> wavenumber_per_cm, coefficient;

    /// Mean of what lies about a wavenumber; false where nothing does.
    bool mean(double nu, double halfWidth_per_cm, double& value) const {
        const auto first = std::ranges::lower_bound(wavenumber_per_cm, nu - halfWidth_per_cm);
        const auto last = std::ranges::upper_bound(wavenumber_per_cm, nu + halfWidth_per_cm);
        if (nu < wavenumber_per_cm.front() || nu > wavenumber_per_cm.back() || first == last)
            return false;
        double sum = 0.0;
        for (auto at = first; at != last; ++at)
            sum += coefficient[static_cast<std::size_t>(at - wavenumber_per_cm.begin())];
        value = sum / static_cast<double>(last - first);
        return true;
    }
};

using ByTemperature = std::map<double, Measurement>;

/// The rotational band and the fundamental.
std::array<ByTemperature, 2> readMeasurements(const std::filesystem::path& file) {
    std::array<ByTemperature, 2> bands;
    std::vector<irsg::Diagnostic> diagnostics;
    std::size_t number = 0;
    for (const std::string& line : irsg::lbl::readTextLines(file)) {
        ++number;
        if (line.empty() || line[0] == '#' || line.starts_with("temperature"))
            continue;
        std::istringstream cells(line);
        std::array<double, 3> values{};
        bool good = true;
        for (double& value : values) {
            std::string cell;
            std::getline(cells, cell, ',');
            const auto found = irsg::parseNumber(irsg::trimmed(cell));
            good = good && found;
            value = found.value_or(0.0);
        }
        if (!good) {
            diagnostics.push_back({file.string(), "line " + std::to_string(number), line,
                                   "temperature, wavenumber, coefficient"});
            continue;
        }
        Measurement& measurement = bands[values[1] < 1000.0 ? 0 : 1][values[0]];
        measurement.wavenumber_per_cm.push_back(values[1]);
        measurement.coefficient.push_back(values[2] * amagat2);
    }
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
    return bands;
}

/// k(T) = k273 exp(slope (1/T - 1/273.15)), fitted to what was measured.
struct Fit {
    double k273 = 0.0, slope_K = 0.0;
    double at(double temperature_K) const {
        return k273 * std::exp(slope_K * (1.0 / temperature_K - 1.0 / 273.15));
    }
};

struct Point {
    double temperature_K, coefficient, spread;
};

Fit fitted(const std::vector<Point>& points) {
    Fit fit;
    for (const Point& point : points)
        fit.k273 = std::max(fit.k273, point.coefficient);
    // Gauss-Newton for ln k273 and the slope, in units of 1000 K.
    for (int iteration = 0; iteration < 50 && fit.k273 > 0.0; ++iteration) {
        double aa = 1e-9, ab = 0.0, bb = 1e-9, a = 0.0, b = 0.0;
        for (const Point& point : points) {
            const double model = fit.at(point.temperature_K), weight = 1.0 / point.spread;
            const double da = model * weight;
            const double db = da * 1e3 * (1.0 / point.temperature_K - 1.0 / 273.15);
            const double residual = (point.coefficient - model) * weight;
            aa += da * da, ab += da * db, bb += db * db, a += da * residual, b += db * residual;
        }
        bb += 0.02 * aa; // a slope that the points do not determine stays small
        b -= 0.02 * aa * fit.slope_K * 1e-3;
        const double determinant = aa * bb - ab * ab;
        fit.k273 *= std::exp(std::clamp((bb * a - ab * b) / determinant, -0.5, 0.5));
        fit.slope_K += 1e3 * std::clamp((aa * b - ab * a) / determinant, -0.3, 0.3);
        // Beyond these only the zero of a measurement can lead.
        fit.slope_K = std::clamp(fit.slope_K, -1800.0, 200.0);
    }
    return fit;
}

struct Band {
    const char* file;
    double coldest_K, warmest_K; ///< temperatures used
    double lower_per_cm, upper_per_cm, step_per_cm;
    const char* error;
};

void write(const Folders& folders, const ByTemperature& measured, const Band& band) {
    std::array<std::vector<double>, 3> columns;
    for (double nu = band.lower_per_cm; nu <= band.upper_per_cm; nu += band.step_per_cm) {
        std::vector<Point> points;
        for (const auto& [temperature_K, measurement] : measured) {
            double value = 0.0;
            if (temperature_K < band.coldest_K || temperature_K > band.warmest_K ||
                !measurement.mean(nu, 0.5 * band.step_per_cm, value))
                continue;
            // The zero of the colder measurements is good to 2e-8, of the others to 1e-9.
            const double zero = nu > 1000.0 && temperature_K < 260.0 ? 2e-8 : 1e-9;
            points.push_back({temperature_K, value, zero + 0.01 * std::abs(value)});
        }
        const bool end = nu == band.lower_per_cm || nu + band.step_per_cm > band.upper_per_cm;
        const Fit fit = end && nu > 1000.0 ? Fit{} : fitted(points);
        columns[0].push_back(nu);
        columns[1].push_back(fit.k273);
        columns[2].push_back(fit.slope_K);
    }
    Writer writer(
        "# source: HITRAN collision-induced absorption N2-N2 (C. Richard et al. 2012, J. Quant. "
        "Spectrosc. Radiat. Transfer 113, 1276; I. E. Gordon et al. 2022, 277, 107949)\n");
    writer.add("wavenumber [cm-1]", columns[0]);
    writer.add("k273 [cm-1 amagat-2]", columns[1]);
    writer.add("slope [K]", columns[2]);
    writer.write(folders.out / band.file,
                 "# Collision-induced absorption of nitrogen by nitrogen\n"
                 "# recipe: atmosphere-tables continuum; means over a step, k273 exp(slope (1/T - "
                 "1/273.15 K)) fitted by least squares to the measurements from " +
                     irsg::numberText(band.coldest_K) + " to " + irsg::numberText(band.warmest_K) +
                     " K\n# units: cm-1; cm-1 amagat-2, K\n# expected error: " + band.error + "\n",
                 0.0, 1e9);
}

} // namespace

void makeNitrogenContinuum(const Folders& folders) {
    const auto bands = readMeasurements(folders.data / "continuum" / "n2_n2_cia_hitran2011.csv.gz");
    write(folders, bands[0],
          {"continuum-nitrogen-rotation.csv", 180.0, 320.0, 200.0, 550.0, 5.0,
           "rms from the measurements of 186 to 310 K 8 % up to 400 cm-1, 1e-9 cm-1 amagat-2 "
           "beyond; at 144 K 33 % low from 200 to 300 cm-1"});
    write(folders, bands[1],
          {"continuum-nitrogen-fundamental.csv", 220.0, 350.0, 2010.0, 2720.0, 2.5,
           "rms from the measurements 2.5 % from 2200 to 2500 cm-1, 6 % from 2500 to 2600, 10 % "
           "from 2100 to 2200 (but for 233.7 K, whose zero is off by 2e-8 cm-1 amagat-2); beyond, "
           "the zero of the cold measurements, 2e-8; as a partner water counts as nitrogen, though "
           "later work has it many times as strong; the first overtone (4300 to 5000 cm-1; 0.003 "
           "in depth over 5 km at the ground) is not held"});
}

} // namespace smat::tables
