#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "smatcore/data/ResultTable.h"
#include "tests/cli/PlainScene.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {

/// Radiant intensities in 4.4-4.6 um of the model NAME.obj of a folder, as a polar sweep sees them:
/// so far away that lines of sight are parallel, and finely.
inline std::vector<double> seenPlume_W_sr(const TemporaryFolder& folder, const std::string& name,
                                          const std::string& from_deg, const std::string& to_deg,
                                          const std::string& step_deg) {
    const Ran ran = smatBatch(with({"polar",          name + ".obj",
                                    "--database",     name + ".sigdb",
                                    "--band",         "4.4-4.6",
                                    "--from",         from_deg,
                                    "--to",           to_deg,
                                    "--step",         step_deg,
                                    "--range",        "20000",
                                    "--background",   "none",
                                    "--atmosphere",   "none",
                                    "--out",          "polar.csv",
                                    "--antialiasing", "5"},
                                   plain),
                              folder.path());
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    return ran.exitCode == 0 ? ResultTable::load(folder / "polar.csv").find("intensity")->values
                             : std::vector<double>();
}

} // namespace smat::test
