#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "irsg/radiance/LobeAims.h"
#include "irsg/radiance/LobeQuadratureTables.h"
#include "irsg/radiance/MirrorReflectivity.h"
#include "irsg/radiance/SpecularEnvironmentGrid.h"
#include "irsg/radiance/SurfaceRows.h"
#include "irsg/radiance/exchange/LightExchange.h"
#include "irsg/render/rays/SunShadows.h"
#include "irsg/render/sampling/Samples.h"
#include "irsg/render/sampling/SurfaceScene.h"
#include "irsg/signature/SurfaceModel.h"

namespace irsg {

/// What directional surfaces send beside Lambertian ones of equal hemispherical reflectance, sample
/// by sample and whoever drew them. With A_k the albedo of component k at the angle of view, Abar_k
/// its mean and f_k its BRDF, a row of the component has the layer's factors times
///   A_k - Abar_k          of emission, which it takes away,
///   (1 - V) A_k - Abar_k  of diffuse light: sky, ground, and what other surfaces send,
///   pi f_k - Abar_k       of the sun,
/// with V the part of the lobe that meets the atmosphere or a surface. A row of the component and a
/// place of the SpecularEnvironmentGrid has A_k times the part of the lobe that lies there, and a
/// row of the component for other surfaces A_k times the part that meets each (LightExchange). What
/// meets anything else, such as terrain, is taken to see what the place itself sees on the whole,
/// so that all of it closes: in a room of one temperature every surface is black.
///
/// Which places a lobe has is known from tables over its mirror direction (LobeQuadratureTable), or
/// for nearly smooth surfaces, and where other surfaces are met, from its facets: one ray for each,
/// turned from sample to sample. What is small and bright gets a ray more (LobeAims), and each ray
/// counts by the balance heuristic of Veach and Guibas 1995 (Optimally combining sampling
/// techniques for Monte Carlo rendering, SIGGRAPH).
///
/// Lobes are wider by the sun's disc, and at least as wide as what normals differ by between
/// samples, so that no glint falls between these.
class LobeQuadrature {
  public:
    struct Making {
        std::vector<std::shared_ptr<const SurfaceModel>> models; ///< by row of the drawing
        std::vector<SpecularEnvironmentGrid> grids;              ///< by entity
        std::vector<LobeRole> roles;                             ///< of the factors
        MirrorReflectivity mirrors;
        /// Numbers of the frame's directions; none.
        int zenith = -1, sun = -1;
        bool isSunSmart = true;
        std::shared_ptr<LobeQuadratureTables> tables; ///< which are for one thread at a time
    };
    /// `rows` must live as long.
    LobeQuadrature(const SurfaceRows& rows, Making making);

    const MirrorReflectivity& mirrors() const { return making_.mirrors; }

    /// Of sorted layers that were drawn with normals, behind the factors, which are left out from
    /// now on. `shadows` and `exchange`: where surfaces reflect each other, or null. `aims`: to
    /// which rays are sent beside those of facets, or null.
    void apply(const SheetScene& sheet, const SunShadows* shadows, const LightExchange* exchange,
               const LobeAims* aims, GeometrySamples& samples) const;

  private:
    struct Tile;
    struct Found;
    struct DirectionalLayer;
    struct Mirrored;
    class Following;
    class TableUse;
    void addLobes(const Tile& tile, int row, int column, const GeometrySamples& samples,
                  SunShadows::Neighbours& neighbours, Found& found) const;
    SlopeSpread spreadOf(const Tile& tile, int row, int column, const GeometrySamples& samples,
                         const DirectionalLayer& layer) const;
    /// What the lobes of a layer meet. Open ones whose mirror direction is free are not followed
    /// facet by facet.
    void follow(const Tile& tile, const DirectionalLayer& layer, SunShadows::Neighbours& neighbours,
                int column, OccluderStacks& sets, Mirrored& mirrored) const;
    static std::array<std::pair<std::size_t, double>, 4>
    placesAbout(const Tile& tile, const SpecularEnvironmentGrid& grid, const Vec3& direction);
    /// What gas changes of what the place receives, on the whole: lobes see no gas by direction.
    static void addGasChange(const Tile& tile, const DirectionalLayer& layer,
                             const Mirrored& mirrored, Found& found);
    void addByTable(const Tile& tile, const DirectionalLayer& layer, Found& found) const;
    void addByFacets(const DirectionalLayer& layer, const Mirrored& mirrored, Found& found) const;

    const SurfaceRows& rows_;
    Making making_;
    std::vector<std::uint32_t> divisions_; // of tables, by row of the drawing; 0: facet by facet
};

} // namespace irsg
