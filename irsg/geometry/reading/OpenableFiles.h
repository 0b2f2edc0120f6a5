#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace irsg {

/// What a name in a project or a model may stand for.
enum class FileKind {
    model,
    picture,
    attributes, ///< what OpenFlight keeps beside a picture, NAME.attr
    materials,  ///< what a Wavefront object is painted with
    buffers     ///< numbers of a .gltf
};

/// A text model of 30 million facets.
constexpr std::uint64_t largestModel_B = std::uint64_t{4} << 30;

/// Who reads a format.
enum class FormatReader {
    plugin,
    flight, ///< a plug-in, of what our scanner checked
    ours,
    assimp
};

/// A format and what reads it.
struct FileFormat {
    const char* extension; ///< lower case, without its dot
    FormatReader reader = FormatReader::plugin;
    /// Of OpenSceneGraph, "openflight" for osgdb_openflight; beside Assimp what reads without it.
    const char* plugin = "";
};

/// The whole list of what is opened, first the formats that are named first to a user. Whatever is
/// not in it stays closed, even where OpenSceneGraph has a plug-in for it: many of them run a
/// script, call a shell, unpack an archive or fetch over a network.
std::span<const FileFormat> formatsOf(FileKind kind);

/// Who reads the models of this name.
FormatReader modelReaderOf(const std::string& name);
/// What reads a file of this name apart from the program, for messages: "Assimp",
/// "OpenSceneGraph" or "this program".
std::string readerNameOf(const std::string& name);
/// Whether a plug-in of OpenSceneGraph can read them.
bool hasPlugin(const std::string& name);

/// Why a name may not be opened as this kind of file, in words such as `a file of type ".lua"`;
/// nothing where it may. Judges the name alone, upper and lower case alike.
std::optional<std::string> refusalOf(const std::string& name, FileKind kind);

/// "a model of type .flt, .osgt ...".
std::string expectationOf(FileKind kind);

/// Whether a library that OpenSceneGraph wants to load ("osgPlugins-3.6.5/osgdb_png.so") reads a
/// format of the list, or is one of its own libraries of node classes.
bool mayLoadLibrary(const std::string& name);

/// "*.flt *.osgt ...", for a dialog that asks for a file.
std::string filterOf(FileKind kind);

} // namespace irsg
