#include "irsg/atmosphere/tables/AtmosphereTables.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace irsg {

namespace {

constexpr double farthest_m = 2.0e6;
constexpr double opaqueDepth = 80.0;

/// The shortest range between two altitudes that can be asked for.
double shortest_m(double a_m, double b_m) {
    return std::abs(a_m - b_m);
}

/// Transmittances as optical depths, and back.
std::vector<double> depths(std::vector<double> transmittance) {
    for (double& value : transmittance)
        value = value > 0.0 ? std::min(-std::log(value), opaqueDepth) : opaqueDepth;
    return transmittance;
}

std::vector<double> transmittances(std::vector<double> depth) {
    for (double& value : depth)
        value = value >= opaqueDepth ? 0.0 : std::exp(-value);
    return depth;
}

/// How wrong a transmittance may be anywhere between two depths: a depth that bends from the line
/// halfway counts by what it does where the air is clearest, not where it is black anyway.
double transmittanceDifference(const std::vector<double>& found, const std::vector<double>& from,
                               const std::vector<double>& to) {
    double largest = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double bend = std::abs(found[i] - 0.5 * (from[i] + to[i]));
        largest = std::max(largest, -std::exp(-std::min(from[i], to[i])) * std::expm1(-bend));
    }
    return largest;
}

/// All of a DirectedLight in a row, so that a table can be made of it: the elevation last.
std::vector<double> packed(const DirectedLight& light) {
    std::vector<double> row = light.even;
    for (const std::vector<double>& beam : light.beams)
        row.insert(row.end(), beam.begin(), beam.end());
    row.push_back(light.sightElevation_rad);
    return row;
}

DirectedLight unpacked(const std::vector<double>& row, std::size_t nodes) {
    DirectedLight light;
    light.sightElevation_rad = row.back();
    const auto at = [&](std::size_t place) {
        return row.begin() + static_cast<std::ptrdiff_t>(place);
    };
    light.even.assign(at(0), at(nodes));
    for (std::size_t first = nodes; first + nodes < row.size(); first += nodes)
        light.beams.emplace_back(at(first), at(first + nodes));
    return light;
}

/// The largest relative difference of any part that is not below a thousandth of the first: phase
/// functions make some of them count more, and others less.
AdaptiveTable::Distance partsDifference(std::size_t nodes) {
    return [nodes](const std::vector<double>& a, const std::vector<double>& from,
                   const std::vector<double>& to) {
        double largest = 0.0, whole = 0.0;
        for (std::size_t first = 0; first + nodes <= a.size(); first += nodes) {
            double difference = 0.0, sum = 0.0;
            for (std::size_t i = first; i < first + nodes; ++i) {
                difference += std::abs(a[i] - 0.5 * (from[i] + to[i]));
                sum += std::abs(a[i]);
            }
            whole = std::max(whole, sum);
            if (difference > 0.0)
                largest = std::max(largest, difference / std::max(sum, 1e-3 * whole));
        }
        return largest;
    };
}

/// Ranges from the shortest up, in cells that grow with the range: tables run over whole powers of
/// four of the distance beyond the shortest, so that near paths do not refine far ones.
struct RangeCell {
    double low_m, high_m;
};
RangeCell cellOf(double range_m, double least_m) {
    constexpr double first_m = 100.0;
    const double beyond = range_m - least_m;
    if (beyond <= first_m)
        return {least_m, least_m + first_m};
    const double power = std::floor(std::log(beyond / first_m) / std::log(4.0));
    const double low = first_m * std::pow(4.0, power);
    return beyond > 4.0 * low ? RangeCell{least_m + 4.0 * low, least_m + 16.0 * low}
                              : RangeCell{least_m + low, least_m + 4.0 * low};
}

} // namespace

AtmosphereTables::AtmosphereTables(const RadiativeTransfer& transfer, NodeSet nodes,
                                   double tolerance)
    : transfer_(transfer), nodes_(std::move(nodes)), tolerance_(tolerance) {}

std::shared_ptr<const AdaptiveTable>
AtmosphereTables::table(const Key& key, double low, double high,
                        const AdaptiveTable::Function& function,
                        const AdaptiveTable::Distance& distance) const {
    const std::lock_guard lock(mutex_);
    const auto isThis = [&](const CacheEntry& kept) { return kept.first == key; };
    if (const CacheEntry* known = tables_.find(isThis))
        return known->second;
    // What is asked once is not worth a table.
    const auto isSame = [&](const Key& asked) { return asked == key; };
    if (asked_.find(isSame) == nullptr) {
        asked_.add(key);
        return nullptr;
    }
    // Those that were not asked longest make place; who is asking one meanwhile still has it.
    std::size_t bytes = 0;
    tables_.letGo([&](const CacheEntry& kept) {
        bytes += kept.second->bytes();
        return bytes > mostBytes;
    });
    return tables_
        .add({key, std::make_shared<AdaptiveTable>(low, high, tolerance_, function, distance)})
        .second;
}

std::vector<double> AtmosphereTables::transmittance(const AtmosphericPath& path) const {
    const double least_m = shortest_m(path.sensorAltitude_m, path.targetAltitude_m);
    if (onTheFly() || !(path.range_m > least_m && path.range_m <= farthest_m))
        return transfer_.transmittance(nodes_, path);
    const RangeCell cell = cellOf(path.range_m, least_m);
    auto function = [this, path](double range_m) {
        AtmosphericPath at = path;
        at.range_m = range_m;
        return depths(transfer_.transmittance(nodes_, at));
    };
    // The path between two altitudes is the same in both directions.
    const auto [low_m, high_m] = std::minmax(path.sensorAltitude_m, path.targetAltitude_m);
    const Key key{Kind::transmittance, low_m, high_m, cell.low_m, 0.0, 0.0};
    const auto own = table(key, cell.low_m, cell.high_m, function, transmittanceDifference);
    return own ? transmittances(own->at(path.range_m)) : transfer_.transmittance(nodes_, path);
}

std::vector<double> AtmosphereTables::towards(const DirectedLight& light, const SunPosition& sun,
                                              double azimuth_rad) const {
    return transfer_.towards(nodes_, light, sun.elevation_rad, azimuth_rad - sun.azimuth_rad);
}

DirectedLight AtmosphereTables::recent(const Key& key,
                                       const std::function<DirectedLight()>& compute) const {
    {
        const std::lock_guard lock(mutex_);
        if (const auto* known = recent_.find([&](const auto& kept) { return kept.first == key; }))
            return known->second;
    }
    DirectedLight light = compute();
    const std::lock_guard lock(mutex_);
    recent_.add({key, light});
    return light;
}

std::vector<double> AtmosphereTables::pathRadiance(const AtmosphericPath& path,
                                                   const SunPosition& sun) const {
    const double least_m = shortest_m(path.sensorAltitude_m, path.targetAltitude_m);
    const auto alone = [&] {
        const Key key{Kind::pathRadiance, path.sensorAltitude_m, path.targetAltitude_m,
                      path.range_m,       sun.elevation_rad,     sun.distance_au};
        return towards(recent(key, [&] { return transfer_.pathLight(nodes_, path, sun); }), sun,
                       path.azimuth_rad);
    };
    if (onTheFly() || !(path.range_m > least_m && path.range_m <= farthest_m))
        return alone();
    const RangeCell cell = cellOf(path.range_m, least_m);
    auto function = [this, path, sun](double range_m) {
        AtmosphericPath at = path;
        at.range_m = range_m;
        return packed(transfer_.pathLight(nodes_, at, sun));
    };
    const Key key{Kind::pathRadiance, path.sensorAltitude_m, path.targetAltitude_m,
                  cell.low_m,         sun.elevation_rad,     sun.distance_au};
    const auto own =
        table(key, cell.low_m, cell.high_m, function, partsDifference(nodes_.nodes.size()));
    if (!own)
        return alone();
    return towards(unpacked(own->at(path.range_m), nodes_.nodes.size()), sun, path.azimuth_rad);
}

AtmosphereTables::Horizon AtmosphereTables::horizonOf(double altitude_m) const {
    {
        const std::lock_guard lock(mutex_);
        if (const auto found = horizons_.find(altitude_m); found != horizons_.end())
            return found->second;
    }
    // By halving between straight down and straight up.
    Horizon horizon{-0.5 * std::numbers::pi, 0.5 * std::numbers::pi};
    while (horizon.above_rad - horizon.below_rad > 1e-12) {
        const double middle_rad = 0.5 * (horizon.below_rad + horizon.above_rad);
        const bool ground =
            transfer_.tracer().along({altitude_m, middle_rad, 0.0}).end == RayPath::End::ground;
        (ground ? horizon.below_rad : horizon.above_rad) = middle_rad;
    }
    const std::lock_guard lock(mutex_);
    if (horizons_.size() >= mostHorizons)
        horizons_.clear();
    return horizons_.emplace(altitude_m, horizon).first->second;
}

std::vector<double> AtmosphereTables::backgroundRadiance(const LineOfSight& sight,
                                                         const SunPosition& sun) const {
    const auto light = [this, sight, sun](double elevation_rad) {
        LineOfSight at = sight;
        at.elevation_rad = elevation_rad;
        return transfer_.skyLight(nodes_, at, sun);
    };
    const auto alone = [&] {
        const Key key{Kind::sky, sight.sensorAltitude_m, sight.elevation_rad,
                      0.0,       sun.elevation_rad,      sun.distance_au};
        return towards(recent(key, [&] { return light(sight.elevation_rad); }), sun,
                       sight.azimuth_rad);
    };
    if (onTheFly())
        return alone();
    // The ground and the sky are two tables: what is seen jumps at the horizon.
    const bool ground = transfer_.tracer().along(sight).end == RayPath::End::ground;
    const Horizon horizon = horizonOf(sight.sensorAltitude_m);
    const double low = ground ? -0.5 * std::numbers::pi : horizon.above_rad;
    const double high = ground ? horizon.below_rad : 0.5 * std::numbers::pi;
    if (!(sight.elevation_rad >= low && sight.elevation_rad <= high && low < high))
        return alone();
    const Key key{ground ? Kind::ground : Kind::sky,
                  sight.sensorAltitude_m,
                  0.0,
                  0.0,
                  sun.elevation_rad,
                  sun.distance_au};
    auto function = [light](double elevation_rad) { return packed(light(elevation_rad)); };
    const auto own = table(key, low, high, function, partsDifference(nodes_.nodes.size()));
    if (!own)
        return alone();
    return towards(unpacked(own->at(sight.elevation_rad), nodes_.nodes.size()), sun,
                   sight.azimuth_rad);
}

std::vector<double> AtmosphereTables::overAltitude(Kind kind, double altitude_m,
                                                   const SunPosition& sun,
                                                   const AdaptiveTable::Function& function) const {
    const double top_m = transfer_.air().profile.top_m();
    if (onTheFly() || !(altitude_m >= 0.0 && altitude_m <= top_m))
        return function(altitude_m);
    const Key key{kind, 0.0, 0.0, 0.0, sun.elevation_rad, sun.distance_au};
    const auto own = table(key, 0.0, top_m, function, halfway(relativeDifference));
    return own ? own->at(altitude_m) : function(altitude_m);
}

std::vector<double> AtmosphereTables::solarIrradiance(double altitude_m,
                                                      const SunPosition& sun) const {
    return overAltitude(Kind::sun, altitude_m, sun, [this, sun](double at_m) {
        return transfer_.solarIrradiance(nodes_, at_m, sun);
    });
}

std::vector<double> AtmosphereTables::upwardFlux(double altitude_m, const SunPosition& sun) const {
    return overAltitude(Kind::up, altitude_m, sun, [this, sun](double at_m) {
        return transfer_.upwardFlux(nodes_, at_m, sun);
    });
}

std::vector<double> AtmosphereTables::downwardFlux(double altitude_m,
                                                   const SunPosition& sun) const {
    return overAltitude(Kind::down, altitude_m, sun, [this, sun](double at_m) {
        return transfer_.downwardFlux(nodes_, at_m, sun);
    });
}

std::size_t AtmosphereTables::evaluations() const {
    const std::lock_guard lock(mutex_);
    std::size_t sum = 0;
    tables_.letGo([&](const CacheEntry& kept) {
        sum += kept.second->evaluations();
        return false;
    });
    return sum;
}

std::size_t AtmosphereTables::bytes() const {
    const std::lock_guard lock(mutex_);
    std::size_t sum = 0;
    tables_.letGo([&](const CacheEntry& kept) {
        sum += kept.second->bytes();
        return false;
    });
    return sum;
}

double AtmosphereTables::largestError() const {
    const std::lock_guard lock(mutex_);
    double largest = 0.0;
    tables_.letGo([&](const CacheEntry& kept) {
        largest = std::max(largest, kept.second->largestError());
        return false;
    });
    return largest;
}

} // namespace irsg
