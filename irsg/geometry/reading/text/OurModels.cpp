#include "irsg/geometry/reading/text/OurModels.h"

#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "irsg/geometry/reading/text/DxfReader.h"
#include "irsg/geometry/reading/text/PlyReader.h"
#include "irsg/geometry/reading/text/StlReader.h"

namespace irsg {

LoadedGraph readOurModel(const std::filesystem::path& file, const PictureReading& picture) {
    const std::string extension = lowerCase(file.extension().string());
    if (extension == ".obj")
        return readObj(file, picture);
    if (extension == ".stl")
        return readStl(file);
    if (extension == ".ply")
        return readPly(file);
    if (extension == ".dxf")
        return readDxf(file);
    throw LogicError("no reader of ours for " + file.string());
}

} // namespace irsg
