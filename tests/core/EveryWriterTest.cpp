#include <cerrno>
#include <filesystem>
#include <functional>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/image/CsvImage.h"
#include "irsg/image/ExrFile.h"
#include "irsg/karma/KarmaXml.h"
#include "irsg/radiometry/FileReading.h"
#include "irsg/radiometry/FileReplacement.h"
#include "irsg/signature/MaterialCsv.h"
#include "irsg/signature/ScalingXml.h"
#include "irsg/signature/SignatureFile.h"
#include "irsg/signature/SpectrumCsv.h"
#include "smatcore/data/ResultTable.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/support/EveryCall.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

namespace fs = std::filesystem;

/// A writer of one kind of file: writes the first or the second content.
struct Writer {
    const char* name;
    const char* file;
    std::function<void(const fs::path& file, bool second)> write;
    /// What a file holds, however its bytes are arranged.
    std::function<std::string(const fs::path& file)> content;
};

void PrintTo(const Writer& writer, std::ostream* out) {
    *out << writer.name;
}

std::string bytesOf(const fs::path& file) {
    return irsg::readFile(file);
}

irsg::RadianceImage image(bool second) {
    irsg::RadianceImage made(4, 3, "L", "W m-2 sr-1");
    made.channels.front().values.assign(12, second ? 2.0f : 1.0f);
    return made;
}

irsg::SignatureDatabase made(bool second) {
    const fs::path sample = fs::path(SMAT_SOURCE_DIR) / "samples/box/box.sigdb";
    irsg::SignatureDatabase database = irsg::loadSignatureFile(sample).database;
    database.title = second ? "second" : "first";
    // More pages than a journal of one.
    database.notes = std::string(second ? 20000 : 10, 'n');
    return database;
}

const irsg::SignatureDatabase& database(bool second) {
    static const irsg::SignatureDatabase all[] = {made(false), made(true)};
    return all[second];
}

ResultTable table(bool second) {
    ResultTable made;
    made.add(irsg::Quantity::range);
    made.addRow({second ? 2.0 : 1.0});
    return made;
}

const std::vector<Writer>& writers() {
    static const std::vector<Writer> list = {
        {"Text", "a.txt",
         [](const fs::path& file, bool second) {
             irsg::writeFileDurably(file, second ? "second" : "first");
         },
         bytesOf},
        {"ExrImage", "a.exr",
         [](const fs::path& file, bool second) { irsg::writeExr(image(second), file); }, bytesOf},
        {"CsvImage", "a.csv",
         [](const fs::path& file, bool second) { irsg::writeCsvImage(image(second), file); },
         bytesOf},
        {"ResultTable", "a.csv",
         [](const fs::path& file, bool second) { table(second).save(file); }, bytesOf},
        {"ResultJson", "a.json",
         [](const fs::path& file, bool second) { table(second).save(file); }, bytesOf},
        {"Project", "a.smat",
         [](const fs::path& file, bool second) {
             Project project;
             project.notes = second ? "second" : "first";
             saveProject(project, file);
         },
         bytesOf},
        {"KarmaXml", "a.xml",
         [](const fs::path& file, bool second) {
             irsg::KarmaXml::read(fs::path(SMAT_RESOURCES_DIR) / "atmospheres" /
                                  (second ? "tropical-maritime.xml" : "subarctic-winter.xml"))
                 .write(file);
         },
         bytesOf},
        {"Database", "a.sigdb",
         [](const fs::path& file, bool second) { irsg::saveSignatureFile(database(second), file); },
         [](const fs::path& file) {
             return irsg::signatureToJson(irsg::loadSignatureFile(file).database);
         }},
    };
    return list;
}

std::set<std::string> namesIn(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

class EveryWriter : public testing::TestWithParam<Writer> {
  protected:
    void SetUp() override {
        if (!callsCanBeWatched())
            GTEST_SKIP() << "one process cannot watch the calls of another here";
        const TemporaryFolder folder;
        const fs::path file = folder / GetParam().file;
        for (const bool second : {false, true}) {
            GetParam().write(file, second);
            (second ? new_ : old_) = GetParam().content(file);
        }
        ASSERT_NE(old_, new_);
    }

    /// Old or new, whole, and nothing beside it; where nothing was, nothing may be left.
    void meets(const Mishap& mishap, bool stands) {
        const Writer& writer = GetParam();
        const TemporaryFolder folder;
        const fs::path file = folder / writer.file;
        // By another process: this one remembers the folders that it has cleared.
        if (stands)
            doElsewhere([&] { writer.write(file, false); });
        const Ended ended = doWatched([&] { writer.write(file, true); }, mishap);
        const std::string where = std::string(mishap.kind == Mishap::killed ? "killed" : "failed") +
                                  " at call " + std::to_string(mishap.call) + ", number " +
                                  ended.name + (stands ? " over a file" : " where nothing was");
        if (mishap.kind == Mishap::fails) {
            EXPECT_TRUE(ended.exitCode == 0 || ended.exitCode == 2) << where << ended.exitCode;
        }
        const bool isThere = fs::exists(file);
        EXPECT_TRUE(isThere || !stands) << where;
        if (isThere) {
            const std::string content = writer.content(file);
            EXPECT_TRUE(content == new_ || (stands && content == old_)) << where;
            if (ended.exitCode == 0) {
                EXPECT_EQ(content, new_) << where;
            }
        }
        if (mishap.kind == Mishap::killed) {
            // Whoever writes next clears away what a killed program could not.
            EXPECT_EQ(doElsewhere([&] { writer.write(file, true); }), 0) << where;
        }
        EXPECT_EQ(namesIn(folder.path()),
                  fs::exists(file) ? std::set<std::string>{writer.file} : std::set<std::string>())
            << where;
    }

    std::string old_, new_;
};

TEST_P(EveryWriter, LeavesTheOldFileOrTheNewOneWhateverHappensAtAnyCall) {
    const Writer& writer = GetParam();
    for (const bool stands : {false, true}) {
        const TemporaryFolder folder;
        if (stands)
            writer.write(folder / writer.file, false);
        const Ended whole = doWatched([&] { writer.write(folder / writer.file, true); }, {});
        ASSERT_EQ(whole.exitCode, 0);
        ASSERT_GT(whole.calls, 5);
        ASSERT_LT(whole.calls, 3000);
        for (long call = 1; call <= whole.calls; ++call) {
            meets({Mishap::killed, call, 0}, stands);
            meets({Mishap::fails, call, call % 2 == 0 ? ENOSPC : EIO}, stands);
            if (HasFailure())
                return;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, EveryWriter, testing::ValuesIn(writers()),
                         [](const auto& writer) { return std::string(writer.param.name); });

} // namespace
} // namespace smat::test
