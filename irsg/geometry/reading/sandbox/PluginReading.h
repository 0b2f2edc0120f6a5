#pragma once

#include <filesystem>

#include <osg/Image>

#include "irsg/geometry/reading/LoadedGraph.h"

namespace irsg {

/// What is to be in place before a process gives up what it does not need.
void preparePlugins();

/// Reads models of the formats that OpenableFiles.h gives to Assimp: the bytes at a place as those
/// of a file.
using AssimpReading = LoadedGraph (*)(const std::filesystem::path& place,
                                      const std::filesystem::path& file);
/// Without one those formats are refused by name. To be called before the first model is read.
void setAssimpReading(AssimpReading reading);

/// Reads a model by OpenSceneGraph or Assimp in this process, with all that it refers to: the bytes
/// at `place` as those of `file`, which is the same place as a rule. Remarks are as loadGraph()
/// gives them. Throws InputError for one that cannot be read, or that ends before it says it does.
LoadedGraph readModelHere(const std::filesystem::path& place, const std::filesystem::path& file);

/// A model of a format that OpenableFiles.h gives to us likewise, with pictures as they are asked
/// for.
LoadedGraph readOurHere(const std::filesystem::path& file);

/// A picture likewise.
osg::ref_ptr<osg::Image> readPictureHere(const std::filesystem::path& file);

} // namespace irsg
