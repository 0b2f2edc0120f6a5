#pragma once

#include <fstream>

#include <QTabWidget>

#include "gui/scenario/ScenarioPage.h"
#include "gui/scenario/TimeLine.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui::test {

/// A small scenario of two boxes and two sensors in a folder of its own, opened in the window.
class ScenarioFixture : public WindowFixture {
  protected:
    static inline const std::string flight =
        "# A pass from west to east.\n"
        "t [s],x [m],y [m],z [m],yaw [deg],pitch [deg],roll [deg],power,mach\n"
        "0,-6,100,50,270,0,0,0.2,0.1\n1,0,100,50,270,0,0,0.6,0.1\n2,6,100,52,270,0,0,1,0.1\n";

    void write(const std::string& name, const std::string& text) {
        std::ofstream(folder / name, std::ios::binary) << text;
    }
    std::filesystem::path writeScenario() {
        const std::string box = SMAT_SOURCE_DIR "/samples/box/box";
        const auto entity = [&](const std::string& name, const std::string& place) {
            return R"({"name": ")" + name + R"(", "model": ")" + box + R"(.flt", "database": ")" +
                   box + R"(.sigdb", )" + place + "}";
        };
        write("flight.csv", flight);
        write("pass.json",
              R"({"version": 1, "title": "Pass", "notes": "Kept as it is.",
 "dt_s": 0.25, "end_s": 2, "sensor": {"width": 48, "height": 40, "fov": 12},
 "render": {"lightError": 0.02},
 "entities": [)" + entity("mover", R"("trajectory": "flight.csv")") +
                  ", " + entity("buoy", R"("position_m": [4, 110, 50])") + R"(],
 "sensors": [{"name": "mwir", "position_m": [0, 0, 50], "sensor": {"band": "3-5"}},
  {"name": "lwir", "position_m": [0, 0, 50], "track": "mover", "sensor": {"band": "8-12"}}]})");
        return folder / "pass.json";
    }
    /// Opens it as a person does, and waits for its first picture.
    ScenarioPage* openScenario() {
        chosen = QString::fromStdString(writeScenario().string());
        trigger("openProject");
        auto* page = shownPage();
        if (page != nullptr) {
            EXPECT_TRUE(settles(*page));
        }
        EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
        return page;
    }
    ScenarioPage* shownPage() {
        auto* tabs = window->findChild<QTabWidget*>("tabs");
        return dynamic_cast<ScenarioPage*>(tabs->currentWidget());
    }
    static bool settles(ScenarioPage& page) {
        return waitUntil([&] { return !page.isBusy(); });
    }
};

} // namespace smat::gui::test
