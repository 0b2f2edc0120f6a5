#include "irsg/atmosphere/engine/AltitudeGrid.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <span>
#include <utility>

namespace irsg {

namespace {

/// An ordered set of altitudes between 0 and a top, none close to another.
class Altitudes {
  public:
    explicit Altitudes(double top_m) : values_{0.0, top_m} {}

    /// Does nothing where there is no place for it.
    void add(double altitude_m) {
        constexpr double closest_m = 0.5;
        if (altitude_m <= 0.0 || altitude_m >= values_.back() ||
            values_.size() >= mostTransferAltitudes)
            return;
        const auto above = std::ranges::lower_bound(values_, altitude_m);
        if (*above - altitude_m >= closest_m && altitude_m - *(above - 1) >= closest_m)
            values_.insert(above, altitude_m);
    }
    const std::vector<double>& values() const { return values_; }

  private:
    std::vector<double> values_;
};

void addSteps(Altitudes& altitudes) {
    struct Part {
        double from_m, to_m, step_m;
    };
    constexpr Part parts[] = {{200.0, 2000.0, 200.0}, {2000.0, 5000.0, 250.0},
                              {5000.0, 12e3, 500.0},  {12e3, 30e3, 1000.0},
                              {30e3, 50e3, 2000.0},   {50e3, 70e3, 4000.0},
                              {70e3, 120e3, 5000.0}};
    for (const Part& part : parts)
        for (double z = part.from_m; z < part.to_m; z += part.step_m)
            altitudes.add(z);
}

/// A piece of the grid with the level of the profile inside it that a straight line between the
/// ends misses by most, in units of what is allowed.
struct Piece {
    AtmosphericState lower, upper;
    std::span<const AtmosphericState> inside;
    std::size_t worst = 0;
    double error = 0.0;

    bool operator<(const Piece& other) const { return error < other.error; }
};

double logarithm(double fraction) {
    constexpr double hardlyAnything = 1e-8;
    return std::log(fraction + hardlyAnything);
}

double errorOf(const AtmosphericState& level, const AtmosphericState& lower,
               const AtmosphericState& upper) {
    const double part =
        (level.altitude_m - lower.altitude_m) / (upper.altitude_m - lower.altitude_m);
    const auto missed = [&](double low, double value, double high) {
        return std::abs(value - (low + part * (high - low)));
    };
    double error = missed(lower.temperature_K, level.temperature_K, upper.temperature_K) /
                   transferTemperatureTolerance_K;
    for (std::size_t gas = 0; gas < gasCount; ++gas)
        error = std::max(error, missed(logarithm(lower.moleFraction[gas]),
                                       logarithm(level.moleFraction[gas]),
                                       logarithm(upper.moleFraction[gas])) /
                                    transferAmountTolerance);
    return error * std::min(1.0, level.pressure_hPa / transferTolerancePressure_hPa);
}

Piece pieceOf(const AtmosphericState& lower, const AtmosphericState& upper,
              std::span<const AtmosphericState> inside) {
    Piece piece{lower, upper, inside};
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const double error = errorOf(inside[i], lower, upper);
        if (error > piece.error) {
            piece.error = error;
            piece.worst = i;
        }
    }
    return piece;
}

/// Of the places in the grid, what bends leave to steep layers and to the inside of particles.
constexpr std::size_t keptForOthers = 16;

/// Adds levels of the profile, the most needed first, until straight lines miss none by more than
/// is allowed.
void addBends(Altitudes& altitudes, const Profile& profile) {
    const std::vector<double> grid = altitudes.values();
    const std::span<const AtmosphericState> levels = profile.levels();
    const auto levelsBetween = [&](double from_m, double to_m) {
        const auto first =
            std::ranges::upper_bound(levels, from_m, {}, &AtmosphericState::altitude_m);
        const auto last = std::ranges::lower_bound(levels, to_m, {}, &AtmosphericState::altitude_m);
        return std::span(first, std::max(first, last));
    };
    std::priority_queue<Piece> pieces;
    for (std::size_t i = 1; i < grid.size(); ++i)
        pieces.push(pieceOf(profile.at(grid[i - 1]), profile.at(grid[i]),
                            levelsBetween(grid[i - 1], grid[i])));
    while (pieces.top().error > 1.0 &&
           altitudes.values().size() + keptForOthers < mostTransferAltitudes) {
        const Piece piece = pieces.top();
        pieces.pop();
        const AtmosphericState& level = piece.inside[piece.worst];
        // Where the grid is too close already, each side is looked at as if it were there.
        altitudes.add(level.altitude_m);
        pieces.push(pieceOf(piece.lower, level, piece.inside.first(piece.worst)));
        pieces.push(pieceOf(level, piece.upper, piece.inside.subspan(piece.worst + 1)));
    }
}

/// Divides what is steeper than air that is well mixed, since between two altitudes it is Planck's
/// radiance, not the temperature, that is taken to be linear.
void divideSteepLayers(Altitudes& altitudes, const Profile& profile) {
    constexpr double steep_K_per_m = 0.01;
    const std::vector<double> grid = altitudes.values();
    for (std::size_t i = 1; i < grid.size(); ++i) {
        const AtmosphericState lower = profile.at(grid[i - 1]);
        const double thickness_m = grid[i] - grid[i - 1];
        const double change_K = std::abs(profile.at(grid[i]).temperature_K - lower.temperature_K);
        if (change_K <= steep_K_per_m * thickness_m ||
            lower.pressure_hPa < transferTolerancePressure_hPa)
            continue;
        const double parts = std::ceil(change_K / transferTemperatureStep_K);
        for (double part = 1.0; part < parts; ++part)
            altitudes.add(grid[i - 1] + thickness_m * part / parts);
    }
}

} // namespace

std::vector<double> transferAltitudes_m(const Profile& profile,
                                        const std::vector<ParticleLayer>& particles) {
    Altitudes altitudes(profile.top_m());
    // Ends of particles first: nothing may come too close to an edge of a cloud.
    for (const ParticleLayer& layer : particles) {
        if (layer.altitudes_m.empty())
            continue;
        altitudes.add(layer.altitudes_m.front());
        altitudes.add(layer.altitudes_m.back());
        if (layer.extinction550_per_m.front() > 0.0)
            altitudes.add(layer.altitudes_m.front() - 1.0);
        if (layer.extinction550_per_m.back() > 0.0)
            altitudes.add(layer.altitudes_m.back() + 1.0);
    }
    addSteps(altitudes);
    addBends(altitudes, profile);
    divideSteepLayers(altitudes, profile);
    for (const ParticleLayer& layer : particles)
        for (const double z : layer.altitudes_m)
            altitudes.add(z);
    return altitudes.values();
}

} // namespace irsg
