#include "gui/plot/PlotExport.h"

#include <QFile>
#include <QImage>
#include <QSvgRenderer>
#include <gtest/gtest.h>

#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PolarPlot.h"
#include "gui/plot/ResultPlot.h"
#include "irsg/core/Errors.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/ResultTables.h"

namespace smat::gui {
namespace {

QByteArray contents(const std::filesystem::path& file) {
    QFile in(QString::fromStdString(file.string()));
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

/// Share of the pixels that are not white.
double inked(const QImage& picture) {
    long count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            count += picture.pixelColor(x, y).lightness() < 250 ? 1 : 0;
        }
    }
    return static_cast<double>(count) / picture.width() / picture.height();
}

class PlotExportTest : public ::testing::Test {
  protected:
    PlotExportTest() : cartesian(PlotStyle::paper()), polar(PlotStyle::paper()) {
        cartesian.setData(cartesianData({{"run", &range}}, "contrast_intensity"));
        polar.setData(polarData({{"run", &angles}}, "contrast_intensity"));
    }
    ResultTable range = test::rangeTable();
    ResultTable angles = test::polarTable("camera-azimuth");
    CartesianPlot cartesian;
    PolarPlot polar;
    std::filesystem::path folder = test::freshFolder("export");
};

TEST_F(PlotExportTest, PngHasTwiceTheSizeAndIsDrawnOn) {
    exportPlot(cartesian, folder / "a.png", {600, 400});
    exportPlot(polar, folder / "b.png", {500, 520});
    const QImage a(QString::fromStdString((folder / "a.png").string()));
    const QImage b(QString::fromStdString((folder / "b.png").string()));
    EXPECT_EQ(a.size(), QSize(1200, 800));
    EXPECT_EQ(b.size(), QSize(1000, 1040));
    EXPECT_GT(inked(a), 0.01);
    EXPECT_GT(inked(b), 0.01);
    EXPECT_LT(inked(a), 0.5);
}

TEST_F(PlotExportTest, SvgIsReadByAnSvgReaderAndHoldsItsWords) {
    exportPlot(cartesian, folder / "a.svg");
    exportPlot(polar, folder / "b.svg");
    EXPECT_TRUE(QSvgRenderer(contents(folder / "a.svg")).isValid());
    const QByteArray words = contents(folder / "b.svg");
    EXPECT_TRUE(QSvgRenderer(words).isValid());
    EXPECT_TRUE(words.contains("starboard"));
    EXPECT_TRUE(words.contains("330°"));
    EXPECT_TRUE(contents(folder / "a.svg").contains("Range (m)"));
}

TEST_F(PlotExportTest, PdfIsAPdf) {
    exportPlot(cartesian, folder / "a.pdf");
    exportPlot(polar, folder / "b.pdf");
    for (const auto* name : {"a.pdf", "b.pdf"}) {
        EXPECT_TRUE(contents(folder / name).startsWith("%PDF-")) << name;
        EXPECT_GT(contents(folder / name).size(), 2000) << name;
    }
}

TEST_F(PlotExportTest, CsvHoldsTheVisiblePart) {
    cartesian.setView({{1000.0, 2000.0}, {0.0, 1e4}});
    exportPlot(cartesian, folder / "a.csv");
    EXPECT_EQ(contents(folder / "a.csv").count('\n'), 1 + 3);
    exportPlot(polar, folder / "b.csv");
    EXPECT_EQ(contents(folder / "b.csv").count('\n'), 1 + 36);
}

TEST_F(PlotExportTest, ValuesCarryWhatTheyWarnOf) {
    angles.setWarning(9, "cut by the frame");
    angles.provenance.add("warning", "at 90 deg: cut by the frame");
    polar.setData(polarData({{"run", &angles}}, "contrast_intensity"));
    for (const PlotPart part : {PlotPart::all, PlotPart::visible}) {
        const QString values = plotValues(polar, part, ',');
        EXPECT_TRUE(values.startsWith("# warning: at 90 deg: cut by the frame\n"));
        EXPECT_TRUE(values.contains(",warning\n"));
        EXPECT_TRUE(values.contains("\n90,190,cut by the frame\n"));
        EXPECT_TRUE(values.contains("\n100,200,\n"));
    }
    EXPECT_FALSE(plotValues(polar, PlotPart::all, '\t').contains('#'));
    const QByteArray svg = plotSvg(polar, {500, 520});
    EXPECT_TRUE(svg.contains("hollow points: cut by the frame"));
}

TEST_F(PlotExportTest, RefusesUnknownSuffixesAndUnwritablePlaces) {
    EXPECT_THROW(exportPlot(cartesian, folder / "a.bmp"), irsg::InputError);
    EXPECT_THROW(exportPlot(cartesian, folder / "none"), irsg::InputError);
    EXPECT_THROW(exportPlot(polar, folder / "no" / "such" / "folder.png"), irsg::InputError);
}

TEST_F(PlotExportTest, PaperIsWhiteWhateverTheThemeOfTheWindow) {
    QPalette night;
    night.setColor(QPalette::Window, Qt::black);
    night.setColor(QPalette::Base, Qt::black);
    CartesianPlot dark(PlotStyle::screen(night));
    dark.setData(cartesian.data());
    exportPlot(dark, folder / "dark.png", {300, 200});
    const QImage picture(QString::fromStdString((folder / "dark.png").string()));
    EXPECT_EQ(picture.pixelColor(1, 1), QColor(Qt::white));
    EXPECT_LT(inked(picture), 0.5);
}

} // namespace
} // namespace smat::gui
