#pragma once

namespace smat {

/// Smooth noise of three coordinates from a hash of its lattice: 0 to 1, about one feature a unit,
/// the same on every machine.
double smoothNoise(double x, double y, double z);
/// A sum of `octaves` of it, each of twice the frequency and half the size: 0 to 1.
double fractalNoise(double x, double y, double z, int octaves);
/// 0 below `low`, 1 above `high`, a smooth step between.
double smoothStep(double low, double high, double value);

} // namespace smat
