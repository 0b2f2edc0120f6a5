#include "irsg/radiometry/Band.h"
#include "irsg/core/Remarks.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using testing::HasSubstr;

namespace {

Band bandOf(const std::string& text) {
    return Band::fromCsv(smat::test::writtenFile(smat::test::ownFolder() / "band.csv", text));
}

} // namespace

TEST(Band, TopHatIsOneInsideAndZeroOutside) {
    const Band band = Band::topHat(3.0, 5.0);
    EXPECT_TRUE(band.isTopHat());
    EXPECT_EQ(band.responseAt(3.0), 1.0);
    EXPECT_EQ(band.responseAt(5.0), 1.0);
    EXPECT_EQ(band.responseAt(2.999), 0.0);
    EXPECT_EQ(band.responseAt(5.001), 0.0);
    EXPECT_DOUBLE_EQ(band.area_um(), 2.0);
    EXPECT_EQ(band.name(), "3-5 um");
    EXPECT_EQ(band, Band::topHat(3.0, 5.0));
    EXPECT_FALSE(band == Band::topHat(3.0, 4.9));
}

TEST(Band, TopHatTakesTheEndsOfTheSpectrum) {
    EXPECT_DOUBLE_EQ(Band::topHat(0.2, 40.0).area_um(), 39.8);
}

TEST(Band, ResponseIsZeroOutsideItsAxisWhateverItsSpectrumHolds) {
    const Band band =
        Band::fromResponse({{3.0, 4.0, 5.0}, {0.5, 1.0, 0.5}, Spectrum::Outside::hold}, "filter");
    EXPECT_FALSE(band.isTopHat());
    EXPECT_EQ(band.name(), "filter");
    EXPECT_EQ(band.range(), (SpectralRange{3.0, 5.0}));
    EXPECT_EQ(band.responseAt(2.9), 0.0);
    EXPECT_EQ(band.responseAt(3.5), 0.75);
    EXPECT_DOUBLE_EQ(band.area_um(), 1.5);
}

TEST(Band, TextOfTwoNumbersIsATopHat) {
    EXPECT_EQ(Band::fromText("3-5"), Band::topHat(3.0, 5.0));
    EXPECT_EQ(Band::fromText(" 8.0 - 12 "), Band::topHat(8.0, 12.0));
    EXPECT_EQ(Band::fromText("3e-1-4e1"), Band::topHat(0.3, 40.0));
}

TEST(Band, CsvInMicrometresIsReadAsItStands) {
    for (const char* header : {"um,response", "wavelength [um],response", "\"um\",R"}) {
        const Band band =
            bandOf("# a filter\r\n" + std::string(header) + "\r\n3.0,0\r\n4.0,0.8\r\n5.0,0\r\n");
        EXPECT_EQ(band.range(), (SpectralRange{3.0, 5.0}));
        EXPECT_DOUBLE_EQ(band.responseAt(3.5), 0.4);
        EXPECT_DOUBLE_EQ(band.area_um(), 0.8);
    }
}

TEST(Band, CsvInWavenumbersIsLinearInWavenumbers) {
    const Band band = bandOf("cm-1,response\n2000,0\n2500,1\n3000,0\n");
    EXPECT_DOUBLE_EQ(band.range().min_um, 1e4 / 3000.0);
    EXPECT_DOUBLE_EQ(band.range().max_um, 5.0);
    for (double wavenumber_per_cm = 2001.0; wavenumber_per_cm < 3000.0; wavenumber_per_cm += 7.0) {
        EXPECT_NEAR(band.responseAt(1e4 / wavenumber_per_cm),
                    1.0 - std::abs(wavenumber_per_cm - 2500.0) / 500.0, 1.1e-7);
    }
}

TEST(Band, ResponsesAreReadInEveryFormThatMakersPrint) {
    const Band expected = bandOf("um,r\n3,0\n3.2,0.5\n3.5,0.9\n4.5,1\n4.9,0.6\n5.1,0\n");
    const std::filesystem::path strangers =
        std::filesystem::path(SMAT_SOURCE_DIR) / "tests/data/strangers/response-forms";
    const std::pair<const char*, const char*> rows[] = {
        {"descending.csv", ""},
        {"modtran.flt", ""},
        {"nm.csv", ""},
        {"spaces.txt", "there is no head"},
        {"negative.csv", "2 values outside of 0 to"}};
    for (const auto& [name, remark] : rows) {
        SCOPED_TRACE(name);
        const CollectedRemarks remarks;
        const Band band = Band::fromCsv(strangers / name);
        EXPECT_NEAR(band.range().min_um, 3.0, 1e-12);
        EXPECT_NEAR(band.range().max_um, 5.1, 1e-12);
        for (const double wavelength_um : {3.1, 3.4, 4.0, 4.7, 5.0}) {
            EXPECT_NEAR(band.responseAt(wavelength_um), expected.responseAt(wavelength_um), 2.1e-4);
        }
        const std::string all = testing::PrintToString(remarks.sentences());
        EXPECT_THAT(all, HasSubstr(remark));
    }
}

TEST(Band, PercentInTheHeadIsSaidAndDividedOut) {
    for (const char* head : {"response [%]", "Transmission (%)", "response percent"}) {
        const CollectedRemarks remarks;
        EXPECT_DOUBLE_EQ(bandOf("um," + std::string(head) + "\n3,0\n4,80\n5,0\n").responseAt(4.0),
                         0.8);
        EXPECT_THAT(testing::PrintToString(remarks.sentences()), HasSubstr("in percent"));
    }
}

TEST(Band, ResponsesALittleBelowZeroAreZeroAndOthersRefused) {
    const CollectedRemarks remarks;
    EXPECT_EQ(bandOf("um,r\n3,-0.005\n4,1\n5,0\n").responseAt(3.0), 0.0);
    EXPECT_THAT(testing::PrintToString(remarks.sentences()), HasSubstr("line 2, column 2: -0.005"));
}

TEST(Band, ResponsesALittleAboveOneAreOneAndBracketsOfOtherWordsAreSaid) {
    const CollectedRemarks remarks;
    EXPECT_EQ(bandOf("um,r\n3,0\n4,1.005\n5,0\n").responseAt(4.0), 1.0);
    EXPECT_THAT(testing::PrintToString(remarks.sentences()), HasSubstr("line 3, column 2: 1.005"));
    EXPECT_EQ(bandOf("um,r [%]\n3,0\n4,100.5\n5,0\n").responseAt(4.0), 1.0);
    for (const char* head :
         {"response", "response [1]", "response [-]", "filter K", "R_s", "M/S"}) {
        const CollectedRemarks none;
        EXPECT_EQ(bandOf("um," + std::string(head) + "\n3,0\n4,0.7\n5,0\n").responseAt(4.0), 0.7);
        EXPECT_TRUE(none.sentences().empty()) << head;
    }
    EXPECT_EQ(bandOf("um,r (relative)\n3,0\n4,0.7\n5,0\n").responseAt(4.0), 0.7);
    EXPECT_THAT(testing::PrintToString(remarks.sentences()),
                HasSubstr("in 'relative' is taken as a fraction"));
}

TEST(Band, OfAFilterOfSeveralChannelsTheFirstIsReadAndTheOthersAreSaid) {
    const CollectedRemarks remarks;
    const Band band = bandOf("W filters\nfirst\n 2000. 0. 5.\n 2500. 1. 4.\nsecond\n 900. 1.\n"
                             " 1000. 1.\n");
    EXPECT_DOUBLE_EQ(band.range().min_um, 4.0);
    EXPECT_THAT(testing::PrintToString(remarks.sentences()),
                HasSubstr("holds 2 channels; 'first' is read"));
}

namespace {

struct BadBand {
    const char* name;
    std::string text;
    const char* message;
};
void PrintTo(const BadBand& row, std::ostream* out) {
    *out << row.name;
}

class BandCsvRefuses : public testing::TestWithParam<BadBand> {};
class BandTextRefuses : public testing::TestWithParam<BadBand> {};

std::string nameOf(const testing::TestParamInfo<BadBand>& row) {
    return row.param.name;
}

} // namespace

TEST_P(BandCsvRefuses, WithFilePlaceAndExpectation) {
    const std::filesystem::path path =
        smat::test::writtenFile(smat::test::ownFolder() / "bad.csv", GetParam().text);
    try {
        Band::fromCsv(path);
        ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(path.string()));
        EXPECT_THAT(error.what(), HasSubstr(GetParam().message));
        for (const Diagnostic& diagnostic : error.diagnostics()) {
            EXPECT_FALSE(diagnostic.expected.empty());
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Of, BandCsvRefuses,
    testing::Values(
        BadBand{"nothing", "", "found no rows"},
        BadBand{"commentsOnly", "# a\n# b\n", "found no rows"},
        BadBand{"headerOnly", "um,r\n", "found 0 rows of numbers, expected at least two"},
        BadBand{"oneRow", "um,r\n3,1\n", "found 1 rows of numbers"},
        BadBand{"noUnit", "energy,r\n3,1\n4,1\n", "line 1, column 1: found 'energy'"},
        BadBand{"noHeaderAndNoWavelengths", "3000,1\n4000,1\n5000,1\n",
                "line 1, column 1: found '3000', expected a head that names the unit"},
        BadBand{"wavelengthsOfTwoUnits", "wavelength,r\n4,1\n4000,1\n", "expected a head that"},
        BadBand{"threeColumns", "um,r,s\n3,1,1\n4,1,1\n", "line 1: found '3 cells'"},
        BadBand{"aShortRow", "um,r\n3,1\n4\n5,1\n", "line 3: found '1 cells', expected two"},
        BadBand{"aLongRow", "um,r\n3,1\n4,1,2\n", "line 3: found '3 cells'"},
        BadBand{"decimalCommas", "um,r\n3,0,5\n4,0,5\n", "line 2: found '3 cells'"},
        BadBand{"turnsBack", "um,r\n5,1\n4,1\n4.5,1\n",
                "line 4, column 1: found '4.5', expected less than 4"},
        BadBand{"negativeBeyondTheTolerance", "um,r\n3,-0.0051\n4,1\n",
                "line 2, column 2: found '-0.0051'"},
        BadBand{"duplicated", "um,r\n4,1\n4,1\n5,0\n", "line 3, column 1: found '4'"},
        BadBand{"wavelengthNan", "um,r\n3,1\nnan,1\n5,1\n", "line 3, column 1: found 'nan'"},
        BadBand{"responseNan", "um,r\n3,1\n4,NaN\n", "line 3, column 2: found 'NaN'"},
        BadBand{"infinite", "um,r\n3,1\ninf,1\n", "line 3, column 1: found 'inf'"},
        BadBand{"words", "um,r\n3,one\n4,1\n", "line 2, column 2: found 'one'"},
        BadBand{"emptyCell", "um,r\n3,\n4,1\n", "line 2, column 2: found nothing"},
        BadBand{"negativeWavelength", "um,r\n-3,1\n4,1\n", "line 2, column 1: found '-3'"},
        BadBand{"zeroWavenumber", "cm-1,r\n0,1\n2000,1\n", "line 2, column 1: found '0'"},
        BadBand{"negativeResponse", "um,r\n3,1\n4,-0.1\n", "line 3, column 2: found '-0.1'"},
        BadBand{"percentUnderAFraction", "um,response\n3,0\n4,90\n5,100\n",
                "line 3, column 2: found '90', expected a fraction from 0 to 1, not percent"},
        BadBand{"counts", "um,response\n3,0\n4,900\n5,0\n",
                "line 3, column 2: found '900', expected a response from 0 to 1"},
        BadBand{"aLittleTooMuch", "um,response\n3,0\n4,1.0051\n5,0\n",
                "found '1.0051', expected a response from 0 to 1"},
        BadBand{"tooManyPercent", "um,response [%]\n3,0\n4,101\n5,0\n",
                "found '101', expected a response from 0 to 100"},
        BadBand{"responsivity", "um,A/W\n3,0\n4,0.5\n5,0\n",
                "line 1, column 2: found 'A/W', expected a response from 0 to 1 without a unit"},
        BadBand{"responsivityInBrackets", "um,R [mV / mW]\n3,0\n4,0.5\n5,0\n", "R [mV / mW]"},
        BadBand{"responsivityByExponent", "um,R (A W-1)\n3,0\n4,0.5\n5,0\n", "R (A W-1)"},
        BadBand{"temperatures", "um,R [K]\n3,0\n4,0.5\n5,0\n", "line 1, column 2: found 'R [K]'"},
        BadBand{"zeroArea", "um,r\n3,0\n4,0\n", "found a response that is 0 everywhere"},
        BadBand{"binary", std::string("um,r\n3,1\n\0\1", 11), "byte 9: found a NUL byte"}),
    nameOf);

TEST(BandCsv, RefusesAFileThatIsNotThere) {
    EXPECT_THROW(Band::fromCsv("no/such/band.csv"), InputError);
}

TEST(BandCsv, NamesEveryDiagnosticAtOnce) {
    try {
        bandOf("um,r\n3,x\n2,1\n4,-1\n");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        ASSERT_EQ(error.diagnostics().size(), 2u);
        EXPECT_EQ(error.diagnostics()[0].position, "line 2, column 2");
        EXPECT_EQ(error.diagnostics()[1].position, "line 4, column 2");
    }
}

TEST(BandCsv, ShowsBytesThatAreNotUtf8AsLatin1) {
    try {
        bandOf("Gr\xF6\xDF"
               "e,response\n3,0\n4,1\n5,0\n");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("Gr\u00f6\u00dfe"));
    }
}

TEST_P(BandTextRefuses, AndSaysHowABandIsWritten) {
    try {
        Band::fromText(GetParam().text);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("'" + GetParam().text + "'"));
        EXPECT_THAT(error.what(), HasSubstr("such as 3-5"));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Of, BandTextRefuses,
    testing::Values(BadBand{"nothing", "", ""}, BadBand{"dash", "-", ""},
                    BadBand{"oneNumber", "3", ""}, BadBand{"openEnd", "3-", ""},
                    BadBand{"openStart", "-5", ""}, BadBand{"reversed", "5-3", ""},
                    BadBand{"empty", "4-4", ""}, BadBand{"zero", "0-5", ""},
                    BadBand{"negative", "-3-5", ""}, BadBand{"nan", "nan-5", ""},
                    BadBand{"infinite", "3-inf", ""}, BadBand{"words", "mid-wave", ""},
                    BadBand{"unit", "3-5um", ""}),
    nameOf);

TEST(Band, RefusesTopHatsThatAreNoInterval) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double notANumber = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(Band::topHat(5.0, 3.0), InputError);
    EXPECT_THROW(Band::topHat(4.0, 4.0), InputError);
    EXPECT_THROW(Band::topHat(0.0, 4.0), InputError);
    EXPECT_THROW(Band::topHat(-1.0, 4.0), InputError);
    EXPECT_THROW(Band::topHat(3.0, infinity), InputError);
    EXPECT_THROW(Band::topHat(notANumber, 4.0), InputError);
}

TEST(Band, RefusesResponsesThatAreNegativeConstantOrOfNoArea) {
    EXPECT_THROW(Band::fromResponse({{3.0, 4.0, 5.0}, {0.0, -0.1, 1.0}}), InputError);
    EXPECT_THROW(Band::fromResponse({{3.0, 4.0}, {0.0, 0.0}}), InputError);
    EXPECT_THROW(Band::fromResponse(Spectrum::constant(1.0)), InputError);
    EXPECT_THROW(Band::fromResponse({{3.0, 9.0}, {1e308, 1e308}}), InputError);
}
