#include "smatcore/tools/GasLayerText.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/Refusal.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

TEST(GasLayerText, IsReadAndWritten) {
    const std::string text = "T_K=700,p_atm=1,length_m=0.5,CO2=0.033,H2O=0.034,CO=0.01,CH4=0.002,"
                             "O2=0.1,soot_ppmv=0.05";
    const irsg::GasLayer layer = gasLayerFromText(text, "layer");
    EXPECT_EQ(layer.temperature_K, 700.0);
    EXPECT_EQ(layer.pressure_atm, 1.0);
    EXPECT_EQ(layer.length_m, 0.5);
    EXPECT_EQ(layer.fraction(irsg::HotGas::CO2), 0.033);
    EXPECT_EQ(layer.fraction(irsg::HotGas::H2O), 0.034);
    EXPECT_EQ(layer.fraction(irsg::HotGas::CO), 0.01);
    EXPECT_EQ(layer.fraction(irsg::HotGas::CH4), 0.002);
    EXPECT_EQ(layer.oxygenFraction, 0.1);
    EXPECT_EQ(layer.soot_ppmv, 0.05);
    EXPECT_NEAR(layer.nitrogenFraction(), 0.821, 1e-12);
    EXPECT_NEAR(layer.column_atm_cm(irsg::HotGas::CO2), 1.65, 1e-12);
    EXPECT_EQ(gasLayerText(layer), text);
    EXPECT_EQ(gasLayerText(gasLayerFromText(" length_m = 2 , p_atm=1,T_K=300", "layer")),
              "T_K=300,p_atm=1,length_m=2");
}

struct Row {
    const char *name, *text;
    std::vector<const char*> named;
};
class GasLayerTextRefuses : public testing::TestWithParam<Row> {};

TEST_P(GasLayerTextRefuses, ByName) {
    const std::string message = refusalOf([] { gasLayerFromText(GetParam().text, "layer 2"); });
    for (const char* part : GetParam().named) {
        EXPECT_THAT(message, HasSubstr(part));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Texts, GasLayerTextRefuses,
    testing::Values(
        Row{"Empty", "", {"layer 2", "T_K", "p_atm", "length_m"}},
        Row{"UnknownGas", "T_K=700,p_atm=1,length_m=1,C02=0.1", {"C02", "did you mean 'CO2'"}},
        Row{"OtherGas", "T_K=700,p_atm=1,length_m=1,NO=0.1", {"NO", "one of T_K"}},
        Row{"Word", "T_K=hot,p_atm=1,length_m=1", {"T_K", "'hot'", "a number"}},
        Row{"NoSign", "T_K=700,p_atm,length_m=1", {"'p_atm'", "KEY=NUMBER"}},
        Row{"Twice", "T_K=700,T_K=800,p_atm=1,length_m=1", {"T_K", "twice"}},
        Row{"Missing", "T_K=700,length_m=1", {"p_atm", "found nothing"}},
        Row{"TooMuch", "T_K=700,p_atm=1,length_m=1,CO2=0.7,H2O=0.7", {"1.4 in sum"}},
        Row{"Open", "T_K=700,p_atm=1,length_m=inf", {"length_m"}},
        Row{"TooHot", "T_K=5000,p_atm=1,length_m=1", {"T_K", "5000", "250 to 3000"}}),
    [](const auto& row) { return std::string(row.param.name); });

} // namespace
} // namespace smat::test
