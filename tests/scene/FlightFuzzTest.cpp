// Damaged OpenFlight files: each is either loaded or refused with its place, never a crash.
#include <random>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/geometry/model/Model.h"
#include "tests/support/FlightBytes.h"

using namespace irsg;
using namespace irsg::test;
namespace fs = std::filesystem;

namespace {

const fs::path data = fs::path(SMAT_SOURCE_DIR) / "tests/data/models";

constexpr int rounds = 200;

/// The same damage in every run; --gtest_random_seed=N does other damage.
unsigned int seed(int which) {
    return static_cast<unsigned int>(10 * testing::UnitTest::GetInstance()->random_seed() + which);
}

/// Loads damaged bytes beside the undamaged file they refer to and counts what becomes of them.
class Mill {
  public:
    Mill() { folder_.write("sub/part.flt", readBytes(data / "sub/part.flt")); }

    void grind(const std::string& bytes, const std::string& what) {
        const auto file = folder_.write("damaged.flt", bytes);
        try {
            const auto model = Model::load(file);
            ++loaded;
            EXPECT_GT(model->mesh()->facets(), 0u) << what;
            EXPECT_TRUE(model->bounds().valid()) << what;
        } catch (const InputError& error) {
            ++refused;
            EXPECT_FALSE(error.diagnostics().empty()) << what;
            EXPECT_NE(error.diagnostics().front().file, "") << what;
            withByte += error.diagnostics().front().position.starts_with("byte ");
        }
    }

    int loaded = 0, refused = 0, withByte = 0;

  private:
    TemporaryFolder folder_;
};

class Damage : public testing::TestWithParam<const char*> {
  protected:
    std::string whole() const {
        const fs::path file = GetParam();
        return readBytes(file.has_parent_path() && file.begin()->string() == "samples"
                             ? fs::path(SMAT_SOURCE_DIR) / file
                             : data / file);
    }
};

} // namespace

TEST_P(Damage, OfAnyLengthIsRefusedWithTheByteItEndsAt) {
    const auto bytes = whole();
    ASSERT_FALSE(bytes.empty());
    Mill mill;
    const std::size_t step = std::max<std::size_t>(1, bytes.size() / 150);
    for (std::size_t length = 0; length < bytes.size(); length += step) {
        mill.grind(bytes.substr(0, length), "cut at " + std::to_string(length));
    }
    EXPECT_EQ(mill.loaded, 0);
    EXPECT_EQ(mill.withByte, mill.refused);
}

TEST_P(Damage, OfAnyBitsIsLoadedOrRefused) {
    const auto bytes = whole();
    Mill mill;
    std::mt19937 random(seed(1));
    for (int round = 0; round < rounds; ++round) {
        auto damaged = bytes;
        const int flips = 1 + round % 8;
        for (int i = 0; i < flips; ++i) {
            damaged[random() % damaged.size()] ^= static_cast<char>(1u << random() % 8);
        }
        mill.grind(damaged, "bits, round " + std::to_string(round));
    }
    EXPECT_GT(mill.loaded, 0);
}

TEST_P(Damage, OfRecordHeadersAndFieldsIsLoadedOrRefused) {
    // Most bits of a file are coordinates and colours; structure is hit by writing small and
    // extreme numbers over whole fields behind the palettes.
    const auto bytes = whole();
    Mill mill;
    std::mt19937 random(seed(2));
    const std::string values[] = {i32(0),          i32(-1), i32(1),  i32(0x7FFFFFFF),
                                  i32(0x80000000), i16(0),  i16(-1), i16(10),
                                  i16(11),         i16(84), i16(72), i16(4)};
    const std::size_t begin = bytes.size() > 5000 ? 4500 : 0;
    for (int round = 0; round < rounds; ++round) {
        auto damaged = bytes;
        const auto& value = values[random() % std::size(values)];
        const auto at = begin + random() % (bytes.size() - begin - 4) / 2 * 2;
        damaged.replace(at, value.size(), value);
        mill.grind(damaged, "field, round " + std::to_string(round));
    }
}

TEST_P(Damage, OfMissingAndRepeatedPiecesIsLoadedOrRefused) {
    const auto bytes = whole();
    Mill mill;
    std::mt19937 random(seed(3));
    for (int round = 0; round < rounds / 2; ++round) {
        auto damaged = bytes;
        const auto at = random() % bytes.size() / 4 * 4;
        const auto length = std::min<std::size_t>(4 + random() % 200 / 4 * 4, bytes.size() - at);
        if (round % 2 == 0) {
            damaged.erase(at, length);
        } else {
            damaged.insert(random() % bytes.size() / 4 * 4, bytes.substr(at, length));
        }
        mill.grind(damaged, "pieces, round " + std::to_string(round));
    }
}

INSTANTIATE_TEST_SUITE_P(Files, Damage,
                         testing::Values("plate.flt", "sub/part.flt", "tricky_1420.flt",
                                         "tricky_1540.flt", "tricky_1640.flt",
                                         "samples/box/box.flt"),
                         [](const auto& info) { return fs::path(info.param).stem().string(); });
