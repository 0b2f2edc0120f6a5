#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "irsg/scene/InteractiveRenderer.h"

namespace irsg::reference {

/// One triangle with its vertex normals, for building graphs and for the ray caster alike.
struct Triangle {
    Vec3 vertex[3];
    Vec3 normal[3];
    IrCodes codes;
    bool cullsBackFaces = false;
};
using Triangles = std::vector<Triangle>;

/// Latitude-longitude sphere about the origin, outward, with exact or with facet normals.
Triangles sphereMesh(double radius_m, int latitudes, int longitudes, IrCodes codes,
                     bool smooth = true);
/// A rectangle centre +- u +- v; the front side is the one that u x v points out of.
Triangles plateMesh(const Vec3& centre, const Vec3& u, const Vec3& v, IrCodes codes);
/// The same, seen from its front alone.
Triangles oneSidedPlate(const Vec3& centre, const Vec3& u, const Vec3& v, IrCodes codes);
/// Six outward faces; `codes` of +x, -x, +y, -y, +z, -z.
Triangles boxMesh(const Vec3& half, const std::vector<IrCodes>& codes);
Triangles joined(const Triangles& a, const Triangles& b);
/// A sphere (codes 1, 1) and a plate (2, 2) inside a box (3, 3): three layers one before the other
/// where the box lets light through.
Triangles glazedMesh();

/// Solid angle of a triangle seen from a point (Van Oosterom and Strackee 1983), positive when its
/// front is seen.
double solidAngle_sr(const Triangle& triangle, const Vec3& from);
/// Solid angle of a closed convex mesh: the sum over the triangles whose front is seen.
double convexSolidAngle_sr(const Triangles& mesh, const Vec3& from);

std::shared_ptr<const Model> modelOf(const Triangles& mesh, const std::string& name = "mesh");

/// A database with one grey material (index 1) and one temperature (index 1).
SignatureDatabase greyDatabase(double emissivity, double temperature_K, double nAngleFactor = 0.0,
                               double transmissivity = 0.0);
TemperatureEntry fixedTemperature(double temperature_K);
Material greyMaterial(double emissivity, double transmissivity = 0.0, double nAngleFactor = 0.0);
Entity entityOf(std::shared_ptr<const Model> model, SignatureDatabase database);

/// An atmosphere whose every quantity is a constant given by the test.
class ConstantAtmosphere : public Atmosphere {
  public:
    double transmittanceValue = 1.0;
    double pathRadianceValue = 0.0;
    double backgroundValue = 0.0;
    double sunValue = 0.0;
    double upValue = 0.0;
    double downValue = 0.0;
    double ambientValue_K = 288.15;

    std::string name() const override { return "constant air"; }
    SpectralRange base() const override { return {0.2, 40.0}; }
    bool supports(AtmosphereProperty) const override { return true; }
    double ambientTemperature_K(double) const override { return ambientValue_K; }

  protected:
    Spectrum nativeSpectrum(const AtmosphericQuery& query, const SpectralRange&) const override;
};
Environment environmentOf(const ConstantAtmosphere& air, const SunPosition& sun = {});
/// Air and sun of which every term is seen.
Environment brightAtmosphere();

/// A generator that looks at entity 0, standing at 1000 m altitude, from azimuth and elevation.
struct View {
    double range_m = 100.0;
    double azimuth_rad = 0.0;
    double elevation_rad = 0.0;
    int width_px = 64, height_px = 64;
    double fieldOfView_rad = 0.04;
    Band band = Band::topHat(3.0, 5.0);
};
inline constexpr double standingAltitude_m = 1000.0;
void look(InteractiveRenderer& irsg, const View& view);

/// In the default band.
Sensor sensorOf(int width_px, int height_px, double fieldOfView_deg);

} // namespace irsg::reference
