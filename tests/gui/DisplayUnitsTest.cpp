// The one table of units that plots, images and read-outs are shown in.
#include "gui/widgets/DisplayUnits.h"

#include <algorithm>
#include <cmath>

#include <QComboBox>
#include <QLabel>
#include <QwtPlotIntervalCurve>
#include <QwtScaleDiv>
#include <gtest/gtest.h>

#include "gui/analysis/MonteCarloPlots.h"
#include "gui/analysis/SummaryText.h"
#include "gui/image/ColorBar.h"
#include "gui/image/FiguresTable.h"
#include "gui/image/ImageView.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotExport.h"
#include "gui/plot/PolarPlot.h"
#include "gui/plot/ResultPlot.h"
#include "gui/settings/Preferences.h"
#include "irsg/image/ApparentTemperature.h"
#include "tests/gui/ComparisonFixture.h"
#include "tests/gui/ImageViewFixture.h"
#include "tests/gui/ResultTables.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

using test::ImageViewTest;
using Spectral = DisplayUnits::Spectral;

/// Units while it lives.
class Shown {
  public:
    explicit Shown(const DisplayUnits& units) { DisplayUnitsWatch::instance().set(units); }
    ~Shown() { DisplayUnitsWatch::instance().set({}); }
    Shown(const Shown&) = delete;
    Shown& operator=(const Shown&) = delete;
};

TEST(DisplayUnits, HaveKnownValues) {
    const DisplayUnits all{Spectral::wavelength, true, true};
    const auto shown = [&](const char* unit, double value) {
        return shownUnitOf(unit, all)->shown(value);
    };
    EXPECT_DOUBLE_EQ(shown("cm-1", 2500.0), 4.0);
    EXPECT_DOUBLE_EQ(shown("K", 273.15), 0.0);
    EXPECT_DOUBLE_EQ(shown("W sr-1", 100.0), 20.0);
    EXPECT_TRUE(std::isnan(shown("W sr-1", -1.0)));
    EXPECT_EQ(shownUnitOf("um", all), nullptr);
    EXPECT_EQ(shownUnitOf("W m-2", all), nullptr);
    for (const char* unit : {"cm-1", "K", "W sr-1", "um", "W m-2 sr-1"}) {
        EXPECT_EQ(shownUnitOf(unit, DisplayUnits()), nullptr) << unit;
    }
    EXPECT_DOUBLE_EQ(shownUnitOf("um", {.spectral = Spectral::wavenumber})->shown(10.0), 1000.0);
    for (const char* unit : {"cm-1", "K", "W sr-1"}) {
        const ShownUnit& row = *shownUnitOf(unit, all);
        EXPECT_NEAR(row.back(row.shown(321.0)), 321.0, 1e-10) << unit;
        // The error is the slope times the error.
        EXPECT_NEAR(row.error(321.0, 1e-4), std::abs(row.shown(321.0 + 1e-4) - row.shown(321.0)),
                    1e-9)
            << unit;
    }
    const Shown celsius({.celsius = true});
    EXPECT_EQ(valueWithUnit(300.0, "K"), "26.85 °C");
    EXPECT_EQ(valueWithUnit(300.0, "m"), "300 m");
}

PlotData spectrum() {
    PlotData data;
    data.xTitle = "Wavenumber (cm⁻¹)";
    data.yTitle = "Intensity (W·sr⁻¹)";
    data.xUnit = "cm-1";
    data.yUnit = "W sr-1";
    data.curves = {{"run", {2000.0, 2500.0, 4000.0}, {1.0, 10.0, 100.0}, {0.1, 0.1, 0.1}}};
    return data;
}

TEST(DisplayUnits, APlotFollowsThemAndItsValuesKeepTheirs) {
    CartesianPlot plot(PlotStyle::paper());
    plot.setData(spectrum());
    const QString values = plotValues(plot, PlotPart::all);
    {
        const Shown units({Spectral::wavelength, true, false});
        EXPECT_EQ(plot.data().xTitle, "Wavelength (µm)");
        EXPECT_EQ(plot.data().yTitle, "Intensity (dB re 1 W·sr⁻¹)");
        EXPECT_EQ(plot.data().curves[0].x, (std::vector<double>{2.5, 4.0, 5.0}));
        EXPECT_EQ(plot.data().curves[0].y, (std::vector<double>{20.0, 10.0, 0.0}));
        EXPECT_NEAR(plot.view().x.maximum, 5.0, 1e-12);
        EXPECT_EQ(plotValues(plot, PlotPart::all), values);
        EXPECT_EQ(plotValues(plot, PlotPart::visible), values);
        plot.setView({{2.0, 4.5}, plot.view().y});
        EXPECT_EQ(plotValues(plot, PlotPart::visible).count('\n'), 3);
        EXPECT_TRUE(plotValues(plot, PlotPart::visible).startsWith("Wavenumber (cm⁻¹)"));
    }
    EXPECT_EQ(plot.data().xTitle, "Wavenumber (cm⁻¹)");
    EXPECT_EQ(plot.data().curves[0].y, (std::vector<double>{1.0, 10.0, 100.0}));
}

TEST(DisplayUnits, APolarPlotInDecibelsHasNoOtherOnes) {
    const auto table = test::polarTable();
    PolarPlot plot(PlotStyle::paper());
    plot.setData(polarData({{"run", &table}}, "contrast_intensity"));
    plot.setRadiusScale(RadiusScale::decibel);
    const Shown units({Spectral::asCalculated, true, false});
    EXPECT_EQ(plot.radiusScale(), RadiusScale::linear);
    EXPECT_FALSE(plot.canBeDecibel());
    EXPECT_TRUE(plot.data().radiusTitle.contains("dB re 1"));
    EXPECT_DOUBLE_EQ(plot.data().curves[0].y[9], 10.0 * std::log10(190.0));
    EXPECT_TRUE(plotValues(plot, PlotPart::all).contains("W·sr⁻¹"));
}

TEST(DisplayUnits, DifferencesAndErrorsAreNoTemperatures) {
    ResultTable table;
    table.add("range", "m");
    table.add("difference_temperature", "K");
    table.addRow({1.0, 2.0});
    table.addRow({2.0, 3.0});
    const Shown units({.celsius = true});
    CartesianPlot plot(PlotStyle::paper());
    plot.setData(cartesianData({{"run", &table}}, "difference_temperature"));
    EXPECT_EQ(plot.data().curves[0].y[0], 2.0);
}

TEST_F(ImageViewTest, TemperaturesAreReadInTheUnitThatIsPreferred) {
    const auto place = [&](const std::string& name) {
        for (std::size_t i = 0; i < view.image().channels.size(); ++i) {
            if (view.image().channels[i].name == name) {
                return static_cast<int>(i);
            }
        }
        return -1;
    };
    view.setShownPlane(place(irsg::apparentTemperatureChannel));
    const auto limits = view.colorBar()->limits();
    const Shown units({.celsius = true});
    EXPECT_TRUE(view.colorBar()->title().contains("(°C)"));
    EXPECT_NEAR(view.colorBar()->limits().low, limits.low - 273.15, 1e-3);
    EXPECT_TRUE(view.readoutAt(2, 0).contains("°C"));
    EXPECT_TRUE(view.statistics().contains("min"));
    // What is exported has its own unit.
    EXPECT_EQ(view.image().find(irsg::apparentTemperatureChannel)->unit, "K");
    // Limits of a project are those of the plane.
    view.setLimits(300.0, 400.0);
    EXPECT_NEAR(view.colorBar()->limits().low, 26.85, 1e-9);
    DisplayUnitsWatch::instance().set({});
    EXPECT_NEAR(view.colorBar()->limits().low, 300.0, 1e-9);
    EXPECT_NEAR(view.colorBar()->limits().high, 400.0, 1e-9);
}

TEST(DisplayUnits, WordsOfEachKindOfValue) {
    const struct {
        const char* name;
        DisplayUnits units;
        SummaryItem item;
        const char* line;
    } rows[] = {
        {"as stored", {}, {"Mean there", 100.0, "W sr-1"}, "Mean there: 100 W·sr⁻¹"},
        {"decibels",
         {.decibel = true},
         {"Mean there", 100.0, "W sr-1"},
         "Mean there: 20 dB re 1 W·sr⁻¹"},
        {"no decibels below 0",
         {.decibel = true},
         {"Mean there", -4.0, "W sr-1"},
         "Mean there: -4 W·sr⁻¹"},
        {"a spread",
         {.decibel = true},
         {"Largest standard deviation", 100.0, "W sr-1"},
         "Largest standard deviation: 100 W·sr⁻¹"},
        {"an error",
         {.celsius = true},
         {"Numerical error there", 2.0, "K"},
         "Numerical error there: 2 K"},
        {"a temperature",
         {.celsius = true},
         {"Highest pixel", 300.0, "K"},
         "Highest pixel: 26.85 °C"},
        {"a wavelength",
         {.spectral = Spectral::wavenumber},
         {"Peak", 4.0, "um"},
         "Peak: 2500 cm⁻¹"},
        {"a range",
         {Spectral::wavelength, true, true},
         {"Largest range", 7.0, "m"},
         "Largest range: 7 m"},
    };
    for (const auto& row : rows) {
        const Shown units(row.units);
        EXPECT_EQ(summaryLine(row.item), QString(row.line)) << row.name;
    }
}

TEST(DisplayUnits, MonteCarloShowsBandsAndHistogramInThem) {
    MonteCarloData data;
    data.analysis.table.provenance.add("quantity", "intensity");
    data.options.percentiles = {5.0, 95.0};
    data.unit = "W sr-1";
    data.abscissaKey = "wavelength";
    data.abscissaUnit = "um";
    data.abscissae = {4.0, 5.0};
    data.bands = {""};
    data.values = {{10.0, 100.0, 1000.0}, {10.0, 10.0, 10.0}};
    data.nominal = {100.0, 10.0};
    for (const char* key : {"mean", "p5", "p95"}) {
        data.analysis.table.add(key, "W sr-1");
    }
    data.analysis.table.addRow({370.0, 10.0, 1000.0});
    data.analysis.table.addRow({10.0, 10.0, 10.0});
    MonteCarloPlots plots;
    plots.setData(data);
    auto* bands = plots.findChild<CartesianPlot*>("monteCarloBands");
    auto* histogram = plots.findChild<QwtPlot*>("monteCarloHistogram");
    const auto tube = [&] {
        const auto items = bands->itemList(QwtPlotItem::Rtti_PlotIntervalCurve);
        return static_cast<QwtPlotIntervalCurve*>(items.front())->sample(0);
    };
    const auto axis = [&] { return histogram->axisTitle(QwtPlot::xBottom).text(); };
    EXPECT_EQ(tube().value, 4.0);
    EXPECT_EQ(tube().interval.maxValue(), 1000.0);
    EXPECT_FALSE(axis().contains("dB"));
    const Shown units({Spectral::wavenumber, true, false});
    EXPECT_EQ(bands->data().xTitle, "Wavenumber (cm⁻¹)");
    EXPECT_EQ(tube().value, 2000.0); // x ascends
    const auto items = bands->itemList(QwtPlotItem::Rtti_PlotIntervalCurve);
    const auto last = static_cast<QwtPlotIntervalCurve*>(items.front())->sample(1);
    EXPECT_EQ(last.value, 2500.0);
    EXPECT_DOUBLE_EQ(last.interval.minValue(), 10.0);
    EXPECT_DOUBLE_EQ(last.interval.maxValue(), 30.0);
    EXPECT_TRUE(axis().contains("dB re 1")) << axis().toStdString();
    EXPECT_LT(histogram->axisScaleDiv(QwtPlot::xBottom).upperBound(), 35.0);
    EXPECT_EQ(plots.findChild<QLabel*>("histogramPlaceText")->text(), "2500 cm⁻¹");
}

class UnitsOfComparison : public test::ComparisonTest {};

TEST_F(UnitsOfComparison, TemperaturesOfBothImagesAndDifferencesAsTheyAre) {
    const auto image = [](float temperature_K) {
        irsg::RadianceImage made(8, 6);
        irsg::ImageChannel& plane = made.channel(irsg::apparentTemperatureChannel);
        plane.unit = "K";
        for (float& value : plane.values) {
            value = temperature_K;
        }
        return made;
    };
    open(image(300.0F), image(290.0F));
    auto* box = window->findChild<QComboBox*>("comparedPlane");
    ASSERT_NE(box, nullptr);
    const int plane = box->findText("apparent temperature", Qt::MatchContains);
    ASSERT_GE(plane, 0);
    box->setCurrentIndex(plane);
    emit box->activated(plane);
    ASSERT_TRUE(test::waitUntil([&] { return !window->isBusy(); }));
    EXPECT_TRUE(window->readoutAt(1, 1).contains("A  300 K"))
        << window->readoutAt(1, 1).toStdString();
    const Shown units({.celsius = true});
    const QString text = window->readoutAt(1, 1);
    EXPECT_TRUE(text.contains("A  26.85 °C") && text.contains("B  16.85 °C")) << text.toStdString();
    EXPECT_TRUE(text.contains("A − B  10 K")) << text.toStdString();
    const QString numbers = window->findChild<FiguresTable*>("comparisonNumbers")->allText();
    EXPECT_TRUE(numbers.contains("A 26.85 °C, B 16.85 °C")) << numbers.toStdString();
    EXPECT_TRUE(numbers.contains("Mean error, A − B\t10 K")) << numbers.toStdString();
    const auto bars = window->findChildren<ColorBar*>();
    EXPECT_TRUE(std::ranges::any_of(
        bars, [](const ColorBar* bar) { return bar->title().contains("(°C)"); }));
    EXPECT_TRUE(test::waitUntil([&] { return !window->isBusy(); }));
}

class UnitPreferences : public test::WindowFixture {};

TEST_F(UnitPreferences, AreKeptAndTakenAtOnce) {
    onDialog = [&](QDialog& dialog) {
        dialog.findChild<QComboBox*>("spectralUnit")->setCurrentIndex(1);
        dialog.findChild<QComboBox*>("intensityUnit")->setCurrentIndex(1);
        dialog.findChild<QComboBox*>("temperatureUnit")->setCurrentIndex(1);
    };
    trigger("preferences");
    EXPECT_EQ(DisplayUnits::current(), (DisplayUnits{Spectral::wavelength, true, true}));
    EXPECT_EQ(Preferences::load().units, DisplayUnits::current());
    Preferences().save();
    DisplayUnitsWatch::instance().set({});
}

} // namespace
} // namespace smat::gui
