#include "irsg/atmosphere/TabulatedAtmosphere.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "irsg/atmosphere/TabulatedPoints.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr const char* airCards[] = {"MODEL", "IHAZE", "ISEASN", "IVULCN", "ICSTL",  "ICLD",
                                    "VIS",   "WSS",   "WHH",    "RAINRT", "GNDALT", "CO2MX"};
constexpr const char* sunCards[] = {"IPARM", "PARM1", "PARM2", "PARM3", "PARM4", "TIME", "IDAY"};
constexpr double sunTolerance_rad = 0.00873; ///< 0.5 deg
constexpr double spaceAltitude_m = 90e3;     ///< paths that end above this end in space
constexpr double sameTransmittance = 1e-3;

AtmosphericPath pathOf(const RunGeometry& geometry) {
    return {geometry.sensorAltitude_m, geometry.targetAltitude_m, geometry.range_m};
}

/// Runs to space may leave the end of their path open.
bool hasPath(const SpectralRun& run) {
    const RunGeometry& geometry = run.geometry;
    const bool hasEnd =
        geometry.path != RunPath::toSpace || geometry.targetAltitude_m > spaceAltitude_m ||
        (geometry.elevation_rad < 0.0 && geometry.targetAltitude_m <= geometry.sensorAltitude_m);
    return run.kind != RunKind::sunlight && geometry.range_m > 0.0 &&
           geometry.targetAltitude_m >= 0.0 && hasEnd;
}

bool isRadiance(const SpectralRun& run) {
    return run.kind == RunKind::thermalRadiance || run.kind == RunKind::solarRadiance;
}

bool isSight(const SpectralRun& run) {
    return isRadiance(run) && run.geometry.path == RunPath::toSpace;
}

bool sameGeometry(const SpectralRun& a, const SpectralRun& b) {
    const auto near = [](double x, double y, double tolerance) {
        return std::abs(x - y) < tolerance;
    };
    const RunGeometry& f = a.geometry;
    const RunGeometry& g = b.geometry;
    const bool sensors = near(f.sensorAltitude_m, g.sensorAltitude_m, 0.1);
    if ((f.path == RunPath::toSpace) != (g.path == RunPath::toSpace))
        return false;
    if (f.path == RunPath::toSpace)
        return sensors && near(f.elevation_rad, g.elevation_rad, 1e-6);
    return sensors && near(f.targetAltitude_m, g.targetAltitude_m, 0.1) &&
           near(f.range_m, g.range_m, 0.01 + 1e-7 * f.range_m);
}

/// Runs that answer the same query about the same geometry.
bool sameRole(const SpectralRun& a, const SpectralRun& b) {
    return (isRadiance(a) && isRadiance(b)) || a.kind == b.kind;
}

std::string gridText(const SpectralRun& run) {
    return std::to_string(run.wavenumbers_per_cm.size()) + " wavenumbers, " +
           numberText(run.wavenumbers_per_cm.front()) + " to " +
           numberText(run.wavenumbers_per_cm.back()) + " cm-1";
}

std::vector<double> backwards(const std::vector<double>& values) {
    return {values.rbegin(), values.rend()};
}

std::vector<double> depthOf(const std::vector<double>& transmittance) {
    std::vector<double> depth = backwards(transmittance);
    std::ranges::transform(depth, depth.begin(), [](double tau) { return -std::log(tau); });
    return depth;
}

void append(std::vector<InterpolationError>& all, std::vector<InterpolationError> some,
            const char* where) {
    for (InterpolationError& error : some) {
        error.axis += where;
        all.push_back(std::move(error));
    }
}

} // namespace

TabulatedAtmosphere::TabulatedAtmosphere(std::vector<SpectralRun> runs, std::string name)
    : runs_(std::move(runs)), name_(std::move(name)) {
    checkFamily();
    for (const double wavenumber : backwards(runs_.front().wavenumbers_per_cm))
        wavelengths_um_.push_back(wavelengthFromWavenumber_um(wavenumber));
    fillPaths();
    fillSights();
    ofPoints_ = std::make_shared<OfPoints>();
}

void TabulatedAtmosphere::checkFamily() const {
    if (runs_.empty())
        throw InputError({name_, "", "no runs", "at least one run"});
    std::vector<Diagnostic> diagnostics;
    const auto report = [&](const SpectralRun& run, std::string value, std::string expected) {
        diagnostics.push_back({name_, run.source, std::move(value), std::move(expected)});
    };
    const SpectralRun* firstWithSun = nullptr;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        const SpectralRun& run = runs_[i];
        const SpectralRun& first = runs_.front();
        if (run.wavenumbers_per_cm != first.wavenumbers_per_cm) {
            report(run, gridText(run), gridText(first) + " as " + first.source + " has");
            continue;
        }
        const auto compareCards = [&](std::span<const char* const> names, const SpectralRun& other,
                                      const char* what) {
            for (const char* card : names) {
                const auto mine = run.cards.find(card);
                const auto its = other.cards.find(card);
                if (mine != run.cards.end() && its != other.cards.end() &&
                    mine->second != its->second) {
                    report(run, std::string(card) + " " + numberText(mine->second),
                           numberText(its->second) + " as in " + other.source + ": " + what);
                }
            }
        };
        compareCards(airCards, first, "a family is of one air");
        if (run.kind == RunKind::solarRadiance) {
            firstWithSun = firstWithSun ? firstWithSun : &run;
            compareCards(sunCards, *firstWithSun, "a family with sun is of one sun");
        }
        for (std::size_t k = 0; k < i; ++k) {
            const SpectralRun& other = runs_[k];
            if (other.wavenumbers_per_cm != run.wavenumbers_per_cm || !sameGeometry(run, other) ||
                (run.kind == RunKind::sunlight) != (other.kind == RunKind::sunlight)) {
                continue;
            }
            if (sameRole(run, other)) {
                report(run, "the geometry of " + other.source + " again",
                       "each geometry once for each kind of run");
                continue;
            }
            double largest = 0.0;
            for (std::size_t n = 0; n < run.transmittance.size(); ++n) {
                largest =
                    std::max(largest, std::abs(run.transmittance[n] - other.transmittance[n]));
            }
            if (largest > sameTransmittance) {
                report(run, "a transmittance that differs by " + numberText(largest),
                       "that of " + other.source + ", which is of the same path");
            }
        }
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
}

void TabulatedAtmosphere::fillPaths() {
    // Radiance runs first: their transmittances have more digits.
    for (const bool radiance : {true, false}) {
        for (const SpectralRun& run : runs_) {
            if (!hasPath(run) || isRadiance(run) != radiance)
                continue;
            const AtmosphericPath path = pathOf(run.geometry);
            PathTable& table = transmittances_.of(path);
            if (!table.holds(path))
                table.add(path, depthOf(run.transmittance), {});
            if (radiance && !radiances_.of(path).holds(path)) {
                radiances_.of(path).add(path, depthOf(run.transmittance),
                                        backwards(run.pathRadiance_W_m2_sr_um));
            }
            if (!run.scatteringDepth.empty() && !scatterings_.of(path).holds(path))
                scatterings_.of(path).add(path, backwards(run.scatteringDepth), {});
        }
    }
}

void TabulatedAtmosphere::fillSights() {
    for (const SpectralRun& run : runs_) {
        if (isSight(run)) {
            backgrounds_.add(run.geometry.sensorAltitude_m, run.geometry.elevation_rad,
                             backwards(run.totalRadiance_W_m2_sr_um));
        }
    }
    for (const RunKind kind : {RunKind::sunlight, RunKind::solarRadiance}) {
        for (const SpectralRun& run : runs_) {
            const std::optional<double>& elevation = run.geometry.sunElevation_rad;
            if (run.kind == kind && elevation && !run.solarIrradiance_W_m2_um.empty() &&
                !suns_.holds(run.geometry.sensorAltitude_m, *elevation)) {
                suns_.add(run.geometry.sensorAltitude_m, *elevation,
                          backwards(run.solarIrradiance_W_m2_um));
            }
        }
    }
}

PathTable& TabulatedAtmosphere::PropertyTables::of(const AtmosphericPath& path) {
    return path.targetAltitude_m > spaceAltitude_m ? toSpace : finite;
}

const PathTable& TabulatedAtmosphere::PropertyTables::answering(const AtmosphericPath& path) const {
    const bool far =
        !toSpace.isEmpty() && (finite.isEmpty() || path.targetAltitude_m > spaceAltitude_m);
    return far ? toSpace : finite;
}

std::string TabulatedAtmosphere::PropertyTables::span() const {
    return finite.isEmpty() || toSpace.isEmpty() ? (finite.isEmpty() ? toSpace : finite).span()
                                                 : finite.span() + "; to space: " + toSpace.span();
}

SpectralRange TabulatedAtmosphere::base() const {
    return {wavelengths_um_.front(), wavelengths_um_.back()};
}

bool TabulatedAtmosphere::supports(AtmosphereProperty property) const {
    switch (property) {
    case AtmosphereProperty::transmittance:
        return !transmittances_.isEmpty();
    case AtmosphereProperty::pathRadiance:
        return !radiances_.isEmpty();
    case AtmosphereProperty::backgroundRadiance:
        return !backgrounds_.isEmpty();
    case AtmosphereProperty::solarIrradiance:
        return !suns_.isEmpty();
    case AtmosphereProperty::scatteringOpticalDepth:
        return !scatterings_.isEmpty();
    default:
        return false;
    }
}

std::pair<std::size_t, std::size_t>
TabulatedAtmosphere::nodesAround(const SpectralRange& range) const {
    const auto& axis = wavelengths_um_;
    const auto above = std::ranges::upper_bound(axis, range.min_um);
    const auto below = std::ranges::lower_bound(axis, range.max_um);
    const auto first = static_cast<std::size_t>(above - axis.begin());
    const auto last = static_cast<std::size_t>(below - axis.begin());
    return {first == 0 ? 0 : std::min(first - 1, axis.size() - 2), std::min(last + 1, axis.size())};
}

std::vector<double> TabulatedAtmosphere::depths(const AtmosphericPath& path, std::size_t first,
                                                std::size_t last) const {
    try {
        return transmittances_.answering(path).at(path, first, last, name_).depth;
    } catch (const InputError&) {
        const AtmosphericPath back{path.targetAltitude_m, path.sensorAltitude_m, path.range_m};
        std::vector<double> depth;
        try {
            depth = transmittances_.answering(back).at(back, first, last, name_).depth;
        } catch (const InputError&) {
            depth.clear();
        }
        if (depth.empty())
            throw;
        return depth;
    }
}

bool TabulatedAtmosphere::holdsSight(double altitude_m, double elevation_rad) const {
    try {
        backgrounds_.at(altitude_m, elevation_rad, 0, 1, name_, "line of sight");
        return true;
    } catch (const InputError&) {
        return false;
    }
}

TargetView TabulatedAtmosphere::targetView(const AtmosphericPath& path) const {
    const TargetView view = sphericalTargetView(path);
    if (supports(AtmosphereProperty::backgroundRadiance) &&
        !holdsSight(path.sensorAltitude_m, view.elevation_rad) &&
        holdsSight(path.sensorAltitude_m, flatTargetView(path).elevation_rad))
        return {flatTargetView(path).elevation_rad, view.hiddenBelow_m};
    return view;
}

void TabulatedAtmosphere::checkSun(const SunPosition& sun) const {
    for (const SpectralRun& run : runs_) {
        if (run.kind == RunKind::solarRadiance && run.geometry.sunElevation_rad &&
            std::abs(*run.geometry.sunElevation_rad - sun.elevation_rad) > sunTolerance_rad) {
            throw InputError(
                {name_, "sun", "an elevation of " + numberText(degrees(sun.elevation_rad)) + " deg",
                 numberText(degrees(*run.geometry.sunElevation_rad)) + " deg as in its runs"});
        }
    }
}

std::vector<double> TabulatedAtmosphere::sunlight(const AtmosphericQuery& query, std::size_t first,
                                                  std::size_t last) const {
    try {
        return suns_.at(query.altitude_m, query.sun.elevation_rad, first, last, name_, "sun");
    } catch (const InputError&) {
        // From high up the sun is seen a little below the horizontal, which runs may contain.
        if (query.sun.isUp())
            throw;
        return std::vector<double>(last - first, 0.0);
    }
}

std::vector<double> TabulatedAtmosphere::valuesAt(const AtmosphericQuery& query, std::size_t first,
                                                  std::size_t last) const {
    const AtmosphericPath& path = query.path;
    const LineOfSight& sight = query.sight;
    const bool isHere = path.range_m == 0.0;
    const std::vector<double> nothing(last - first, 0.0);
    switch (query.quantity) {
    case AtmosphereProperty::transmittance: {
        std::vector<double> values = isHere ? nothing : depths(path, first, last);
        std::ranges::transform(values, values.begin(), [](double d) { return std::exp(-d); });
        return values;
    }
    case AtmosphereProperty::pathRadiance:
        if (isHere)
            return nothing;
        checkSun(query.sun);
        return radiances_.answering(path).at(path, first, last, name_).radiance;
    case AtmosphereProperty::backgroundRadiance:
        checkSun(query.sun);
        return backgrounds_.at(sight.sensorAltitude_m, sight.elevation_rad, first, last, name_,
                               "line of sight");
    case AtmosphereProperty::solarIrradiance:
        return sunlight(query, first, last);
    case AtmosphereProperty::scatteringOpticalDepth:
        return isHere ? nothing : scatterings_.answering(path).at(path, first, last, name_).depth;
    default:
        throw LogicError("a table of runs was asked for what it does not support");
    }
}

Spectrum TabulatedAtmosphere::nativeSpectrum(const AtmosphericQuery& query,
                                             const SpectralRange& range) const {
    const auto [first, last] = nodesAround(range);
    const auto begin = wavelengths_um_.begin();
    const std::vector<double> nodes(begin + static_cast<std::ptrdiff_t>(first),
                                    begin + static_cast<std::ptrdiff_t>(last));
    return {nodes, valuesAt(query, first, last), Spectrum::Outside::hold, name_};
}

std::string TabulatedAtmosphere::nearestRun(const AtmosphericQuery& query) const {
    const auto ofPath = [&](const PropertyTables& tables) -> std::string {
        const AtmosphericPath& path = query.path;
        if (path.range_m == 0.0)
            return "";
        const PathTable& table = tables.answering(path);
        RunDistance distance = table.nearest(path);
        if (query.quantity == AtmosphereProperty::transmittance) {
            const RunDistance back =
                table.nearest({path.targetAltitude_m, path.sensorAltitude_m, path.range_m});
            distance = back.sum() < distance.sum() ? back : distance;
        }
        return nearestRunText(distance);
    };
    switch (query.quantity) {
    case AtmosphereProperty::transmittance:
        return ofPath(transmittances_);
    case AtmosphereProperty::pathRadiance:
        return ofPath(radiances_);
    case AtmosphereProperty::scatteringOpticalDepth:
        return ofPath(scatterings_);
    case AtmosphereProperty::backgroundRadiance:
        return nearestRunText(
            backgrounds_.nearest(query.sight.sensorAltitude_m, query.sight.elevation_rad));
    case AtmosphereProperty::solarIrradiance:
        return nearestRunText(suns_.nearest(query.altitude_m, query.sun.elevation_rad));
    default:
        return "";
    }
}

std::vector<std::string> TabulatedAtmosphere::warnings() const {
    std::vector<std::string> all;
    for (const SpectralRun& run : runs_)
        for (const std::string& warning : run.warnings)
            all.push_back(run.source + ": " + warning);
    return all;
}

std::vector<InterpolationError> TabulatedAtmosphere::interpolationErrors() const {
    std::vector<InterpolationError> all;
    // The radiance tables also hold depths; those were compared with all the others before.
    append(all, transmittances_.finite.errors("transmittance"), "");
    append(all, transmittances_.toSpace.errors("transmittance"), ", to space");
    for (const auto& [table, where] :
         {std::pair{&radiances_.finite, ""}, {&radiances_.toSpace, ", to space"}}) {
        std::vector<InterpolationError> some = table->errors("transmittance");
        std::erase_if(some, [](const InterpolationError& error) {
            return error.quantity == "transmittance";
        });
        append(all, std::move(some), where);
    }
    append(all, backgrounds_.errors("background radiance"), "");
    append(all, suns_.errors("solar irradiance"), "");
    append(all, scatterings_.finite.errors("exp(-scattering depth)"), "");
    append(all, scatterings_.toSpace.errors("exp(-scattering depth)"), ", to space");
    return all;
}

std::vector<std::string> TabulatedAtmosphere::spans() const {
    std::vector<std::string> all;
    const auto add = [&](AtmosphereProperty property, const std::string& span) {
        if (supports(property))
            all.push_back(std::string(irsg::name(property)) + ": " + span);
    };
    add(AtmosphereProperty::transmittance, transmittances_.span());
    add(AtmosphereProperty::pathRadiance, radiances_.span());
    add(AtmosphereProperty::backgroundRadiance, backgrounds_.span());
    add(AtmosphereProperty::solarIrradiance, suns_.span());
    add(AtmosphereProperty::scatteringOpticalDepth, scatterings_.span());
    return all;
}

} // namespace irsg
