#include "gui/settings/Preferences.h"

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSpinBox>

#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class PreferencesTest : public test::WindowFixture {};

TEST_F(PreferencesTest, AreKeptInAReadableFile) {
    onDialog = [&](QDialog& dialog) {
        dialog.findChild<QComboBox*>("theme")->setCurrentIndex(2);
        dialog.findChild<QComboBox*>("colorMap")->setCurrentText("ironbow");
        dialog.findChild<QSpinBox*>("recoveryDelay")->setValue(30);
    };
    trigger("preferences");
    EXPECT_TRUE(isDark(QApplication::palette()));
    const Preferences kept = Preferences::load();
    EXPECT_EQ(kept, (Preferences{ThemeMode::dark, "ironbow", 30}));
    QFile file(Preferences::file());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    EXPECT_TRUE(text.contains("theme=dark")) << text.toStdString();
    EXPECT_TRUE(text.contains("recoveryDelay_s=30"));
    // A project that is begun has the map; one that has a file keeps its own.
    makeWindow();
    EXPECT_TRUE(opens(std::filesystem::path(SMAT_SOURCE_DIR) / "samples/ship/ship.flt"));
    EXPECT_EQ(workbench.settings().text("display.colorMap"), "ironbow");
    EXPECT_FALSE(workbench.isModified());
    openSample();
    EXPECT_EQ(workbench.settings().text("display.colorMap"), "white-hot");
    Preferences().save();
    applyTheme(*qApp, ThemeMode::light);
}

TEST_F(PreferencesTest, WrongOnesAreNamedAndReplacedByDefaults) {
    QDir().mkpath(QFileInfo(Preferences::file()).path());
    QFile file(Preferences::file());
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("[General]\ntheme=pink\ncolorMap=plaid\nrecoveryDelay_s=soon\n");
    file.close();
    QStringList problems;
    EXPECT_EQ(Preferences::load(&problems), Preferences());
    ASSERT_EQ(problems.size(), 3);
    EXPECT_TRUE(problems.join(' ').contains("pink"));
    EXPECT_TRUE(problems.join(' ').contains("plaid"));
    EXPECT_TRUE(problems.join(' ').contains("soon"));
    Preferences().save();
}

} // namespace
} // namespace smat::gui
