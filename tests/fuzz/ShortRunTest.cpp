#include <filesystem>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "irsg/core/FileReading.h"
#include "tests/fuzz/Readers.h"
#include "tests/support/WalkedReaders.h"

namespace smat::test {

void PrintTo(const FuzzedReader& reader, std::ostream* out) {
    *out << reader.name;
}

namespace {

/// Some bytes changed, taken out, doubled or cut off, the same on every machine.
std::string mutant(std::mt19937& random, std::string bytes) {
    static const std::string tokens[] = {
        "-1",   "0",  "1e999", "nan", "inf",  "99999999999999999999",
        "\"",   "{",  "[",     "<",   "/>",   ",,",
        "\xff", "\r", "\n\n",  "#",   "1e-9", std::string(1, '\0')};
    for (unsigned i = 0, count = 1 + random() % 4; i < count && !bytes.empty(); ++i) {
        const std::size_t at = random() % bytes.size();
        switch (random() % 6) {
        case 0:
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
            break;
        case 1:
            bytes.resize(at);
            break;
        case 2:
            bytes.erase(at, random() % 32);
            break;
        case 3:
            bytes.insert(at, bytes.substr(at, random() % 256));
            break;
        case 4:
            bytes.insert(at, tokens[random() % std::size(tokens)]);
            break;
        default:
            bytes.replace(at, 4, std::string(4, random() % 2 ? '\xff' : '\x7f'));
        }
    }
    return bytes;
}

class ShortRun : public testing::TestWithParam<FuzzedReader> {};

} // namespace

TEST_P(ShortRun, GivesAnAnswerOrASentence) {
    const FuzzedReader& reader = GetParam();
    const std::vector<std::string> seeds = seedsOf(reader);
    ASSERT_FALSE(seeds.empty());
    std::mt19937 random(1);
    bool anyIsRead = false;
    for (const std::string& seed : seeds) {
        ASSERT_FALSE(seed.empty());
        ASSERT_NO_THROW(anyIsRead = readBytes(reader, seed) || anyIsRead);
    }
    EXPECT_TRUE(anyIsRead) << "what is made of refused files stays at the door";
    for (int i = 0; i < 300; ++i) {
        const std::string bytes = mutant(random, seeds[random() % seeds.size()]);
        try {
            readBytes(reader, bytes);
        } catch (const std::exception& error) {
            FAIL() << error.what() << " over " << testing::PrintToString(bytes.substr(0, 2000));
        }
    }
}

TEST(WalkedReaders, OfDamagedBytesAreAsManyAsThePageHas) {
    expectWalked("damaged bytes", fuzzedReaders().size());
}

TEST(WalkedReaders, EachRowIsComparedByATest) {
    namespace fs = std::filesystem;
    std::string sources;
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(SMAT_SOURCE_DIR) / "tests")) {
        if (entry.path().extension() == ".cpp") {
            sources += irsg::readFile(entry.path());
        }
    }
    const std::vector<std::string> kinds = walkedKinds();
    EXPECT_FALSE(kinds.empty());
    for (const std::string& kind : kinds) {
        EXPECT_NE(sources.find("expectWalked(\"" + kind + "\""), sources.npos) << kind;
    }
}

INSTANTIATE_TEST_SUITE_P(Readers, ShortRun, testing::ValuesIn(fuzzedReaders()),
                         [](const auto& reader) {
                             std::string name = reader.param.name;
                             for (char& c : name) {
                                 c = c == '-' ? '_' : c;
                             }
                             return name;
                         });

} // namespace smat::test
