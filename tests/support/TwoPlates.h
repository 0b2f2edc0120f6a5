#pragma once

#include <map>
#include <string>

namespace irsg::test {

/// Two plates, of 2 m^2 in the plane z = 0 and of 3 m^2 above it, as a text in each format that has
/// one, by its extension; formats of nodes call them Hull and Exhaust, and their materials, where
/// there are some, PaintGrey and HotPipe. Lines end in \n.
const std::map<std::string, std::string>& twoPlates();

} // namespace irsg::test
