#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

#include "benchmarks/atmosphere/Table.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "tests/atmosphere/ModtranRuns.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"

namespace irsg::accuracy {

namespace {

using modtran::BandLimits;
using modtran::Slit;

constexpr double slit_per_cm = 20.0;
constexpr SunPosition night{0.0, -0.5 * std::numbers::pi};
const std::vector<BandLimits> bands = {{"8-12", 1e4 / 12.0, 1250.0},
                                       {"4.5-5", 2000.0, 1e4 / 4.5},
                                       {"3-4.17", 2400.0, 1e4 / 3.0},
                                       {"1.5-2.5", 4000.0, 1e4 / 1.5}};

struct Sight {
    const char* name;
    const char* words;
    double sensor_m, target_m, range_m, elevation_deg;
};
constexpr Sight sights[] = {
    {"h0_r1", "horizontal, 0 km, 1 km", 0, 0, 1e3, 0},
    {"h0_r5", "horizontal, 0 km, 5 km", 0, 0, 5e3, 0},
    {"h0_r20", "horizontal, 0 km, 20 km", 0, 0, 20e3, 0},
    {"s0_5_el45", "0 to 5 km, elevation 45°", 0, 5e3, 0, 45},
    {"s3_10_el30", "3 to 10 km, elevation 30°", 3e3, 10e3, 0, 30},
    {"space_el90", "0 km to space, vertical", 0, 100e3, 0, 90},
};

/// Columns of a result by name.
struct Columns {
    std::map<std::string, std::vector<double>> byName;

    static Columns read(const std::filesystem::path& file) {
        Columns columns;
        std::vector<std::string> names;
        for (const std::string& line : lbl::readTextLines(file)) {
            if (line.empty() || line.front() == '#')
                continue;
            std::istringstream cells(line);
            std::size_t i = 0;
            for (std::string cell; std::getline(cells, cell, ','); ++i)
                if (names.size() <= i)
                    names.push_back(cell);
                else if (!columns.byName.contains(cell))
                    columns.byName[names[i]].push_back(parseNumber(cell).value_or(0.0));
        }
        return columns;
    }
    const std::vector<double>& operator[](const std::string& name) const {
        const auto found = byName.find(name);
        if (found == byName.end())
            throw LogicError("a LOWTRAN result has no column " + name);
        return found->second;
    }
};

struct Air {
    const char* name;
    ModelAtmosphere model;
};
constexpr Air airs[] = {{"us76", ModelAtmosphere::usStandard1976},
                        {"tropical", ModelAtmosphere::tropical},
                        {"mlw", ModelAtmosphere::midlatitudeWinter}};

RadiativeTransfer transferOf(const Air& air, const std::string& aerosol,
                             ScatteringMode mode = ScatteringMode::single) {
    Profile profile = Profile::model(air.model, 330.0);
    std::vector<ParticleLayer> particles;
    if (aerosol != "noaer") {
        ParticleSettings settings;
        settings.aerosol = aerosol == "marit23" ? AerosolModel::maritime : AerosolModel::rural;
        settings.visibility_m = aerosol == "rural5" ? 5e3 : 23e3;
        settings.winter = air.model == ModelAtmosphere::midlatitudeWinter;
        particles = particleLayers(settings, profile);
    }
    AtmosphericModel model{std::move(profile), std::move(particles)};
    model.groundTemperature_K = model.profile.at(0.0).temperature_K;
    model.scattering = mode;
    return RadiativeTransfer(std::move(model), GasTable::shipped());
}

/// Differences of one kind of path in one band.
struct Score {
    double sum = 0.0, squares = 0.0, largest = 0.0, share = 0.0, largestShare = 0.0;
    int count = 0;

    void add(double transmittanceError, double radianceError) {
        sum += transmittanceError;
        squares += transmittanceError * transmittanceError;
        if (std::abs(transmittanceError) > std::abs(largest))
            largest = transmittanceError;
        share += radianceError * radianceError;
        if (std::abs(radianceError) > std::abs(largestShare))
            largestShare = radianceError;
        ++count;
    }
    std::vector<std::string> cells() const {
        return {std::to_string(count),
                text("%+.4f", sum / count),
                text("%.4f", std::sqrt(squares / count)),
                text("%+.4f", largest),
                text("%.2f %%", 100.0 * std::sqrt(share / count)),
                text("%+.2f %%", 100.0 * largestShare)};
    }
};

const std::vector<std::string> scoreColumns = {"cases",      "mean Δτ", "RMS Δτ",
                                               "largest Δτ", "RMS ΔL",  "largest ΔL"};

/// Skies seen from the ground, without and with the sun.
void skyTable(const std::filesystem::path& folder) {
    const std::vector<BandLimits> skyBands = {bands[0], bands[1], bands[2], bands[3]};
    Table table(
        "Sky radiance from the ground against LOWTRAN 7, in-band, W m⁻² sr⁻¹ µm⁻¹, US 1976, "
        "rural 23 km: heat alone without multiple scattering; with sun at 45° (90° off in "
        "azimuth), albedo 0.2 and multiple scattering",
        {"elevation", "µm", "heat, ours", "LOWTRAN", "with sun, ours", "LOWTRAN"});
    const auto night_sky = Columns::read(folder / "sky_us76__rural23.csv.gz");
    const auto day_sky = Columns::read(folder / "sky_us76__rural23__sun45.csv.gz");
    const RadiativeTransfer once = transferOf(airs[0], "rural23");
    const RadiativeTransfer often = transferOf(airs[0], "rural23", ScatteringMode::twoStream);
    const auto& nu = night_sky["wavenumber_cm-1"];
    const auto& dayNu = day_sky["wavenumber_cm-1"];
    const Slit slit(once, nu, slit_per_cm), daySlit(often, dayNu, slit_per_cm);
    for (const double elevation_deg : {1.0, 5.0, 15.0, 45.0, 90.0}) {
        const std::string name = "el" + text("%g", elevation_deg);
        const LineOfSight sight{0.0, elevation_deg * std::numbers::pi / 180.0, 0.0};
        const auto heat = slit.at(once.backgroundRadiance(slit.nodes(), sight, night));
        const auto all = daySlit.at(often.backgroundRadiance(
            daySlit.nodes(), sight, {0.5 * std::numbers::pi, 0.25 * std::numbers::pi}));
        for (const BandLimits& band : skyBands)
            table.add({text("%g°", elevation_deg), band.name,
                       text("%.4g", bandMean(nu, heat, band)),
                       text("%.4g", bandMean(nu, night_sky["L_" + name], band)),
                       text("%.4g", bandMean(dayNu, all, band)),
                       text("%.4g", bandMean(dayNu, day_sky["Ltot_" + name], band))});
    }
    table.print();
}

} // namespace

void lowtranTables(const Output& output) {
    const auto folder = output.data() / "lowtran_results";
    std::map<std::pair<std::string, std::string>, Score> scores;
    for (const Air& air : airs)
        for (const std::string aerosol : {"noaer", "rural23", "rural5", "marit23"}) {
            const RadiativeTransfer transfer = transferOf(air, aerosol);
            const double air_K[] = {transfer.air().profile.at(0.0).temperature_K,
                                    transfer.air().profile.at(3000.0).temperature_K};
            for (const Sight& sight : sights) {
                const auto theirs =
                    Columns::read(folder / (std::string(air.name) + "__" + sight.name + "__" +
                                            aerosol + ".csv.gz"));
                const auto& nu = theirs["wavenumber_cm-1"];
                const Slit slit(transfer, nu, slit_per_cm);
                const double range_m =
                    sight.range_m > 0.0
                        ? sight.range_m
                        : *chord_m(sight.sensor_m, sight.target_m,
                                   sight.elevation_deg * std::numbers::pi / 180.0, 6371.23e3);
                const AtmosphericPath path{sight.sensor_m, sight.target_m, range_m};
                const auto transmittance = slit.at(transfer.transmittance(slit.nodes(), path));
                const auto radiance = slit.at(transfer.pathRadiance(slit.nodes(), path, night));
                std::vector<double> black;
                for (const double at_per_cm : nu)
                    black.push_back(
                        planckRadiance_W_m2_sr_um(1e4 / at_per_cm, air_K[sight.sensor_m > 0.0]));
                for (const BandLimits& band : bands)
                    scores[{sight.words, band.name}].add(
                        bandMean(nu, transmittance, band) - bandMean(nu, theirs["tau"], band),
                        (bandMean(nu, radiance, band) -
                         bandMean(nu, theirs["Lpath_W_m-2_sr-1_um-1"], band)) /
                            bandMean(nu, black, band));
            }
        }
    std::vector<std::string> columns = {"path", "µm"};
    columns.insert(columns.end(), scoreColumns.begin(), scoreColumns.end());
    Table table("Against LOWTRAN 7, in-band: ours − LOWTRAN over three atmospheres and four "
                "aerosols; ΔL is the path radiance over the black body of the air at the sensor",
                columns);
    for (const Sight& sight : sights)
        for (const BandLimits& band : bands) {
            std::vector<std::string> cells = {sight.words, band.name};
            std::ranges::copy(scores[{sight.words, band.name}].cells(), std::back_inserter(cells));
            table.add(cells);
        }
    table.print();
    skyTable(folder);
}

} // namespace irsg::accuracy
