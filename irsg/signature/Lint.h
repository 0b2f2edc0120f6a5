#pragma once

#include <vector>

#include "irsg/signature/Finding.h"
#include "irsg/signature/LintScope.h"
#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// Checks the physics of a database.
///
/// Errors: emissivity, transmissivity or their sum outside [0, 1] at a node of either, N below 0,
/// numbers that are not finite, names of spectra and components that do not exist, negative
/// factors, angles outside 0 to 180 degrees, loops over anything but time, 0 K or less, texts that
/// are not UTF-8; with a model, codes without an entry.
///
/// Warnings, the suspicion named: temperatures outside 200 to 4000 K at rest in air of 288.15 K and
/// outside 100 to 4000 K over the tables and the states given; degrees Celsius for K; percent for
/// fractions; nm or cm-1 for um; km for m of altitude; radians for degrees; m/s for Mach;
/// brightness temperatures outside 200 to 4000 K, with the unit that would repair them (W cm-2
/// against W m-2, per cm-1 against per um); curves that become a Planck curve only when the density
/// per cm-1 is told from that per um; loops that jump; spectra that do not cover the band; tables
/// that hold their end value in the states given; entries that nothing uses; levels of detail;
/// faces of different codes in one plane.
///
/// Findings come in the order of the database; equal databases give equal findings.
std::vector<Finding> lint(const SignatureDatabase& database, const LintScope& scope = {});
std::vector<Finding> lint(const SignatureDatabase& database, const SpectralRange& band);

/// Repairs what can be repaired without removing anything, and looks again until nothing is left to
/// repair. Returns the findings that were repaired, in order.
std::vector<Finding> repairAll(SignatureDatabase& database, const LintScope& scope = {});

} // namespace irsg
