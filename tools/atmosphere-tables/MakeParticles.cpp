#include "tools/atmosphere-tables/Command.h"
#include "tools/atmosphere-tables/DataTable.h"

#include <algorithm>
#include <string>
#include <vector>

namespace smat::tables {

namespace {

std::vector<double> times(std::vector<double> values, double factor) {
    for (double& value : values)
        value *= factor;
    return values;
}

constexpr double shortest_um = 0.2;
constexpr double longest_um = 200.0; ///< the rows at 300 um hold no data

void humidAerosols(const Folders& folders) {
    Writer writer;
    for (const std::string model : {"rural", "urban", "maritime", "tropospheric"}) {
        const Table table = readTable(folders.data / "lowtran" / ("aerosol_" + model + ".csv"));
        if (model == "rural")
            writer.add("wavelength [um]", table.column("wavelength_um"));
        for (const char* quantity : {"ext", "abs", "asym"})
            for (const char* humidity : {"0", "70", "80", "99"})
                writer.add(model + "_" + quantity + "_rh" + humidity,
                           table.column(std::string(quantity) + "_rh" + humidity));
    }
    writer.write(folders.out / "particles-humid.csv",
                 "# Optics of the aerosols that swell in humid air, at relative humidities of 0, "
                 "70, 80 and 99 %\n"
                 "# recipe: the numbers of the source, 0.2 to 200 um; ext and abs relative to the "
                 "extinction at 0.55 um, asym of the phase function\n"
                 "# units: um; the rest without a unit\n"
                 "# models: E. P. Shettle and R. W. Fenn 1979, AFGL-TR-79-0214\n"
                 "# expected error: 5 digits as printed; the models themselves stand for air whose "
                 "aerosol varies by tens of percent in the infrared\n",
                 shortest_um, longest_um);
}

void dryParticles(const Folders& folders) {
    Writer writer;
    auto take = [&](const char* file, const std::vector<std::pair<std::string, std::string>>& all) {
        const Table table = readTable(folders.data / "lowtran" / file);
        if (all.front().second == "fog1")
            writer.add("wavelength [um]", table.column("wavelength_um"));
        for (const auto& [ours, theirs] : all)
            for (const std::string quantity : {"ext", "abs", "asym"})
                writer.add(ours + "_" + quantity, table.column(quantity + "_" + theirs));
    };
    take("aerosol_fog.csv", {{"advective_fog", "fog1"}, {"radiative_fog", "fog2"}});
    take("aerosol_stratospheric_volcanic.csv",
         {{"stratospheric", "background_strat"}, {"meteoric_dust", "meteoric_dust"}});
    take("cloud_water_optics.csv", {{"cumulus", "cumulus"},
                                    {"altostratus", "altostratus"},
                                    {"stratus", "stratus"},
                                    {"stratocumulus", "stratocumulus"},
                                    {"nimbostratus", "nimbostratus"}});
    take("cirrus_optics.csv",
         {{"cirrus_standard", "cirrus_standard"}, {"cirrus_thin", "cirrus_thin"}});
    writer.write(folders.out / "particles-dry.csv",
                 "# Optics of fogs, high aerosols, water clouds and cirrus\n"
                 "# recipe: the numbers of the source, 0.2 to 200 um; ext and abs relative to the "
                 "extinction at 0.55 um, asym of the phase function\n"
                 "# units: um; the rest without a unit\n"
                 "# models: fogs and high aerosols E. P. Shettle and R. W. Fenn 1979, "
                 "AFGL-TR-79-0214; cirrus of 64 and 4 um mode radius\n"
                 "# expected error: 5 digits as printed\n",
                 shortest_um, longest_um);
}

void desert(const Folders& folders) {
    const Table table = readTable(folders.data / "lowtran" / "aerosol_desert.csv");
    Writer writer;
    writer.add("wavelength [um]", table.column("wavelength_um"));
    for (const std::string wind : {"0", "10", "20", "30"}) {
        writer.add("desert_ext_w" + wind, times(table.column("ext_km-1_w" + wind), 1e-3));
        writer.add("desert_abs_w" + wind, times(table.column("abs_km-1_w" + wind), 1e-3));
        writer.add("desert_asym_w" + wind, table.column("asym_w" + wind));
    }
    writer.write(folders.out / "particles-desert.csv",
                 "# Optics of the desert aerosol at winds of 0, 10, 20 and 30 m/s\n"
                 "# recipe: the numbers of the source in SI, 0.2 to 200 um\n"
                 "# units: um; ext and abs m-1; asym without a unit\n"
                 "# model: D. R. Longtin, E. P. Shettle, J. R. Hummel, J. D. Pryce 1988, "
                 "AFGL-TR-88-0112\n"
                 "# expected error: 5 digits as printed\n",
                 shortest_um, longest_um);
}

void navyMaritime(const Folders& folders) {
    const Table table = readTable(folders.data / "lowtran" / "aerosol_navy_maritime.csv");
    Writer writer;
    for (std::size_t i = 0; i < table.names.size(); ++i)
        writer.add(i == 0 ? "wavelength [um]" : table.names[i], table.columns[i]);
    writer.write(
        folders.out / "particles-navy.csv",
        "# Navy maritime aerosol: log10 of the extinction and absorption sums of its three size "
        "modes at relative humidities of 50, 85, 95 and 98 %\n"
        "# recipe: the numbers of the source; extinction [km-1] = pi/1000/F sum A_i 10^q_i, see "
        "docs/atmosphere-particles.md\n"
        "# units: um; the rest log10 without a unit\n"
        "# model: S. G. Gathman 1983, Optical properties of the marine aerosol as predicted by "
        "the Navy aerosol model, Opt. Eng. 22, 57\n"
        "# expected error: 4 digits after the point, 1e-4 of the value\n",
        shortest_um, 40.0);
}

void verticalProfiles(const Folders& folders) {
    const Table table = readTable(folders.data / "lowtran" / "aerosol_vertical_profiles.csv");
    Writer writer;
    writer.add("altitude [m]", times(table.column("altitude_km"), 1e3));
    for (const std::string name :
         {"bl_vis50", "bl_vis23", "bl_vis10", "bl_vis5", "bl_vis2", "trop_fw_vis50",
          "trop_fw_vis23", "trop_ss_vis50", "trop_ss_vis23", "strat_fw_background",
          "strat_ss_background", "upper_normal"})
        writer.add(name, times(table.column(name), 1e-3));
    writer.write(folders.out / "particles-profiles.csv",
                 "# Extinction by aerosols at 0.55 um over altitude: boundary layer by visibility "
                 "in km, troposphere and stratosphere by season (fw autumn and winter, ss spring "
                 "and summer), above\n"
                 "# recipe: the numbers of the source in SI\n"
                 "# units: m; the rest m-1\n"
                 "# models: E. P. Shettle and R. W. Fenn 1979, AFGL-TR-79-0214\n"
                 "# expected error: 3 digits as printed\n",
                 0.0, 100e3);
}

void clouds(const Folders& folders) {
    const Table profiles = readTable(folders.data / "lowtran" / "cloud_lwc_rain_profiles.csv");
    Writer writer;
    writer.add("height [m]", times(profiles.column("height_km"), 1e3));

    // Water content per extinction of 1 km-1, AFGL-TR-88-0177, by the kind of cloud.
    const std::vector<std::pair<std::string, double>> kinds = {{"cumulus", 0.007683},
                                                               {"altostratus", 0.004509},
                                                               {"stratus", 0.005272},
                                                               {"stratocumulus", 0.004177},
                                                               {"nimbostratus", 0.007518}};
    for (const auto& [kind, contentPerExtinction] : kinds)
        writer.add(kind, times(profiles.column("lwc_" + kind), 1e-3 / contentPerExtinction));
    for (const std::string rain : {"drizzle2", "light5", "moderate12.5", "heavy25", "extreme75"})
        writer.add("rain_" + rain, profiles.column("rain_" + rain));
    writer.write(folders.out / "particles-clouds.csv",
                 "# Extinction of water clouds at 0.55 um and rain rate over the height above "
                 "ground\n"
                 "# recipe: liquid water content divided by the content that makes 1 km-1 "
                 "(cumulus 0.007683, altostratus 0.004509, stratus 0.005272, stratocumulus "
                 "0.004177, nimbostratus 0.007518 g m-3); rain rates as they are\n"
                 "# units: m; clouds m-1; rain mm/h\n"
                 "# expected error: 2 digits of the contents\n",
                 0.0, 6000.0);
}

} // namespace

void makeParticles(const Folders& folders) {
    humidAerosols(folders);
    dryParticles(folders);
    desert(folders);
    navyMaritime(folders);
    verticalProfiles(folders);
    clouds(folders);
}

} // namespace smat::tables
