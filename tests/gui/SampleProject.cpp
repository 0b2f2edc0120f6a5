#include "tests/gui/SampleProject.h"

#include <QElapsedTimer>
#include <QTest>

#include "smatcore/project/ProjectFile.h"

namespace smat::gui::test {

std::filesystem::path writeSampleProject(const std::filesystem::path& folder) {
    const std::filesystem::path sample = std::filesystem::path(SMAT_SOURCE_DIR) / "samples/ship";
    Project project = projectOfModel(sample / "ship.flt", sample / "ship.sigdb");
    project.title = "Ship in the test basin";
    project.settings.set("sensor.width", 64);
    project.settings.set("sensor.height", 48);
    project.settings.set("sensor.fov", "10");
    project.settings.set("camera.azimuth", "60");
    project.settings.set("camera.elevation", "15");
    project.settings.set("target.altitude", "100");
    project.settings.set("render.antialiasing", 0);
    project.settings.set("render.lightError", "0.02");
    project.settings.set("polar.step", "30");
    project.settings.set("table.azimuthStep", "90");
    project.settings.set("table.elevationStep", "30");
    project.settings.set("range.points", 5);
    project.settings.set("spectrum.resolution", "50");
    project.settings.set("time.step", "5");
    const auto file = folder / "ship.smat";
    saveProject(project, file);
    return file;
}

bool waitUntil(const std::function<bool()>& done, double seconds) {
    QElapsedTimer clock;
    clock.start();
    while (!done() && static_cast<double>(clock.elapsed()) < seconds * 1000.0) {
        QTest::qWait(5);
    }
    return done();
}

} // namespace smat::gui::test
