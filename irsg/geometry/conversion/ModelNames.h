#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "irsg/geometry/reading/ModelCodes.h"

namespace irsg {

/// What of a model carries a name: for lists to choose from.
struct NamedFaces {
    long polygons = 0;
    double area = 0.0;             ///< in squares of the file's unit
    std::map<IrCodes, long> codes; ///< polygons
};
/// By kind of rule, in the order of CodeRule::Of, and name. Faces without a name stand under "".
using NamesOfKinds = std::vector<std::map<std::string, NamedFaces>>;

struct ModelNames {
    NamesOfKinds names;
    std::vector<std::string> remarks; ///< what of the codes fits nothing
};
/// Of a model with codes beside it, in place of those that are there. Throws InputError as
/// loadGraph does.
ModelNames namesOf(const std::filesystem::path& model, const ModelCodes& codes);

} // namespace irsg
