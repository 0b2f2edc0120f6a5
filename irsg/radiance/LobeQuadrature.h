#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "irsg/radiance/LobeQuadratureTables.h"
#include "irsg/radiance/SpecularEnvironmentGrid.h"
#include "irsg/radiance/SurfaceRows.h"
#include "irsg/render/rays/SunShadows.h"
#include "irsg/render/sampling/Samples.h"
#include "irsg/render/sampling/SurfaceScene.h"
#include "irsg/signature/SurfaceModel.h"

namespace irsg {

/// What directional surfaces send beside Lambertian ones of equal hemispherical reflectance, sample
/// by sample and whoever drew them. With A_k the albedo of component k at the angle of view, Abar_k
/// its mean, f_k its BRDF and V whether the lobe meets the sky or the ground (or the surface of
/// another part), a row of the component has the layer's factors times
///   A_k - Abar_k          of emission, which it takes away,
///   (1 - V) A_k - Abar_k  of diffuse light: sky, ground, and what other surfaces send,
///   pi f_k - Abar_k       of the sun,
/// and a row of the component and a place of the SpecularEnvironmentGrid has V A_k times the share
/// of the lobe that lies there. What meets another surface is taken to see what the place itself
/// sees on the whole, so that all of it closes: in a room of one temperature every surface is
/// black.
///
/// Which places a lobe has is known from tables over its mirror direction (LobeQuadratureTable), or
/// for nearly smooth surfaces from its facets.
///
/// Lobes are as wide as the sun's disc and as what normals differ by between samples, so that no
/// glint falls between these.
class LobeQuadrature {
  public:
    struct Making {
        std::vector<std::shared_ptr<const SurfaceModel>> models; ///< by row of the drawing
        std::vector<SpecularEnvironmentGrid> grids;              ///< by entity
        std::vector<LobeRole> roles;                             ///< of the factors
        /// Numbers of the frame's directions; none.
        int zenith = -1, sun = -1;
        bool isSunSmart = true;
        std::shared_ptr<LobeQuadratureTables> tables; ///< which are for one thread at a time
    };
    /// `rows` must live as long.
    LobeQuadrature(const SurfaceRows& rows, Making making);

    /// Of sorted layers that were drawn with normals, behind the factors, which are left out from
    /// now on. `shadows`: where light between surfaces counts, or null.
    void apply(const SheetScene& sheet, const SunShadows* shadows, GeometrySamples& samples) const;

  private:
    struct Tile;
    struct Found;
    class TableUse;
    void addLobes(const Tile& tile, int row, int column, const GeometrySamples& samples,
                  SunShadows::Neighbours& neighbours, Found& found) const;

    const SurfaceRows& rows_;
    Making making_;
    std::vector<std::uint32_t> divisions_; // of tables, by row of the drawing; 0: facet by facet
};

} // namespace irsg
