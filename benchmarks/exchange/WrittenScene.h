#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tests/support/ExchangeCase.h"

namespace irsg::bench {

/// What bench_exchange knows of a case.
struct Judged {
    double truth_W_sr = 0.0, truthError_W_sr = 0.0;
    double library_W_sr = 0.0, statedError_W_sr = 0.0, library_s = 0.0;
};

/// Writes the facets of a case and who looks at them for other renderers
/// (benchmarks/mitsuba_witness.py), with what is known: FOLDER/NUMBER.json, and a binary .ply for
/// each kind of facets, which the document lists with emitted radiance, reflectivity and whether
/// they are two-sided. Throws std::runtime_error where a file cannot be written.
void writeScene(const test::ExchangeCase& one, const Judged& known,
                const std::filesystem::path& folder);

} // namespace irsg::bench
