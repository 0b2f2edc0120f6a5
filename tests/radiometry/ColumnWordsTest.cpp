#include "irsg/core/ColumnWords.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace irsg {

void PrintTo(const ColumnHead& head, std::ostream* out) {
    *out << head.name << " [" << head.unit << "]";
}

namespace {

TEST(ColumnWords, OneHeadIsTheSameInEveryForm) {
    const struct {
        const char* head;
        ColumnHead meant;
    } rows[] = {
        {"Temperatur [\u00b0C]", {"temperature", "C"}},
        {"Temperatur in \u00b0C", {"temperature", "C"}},
        {"Temp\u00e9rature (\u00baC)", {"temperature", "C"}},
        {"TEMPERATUR / K", {"temperature", "K"}},
        {"temperature_K", {"temperature", "K"}},
        {"T [\u2103]", {"temperature", "C"}},
        {"Emissionsgrad", {"emissivity", ""}},
        {"\u00c9missivit\u00e9", {"emissivity", ""}},
        {"Emissivit\u00e4t [1]", {"emissivity", ""}},
        {"Emissivit\xe4t (-)", {"emissivity", ""}}, // Latin-1
        {"Emissivita\u0308t", {"emissivity", ""}},  // a letter and its dots
        {"Reflexionsgrad [%]", {"reflectance", "%"}},
        {"Reflexionsgrad in Prozent", {"reflectance", "%"}},
        {"facteur de r\u00e9flexion, pour cent", {"reflectance", "%"}},
        {"Transmission %", {"transmittance", "%"}},
        {"H\u00f6he [m]", {"altitude", "m"}},
        {"HOEHE in Meter", {"altitude", "m"}},
        {"rel. Feuchte [%]", {"relative_humidity", "%"}},
        {"humidit\u00e9_relative (%)", {"relative_humidity", "%"}},
        {"point de ros\u00e9e [degC]", {"dew_point", "C"}},
        {"Zeit [s]", {"time", "s"}},
        {"t, s", {"time", "s"}},
        {"angle d\u2019incidence [\u00b0]", {"incidence", "deg"}},
        {"incidence_deg", {"incidence", "deg"}},
        {"Extinktion [1/km]", {"extinction", "km-1"}},
        {"Extinktion [km\u207b\u00b9]", {"extinction", "km-1"}},
        {"Brechzahl", {"n", ""}},
        {"Luftdruck [mbar]", {"pressure", "hPa"}},
        {"solar_irradiance [W\u00b7m\u207b\u00b2 um^-1]", {"solar_irradiance", "W m-2 um^-1"}},
        {"co2 [ppmv]", {"co2", "ppmv"}},
        {"um", {"um", ""}},
        {"", {"", ""}},
    };
    for (const auto& row : rows) {
        EXPECT_EQ(columnHead(row.head), row.meant) << row.head;
    }
}

TEST(ColumnWords, LettersWhoseCaseMattersKeepIt) {
    EXPECT_EQ(columnHead("t [s]").name, "time");
    EXPECT_EQ(columnHead("T [K]").name, "temperature");
    EXPECT_EQ(columnHead("N").name, "N");
    EXPECT_EQ(columnHead("z [M]").unit, "M"); // none that is known
    EXPECT_EQ(columnHead("z [MM]").unit, "MM");
    EXPECT_EQ(columnHead("z [Meter]").unit, "m");
    EXPECT_FALSE(columnUnit("k"));
    EXPECT_EQ(columnUnit("\u00b5m"), "um");
    EXPECT_EQ(columnUnit("\u00c5"), "angstrom");
    EXPECT_EQ(columnUnit("A\u030angstr\u00f6m"), "angstrom");
}

TEST(ColumnWords, WhatMeansTwoThingsIsNone) {
    // Absorbance or extinction of a length; gon or degrees; of volume or of mass.
    for (const char* head : {"Absorption", "Emission", "R", "D", "Grad"}) {
        for (const ColumnWord& word : columnWords()) {
            EXPECT_NE(columnHead(head).name, word.name) << head;
        }
    }
    for (const char* unit : {"Grad", "ppm", "A", "M", "Pa", "h", "min"}) {
        EXPECT_FALSE(columnUnit(unit)) << unit;
    }
}

TEST(ColumnWords, StandOnceInTheirTables) {
    std::set<std::string_view> words, spellings;
    for (const ColumnWord& word : columnWords()) {
        EXPECT_TRUE(words.insert(word.word).second) << word.word;
        EXPECT_EQ(columnHead(word.word).name, word.name) << word.word;
        EXPECT_EQ(plainHead(word.word), word.word);
    }
    for (const ColumnUnit& unit : columnUnits()) {
        EXPECT_TRUE(spellings.insert(unit.spelling).second) << unit.spelling;
        EXPECT_EQ(columnUnit(unit.spelling), unit.unit) << unit.spelling;
        if (!unit.unit.empty()) {
            EXPECT_EQ(columnUnit(unit.unit), unit.unit) << unit.spelling;
        }
    }
}

} // namespace
} // namespace irsg
