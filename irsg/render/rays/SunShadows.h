#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "irsg/geometry/view/Pose.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/ExchangeMesh.h"
#include "irsg/render/rays/RayMesh.h"
#include "irsg/render/rays/SunlitFacets.h"
#include "irsg/render/sampling/Samples.h"
#include "irsg/render/sampling/SurfaceScene.h"

namespace irsg {

/// What stands between surfaces and the sun, whoever drew them. Each sample's place is found again
/// on the facet that it shows, in double, and a ray goes from there to the sun, or 64 to places
/// spread evenly over its disc. What is opaque takes their light away; what is transparent is
/// noted, so that its transmissivity is multiplied node by node. Facets cast the shadows that a
/// sensor at the sun would see them cast.
class SunShadows {
  public:
    /// What light may meet: an entity, or the terrain.
    struct Caster {
        int entity = -1; ///< -1: the terrain
        std::shared_ptr<const RayMesh> mesh;
        Pose pose;
        PieceUses uses{0};
        std::vector<int> rows;      ///< of the drawing, by piece; of the terrain none
        std::vector<int> materials; ///< indices, by piece
    };
    /// For the light that surfaces send each other: the triangles that samples lie in.
    struct LightPlaces {
        std::vector<std::shared_ptr<const ExchangeMesh>> meshes; ///< by caster that has rows
        std::vector<std::uint32_t> firstCell;                    ///< of a mesh among all
        std::vector<bool> matters;                               ///< by row of the drawing
        /// By twice the triangle, + 1 for the back: what its corners' receivers see of the sky and
        /// the ground.
        std::function<std::array<float, 3>(std::uint32_t)> openAt;
    };
    /// Half the angle of the sun's disc, rad.
    static constexpr double discRadius_rad = 0.265 * pi / 180.0;

    struct Source;

    /// `reflects`: by row of the drawing; light on others is left as it is. None: all do.
    SunShadows(std::vector<Caster> casters, std::vector<bool> reflects, bool isDisc);

    /// Where samples lie is told from now on.
    void setPlaces(LightPlaces places) { places_ = std::move(places); }

    /// What is known without rays of the light from a direction in the world: by caster, null where
    /// nothing is.
    struct Sunlit {
        Vec3 towards;
        std::vector<std::shared_ptr<const SunlitFacets>> facets;
    };
    void setSunlit(std::vector<Sunlit> sunlit) { sunlit_ = std::move(sunlit); }
    double radius_rad() const { return isDisc_ ? discRadius_rad : 0.0; }

    const std::vector<bool>& reflects() const { return reflects_; }
    const std::vector<Caster>& casters() const { return casters_; }

    /// The facets on which samples were found that are neighbours of the next, most of which lie on
    /// the same. One for each thread, begun anew with each piece of a drawing.
    class Neighbours {
      public:
        Neighbours() = default;

      private:
        friend class SunShadows;
        struct Known {
            int row = -1, piece = 0;
            unsigned facet = 0;
        };
        std::vector<Known> above_; // by column, of the line before or of this one
        std::vector<Known> last_;  // by row of the drawing
    };

    /// A place on a surface, and the ray that it was found by, in the axes of its mesh.
    struct Place {
        std::size_t caster = 0;
        Ray ray;
        double distance_m = 0.0;
        RayHit hit;
        bool isFound = false;
        Vec3 start_m; ///< in the world, where rays from there begin
    };
    /// What a ray from a place meets first of what is opaque.
    enum class Met { nothing, surface, other };

    /// What a ray from a place meets: its own place, and how samples and drawings name it.
    struct Hit {
        Place place;
        int row = 0;
        GeometrySamples::Place at;
    };

    /// What is seen from the samples of a tile, which must live as long as this.
    class OpenPaths {
      public:
        /// The surface of a row that a ray from the eye meets at a distance. Directions in eye
        /// space.
        Place placeOf(const Vec3& eyeDirection, int row, double distance_m, int column,
                      Neighbours& neighbours) const;
        /// Whether nothing opaque is met on the way from there.
        bool isOpen(const Place& from, const Vec3& towardsEye) const;
        /// What is met: a surface with places that samples may have (`end`), or something else,
        /// such as terrain; and the panes before it, in order, in place of what `panes` held.
        Met met(const Place& from, const Vec3& towardsEye, Hit& end, std::vector<Hit>& panes) const;
        /// Lets rays begin at what was met.
        void goOnFrom(Hit& hit) const;
        /// A direction of the world in eye space.
        Vec3 inEye(const Vec3& direction) const;
        /// Of the smooth surface there, in eye space; to the side that the ray came from.
        Vec3 normalAt(const Hit& hit) const;

      private:
        friend class SunShadows;
        const SunShadows* shadows_ = nullptr;
        std::shared_ptr<const Source> source_;
    };
    OpenPaths openPaths(const SurfaceScene& scene, const SampleTile& tile) const;

    /// Takes the light away from the sorted layers of a drawing that has distances. Fills in the
    /// visibility of the sun where it is wanted. The result does not depend on the number of
    /// threads.
    void apply(const SheetScene& sheet, bool withVisibility, GeometrySamples& samples) const;

  private:
    struct Shaded;
    Source sourceOf(const SurfaceScene& scene, const SampleTile& tile) const;
    Place placeOf(const Source& source, const Vec3& eyeDirection, int row, double distance_m,
                  int column, Neighbours& neighbours) const;
    bool isAllLit(const Place& place, const Sunlit* known) const;
    Vec3 startOf_m(const Place& place) const;
    Met met(const Place& from, const Vec3& towards, Hit& end, std::vector<Hit>& panes) const;
    /// Names what a ray has met of a caster; false for what samples have no places on.
    bool name(std::size_t caster, Hit& hit) const;
    /// Parts of the light that arrive: through nothing, and through sets of materials.
    Shaded lightAt(const Place& place, const Vec3& towardsSun, bool isLit, std::size_t turn) const;
    /// `isLit`: nothing of the mesh of the place itself is in the way.
    bool reaches(const Place& place, const Vec3& start_m, const Vec3& towards, bool isLit,
                 std::vector<std::pair<int, int>>& through) const;

    std::vector<Caster> casters_;
    std::vector<Rotation> toMesh_, toWorld_; // by caster
    std::vector<bool> reflects_;
    bool isDisc_;
    LightPlaces places_;
    std::vector<Sunlit> sunlit_;
};

} // namespace irsg
