#include "gui/widgets/Theme.h"

#include <map>
#include <set>

#include <QAbstractButton>
#include <QApplication>
#include <QListWidget>
#include <QMessageBox>
#include <QTabBar>
#include <QTabWidget>
#include <QToolBar>

#include "gui/image/ComparisonWindow.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class ThemeTest : public test::WindowFixture {
  protected:
    void TearDown() override {
        window.reset(); // whose hundreds of widgets would be polished anew for nobody
        applyTheme(*qApp, ThemeMode::light);
        QTest::qWait(20);
    }
};

TEST_F(ThemeTest, FollowsTheDesktopUnlessOneIsChosen) {
    const QPalette dark(QColor("#303030"), QColor("#202020"));
    const QPalette light(QColor("#f0f0f0"), QColor("#ffffff"));
    const struct {
        ThemeMode mode;
        bool onDark, onLight;
    } rows[] = {{ThemeMode::system, true, false},
                {ThemeMode::dark, true, true},
                {ThemeMode::light, false, false}};
    for (const auto& row : rows) {
        EXPECT_EQ(isDark(row.mode, dark), row.onDark);
        EXPECT_EQ(isDark(row.mode, light), row.onLight);
    }
    // What is applied is seen: this desktop has Qt's own palette, a light one.
    for (const auto mode : {ThemeMode::dark, ThemeMode::system}) {
        applyTheme(*qApp, mode);
        EXPECT_EQ(isDark(QApplication::palette()), mode == ThemeMode::dark);
    }
}

TEST_F(ThemeTest, ButtonsOfMessagesAndDialogsHaveNoIcons) {
    QMessageBox box(QMessageBox::Warning, "title", "text",
                    QMessageBox::Ok | QMessageBox::Cancel | QMessageBox::Discard, window.get());
    for (const auto* button : box.buttons()) {
        EXPECT_TRUE(button->icon().isNull()) << button->text().toStdString();
    }
}

/// Mean lightness of what an icon draws, 0 to 255; 128 for nothing.
double lightnessOf(const QIcon& icon) {
    const QImage drawn = icon.pixmap(24).toImage();
    double sum = 0.0, weight = 0.0;
    for (int y = 0; y < drawn.height(); ++y) {
        for (int x = 0; x < drawn.width(); ++x) {
            const QColor pixel = drawn.pixelColor(x, y);
            sum += pixel.alphaF() * pixel.lightnessF() * 255.0;
            weight += pixel.alphaF();
        }
    }
    return weight > 0.0 ? sum / weight : 128.0;
}

/// Every icon that is in sight, with where it is.
std::map<QString, QIcon> iconsOf(QWidget& window) {
    std::map<QString, QIcon> icons;
    const auto keep = [&](const QString& where, const QIcon& icon) {
        if (!icon.isNull()) {
            icons.emplace(where, icon);
        }
    };
    for (auto* button : window.findChildren<QAbstractButton*>()) {
        if (button->isVisible()) {
            keep("button " + button->objectName() + " " + button->text() + button->toolTip(),
                 button->icon());
        }
    }
    for (auto* tabs : window.findChildren<QTabWidget*>()) {
        for (int i = 0; i < tabs->count(); ++i) {
            keep("tab " + tabs->tabText(i), tabs->tabIcon(i));
        }
    }
    for (auto* list : window.findChildren<QListWidget*>()) {
        for (int i = 0; i < list->count(); ++i) {
            keep("list " + list->item(i)->text(), list->item(i)->icon());
        }
    }
    for (auto* action : window.findChildren<QAction*>()) {
        keep("action " + action->objectName() + " " + action->text(), action->icon());
    }
    return icons;
}

TEST_F(ThemeTest, CommandsThatLookAlikeDoAlike) {
    const std::set<QStringList> alike{
        {"addModel", "openModel"},
        {"convertModel", "importAir", "menuImportMaterial", "menuImportSpectrum"},
        {"copyFromDatabase", "openDatabase"},
        {"exportShown", "saveResultAction"},
        {"firstSignature", "menuLibrary"}, // materials by name
        {"fitModel", "showWholeModel"},
        {"menuNewDatabase", "newProject"},
        {"menuOpenDatabase", "openProject", "openResultAction"},
        {"menuSaveDatabaseAs", "saveProject"},
        {"newAir", "projectAir"}};
    std::map<QByteArray, QStringList> looks;
    for (const auto* action : window->findChildren<QAction*>()) {
        if (action->icon().isNull() || action->objectName().isEmpty() ||
            action->objectName().startsWith("_q_")) { // Qt's own
            continue;
        }
        const QImage drawn =
            action->icon().pixmap(32).toImage().convertToFormat(QImage::Format_ARGB32);
        const QByteArray pixels(reinterpret_cast<const char*>(drawn.constBits()),
                                drawn.sizeInBytes());
        looks[pixels] << action->objectName();
    }
    EXPECT_GT(looks.size(), 25U);
    for (auto& [pixels, names] : looks) {
        names.sort();
        EXPECT_TRUE(names.size() == 1 || alike.contains(names)) << names.join(", ").toStdString();
    }
    // Every kind of analysis has one of its own, which its results have as well.
    std::map<std::string, std::string> kinds;
    for (const AnalysisKind kind : allAnalysisKinds()) {
        const auto [place, isNew] = kinds.emplace(kind->icon, name(kind));
        EXPECT_TRUE(isNew) << name(kind) << " looks as " << place->second;
    }
}

TEST_F(ThemeTest, EveryIconTurnsWithTheTheme) {
    openSample();
    for (const char* word : {"image", "polar", "range"}) {
        runAnalysis(word);
    }
    const auto& results = workbench.results();
    window->compareResults(results[0].id, results[0].id);
    auto* tabs = window->findChild<QTabWidget*>("tabs");
    std::map<int, std::map<QString, double>> lightOf;
    for (int page = 0; page < tabs->count(); ++page) {
        tabs->setCurrentIndex(page);
        QTest::qWait(30);
        for (const auto& [where, icon] : iconsOf(*window)) {
            lightOf[page][where] = lightnessOf(icon);
        }
    }
    // The last page is in sight as the theme turns, the others are not.
    applyTheme(*qApp, ThemeMode::dark);
    QTest::qWait(20);
    for (int page = tabs->count() - 1; page >= 0; --page) {
        tabs->setCurrentIndex(page);
        QTest::qWait(30);
        test::keepScreenshot(*window, "theme-dark-" + std::to_string(page));
        const std::map<QString, double>& light = lightOf[page];
        int drawn = 0;
        for (const auto& [where, icon] : iconsOf(*window)) {
            const auto before = light.find(where);
            if (before == light.end() || before->second > 80.0) {
                continue; // has colours of its own
            }
            EXPECT_GT(lightnessOf(icon), before->second + 30.0) << where.toStdString();
            ++drawn;
        }
        EXPECT_GT(drawn, 20) << tabs->tabText(page).toStdString();
    }
}

} // namespace
} // namespace smat::gui
