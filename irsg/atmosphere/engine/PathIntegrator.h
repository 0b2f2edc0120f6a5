#pragma once

#include <functional>
#include <span>
#include <vector>

#include "irsg/atmosphere/engine/CallOnceFast.h"
#include "irsg/atmosphere/engine/NodeColumn.h"
#include "irsg/atmosphere/engine/RayPath.h"

namespace irsg {

/// How much every level's value counts, in m, in the integral along a ray of a quantity that is
/// linear in altitude between levels: each segment gives length (1 - f) to its lower level and
/// length f to its upper. The same from either end.
std::vector<double> levelWeights(const RayPath& path, std::size_t levels);

/// Integrals of extinction or scattering along a ray, per node.
enum class Depth { extinction, scattering };
void opticalDepth(const NodeColumn& column, std::span<const double> weights, Depth which,
                  std::span<double> depth);
/// Puts exp(-depth) in place of every optical depth; 0 beyond 600.
void turnToTransmittance(std::span<double> depth);

/// Writes what a level scatters, per node, into light that travels at an angle to the vertical:
/// `mean` + cosine * `slope`, W m-3 sr-1 um-1, with the cosine of the angle from upwards, -1 to 1;
/// |slope| <= mean.
using ScatteredEmission =
    std::function<void(std::size_t level, std::span<double> mean, std::span<double> slope)>;

/// The source function ((extinction - scattering) B + scattered) / extinction at the levels of a
/// column: computed when first asked for, and kept. Const members may be called from several
/// threads.
class LevelSources {
  public:
    /// What is referred to must live as long. Without `scattered` what is scattered out of a ray is
    /// lost and nothing is scattered into it.
    LevelSources(const NodeColumn& column, ScatteredEmission scattered);

    /// `mean` + cosine * `slope`, per node.
    struct Rows {
        std::vector<double> mean, slope;

        explicit Rows(std::size_t nodes = 0) : mean(nodes), slope(nodes) {}
    };
    const NodeColumn& column() const { return column_; }
    const Rows& at(std::size_t level) const;
    /// In a layer at its part `f`: extinction, absorption and what is scattered are linear in
    /// altitude, and so is the temperature that the air emits with.
    void between(std::size_t layer, double f, Rows& rows) const;

  private:
    struct Level {
        CallOnceFast once;
        Rows rows;
    };
    void scatteredAt(std::size_t level, Rows& rows) const;

    const NodeColumn& column_;
    ScatteredEmission scattered_;
    mutable std::vector<Level> levels_;
};

/// Writes what a level scatters of the beam of the sun by one kind of scatterer, per node, as if it
/// scattered alike in all directions, W m-3 sr-1 um-1. False where it is nothing.
using BeamEmission =
    std::function<bool(std::size_t level, std::size_t kind, std::span<double> emission)>;

/// The source functions of the beam, scattered once, kind by kind of scatterer: what light comes
/// out at an angle is the product with a phase function, so that one pass along a ray serves for
/// all azimuths. Computed when first asked for, and kept. Const members may be called from several
/// threads.
class BeamSources {
  public:
    /// What is referred to must live as long.
    BeamSources(const NodeColumn& column, std::size_t kinds, BeamEmission emission);

    std::size_t kinds() const { return kinds_; }
    /// Per node; empty where it is nothing.
    using Row = std::vector<double>;
    const Row& at(std::size_t level, std::size_t kind) const;
    /// In a layer at its part `f`.
    Row between(std::size_t layer, double f, std::size_t kind) const;

  private:
    struct Level {
        CallOnceFast once;
        Row row;
    };
    Row emittedAt(std::size_t level, std::size_t kind) const;

    const NodeColumn& column_;
    std::size_t kinds_;
    BeamEmission emission_;
    mutable std::vector<Level> levels_; ///< [level][kind]
};

/// Light from along a ray and the share that passes all of it, per node.
struct PathLight {
    std::vector<double> transmittance;
    std::vector<double> radiance; ///< W m-2 sr-1 um-1 at the sensor
    /// Of the beam of the sun, by kind, for phase functions of 1.
    std::vector<std::vector<double>> beams = {};
};

/// Integrates the equation of transfer along a ray, from the sensor outward: in every segment the
/// source function is linear in optical depth between its values at the segment's ends. Exact for
/// isothermal air, for optically thin and thick segments.
PathLight integratePath(const LevelSources& sources, const RayPath& path,
                        const BeamSources* beams = nullptr);
PathLight integratePath(const NodeColumn& column, const RayPath& path, ScatteredEmission scattered);

} // namespace irsg
