#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "irsg/radiance/GeometryBuffer.h"
#include "irsg/radiance/OccluderStacks.h"
#include "irsg/radiance/SceneRadiometry.h"

namespace irsg {

/// Between which reflectivities for which light is solved (SceneLight) each node lies.
struct LightKnots {
    struct Between {
        std::size_t low = 0, high = 0;
        bool operator==(const Between&) const = default;
    };
    std::size_t count = 0;
    std::vector<Between> between; ///< by node
    std::vector<double> parts;    ///< likewise: how far from the first
};

/// Sums over the nodes of an output of what light between surfaces gives at the sensor where its
/// factors are 1, W m-2 sr-1: what a row's sky and ground give, taken away, and what each source
/// gives, knot by knot. Kinds that are asked for together share what is read of the sources.
class LightIntegrals {
  public:
    /// All must live as long. `sources_W_m2_um` by source and node; terms of the light that is
    /// taken away, -1 for none.
    LightIntegrals(const SceneRadiometry& radiometry, const OccluderStacks& occluderStacks,
                   const LightKnots& knots, const std::vector<std::vector<double>>& sources_W_m2_um,
                   int skyTerm, int groundTerm)
        : radiometry_(radiometry),
          occluderStacks_(occluderStacks),
          knots_(knots),
          sources_W_m2_um_(sources_W_m2_um),
          skyTerm_(skyTerm),
          groundTerm_(groundTerm) {}

    /// Sky, ground, then the sources of each knot.
    std::size_t width() const { return 2 + sources_W_m2_um_.size() * knots_.count; }
    std::vector<double> of(const SurfaceStackId& kind, std::size_t output) const;
    /// By kind and output, on all cores.
    std::vector<std::vector<std::vector<double>>>
    ofAll(const std::vector<SurfaceStackId>& kinds) const;

  private:
    /// Kinds whose air an output takes, from which that of others follows.
    struct Taken {
        std::vector<SurfaceStackId> kinds;
        std::vector<SliceBetween> about; ///< by kind that was asked for: between which of `kinds`
    };
    Taken takenFor(std::span<const SurfaceStackId> kinds, std::size_t output) const;
    /// Of a few kinds that are taken.
    std::vector<std::vector<double>> sumsOf(std::span<const SurfaceStackId> kinds,
                                            std::size_t output) const;
    /// By node.
    const double* lightOn(const SurfaceStackId& kind, int term) const;

    const SceneRadiometry& radiometry_;
    const OccluderStacks& occluderStacks_;
    const LightKnots& knots_;
    const std::vector<std::vector<double>>& sources_W_m2_um_;
    int skyTerm_, groundTerm_;
};

} // namespace irsg
