#include "smatcore/analysis/CaseFile.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/support/TextFile.h"
#include "tests/core/AnalyticSource.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// Warns of some of its cases.
class Warning : public test::GreySphere {
  public:
    irsg::RenderReport measure() override {
        irsg::RenderReport report = GreySphere::measure();
        ++drawn;
        if (report.all.range_m > 1200.0) {
            report.warnings.push_back("far");
        }
        report.layersLeftOver = static_cast<int>(report.all.range_m) / 100;
        return report;
    }
    int drawn = 0;
};

AnalysisData asked(const char* points = "20") {
    Settings overrides;
    overrides.set("range.points", points);
    overrides.set("range.to", "2000");
    overrides.set("sensor.band", "3-5,8-12");
    return AnalysisData::of(Project(), AnalysisKind::range, overrides);
}

/// What a run with these cases comes to, and how many it drew.
struct Ran {
    AnalysisData data;
    int drawn = 0;
};
Ran ran(CaseStore* store, AnalysisData data = asked(), std::stop_token stop = {}) {
    Warning source;
    AnalysisGenerator(source, test::sceneWithoutFiles).run(data, {}, stop, nullptr, store);
    return {data, source.drawn};
}
std::string whole() {
    return ran(nullptr).data.table.toCsv();
}

TEST(CaseFile, PartsJoinToTheBytesOfOneRunInAnyOrder) {
    const test::TemporaryFolder folder;
    EXPECT_THAT(whole(), testing::ContainsRegex("and [0-9]+ more.: far"));
    for (const std::size_t parts : {1U, 2U, 3U, 7U, 30U}) {
        std::vector<fs::path> files;
        int drawn = 0;
        for (std::size_t part = 1; part <= parts; ++part) {
            const CaseShare share{part, parts};
            files.insert(files.begin(), CaseFile::besides(folder / "a.csv", share));
            CaseFile file(files.front(), {share, false, {}, 0.0});
            const Ran one = ran(&file);
            EXPECT_EQ(one.data.state,
                      parts == 1 ? AnalysisState::complete : AnalysisState::partial);
            drawn += one.drawn;
        }
        EXPECT_EQ(drawn, 2 * 20) << "every case once, in both bands";
        EXPECT_EQ(joinedCases(files).table.toCsv(), whole()) << parts;
    }
}

TEST(CaseFile, IsGoneOnWithWhereverItWasCutOff) {
    const test::TemporaryFolder folder;
    const fs::path place = folder / "a.csv.cases";
    {
        CaseFile file(place, {{}, false, {}, 0.0});
        ran(&file);
    }
    const std::string complete = readTextFile(place), expected = whole();
    for (std::size_t size = 0; size <= complete.size(); size += 173) {
        std::ofstream(place, std::ios::binary) << complete.substr(0, size);
        CaseFile file(place, {{}, true, {}, 0.0});
        const Ran again = ran(&file);
        EXPECT_EQ(again.data.table.toCsv(), expected) << size;
        EXPECT_LE(again.drawn, 40) << size;
        if (size > complete.size() / 2) {
            EXPECT_LT(again.drawn, 24) << size;
        }
        EXPECT_EQ(joinedCases({place}).table.toCsv(), expected) << size;
    }
}

TEST(CaseFile, RefusesCasesOfAnotherRun) {
    const test::TemporaryFolder folder;
    const fs::path place = folder / "a.csv.cases";
    const std::map<std::string, std::string> inputs{{"a.sigdb", "1234"}};
    {
        CaseFile file(place, {{}, false, inputs, 0.0});
        ran(&file);
    }
    const auto refusal = [&](CaseFile::Options options, const AnalysisData& data) {
        return test::refusalOf([&] {
            CaseFile file(place, std::move(options));
            ran(&file, data);
        });
    };
    EXPECT_EQ(refusal({{}, true, inputs, 0.0}, asked()), "nothing was refused");
    AnalysisData other = asked();
    other.settings.set("camera.azimuth", "12.5");
    EXPECT_THAT(refusal({{}, true, inputs, 0.0}, other), HasSubstr("camera.azimuth"));
    EXPECT_THAT(refusal({{}, true, {{"a.sigdb", "99"}}, 0.0}, asked()),
                HasSubstr("content of a.sigdb"));
    EXPECT_THAT(refusal({{}, true, inputs, 0.0}, asked("21")), HasSubstr("cases"));
    EXPECT_THAT(refusal({{1, 2}, true, inputs, 0.0}, asked()), HasSubstr("1/1"));
    std::string text = readTextFile(place);
    text.replace(text.find("\"row\":\"", text.size() / 2) + 7, 1, "x");
    std::ofstream(place, std::ios::binary) << text;
    EXPECT_THAT(refusal({{}, true, inputs, 0.0}, asked()), HasSubstr("numbers separated"));
}

TEST(CaseFile, KeepsWhatIsNotGoneOnWith) {
    const test::TemporaryFolder folder;
    const fs::path place = folder / "a.csv.cases";
    {
        CaseFile file(place, {{}, false, {}, 0.0});
        ran(&file);
    }
    const std::string before = readTextFile(place);
    CaseFile file(place, {{}, false, {}, 0.0});
    ran(&file, asked("5"));
    EXPECT_TRUE(file.keptOld());
    EXPECT_EQ(readTextFile(folder / "a.csv.cases.old"), before);
    file.remove();
    EXPECT_FALSE(fs::exists(place));
    EXPECT_FALSE(fs::exists(folder / "a.csv.cases.old"));
    EXPECT_FALSE(file.keptOld());
    // A short run leaves nothing.
    CaseFile brief(place, {{}, false, {}, 1000.0});
    ran(&brief);
    EXPECT_FALSE(fs::exists(place));
}

TEST(CaseFile, SaysWhichPartsAreMissing) {
    const test::TemporaryFolder folder;
    std::vector<fs::path> files;
    for (std::size_t part : {1U, 3U}) {
        files.push_back(CaseFile::besides(folder / "a.csv", {part, 4}));
        CaseFile file(files.back(), {{part, 4}, false, {}, 0.0});
        ran(&file);
    }
    const std::string refusal = test::refusalOf([&] { joinedCases(files); });
    EXPECT_THAT(refusal, HasSubstr("10 of 20"));
    EXPECT_THAT(refusal, HasSubstr("2/4, 4/4"));
    EXPECT_THAT(test::refusalOf([] { CaseShare::fromText("0/4", "--shard"); }),
                HasSubstr("--shard"));
    EXPECT_THAT(test::refusalOf([] { CaseShare::fromText("5/4", "--shard"); }), HasSubstr("5/4"));
}

TEST(CaseFile, DamagedHeadsAreRefusedByWhatIsWrong) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "a.csv.part1of2";
    const auto refusalOf = [&](const std::string& changed, const std::string& by) {
        AnalysisData data = asked();
        data.table.add("range", "m");
        std::string head = CaseFile::headText(data, 2, {{1, 2}, false, {{"a.sigdb", "00"}}, 0.0});
        const std::size_t at = head.find(changed);
        EXPECT_NE(at, head.npos) << changed;
        writeTextFile(file, head.replace(at, changed.size(), by));
        return test::refusalOf([&] { joinedCases({file}); });
    };
    EXPECT_THAT(refusalOf(R"("a.sigdb":"00")", R"("a.sigdb":7)"), HasSubstr("a.sigdb: found 7"));
    EXPECT_THAT(refusalOf(R"({"a.sigdb":"00"})", "[]"), HasSubstr("inputs: found []"));
    EXPECT_THAT(refusalOf(R"("cases":2)", R"("cases":1e8)"), HasSubstr("from 1 to 1e7"));
    // As many parts as cases: their names are not all told, and nothing takes for ever.
    const std::string many = refusalOf(R"("parts":2,"cases":2)", R"("parts":1e7,"cases":1e7)");
    EXPECT_THAT(many, HasSubstr("10000000 of 10000000 cases without a result"));
    EXPECT_THAT(many, HasSubstr("100/10000000 and 9999900 more"));
}

} // namespace
} // namespace smat
