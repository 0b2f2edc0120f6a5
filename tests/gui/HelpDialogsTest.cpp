#include "gui/HelpDialogs.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>

#include "smatcore/settings/SettingAvailability.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class HelpDialogsTest : public test::WindowFixture {};

TEST_F(HelpDialogsTest, TheListOfKeysIsThatOfTheActions) {
    QString text;
    onDialog = [&](QDialog& dialog) { text = dialog.findChild<QLabel*>("keyList")->text(); };
    trigger("showShortcuts");
    QStringList seen;
    for (auto* action : window->findChildren<QAction*>()) {
        for (const auto& keys : action->shortcuts()) {
            const QString name = keys.toString(QKeySequence::NativeText);
            EXPECT_TRUE(text.contains(name)) << name.toStdString();
            // A key of one widget alone may be another's, too.
            if (action->shortcutContext() == Qt::WidgetShortcut) {
                continue;
            }
            EXPECT_FALSE(seen.contains(name)) << name.toStdString() << " does two things";
            seen << name;
        }
    }
    EXPECT_GE(seen.size(), 18);
    EXPECT_TRUE(text.contains("Save project as"));
}

TEST_F(HelpDialogsTest, EveryMenuAndItsEntriesHaveALetterOfTheirOwn) {
    openSample();
    for (const auto* menu : window->menuBar()->actions()) {
        EXPECT_TRUE(menu->text().contains('&')) << menu->text().toStdString();
        QStringList letters;
        for (const auto* action : menu->menu()->actions()) {
            const int at = static_cast<int>(action->text().indexOf('&'));
            if (action->isSeparator() || at < 0) {
                continue;
            }
            const QString letter = action->text().mid(at + 1, 1).toLower();
            EXPECT_FALSE(letters.contains(letter))
                << menu->text().toStdString() << ": " << action->text().toStdString() << ", behind "
                << letters.join(' ').toStdString();
            letters << letter;
        }
    }
}

TEST_F(HelpDialogsTest, AboutNamesEveryLibraryWithItsVersion) {
    QString text;
    onDialog = [&](QDialog& dialog) { text = dialog.findChild<QLabel*>("aboutText")->text(); };
    trigger("showAbout");
    for (const auto* name : {"Qt", "Qwt", "OpenSceneGraph", "OpenEXR", "SQLite", "3-D view"}) {
        EXPECT_TRUE(text.contains(name)) << name;
    }
    EXPECT_TRUE(text.contains(qVersion()));
    EXPECT_EQ(text.contains("FFTW"), whyUnavailable(settingInfo("render.scattering")).empty());
    EXPECT_TRUE(text.contains(window->sceneView()->renderer().toHtmlEscaped()));
}

} // namespace
} // namespace smat::gui
