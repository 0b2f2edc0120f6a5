#include "irsg/core/Errors.h"

#include <limits>

#include <gtest/gtest.h>

#include "irsg/core/Diagnostics.h"

using namespace irsg;

TEST(Errors, AnDiagnosticSaysWhatIsKnownAndNothingElse) {
    EXPECT_EQ((Diagnostic{"a.csv", "line 7", "'x'", "a number"}).message(),
              "a.csv: line 7: found 'x', expected a number");
    EXPECT_EQ((Diagnostic{"a.csv", "", "", "a readable file"}).message(),
              "a.csv: expected a readable file");
    EXPECT_EQ((Diagnostic{"", "line 7", "'x'", ""}).message(), "line 7: found 'x'");
    EXPECT_EQ((Diagnostic{"a.csv", "", "", ""}).message(), "a.csv");
    EXPECT_EQ((Diagnostic{"", "", "'x'", "a number"}).message(), "found 'x', expected a number");
}

TEST(Errors, AnInputErrorHoldsEveryDiagnosticAndPrintsOneALine) {
    const InputError error({{"a", "1", "x", "y"}, {"a", "2", "u", "v"}});
    EXPECT_EQ(error.diagnostics().size(), 2u);
    EXPECT_STREQ(error.what(), "a: 1: found x, expected y\na: 2: found u, expected v");
    EXPECT_THROW(InputError(std::vector<Diagnostic>{}), LogicError);
}

TEST(Errors, TellAHundredDiagnosticsOfAFileAndHowManyMore) {
    std::vector<Diagnostic> diagnostics(250, {"a.csv", "line 1", "x", "a number"});
    diagnostics.push_back({"b.csv", "", "nothing", "a table"});
    // Whoever collects diagnostics of several readers tells the same.
    const InputError once(diagnostics), again(once.diagnostics());
    for (const InputError* error : {&once, &again}) {
        ASSERT_EQ(error->diagnostics().size(), 102u);
        EXPECT_EQ(error->diagnostics()[100].message(), "b.csv: found nothing, expected a table");
        EXPECT_EQ(error->diagnostics()[101].message(), "a.csv: and 150 more");
    }
}

TEST(Errors, DiagnosticsAreFoldedWhileTheyAreCollected) {
    std::vector<Diagnostic> all, folded;
    for (int line = 1; line <= 5000; ++line) {
        for (auto* list : {&all, &folded}) {
            list->push_back({"a.csv", "line " + std::to_string(line), "x", "a number"});
        }
        keepFirstDiagnostics(folded);
        ASSERT_LE(folded.size(), 1000u);
    }
    EXPECT_STREQ(InputError(folded).what(), InputError(all).what());
}

TEST(Errors, NumbersAreWrittenShortAndReadBack) {
    EXPECT_EQ(numberText(3.5), "3.5");
    EXPECT_EQ(numberText(-300.0), "-300");
    EXPECT_EQ(numberText(1e-300), "1e-300");
    EXPECT_EQ(numberText(std::numeric_limits<double>::quiet_NaN()), "nan");
    EXPECT_EQ(numberText(-std::numeric_limits<double>::infinity()), "-inf");
    EXPECT_EQ(std::stod(numberText(0.1 + 0.2)), 0.1 + 0.2);
}
