#pragma once

#include <gtest/gtest.h>

#include "irsg/render/rays/RaysBuilt.h"

namespace irsg::test {

/// Tests that send rays: skipped, by name, in a build without them.
class RaysTest : public testing::Test {
  protected:
    void SetUp() override {
        if (!areRaysBuilt()) {
            GTEST_SKIP() << whyNoRays();
        }
    }
};

} // namespace irsg::test
