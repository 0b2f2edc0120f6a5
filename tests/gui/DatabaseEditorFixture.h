#pragma once

#include <map>
#include <string>

#include "tests/gui/DatabaseFixture.h"

namespace smat::gui::test {

/// The editor with a copy of the sample aircraft, small.
class DatabaseEditorTest : public DatabaseFixture {
  protected:
    void SetUp() override {
        DatabaseFixture::SetUp();
        if (!IsSkipped()) {
            openCopy("turboprop4", small());
        }
    }
    static std::map<std::string, std::string> small() {
        return {{"sensor.width", "64"},      {"sensor.height", "48"},      {"sensor.fov", "3"},
                {"camera.azimuth", "60"},    {"camera.elevation", "12"},   {"camera.range", "900"},
                {"target.altitude", "1500"}, {"render.antialiasing", "0"}, {"state.power", "0.7"},
                {"state.mach", "0.4"}};
    }
    QTabWidget* tabs() { return dock().tabs(); }
};

} // namespace smat::gui::test
