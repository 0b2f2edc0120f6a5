#include "irsg/radiometry/Errors.h"

#include <limits>

#include <gtest/gtest.h>

#include "irsg/radiometry/Offences.h"

using namespace irsg;

TEST(Errors, anOffenceSaysWhatIsKnownAndNothingElse) {
    EXPECT_EQ((Offence{"a.csv", "line 7", "'x'", "a number"}).message(),
              "a.csv: line 7: found 'x', expected a number");
    EXPECT_EQ((Offence{"a.csv", "", "", "a readable file"}).message(),
              "a.csv: expected a readable file");
    EXPECT_EQ((Offence{"", "line 7", "'x'", ""}).message(), "line 7: found 'x'");
    EXPECT_EQ((Offence{"a.csv", "", "", ""}).message(), "a.csv");
    EXPECT_EQ((Offence{"", "", "'x'", "a number"}).message(), "found 'x', expected a number");
}

TEST(Errors, anInputErrorHoldsEveryOffenceAndPrintsOneALine) {
    const InputError error({{"a", "1", "x", "y"}, {"a", "2", "u", "v"}});
    EXPECT_EQ(error.offences().size(), 2u);
    EXPECT_STREQ(error.what(), "a: 1: found x, expected y\na: 2: found u, expected v");
    EXPECT_THROW(InputError(std::vector<Offence>{}), LogicError);
}

TEST(Errors, tellAHundredOffencesOfAFileAndHowManyMore) {
    std::vector<Offence> offences(250, {"a.csv", "line 1", "x", "a number"});
    offences.push_back({"b.csv", "", "nothing", "a table"});
    // Whoever collects offences of several readers tells the same.
    const InputError once(offences), again(once.offences());
    for (const InputError* error : {&once, &again}) {
        ASSERT_EQ(error->offences().size(), 102u);
        EXPECT_EQ(error->offences()[100].message(), "b.csv: found nothing, expected a table");
        EXPECT_EQ(error->offences()[101].message(), "a.csv: and 150 more");
    }
}

TEST(Errors, offencesAreFoldedWhileTheyAreCollected) {
    std::vector<Offence> all, folded;
    for (int line = 1; line <= 5000; ++line) {
        for (auto* list : {&all, &folded})
            list->push_back({"a.csv", "line " + std::to_string(line), "x", "a number"});
        keepFirstOffences(folded);
        ASSERT_LE(folded.size(), 1000u);
    }
    EXPECT_STREQ(InputError(folded).what(), InputError(all).what());
}

TEST(Errors, numbersAreWrittenShortAndReadBack) {
    EXPECT_EQ(numberText(3.5), "3.5");
    EXPECT_EQ(numberText(-300.0), "-300");
    EXPECT_EQ(numberText(1e-300), "1e-300");
    EXPECT_EQ(numberText(std::numeric_limits<double>::quiet_NaN()), "nan");
    EXPECT_EQ(numberText(-std::numeric_limits<double>::infinity()), "-inf");
    EXPECT_EQ(std::stod(numberText(0.1 + 0.2)), 0.1 + 0.2);
}
