#include <QApplication>
#include <QDockWidget>
#include <QLineEdit>
#include <QwtPlot>

#include "gui/widgets/Theme.h"
#include "tests/gui/DatabaseFixture.h"

namespace smat::gui {
namespace {

/// The theme is changed while the window is open, more than once.
class ThemeChangeTest : public test::DatabaseFixture {
  protected:
    void TearDown() override {
        applyTheme(*qApp, ThemeMode::light);
        QTest::qWait(20);
    }
    /// Every plot and field that is in sight has the colours of the theme.
    void expectReadable(bool dark, const std::string& where) {
        int plots = 0;
        for (const auto* plot : window->findChildren<QwtPlot*>()) {
            if (!plot->isVisible()) {
                continue;
            }
            ++plots;
            const std::string name = where + ": " + plot->objectName().toStdString();
            EXPECT_EQ(plot->canvasBackground().color().lightness() < 128, dark) << name;
            EXPECT_EQ(plot->palette().color(QPalette::Text).lightness() > 128, dark) << name;
            EXPECT_EQ(plot->palette().color(QPalette::Window).lightness() < 128, dark) << name;
        }
        EXPECT_GE(plots, 1) << where;
        for (const auto* field : window->findChildren<QLineEdit*>()) {
            if (field->isVisible()) {
                EXPECT_EQ(field->palette().color(QPalette::Base).lightness() < 128, dark)
                    << where << ": " << field->objectName().toStdString();
            }
        }
    }
};

TEST_F(ThemeChangeTest, PlotsAndFieldsOfTheDatabaseFollowEveryChange) {
    openCopy("turboprop4", {});
    const auto show = [&](EntryKind kind, int index) {
        dock().select({kind, index});
        dock().raise();
        QTest::qWait(40);
    };
    for (const EntryKind kind : {EntryKind::material, EntryKind::temperature}) {
        show(kind, 5);
        if (kind == EntryKind::temperature) {
            chooseTab("temperatureTabs", "Equation terms");
        }
        for (const ThemeMode mode :
             {ThemeMode::dark, ThemeMode::light, ThemeMode::dark, ThemeMode::light}) {
            applyTheme(*qApp, mode);
            QTest::qWait(40);
            const bool dark = mode == ThemeMode::dark;
            expectReadable(dark,
                           std::string(kind == EntryKind::material ? "material" : "temperature") +
                               (dark ? " in the dark" : " in the light"));
            test::keepScreenshot(*window,
                                 std::string("theme-change-") +
                                     (kind == EntryKind::material ? "material-" : "terms-") +
                                     (dark ? "dark" : "light"));
        }
    }
}

} // namespace
} // namespace smat::gui
