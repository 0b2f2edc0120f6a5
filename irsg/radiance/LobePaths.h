#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "irsg/radiance/MirrorReflectivity.h"
#include "irsg/radiance/OccluderStacks.h"
#include "irsg/radiance/SurfaceRows.h"
#include "irsg/radiance/exchange/LightExchange.h"
#include "irsg/render/rays/SunShadows.h"
#include "irsg/signature/SurfaceModel.h"

namespace irsg {

/// The axes of a surface: its normal, and one in the plane of view.
struct SurfaceAxes {
    Vec3 x, y, z;
    /// `view`: to the viewer.
    SurfaceAxes(const Vec3& normal, const Vec3& view);
    SurfaceDirection of(const Vec3& v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
    /// Of a direction in which the surface is seen: interpolated normals may look away from it.
    SurfaceDirection ofSeen(const Vec3& v) const;
    Vec3 to(const SurfaceDirection& v) const { return x * v.x + y * v.y + z * v.z; }
};

/// What the sun's disc adds to the spread of slopes along an axis.
inline constexpr double sunDiscSpread =
    SunShadows::discRadius_rad * SunShadows::discRadius_rad / 8.0;

/// Rays of the lobes of a surface, from what they meet on: through panes, and from mirror to
/// mirror, one facet of each further mirror for a ray. What a mirror that is followed shows in
/// place of its Lambertian mean is, with the names of LobeQuadrature, for each of its components
///   A_k - Abar_k          of emission, which it takes away,
///   (1 - V) A_k - Abar_k  of what its place receives on the whole,
///   pi f_k - Abar_k       of the sun there,
/// and A_k times what its lobe meets. One for each thread.
class LobePaths {
  public:
    struct Making {
        const SurfaceRows* rows = nullptr;
        const std::vector<std::shared_ptr<const SurfaceModel>>* models = nullptr; ///< by row
        const MirrorReflectivity* mirrors = nullptr;
        const LightExchange* exchange = nullptr;
        const SunShadows::OpenPaths* open = nullptr;
        Vec3 sun; ///< towards it, eye space
        bool isSunSmart = true;
    };
    explicit LobePaths(OccluderStacks& sets) : sets_(sets) {}

    /// What the rays of a layer have met so far, by component of its lobes.
    struct Part {
        int set = 0;              ///< of the stacks: what it has passed
        std::uint32_t number = 0; ///< of LightExchange::reflected, or a place of the atmosphere
        SurfaceModel::Amounts weights{};
    };
    struct Found {
        SurfaceModel::Amounts elsewhere{}; ///< what stands for what the layer sees on the whole
        std::vector<Part> surfaces, atmosphere;
        void clear();
        /// Puts equal ones together.
        void join();
    };
    static void add(std::vector<Part>& to, int set, std::uint32_t number,
                    const SurfaceModel::Amounts& weights, double scale);
    static void join(std::vector<Part>& parts);
    /// Calls visit(place, part) for the places of the atmosphere about a direction, eye space.
    using PlacesAbout =
        std::function<void(const Vec3&, const std::function<void(std::size_t, double)>&)>;

    /// What a ray of a lobe has met.
    struct Ray {
        Vec3 direction; ///< eye space
        SunShadows::Met met = SunShadows::Met::nothing;
        SunShadows::Hit end;
        std::vector<SunShadows::Hit> panes;
    };
    /// Whether a ray of the lobes of `row` brings more than what leaves the place where it ends, or
    /// the atmosphere.
    static bool goesOn(const Making& making, const Ray& ray, int row);
    /// Follows it; the lobes weigh so much. `turn`: 0 to 1, another for each ray.
    void follow(const Making& making, Ray& ray, int row, const SurfaceModel::Amounts& weights,
                double turn, const PlacesAbout& placesAbout, Found& found);

  private:
    /// What a ray brings, by what it has passed.
    struct Carried {
        int set = 0;
        SurfaceModel::Amounts weights{};
    };
    /// Of one way from mirror to mirror.
    struct Way {
        const Making& making;
        const PlacesAbout& placesAbout;
        Found& found;
        double turn = 0.0;
    };
    /// How a ray goes on: what reaches the viewer of it at most, and over how many mirrors it went.
    struct Reach {
        double most = 1.0;
        int mirrors = 0;
        SlopeSpread spread; ///< of mirrors so smooth that one ray stands for all facets
    };
    /// False where it ends at what has no places, such as terrain.
    bool go(const Way& way, Ray& ray, const std::vector<Carried>& carried, const Reach& reach);
    void meet(const Way& way, SunShadows::Hit& hit, const Vec3& direction,
              const std::vector<Carried>& carried, const Reach& reach);
    /// Adds the components of a mirror that were met, whose lobes see `elsewhere` on the whole.
    void addMirror(const Way& way, const SunShadows::Hit& hit, const SurfaceAxes& axes,
                   const SurfaceDirection& to, const std::vector<Carried>& carried,
                   const SurfaceModel::Amounts& elsewhere, const Reach& reach);

    OccluderStacks& sets_;
};

} // namespace irsg
