#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "irsg/radiance/RadiometryCache.h"
#include "irsg/radiance/Reductions.h"
#include "irsg/radiance/SampledScene.h"
#include "irsg/radiance/ViewGeometry.h"

namespace irsg {

/// The atmosphere at a range along the line of sight of an object.
struct AirAtRange {
    const SampledScene& sampled;    ///< of one band and one object
    const SharedValues& background; ///< behind the object, by node, W m-2 sr-1 um-1
    double range_m = 0.0;           ///< to the reference point
    double pixel_rad = 0.0;         ///< width of a pixel at unit depth
};

/// What the surfaces of one object send along a line of sight, before the atmosphere between it and
/// the sensor: spectra, node by node, of the whole object, by the distance slices of its drawing
/// and by the columns of hot gas in front, whose lines coincide with those of the atmosphere. With
/// tau and P of a slice, what arrives at a range r is
///   E = r^-2 sum_slices sum_nodes (sum_gas A g tau + O P),
/// where A is sent, g the transmittance of a gas column through that atmosphere, and O the part of
/// what is behind that the object hides, both with the weights of the band. So another range costs
/// some sums over nodes, however many surfaces there are; sources, reflected light and
/// inter-reflection do not depend on it. The sums are those of objectSums of the same drawing
/// (addAtRange) to rounding.
class SpectraBeforeAir {
  public:
    /// `atUnitDistance`: factors as RangeGeometry keeps them, with slices of `drawn` about
    /// `drawn_m`. `evaluated`: the scene at any range, prepared as for objectSums.
    SpectraBeforeAir(const ViewGeometry& atUnitDistance, const SurfaceRows& drawn, double drawn_m,
                     const EvaluatedScene& evaluated, const OccluderStacks& occluderStacks);

    /// Whether such spectra exist of a scene: of one object in one band whose surfaces have no
    /// measured spectra, which hold a part of their atmosphere.
    static bool existOf(const SceneRadiometry& radiometry, const SampledScene& sampled);
    /// Whether two atmospheres differ in nothing but the path from an object to the sensor, and in
    /// what is behind the object.
    static bool differByPathAlone(const RadianceTerms& terms, const SampledScene& a,
                                  const SampledScene& b);

    ObjectSums at(const AirAtRange& air) const;
    int layersLeftOver() const { return layersLeftOver_; }
    bool isSliced() const { return offsets_m_.size() > 1; }

  private:
    /// A column of gas that light passes, or the part of it that a gas sends itself.
    struct GasFactor {
        int entity = 0, column = 0;
        std::optional<IrCodes> sender;
        auto operator<=>(const GasFactor&) const = default;
    };
    using GasPath = std::vector<GasFactor>;
    using Spectrum = std::vector<double>;
    /// Without and with the cosine off axis.
    struct Sent {
        Spectrum plain, cosine;
    };
    struct Hidden {
        Spectrum plain, cosine, pixels;
    };
    class Making;
    /// Of the atmosphere between a slice and the sensor, by node.
    struct Through {
        Spectrum transmittance, path;
    };

    std::vector<Through> throughAir(const AirAtRange& air) const;

    const RadianceTerms* terms_;
    std::map<int, GasColumnSpectra::OfEntity> gases_;
    int layersLeftOver_;
    std::vector<double> offsets_m_;             ///< of slices from the reference point
    std::map<GasPath, std::vector<Sent>> sent_; ///< by slice; empty where nothing is
    std::vector<Hidden> hidden_;                ///< likewise
};

} // namespace irsg
