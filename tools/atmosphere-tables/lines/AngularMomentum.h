#pragma once

namespace irsg::lbl {

/// The Clebsch-Gordan coefficient <J k 1 q | J' k+q> in Condon and Shortley's phases, q = -1, 0 or
/// 1, J' = J - 1, J or J + 1; 0 where the three do not couple.
double clebschGordan(int J, int k, int q, int upperJ);

} // namespace irsg::lbl
