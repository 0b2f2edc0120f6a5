#include "tests/support/ExchangeCase.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <tuple>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/random/Philox.h"
#include "tests/support/TracedScene.h"

namespace irsg::test {

namespace {

/// Around the corners of all bodies that count, world axes.
BoundingBox extentOf(const ExchangeCase& one) {
    BoundingBox extent = BoundingBox::nowhere();
    for (std::size_t e = 0; e < one.entities.size(); ++e) {
        if (one.body && e != *one.body) {
            continue;
        }
        for (const Mesh::Part& part : one.entities[e].model->mesh()->parts) {
            for (const Float3& vertex : part.vertices) {
                extent.include(one.entities[e].pose.toWorld(toVec3(vertex)));
            }
        }
    }
    return extent;
}

double rangeOf_m(const BoundingBox& extent) {
    return 1000.0 * 0.5 * extent.diagonal_m();
}

} // namespace

const Band& band() {
    static const Band made = Band::topHat(3.0, 5.0);
    return made;
}

Scene sceneOf(const ExchangeCase& one) {
    ConstantAtmosphere vacuum;
    const double width_um = band().area_um();
    vacuum.sunValue = one.sun_W_m2 / width_um;
    vacuum.downValue = pi * one.sky_W_m2_sr / width_um;
    vacuum.upValue = pi * one.ground_W_m2_sr / width_um;
    Scene scene;
    scene.settings = RenderSettings::direct();
    scene.environment = environmentOf(vacuum, one.sun);
    scene.entities = one.entities;
    const Vec3 centre_m = extentOf(one).centre();
    for (Entity& entity : scene.entities) { // one range for all of them
        entity.referencePoint_m =
            entity.pose.attitude.rotation().transposed() * (centre_m - entity.pose.position_m);
    }
    RenderSettings& settings = scene.settings;
    settings.engine = EngineChoice::rays;
    settings.sunShadows = SunShadowMode::point;
    settings.background = BackgroundMode::none;
    settings.bounces = one.bounces;
    if (!(one.sun_W_m2 > 0.0)) {
        settings.sun = ReflectionMode::off;
    }
    if (!one.isLitAround()) {
        settings.ambientReflection = ReflectionMode::off;
    }
    return scene;
}

SensorView viewOf(const ExchangeCase& one) {
    const BoundingBox extent = extentOf(one);
    const double range_m = rangeOf_m(extent);
    const double width_m = (one.place_m ? 0.001 : 1.1) * extent.diagonal_m();
    const int pixels = one.place_m ? 4 : 1024; // their samples are right to 0.05 %
    SensorView view;
    view.sensor = {.width_px = pixels,
                   .height_px = pixels,
                   .horizontalFieldOfView_rad = width_m / range_m,
                   .band = band()};
    view.viewpoint =
        Viewpoint::about(one.place_m.value_or(extent.centre()), 0.0, radians(one.azimuth_deg),
                         radians(one.elevation_deg), range_m);
    return view;
}

TracedLight truthOf(const ExchangeCase& one, TraceSettings settings) {
    const PathTracer tracer(tracedOf(sceneOf(one), band()),
                            {.towardsSun = direction(one.sun.azimuth_rad, one.sun.elevation_rad),
                             .sun_W_m2 = one.sun_W_m2,
                             .sky_W_m2_sr = one.sky_W_m2_sr,
                             .ground_W_m2_sr = one.ground_W_m2_sr},
                            one.skin_m);
    const Vec3 towards = direction(radians(one.azimuth_deg), radians(one.elevation_deg));
    settings.bounces = one.bounces;
    if (one.place_m) {
        return tracer.radiance(*one.place_m, towards, settings);
    }
    const BoundingBox extent = extentOf(one);
    settings.centre_m = extent.centre();
    settings.distance_m = rangeOf_m(extent);
    if (one.body) {
        settings.body = static_cast<int>(*one.body);
    }
    return tracer.intensity(towards, settings);
}

ExchangeCase seenFrom(std::string name, std::string variant, std::vector<Entity> entities,
                      double azimuth_deg, double elevation_deg) {
    ExchangeCase one;
    one.name = std::move(name);
    one.variant = std::move(variant);
    one.entities = std::move(entities);
    one.azimuth_deg = azimuth_deg;
    one.elevation_deg = elevation_deg;
    return one;
}

Entity greyEntity(std::shared_ptr<const Model> model, double emissivity, double temperature_K,
                  const std::set<int>& absentMaterials) {
    SignatureDatabase database;
    for (const auto& [codes, use] : model->codes()) {
        database.temperatures[codes.temperature] = fixedTemperature(temperature_K);
        database.materials[codes.material] = absentMaterials.contains(codes.material)
                                                 ? greyMaterial(0.0, 1.0)
                                                 : greyMaterial(emissivity);
    }
    return entityOf(std::move(model), std::move(database));
}

VariedCase varied(const ExchangeCase& one, unsigned seed) {
    if (one.isLitAround()) {
        throw LogicError("sky and ground do not turn with a body");
    }
    std::uint64_t drawn = 0;
    const auto unit = [&] { return unitOf(seed, {}, drawn++); };
    const Vec3 sun = direction(one.sun.azimuth_rad, one.sun.elevation_rad);
    Rotation rotation;
    do {
        rotation = Attitude{2.0 * pi * unit(), pi * (unit() - 0.5), 2.0 * pi * unit()}.rotation();
    } while (one.sun_W_m2 > 0.0 && (rotation * sun).z < 0.1); // it stays above the horizon
    const double scale = std::pow(30.0, 2.0 * unit() - 1.0);
    const int cuts = 1 + static_cast<int>(3.0 * unit());
    const bool isApart = unit() < 0.5;
    const Vec3 origin_m = one.entities.front().pose.position_m;
    const auto there = [&](const Vec3& world_m) { return rotation * (world_m - origin_m) * scale; };

    // By entity, and by its materials.
    std::map<std::pair<std::size_t, int>, Triangles> bodies;
    for (std::size_t e = 0; e < one.entities.size(); ++e) {
        for (const Mesh::Part& part : one.entities[e].model->mesh()->parts) {
            for (std::size_t i = 0; i + 2 < part.triangles.size(); i += 3) {
                std::array<Vec3, 3> corner;
                for (std::size_t k = 0; k < 3; ++k) {
                    corner[k] = there(
                        one.entities[e].pose.toWorld(toVec3(part.vertices[part.triangles[i + k]])));
                }
                const Vec3 normal = normalized(cross(corner[1] - corner[0], corner[2] - corner[0]));
                const auto at = [&](int a, int b) {
                    return corner[0] + (corner[1] - corner[0]) * (1.0 * a / cuts) +
                           (corner[2] - corner[0]) * (1.0 * b / cuts);
                };
                Triangles& body = bodies[{e, isApart ? part.codes.material : 0}];
                const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
                    body.push_back({{a, b, c}, {normal, normal, normal}, part.codes, part.culled});
                };
                for (int a = 0; a < cuts; ++a) {
                    for (int b = 0; a + b < cuts; ++b) {
                        add(at(a, b), at(a + 1, b), at(a, b + 1));
                        if (a + b + 2 <= cuts) {
                            add(at(a + 1, b), at(a + 1, b + 1), at(a, b + 1));
                        }
                    }
                }
            }
        }
    }

    VariedCase made{one, scale, {}};
    const double height_m =
        1.1 * scale * rangeOf_m(extentOf(one)); // viewers stand above the ground
    const Vec3 turned_m{0, 0, standingAltitude_m + height_m};
    made.body.entities.clear();
    for (const auto& [key, mesh] : bodies) {
        Entity entity = one.entities[key.first];
        entity.model = modelOf(mesh);
        entity.pose = {turned_m, {}};
        made.body.entities.push_back(std::move(entity));
    }
    const auto turnedTo = [&](double azimuth_rad, double elevation_rad) {
        const Vec3 towards = rotation * direction(azimuth_rad, elevation_rad);
        return std::pair(std::atan2(towards.x, towards.y),
                         std::asin(std::clamp(towards.z, -1.0, 1.0)));
    };
    const auto [azimuth_rad, elevation_rad] =
        turnedTo(radians(one.azimuth_deg), radians(one.elevation_deg));
    made.body.azimuth_deg = degrees(azimuth_rad);
    made.body.elevation_deg = degrees(elevation_rad);
    std::tie(made.body.sun.azimuth_rad, made.body.sun.elevation_rad) =
        turnedTo(one.sun.azimuth_rad, one.sun.elevation_rad);
    if (one.place_m) {
        made.body.place_m = turned_m + there(*one.place_m);
    } else if (one.closedForm) {
        made.body.closedForm = *one.closedForm * scale * scale;
    }
    char text[96];
    std::snprintf(text, sizeof text, "scaled by %.3g, cut in %d, %zu entities", scale, cuts * cuts,
                  made.body.entities.size());
    made.how = text;
    return made;
}

} // namespace irsg::test
