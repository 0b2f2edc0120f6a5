#include "tests/support/RevolvedMeshes.h"

#include <cmath>
#include <utility>

#include "irsg/radiometry/Units.h"

namespace irsg::test {

Profile line(double r0, double z0, double r1, double z1, int steps) {
    Profile profile;
    for (int i = 0; i <= steps; ++i) {
        const double part = static_cast<double>(i) / steps;
        profile.push_back({r0 + part * (r1 - r0), z0 + part * (z1 - z0)});
    }
    return profile;
}

Profile arc(double radius, double z, double from_rad, double to_rad, int steps) {
    Profile profile;
    for (int i = 0; i <= steps; ++i) {
        const double angle = from_rad + (to_rad - from_rad) * i / steps;
        profile.push_back({radius * std::sin(angle), z - radius * std::cos(angle)});
    }
    return profile;
}

Triangles revolved(const Profile& profile, int around, IrCodes codes) {
    Triangles mesh;
    const auto at = [&](std::size_t i, int k) {
        const double angle = 2.0 * pi * (k % around) / around;
        return Vec3{profile[i][0] * std::cos(angle), profile[i][0] * std::sin(angle),
                    profile[i][1]};
    };
    const auto normal = [&](std::size_t i, int k) {
        const double angle = 2.0 * pi * (k % around) / around;
        const double r = profile[i + 1][0] - profile[i][0], z = profile[i + 1][1] - profile[i][1];
        const double size = std::hypot(r, z);
        return Vec3{-z / size * std::cos(angle), -z / size * std::sin(angle), r / size};
    };
    const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& na,
                         const Vec3& nb, const Vec3& nc) {
        if (length(cross(b - a, c - a)) > 1e-12) {
            mesh.push_back({{a, b, c}, {na, nb, nc}, codes, false});
        }
    };
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        for (int k = 0; k < around; ++k) {
            const Vec3 a = at(i, k), b = at(i, k + 1), c = at(i + 1, k), d = at(i + 1, k + 1);
            const Vec3 left = normal(i, k), right = normal(i, k + 1);
            add(a, c, b, left, left, right);
            add(b, c, d, right, left, right);
        }
    }
    return mesh;
}

Triangles reversed(Triangles mesh) {
    for (Triangle& t : mesh) {
        std::swap(t.vertex[1], t.vertex[2]);
        std::swap(t.normal[1], t.normal[2]);
        for (Vec3& n : t.normal) {
            n = n * -1.0;
        }
    }
    return mesh;
}

Triangles disc(double radius, double z, IrCodes codes, bool up) {
    const Triangles mesh = revolved(line(0, z, radius, z, 2), 128, codes);
    return up ? mesh : reversed(mesh);
}

double area_m2(const Triangles& mesh) {
    double sum_m2 = 0.0;
    for (const Triangle& t : mesh) {
        sum_m2 += 0.5 * length(cross(t.vertex[1] - t.vertex[0], t.vertex[2] - t.vertex[0]));
    }
    return sum_m2;
}

Triangles sphereOfEqualArea(double radius, int latitudes, IrCodes codes) {
    Triangles mesh = sphereMesh(radius, latitudes, 2 * latitudes, codes);
    const double scale = std::sqrt(4.0 * pi * radius * radius / area_m2(mesh));
    for (Triangle& t : mesh) {
        for (Vec3& v : t.vertex) {
            v = v * scale;
        }
    }
    return mesh;
}

Triangles moved(Triangles mesh, const Vec3& by) {
    for (Triangle& t : mesh) {
        for (Vec3& v : t.vertex) {
            v = v + by;
        }
    }
    return mesh;
}

Triangles oneSided(Triangles mesh) {
    for (Triangle& t : mesh) {
        t.cullsBackFaces = true;
    }
    return mesh;
}

} // namespace irsg::test
