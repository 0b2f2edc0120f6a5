#include <clocale>
#include <fstream>

#include "irsg/geometry/model/Model.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/DecimalCommas.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::gui {
namespace {

using LocaleTest = test::WindowFixture;

/// Two triangles of 0.5 and 1.875 m2, whose corners are no whole numbers.
const char* const twoFaces = "v 0.0 0.0 0.0\nv 1.0 0.0 0.0\nv 0.0 1.0 0.0\n"
                             "v 1.5 0 0.5\nv 0 2.5 0.5\nv 0 0 0.5\nf 1 2 3\nf 6 4 5\n";

TEST_F(LocaleTest, TheWindowReadsModelsUnderDecimalCommas) {
    for (const char* name : {"de_DE", "fr_CA"}) {
        const smat::test::TemporaryFolder place;
        const smat::test::DecimalCommas locale(name, place.path());
        if (!locale.isThere()) {
            GTEST_SKIP() << "this system cannot make the locale " << name;
        }
        const std::filesystem::path file = folder / (std::string(name) + ".obj");
        std::ofstream(file) << twoFaces;
        ASSERT_TRUE(opens(file)) << name;
        EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
        ASSERT_STREQ(std::localeconv()->decimal_point, ",") << "the window took the locale away";
        const auto model = workbench.models()->model({file});
        long faces = 0;
        double area_m2 = 0.0;
        for (const auto& [codes, use] : model->codes()) {
            faces += use.faces;
            area_m2 += use.area_m2;
        }
        EXPECT_EQ(faces, 2) << name;
        EXPECT_NEAR(area_m2, 2.375, 1e-6) << name;
    }
}

} // namespace
} // namespace smat::gui
