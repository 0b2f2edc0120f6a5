#pragma once

#include <filesystem>
#include <mutex>
#include <string>

#include "irsg/geometry/reading/LoadedGraph.h"
#include "irsg/geometry/reading/ModelCodes.h"
#include "irsg/geometry/reading/ModelValues.h"

namespace irsg {

/// What the graph is for: the infrared picture needs geometry, normals and codes; the visible
/// display needs textures and materials, too.
enum class LoadPurpose { infrared, visible };
/// What a model with these options is read for: textures are needed where they cut.
LoadPurpose purposeOf(const ModelOptions& options);

/// To be held while a plug-in of OpenSceneGraph writes: the registry of plug-ins and their caches
/// belong to the whole process.
std::mutex& osgRegistryMutex();

/// Reads a model of OpenableFiles.h in the reading process: of .flt, with its external references,
/// each file once, what our scanner validated. Codes are on drawables or nodes as codesOf()
/// finds them. What OpenSceneGraph prints becomes remarks, and so does every file that a model
/// refers to and that OpenableFiles.h does not list: it stays closed. Throws InputError for a file
/// that is missing, malformed, of a kind that is not opened, or empty.
LoadedGraph loadGraphAsIs(const std::filesystem::path& file, LoadPurpose purpose);

/// The same with the codes that a file beside the model gives it (ModelCodes), which win; what of
/// them fits nothing becomes remarks. Faces are then not those of the file's records.
LoadedGraph loadGraph(const std::filesystem::path& file, LoadPurpose purpose);

/// The same of what was read already, whose graph stays as it is, with these codes.
LoadedGraph withCodes(LoadedGraph asIs, const ModelCodes& codes, const std::filesystem::path& file);

/// What OpenSceneGraph reads of these bytes as those of a file of this name, where it is not one
/// of those that we read.
LoadedGraph loadWritten(const std::string& bytes, const std::filesystem::path& name);

} // namespace irsg
