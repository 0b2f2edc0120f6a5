// smat-samples [FOLDER] writes what this project makes of formulas: the models of sphere, box,
// heron, tern, corvette and helicopter, the sea, and the sky and the terrain of the valley into
// FOLDER/samples, the plate of the tests into FOLDER/tests/data/models. FOLDER is the present one.

#include <iostream>

#include "irsg/core/Errors.h"
#include "tools/samples/GasZones.h"
#include "tools/samples/SampleCorvette.h"
#include "tools/samples/SampleHelicopter.h"
#include "tools/samples/SampleHeron.h"
#include "tools/samples/SampleModels.h"
#include "tools/samples/SampleSea.h"
#include "tools/samples/SampleTern.h"
#include "tools/samples/SampleValley.h"

namespace {

constexpr int rings = 128, segments = 256;

void write(const smat::FlightWriter& model, const std::filesystem::path& file) {
    std::cout << "writes " << file.string() << std::endl;
    model.save(file);
}

} // namespace

int main(int argc, char** argv) {
    if (argc > 2 || (argc == 2 && argv[1][0] == '-')) {
        std::cerr << "usage: smat-samples [FOLDER]\n";
        return 2;
    }
    const std::filesystem::path folder = argc == 2 ? argv[1] : ".";
    try {
        write(smat::sphereModel(rings, segments), folder / "samples/sphere/sphere.flt");
        write(smat::boxModel(), folder / "samples/box/box.flt");
        write(smat::heronModel(), folder / "samples/heron/heron.flt");
        write(smat::ternModel(false), folder / "samples/tern/tern.flt");
        write(smat::ternModel(true), folder / "samples/tern/tern-reheat.flt");
        write(smat::corvetteModel(), folder / "samples/corvette/corvette.flt");
        const std::filesystem::path sea = folder / "samples/corvette";
        std::cout << "writes " << (sea / "sea.osgb").string() << std::endl;
        smat::writeSea(sea);
        const std::filesystem::path funnel = sea / "funnel.csv";
        std::cout << "writes " << funnel.string() << std::endl;
        smat::savePlumeTable(smat::corvetteJet(1.0).flow().table, funnel);
        const std::filesystem::path helicopter = folder / "samples/helicopter/helicopter.gltf";
        std::cout << "writes " << helicopter.string() << std::endl;
        std::filesystem::create_directories(helicopter.parent_path());
        smat::helicopterModel().save(helicopter);
        const std::filesystem::path valley = folder / "samples/valley";
        std::cout << "writes " << valley.string() << std::endl;
        smat::writeCloudSkybox(valley / "sky");
        smat::writeValleyTerrain(valley);
        write(smat::plateModel(), folder / "tests/data/models/plate.flt");
    } catch (const irsg::InputError& error) {
        std::cerr << error.what() << "\n";
        return 2;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 3;
    }
    return 0;
}
