#include <QFile>
#include <QImage>
#include <QProcess>
#include <gtest/gtest.h>

#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/ResultTables.h"

namespace smat::gui {
namespace {

struct Outcome {
    int code = -1;
    QString errors;
};

/// Runs `smat plot` as a person without any display would, with the fonts of this machine or those
/// that a configuration names.
Outcome runPlot(const QStringList& arguments, const QString& fonts = {}) {
    QProcess process;
    auto environment = QProcessEnvironment::systemEnvironment();
    for (const auto* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
        environment.remove(name);
    }
    if (!fonts.isEmpty()) {
        environment.insert("FONTCONFIG_FILE", fonts);
    }
    process.setProcessEnvironment(environment);
    process.start(QString(SMAT_BINARY_DIR) + "/bin/smat", QStringList{"plot"} + arguments);
    process.waitForFinished(120000);
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardError())};
}

class PlotCommandTest : public ::testing::Test {
  protected:
    PlotCommandTest() {
        test::polarTable("camera-azimuth").save(folder / "polar.csv");
        test::polarTable("model-yaw").save(folder / "yaw.json");
        test::rangeTable().save(folder / "range.csv");
    }
    QString path(const char* name) const {
        return QString::fromStdString((folder / name).string());
    }
    std::filesystem::path folder = test::freshFolder("command");
};

TEST_F(PlotCommandTest, DrawsEveryKindOfFileWithoutADisplay) {
    for (const auto* output : {"a.svg", "a.png", "a.pdf", "a.csv"}) {
        const auto outcome = runPlot({path("polar.csv"), "-o", path(output)});
        EXPECT_EQ(outcome.code, 0) << outcome.errors.toStdString();
        EXPECT_GT(QFile(path(output)).size(), 300) << output;
    }
    EXPECT_EQ(runPlot({path("yaw.json"), "--db", "-o", path("b.png")}).code, 0);
    EXPECT_EQ(runPlot({path("range.csv"), "--log-x", "--log-y", "--quantity", "intensity", "-o",
                       path("c.png")})
                  .code,
              0);
    EXPECT_FALSE(QImage(path("c.png")).isNull());
}

TEST_F(PlotCommandTest, DrawsTheSameWhereThereIsNoFont) {
    QFile fonts(path("fonts.conf"));
    ASSERT_TRUE(fonts.open(QIODevice::WriteOnly));
    fonts.write(("<fontconfig><dir>" + path("none") + "</dir><cachedir>" + path("cache") +
                 "</cachedir></fontconfig>")
                    .toUtf8());
    fonts.close();
    EXPECT_EQ(runPlot({path("polar.csv"), "-o", path("with.png")}).code, 0);
    EXPECT_EQ(runPlot({path("polar.csv"), "-o", path("without.png")}, path("fonts.conf")).code, 0);
    const QImage with(path("with.png")), without(path("without.png"));
    ASSERT_FALSE(with.isNull());
    ASSERT_EQ(with.size(), without.size());
    // A legend may stand a part of a pixel beside its place: some hundred pixels, where all words
    // have ten thousand.
    int different = 0;
    for (int y = 0; y < with.height(); ++y) {
        for (int x = 0; x < with.width(); ++x) {
            different += with.pixel(x, y) != without.pixel(x, y) ? 1 : 0;
        }
    }
    EXPECT_LT(different, 1000);
}

TEST_F(PlotCommandTest, RefusesWhatItCannotDrawWithOneSentenceAndExitCodeTwo) {
    QFile broken(path("broken.csv"));
    ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
    broken.write("range [m],intensity [W sr-1]\n500,seven\n");
    broken.close();
    struct Row {
        const char* name;
        QStringList arguments;
        const char* says;
    };
    const Row rows[] = {
        {"missing file", {path("none.csv"), "-o", path("x.svg")}, "none.csv"},
        {"no number", {path("broken.csv"), "-o", path("x.svg")}, "seven"},
        {"unknown suffix", {path("range.csv"), "-o", path("x.bmp")}, ".svg"},
        {"unknown column",
         {path("range.csv"), "--quantity", "colour", "-o", path("x.svg")},
         "colour"},
        {"decibels over range", {path("range.csv"), "--db", "-o", path("x.svg")}, "--db"},
        {"logarithmic angle", {path("polar.csv"), "--log-x", "-o", path("x.svg")}, "--log-x"},
        {"mixed sweeps", {path("polar.csv"), path("yaw.json"), "-o", path("x.svg")}, "model-yaw"},
        {"no output", {path("range.csv")}, "--out"},
    };
    for (const auto& row : rows) {
        const auto outcome = runPlot(row.arguments);
        EXPECT_EQ(outcome.code, 2) << row.name << ": " << outcome.errors.toStdString();
        EXPECT_TRUE(outcome.errors.contains(row.says))
            << row.name << ": " << outcome.errors.toStdString();
        EXPECT_FALSE(QFile::exists(path("x.svg"))) << row.name;
    }
}

} // namespace
} // namespace smat::gui
