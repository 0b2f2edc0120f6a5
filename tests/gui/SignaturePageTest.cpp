// The page of a signature table: map and ball, what is chosen, what is written.
#include <cmath>

#include <QComboBox>
#include <QImage>
#include <QProcess>
#include <gtest/gtest.h>

#include "gui/analysis/ResultPage.h"
#include "gui/plot/PlotLook.h"
#include "gui/plot/TablePanel.h"
#include "irsg/core/FileReading.h"
#include "smatcore/tables/TableFormats.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

/// Brightest to starboard, darker than the background from behind; two ranges, two bands.
ResultTable table(bool isGrid = true) {
    ResultTable made;
    made.add(irsg::Quantity::azimuth);
    made.add(irsg::Quantity::elevation);
    made.add(irsg::Quantity::range);
    made.add("contrast_intensity@3-5um", "W sr-1");
    made.add("contrast_intensity@8-12um", "W sr-1");
    const auto value = [](double azimuth, double elevation) {
        const double a = azimuth * 0.0174532925, e = elevation * 0.0174532925;
        return 60.0 * std::pow(std::max(0.0, std::sin(a) * std::cos(e)), 2) + 12.0 +
               20.0 * std::cos(a) * std::cos(e) + 5.0 * std::sin(e);
    };
    const auto add = [&](double azimuth, double elevation) {
        for (const double range : {1000.0, 3000.0}) {
            made.addRow({azimuth, elevation, range, value(azimuth, elevation) * 1000.0 / range,
                         3.0 * value(azimuth, elevation)});
        }
    };
    if (isGrid) {
        for (int elevation = -90; elevation <= 90; elevation += 10) {
            for (int azimuth = 0; azimuth < 360; azimuth += 10) {
                add(azimuth, elevation);
            }
        }
    } else {
        // A spiral, even on the sphere.
        for (int i = 0; i < 400; ++i) {
            add(std::fmod(i * 137.50776405, 360.0),
                57.29577951 * std::asin((i + 0.5) / 200.0 - 1.0));
        }
    }
    made.provenance.add("analysis", "table");
    return made;
}

TEST(TableDrawing, FindsTheCellOfEveryDirection) {
    for (const bool isGrid : {true, false}) {
        const ResultTable from = table(isGrid);
        const SignatureTable one(from);
        const DirectionLookup lookup(one);
        for (std::size_t i = 0; i < one.directions().size(); ++i) {
            const auto& at = one.directions()[i];
            const bool isPole = std::abs(at.elevation_deg) == 90.0;
            const int found = lookup.nearest(at.azimuth_deg + 0.2, at.elevation_deg);
            ASSERT_NE(found, DirectionLookup::nothing) << i;
            if (!isPole) {
                EXPECT_EQ(found, static_cast<int>(i)) << at.azimuth_deg << ", " << at.elevation_deg;
            }
            EXPECT_EQ(lookup.nearest(at.azimuth_deg - 720.0, at.elevation_deg),
                      lookup.nearest(at.azimuth_deg, at.elevation_deg));
        }
    }
    // Below the lowest row of a table there is nothing.
    ResultTable upper;
    upper.add(irsg::Quantity::azimuth);
    upper.add(irsg::Quantity::elevation);
    upper.add(irsg::Quantity::contrastIntensity);
    for (const double elevation : {0.0, 10.0}) {
        for (const double azimuth : {0.0, 90.0, 180.0, 270.0}) {
            upper.addRow({azimuth, elevation, 1.0});
        }
    }
    const SignatureTable one(upper);
    EXPECT_EQ(DirectionLookup(one).nearest(40.0, -5.1), DirectionLookup::nothing);
    EXPECT_NE(DirectionLookup(one).nearest(40.0, -4.9), DirectionLookup::nothing);
}

TEST(TableDrawing, ReadsMapAndBallAtTheirPlaces) {
    TablePlot plot(std::make_shared<const ResultTable>(table()));
    plot.resize(900, 500);
    plot.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&plot));
    TableDrawing& drawing = plot.drawing();
    // The middle of the ball is where it is looked at from; the right of it, from the nose, port.
    const auto directionOf = [&](const QPointF& point) {
        const int direction = plot.directionAt(point);
        return direction < 0 ? SignatureTable::Direction{-1, -1}
                             : drawing.table().directions()[static_cast<std::size_t>(direction)];
    };
    drawing.turnBall(0.0, 0.0);
    EXPECT_EQ(directionOf(plot.ballCentre()), (SignatureTable::Direction{0, 0}));
    const double radius =
        0.5 * drawing.ballIn(plot.rect(), QFontMetricsF(plotFont(), &plot).height()).width();
    EXPECT_EQ(directionOf(plot.ballCentre() + QPointF(0.866 * radius, 0)),
              (SignatureTable::Direction{300, 0}));
    EXPECT_EQ(directionOf(plot.ballCentre() - QPointF(0, 0.5 * radius)),
              (SignatureTable::Direction{0, 30}));
    EXPECT_EQ(plot.directionAt({1.0, 1.0}), DirectionLookup::nothing);
    // Keys and mouse turn it; nothing else of it changes.
    QTest::keyClick(&plot, Qt::Key_Right);
    EXPECT_EQ(drawing.ballAzimuth_deg(), 10.0);
    QTest::mousePress(&plot, Qt::LeftButton, Qt::NoModifier, plot.ballCentre().toPoint());
    QTest::mouseMove(&plot, plot.ballCentre().toPoint() + QPoint(20, 0));
    QTest::mouseRelease(&plot, Qt::LeftButton, Qt::NoModifier,
                        plot.ballCentre().toPoint() + QPoint(20, 0));
    EXPECT_GT(drawing.ballAzimuth_deg(), 12.0);
}

TEST(TableDrawing, TellsOfNegativeCellsAndScales) {
    TableDrawing drawing(std::make_shared<const ResultTable>(table()));
    const SignatureTable& one = drawing.table();
    int negative = 0;
    double most = -1e9;
    for (std::size_t i = 0; i < one.directions().size(); ++i) {
        const double value = drawing.column().values[one.row(i, {0})];
        negative += value < 0.0 ? 1 : 0;
        most = std::max(most, value);
    }
    ASSERT_GT(negative, 0);
    EXPECT_EQ(drawing.negativeCells(), negative);
    EXPECT_TRUE(drawing.negativeWords().startsWith(QString::number(negative) + " of 684"));
    EXPECT_EQ(drawing.limits().high, most);
    EXPECT_LT(drawing.limits().low, 0.0);
    drawing.setDecibel(true);
    EXPECT_NEAR(drawing.limits().high, 10.0 * std::log10(most), 1e-9);
    EXPECT_EQ(drawing.negativeCells(), negative);
    drawing.setChoice({1});
    EXPECT_NEAR(drawing.limits().high, 10.0 * std::log10(most / 3.0), 1e-9) << "from 3000 m";
}

class SignaturePageTest : public test::WindowFixture {};

TEST_F(SignaturePageTest, OfATableThatTheWindowComputed) {
    ASSERT_TRUE(opens(own("turboprop4")));
    for (const auto& [key, value] : {std::pair{"table.azimuthStep", "30"},
                                     {"table.elevationStep", "30"},
                                     {"table.ranges", "1000,3000"},
                                     {"render.antialiasing", "3"},
                                     {"target.altitude", "8000"},
                                     {"sensor.band", "3-5,8-12"}}) {
        workbench.set(key, value);
    }
    runAnalysis("table");
    auto* page = qobject_cast<ResultPage*>(window->findChild<QTabWidget*>("tabs")->currentWidget());
    ASSERT_NE(page, nullptr);
    TablePanel* panel = page->tablePanel();
    ASSERT_NE(panel, nullptr);
    const TableDrawing& drawing = panel->plot()->drawing();
    EXPECT_EQ(drawing.table().directions().size(), 12U * 7U);
    const auto choose = [&](const char* name, int index) {
        auto* box = panel->findChild<QComboBox*>(name);
        ASSERT_NE(box, nullptr) << name;
        box->setCurrentIndex(index);
        emit box->activated(index);
    };
    EXPECT_EQ(drawing.column().key, "contrast_intensity@3-5um");
    choose("tableBand", 1);
    EXPECT_EQ(drawing.column().key, "contrast_intensity@8-12um");
    choose("tableAxis.range", 1);
    EXPECT_EQ(drawing.choice(), (SignatureTable::Choice{1}));
    choose("tableScale", 1);
    EXPECT_TRUE(drawing.isDecibel());
    test::keepScreenshot(*window, "signature-table");

    // What is written: picture, cells, the table itself and its forms for others.
    EXPECT_TRUE(page->exportFilters().contains("All inputs and values (*.json)"));
    for (const char* name : {"a.svg", "a.png", "a.pdf", "a.csv", "a.json"}) {
        page->exportTo(folder / name);
        EXPECT_GT(std::filesystem::file_size(folder / name), 500U) << name;
    }
    EXPECT_EQ(ResultTable::load(folder / "a.csv"), workbench.results().back().data->table);
    for (const TableFormat* format : tableFormats()) {
        if (format->isBuilt) {
            page->exportTo(folder / (std::string("a") + format->extension));
        }
    }
}

TEST_F(SignaturePageTest, OfOpenedTablesInLightAndDark) {
    table().save(folder / "grid.csv");
    table(false).save(folder / "spiral.csv");
    for (const char* name : {"grid", "spiral"}) {
        chosen = QString::fromStdString((folder / (std::string(name) + ".csv")).string());
        trigger("openProject");
        ASSERT_TRUE(test::waitUntil([&] {
            auto* page =
                qobject_cast<ResultPage*>(window->findChild<QTabWidget*>("tabs")->currentWidget());
            return page != nullptr && page->tablePanel() != nullptr &&
                   page->tablePanel()->plot()->drawing().title.contains(name);
        })) << name;
        test::keepScreenshot(*window, (std::string("signature-table-") + name).c_str());
    }
    applyTheme(*qApp, ThemeMode::dark);
    QTest::qWait(50);
    test::keepScreenshot(*window, "signature-table-dark");
    applyTheme(*qApp, ThemeMode::light);
}

/// Runs `smat plot` without a display.
std::pair<int, std::string> runPlot(const QStringList& arguments) {
    QProcess process;
    auto environment = QProcessEnvironment::systemEnvironment();
    for (const auto* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
        environment.remove(name);
    }
    process.setProcessEnvironment(environment);
    process.start(QString(SMAT_BINARY_DIR) + "/bin/smat", QStringList{"plot"} + arguments);
    process.waitForFinished(120000);
    return {process.exitCode(), process.readAllStandardError().toStdString()};
}

TEST(TablePlotCommand, DrawsATableAndRefusesWhatDoesNotFit) {
    const auto folder = test::freshFolder("table-plot");
    table().save(folder / "grid.csv");
    const auto path = [&](const char* name) {
        return QString::fromStdString((folder / name).string());
    };
    for (const char* name : {"a.svg", "a.png"}) {
        const auto [code, errors] =
            runPlot({path("grid.csv"), "--quantity", "contrast_intensity@8-12um", "--db", "--at",
                     "range=3000", "-o", path(name)});
        EXPECT_EQ(code, 0) << errors;
    }
    const std::string svg = irsg::readFile(folder / "a.svg");
    EXPECT_NE(svg.find("cells are negative"), std::string::npos);
    EXPECT_NE(svg.find("dB over 1"), std::string::npos);
    EXPECT_FALSE(QImage(path("a.png")).isNull());
    const std::vector<std::pair<QStringList, const char*>> wrong{
        {{"--at", "range=2000"}, "1000, 3000"},
        {{"--at", "mach=0.5"}, "KEY=VALUE with one of range"},
        {{"--quantity", "irradiance"}, "contrast_intensity@3-5um"},
        {{"--log-x"}, "no abscissa"}};
    for (const auto& [options, says] : wrong) {
        const auto [code, errors] =
            runPlot(QStringList{path("grid.csv"), "-o", path("b.svg")} + options);
        EXPECT_EQ(code, 2) << errors;
        EXPECT_NE(errors.find(says), std::string::npos) << errors;
    }
}

} // namespace
} // namespace smat::gui
