#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "irsg/radiance/GasZones.h"
#include "irsg/radiance/OccluderStacks.h"
#include "irsg/radiance/SurfaceRows.h"

namespace irsg {

/// A line of sight through gases as a weighted sum of columns (GasColumnKey): its lengths in the
/// gases of an entity lie in a box of knots, which is divided into simplices by the order of the
/// lengths' fractions (Freudenthal 1942, Ann. Math. 43, 580), so that what is linear in the lengths
/// comes out exact and the rest continuous. Follows the walls of zones along one sample; between
/// nested or crossing zones the gas of the smallest volume counts. One for each walk.
class GasWalk {
  public:
    explicit GasWalk(const SurfaceRows& rows) : rows_(rows) {}

    /// A column of some entities' gases, and the part of the sample that has it.
    struct Branch {
        std::vector<OccluderMaterial> columns;
        double weight = 1.0;
    };
    /// Emission of the stretches since something that is no gas was met last.
    struct Emission {
        int row = 0; ///< drawn row of the gas
        float distance_m = 0.0f;
        Branch branch; ///< with the column itself
    };

    /// Begins a sample in the gases of these drawn rows.
    void begin(std::span<const int> rowsAbout);
    /// The line of sight reaches a distance in what it is in.
    void goTo(float distance_m);
    /// It goes through a wall of a gas.
    void cross(int row);
    /// Whether there is gas that nothing was told of yet.
    bool hasNew() const { return hasNew_; }
    /// What emits since the last time; from now on it is before everything else.
    const std::vector<Emission>& takeEmission();
    /// What stands before what comes next; weights add up to 1.
    const std::vector<Branch>& branches() const { return branches_; }

  private:
    struct Stretch {
        int row = 0;
        double length_m = 0.0;
        float from_m = 0.0f;
    };
    struct OfEntity {
        int entity = 0;
        std::vector<Stretch> stretches;
        std::size_t told = 0; ///< of the stretches
        struct Vertex {
            std::vector<double> lengths_m;
            double weight = 0.0;
            int number = 0; ///< of its column as a whole
        };
        std::vector<Vertex> vertices;
    };
    int innermost() const;
    OfEntity& ofEntity(int entity);
    /// The vertices of the simplex that holds all lengths.
    std::vector<OfEntity::Vertex> simplex(const OfEntity& gas);
    /// Fills in `column_`.
    void makeColumn(const OfEntity& gas, const OfEntity::Vertex& vertex, std::size_t before);
    int numberOfColumn();
    void addEmission(const OfEntity& gas, std::size_t vertex);
    void fillBranches();

    const SurfaceRows& rows_;
    std::vector<int> inside_; ///< drawn rows
    float at_m_ = 0.0f;
    bool hasNew_ = false;
    std::vector<OfEntity> gases_; ///< in the order in which they were met
    std::vector<Branch> branches_;
    GasColumnKey column_;
    std::map<GasColumnKey, int> numbers_; ///< of those that this walk has met
    std::vector<Emission> emission_;
};

} // namespace irsg
