#include "gui/ManipulatorsDock.h"

#include <QLineEdit>
#include <QSlider>
#include <QToolButton>

#include "gui/widgets/NumberText.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class ManipulatorsTest : public test::WindowFixture {
  protected:
    QLineEdit* field(const std::string& key) {
        return window->findChild<QLineEdit*>(QString::fromStdString(key));
    }
    QSlider* slider(const std::string& key) {
        return window->findChild<QSlider*>(QString::fromStdString(key + ".slider"));
    }
    void type(const std::string& key, const char* text) {
        field(key)->setFocus();
        field(key)->selectAll();
        QTest::keyClicks(field(key), text);
    }
};

TEST_F(ManipulatorsTest, ATypedNumberIsTheStateAndTheSliderFollows) {
    openSample();
    for (const std::string key : {"camera.azimuth", "camera.elevation", "camera.range",
                                  "target.yaw", "target.pitch", "target.roll"}) {
        const int before = slider(key)->value();
        type(key, "12.345");
        EXPECT_EQ(workbench.settings().text(key), "12.345") << key;
        EXPECT_NE(slider(key)->value(), before) << key;
        EXPECT_EQ(field(key)->text(), "12.345") << key;
    }
    EXPECT_EQ(window->sceneView()->camera(), (OrbitCamera{12.345, 12.345, 12.345}));
    EXPECT_EQ(workbench.undoStack().count(), 6);
    // Half way on a logarithmic slider from 1 m to 1000 km is a kilometre.
    type("camera.range", "1000");
    EXPECT_EQ(slider("camera.range")->value(), slider("camera.range")->maximum() / 2);
}

TEST_F(ManipulatorsTest, ADragMovesTheViewAllTheWayAndIsOneStep) {
    openSample();
    auto* azimuth = slider("camera.azimuth");
    const QRect area = azimuth->rect();
    const QPoint handle(static_cast<int>(area.width() * (60.0 + 180.0) / 360.0), area.center().y());
    QTest::mousePress(azimuth, Qt::LeftButton, {}, handle);
    double last = workbench.camera().azimuth_deg;
    for (int i = 1; i <= 4; ++i) {
        QTest::mouseMove(azimuth, handle + QPoint(6 * i, 0));
        EXPECT_GT(workbench.camera().azimuth_deg, last);
        last = workbench.camera().azimuth_deg;
        EXPECT_EQ(window->sceneView()->camera().azimuth_deg, last);
        EXPECT_EQ(field("camera.azimuth")->text().toDouble(), last);
    }
    QTest::mouseRelease(azimuth, Qt::LeftButton, {}, handle + QPoint(24, 0));
    EXPECT_EQ(workbench.undoStack().count(), 1);
    trigger("undo");
    EXPECT_EQ(window->sceneView()->camera().azimuth_deg, 60.0);
    EXPECT_EQ(field("camera.azimuth")->text(), "60");
}

TEST_F(ManipulatorsTest, ValuesBeyondASliderStayExact) {
    openSample();
    type("camera.range", "25000000");
    EXPECT_EQ(workbench.settings()[key::cameraRange], 2.5e7);
    EXPECT_EQ(slider("camera.range")->value(), slider("camera.range")->maximum());
    type("target.yaw", "-270.125");
    EXPECT_EQ(workbench.settings()[key::targetYaw], -270.125);
    EXPECT_EQ(slider("target.yaw")->value(), 0);
}

TEST_F(ManipulatorsTest, ARefusedNumberLeavesNotItsBeginning) {
    openSample();
    struct {
        const char *key, *text, *value, *said;
    } const rows[] = {
        {"camera.range", "12,5", "12.5", ""},
        {"camera.range", "2e5", "200000", ""},
        {"camera.range", "1,5 km", "1500", ""},
        {"camera.range", "2.500,0", "1500", "'2.500,0' has a point and a comma"},
        {"camera.range", "20 parsecs", "1500", "'parsecs' is none of the units m, km"},
        {"camera.azimuth", "1.2.3", "60", "several decimal signs"},
        {"target.yaw", "0,25", "0.25", ""},
        {"state.mach", "0,85", "0.85", ""},
        {"state.mach", "0.8.5", "0.85", "several decimal signs"},
        {"target.altitude", "2 km", "2000", ""},
        {"target.altitude", "3 km2", "2000", "'km2' is none of the units"},
    };
    for (const auto& row : rows) {
        field(row.key)->setProperty("refused", {});
        type(row.key, row.text);
        QTest::keyClick(field(row.key), Qt::Key_Return);
        const auto value = numberOf(QString::fromStdString(workbench.settings().text(row.key)));
        EXPECT_EQ(value, numberOf(row.value)) << row.key << " " << row.text;
        EXPECT_EQ(numberOf(field(row.key)->text()), value) << row.key << " " << row.text;
        EXPECT_TRUE(field(row.key)->property("refused").toString().contains(row.said))
            << field(row.key)->property("refused").toString().toStdString();
    }
}

TEST_F(ManipulatorsTest, ATextThatIsNoNumberChangesNothingAndGoesAway) {
    openSample();
    type("camera.elevation", "abc");
    EXPECT_EQ(workbench.settings()[key::cameraElevation], 15.0);
    EXPECT_NE(field("camera.elevation")->palette().color(QPalette::Base),
              window->palette().color(QPalette::Base));
    QTest::keyClick(field("camera.elevation"), Qt::Key_Return);
    EXPECT_EQ(field("camera.elevation")->text(), "15");
    EXPECT_EQ(workbench.undoStack().count(), 0);
}

TEST_F(ManipulatorsTest, LooksFromTheSixSides) {
    openSample();
    window->findChild<QToolButton*>("viewTop")->click();
    EXPECT_EQ(workbench.camera().elevation_deg, 90.0);
    window->findChild<QToolButton*>("viewStarboard")->click();
    EXPECT_EQ(workbench.camera().azimuth_deg, 90.0);
    EXPECT_EQ(workbench.camera().elevation_deg, 0.0);
    EXPECT_EQ(workbench.undoStack().undoText(), "Look: from starboard");
}

} // namespace
} // namespace smat::gui
