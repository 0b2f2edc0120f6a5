#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "irsg/radiance/GasZones.h"
#include "irsg/radiance/OccluderStacks.h"
#include "irsg/radiance/SurfaceRows.h"

namespace irsg {

/// A line of sight through gases as a weighted sum of columns (GasColumnBasis). Follows the walls
/// of zones along one sample; between nested or crossing zones the gas of the smallest volume
/// counts. One for each walk.
class GasWalk {
  public:
    explicit GasWalk(const SurfaceRows& rows) : rows_(rows), sets_(1) {}

    /// One column or front of some entities' gases, and its weight in the sample, which may be
    /// below 0.
    struct Branch {
        int set = 0; ///< of materials: see columns()
        double weight = 1.0;
    };
    /// What all gas of an entity emits since something that is no gas was met last, behind a column
    /// or front of the others or none.
    struct Emission {
        int row = 0;      ///< drawn row of the entity's first gas, which stands for all of them
        int metFirst = 0; ///< drawn row of the gas nearest to the sensor
        float distance_m = 0.0f;
        Branch before;      ///< what stands before it
        double share = 1.0; ///< what the sample counts (GeometrySamples::gasShares)
        const GasColumnsOfEntity* columns = nullptr;
        int firstSet = 0; ///< of its columns, which follow each other
        /// What its line of sight does more than the last time, by strength (GasColumnBasis::Line):
        /// its columns have the weights of this. Valid until the next time.
        std::span<const double> values;
    };

    /// Begins a sample in the gases of these drawn rows.
    void begin(std::span<const int> rowsAbout);
    /// The line of sight reaches a distance in what it is in.
    void goTo(float distance_m);
    /// It goes through a wall of a gas.
    void cross(int row);
    /// Whether there is gas that nothing was told of yet.
    bool hasNew() const { return hasNew_; }
    /// What emits since the last time in a sample of such a share; from now on it is before
    /// everything else.
    const std::vector<Emission>& takeEmission(double share);
    /// What stands before what comes next; weights add up to 1.
    const std::vector<Branch>& branches();
    /// The same, of fewer fronts, before what surfaces there reflect of others.
    const std::vector<Branch>& reflectionBranches();
    /// The materials of a set; number 0 is none.
    const std::vector<OccluderMaterial>& columns(int set) const {
        return sets_[static_cast<std::size_t>(set)];
    }

  private:
    struct Fronts {
        const GasColumnBasis::Fronts* of = nullptr;
        std::vector<double> weights;
        bool areKnown = false;
    };
    struct Branches {
        std::vector<Branch> all;
        bool areKnown = false;
    };
    /// What stays the same from sample to sample.
    struct OfEntity {
        int entity = 0, firstRow = 0;
        const GasColumnsOfEntity* columns = nullptr;
        int firstSet = 0; ///< of its columns, which follow each other
        GasColumnBasis::Line line;
        /// Of the line as it is, as it was told of last, and more than that.
        std::vector<double> values, told, more;
        Fronts fronts, reflectionFronts;   ///< as it was told of last
        bool isMet = false, isNew = false; ///< in this sample
        int metFirst = 0;
        float from_m = 0.0f;
    };
    int innermost() const;
    OfEntity& ofEntity(int row);
    /// The fronts of all gas that was told of but that of one entity, or none.
    void fillBranches(const OfEntity* without, Fronts OfEntity::*of, std::vector<Branch>& branches);
    const std::vector<Branch>& known(Branches& branches, Fronts OfEntity::*of);
    /// Of a gas that was told of.
    static const Fronts& frontsOf(OfEntity& gas, Fronts OfEntity::*of);
    int joined(int set, int other);

    const SurfaceRows& rows_;
    std::vector<int> inside_; ///< drawn rows
    float at_m_ = 0.0f;
    bool hasNew_ = false;
    std::vector<OfEntity> entities_;
    std::vector<std::size_t> met_; ///< of the entities, in the order in which they were met
    Branches branches_, reflectionBranches_;
    std::vector<Branch> others_, longer_;
    std::vector<std::vector<OccluderMaterial>> sets_;
    std::map<std::pair<int, int>, int> joined_;
    std::vector<Emission> emission_;
};

} // namespace irsg
