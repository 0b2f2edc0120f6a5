#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <vector>

#include "irsg/atmosphere/engine/RadiativeTransfer.h"
#include "irsg/atmosphere/tables/AdaptiveTable.h"
#include "irsg/core/RecentlyUsed.h"

namespace irsg {

/// What a scene asks of the air at the nodes of one spectral range or of one sensor's wideband
/// points, kept in tables that refine themselves (the report's IrradianceMode 1): over range for
/// every pair of altitudes, over elevation for every altitude of the sensor, over altitude for the
/// sun and the diffuse fluxes. What is asked for once costs a few evaluations more than it would on
/// the fly; what is asked for along a sweep or again and again costs an interpolation.
///
/// Tables are bounded: those that were not asked longest go. What is asked once has none, so that
/// ever other altitudes cost what they do on the fly.
///
/// Optical depths are linear in range where the air is uniform, so transmittances are interpolated
/// through them, and path radiances as they are. Errors: `tolerance` in transmittance, and relative
/// to the sum over nodes for radiances, irradiances and fluxes.
class AtmosphereTables {
  public:
    /// `transfer` must live as long.
    AtmosphereTables(const RadiativeTransfer& transfer, NodeSet nodes, double tolerance = 1e-3);

    const NodeSet& nodes() const { return nodes_; }

    std::vector<double> transmittance(const AtmosphericPath& path) const;
    std::vector<double> pathRadiance(const AtmosphericPath& path, const SunPosition& sun) const;
    std::vector<double> backgroundRadiance(const LineOfSight& sight, const SunPosition& sun) const;
    std::vector<double> solarIrradiance(double altitude_m, const SunPosition& sun) const;
    std::vector<double> upwardFlux(double altitude_m, const SunPosition& sun) const;
    std::vector<double> downwardFlux(double altitude_m, const SunPosition& sun) const;

    std::size_t evaluations() const; ///< of the radiative transfer, for the tables there are
    double largestError() const;     ///< of any table there is, in the unit of the tolerance
    std::size_t bytes() const;       ///< of all tables: not much more than `mostBytes`
    static constexpr std::size_t mostBytes = 32u << 20;

  private:
    enum class Kind { transmittance, pathRadiance, sky, ground, sun, up, down };
    /// Kind, two altitudes or an elevation, a cell or range, elevation and distance of the sun.
    using Key = std::tuple<Kind, double, double, double, double, double>;
    /// Apparent elevations between which the horizon of an altitude lies.
    struct Horizon {
        double below_rad, above_rad;
    };
    Horizon horizonOf(double altitude_m) const;
    /// Null for what is asked for the first time, which is computed as it is.
    std::shared_ptr<const AdaptiveTable> table(const Key& key, double low, double high,
                                               const AdaptiveTable::Function& function,
                                               const AdaptiveTable::Distance& distance) const;
    DirectedLight recent(const Key& key, const std::function<DirectedLight()>& compute) const;
    std::vector<double> towards(const DirectedLight& light, const SunPosition& sun,
                                double azimuth_rad) const;
    std::vector<double> overAltitude(Kind kind, double altitude_m, const SunPosition& sun,
                                     const AdaptiveTable::Function& function) const;

    const RadiativeTransfer& transfer_;
    NodeSet nodes_;
    double tolerance_;
    bool onTheFly() const { return tolerance_ <= 0.0; }
    mutable std::mutex mutex_;
    using CacheEntry = std::pair<Key, std::shared_ptr<const AdaptiveTable>>;
    static constexpr std::size_t mostTables = 512, mostHorizons = 4096;
    mutable RecentlyUsed<CacheEntry> tables_{mostTables};
    mutable RecentlyUsed<Key> asked_{mostTables}; ///< that have no table yet
    mutable std::map<double, Horizon> horizons_;
    /// Light of the last geometries asked for one by one: another azimuth costs a phase function.
    /// So many hold the rows of a fine background.
    static constexpr std::size_t recentKept = 160;
    mutable RecentlyUsed<std::pair<Key, DirectedLight>> recent_{recentKept};
};

} // namespace irsg
