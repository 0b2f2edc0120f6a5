#include "irsg/reference/RayCaster.h"

#include <algorithm>
#include <cmath>

namespace irsg::reference {

namespace {

struct Hit {
    double distance;
    int facet;
    double u, v; // barycentric, of vertices 1 and 2
    bool front;
};

/// Moeller and Trumbore 1997, two-sided.
bool intersect(const Triangle& t, const Vec3& origin, const Vec3& ray, Hit& hit) {
    const Vec3 e1 = t.vertex[1] - t.vertex[0], e2 = t.vertex[2] - t.vertex[0];
    const Vec3 p = cross(ray, e2);
    const double determinant = dot(e1, p);
    if (determinant == 0.0)
        return false;
    const Vec3 s = origin - t.vertex[0];
    hit.u = dot(s, p) / determinant;
    const Vec3 q = cross(s, e1);
    hit.v = dot(ray, q) / determinant;
    hit.distance = dot(e2, q) / determinant;
    hit.front = determinant > 0.0;
    return hit.u >= 0.0 && hit.v >= 0.0 && hit.u + hit.v <= 1.0 && hit.distance > 0.0;
}

} // namespace

std::vector<RayPixel> castRays(const RayScene& scene, const Sensor& sensor,
                               const Viewpoint& viewpoint) {
    const double pitch = 2.0 * std::tan(0.5 * sensor.horizontalFieldOfView_rad) / sensor.width_px;
    std::vector<RayPixel> pixels;
    std::vector<std::vector<int>> order;
    for (int y = 0; y < sensor.height_px; ++y) {
        for (int x = 0; x < sensor.width_px; ++x) {
            const Vec3 ray =
                normalized(viewpoint.forward() +
                           viewpoint.right * ((x + 0.5 - 0.5 * sensor.width_px) * pitch) +
                           viewpoint.up * ((0.5 * sensor.height_px - y - 0.5) * pitch));

            // Every hit in front of the first opaque one, near to far.
            std::vector<Hit> hits;
            for (std::size_t i = 0; i < scene.mesh.size(); ++i) {
                Hit hit{};
                hit.facet = static_cast<int>(i);
                const Triangle& t = scene.mesh[i];
                if (intersect(t, viewpoint.position_m, ray, hit) &&
                    (hit.front || !t.cullsBackFaces)) {
                    hits.push_back(hit);
                }
            }
            std::ranges::sort(hits, {}, &Hit::distance);

            RayPixel pixel;
            double passed = 1.0;
            std::vector<int> facets;
            for (const Hit& hit : hits) {
                const Triangle& t = scene.mesh[static_cast<std::size_t>(hit.facet)];
                const SurfaceTerms& s =
                    scene.surfaces[static_cast<std::size_t>(t.codes.temperature)];
                Vec3 n = normalized(t.normal[0] * (1.0 - hit.u - hit.v) + t.normal[1] * hit.u +
                                    t.normal[2] * hit.v);
                if (!hit.front)
                    n = n * -1.0;
                const double cosView = std::clamp(-dot(n, ray), 0.0, 1.0);
                const double thermal =
                    s.nAngleFactor == 0.0 ? 1.0 : std::pow(cosView, s.nAngleFactor);
                pixel.radiance +=
                    passed *
                    (thermal * s.thermal + 0.5 * (1.0 - n.z) * s.up + 0.5 * (1.0 + n.z) * s.down +
                     std::max(0.0, dot(n, scene.sunDirection)) * s.sun + s.path);
                passed *= s.transmissivity;
                facets.push_back(hit.facet);
                if (s.transmissivity == 0.0)
                    break;
            }
            pixel.opacity = 1.0 - passed;
            pixel.radiance += passed * scene.background;
            pixel.facet = facets.empty() ? -1 : facets.front();
            pixels.push_back(pixel);
            order.push_back(facets);
        }
    }

    const int w = sensor.width_px, h = sensor.height_px;
    for (int y = 1; y + 1 < h; ++y) {
        for (int x = 1; x + 1 < w; ++x) {
            const auto centre = static_cast<std::size_t>(y * w + x);
            bool same = true;
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    same = same &&
                           order[static_cast<std::size_t>((y + dy) * w + x + dx)] == order[centre];
                }
            }
            pixels[centre].isInterior = same;
        }
    }
    return pixels;
}

} // namespace irsg::reference
