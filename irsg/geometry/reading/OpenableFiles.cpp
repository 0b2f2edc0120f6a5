#include "irsg/geometry/reading/OpenableFiles.h"

#include <algorithm>
#include <cctype>

#include "irsg/core/Wording.h"

namespace irsg {
namespace {

constexpr FileFormat by(const char* extension, const char* plugin) {
    return {extension, FormatReader::plugin, plugin};
}
constexpr FileFormat byUs(const char* extension) {
    return {extension, FormatReader::ours, ""};
}
constexpr FileFormat byAssimp(const char* extension) {
    return {extension, FormatReader::assimp, ""};
}

constexpr FileFormat models[] = {
    {"flt", FormatReader::flight, "openflight"},
    by("osgt", "osg"),
    by("osgb", "osg"),
    by("ive", "ive"),
    by("osg", "osg"),
    by("osgx", "osg"),
    byAssimp("gltf"),
    byAssimp("glb"),
    byAssimp("fbx"),
    byAssimp("dae"),
    byUs("obj"),
    by("3ds", "3ds"),
    byUs("stl"),
    byUs("ply"),
    by("ac", "ac"),
    byUs("dxf"),
    by("lwo", "lwo"),
    {"x", FormatReader::assimp, "x"}, // without Assimp by the plug-in, which drops names
};

constexpr FileFormat pictures[] = {
    by("png", "png"), by("jpg", "jpeg"), by("jpeg", "jpeg"), by("tif", "tiff"), by("tiff", "tiff"),
    byUs("exr"),      by("hdr", "hdr"),  by("rgb", "rgb"),   by("rgba", "rgb"), by("sgi", "rgb"),
    by("int", "rgb"), by("inta", "rgb"), by("bw", "rgb"),    by("bmp", "bmp"),  by("tga", "tga"),
    by("dds", "dds"), by("gif", "gif"),  by("pnm", "pnm"),   by("ppm", "pnm"),  by("pgm", "pnm"),
    by("pbm", "pnm"),
};

constexpr FileFormat attributes[] = {by("attr", "openflight")};

constexpr FileFormat materials[] = {byUs("mtl")};

constexpr FileFormat buffers[] = {byAssimp("bin")};

std::string extensionOf(const std::string& name) {
    const auto dot = name.find_last_of('.');
    const auto slash = name.find_last_of("/\\");
    return dot == name.npos || (slash != name.npos && dot < slash)
               ? ""
               : lowerCase(name.substr(dot + 1));
}

const FileFormat* modelFormatOf(const std::string& name) {
    const auto* format = std::ranges::find(models, extensionOf(name), &FileFormat::extension);
    return format == std::end(models) ? nullptr : format;
}

/// "http://host/a.png", and what is left of its two slashes once a path was made of it.
bool isAddress(const std::string& name) {
    for (auto colon = name.find(":/"); colon != name.npos; colon = name.find(":/", colon + 1)) {
        auto begin = colon;
        while (begin > 0 && (std::isalnum(static_cast<unsigned char>(name[begin - 1])) ||
                             name[begin - 1] == '+' || name[begin - 1] == '-'))
            --begin;
        const bool isDrive = begin == 0 && colon == 1 && !name.substr(colon).starts_with("://");
        if (begin < colon && !isDrive && (begin == 0 || name[begin - 1] == '/'))
            return true;
    }
    return name.find("://") != name.npos;
}

/// OpenSceneGraph opens what stands before the slash as an archive.
bool isInsideArchive(const std::string& name) {
    static constexpr const char* archives[] = {".osga", ".zip", ".tgz", ".gz", ".tar", ".7z"};
    const std::string lower = lowerCase(name);
    return std::ranges::any_of(archives, [&](const char* archive) {
        return lower.find(std::string(archive) + '/') != lower.npos ||
               lower.find(std::string(archive) + '\\') != lower.npos;
    });
}

} // namespace

std::span<const FileFormat> formatsOf(FileKind kind) {
    switch (kind) {
    case FileKind::model:
        return models;
    case FileKind::picture:
        return pictures;
    case FileKind::attributes:
        return attributes;
    case FileKind::materials:
        return materials;
    case FileKind::buffers:
        return buffers;
    }
    return {};
}

FormatReader modelReaderOf(const std::string& name) {
    const FileFormat* format = modelFormatOf(name);
    return format ? format->reader : FormatReader::plugin;
}

std::string readerNameOf(const std::string& name) {
    switch (modelReaderOf(name)) {
    case FormatReader::assimp:
        return "Assimp";
    case FormatReader::ours:
        return "this program";
    case FormatReader::plugin:
    case FormatReader::flight:
        break;
    }
    return "OpenSceneGraph";
}

bool hasPlugin(const std::string& name) {
    const FileFormat* format = modelFormatOf(name);
    return format && *format->plugin;
}

std::optional<std::string> refusalOf(const std::string& name, FileKind kind) {
    if (name.find('\0') != name.npos)
        return "a name with a zero byte";
    if (isAddress(name))
        return "an address, from which nothing is fetched";
    if (isInsideArchive(name))
        return "a file inside an archive";
    const std::string extension = extensionOf(name);
    const auto isOurs = [&](const FileFormat& format) { return extension == format.extension; };
    if (std::ranges::none_of(formatsOf(kind), isOurs))
        return "a file of type \"." + extension + "\"";
    return std::nullopt;
}

std::string expectationOf(FileKind kind) {
    std::string text = kind == FileKind::model       ? "a model of type "
                       : kind == FileKind::picture   ? "a picture of type "
                       : kind == FileKind::materials ? "a library of materials of type "
                       : kind == FileKind::buffers   ? "numbers of a model, of type "
                                                     : "attributes of a picture, of type ";
    const auto formats = formatsOf(kind);
    for (std::size_t i = 0; i < formats.size(); ++i)
        text += (i == 0                    ? "."
                 : i + 1 == formats.size() ? " or ."
                                           : ", .") +
                std::string(formats[i].extension);
    return text;
}

bool mayLoadLibrary(const std::string& name) {
    const auto slash = name.find_last_of('/');
    const std::string folder = slash == name.npos ? "" : name.substr(0, slash);
    const std::string file = slash == name.npos ? name : name.substr(slash + 1);
    if (!folder.empty() && (!folder.starts_with("osgPlugins-") || folder.find('/') != folder.npos))
        return false;
    if (file.starts_with("libosg") || file.starts_with("osgdb_serializers_osg") ||
        file.starts_with("osgdb_deprecated_osg"))
        return true;
    for (const FileKind kind : {FileKind::model, FileKind::picture, FileKind::attributes})
        for (const FileFormat& format : formatsOf(kind))
            if (*format.plugin && file.starts_with("osgdb_" + std::string(format.plugin) + "."))
                return true;
    return false;
}

std::string filterOf(FileKind kind) {
    std::string text;
    for (const FileFormat& format : formatsOf(kind))
        text += (text.empty() ? "*." : " *.") + std::string(format.extension);
    return text;
}

} // namespace irsg
