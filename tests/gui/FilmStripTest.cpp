#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QListWidget>
#include <QToolButton>

#include "gui/analysis/ResultPage.h"
#include "gui/plot/PolarPlot.h"
#include "gui/start/StartPage.h"
#include "gui/widgets/Theme.h"
#include "tests/gui/DatabaseFixture.h"

namespace smat::gui {
namespace {

struct Screen {
    const char* name;
    QSize size;
    ThemeMode theme;
};
void PrintTo(const Screen& row, std::ostream* out) {
    *out << row.name;
}

/// A session as one would show it to others, a picture at each step, to be looked at in order.
class FilmStripTest : public test::DatabaseFixture, public ::testing::WithParamInterface<Screen> {
  protected:
    void TearDown() override {
        window.reset(); // whose hundreds of widgets would be polished anew for nobody
        applyTheme(*qApp, ThemeMode::light);
        QTest::qWait(20);
    }
    void keep(const char* step) {
        QTest::qWait(60);
        test::keepScreenshot(*window, std::string("film-") + GetParam().name + "-" +
                                          std::to_string(++number_) + "-" + step);
    }
    std::vector<QRgb> pixels() {
        SceneView& view = *window->sceneView();
        EXPECT_TRUE(
            test::waitUntil([&] { return view.isUpToDate() && view.shownPicture() != nullptr; }));
        const QImage colors = view.shownPicture()->colors.convertToFormat(QImage::Format_RGB32);
        std::vector<QRgb> all;
        for (int y = 0; y < colors.height(); ++y) {
            for (int x = 0; x < colors.width(); ++x) {
                all.push_back(colors.pixel(x, y));
            }
        }
        return all;
    }
    static int differing(const std::vector<QRgb>& a, const std::vector<QRgb>& b) {
        int count = 0;
        for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
            count += a[i] != b[i] ? 1 : 0;
        }
        return count;
    }
    int materialNamed(const std::string& name) {
        for (const auto& [index, material] : session().value().materials) {
            if (material.name == name) {
                return index;
            }
        }
        return -1;
    }

  private:
    int number_ = 0;
};

TEST_P(FilmStripTest, FromTheStartPageToReopenedResults) {
    applyTheme(*qApp, GetParam().theme);
    window->resize(GetParam().size);
    keep("start");

    // A copy of the sample that may be written, from the list of recent files as from a card.
    openCopy("turboprop4", {{"camera.azimuth", "150"},
                            {"camera.elevation", "12"},
                            {"camera.range", "900"},
                            {"sensor.fov", "3"},
                            {"target.altitude", "1500"},
                            {"state.power", "0.7"},
                            {"polar.step", "30"},
                            {"display.colorMap", "ironbow"}});
    keep("opened");
    window->findChild<QToolButton*>("showInfrared")->click();
    const std::vector<QRgb> first = pixels();
    keep("infrared");

    // +100 K on the exhaust pipes changes more than a pixel.
    heatPipes(100.0);
    const int heated = differing(first, pixels());
    RecordProperty("pixels changed by 100 K", heated);
    EXPECT_GT(heated, 50);
    keep("heated");

    // Paint, polar twice, overlay: the legend says what differs.
    runAnalysis("polar");
    keep("polar");
    const int grey = materialNamed("grey paint");
    ASSERT_GE(grey, 0);
    window->findChild<QTabWidget*>("tabs")->setCurrentIndex(0);
    dock().select({EntryKind::material, grey});
    dock().raise();
    auto* table = find<QWidget>("emissivity")->findChild<NodeTable*>()->model();
    for (int row = 0; row < table->rowCount() - 1; ++row) {
        table->setData(table->index(row, 1), "0.3", Qt::EditRole);
    }
    pixels();
    keep("painted");
    runAnalysis("polar");
    auto* list = window->findChild<QListWidget*>("resultList");
    list->selectAll();
    window->findChild<QToolButton*>("overlayResults")->click();
    const PolarPlot* plot = window->currentPage()->polarPlot();
    ASSERT_EQ(plot->data().curves.size(), 2U);
    EXPECT_TRUE(plot->data().curves[0].name.startsWith("ε"))
        << plot->data().curves[0].name.toStdString();
    EXPECT_EQ(plot->data().curves[1].name, "ε 0.3");
    EXPECT_TRUE(plot->data().conditions.contains("altitude 1500 m"))
        << plot->data().conditions.toStdString();
    keep("overlay");
    runAnalysis("image");
    keep("image");
    applyTheme(*qApp, GetParam().theme == ThemeMode::dark ? ThemeMode::light : ThemeMode::dark);
    keep("other-theme");
    applyTheme(*qApp, GetParam().theme);

    // Quit, and open it again with all results.
    trigger("saveDatabase");
    trigger("saveProject");
    ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    const std::size_t results = workbench.results().size();
    ASSERT_TRUE(window->close());
    window.reset();
    Workbench later;
    window = std::make_unique<MainWindow>(later, people);
    window->resize(GetParam().size);
    window->show();
    ASSERT_TRUE(opens(folder / "turboprop4.smat"));
    ASSERT_TRUE(test::waitUntil([&] { return later.results().size() == results; }));
    list = window->findChild<QListWidget*>("resultList");
    list->selectAll();
    window->findChild<QDockWidget*>("resultsDock")->raise();
    keep("reopened");
    list->clearSelection();
    for (const int row : {0, 1}) {
        list->item(row)->setSelected(true);
    }
    window->findChild<QToolButton*>("overlayResults")->click();
    EXPECT_EQ(window->currentPage()->polarPlot()->data().curves[1].name, "ε 0.3");
    keep("overlay-again");
    window.reset();
}

INSTANTIATE_TEST_SUITE_P(OnScreens, FilmStripTest,
                         ::testing::Values(Screen{"light-1280", {1280, 800}, ThemeMode::light},
                                           Screen{"dark-1600", {1600, 1000}, ThemeMode::dark}),
                         [](const auto& param) {
                             std::string name = param.param.name;
                             std::erase(name, '-');
                             return name;
                         });

} // namespace
} // namespace smat::gui
