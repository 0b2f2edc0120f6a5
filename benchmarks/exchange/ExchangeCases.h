#pragma once

#include <filesystem>
#include <vector>

#include "tests/support/ExchangeCase.h"

namespace irsg::bench {

/// Samples of the program, as they are, read two-sided and in another format.
std::vector<test::NamedCases> sampleCases();
/// Models of Debian's packages assimp-testmodels and flightgear-data-ai.
struct FileAspects;
std::vector<test::NamedCases> publicModelCases(const FileAspects& aspects);

/// A model file from 8 aspects, emissivity 0.7, 330 K, in sun and sky or by its emission alone.
struct FileAspects {
    bool isTwoSided = false, isEmissionAlone = false;
    /// Light is reflected by the normals of the file; else by those of facets, as the path tracer
    /// has them.
    bool hasOwnNormals = false;
    double elevation_deg = 10.0;

    std::vector<test::ExchangeCase> of(const std::filesystem::path& file) const;
};

} // namespace irsg::bench
