// Surfaces whose inter-reflection is hard.
#include "tests/support/ExchangeCase.h"

#include <array>
#include <cmath>
#include <utility>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/RevolvedMeshes.h"

namespace irsg::test {

namespace {

constexpr double cold_K = 20.0; // emits nothing in 3-5 um

Entity entityOfTriangles(const Triangles& mesh, SignatureDatabase database) {
    return entityOf(modelOf(mesh), std::move(database));
}

Triangles slab(const Vec3& centre, const Vec3& half, IrCodes codes) {
    return moved(boxMesh(half, std::vector<IrCodes>(6, codes)), centre);
}

/// A box without a bottom on a plate: 600 K inside, cold and black outside. Nothing leaves it.
std::vector<ExchangeCase> coverLeak() {
    const Vec3 half{0.5, 0.4, 0.3};
    const IrCodes inside{2, 2}, outside{1, 2}, plate{1, 1};
    Triangles cover;
    for (Triangle triangle :
         moved(boxMesh(half, std::vector<IrCodes>(6, outside)), {0.1, 0.2, half.z})) {
        if (triangle.vertex[0].z < 1e-9 && triangle.vertex[1].z < 1e-9 &&
            triangle.vertex[2].z < 1e-9) {
            continue;
        }
        triangle.cullsBackFaces = true;
        cover.push_back(triangle);
        std::swap(triangle.vertex[1], triangle.vertex[2]);
        for (Vec3& normal : triangle.normal) {
            normal = normal * -1.0;
        }
        triangle.codes = inside;
        cover.push_back(triangle);
    }
    SignatureDatabase database = greyDatabase(0.1, cold_K);
    database.temperatures[2] = fixedTemperature(600.0);
    database.materials[2] = greyMaterial(1.0);
    const Triangles whole = plateMesh({}, {1.5, 0, 0}, {0, 1.5, 0}, plate);
    // Cut along the walls of the cover.
    Triangles divided;
    const std::array<double, 4> x{-1.5, 0.1 - half.x, 0.1 + half.x, 1.5};
    const std::array<double, 4> y{-1.5, 0.2 - half.y, 0.2 + half.y, 1.5};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            divided =
                joined(divided, plateMesh({0.5 * (x[i] + x[i + 1]), 0.5 * (y[k] + y[k + 1]), 0},
                                          {0.5 * (x[i + 1] - x[i]), 0, 0},
                                          {0, 0.5 * (y[k + 1] - y[k]), 0}, plate));
        }
    }
    return {seenFrom("cover", "plate in one", {entityOfTriangles(joined(whole, cover), database)},
                     30.0, 50.0),
            seenFrom("cover", "plate divided",
                     {entityOfTriangles(joined(divided, cover), database)}, 30.0, 50.0)};
}

ExchangeCase inTheSun(ExchangeCase one, double azimuth_deg, double elevation_deg) {
    one.sun = {.azimuth_rad = radians(azimuth_deg), .elevation_rad = radians(elevation_deg)};
    one.sun_W_m2 = 15.0;
    return one;
}

/// Three slabs that cross, and a ball before them.
std::vector<ExchangeCase> corner() {
    const IrCodes code{1, 1};
    Triangles mesh = slab({0, 0, 0}, {1.2, 1.2, 0.05}, code);
    mesh = joined(mesh, slab({-0.9, 0, 0.9}, {0.05, 1.2, 1.2}, code));
    mesh = joined(mesh, slab({0, -0.9, 0.9}, {1.2, 0.05, 1.2}, code));
    mesh = joined(mesh, moved(sphereMesh(0.35, 32, 64, code, false), {-0.2, -0.2, 0.55}));
    return {inTheSun(seenFrom("corner", "sun, 45°",
                              {entityOfTriangles(mesh, greyDatabase(0.3, cold_K))}, 45.0, 30.0),
                     65.0, 40.0)};
}

/// Two walls that stand on a floor without a joint.
std::vector<ExchangeCase> wallsOnFloor() {
    const IrCodes code{1, 1};
    Triangles mesh = plateMesh({}, {1, 0, 0}, {0, 1, 0}, code);
    mesh = joined(mesh, plateMesh({0.4, 0, 0.4}, {0, 0.7, 0}, {0, 0, 0.4}, code));
    mesh = joined(mesh, plateMesh({-0.4, 0, 0.4}, {0, 0.7, 0}, {0, 0, 0.4}, code));
    std::vector<ExchangeCase> cases;
    for (const double azimuth_deg : {90.0, 270.0}) {
        cases.push_back(inTheSun(
            seenFrom("walls", "sun, " + std::to_string(static_cast<int>(azimuth_deg)) + "°",
                     {entityOfTriangles(mesh, greyDatabase(0.2, cold_K))}, azimuth_deg, 30.0),
            110.0, 50.0));
    }
    return cases;
}

/// A black wall of 600 K at the edge of a cold plate of 2 m, one bounce: radiances along the plate
/// and its intensity seen from behind the wall, whose back is not there.
std::vector<ExchangeCase> edge() {
    constexpr double emissivity = 0.3, height_m = 1.0;
    Triangles mesh = plateMesh({1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1});
    mesh = joined(mesh,
                  oneSidedPlate({0, 0, 0.5 * height_m}, {0, 1, 0}, {0, 0, 0.5 * height_m}, {2, 2}));
    SignatureDatabase database = greyDatabase(emissivity, cold_K);
    database.temperatures[2] = fixedTemperature(600.0);
    database.materials[2] = greyMaterial(1.0);
    const Entity entity = entityOfTriangles(mesh, database);
    const double sent_W_m2_sr = bandRadiance_W_m2_sr(band(), 600.0);
    std::vector<ExchangeCase> cases;
    for (const double x_m : {0.02, 0.05, 0.2, 0.7, 1.3, 1.9}) {
        char text[64];
        std::snprintf(text, sizeof text, "at %.2f m, W m-2 sr-1", x_m);
        ExchangeCase one = seenFrom("edge", text, {entity}, 0.0, 90.0);
        one.bounces = 1;
        one.place_m = entity.pose.toWorld({x_m, 0.0, 0.0});
        // Of an element to a rectangle at a right angle, both halves of its width.
        const double far_m = std::hypot(x_m, height_m);
        const double factor = (std::atan(1.0 / x_m) - x_m / far_m * std::atan(1.0 / far_m)) / pi;
        one.closedForm = (1.0 - emissivity) * sent_W_m2_sr * factor;
        cases.push_back(one);
    }
    ExchangeCase whole = seenFrom("edge", "from behind", {entity}, 270.0, 45.0);
    whole.bounces = 1;
    // C-14 of the catalogue, the plate as long as wide, the wall half as high.
    const double h2 = 0.25 * height_m * height_m, h = std::sqrt(h2), r = std::sqrt(h2 + 1.0);
    const double w2 = 1.0;
    const double sum = std::log((1 + w2) * (1 + h2) / (1 + w2 + h2)) +
                       w2 * std::log(w2 * (1 + w2 + h2) / ((1 + w2) * (w2 + h2))) +
                       h2 * std::log(h2 * (1 + h2 + w2) / ((1 + h2) * (h2 + w2)));
    const double factor =
        (std::atan(1.0) + h * std::atan(1.0 / h) - r * std::atan(1.0 / r) + 0.25 * sum) / pi;
    whole.closedForm = (1.0 - emissivity) * sent_W_m2_sr * factor * 4.0 * std::sin(radians(45.0));
    cases.push_back(whole);
    return cases;
}

/// A tube with a bottom, as long as wide, and a cone, both seen along their axis.
std::vector<ExchangeCase> cavities() {
    const IrCodes code{1, 1};
    const Triangles tube = joined(revolved(line(0, 0, 0.5, 0, 4), 128, code),
                                  revolved(line(0.5, 0, 0.5, 1.0, 8), 128, code));
    const double length_m = 0.5 / std::tan(radians(10.0));
    const Triangles cone = revolved(line(0, 0, 0.5, length_m, 16), 128, code);
    const auto along = [](const char* name, const char* variant, const Triangles& mesh,
                          double emissivity) {
        return seenFrom(name, variant, {entityOfTriangles(mesh, greyDatabase(emissivity, 330.0))},
                        0.0, 90.0);
    };
    return {along("tube", "L/D 1, emissivity 0.3", tube, 0.3),
            along("cone", "of 20°, emissivity 0.3", cone, 0.3),
            along("cone", "of 20°, emissivity 0.7", cone, 0.7)};
}

/// A part of 1 cm2 and 1500 K, 0.5 m before a wall, whose back is not there.
std::vector<ExchangeCase> lip() {
    constexpr double half_m = 0.005;
    Triangles mesh = plateMesh({}, {1, 0, 0}, {0, 0, 1}, {1, 1});
    mesh = joined(mesh, oneSidedPlate({0, -0.5, 0}, {0, 0, half_m}, {half_m, 0, 0}, {2, 2}));
    SignatureDatabase database = greyDatabase(0.5, cold_K);
    database.temperatures[2] = fixedTemperature(1500.0);
    database.materials[2] = greyMaterial(1.0);
    ExchangeCase one =
        seenFrom("lip", "1 cm2, 1500 K", {entityOfTriangles(mesh, database)}, 180.0, 0.0);
    // Four corners, each of an element before the corner of a rectangle.
    const double side = 1.0 / std::sqrt(1.25);
    one.closedForm = 0.5 * bandRadiance_W_m2_sr(band(), 1500.0) * 4.0 * half_m * half_m * 4.0 / pi *
                     side * std::atan(side);
    return {one};
}

std::vector<ExchangeCase> hotBox() {
    Triangles mesh = plateMesh({}, {1.5, 0, 0}, {0, 1.5, 0}, {1, 1});
    mesh = joined(mesh, slab({0.2, 0.1, 0.45}, {0.3, 0.3, 0.15}, {2, 2}));
    SignatureDatabase database = greyDatabase(0.5, 300.0);
    database.temperatures[2] = fixedTemperature(600.0);
    database.materials[2] = greyMaterial(0.9);
    return {seenFrom("box", "600 K over a plate", {entityOfTriangles(mesh, database)}, 30.0, 40.0),
            seenFrom("box", "600 K over a plate, low", {entityOfTriangles(mesh, database)}, 200.0,
                     10.0)};
}

/// A bright ball over a plate in the sun, as one entity and as two: the ball sees nothing of
/// itself.
std::vector<ExchangeCase> ballOverPlate() {
    const Triangles plate = plateMesh({}, {1.5, 0, 0}, {0, 1.5, 0}, {1, 1});
    const Triangles ball = moved(sphereMesh(0.5, 32, 64, {1, 1}, false), {0.2, 0.1, 0.7});
    const SignatureDatabase database = greyDatabase(0.2, cold_K);
    const auto seen = [&](const char* variant, std::vector<Entity> entities) {
        return inTheSun(seenFrom("ball", variant, std::move(entities), 150.0, 35.0), 65.0, 40.0);
    };
    return {seen("sun, one entity", {entityOfTriangles(joined(plate, ball), database)}),
            seen("sun, two entities",
                 {entityOfTriangles(plate, database), entityOfTriangles(ball, database)})};
}

/// A sheet close before a wider one, as propeller discs are drawn, each of two copies of one plate
/// that turn to either side: from before them they are convex, and nothing is reflected.
std::vector<ExchangeCase> sheets() {
    const IrCodes code{1, 1};
    const auto sheet = [&](const Vec3& centre, double half_m) {
        return joined(oneSidedPlate(centre, {half_m, 0, 0}, {0, half_m, 0}, code),
                      oneSidedPlate(centre, {0, half_m, 0}, {half_m, 0, 0}, code));
    };
    constexpr double emissivity = 0.3;
    std::vector<ExchangeCase> cases;
    // The second gap is wider than what distances from the viewer are rounded by, and than would
    // let the sheets count as one plane.
    for (const double gap_m : {5e-5, 1e-3}) {
        char text[64];
        std::snprintf(text, sizeof text, "%g m apart", gap_m);
        cases.push_back(
            seenFrom("sheets", text,
                     {entityOfTriangles(joined(sheet({}, 1.0), sheet({0.2, 0.1, gap_m}, 0.5)),
                                        greyDatabase(emissivity, 330.0))},
                     0.0, 90.0));
        if (gap_m < 1e-4) {
            cases.back().closedForm = emissivity * bandRadiance_W_m2_sr(band(), 330.0) * 4.0;
        }
    }
    return cases;
}

} // namespace

std::vector<NamedCases> hardSurfaces() {
    return {{"cover", coverLeak}, {"corner", corner},      {"walls", wallsOnFloor},
            {"edge", edge},       {"cavities", cavities},  {"lip", lip},
            {"box", hotBox},      {"ball", ballOverPlate}, {"sheets", sheets}};
}

} // namespace irsg::test
