#include "gui/plot/PlotPanel.h"

#include <cmath>
#include <limits>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <QwtPolarCanvas>
#include <gtest/gtest.h>

#include "gui/plot/AxisLimitsDialog.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PolarPlot.h"
#include "gui/widgets/Theme.h"
#include "irsg/core/Errors.h"
#include "tests/gui/GuiEnvironment.h"

namespace smat::gui {
namespace {

PlotData hill(bool withErrors) {
    Curve curve{"hill", {}, {}};
    for (int i = 1; i <= 40; ++i) {
        curve.x.push_back(100.0 * i);
        curve.y.push_back(500.0 * std::exp(-0.02 * (i - 20) * (i - 20)) + 5.0);
        if (withErrors) {
            curve.error.push_back(30.0 + i);
        }
    }
    Curve flat{"flat", curve.x, std::vector<double>(40, 100.0)};
    return {.title = "Contrast intensity over range",
            .xTitle = "Range (m)",
            .yTitle = "Contrast intensity (W·sr⁻¹)",
            .curves = {curve, flat}};
}

PolarData rose() {
    Curve curve{"rose", {}, {}};
    for (int angle = 0; angle < 360; angle += 10) {
        curve.x.push_back(angle);
        curve.y.push_back(60.0 + 40.0 * std::cos(angle * 3.14159265 / 180.0));
        curve.error.push_back(8.0);
    }
    return {.title = "Contrast intensity over camera azimuth, view offset 0°",
            .conditions = {},
            .radiusTitle = "Contrast intensity (W·sr⁻¹)",
            .directionNote = "clockwise from the nose, 90° is starboard",
            .clockwise = true,
            .curves = {curve}};
}

void sendMouse(QWidget* to, QEvent::Type type, const QPointF& at, Qt::MouseButton button,
               Qt::MouseButtons buttons) {
    QMouseEvent event(type, at, to->mapToGlobal(at), button, buttons, Qt::NoModifier);
    QCoreApplication::sendEvent(to, &event);
}

class PlotPanelTest : public ::testing::Test {
  protected:
    PlotPanelTest() {
        dialogs.saveFile = [this](QWidget*, const QString&, const QStringList&, const QString&) {
            return chosen;
        };
        dialogs.tell = [this](QWidget*, const QString&, const QStringList& sentences) {
            told += sentences;
        };
        dialogs.run = [this](QDialog& dialog) {
            dialog.show();
            QTest::qWait(10);
            onDialog(dialog);
            return true;
        };
        cartesian = std::make_unique<PlotPanel>(PlotKind::cartesian, dialogs);
        cartesian->cartesian()->setData(hill(true));
        polar = std::make_unique<PlotPanel>(PlotKind::polar, dialogs);
        polar->polar()->setData(rose());
        for (auto* panel : {cartesian.get(), polar.get()}) {
            panel->resize(760, 620);
            panel->refresh();
            panel->show();
        }
        QTest::qWait(20);
    }
    void drag(PlotSurface& surface, Qt::MouseButton button, const QPointF& from,
              const QPointF& to) {
        sendMouse(surface.sheet(), QEvent::MouseButtonPress, from, button, button);
        sendMouse(surface.sheet(), QEvent::MouseMove, to, Qt::NoButton, button);
        sendMouse(surface.sheet(), QEvent::MouseButtonRelease, to, button, Qt::NoButton);
    }
    Dialogs dialogs;
    QString chosen;
    QStringList told;
    std::function<void(QDialog&)> onDialog = [](QDialog&) {};
    std::unique_ptr<PlotPanel> cartesian, polar;
};

TEST_F(PlotPanelTest, BothPlotsZoomByTheSameMouseAndTakeItBack) {
    for (auto* panel : {cartesian.get(), polar.get()}) {
        panel->action("crosshair")->trigger(); // it stays where the mouse is
        PlotSurface& surface = panel->surface();
        const QPointF middle(surface.sheet()->rect().center());
        const auto picture = [&] {
            QTest::qWait(5); // axes are laid out by an event
            return surface.widget()->grab().toImage();
        };
        surface.widget()->setFocus();
        const QImage whole = picture();
        EXPECT_FALSE(panel->action("undoZoom")->isEnabled());
        drag(surface, Qt::LeftButton, middle - QPointF(60.0, 80.0), middle + QPointF(70.0, 50.0));
        const QImage part = picture();
        EXPECT_NE(part, whole);
        EXPECT_TRUE(panel->action("undoZoom")->isEnabled());
        drag(surface, Qt::RightButton, middle, middle + QPointF(40.0, 30.0));
        EXPECT_NE(picture(), part);
        panel->action("undoZoom")->trigger();
        EXPECT_EQ(picture(), part);
        panel->action("undoZoom")->trigger();
        EXPECT_EQ(picture(), whole);
        EXPECT_FALSE(panel->action("undoZoom")->isEnabled());

        // The keyboard does the same.
        QTest::keyClick(surface.widget(), Qt::Key_Plus);
        QTest::keyClick(surface.widget(), Qt::Key_Left);
        EXPECT_NE(picture(), whole);
        QTest::keyClick(surface.widget(), Qt::Key_Backspace);
        QTest::keyClick(surface.widget(), Qt::Key_Backspace);
        EXPECT_EQ(picture(), whole);
    }
}

TEST_F(PlotPanelTest, ARightClickOpensTheMenuAndARightDragDoesNot) {
    for (auto* panel : {cartesian.get(), polar.get()}) {
        PlotSurface& surface = panel->surface();
        const QPointF middle(surface.sheet()->rect().center());
        drag(surface, Qt::RightButton, middle, middle + QPointF(50.0, 0.0));
        EXPECT_EQ(panel->findChild<QMenu*>("plotMenu"), nullptr);
        drag(surface, Qt::RightButton, middle, middle + QPointF(1.0, 1.0));
        auto* menu = panel->findChild<QMenu*>("plotMenu");
        ASSERT_NE(menu, nullptr);
        EXPECT_TRUE(menu->isVisible());
        const auto count = menu->actions().size();
        EXPECT_GE(count, 12);
        // What it leads to may end it in Qt: it is kept, and filled anew.
        menu->close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        drag(surface, Qt::RightButton, middle, middle + QPointF(1.0, 1.0));
        ASSERT_EQ(panel->findChild<QMenu*>("plotMenu"), menu);
        EXPECT_TRUE(menu->isVisible());
        EXPECT_EQ(menu->actions().size(), count);
        if (panel == cartesian.get()) {
            test::keepScreenshot(*menu, "plot-menu");
        }
        menu->close();
        QTest::qWait(10);
    }
}

TEST_F(PlotPanelTest, AxisLimitsAreTakenToEveryDigit) {
    onDialog = [](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("limit1From")->setText("123.456789012345");
        dialog.findChild<QLineEdit*>("limit1To")->setText("2e3");
        auto* low = dialog.findChild<QLineEdit*>("limit2From");
        low->setText("700");
        EXPECT_FALSE(dynamic_cast<AxisLimitsDialog&>(dialog).isAcceptable());
        EXPECT_TRUE(dialog.findChild<QLabel*>("problems")->text().contains("W·sr⁻¹"));
        test::keepScreenshot(dialog, "axis-limits");
        low->setText("-0.25");
        EXPECT_TRUE(dynamic_cast<AxisLimitsDialog&>(dialog).isAcceptable());
    };
    cartesian->action("axisLimits")->trigger();
    const auto view = cartesian->cartesian()->view();
    EXPECT_EQ(view.x, (Interval{123.456789012345, 2000.0}));
    EXPECT_EQ(view.y.minimum, -0.25);
    cartesian->action("undoZoom")->trigger();
    EXPECT_EQ(cartesian->cartesian()->view().x.maximum, 4000.0);

    onDialog = [](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("limit1From")->setText("20");
        dialog.findChild<QLineEdit*>("limit1To")->setText("80");
    };
    polar->action("axisLimits")->trigger();
    EXPECT_EQ(polar->polar()->radiusLimits(), (Interval{20.0, 80.0}));
    const QPointF pole = polar->polar()->plotRect().center();
    // What is below the limits is in the middle, never on the other side.
    EXPECT_EQ(polar->polar()->canvasPoint(90.0, 5.0), pole);
    polar->action("undoZoom")->trigger();
    EXPECT_EQ(polar->polar()->radiusLimits().minimum, 0.0);
}

TEST_F(PlotPanelTest, LimitsThatAreNotTypedStayExactThoughFewerDigitsAreShown) {
    const CartesianPlot::View view{{1.0 / 3.0, 2000.0 / 3.0}, {1e-18 / 7.0, 8.0 / 7.0}};
    cartesian->cartesian()->setView(view);
    onDialog = [](QDialog& dialog) {
        for (const char* name : {"limit1From", "limit1To", "limit2From", "limit2To"}) {
            EXPECT_LE(dialog.findChild<QLineEdit*>(name)->text().size(), 11) << name;
        }
    };
    cartesian->action("axisLimits")->trigger();
    EXPECT_EQ(cartesian->cartesian()->view(), view);
}

TEST_F(PlotPanelTest, ButtonsOfAxesKeepTheirShortWords) {
    for (const auto& [panel, name, word] :
         {std::tuple(cartesian.get(), "logX", "log x"),
          std::tuple(cartesian.get(), "logY", "log y"), std::tuple(polar.get(), "decibel", "dB")}) {
        auto* button = panel->findChild<QToolButton*>(name);
        ASSERT_NE(button, nullptr) << name;
        EXPECT_EQ(button->text(), word);
        button->click();
        EXPECT_TRUE(panel->action(name)->isChecked());
        EXPECT_EQ(button->text(), word);
    }
}

TEST_F(PlotPanelTest, LogarithmicAxesRefuseLimitsThatHaveNoLogarithm) {
    cartesian->action("logY")->trigger();
    EXPECT_TRUE(cartesian->cartesian()->isLogarithmic(QwtPlot::yLeft));
    const auto before = cartesian->cartesian()->view();
    onDialog = [](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("limit2From")->setText("-1");
        EXPECT_TRUE(dialog.findChild<QLabel*>("problems")->text().contains("logarithmic"));
    };
    cartesian->action("axisLimits")->trigger();
    EXPECT_EQ(cartesian->cartesian()->view(), before);
    cartesian->action("logX")->trigger();
    test::keepScreenshot(*cartesian, "panel-logarithmic");
    polar->action("decibel")->trigger();
    EXPECT_EQ(polar->polar()->radiusScale(), RadiusScale::decibel);
    test::keepScreenshot(*polar, "panel-decibel");
}

TEST_F(PlotPanelTest, CopiesPictureAndValues) {
    test::keepClipboard();
    auto* clipboard = QApplication::clipboard();
    cartesian->action("copyPicture")->trigger();
    EXPECT_EQ(clipboard->image().size(), 2 * cartesianPaper);
    EXPECT_TRUE(clipboard->mimeData()->data("image/svg+xml").contains("Range (m)"));

    cartesian->cartesian()->setView({{950.0, 2050.0}, {0.0, 600.0}});
    cartesian->action("copyValues")->trigger();
    EXPECT_EQ(clipboard->text().count('\n'), 1 + 11);
    EXPECT_TRUE(clipboard->text().contains('\t'));
    EXPECT_TRUE(clipboard->mimeData()->data("text/csv").contains("Error of"));
    cartesian->action("copyAllValues")->trigger();
    EXPECT_EQ(clipboard->text().count('\n'), 1 + 40);

    // Hidden curves are not visible values.
    cartesian->cartesian()->setCurveVisible(1, false);
    cartesian->action("copyValues")->trigger();
    EXPECT_FALSE(clipboard->text().contains("flat"));
    polar->action("copyAllValues")->trigger();
    EXPECT_EQ(clipboard->text().count('\n'), 1 + 36);
    polar->polar()->zoomAt(polar->polar()->canvasPoint(0.0, 100.0), 0.3);
    polar->action("copyValues")->trigger();
    EXPECT_LT(clipboard->text().count('\n'), 1 + 20);
    EXPECT_GT(clipboard->text().count('\n'), 1);
}

TEST_F(PlotPanelTest, SavesPicturesAndValues) {
    const auto folder = test::freshFolder("panel");
    const auto path = [&](const char* name) {
        return QString::fromStdString((folder / name).string());
    };
    for (auto* panel : {cartesian.get(), polar.get()}) {
        for (const char* name : {"a.svg", "a.pdf", "a.png"}) {
            chosen = path(name);
            panel->action("savePlot")->trigger();
            EXPECT_GT(QFile(chosen).size(), 1000) << name;
        }
        chosen = path("v.csv");
        panel->action("saveAllValues")->trigger();
        EXPECT_GT(QFile(chosen).size(), 300);
        panel->action("saveValues")->trigger();
    }
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    chosen = path("no/such/place.csv");
    cartesian->action("saveValues")->trigger();
    EXPECT_EQ(told.size(), 1);
}

TEST_F(PlotPanelTest, ErrorsAreBandsThatCanBeHidden) {
    for (auto* panel : {cartesian.get(), polar.get()}) {
        EXPECT_TRUE(panel->action("errorBands")->isEnabled());
        const QImage with = panel->surface().widget()->grab().toImage();
        panel->action("errorBands")->trigger();
        EXPECT_NE(panel->surface().widget()->grab().toImage(), with);
        panel->action("errorBands")->trigger();
        EXPECT_EQ(panel->surface().widget()->grab().toImage(), with);
    }
    test::keepScreenshot(*cartesian, "panel-error-band");
    test::keepScreenshot(*polar, "panel-polar-error-band");
    EXPECT_TRUE(cartesian->cartesian()
                    ->readoutAt(QPointF(cartesian->surface().sheet()->rect().center()))
                    .contains("±"));
    cartesian->cartesian()->setData(hill(false));
    cartesian->refresh();
    EXPECT_FALSE(cartesian->action("errorBands")->isEnabled());
}

TEST_F(PlotPanelTest, ErrorsAroundMissingPointsLeaveGaps) {
    auto data = hill(true);
    data.curves.pop_back();
    data.curves[0].y[10] = std::numeric_limits<double>::quiet_NaN();
    data.curves[0].error[25] = std::numeric_limits<double>::quiet_NaN();
    data.curves[0].error[39] = 1e6; // beyond the frame, below 0
    CartesianPlot& plot = *cartesian->cartesian();
    plot.setData(data);
    plot.setLogarithmic(QwtPlot::yLeft, true);
    plot.setView({{100.0, 4000.0}, {1.0, 1000.0}});
    QTest::qWait(10);
    test::keepScreenshot(*cartesian, "panel-error-gaps");
    const QImage seen = plot.canvas()->grab().toImage();
    const QColor line = PlotStyle::screen(plot.palette()).curve(0);
    // How much of a column is in the colour of the curve, be it thin as a band's.
    const auto tinted = [&](double x) {
        const int column = qRound(plot.canvasMap(QwtPlot::xBottom).transform(x));
        int pixels = 0;
        for (int y = 0; y < plot.canvas()->height(); ++y) {
            const QColor color = test::colorAt(seen, QPointF(column, y));
            const int ofLine = line.blue() - line.red(), ofPixel = color.blue() - color.red();
            pixels += std::abs(ofPixel) > 12 && (ofPixel > 0) == (ofLine > 0);
        }
        return pixels;
    };
    EXPECT_GT(tinted(900.0), 10); // a band about the line
    EXPECT_EQ(tinted(1120.0), 0); // no sample: neither band nor line
    EXPECT_GT(tinted(2000.0), 10);
    EXPECT_GT(tinted(2610.0), 0); // no error: the line alone
    EXPECT_LT(tinted(2610.0), 10);

    auto round = rose();
    PolarPlot& circle = *polar->polar();
    const QPointF at = circle.canvasPoint(90.0, round.curves[0].y[9]);
    const QColor first = PlotStyle::screen(circle.palette()).curve(0);
    circle.setData(round);
    QTest::qWait(10);
    EXPECT_TRUE(test::showsColorAt(*circle.canvas(), at, first));
    round.curves[0].y[9] = std::numeric_limits<double>::infinity();
    circle.setData(round);
    QTest::qWait(10);
    EXPECT_FALSE(test::showsColorAt(*circle.canvas(), circle.canvasPoint(90.0, 60.0), first));
    EXPECT_TRUE(test::showsColorAt(*circle.canvas(), circle.canvasPoint(180.0, 20.0), first));
    round.curves[0].error[3] = 1e9; // far out of the circle
    circle.setData(round);
    polar->action("decibel")->trigger();
    QTest::qWait(10);
    EXPECT_FALSE(test::showsColorAt(*circle.canvas(), circle.canvasPoint(90.0, 60.0), first));
    EXPECT_TRUE(test::showsColorAt(*circle.canvas(), circle.canvasPoint(180.0, 20.0), first));
}

TEST_F(PlotPanelTest, TheCrosshairCanBeHidden) {
    QWidget* sheet = cartesian->surface().sheet();
    const QPointF middle(sheet->rect().center());
    const QImage bare = sheet->grab().toImage();
    sendMouse(sheet, QEvent::MouseMove, middle, Qt::NoButton, Qt::NoButton);
    QTest::qWait(10);
    EXPECT_NE(sheet->grab().toImage(), bare);
    test::keepScreenshot(*cartesian, "panel-crosshair");
    cartesian->action("crosshair")->trigger();
    EXPECT_EQ(sheet->grab().toImage(), bare);
}

TEST_F(PlotPanelTest, FollowsTheThemeAndKeepsItsView) {
    cartesian->cartesian()->setView({{500.0, 900.0}, {10.0, 90.0}});
    cartesian->cartesian()->setCurveVisible(1, false);
    applyTheme(*qApp, ThemeMode::dark);
    QTest::qWait(30);
    EXPECT_EQ(cartesian->cartesian()->view().x, (Interval{500.0, 900.0}));
    EXPECT_FALSE(cartesian->cartesian()->isCurveVisible(1));
    EXPECT_LT(cartesian->cartesian()->grab().toImage().pixelColor(3, 3).lightness(), 90);
    EXPECT_LT(polar->polar()->grab().toImage().pixelColor(3, 3).lightness(), 90);
    cartesian->action("resetView")->trigger();
    test::keepScreenshot(*cartesian, "panel-dark");
    test::keepScreenshot(*polar, "panel-polar-dark");
    applyTheme(*qApp, ThemeMode::light);
}

TEST_F(PlotPanelTest, KnowsItsActionsAlone) {
    EXPECT_THROW(cartesian->action("decibel"), irsg::LogicError);
    EXPECT_THROW(polar->action("logX"), irsg::LogicError);
}

} // namespace
} // namespace smat::gui
