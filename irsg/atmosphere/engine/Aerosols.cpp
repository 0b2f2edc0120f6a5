#include <algorithm>
#include <array>
#include <cmath>

#include "irsg/atmosphere/engine/ParticleParts.h"
#include "irsg/atmosphere/engine/ResourceFile.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"

namespace irsg::particles {

namespace {

/// Extinction at 0.55 um over altitude.
struct Vertical {
    std::vector<double> altitudes_m;
    std::vector<double> extinction_per_m;
};

const std::vector<std::string> humidModels = {"rural", "urban", "maritime", "tropospheric"};

const ParticleTable& humidTable() {
    static const ParticleTable table =
        ParticleTable::read(atmosphereResource("particles-humid.csv"), ParticleTable::Kind::optics,
                            opticsColumns(humidModels, {"_rh0", "_rh70", "_rh80", "_rh99"}));
    return table;
}

const ParticleTable& dryTable() {
    static const ParticleTable table = ParticleTable::read(
        atmosphereResource("particles-dry.csv"), ParticleTable::Kind::optics,
        opticsColumns({"advective_fog", "radiative_fog", "stratospheric", "meteoric_dust",
                       "cumulus", "altostratus", "stratus", "stratocumulus", "nimbostratus",
                       "cirrus_standard", "cirrus_thin"},
                      {""}));
    return table;
}

/// The visibilities of the profiles of the boundary layer, km, and their columns.
struct BoundaryColumn {
    double visibility_km;
    const char* name;
};
constexpr std::array<BoundaryColumn, 5> boundaryColumns = {
    {{50, "bl_vis50"}, {23, "bl_vis23"}, {10, "bl_vis10"}, {5, "bl_vis5"}, {2, "bl_vis2"}}};

const ParticleTable& profileTable() {
    static const ParticleTable table = ParticleTable::read(
        atmosphereResource("particles-profiles.csv"), ParticleTable::Kind::profile,
        {"bl_vis50", "bl_vis23", "bl_vis10", "bl_vis5", "bl_vis2", "trop_fw_vis50", "trop_fw_vis23",
         "trop_ss_vis50", "trop_ss_vis23", "strat_fw_background", "strat_ss_background",
         "upper_normal"});
    return table;
}

/// A column from its first to its last value above 0 with the zeros beside them, so that a region
/// fades into the next between two levels.
Vertical region(const std::vector<double>& altitudes_m, const std::vector<double>& values) {
    Vertical result;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool beside =
            (i > 0 && values[i - 1] > 0.0) || (i + 1 < values.size() && values[i + 1] > 0.0);
        if (values[i] > 0.0 || beside) {
            result.altitudes_m.push_back(altitudes_m[i]);
            result.extinction_per_m.push_back(values[i]);
        }
    }
    return result;
}

/// Between levels that are both positive the extinction is an exponential of altitude (as in
/// LOWTRAN 7). Nodes are added so that straight lines follow it to 1 % of its mean, where the
/// optical depth of the interval is worth it.
Vertical withExponentials(const Vertical& coarse) {
    Vertical fine;
    for (std::size_t i = 0; i < coarse.altitudes_m.size(); ++i) {
        fine.altitudes_m.push_back(coarse.altitudes_m[i]);
        fine.extinction_per_m.push_back(coarse.extinction_per_m[i]);
        if (i + 1 == coarse.altitudes_m.size())
            break;

        // The mean of an exponential of ratio r in straight pieces is off by (ln r / n)^2 / 12.
        const double a = coarse.extinction_per_m[i];
        const double b = coarse.extinction_per_m[i + 1];
        const double thickness_m = coarse.altitudes_m[i + 1] - coarse.altitudes_m[i];
        if (a <= 0.0 || b <= 0.0 || std::max(a, b) * thickness_m < 1e-3)
            continue;
        const int pieces = static_cast<int>(std::ceil(std::abs(std::log(b / a)) / 0.35));
        for (int piece = 1; piece < pieces; ++piece) {
            const double part = static_cast<double>(piece) / pieces;
            fine.altitudes_m.push_back(coarse.altitudes_m[i] + part * thickness_m);
            fine.extinction_per_m.push_back(lerpByRatio(a, b, part));
        }
    }
    return fine;
}

/// Linear in 1 / visibility between two columns, the rule of LOWTRAN 7.
std::vector<double> blend(const std::vector<double>& far, double far_km,
                          const std::vector<double>& near, double near_km, double visibility_km) {
    const double part = (1.0 / visibility_km - 1.0 / far_km) / (1.0 / near_km - 1.0 / far_km);
    std::vector<double> result(far.size());
    for (std::size_t i = 0; i < far.size(); ++i)
        result[i] = lerp(far[i], near[i], part);
    return result;
}

/// 0 to 2 km: the table's shape for the visibility, its lowest value that of Koschmieder. Clearer
/// air than the table's keeps the shape of 50 km; the blend of 2 and 5 km goes on below 2 km.
Vertical boundaryLayer(double extinction550_per_m) {
    const ParticleTable& table = profileTable();
    const double visibility_km = std::min(koschmiederVisibility_m(extinction550_per_m) / 1e3,
                                          boundaryColumns[0].visibility_km);
    const Bracket at =
        bracket(boundaryColumns, visibility_km, Beyond::clamp, &BoundaryColumn::visibility_km);
    const BoundaryColumn& a = boundaryColumns[at.below];
    const BoundaryColumn& b = boundaryColumns[at.above];
    std::vector<double> values = blend(table.column(a.name), a.visibility_km, table.column(b.name),
                                       b.visibility_km, visibility_km);
    const double scale = extinction550_per_m / values.front();
    for (double& value : values)
        value *= scale;
    return withExponentials(region(table.first(), values));
}

/// 2 to 10 km: the profile of 23 km for that visibility and less, of 50 km for that and more.
Vertical troposphere(double extinction550_per_m, bool winter) {
    const ParticleTable& table = profileTable();
    const double visibility_km =
        std::clamp(koschmiederVisibility_m(extinction550_per_m) / 1e3, 23.0, 50.0);
    const std::string season = winter ? "trop_fw" : "trop_ss";
    return withExponentials(
        region(table.first(), blend(table.column(season + "_vis50"), 50.0,
                                    table.column(season + "_vis23"), 23.0, visibility_km)));
}

ParticleLayer layer(std::string name, Vertical vertical, Optics optics) {
    return {std::move(name), std::move(vertical.altitudes_m), std::move(vertical.extinction_per_m),
            std::move(optics.wavelengths_um), std::move(optics.values)};
}

/// The report's name of a model and the visibility it stands for when none is given, km; 0 where
/// wind decides.
struct Model {
    const char* name;
    const char* optics;
    double visibility_km;
};
constexpr std::array<Model, 8> models = {{{"rural aerosol", "rural", 23.0},
                                          {"urban aerosol", "urban", 5.0},
                                          {"maritime aerosol", "maritime", 23.0},
                                          {"Navy maritime aerosol", "", 0.0},
                                          {"tropospheric aerosol", "tropospheric", 50.0},
                                          {"advective fog", "advective_fog", 0.2},
                                          {"radiative fog", "radiative_fog", 0.5},
                                          {"desert aerosol", "", 0.0}}};

/// An aerosol whose optics follow the humidity: three kinds, those of the humidity at 0, 1 and 2
/// km, each fading linearly over altitude into the next.
std::vector<ParticleLayer> humidBoundary(const Model& model, const Vertical& vertical,
                                         const HumidityProfile& relativeHumidityAt) {
    std::vector<ParticleLayer> layers;
    for (const double anchor_m : {0.0, 1000.0, 2000.0}) {
        Vertical share;
        for (std::size_t i = 0; i < vertical.altitudes_m.size(); ++i) {
            const double altitude_m = vertical.altitudes_m[i];
            const double distance = std::abs(altitude_m - anchor_m) / 1000.0;
            const double weight =
                anchor_m == 2000.0 && altitude_m > anchor_m ? 1.0 : std::max(0.0, 1.0 - distance);
            if (distance <= 1.0) {
                share.altitudes_m.push_back(altitude_m);
                share.extinction_per_m.push_back(weight * vertical.extinction_per_m[i]);
            }
        }
        layers.push_back(layer(std::string(model.name) + " at " +
                                   std::to_string(static_cast<int>(anchor_m / 1000.0)) + " km",
                               std::move(share),
                               humidOptics(model.optics, relativeHumidityAt(anchor_m))));
    }
    return layers;
}

} // namespace

double koschmiederExtinction_per_m(double visibility_m) {
    return 3.912 / visibility_m - 1.159e-5;
}
double koschmiederVisibility_m(double extinction550_per_m) {
    return 3.912 / (extinction550_per_m + 1.159e-5);
}

double windAt10m(double wind_m_s, double height_m, double roughness_m) {
    return wind_m_s * std::log(10.0 / roughness_m) / std::log(height_m / roughness_m);
}

Optics dryOptics(const std::string& kind) {
    return normalised(opticsOf(dryTable(), kind));
}

Optics humidOptics(const std::string& model, double relativeHumidity) {
    constexpr std::array<double, 4> percents = {0.0, 70.0, 80.0, 99.0};
    constexpr std::array<const char*, 4> suffixes = {"_rh0", "_rh70", "_rh80", "_rh99"};
    const double percent = std::clamp(100.0 * relativeHumidity, 0.0, 99.0);
    const Bracket at = bracket(percents, percent);
    const double part =
        fractionByRatio(100.0 - percents[at.below], 100.0 - percents[at.above], 100.0 - percent);
    Optics result = opticsOf(humidTable(), model, suffixes[at.below]);
    const Optics moister = opticsOf(humidTable(), model, suffixes[at.above]);
    for (std::size_t k = 0; k < result.values.size(); ++k)
        result.values[k] = between(result.values[k], moister.values[k], part);
    return normalised(std::move(result));
}

std::vector<ParticleLayer> aerosols(const ParticleSettings& settings,
                                    const HumidityProfile& humidityAboveGround) {
    // Tables begin at sea level.
    constexpr double still_m = 6000.0;
    const auto aboveGround_m = [&](double altitude_m) {
        return altitude_m < still_m ? altitude_m * (1.0 - settings.ground_m / still_m)
                                    : altitude_m - settings.ground_m;
    };
    const HumidityProfile relativeHumidityAt = [&](double altitude_m) {
        return humidityAboveGround(aboveGround_m(altitude_m));
    };
    const AerosolModel kind = *settings.aerosol;
    const Model& model = models.at(static_cast<std::size_t>(kind));

    // What wind makes of the aerosol of sea and desert.
    WindAerosol wind;
    if (kind == AerosolModel::navyMaritime) {
        auto at10m = [&](double speed) {
            return windAt10m(speed, settings.windHeight_m, seaRoughness_m);
        };
        wind = navyMaritime(settings.airMass, at10m(settings.windSpeed_m_s),
                            at10m(settings.windSpeed24h_m_s), relativeHumidityAt(0.0));
    } else if (kind == AerosolModel::desert) {
        wind = desert(windAt10m(settings.windSpeed_m_s, settings.windHeight_m, desertRoughness_m));
    }

    // The strength at the ground: of the visibility asked for, of the model's own, of the wind.
    const double visibility_m =
        settings.visibility_m > 0.0 ? settings.visibility_m : 1e3 * model.visibility_km;
    const double extinction_per_m =
        visibility_m > 0.0 ? koschmiederExtinction_per_m(visibility_m) : wind.extinction550_per_m;

    // The boundary layer.
    const Vertical boundary = boundaryLayer(extinction_per_m);
    std::vector<ParticleLayer> layers;
    if (!wind.optics.values.empty())
        layers.push_back(layer(model.name, boundary, std::move(wind.optics)));
    else if (std::ranges::find(humidModels, model.optics) != humidModels.end())
        layers = humidBoundary(model, boundary, relativeHumidityAt);
    else
        layers.push_back(layer(model.name, boundary, dryOptics(model.optics)));

    // What lies above does not know the boundary layer's kind; its humidity is 70 %, as in LOWTRAN.
    const ParticleTable& table = profileTable();
    layers.push_back(layer("tropospheric aerosol above 2 km",
                           troposphere(extinction_per_m, settings.winter),
                           humidOptics("tropospheric", 0.7)));
    const std::vector<double>& stratosphere =
        table.column(settings.winter ? "strat_fw_background" : "strat_ss_background");
    layers.push_back(layer("stratospheric aerosol",
                           withExponentials(region(table.first(), stratosphere)),
                           dryOptics("stratospheric")));

    // The table's level of 30 km stands in both columns and belongs to the stratosphere.
    std::vector<double> upper = table.column("upper_normal");
    for (std::size_t i = 0; i < upper.size(); ++i)
        upper[i] = stratosphere[i] > 0.0 ? 0.0 : upper[i];
    layers.push_back(
        layer("meteoric dust", region(table.first(), upper), dryOptics("meteoric_dust")));
    for (ParticleLayer& one : layers)
        std::ranges::transform(one.altitudes_m, one.altitudes_m.begin(), aboveGround_m);
    return layers;
}

} // namespace irsg::particles
