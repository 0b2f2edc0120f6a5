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

/// The names over a drawable, by which rules find it.
struct FaceNames {
    std::string material, object;
    std::vector<std::string> groups; ///< from the root down, without empty ones
    auto operator<=>(const FaceNames&) const = default;
};
/// Faces by all of their names together.
struct NamedExtent {
    long polygons = 0;
    double area = 0.0; ///< in squares of the file's unit
};
using NamedParts = std::map<FaceNames, NamedExtent>;

struct ModelNames {
    NamesOfKinds names;
    NamedParts parts;
    std::vector<std::string> remarks; ///< what of the codes fits nothing
};
/// Of a model with codes beside it, in place of those that are there. Throws InputError as
/// loadGraph does.
ModelNames namesOf(const std::filesystem::path& model, const ModelCodes& codes);

} // namespace irsg
