#include "tests/support/RandomScenes.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <random>

#include "irsg/atmosphere/AtmosphereIdentity.h"
#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/SignatureFile.h"
#include "tests/support/WidebandScenes.h"

namespace irsg::test {

namespace {

/// Numbers that are the same everywhere, which those of distributions of the library are not.
class Draw {
  public:
    explicit Draw(unsigned seed) : engine_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
    }
    int below(int count) { return static_cast<int>(between(0.0, count)); }
    double logarithmic(double low, double high) {
        return std::exp(between(std::log(low), std::log(high)));
    }
    Vec3 direction() {
        const double z = between(-1.0, 1.0), turn = between(0.0, 2.0 * pi);
        const double r = std::sqrt(1.0 - z * z);
        return {r * std::cos(turn), r * std::sin(turn), z};
    }

  private:
    std::mt19937 engine_;
};

/// With plumes as shells, which every mode of calculation takes.
Entity sample(const std::string& name) {
    auto folder = std::filesystem::path(SMAT_SOURCE_DIR) / "tests/data/shells" / name;
    if (!std::filesystem::exists(folder)) {
        folder = std::filesystem::path(SMAT_SOURCE_DIR) / "samples" / name;
    }
    static std::map<std::string, Entity> known;
    const auto found = known.find(name);
    if (found != known.end()) {
        return found->second;
    }
    return known[name] = entityOf(Model::load(folder / (name + ".flt")),
                                  loadSignatureFile(folder / (name + ".sigdb")).database);
}

Triangles moved(Triangles mesh, const Vec3& by, const Rotation& turn) {
    for (Triangle& triangle : mesh) {
        for (int i = 0; i < 3; ++i) {
            triangle.vertex[i] = turn * triangle.vertex[i] + by;
            triangle.normal[i] = turn * triangle.normal[i];
        }
    }
    return mesh;
}

/// Some bodies that overlap or do not, each of its own temperature.
Entity bodies(Draw& draw, const Band& band) {
    SignatureDatabase database = painted(band, draw.between(270.0, 330.0));
    Triangles mesh;
    const int count = 1 + draw.below(5);
    for (int i = 0; i < count; ++i) {
        const IrCodes codes{10 + i, 1 + draw.below(2)};
        database.temperatures[10 + i] = fixedTemperature(
            draw.below(4) == 0 ? draw.between(400.0, 900.0) : draw.between(260.0, 340.0));
        const Rotation turn =
            Attitude{draw.between(0.0, 6.0), draw.between(-1.0, 1.0), draw.between(-1.0, 1.0)}
                .rotation();
        const Vec3 place = draw.direction() * draw.between(0.0, 3.0);
        const double size = draw.logarithmic(0.2, 3.0);
        Triangles body;
        switch (draw.below(4)) {
        case 0:
            body = sphereMesh(size, 24, 48, codes);
            break;
        case 1: // a wire or a plank
            body = boxMesh({size, 0.03 * size, 0.05 * size}, std::vector<IrCodes>(6, codes));
            break;
        case 2:
            body = plateMesh({}, {size, 0.0, 0.0}, {0.3 * size, 0.8 * size, 0.0}, codes);
            break;
        default:
            body = boxMesh({size, draw.between(0.2, 1.0) * size, draw.between(0.1, 1.0) * size},
                           std::vector<IrCodes>(6, codes));
        }
        mesh = joined(mesh, moved(std::move(body), place, turn));
    }
    return entityOf(modelOf(mesh), std::move(database));
}

/// Computed air, and the same in the finest bins.
struct Airs {
    Environment usual, finest;
};

const Airs& atmospheresOf(const WidebandAtmosphere& air) {
    static std::map<std::string, Airs> known;
    const auto found = known.find(air.name);
    if (found != known.end()) {
        return found->second;
    }
    return known[air.name] = {air.environment(5), air.environment(1)};
}

} // namespace

RandomScene randomScene(unsigned number, RandomAtmosphere air) {
    Draw draw(1000 + number);
    RandomScene random;
    const WidebandAtmosphere computed =
        widebandAtmospheres().at(static_cast<std::size_t>(number % 4));
    random.view.sensor.band =
        air == RandomAtmosphere::none
            ? (draw.below(2) == 0 ? Band::topHat(3.0, 5.0) : Band::topHat(8.0, 12.0))
            : computed.band();
    const char* const samples[] = {"turboprop4", "heron", "corvette", "ship"};
    const int kind = draw.below(7);
    Entity entity = kind < 4 ? sample(samples[kind]) : bodies(draw, random.view.sensor.band);
    random.name = kind < 4 ? samples[kind] : "bodies";
    entity.state.power = draw.between(0.2, 1.0);
    entity.state.mach = draw.between(0.0, 0.5);
    entity.pose.position_m.z = 1000.0;
    entity.pose.attitude = {draw.between(0.0, 2.0 * pi), draw.between(-0.3, 0.3),
                            draw.between(-0.5, 0.5)};
    const double extent_m = 2.0 * entity.model->bounds().diagonal_m();

    RenderSettings& settings = random.scene.settings;
    const int mode = draw.below(4);
    double extent_px = draw.logarithmic(0.02, 300.0);
    if (mode == 3) { // in pixels, which a small object does not meet
        settings.tileSide_samples = 0;
        settings.samplesPerAxis = 4;
        extent_px = draw.logarithmic(20.0, 200.0);
    } else {
        settings.tileSide_samples = 128 << mode;
    }
    random.alongRange = mode < 3 && draw.below(4) == 0;
    if (air == RandomAtmosphere::none) {
        ConstantAtmosphere constant;
        constant.upValue = 20.0, constant.downValue = 10.0, constant.sunValue = 5.0;
        random.scene.environment = environmentOf(constant, {1.0, 0.6});
        settings.background = BackgroundMode::constant;
        settings.background_W_m2_sr =
            draw.between(0.3, 1.0) * (random.view.sensor.band.range().min_um > 6.0 ? 30.0 : 1.0);
    } else {
        random.scene.environment = atmospheresOf(computed).usual;
        settings.mode = air == RandomAtmosphere::wideband ? CalculationMode::wideband
                                                          : CalculationMode::spectral;
        if (air == RandomAtmosphere::wideband) { // of the grid, too
            settings.backgroundRows = 16;
        }
    }
    random.scene.entities = {entity};

    InteractiveRenderer places{RenderSettings::direct()};
    places.scene.entities = random.scene.entities;
    const double range_m = extent_m * draw.logarithmic(10.0, 400.0);
    const double lowest = std::max(-0.9, -900.0 / range_m);
    random.view.sensor.width_px = random.view.sensor.height_px = 320;
    random.view.sensor.horizontalFieldOfView_rad = 320.0 * extent_m / range_m / extent_px;
    if (random.view.sensor.horizontalFieldOfView_rad > 1.5) {
        random.view.sensor.horizontalFieldOfView_rad = 1.5;
    }
    random.view.viewpoint =
        Viewpoint::about(places.referencePoint(0), 0.0, draw.between(0.0, 2.0 * pi),
                         std::asin(draw.between(lowest, 0.9)), range_m);
    random.name += ", window " + std::to_string(settings.tileSide_samples) + ", " +
                   std::to_string(extent_px) + " px, " + std::to_string(range_m) + " m" +
                   (random.alongRange ? ", along range" : "");
    return random;
}

std::array<JudgedNumber, 2> judged(Renderer& renderer, const RandomScene& random) {
    const auto measured = [&](const Scene& scene, bool alongRange, bool errors) {
        return renderer
            .render(scene, random.view,
                    Outputs::reports().alongRange(alongRange).withErrors(errors))
            .reports.front()
            .all;
    };
    Scene fine = random.scene;
    fine.settings.tileSide_samples = 2048;
    fine.settings.mode = CalculationMode::spectral;
    fine.settings.atmosphereSliceFrom = 1e-3;
    fine.settings.pointSourceBelow_px = 0.0;
    for (const WidebandAtmosphere& air : widebandAtmospheres()) {
        if (AtmosphereIdentity(fine.environment) == AtmosphereIdentity(atmospheresOf(air).usual)) {
            fine.environment = atmospheresOf(air).finest;
        }
    }
    if (fine.settings.background == BackgroundMode::environment) {
        fine.settings.backgroundRows = 129;
    }
    const ObjectRadiometry own = measured(random.scene, random.alongRange, true);
    const ObjectRadiometry truth = measured(fine, false, false);
    return {JudgedNumber{own.intensity_W_sr, truth.intensity_W_sr, own.errors->intensity_W_sr},
            JudgedNumber{own.contrastIntensity_W_sr, truth.contrastIntensity_W_sr,
                         own.errors->contrastIntensity_W_sr}};
}

} // namespace irsg::test
