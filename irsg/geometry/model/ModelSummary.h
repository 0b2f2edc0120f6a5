#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "irsg/geometry/model/Model.h"

namespace irsg {

/// What there is to say about a model file without drawing it.
struct ModelSummary {
    std::filesystem::path file;
    std::string format;                            ///< "OpenFlight 16.10", or the extension
    std::vector<std::filesystem::path> references; ///< other OpenFlight files it is made of
    int faces = 0;                                 ///< sum of the codes' faces
    int drawables = 0;
    long triangles = 0, vertices = 0; ///< as they are drawn
    double area_m2 = 0.0;
    std::map<IrCodes, CodeUse> codes;
    BoundingBox bounds;
    std::vector<std::string> remarks;
};

/// Loads the model as Model::load does and throws as it does.
ModelSummary summarizeModel(const std::filesystem::path& file, const ModelOptions& options = {});

/// A page of text: a line each for format, size, bounds, every pair of codes and every remark.
std::string toText(const ModelSummary& summary);

} // namespace irsg
