#include "irsg/atmosphere/import/SpectralRun.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Half a unit of the third decimal, with which optical depths are printed.
constexpr double depthRounding = 5e-4;

struct Alias {
    std::string_view header; ///< lower case, letters and digits only
    RunColumn column;
};
constexpr std::array aliases = {
    Alias{"freq", RunColumn::wavenumber},
    Alias{"freqcm1", RunColumn::wavenumber},
    Alias{"frequency", RunColumn::wavenumber},
    Alias{"wavenumber", RunColumn::wavenumber},
    Alias{"wavlen", RunColumn::wavenumber},
    Alias{"wavelength", RunColumn::wavenumber},
    Alias{"tottrans", RunColumn::transmittance},
    Alias{"totaltrans", RunColumn::transmittance},
    Alias{"totaltransmittance", RunColumn::transmittance},
    Alias{"combintrans", RunColumn::transmittance},
    Alias{"trans", RunColumn::transmittance},
    Alias{"depth", RunColumn::depth},
    Alias{"natlogpathtrans", RunColumn::depth},
    Alias{"logcombin", RunColumn::depth},
    Alias{"logtotal", RunColumn::depth},
    Alias{"pththrml", RunColumn::thermal},
    Alias{"thrmlem", RunColumn::thermal},
    Alias{"pathemission", RunColumn::thermal},
    Alias{"thrmlsct", RunColumn::thermalScatter},
    Alias{"paththermalscat", RunColumn::thermalScatter},
    Alias{"surfemis", RunColumn::surface},
    Alias{"surfaceemission", RunColumn::surface},
    Alias{"solscat", RunColumn::solarScatter},
    Alias{"multscat", RunColumn::solarScatter},
    Alias{"pathmultiplescat", RunColumn::solarScatter},
    Alias{"singscat", RunColumn::singleScatter},
    Alias{"pathsinglescat", RunColumn::singleScatter},
    Alias{"grndrflt", RunColumn::ground},
    Alias{"groundreflect", RunColumn::ground},
    Alias{"totalrad", RunColumn::total},
    Alias{"totalradiance", RunColumn::total},
    Alias{"solobs", RunColumn::sunAtObserver},
    Alias{"solatobs", RunColumn::sunAtObserver},
    Alias{"irradianceatobserver", RunColumn::sunAtObserver},
    Alias{"soltr", RunColumn::sunTransmitted},
    Alias{"soltrans", RunColumn::sunTransmitted},
    Alias{"transmittedsolar", RunColumn::sunTransmitted},
    Alias{"molecscat", RunColumn::molecularScatter},
    Alias{"aercldtrans", RunColumn::aerosol},
    Alias{"transaercld", RunColumn::aerosol},
    Alias{"aercldabtrns", RunColumn::aerosolAbsorption},
    Alias{"abtrnsaercld", RunColumn::aerosolAbsorption},
};

const char* headerOf(RunColumn column) {
    switch (column) {
    case RunColumn::wavenumber:
        return "FREQ";
    case RunColumn::transmittance:
        return "TOT_TRANS";
    case RunColumn::thermal:
        return "PTH_THRML";
    case RunColumn::solarScatter:
        return "SOL_SCAT";
    case RunColumn::total:
        return "TOTAL_RAD";
    case RunColumn::sunTransmitted:
        return "SOL TR";
    case RunColumn::surface:
        return "SURF_EMIS";
    case RunColumn::ground:
        return "GRND_RFLT";
    case RunColumn::depth:
        return "DEPTH";
    case RunColumn::thermalScatter:
        return "THRML_SCT";
    case RunColumn::singleScatter:
        return "SING_SCAT";
    case RunColumn::sunAtObserver:
        return "SOL@OBS";
    case RunColumn::molecularScatter:
        return "MOLEC SCAT";
    case RunColumn::aerosol:
        return "AER+CLD TRANS";
    case RunColumn::aerosolAbsorption:
        return "AER+CLD abTRNS";
    }
    return "";
}

/// One table on its way into a run.
class Filler {
  public:
    Filler(SpectralRun& run, const RunTable& table, std::vector<Diagnostic>& diagnostics)
        : run_(run), table_(table), diagnostics_(diagnostics), rows_(table.positions.size()) {}

    void fill() {
        const std::size_t before = diagnostics_.size();
        if (rows_ < 2)
            report("", std::to_string(rows_) + " rows of numbers", "at least two wavenumbers");
        std::vector<RunColumn> required = {RunColumn::wavenumber, RunColumn::transmittance};
        if (run_.kind == RunKind::sunlight)
            required.push_back(RunColumn::sunTransmitted);
        else if (run_.kind != RunKind::transmittance)
            required.insert(required.end(), {RunColumn::thermal, RunColumn::total});
        if (run_.kind == RunKind::solarRadiance)
            required.push_back(RunColumn::solarScatter);
        for (const RunColumn column : required)
            require(column);
        if (diagnostics_.size() != before)
            return;
        fillWavenumbers();
        fillTransmittance();
        if (run_.kind == RunKind::thermalRadiance || run_.kind == RunKind::solarRadiance)
            fillRadiances();
        if (run_.kind == RunKind::sunlight)
            run_.solarIrradiance_W_m2_um = density(RunColumn::sunTransmitted);
        else if (run_.kind == RunKind::solarRadiance && whole(RunColumn::sunAtObserver))
            run_.solarIrradiance_W_m2_um = density(RunColumn::sunAtObserver);
        fillScatteringDepth();
        if (table_.unit != SpectralUnit::wavenumber && diagnostics_.size() == before) {
            for (std::vector<double>* values :
                 {&run_.wavenumbers_per_cm, &run_.transmittance, &run_.pathRadiance_W_m2_sr_um,
                  &run_.totalRadiance_W_m2_sr_um, &run_.solarIrradiance_W_m2_um,
                  &run_.scatteringDepth}) {
                std::ranges::reverse(*values);
            }
        }
    }

  private:
    void report(std::string position, std::string value, std::string expected) {
        diagnostics_.push_back(
            {table_.file, std::move(position), std::move(value), std::move(expected)});
    }

    const std::vector<double>* find(RunColumn column) const {
        const auto found = table_.columns.find(column);
        return found == table_.columns.end() ? nullptr : &found->second;
    }

    bool whole(RunColumn column) const {
        const std::vector<double>* values = find(column);
        return values && std::ranges::none_of(*values, [](double x) { return std::isnan(x); });
    }

    void require(RunColumn column) {
        const std::vector<double>* values = find(column);
        if (!values) {
            report(rows_ ? table_.positions.front() : "",
                   "no column " + std::string(headerOf(column)),
                   "this column in a run of " + std::string(name(run_.kind)));
            return;
        }
        for (std::size_t i = 0; i < rows_; ++i) {
            if (std::isnan((*values)[i])) {
                report(table_.positions[i], "a blank " + std::string(headerOf(column)),
                       "a number in this column");
            }
        }
    }

    void fillWavenumbers() {
        const std::vector<double>& axis = *find(RunColumn::wavenumber);
        for (std::size_t i = 0; i < rows_; ++i) {
            if (!(axis[i] > 0.0)) {
                report(table_.positions[i], numberText(axis[i]), "a positive " + axisName());
            } else if (i > 0 && !(axis[i] > axis[i - 1])) {
                report(table_.positions[i], axisName() + " " + numberText(axis[i]),
                       "ascending, above " + numberText(axis[i - 1]));
            }
            run_.wavenumbers_per_cm.push_back(table_.unit == SpectralUnit::wavenumber ? axis[i]
                                              : table_.unit == SpectralUnit::micrometre
                                                  ? wavenumberFromWavelength_per_cm(axis[i])
                                                  : 1e7 / axis[i]);
        }
    }

    std::string axisName() const {
        return table_.unit == SpectralUnit::wavenumber ? "wavenumber" : "wavelength";
    }

    void fillTransmittance() {
        const std::vector<double>& printed = *find(RunColumn::transmittance);
        const std::vector<double>* depth = find(RunColumn::depth);
        for (std::size_t i = 0; i < rows_; ++i) {
            double tau = printed[i];
            if (!(tau >= -1e-6 && tau <= 1.0 + 1e-4))
                report(table_.positions[i], "transmittance " + numberText(tau), "0 to 1");
            tau = std::clamp(tau, 0.0, 1.0);
            // The depth has more digits where the transmittance is small.
            if (depth && (*depth)[i] > 0.0 && table_.transmittanceRounding >= depthRounding * tau) {
                const double fromDepth = std::exp(-(*depth)[i]);
                const double slack =
                    1.01 * (table_.transmittanceRounding + 2 * depthRounding * tau);
                if (std::abs(fromDepth - tau) <= slack)
                    tau = fromDepth;
            }
            run_.transmittance.push_back(tau);
        }
    }

    /// W m-2 (sr-1) um-1 from what the file holds; blanks are 0.
    std::vector<double> density(RunColumn column) {
        std::vector<double> values(rows_, 0.0);
        const std::vector<double>* found = find(column);
        for (std::size_t i = 0; found && i < rows_; ++i) {
            const double value = std::isnan((*found)[i]) ? 0.0 : (*found)[i];
            if (value < 0.0) {
                report(table_.positions[i], std::string(headerOf(column)) + " " + numberText(value),
                       "at least 0");
            }
            const double nu = run_.wavenumbers_per_cm[i];
            values[i] = table_.unit == SpectralUnit::wavenumber
                            ? perMicrometreFromPerWavenumber(1e4 * value, nu)
                        : table_.unit == SpectralUnit::micrometre ? 1e4 * value
                                                                  : 10.0 * value;
        }
        return values;
    }

    void fillRadiances() {
        const std::vector<double> thermal = density(RunColumn::thermal);
        const std::vector<double> thermalScatter = density(RunColumn::thermalScatter);
        const std::vector<double> solar = density(RunColumn::solarScatter);
        const std::vector<double> single = density(RunColumn::singleScatter);
        const std::vector<double> surface = density(RunColumn::surface);
        const std::vector<double> ground = density(RunColumn::ground);
        run_.totalRadiance_W_m2_sr_um = density(RunColumn::total);
        const std::vector<double>& total = run_.totalRadiance_W_m2_sr_um;

        // The parts whose sum closes with TOTAL_RAD; what the version's names mean comes first.
        std::array<std::pair<double, double>, 4> parts = {
            {{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}}};
        if (!table_.sumsIncluded)
            std::swap(parts[0], parts[1]);
        double best = std::numeric_limits<double>::infinity();
        for (const auto& [withThermalScatter, withSingle] : parts) {
            std::vector<double> path(rows_);
            double missed = 0.0;
            double sum = 0.0;
            for (std::size_t i = 0; i < rows_; ++i) {
                path[i] = thermal[i] + withThermalScatter * thermalScatter[i] + solar[i] +
                          withSingle * single[i];
                missed += std::abs(total[i] - surface[i] - ground[i] - path[i]);
                sum += total[i];
            }
            const double miss = sum > 0.0 ? missed / sum : missed;
            if (miss < best - 1e-4) {
                best = miss;
                run_.pathRadiance_W_m2_sr_um = std::move(path);
            }
        }
        if (best > 0.01) {
            run_.warnings.push_back("TOTAL_RAD differs from the sum of its parts by " +
                                    numberText(std::round(1e3 * best) / 10.0) + " %");
        }
    }

    void fillScatteringDepth() {
        if (!whole(RunColumn::molecularScatter) || !whole(RunColumn::aerosol) ||
            !whole(RunColumn::aerosolAbsorption)) {
            return;
        }
        // Transmittances of four digits reach down to 5e-5; what is less counts as that.
        const double least = std::max(table_.transmittanceRounding, 1e-30);
        const auto depth = [&](RunColumn column, std::size_t i) {
            return -std::log(std::clamp((*find(column))[i], least, 1.0));
        };
        for (std::size_t i = 0; i < rows_; ++i) {
            run_.scatteringDepth.push_back(
                depth(RunColumn::molecularScatter, i) +
                std::max(0.0,
                         depth(RunColumn::aerosol, i) - depth(RunColumn::aerosolAbsorption, i)));
        }
    }

    SpectralRun& run_;
    const RunTable& table_;
    std::vector<Diagnostic>& diagnostics_;
    std::size_t rows_;
};

} // namespace

const char* name(RunKind kind) {
    switch (kind) {
    case RunKind::transmittance:
        return "transmittance";
    case RunKind::thermalRadiance:
        return "thermal radiance";
    case RunKind::solarRadiance:
        return "thermal and solar radiance";
    case RunKind::sunlight:
        return "solar irradiance";
    }
    return "";
}

std::optional<RunColumn> runColumn(std::string_view header) {
    std::string word;
    for (const char c : header.substr(0, header.find('[')))
        if (std::isalnum(static_cast<unsigned char>(c)))
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const auto found = std::ranges::find(aliases, word, &Alias::header);
    return found == aliases.end() ? std::nullopt : std::optional(found->column);
}

void fillRun(SpectralRun& run, const RunTable& table, std::vector<Diagnostic>& diagnostics) {
    Filler(run, table, diagnostics).fill();
}

std::optional<double> chord_m(double fromAltitude_m, double toAltitude_m, double elevation_rad,
                              double earthRadius_m, bool beyondTangent) {
    const double from = earthRadius_m + fromAltitude_m;
    const double rise = (toAltitude_m - fromAltitude_m) * (from + earthRadius_m + toAltitude_m);
    const double along = from * std::sin(elevation_rad);
    const double square = along * along + rise;
    if (square < 0.0)
        return std::nullopt;
    const double root = std::sqrt(square);
    const double near = -along - root;
    if (near > 0.0 && !beyondTangent)
        return near;
    // A ray that goes down first must pass its lowest point above the ground.
    const bool hitsGround = along < 0.0 && from * std::cos(elevation_rad) < earthRadius_m;
    const double length = -along + root;
    return length > 0.0 && !hitsGround ? std::optional(length) : std::nullopt;
}

} // namespace irsg
