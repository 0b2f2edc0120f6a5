// Frame time of the four-engined aircraft at 640 x 512 beside OpenSceneGraph drawing the same model
// into the same float target with a constant shader. Both in one process, in alternation.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <vector>

#include "benchmarks/ConstantShaderRendering.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scene/InteractiveRenderer.h"

using namespace irsg;

namespace {

double milliseconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

double median(std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + static_cast<long>(values.size() / 2));
    return values[values.size() / 2];
}

/// Every index of the model has an entry; `transmissivity` is that of the gas and the propeller
/// discs.
SignatureDatabase plainDatabase(const Model& model, double transmissivity) {
    SignatureDatabase database;
    for (const auto& [codes, use] : model.codes()) {
        database.temperatures[codes.temperature].terms.base_K = 10.0;
        database.materials[codes.material].emissivity = Spectrum::constant(0.8);
    }
    for (const int zone : {5, 6, 7}) {
        Material& gas = database.materials[zone];
        gas.emissivity = Spectrum::constant(1.0 - transmissivity);
        gas.transmissivity = Spectrum::constant(transmissivity);
    }
    return database;
}

} // namespace

int main(int argc, char** argv) {
    const std::string file =
        argc > 1 ? argv[1] : std::string(SMAT_SOURCE_DIR) + "/samples/turboprop4/turboprop4.flt";
    const std::shared_ptr<const Model> model = Model::load(file);
    Sensor sensor;
    sensor.horizontalFieldOfView_rad = radians(2.5);

    std::printf("%-34s %10s %10s %8s\n", "640 x 512, turboprop4", "ours ms", "OSG ms", "ratio");
    for (double transmissivity : {0.0, 0.6})
        for (double range_m : {1000.0, 5000.0}) {
            Entity entity;
            entity.model = model;
            entity.database =
                std::make_shared<const SignatureDatabase>(plainDatabase(*model, transmissivity));
            entity.pose.position_m.z = 1000.0;
            InteractiveRenderer irsg{RenderSettings::direct()};
            RenderSettings settings = RenderSettings::direct();
            settings.tileSide_samples = 0;
            settings.samplesPerAxis = 1;
            irsg.scene.settings = settings;
            irsg.view.sensor = sensor;
            irsg.scene.entities = {entity};
            const Viewpoint viewpoint = Viewpoint::about(irsg.referencePoint(0), 0.0, radians(60.0),
                                                         radians(15.0), range_m);
            irsg.view.viewpoint = viewpoint;

            Viewpoint relative = viewpoint;
            relative.position_m = viewpoint.position_m - entity.pose.position_m;
            bench::ConstantShaderRendering floor(model, sensor, relative);

            std::vector<double> ours, floors, ratios;
            for (int i = 0; i < 60; ++i) {
                const double a = milliseconds([&] { irsg.imageWithReport(); });
                const double b = milliseconds([&] { floor.draw(); });
                if (i < 10)
                    continue;
                ours.push_back(a);
                floors.push_back(b);
                ratios.push_back(a / b);
            }
            char label[64];
            std::snprintf(label, sizeof label, "range %.0f m, %s", range_m,
                          transmissivity > 0.0 ? "plumes peeled" : "all opaque");
            std::printf("%-34s %10.2f %10.2f %8.2f\n", label, median(ours), median(floors),
                        median(ratios));
            irsg.resetStageTimes();
            for (int i = 0; i < 50; ++i)
                irsg.imageWithReport();
            for (const StageTimes::Stage& stage : irsg.stageTimes().stages)
                std::printf("    %-16s %8.3f ms\n", stage.name.c_str(), stage.seconds / 50 * 1e3);
        }
    return 0;
}
