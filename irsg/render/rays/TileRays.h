#pragma once

#include <vector>

#include "irsg/render/rays/RayMesh.h"
#include "irsg/render/rays/TileSamples.h"
#include "irsg/render/sampling/SurfaceScene.h"

namespace irsg {

/// The rays of one tile of a drawing and what they meet there.
class TileRays {
  public:
    /// Both must live as long.
    TileRays(const SurfaceScene& scene, const SampleTile& tile);

    /// Fills in the samples of a row, counted from the top, and appends fragments of transparent
    /// surfaces, as GeometrySamples has them. Rows may be traced at the same time.
    void traceRow(int row, GeometrySamples& samples, std::vector<float>& fragments) const {
        traceRow(row, 0, tile_.width(), samples, fragments);
    }
    /// The same of the columns from one on to before another.
    void traceRow(int row, int firstColumn, int lastColumn, GeometrySamples& samples,
                  std::vector<float>& fragments) const;

    /// A facet of an entity, -1 for the terrain, in a piece of its mesh.
    struct Facet {
        int entity = 0, piece = 0;
        unsigned number = 0;
        bool operator==(const Facet&) const = default;
    };
    /// What a sample shows, near to far; the terrain where it is behind all.
    std::vector<Facet> facetsAt(int column, int row) const;

  private:
    /// One entity as it stands in the tile.
    struct Body {
        int entity = 0;
        const RayMesh* mesh = nullptr;
        /// Rotation of the axes of eye space to the mesh's, row by row, and the eye there.
        Vec3 x, y, z, eye_m;
        PieceUses uses;
        std::vector<int> rows; ///< by piece

        Vec3 toMesh(const Vec3& eyeDirection) const;
        Vec3 toEye(const Vec3& meshDirection) const;
    };
    struct Met {
        const Body* body = nullptr;
        RayHit hit;
    };
    static Body bodyOf(const SurfaceBody& body, PieceUses uses, std::vector<int> rows);
    static Ray rayTo(const Body& body, const Vec3& eyeDirection, double from_m);
    /// What is met along a direction: transparent layers, in any order, and the opaque facet, if
    /// any, that ends it; nothing of what the terrain hides.
    Met meet(const Vec3& eyeDirection, std::vector<Met>& layers) const;
    /// Fills in the factors of a layer as the shader does.
    void fillFactors(const Met& met, const Vec3& eyeDirection, float* factors) const;
    float depthOf(double distance_m, const Vec3& eyeDirection) const;

    const SurfaceScene& scene_;
    const SampleTile& tile_;
    EyeDirections directions_;
    double sampleWidth_ = 0.0;
    std::vector<Body> bodies_;
    std::vector<Body> occluders_; // the terrain, and ground
};

} // namespace irsg
