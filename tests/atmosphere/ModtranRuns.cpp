#include "tests/atmosphere/ModtranRuns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "irsg/atmosphere/import/Tape7.h"
#include "irsg/atmosphere/import/TextLines.h"
#include "irsg/radiometry/Planck.h"

namespace irsg::modtran {

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr const char* absorberFile = "pyradi/horizon5kmtropical.fl7";

/// The integral of a triangle of area 1 and full width `fwhm` at half of its height, from its
/// middle.
double triangleIntegral(double x, double fwhm) {
    const double t = std::min(std::abs(x) / fwhm, 1.0);
    return std::copysign(t - 0.5 * t * t, x);
}

double card(const SpectralRun& run, const char* name, double otherwise = 0.0) {
    const auto found = run.cards.find(name);
    return found == run.cards.end() || found->second == -99.0 ? otherwise : found->second;
}

std::optional<AerosolModel> aerosolOf(int ihaze) {
    switch (ihaze) {
    case 0:
        return {};
    case 3:
        return AerosolModel::navyMaritime;
    case 4:
        return AerosolModel::maritime;
    case 5:
        return AerosolModel::urban;
    case 6:
        return AerosolModel::tropospheric;
    case 8:
        return AerosolModel::advectiveFog;
    case 9:
        return AerosolModel::radiativeFog;
    case 10:
        return AerosolModel::desert;
    default:
        return AerosolModel::rural;
    }
}

/// Where the sun stands from the cards 3A: IPARM 0 gives latitude and longitude (west) of the
/// observer and of the point under the sun. The path goes north, PSIPO 0.
SunPosition sunOf(const SpectralRun& run) {
    if (run.geometry.sunElevation_rad) {
        return {0.0, *run.geometry.sunElevation_rad};
    }
    const double latitude = card(run, "PARM1") * degree, longitude = card(run, "PARM2") * degree;
    const double under = card(run, "PARM3") * degree, west = card(run, "PARM4") * degree;
    const double east = longitude - west;
    const double sine = std::sin(latitude) * std::sin(under) +
                        std::cos(latitude) * std::cos(under) * std::cos(east);
    const double azimuth = std::atan2(std::sin(east) * std::cos(under),
                                      std::cos(latitude) * std::sin(under) -
                                          std::sin(latitude) * std::cos(under) * std::cos(east));
    return {azimuth < 0.0 ? azimuth + 2.0 * std::numbers::pi : azimuth,
            std::asin(std::clamp(sine, -1.0, 1.0))};
}

/// The air as sunlight meets it: with IPH 0 all particles scatter by Henyey and Greenstein's
/// function with the asymmetry G of card 3A2 (0: alike into all directions) in place of their own.
AtmosphericModel atmosphereOfSunlight(AtmosphericModel air, const SpectralRun& run) {
    if (card(run, "IPH", 2.0) == 0.0) {
        for (ParticleLayer& layer : air.particles) {
            for (ParticleOptics& optics : layer.optics) {
                optics.asymmetry = card(run, "G");
            }
        }
    }
    return air;
}

/// The true elevation of a sun that is seen at an apparent one: the ray is as long.
double trueElevation(const RayTracer& tracer, double altitude_m, double apparent_rad) {
    const double length_m = tracer.along({altitude_m, apparent_rad, 0.0}).length_m;
    double lower = apparent_rad - 0.05, upper = apparent_rad + 0.05;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (lower + upper);
        const RayPath ray = tracer.towardsSun(altitude_m, middle);
        (ray.end != RayPath::End::space || ray.length_m > length_m ? lower : upper) = middle;
    }
    return upper;
}

AtmosphericPath pathOf(const SpectralRun& run, const RadiativeTransfer& transfer) {
    const RunGeometry& geometry = run.geometry;
    switch (geometry.path) {
    case RunPath::horizontal:
        return {geometry.sensorAltitude_m, geometry.sensorAltitude_m, geometry.range_m};
    case RunPath::slant:
        return {geometry.sensorAltitude_m, geometry.targetAltitude_m, geometry.range_m};
    case RunPath::toSpace:
        break;
    }
    return {
        geometry.sensorAltitude_m, transfer.air().profile.top_m(),
        transfer.tracer().along({geometry.sensorAltitude_m, geometry.elevation_rad, 0.0}).length_m};
}

/// What the air sends along the path of a run, per node: emitted and scattered.
std::vector<double> radianceOf(const SpectralRun& run, const RadiativeTransfer& transfer,
                               const NodeSet& nodes, const SunPosition& sun) {
    const RunGeometry& geometry = run.geometry;
    if (geometry.path == RunPath::toSpace) {
        return transfer.backgroundRadiance(
            nodes, {geometry.sensorAltitude_m, geometry.elevation_rad, 0.0}, sun);
    }
    return transfer.pathRadiance(nodes, pathOf(run, transfer), sun);
}

/// Bins much finer than the slit.
int resolutionFor(double fwhm_per_cm) {
    return fwhm_per_cm <= 10.0 ? 1 : 5;
}

} // namespace

const std::vector<PublishedFile>& publishedFiles() {
    static const std::vector<PublishedFile> files = [] {
        const BandLimits narrow{"4.76-4.88", 2050.0, 2100.0};
        const std::vector<BandLimits> midwave = {{"3-5", 2000.0, 1e4 / 3.0},
                                                 {"3.5-4.1", 1e4 / 4.1, 1e4 / 3.5},
                                                 {"4.1-4.5", 1e4 / 4.5, 1e4 / 4.1},
                                                 {"4.5-5", 2000.0, 1e4 / 4.5}};
        const std::vector<BandLimits> cut = {
            {"3.2-5", 2000.0, 3125.0}, midwave[1], midwave[2], midwave[3]};
        return std::vector<PublishedFile>{
            {absorberFile,
             365.0,
             {{"8-12", 1e4 / 12.0, 1250.0},
              {"12-15", 1e4 / 15.0, 1e4 / 12.0},
              {"5-8", 1250.0, 2000.0},
              midwave[0],
              midwave[1],
              midwave[2],
              midwave[3],
              {"1.5-2.5", 4000.0, 1e4 / 1.5},
              {"0.7-1.5", 1e4 / 1.5, 1e4 / 0.7},
              {"0.4-0.7", 1e4 / 0.7, 25000.0},
              {"0.25-0.4", 25000.0, 40000.0}}},
            {"pyradi/tape7-01", 365.0, {narrow}},
            {"pyradi/tape7-01b", 365.0, {{"13.3-15.3", 655.0, 750.0}}},
            {"pyradi/tape7-02", 365.0, {narrow}},
            {"pyradi/tape7-02b", 365.0, {narrow}},
            {"pyradi/tape7-02c", 365.0, {{"14-15.3", 655.0, 715.0}}},
            {"pyradi/tape7-03", 365.0, {narrow}},
            {"pyradi/tape7-03b", 365.0, {narrow}},
            {"pyradi/tape7-04", 365.0, {{"4.65-4.88", 2050.0, 2150.0}}},
            {"pyradi/tape7-05", 365.0, {narrow}},
            {"pyradi/tape7-05b", 365.0, {narrow}},
            {"well-fill/MLS23km/tape7", 380.0, midwave},
            {"well-fill/tropical5km/tape7", 380.0, midwave},
            {"well-fill/SW31km/tape7", 380.0, cut}};
    }();
    return files;
}

Slit::Slit(const RadiativeTransfer& transfer, std::vector<double> wavenumbers_per_cm,
           double fwhm_per_cm)
    : wavenumbers_per_cm_(std::move(wavenumbers_per_cm)), fwhm_per_cm_(fwhm_per_cm) {
    const BinSet& set = transfer.gases().bins(transfer.air().resolution_per_cm);
    const auto [first, last] = set.range(wavenumbers_per_cm_.front() - fwhm_per_cm_,
                                         wavenumbers_per_cm_.back() + fwhm_per_cm_);
    for (std::size_t bin = first; bin < last; ++bin) {
        const SpectralBin& own = set.bins[bin];
        bins_.push_back({own.lower_per_cm, own.upper_per_cm, {}});
        for (std::uint32_t i = own.first; i < own.first + own.count; ++i) {
            bins_.back().weights.push_back(static_cast<double>(set.weights[i]));
            nodes_.nodes.push_back(set.nodes[i]);
            nodes_.wavenumbers_per_cm.push_back(transfer.gases().wavenumber_per_cm(set.nodes[i]));
        }
    }
}

std::vector<double> Slit::at(const std::vector<double>& nodeValues) const {
    std::vector<double> means;
    std::size_t node = 0;
    for (const Bin& bin : bins_) {
        double mean = 0.0;
        for (const double weight : bin.weights) {
            mean += weight * nodeValues.at(node++);
        }
        means.push_back(mean);
    }
    std::vector<double> values;
    std::size_t first = 0;
    for (const double at_per_cm : wavenumbers_per_cm_) {
        while (first + 1 < bins_.size() && bins_[first].upper_per_cm <= at_per_cm - fwhm_per_cm_) {
            ++first;
        }
        double sum = 0.0, area = 0.0;
        for (std::size_t b = first;
             b < bins_.size() && bins_[b].lower_per_cm < at_per_cm + fwhm_per_cm_; ++b) {
            const double part = triangleIntegral(bins_[b].upper_per_cm - at_per_cm, fwhm_per_cm_) -
                                triangleIntegral(bins_[b].lower_per_cm - at_per_cm, fwhm_per_cm_);
            sum += part * means[b];
            area += part;
        }
        values.push_back(sum / area);
    }
    return values;
}

double bandMean(const std::vector<double>& wavenumbers_per_cm, const std::vector<double>& values,
                const BandLimits& band) {
    double sum = 0.0, width = 0.0;
    for (std::size_t i = 1; i < wavenumbers_per_cm.size(); ++i) {
        const double below = wavenumbers_per_cm[i - 1], above = wavenumbers_per_cm[i];
        const double from = std::max(below, band.lower_per_cm),
                     to = std::min(above, band.upper_per_cm);
        if (from >= to) {
            continue;
        }
        auto at = [&](double nu) {
            const double f = (nu - below) / (above - below);
            return (1.0 - f) * values[i - 1] + f * values[i];
        };
        const double part_um = 1e4 / from - 1e4 / to;
        sum += 0.5 * (at(from) + at(to)) * part_um;
        width += part_um;
    }
    return sum / width;
}

AtmosphericModel atmosphereOf(const SpectralRun& run, double co2_ppmv) {
    const auto model = static_cast<ModelAtmosphere>(static_cast<int>(card(run, "MODEL")));
    AtmosphericModel air{Profile::model(model, co2_ppmv), {}};
    ParticleSettings settings;
    settings.aerosol = aerosolOf(static_cast<int>(card(run, "IHAZE")));
    settings.visibility_m = 1000.0 * card(run, "VIS");
    settings.winter = card(run, "ISEASN") == 2.0;
    settings.airMass = std::max(1, static_cast<int>(card(run, "ICSTL", 3.0)));
    settings.windSpeed_m_s = std::max(0.1, card(run, "WSS", 5.0));
    settings.windSpeed24h_m_s = std::max(0.1, card(run, "WHH", 5.0));
    air.particles = particleLayers(settings, air.profile);
    const double ground_K = card(run, "TBOUND");
    air.groundTemperature_K = ground_K > 0.0 ? ground_K : air.profile.at(0.0).temperature_K;
    air.groundAlbedo = Spectrum::constant(card(run, "SALB"));
    air.scattering = card(run, "IMULT") == 0.0 ? ScatteringMode::single : ScatteringMode::twoStream;
    air.resolution_per_cm = resolutionFor(card(run, "FWHM"));
    return air;
}

ModtranComparison compare(const std::filesystem::path& folder, const PublishedFile& file) {
    const SpectralRun run = readTape7(folder / file.name).front();
    const RadiativeTransfer transfer(atmosphereOf(run, file.co2_ppmv), GasTable::shipped());
    const Slit slit(transfer, run.wavenumbers_per_cm, card(run, "FWHM"));
    const double sensor_m = run.geometry.sensorAltitude_m;
    constexpr SunPosition night{0.0, -0.5 * std::numbers::pi};

    ModtranComparison result{.wavenumbers_per_cm = run.wavenumbers_per_cm};
    result.theirTransmittance = run.transmittance;
    result.theirRadiance = run.pathRadiance_W_m2_sr_um;
    result.theirSunlight = run.solarIrradiance_W_m2_um;
    const AtmosphericPath path = pathOf(run, transfer);
    result.transmittance = slit.at(transfer.transmittance(slit.nodes(), path));
    if (run.kind == RunKind::sunlight) {
        const double elevation =
            trueElevation(transfer.tracer(), sensor_m, run.geometry.elevation_rad);
        result.sunlight =
            slit.at(transfer.solarIrradiance(slit.nodes(), sensor_m, {0.0, elevation}));
        result.reference = slit.at(transfer.solarIrradiance(
            slit.nodes(), transfer.air().profile.top_m(), {0.0, 0.5 * std::numbers::pi}));
    } else if (run.kind != RunKind::transmittance) {
        result.radiance = slit.at(radianceOf(run, transfer, slit.nodes(), night));
        if (run.kind == RunKind::solarRadiance) {
            const RadiativeTransfer sunlit(atmosphereOfSunlight(transfer.air(), run),
                                           GasTable::shipped());
            const SunPosition sun = sunOf(run);
            const auto day = slit.at(radianceOf(run, sunlit, slit.nodes(), sun));
            const auto dark = slit.at(radianceOf(run, sunlit, slit.nodes(), night));
            for (std::size_t i = 0; i < day.size(); ++i) {
                result.scatteredSun.push_back(day[i] - dark[i]);
                result.radiance[i] += result.scatteredSun[i];
            }
        }
        const double air_K = transfer.air().profile.at(sensor_m).temperature_K;
        for (const double nu : run.wavenumbers_per_cm) {
            result.reference.push_back(planckRadiance_W_m2_sr_um(1e4 / nu, air_K));
        }
    }
    return result;
}

double InBand::radianceShare() const {
    return radiance ? std::abs(*radiance - *theirRadiance) /
                          std::max(0.03 * *theirRadiance, 0.02 * *reference)
                    : 0.0;
}

bool InBand::holds() const {
    return std::abs(transmittanceError()) <= 0.015 && radianceShare() <= 1.0;
}

std::vector<InBand> inBand(const ModtranComparison& comparison, const PublishedFile& file) {
    std::vector<InBand> rows;
    for (const BandLimits& band : file.bands) {
        auto mean = [&](const std::vector<double>& values) {
            return bandMean(comparison.wavenumbers_per_cm, values, band);
        };
        InBand row{.band = band};
        row.transmittance = mean(comparison.transmittance);
        row.theirTransmittance = mean(comparison.theirTransmittance);
        const bool isSunlight = !comparison.sunlight.empty();
        if (isSunlight || !comparison.radiance.empty()) {
            row.radiance = mean(isSunlight ? comparison.sunlight : comparison.radiance);
            row.theirRadiance =
                mean(isSunlight ? comparison.theirSunlight : comparison.theirRadiance);
            row.reference = mean(comparison.reference);
        }
        rows.push_back(row);
    }
    return rows;
}

AbsorberComparisons compareAbsorbers(const std::filesystem::path& folder) {
    struct Column {
        const char* name;
        std::size_t index; ///< in the file
        std::vector<std::string> ours;
    };
    const std::array<Column, 12> columns = {
        {{"H2O", 2, {"H2O"}},
         {"O3", 4, {"O3", "O3 ultraviolet and visible"}},
         {"N2 CONT", 6, {"N2 collision-induced"}},
         {"H2O CONT", 7, {"H2O self continuum", "H2O foreign continuum"}},
         {"MOLEC SCAT", 8, {"Rayleigh"}},
         {"AER+CLD", 9, {"particles"}},
         {"HNO3", 10, {"HNO3"}},
         {"CO2", 13, {"CO2"}},
         {"CO", 14, {"CO"}},
         {"CH4", 15, {"CH4"}},
         {"N2O", 16, {"N2O"}},
         {"O2", 17, {"O2", "O2 collision-induced"}}}};

    const SpectralRun run = readTape7(folder / absorberFile).front();
    AbsorberComparisons result{.wavenumbers_per_cm = run.wavenumbers_per_cm};
    for (const Column& column : columns) {
        result.absorbers.push_back({column.name, {}, {}});
    }
    constexpr std::size_t headerLines = 12;
    const TextLines text = TextLines::read(folder / absorberFile);
    for (std::size_t row = 0; row < run.wavenumbers_per_cm.size(); ++row) {
        std::istringstream words(text.lines.at(headerLines + row));
        std::vector<double> values;
        for (double value = 0.0; words >> value;) {
            values.push_back(value);
        }
        for (std::size_t c = 0; c < columns.size(); ++c) {
            result.absorbers[c].theirs.push_back(values.at(columns[c].index));
        }
    }

    AtmosphericModel air = atmosphereOf(run, publishedFiles().front().co2_ppmv);
    {
        const RadiativeTransfer transfer(air, GasTable::shipped());
        const Slit slit(transfer, run.wavenumbers_per_cm, card(run, "FWHM"));
        const AtmosphericPath path = pathOf(run, transfer);
        for (std::size_t c = 0; c < columns.size(); ++c) {
            std::vector<double> product(slit.nodes().nodes.size(), 1.0);
            for (const std::string& component : columns[c].ours) {
                std::ranges::transform(
                    product, transfer.componentTransmittance(slit.nodes(), path, component),
                    product.begin(), std::multiplies());
            }
            result.absorbers[c].ours = slit.at(product);
        }
    }

    // As much water in ten times as much air: its molecules hardly meet each other.
    constexpr double thinner = 10.0;
    std::vector<AtmosphericState> levels = air.profile.levels();
    for (AtmosphericState& level : levels) {
        level.moleFraction[static_cast<std::size_t>(Gas::H2O)] /= thinner;
    }
    air.profile = Profile(levels);
    const RadiativeTransfer transfer(air, GasTable::shipped());
    const Slit slit(transfer, run.wavenumbers_per_cm, card(run, "FWHM"));
    AtmosphericPath path = pathOf(run, transfer);
    path.range_m *= thinner;
    result.absorbers.push_back({"H2O by air alone",
                                slit.at(transfer.componentTransmittance(slit.nodes(), path, "H2O")),
                                result.absorbers.front().theirs});
    return result;
}

} // namespace irsg::modtran
