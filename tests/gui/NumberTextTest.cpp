#include "gui/widgets/NumberText.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

#include "gui/settings/SettingForm.h"
#include "gui/settings/TypedSetting.h"
#include "gui/widgets/NumberBoxes.h"
#include "gui/widgets/NumberField.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {
namespace {

/// What people type into a field in m.
struct Typed {
    const char* text;
    std::optional<double> value;
    const char* problem = "is not a number";
};

const Typed inMetres[] = {
    {"12", 12.0},
    {"12.5", 12.5},
    {"12,5", 12.5},
    {" 12,5 ", 12.5},
    {"+7", 7.0},
    {"-7", -7.0},
    {"\u2212"
     "7,25",
     -7.25},
    {".5", 0.5},
    {",5", 0.5},
    {"5.", 5.0},
    {"5,", 5.0},
    {"2e5", 2e5},
    {"2E5", 2e5},
    {"2,5e-3", 2.5e-3},
    {"1.5e+02", 150.0},
    {"1,234", 1.234},
    {"007", 7.0},
    {"12 m", 12.0},
    {"12m", 12.0},
    {"1,5 km", 1500.0},
    {"0.1km", 100.0},
    {"2e2 cm", 2.0},
    {"30 mm", 0.03},
    {"10 \u00b5m", 1e-5},
    {"1000 ft", 304.8},
    {"1 NM", 1852.0},
    {"3 nmi", 5556.0},
    {"", std::nullopt, "nothing stands there"},
    {"  ", std::nullopt, "nothing stands there"},
    {"abc", std::nullopt},
    {"-", std::nullopt},
    {",", std::nullopt},
    {"nan", std::nullopt},
    {"inf", std::nullopt},
    {"1e999", std::nullopt},
    {"0x10", std::nullopt, "'x10' is none of the units"},
    {"2.500,0", std::nullopt, "has a point and a comma"},
    {"1,234.5", std::nullopt, "has a point and a comma"},
    {"1,234,567", std::nullopt, "has several decimal signs"},
    {"1.2.3", std::nullopt, "has several decimal signs"},
    {"1 000", std::nullopt},
    {"12 nm", std::nullopt, "'nm' is none of the units m, km, cm, mm, um, ft, NM, nmi"},
    {"12 parsecs", std::nullopt, "'parsecs' is none of the units"},
    {"1e", std::nullopt, "'e' is none of the units"},
    {"5-3", std::nullopt},
    {"12;5", std::nullopt},
};

TEST(NumberText, HasOneRuleForWhatIsTyped) {
    for (const Typed& row : inMetres) {
        const TypedNumber typed = typedNumber(QString::fromUtf8(row.text), "m");
        EXPECT_EQ(typed.value, row.value) << row.text;
        EXPECT_EQ(typed.problem.isEmpty(), row.value.has_value()) << row.text;
        if (!row.value) {
            EXPECT_TRUE(typed.problem.contains(row.problem))
                << row.text << ": " << typed.problem.toStdString();
        }
    }
}

TEST(NumberText, TakesOtherUnitsOfTheQuantity) {
    struct {
        const char *unit, *text;
        double value;
    } const rows[] = {{"K", "27 \u00b0C", 300.15},
                      {"K", "300 K", 300.0},
                      {"\u00b0C", "300.15 K", 27.0},
                      {"C", "27 \u00b0C", 27.0},
                      {"", "85 %", 0.85},
                      {"%", "85 %", 85.0},
                      {"\u00b0", "45\u00b0", 45.0},
                      {"deg", "1 mrad", 0.18 / M_PI},
                      {"\u00b5m", "4200 nm", 4.2},
                      {"um", "4,2 \u03bcm", 4.2},
                      {"s", "2 min", 120.0},
                      {"s", "1,5 h", 5400.0},
                      {"m/s", "36 km/h", 10.0},
                      {"W\u00b7m\u207b\u00b2", "3 W m-2", 3.0},
                      {"m s-1", "3 m/s", 0.0}};
    for (const auto& row : rows) {
        const TypedNumber typed =
            typedNumber(QString::fromUtf8(row.text), QString::fromUtf8(row.unit));
        if (row.value == 0.0) {
            EXPECT_FALSE(typed.value) << row.text;
            continue;
        }
        ASSERT_TRUE(typed.value) << row.text << ": " << typed.problem.toStdString();
        EXPECT_NEAR(*typed.value, row.value, 1e-14 * row.value) << row.text;
    }
    EXPECT_TRUE(typedNumber("27 C", "K", NumberMeaning::difference).problem.contains("difference"));
    EXPECT_EQ(typedNumber("27 K", "K", NumberMeaning::difference).value, 27.0);
    EXPECT_TRUE(typedNumber("3 m", {}).problem.contains("'m' is none of the units %"));
}

TEST(NumberText, HasThatRuleInEveryKindOfField) {
    NumberField field("m");
    RealBox box("box", "m");
    box.setRange(-1e7, 1e7);
    box.setDecimals(9);
    SettingForm form({key::cameraRange}, {});
    auto* setting = form.findChild<QLineEdit*>("camera.range");
    ASSERT_NE(setting, nullptr);
    const SettingInfo& info = settingInfo(key::cameraRange);
    for (const Typed& row : inMetres) {
        const QString text = QString::fromUtf8(row.text);
        field.setValue(77.0);
        field.selectAll();
        field.del();
        field.insert(text);
        QTest::keyClick(&field, Qt::Key_Return);
        EXPECT_EQ(field.value(), row.value.value_or(77.0)) << row.text;

        box.setValue(77.0);
        box.findChild<QLineEdit*>()->setText(text);
        box.interpretText();
        EXPECT_EQ(box.value(), row.value.value_or(77.0)) << row.text;

        const auto typed = typedSetting(info, text);
        const bool isInRange =
            row.value && *row.value >= info.minimum && *row.value <= info.maximum;
        EXPECT_EQ(typed.has_value(), isInRange) << row.text;
        if (typed) {
            EXPECT_EQ(numberOf(QString::fromStdString(*typed)), row.value) << row.text;
        } else {
            EXPECT_FALSE(problemOf(info, text).isEmpty()) << row.text;
        }
    }
}

TEST(NumberText, KeepsTheDigitsThatWereTyped) {
    EXPECT_EQ(plainNumber("0.100", "m"), "0.100");
    EXPECT_EQ(plainNumber("1e3", "m"), "1e3");
    EXPECT_EQ(plainNumber("0,1", "m"), "0.1");
    EXPECT_EQ(plainNumber("100 km", "m"), "100000");
    EXPECT_EQ(plainNumber("nose", "m"), "nose");
}

TEST(NumberBoxes, SwallowNothingThatIsTyped) {
    WholeBox box("draws");
    box.setRange(1, 100000);
    box.setValue(50);
    box.setSuffix(" s after an edit");
    auto* line = box.findChild<QLineEdit*>();
    struct {
        const char* text;
        int value;
        const char* problem;
    } const rows[] = {
        {"1,5", 50, "'1,5' is not a whole number"}, {"2e3", 2000, ""},
        {"1.024,0", 50, "has a point and a comma"}, {"0", 50, "has to be from 1 to 100000"},
        {"12x", 50, "'x' is none of the units"},    {"640", 640, ""}};
    for (const auto& row : rows) {
        box.setValue(50);
        box.setProperty("refused", {});
        line->selectAll();
        QTest::keyClicks(line, row.text);
        QTest::keyClick(line, Qt::Key_Return);
        EXPECT_EQ(box.value(), row.value) << row.text;
        EXPECT_TRUE(box.property("refused").toString().contains(row.problem))
            << row.text << ": " << box.property("refused").toString().toStdString();
    }
}

} // namespace
} // namespace smat::gui
