// Whole objects: what becomes of their samples.
#include <cmath>
#include <numeric>
#include <vector>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/reference/RayCaster.h"
#include "smatcore/selftest/CheckParts.h"
#include "smatcore/selftest/Checks.h"

namespace smat::selftest {
namespace {

using namespace irsg::reference;
using irsg::InteractiveRenderer;
using irsg::Vec3;

Triangles ball() {
    return sphereMesh(1.0, 32, 64, one);
}

/// A grey ball in the dark, to be looked at.
InteractiveRenderer& withBall(SelfTestBench& bench) {
    InteractiveRenderer& irsg = bench.irsg();
    irsg.scene.entities = {entityOf(modelOf(ball()), greyDatabase(0.9, 320.0))};
    look(irsg, {});
    return irsg;
}

/// By the solid angle of its facets.
double intensityOfBall_W_sr(double range_m) {
    return grey_W_m2_sr() * convexSolidAngle_sr(ball(), {0, range_m, 0}) * range_m * range_m;
}

double sumOf(const irsg::RadianceImage& image) {
    const auto& values = image.primary().values;
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Pixels of three layers, one before the other, against rays in double.
SelfTestValue againstRays(SelfTestBench& bench) {
    const Triangles mesh = glazedMesh();
    irsg::SignatureDatabase database;
    RayScene rays;
    rays.surfaces.resize(1);
    struct Surface {
        double emissivity, transmissivity, temperature_K, n;
    };
    int code = 0;
    const double bandwidth_um = band.area_um(), t = 0.7, pi = irsg::pi;
    for (const Surface& s :
         {Surface{0.9, 0.0, 320.0, 0.0}, {0.5, 0.0, 400.0, 1.0}, {0.2, 0.7, 330.0, 0.0}}) {
        ++code;
        database.temperatures[code] = fixedTemperature(s.temperature_K);
        database.materials[code] = greyMaterial(s.emissivity, s.transmissivity, s.n);
        const double rho = 1.0 - s.emissivity - s.transmissivity;
        SurfaceTerms terms;
        terms.thermal = s.emissivity * t * irsg::bandRadiance_W_m2_sr(band, s.temperature_K);
        terms.sun = rho / pi * 3.0 * t * bandwidth_um;
        terms.up = rho / pi * 2.0 * t * bandwidth_um;
        terms.down = rho / pi * 1.0 * t * bandwidth_um;
        terms.path = (1.0 - s.transmissivity) * 0.2 * bandwidth_um;
        terms.transmissivity = s.transmissivity;
        terms.nAngleFactor = s.n;
        rays.surfaces.push_back(terms);
    }
    InteractiveRenderer& irsg = bench.irsg();
    irsg.scene.environment = brightAtmosphere();
    irsg::RenderSettings settings = irsg::RenderSettings::direct();
    settings.tileSide_samples = 0;
    settings.samplesPerAxis = 1;
    irsg.scene.settings = settings;
    irsg.scene.entities = {entityOf(modelOf(mesh), database)};
    look(irsg, {.azimuth_rad = 0.7,
                .elevation_rad = 0.4,
                .width_px = 96,
                .height_px = 80,
                .fieldOfView_rad = 0.06});
    rays.mesh = mesh;
    for (Triangle& triangle : rays.mesh)
        for (Vec3& vertex : triangle.vertex)
            vertex.z += standingAltitude_m;
    const auto& sun = irsg.scene.environment.sun;
    rays.sunDirection = {std::sin(sun.azimuth_rad) * std::cos(sun.elevation_rad),
                         std::cos(sun.azimuth_rad) * std::cos(sun.elevation_rad),
                         std::sin(sun.elevation_rad)};
    rays.background = 0.4 * bandwidth_um;
    const irsg::RadianceImage image = irsg.picture();
    const auto pixels = castRays(rays, irsg.view.sensor, irsg.view.viewpoint);
    Farthest farthest;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (pixels[i].isInterior)
            farthest.add(static_cast<double>(image.primary().values[i]), pixels[i].radiance);
    return farthest.found();
}

/// A body of the background's radiance, whichever that is.
SelfTestValue unseen(SelfTestBench& bench) {
    InteractiveRenderer& irsg = withBall(bench);
    irsg::RenderSettings settings = irsg::RenderSettings::direct();
    settings.background = irsg::BackgroundMode::constant;
    settings.background_W_m2_sr = grey_W_m2_sr();
    irsg.scene.settings = settings;
    const auto report = irsg.measure();
    return {report.all.contrastIntensity_W_sr / report.all.intensity_W_sr, 0.0};
}

/// Of the hot part the picture takes samples that weigh otherwise than their neighbours.
SelfTestValue hotSpotInPicture(SelfTestBench& bench) {
    constexpr irsg::IrCodes hot{2, 1};
    const double side_m = 0.11;
    InteractiveRenderer& irsg = bench.irsg();
    irsg::SignatureDatabase database = greyDatabase(0.9, 320.0);
    database.temperatures[2] = fixedTemperature(1200.0);
    irsg.scene.entities = {
        entityOf(modelOf(joined(ball(), oneSidedPlate({1.63, 0.0, 0.21}, {-0.5 * side_m, 0.0, 0.0},
                                                      {0.0, 0.0, 0.5 * side_m}, hot))),
                 database)};
    look(irsg, {});
    const double pixel_rad = 2.0 * std::tan(0.02) / 64.0;
    return {sumOf(irsg.picture()) * pixel_rad * pixel_rad * 1e4,
            intensityOfBall_W_sr(100.0) +
                0.9 * irsg::bandRadiance_W_m2_sr(band, 1200.0) * side_m * side_m};
}

/// Small plates have finer windows, cut out of the one around them along its cells: samples at the
/// border count with what of their own cells lies inside.
SelfTestValue evenPicture(SelfTestBench& bench) {
    InteractiveRenderer& irsg = bench.irsg();
    const irsg::SignatureDatabase black = greyDatabase(1.0, 320.0);
    std::vector<irsg::Entity> entities{
        entityOf(modelOf(plateMesh({0, 0, 0}, {-3, 0, 0}, {0, 0, 3}, one)), black)};
    constexpr double places_m[][2] = {{0.31, 0.47}, {-0.83, 0.12}, {1.17, -0.71}, {-0.4, -1.3}};
    for (const auto& place : places_m)
        entities.push_back(entityOf(
            modelOf(plateMesh({place[0], 0.5, place[1]}, {-0.083, 0, 0}, {0, 0, 0.061}, one)),
            black));
    irsg.scene.entities = entities;
    look(irsg, {});
    Farthest farthest;
    const irsg::RadianceImage image = irsg.picture();
    for (const float value : image.primary().values)
        farthest.add(static_cast<double>(value), grey_W_m2_sr() / 0.9);
    return farthest.found();
}

SelfTestValue twoBands(SelfTestBench& bench) {
    InteractiveRenderer& irsg = withBall(bench);
    const std::vector<irsg::Band> bands{irsg::Band::topHat(3.4, 4.1),
                                        irsg::Band::topHat(8.0, 12.0)};
    const auto together = irsg.measure(bands);
    Farthest farthest;
    for (std::size_t i = 0; i < bands.size(); ++i)
        farthest.add(together[i].all.intensity_W_sr / irsg::bandRadiance_W_m2_sr(bands[i], 320.0),
                     intensityOfBall_W_sr(100.0) / irsg::bandRadiance_W_m2_sr(band, 320.0));
    return farthest.found();
}

SelfTestValue ballIntensity(SelfTestBench& bench) {
    return {withBall(bench).measure().all.intensity_W_sr, intensityOfBall_W_sr(100.0)};
}

SelfTestValue plateCosine(SelfTestBench& bench) {
    InteractiveRenderer& irsg = bench.irsg();
    irsg.scene.entities = {entityOf(modelOf(plateMesh({0, 0, 0}, {-1, 0, 0}, {0, 0, 1}, one)),
                                    greyDatabase(0.9, 320.0))};
    Farthest farthest;
    for (const double angle_deg : {0.0, 33.0, 61.0, 80.0}) {
        look(irsg,
             {.range_m = 5000.0, .azimuth_rad = irsg::radians(angle_deg), .fieldOfView_rad = 1e-3});
        farthest.add(irsg.measure().all.intensity_W_sr,
                     4.0 * std::cos(irsg::radians(angle_deg)) * grey_W_m2_sr());
    }
    return farthest.found();
}

SelfTestValue irradiance(SelfTestBench& bench) {
    const auto report = withBall(bench).measure();
    return {report.all.irradiance_W_m2, report.all.contrastIntensity_W_sr / 1e4};
}

SelfTestValue pictureAndReport(SelfTestBench& bench) {
    InteractiveRenderer& irsg = withBall(bench);
    const auto rendered = irsg.imageWithReport();
    const double pixel_rad = 2.0 * std::tan(0.02) / 64.0;
    return {sumOf(rendered.image) * pixel_rad * pixel_rad * 1e4,
            rendered.report.all.intensity_W_sr};
}

SelfTestValue wideField(SelfTestBench& bench) {
    InteractiveRenderer& irsg = withBall(bench);
    look(irsg, {.width_px = 400, .height_px = 400, .fieldOfView_rad = 1.4});
    const double aside_m = 100.0 * std::tan(irsg::radians(35.0));
    irsg.scene.entities[0].pose = {{aside_m, 0.0, standingAltitude_m}, {}};
    const double range_m = std::hypot(100.0, aside_m);
    return {irsg.measure().all.intensity_W_sr,
            grey_W_m2_sr() * convexSolidAngle_sr(ball(), {-aside_m, 100.0, 0.0}) * range_m *
                range_m};
}

SelfTestValue hidden(SelfTestBench& bench) {
    InteractiveRenderer& irsg = bench.irsg();
    const Triangles front = plateMesh({0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, one);
    const auto measured = [&](const Triangles& mesh) {
        irsg.scene.entities = {entityOf(modelOf(mesh), greyDatabase(0.9, 320.0))};
        look(irsg, {});
        return irsg.measure().all.intensity_W_sr;
    };
    const double alone = measured(front);
    return {measured(joined(front, plateMesh({0, -1, 0}, {-0.5, 0, 0}, {0, 0, 0.5}, one))), alone};
}

SelfTestValue spectrumAndBand(SelfTestBench& bench) {
    InteractiveRenderer& irsg = withBall(bench);
    std::vector<double> wavenumbers_per_cm;
    for (int i = 0; i < 10; ++i)
        wavenumbers_per_cm.push_back(2000.0 + 130.0 * i);
    const auto spectrum = irsg.measureSpectrum(wavenumbers_per_cm);
    const double area = intensityOfBall_W_sr(100.0) / grey_W_m2_sr();
    Farthest farthest;
    for (std::size_t i = 0; i < wavenumbers_per_cm.size(); ++i)
        farthest.add(spectrum.intensity_W_sr_um[i],
                     area * 0.9 *
                         irsg::planckRadiance_W_m2_sr_um(1e4 / wavenumbers_per_cm[i], 320.0));
    return farthest.found();
}

SelfTestValue scales(SelfTestBench& bench) {
    InteractiveRenderer& irsg = withBall(bench);
    auto scaled = irsg.scene.entities;
    scaled[0].temperatureScale[1] = 1.1;
    irsg.scene.entities = scaled;
    const double found = irsg.measure().all.intensity_W_sr;
    auto warmer = withBall(bench).scene.entities;
    warmer[0].database = std::make_shared<const irsg::SignatureDatabase>(greyDatabase(0.9, 352.0));
    irsg.scene.entities = warmer;
    return {found, irsg.measure().all.intensity_W_sr};
}

SelfTestValue farFromTheOrigin(SelfTestBench& bench) {
    InteractiveRenderer& irsg = withBall(bench);
    const double here = irsg.measure().all.intensity_W_sr;
    irsg.scene.entities[0].pose = {{6.4e6, -6.4e6, standingAltitude_m}, {}};
    look(irsg, {});
    return {irsg.measure().all.intensity_W_sr, here};
}

SelfTestValue tenThousandKilometres(SelfTestBench& bench) {
    InteractiveRenderer& irsg = withBall(bench);
    look(irsg, {.range_m = 1e7, .fieldOfView_rad = 2.4e-7});
    return {irsg.measure().all.intensity_W_sr,
            grey_W_m2_sr() * convexSolidAngle_sr(ball(), {0, 1e4, 0}) * 1e8};
}

SelfTestValue fromInside(SelfTestBench& bench) {
    Farthest farthest;
    for (const double range_m : {0.5, 1e-9}) {
        InteractiveRenderer& irsg = withBall(bench);
        look(irsg, {.range_m = range_m, .fieldOfView_rad = 1.0});
        farthest.add(static_cast<double>(irsg.picture().at(32, 32)), grey_W_m2_sr());
    }
    return farthest.found();
}

SelfTestValue shapesOfPictures(SelfTestBench& bench) {
    InteractiveRenderer& irsg = withBall(bench);
    Farthest farthest;
    constexpr int sizes[][2] = {{1, 1}, {1, 37}, {37, 1}, {53, 47}, {640, 3}};
    for (const auto& size : sizes) {
        look(irsg, {.width_px = size[0],
                    .height_px = size[1],
                    .fieldOfView_rad = size[0] == 1 ? 1e-3 : 0.018});
        farthest.add(static_cast<double>(irsg.picture().at(size[0] / 2, size[1] / 2)),
                     grey_W_m2_sr());
    }
    return farthest.found();
}

SelfTestValue degenerateFacets(SelfTestBench& bench) {
    InteractiveRenderer& irsg = withBall(bench);
    const double before = irsg.measure().all.intensity_W_sr;
    Triangles mesh = ball();
    mesh.push_back(
        {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, one, false});
    mesh.push_back({{{0, 0, 0}, {0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}},
                    {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
                    one,
                    false});
    irsg.scene.entities = {entityOf(modelOf(mesh), greyDatabase(0.9, 320.0))};
    look(irsg, {});
    return {irsg.measure().all.intensity_W_sr, before};
}

SelfTestValue layersLeftOver(SelfTestBench& bench) {
    Triangles mesh;
    for (int i = 0; i < 6; ++i)
        mesh = joined(mesh, plateMesh({0, i * 0.1, 0}, {1, 0, 0}, {0, 0, 1}, one));
    InteractiveRenderer& irsg = bench.irsg();
    irsg::RenderSettings settings = irsg::RenderSettings::direct();
    settings.tileSide_samples = 0;
    settings.samplesPerAxis = 1;
    settings.maximumLayers = 3;
    irsg.scene.settings = settings;
    irsg.scene.entities = {entityOf(modelOf(mesh), greyDatabase(0.3, 320.0, 0.0, 0.7))};
    look(irsg, {.range_m = 50.0, .fieldOfView_rad = 0.01});
    return {static_cast<double>(irsg.imageWithReport().report.layersLeftOver), 64.0 * 64.0};
}

} // namespace

std::vector<SelfTestCheck> sceneChecks() {
    return withHard(
        {
            {"scene.ball-intensity",
             "Radiant intensity of a grey ball against the solid angle of its facets", "W sr-1",
             1e-3, relative, ballIntensity},
            {"scene.plate-cosine",
             "Intensity of a plate of 4 m2, seen at 0 to 80 degrees: area times cosine", "W sr-1",
             2e-3, relative, plateCosine},
            {"scene.irradiance",
             "Irradiance of the ball at the sensor: contrast intensity over the range squared",
             "W m-2", 1e-4, relative, irradiance},
            {"scene.picture-and-report",
             "Sum over a picture, by solid angles of pixels and range squared, against the "
             "intensity of the report",
             "W sr-1", 1e-3, relative, pictureAndReport},
            {"scene.hot-part",
             "Sum over a picture of the ball with a small hot plate beside it, against its facets "
             "and the plate's area",
             "W sr-1", 3e-3, relative, hotSpotInPicture},
            {"scene.even-picture",
             "A picture of black plates of one temperature, small ones before a large one that "
             "fills it: the farthest pixel from that black body",
             "W m-2 sr-1", 1e-5, relative, evenPicture},
            {"scene.wide-field",
             "The ball 35 degrees off the axis of a wide field, against its solid angle", "W sr-1",
             2e-3, relative, wideField},
            {"scene.hidden", "A plate behind a larger one adds nothing", "W sr-1", 1e-9, relative,
             hidden},
            {"scene.unseen",
             "Contrast of a body of its background's radiance, as a part of its intensity", "",
             1e-6, absolute, unseen},
            {"scene.against-rays",
             "A picture of a glazed body, every term switched on, against a ray caster in double: "
             "the farthest pixel whose neighbours hit the same facets",
             "W m-2 sr-1", 1e-5, relative, againstRays},
            {"scene.two-bands",
             "Two bands from one drawing, over their black bodies, against a band by itself", "m2",
             1e-3, relative, twoBands},
            {"scene.spectrum-and-band",
             "A spectrum of intensity at 10 wavenumbers against Planck's law", "W sr-1 um-1", 1e-3,
             relative, spectrumAndBand},
            {"scene.scales",
             "A temperature scaled by 1.1 as a draw of Monte Carlo against the same model with 352 "
             "K",
             "W sr-1", 1e-6, relative, scales},
        },
        {
            {"scene.far-from-the-origin",
             "The ball 9,000 km from the world's origin against itself at the origin", "W sr-1",
             1e-5, relative, farFromTheOrigin},
            {"scene.ten-thousand-kilometres", "The ball from 1e7 m, 2.4 balls to the frame",
             "W sr-1", 2e-3, relative, tenThousandKilometres},
            {"scene.from-inside",
             "From inside the ball, and from its very centre: its radiance all around",
             "W m-2 sr-1", 1e-5, relative, fromInside},
            {"scene.shapes-of-pictures",
             "Pictures of 1 x 1, 1 x 37, 37 x 1, 53 x 47 and 640 x 3 pixels: their middle",
             "W m-2 sr-1", 1e-5, relative, shapesOfPictures},
            {"scene.degenerate-facets", "Facets without area, without normals: the ball as it was",
             "W sr-1", 1e-6, relative, degenerateFacets},
            {"scene.layers-left-over",
             "Six panes where three layers are kept: every sample is counted", "samples", 0.0,
             absolute, layersLeftOver},
        });
}

} // namespace smat::selftest
