#include "irsg/reference/Scenes.h"

#include <cmath>
#include <map>

#include <osg/CullFace>
#include <osg/Geode>
#include <osg/Geometry>
#include <osgSim/ShapeAttribute>

#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/LoadedGraph.h"
#include "irsg/geometry/reading/ModelCodes.h"
#include "irsg/radiometry/Units.h"

namespace irsg::reference {

Triangles sphereMesh(double radius_m, int latitudes, int longitudes, IrCodes codes, bool smooth) {
    auto point = [&](int i, int j) {
        const double theta = pi * i / latitudes, phi = 2.0 * pi * (j % longitudes) / longitudes;
        const double s = i == 0 || i == latitudes ? 0.0 : std::sin(theta);
        return Vec3{s * std::cos(phi), s * std::sin(phi), std::cos(theta)};
    };
    Triangles mesh;
    auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 facet = normalized(cross(b - a, c - a));
        Triangle t{{a * radius_m, b * radius_m, c * radius_m}, {a, b, c}, codes, false};
        if (!smooth)
            t.normal[0] = t.normal[1] = t.normal[2] = facet;
        mesh.push_back(t);
    };
    for (int i = 0; i < latitudes; ++i) {
        for (int j = 0; j < longitudes; ++j) {
            const Vec3 a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1),
                       d = point(i, j + 1);
            if (i + 1 < latitudes)
                add(a, b, c);
            if (i > 0)
                add(a, c, d);
        }
    }
    return mesh;
}

Triangles plateMesh(const Vec3& centre, const Vec3& u, const Vec3& v, IrCodes codes) {
    const Vec3 n = normalized(cross(u, v));
    const Vec3 a = centre - u - v, b = centre + u - v, c = centre + u + v, d = centre - u + v;
    return {{{a, b, c}, {n, n, n}, codes, false}, {{a, c, d}, {n, n, n}, codes, false}};
}

Triangles oneSidedPlate(const Vec3& centre, const Vec3& u, const Vec3& v, IrCodes codes) {
    Triangles mesh = plateMesh(centre, u, v, codes);
    for (Triangle& triangle : mesh)
        triangle.cullsBackFaces = true;
    return mesh;
}

Triangles boxMesh(const Vec3& half, const std::vector<IrCodes>& codes) {
    const Vec3 x{half.x, 0, 0}, y{0, half.y, 0}, z{0, 0, half.z};
    const Vec3 o{0, 0, 0};
    Triangles mesh = plateMesh(x, y, z, codes.at(0));
    for (const Triangles& side :
         {plateMesh(o - x, z, y, codes.at(1)), plateMesh(y, z, x, codes.at(2)),
          plateMesh(o - y, x, z, codes.at(3)), plateMesh(z, x, y, codes.at(4)),
          plateMesh(o - z, y, x, codes.at(5))}) {
        mesh.insert(mesh.end(), side.begin(), side.end());
    }
    return mesh;
}

Triangles joined(const Triangles& a, const Triangles& b) {
    Triangles mesh = a;
    mesh.insert(mesh.end(), b.begin(), b.end());
    return mesh;
}

Triangles glazedMesh() {
    return joined(joined(sphereMesh(0.8, 24, 48, {1, 1}),
                         plateMesh({0, 1.2, 0}, {0.3, 0, 0}, {0, 0, 0.3}, {2, 2})),
                  boxMesh({1.5, 1.5, 1.5}, std::vector<IrCodes>(6, IrCodes{3, 3})));
}

double solidAngle_sr(const Triangle& triangle, const Vec3& from) {
    const Vec3 a = triangle.vertex[0] - from, b = triangle.vertex[1] - from,
               c = triangle.vertex[2] - from;
    const double la = length(a), lb = length(b), lc = length(c);
    const double numerator = dot(a, cross(b, c));
    const double denominator = la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la;
    return -2.0 * std::atan2(numerator, denominator);
}

double convexSolidAngle_sr(const Triangles& mesh, const Vec3& from) {
    double sum = 0.0;
    for (const Triangle& triangle : mesh)
        sum += std::max(0.0, solidAngle_sr(triangle, from));
    return sum;
}

namespace {

/// A scene graph with ShapeAttributeLists, one geometry for each pair of codes.
osg::ref_ptr<osg::Geode> graphOf(const Triangles& mesh) {
    std::map<std::pair<IrCodes, bool>, Triangles> parts;
    for (const Triangle& triangle : mesh)
        parts[{triangle.codes, triangle.cullsBackFaces}].push_back(triangle);

    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    for (const auto& [key, triangles] : parts) {
        osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
        osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
        osg::ref_ptr<osg::Vec3Array> normals = new osg::Vec3Array;
        for (const Triangle& t : triangles) {
            for (int i = 0; i < 3; ++i) {
                vertices->push_back(osg::Vec3d(t.vertex[i].x, t.vertex[i].y, t.vertex[i].z));
                normals->push_back(osg::Vec3d(t.normal[i].x, t.normal[i].y, t.normal[i].z));
            }
        }
        geometry->setVertexArray(vertices);
        geometry->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
        geometry->addPrimitiveSet(
            new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices->size())));
        osg::ref_ptr<osgSim::ShapeAttributeList> codes = new osgSim::ShapeAttributeList;
        codes->push_back(osgSim::ShapeAttribute("IRColor", key.first.temperature));
        codes->push_back(osgSim::ShapeAttribute("IRMaterial", key.first.material));
        geometry->setUserData(codes);
        if (key.second) {
            geometry->getOrCreateStateSet()->setAttributeAndModes(
                new osg::CullFace(osg::CullFace::BACK));
        }
        geode->addDrawable(geometry);
    }
    return geode;
}

} // namespace

std::shared_ptr<const Model> modelOf(const Triangles& mesh, const std::string& name) {
    LoadedGraph graph;
    graph.node = graphOf(mesh);
    return Model::ofGraph(graph, {}, name);
}

TemperatureEntry fixedTemperature(double temperature_K) {
    TemperatureEntry entry;
    entry.name = "fixed";
    entry.terms.base_K = temperature_K;
    entry.terms.ambientFactor = 0.0;
    return entry;
}

Material greyMaterial(double emissivity, double transmissivity, double nAngleFactor) {
    Material material;
    material.name = "grey";
    material.emissivity = Spectrum::constant(emissivity);
    material.transmissivity = Spectrum::constant(transmissivity);
    material.nAngleFactor = nAngleFactor;
    return material;
}

SignatureDatabase greyDatabase(double emissivity, double temperature_K, double nAngleFactor,
                               double transmissivity) {
    SignatureDatabase database;
    database.temperatures[1] = fixedTemperature(temperature_K);
    database.materials[1] = greyMaterial(emissivity, transmissivity, nAngleFactor);
    return database;
}

Entity entityOf(std::shared_ptr<const Model> model, SignatureDatabase database) {
    Entity entity;
    entity.name = model->name();
    entity.model = std::move(model);
    entity.database = std::make_shared<const SignatureDatabase>(std::move(database));
    entity.pose.position_m = {0, 0, standingAltitude_m};
    entity.referencePoint_m = Vec3{0, 0, 0};
    return entity;
}

Spectrum ConstantAtmosphere::nativeSpectrum(const AtmosphericQuery& query,
                                            const SpectralRange&) const {
    switch (query.quantity) {
    case AtmosphereProperty::transmittance:
        return Spectrum::constant(transmittanceValue);
    case AtmosphereProperty::pathRadiance:
        return Spectrum::constant(pathRadianceValue);
    case AtmosphereProperty::backgroundRadiance:
        return Spectrum::constant(backgroundValue);
    case AtmosphereProperty::solarIrradiance:
        return Spectrum::constant(sunValue);
    case AtmosphereProperty::upwardFlux:
        return Spectrum::constant(upValue);
    case AtmosphereProperty::downwardFlux:
        return Spectrum::constant(downValue);
    default:
        throw LogicError("constant air has no " + std::string(irsg::name(query.quantity)));
    }
}

Environment environmentOf(const ConstantAtmosphere& air, const SunPosition& sun) {
    Environment environment;
    environment.add(std::make_shared<ConstantAtmosphere>(air));
    environment.sun = sun;
    return environment;
}

Environment brightAtmosphere() {
    ConstantAtmosphere air;
    air.transmittanceValue = 0.7;
    air.pathRadianceValue = 0.2;
    air.backgroundValue = 0.4;
    air.sunValue = 3.0;
    air.upValue = 2.0;
    air.downValue = 1.0;
    return environmentOf(air, {.azimuth_rad = 0.4, .elevation_rad = 0.6});
}

void look(InteractiveRenderer& irsg, const View& view) {
    Sensor sensor;
    sensor.width_px = view.width_px;
    sensor.height_px = view.height_px;
    sensor.horizontalFieldOfView_rad = view.fieldOfView_rad;
    sensor.band = view.band;
    irsg.view.sensor = sensor;
    irsg.view.viewpoint =
        Viewpoint::about(irsg.referencePoint(0), irsg.scene.entities.front().pose.attitude.yaw_rad,
                         view.azimuth_rad, view.elevation_rad, view.range_m);
}

Sensor sensorOf(int width_px, int height_px, double fieldOfView_deg) {
    Sensor sensor;
    sensor.width_px = width_px;
    sensor.height_px = height_px;
    sensor.horizontalFieldOfView_rad = radians(fieldOfView_deg);
    return sensor;
}

} // namespace irsg::reference
