#include "irsg/geometry/model/IndexNames.h"

#include <gtest/gtest.h>

namespace irsg {
namespace {

NamedFaces faces(std::map<IrCodes, long> codes) {
    NamedFaces all;
    for (const auto& [code, polygons] : codes) {
        all.polygons += polygons;
    }
    all.codes = std::move(codes);
    return all;
}

/// Codes of temperature and material.
constexpr IrCodes skin{1, 1}, pipe{2, 1}, glass{1, 3};

TEST(IndexNames, AreThoseOfTheFacesThatHaveTheIndex) {
    const IndexNames names(NamesOfKinds{
        {{"grey paint", faces({{skin, 90}, {pipe, 20}})}, {"acryl", faces({{glass, 10}})}},
        {{"fuselage", faces({{skin, 60}})},
         {"nozzle", faces({{pipe, 20}})},
         {"wing", faces({{skin, 30}})},
         {"cockpit", faces({{glass, 10}})}},
        {{"aircraft", faces({{skin, 90}, {pipe, 20}, {glass, 10}})}}});
    EXPECT_EQ(names.ofMaterial(1), "grey paint");
    EXPECT_EQ(names.ofMaterial(3), "acryl");
    EXPECT_EQ(names.ofTemperature(2), "nozzle");
    // 90 of 110 that are paint and 100 of index 1: 90/120; of the whole aircraft 100/120.
    EXPECT_EQ(names.ofTemperature(1), "aircraft");
}

TEST(IndexNames, FallBackToTheIndexWhereTheModelSaysNothing) {
    const IndexNames names(NamesOfKinds{{{"", faces({{skin, 40}, {pipe, 60}})}},
                                        {{"o12", faces({{skin, 40}})}, {"P7", faces({{pipe, 60}})}},
                                        {{"g1", faces({{skin, 40}, {pipe, 60}})}}});
    EXPECT_EQ(names.ofTemperature(1), "temperature 1");
    EXPECT_EQ(names.ofTemperature(2), "temperature 2");
    EXPECT_EQ(names.ofMaterial(1), "material 1");
    EXPECT_EQ(names.ofMaterial(99), "material 99");
    EXPECT_EQ(IndexNames().ofTemperature(4), "temperature 4");
}

TEST(IndexNames, ANameThatFitsHalfIsGivenToNobody) {
    // Half of each index: neither has more right to it.
    const IndexNames names(
        NamesOfKinds{{{"hull", faces({{skin, 10}, {pipe, 10}})}, {"", faces({{glass, 1}})}}});
    EXPECT_EQ(names.ofTemperature(1), "temperature 1");
    EXPECT_EQ(names.ofTemperature(2), "temperature 2");
}

} // namespace
} // namespace irsg
