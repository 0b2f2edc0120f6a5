#pragma once

#include <functional>
#include <vector>

#include "irsg/atmosphere/ck/CkNodes.h"
#include "irsg/atmosphere/ck/SparseWeights.h"

namespace irsg {

class Atmosphere;
class SensorCkData;
struct CkRequest;

/// What wideband quadrature points are trained on: one air at the nodes of its spectral mode over a
/// band, and where it is asked.
struct CkAtmosphere {
    CkNodes nodes;
    /// At every node, in their order; empty where the air does not know: it lacks the quantity, or
    /// its tables do not reach there.
    std::function<std::vector<double>(const AtmosphericQuery&)> values;
    double ambient_K = 288.15;          ///< of the ground's air, the scale of what is faint
    std::vector<AtmosphericPath> paths; ///< of the training
    std::vector<LineOfSight> sights;    ///< the same
    /// Paths of the training that are asked for their transmittance alone, a tenth of the work:
    /// what they emit is taken as that of air of one temperature, cold and warm.
    std::vector<AtmosphericPath> shades{};
    std::vector<AtmosphericPath> heldOut{}; ///< between them
};

/// Computed air, with paths of all kinds between the ground and its top. Refers to `transfer`.
CkAtmosphere ckAtmosphereOf(const RadiativeTransfer& transfer, const Band& band);

/// How far quadrature points are off, relative to each in-band quantity.
struct CkErrors {
    double largest = 0.0, rms = 0.0;
};

/// The points that serve the request along the paths and lines of sight of an air, which is asked
/// from all threads; with `heldOut` also how far they are off along its held-out paths, against the
/// sums over its nodes. InputError where the band has no node or the air answers nothing there.
SparseWeights trainedPoints(const CkAtmosphere& air, const CkRequest& request,
                            CkErrors* heldOut = nullptr);
/// How far quadrature points of any air are off, against its spectral mode with a quadrature of its
/// own for every path: bodies of several temperatures, grey, sloped and of the scene, path radiance
/// and reflected light.
CkErrors heldOutErrors(const Atmosphere& air, const SensorCkData& points, const CkRequest& request,
                       const std::vector<AtmosphericPath>& paths);

} // namespace irsg
