#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace irsg {

/// The first spectrum of a JCAMP-DX file.
struct JcampText {
    std::string title, xUnits, yUnits;
    int xUnitsLine = 0, yUnitsLine = 0;
    std::vector<double> x, y; ///< of equal length, times XFACTOR and YFACTOR
    std::vector<int> lines;   ///< where each value stands
};

/// Reads XYDATA (X++(Y..Y)), in numbers or in the packed forms PAC, SQZ, DIF and DUP of JCAMP-DX
/// 4.24 (McDonald and Wilks, Appl. Spectrosc. 42, 151, 1988), or XYPOINTS (XY..XY). Abscissas of
/// XYDATA follow from FIRSTX, LASTX and NPOINTS. Throws InputError where they contradict what is
/// there, for a check value of DIF that is not met, and for other kinds of data, such as NTUPLES.
JcampText readJcampText(std::string_view text, const std::string& file);

} // namespace irsg
