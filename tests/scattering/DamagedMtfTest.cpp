#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "tests/scattering/DamagedMtfFiles.h"

namespace irsg {
namespace {

TEST(DamagedMtf, IsRefusedByNameAndByteOffset) {
    const std::vector<DamagedMtf> files = damagedMtfFiles();
    ASSERT_GE(files.size(), 30u);
    for (const DamagedMtf& damaged : files) {
        SCOPED_TRACE(damaged.name);
        try {
            MtfDatabase::fromBytes(damaged.bytes, "haze.mtf");
            ADD_FAILURE() << "was read";
        } catch (const InputError& error) {
            ASSERT_FALSE(error.diagnostics().empty());
            const Diagnostic& first = error.diagnostics().front();
            EXPECT_EQ(first.file, "haze.mtf");
            EXPECT_EQ(first.position, damaged.position) << error.what();
            EXPECT_FALSE(first.value.empty());
            EXPECT_FALSE(first.expected.empty());
        }
    }
}

TEST(DamagedMtf, TellsEveryDiagnosticUpToTwenty) {
    std::string bytes = smallDatabase().bytes();
    for (std::size_t at = 40; at < bytes.size(); at += 8) {
        putDouble(bytes, at, -3.0);
    }
    try {
        MtfDatabase::fromBytes(bytes, "haze.mtf");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.diagnostics().size(), 14u);
        EXPECT_EQ(error.diagnostics().back().position, "byte 144");
    }
}

} // namespace
} // namespace irsg
