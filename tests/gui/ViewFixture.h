#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include <QApplication>
#include <QTest>
#include <gtest/gtest.h>

#include "gui/view/SceneView.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/SampleProject.h"

namespace smat::gui::test {

/// A view of a sample, 400 x 300 and 10 degrees wide, as many pixels of the screen as the sensor
/// has.
class ViewFixture : public ::testing::Test {
  protected:
    void SetUp() override {
        if (lacksGl()) {
            GTEST_SKIP() << "this desktop gives no OpenGL context";
        }
    }
    static Project sample(const std::string& name) {
        const auto folder = std::filesystem::path(SMAT_SOURCE_DIR) / "samples" / name;
        Project project = loadProject(folder / (name + ".smat"));
        Settings& settings = project.settings;
        settings.set("sensor.width", pixels(400));
        settings.set("sensor.height", pixels(300));
        settings.set("render.lightError", "0.02");
        return project;
    }
    /// Pixels of a picture that a pixel of the widget has along each side.
    static double pixelRatio() { return qApp->devicePixelRatio(); }
    static int pixels(int ofWidget) {
        return static_cast<int>(std::lround(ofWidget * pixelRatio()));
    }
    void show(const Project& shown) {
        project = shown;
        view.resize(400, 300);
        view.setScene(loadDisplayScene(project, project.settings));
        view.setProject(project, project.settings);
        view.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
        QTest::qWait(30);
    }
    void set(const char* key, const std::string& value) {
        project.settings.set(key, value);
        view.setProject(project, project.settings);
    }
    /// Waits for the infrared picture of what is set now, in full.
    bool waitForPicture() {
        return waitUntil(
            [this] {
                const auto* picture = view.shownPicture();
                return picture != nullptr && !picture->coarse && view.isUpToDate();
            },
            20.0);
    }
    bool showInfrared() {
        view.setDisplay(ViewDisplay::infrared);
        return waitForPicture();
    }

    Project project;
    SceneView view;
};

/// How far two colours are apart, summed over the channels.
inline int apart(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
           std::abs(a.blue() - b.blue());
}

} // namespace smat::gui::test
