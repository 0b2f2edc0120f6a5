#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/image/PngView.h"
#include "irsg/image/RadianceImage.h"

namespace irsg {

/// What a writer may need beside the image.
struct ImageWriting {
    std::string channel = {}; ///< for formats of one plane and pictures; empty: the shown one
    PngViewOptions view = {}; ///< for pictures
};

/// Which of several images in a file is read. Empty: the one that is most likely meant, with a
/// remark that names the others.
struct ImageReading {
    std::string part = {};        ///< of OpenEXR: its name, or its number from 1
    std::optional<int> page = {}; ///< of TIFF: its number from 1
    bool isEmpty() const { return part.empty() && !page; }
    bool operator==(const ImageReading&) const = default;
};

/// One of several images in a file, as a person may choose it.
struct ImagePart {
    std::string words; ///< "2 'radiance': Y, 48 x 32 pixels"
    ImageReading reading;
};

/// A form in which files hold images, as every part of the program knows it: reading by content,
/// writing by extension, filters of file dialogs and messages come from here. A new format is a
/// source with its record and its name in the list IMAGE_FORMATS of irsg/image/CMakeLists.txt.
struct ImageFormat {
    enum class Keeps {
        allPlanes, ///< with attributes, to the last bit
        onePlane,  ///< the same of one plane
        picture    ///< colours, which no values can be read from
    };

    const char* name;          ///< "OpenEXR image", as lists of file types call it
    const char* shortName;     ///< "OpenEXR", as menus do
    const char* extensions;    ///< of files that are written, separated by blanks: ".tif .tiff"
    const char* alsoRead = ""; ///< further ones of files that are read
    Keeps keeps = Keeps::allPlanes;
    bool isUsual = false; ///< among those in which `smat-batch run` writes an image unasked
    bool isText = false;  ///< files of these names may hold a table or a letter as well
    /// Whether a file that begins so (its first 256 KiB, or all) is of this format.
    bool (*recognises)(std::string_view beginning) = nullptr;
    /// Throws InputError; null where nothing can be read.
    RadianceImage (*read)(const std::filesystem::path& file, const ImageReading& what) = nullptr;
    /// Throws InputError where the file cannot be written.
    void (*write)(const RadianceImage& image, const std::filesystem::path& file,
                  const ImageWriting& how) = nullptr;

    /// The images of a file, where a file may hold several; null where it cannot.
    std::vector<ImagePart> (*parts)(const std::filesystem::path& file) = nullptr;
    bool hasPages = false; ///< its parts are pages

    std::vector<std::string> extensionList() const;
};

/// Those that are written and read, in the order of file dialogs; made from IMAGE_FORMATS.
const std::vector<const ImageFormat*>& imageFormats();
/// Those that are only read; made from FOREIGN_IMAGE_FORMATS.
const std::vector<const ImageFormat*>& foreignImageFormats();
/// Those that are read: the foreign ones first, which are told more surely than text.
std::vector<const ImageFormat*> readImageFormats();
/// The format that a file of this name is written in; null for another extension.
const ImageFormat* imageFormatOf(const std::filesystem::path& file);
/// The same; InputError naming the extensions there are.
const ImageFormat& requiredImageFormat(const std::filesystem::path& file);
/// The format that a file of this name, in letters of either case, is read in; null for another
/// extension.
const ImageFormat* readableImageFormatOf(const std::filesystem::path& file);
/// Of files that are written: ".exr", ".csv", ".png", ".tif", ".tiff".
std::vector<std::string> imageExtensions();
/// Of files that are read: ".exr", ".csv", ".txt", ".dat", ".tif", ".tiff", ".hdr", ... A text may
/// be a table all the same: holdsImage looks into it.
std::vector<std::string> readableImageExtensions();
/// ".exr, .csv or .png": for messages.
std::string imageExtensionNames();

/// Writes an image in the format of its extension.
void writeImageFile(const RadianceImage& image, const std::filesystem::path& file,
                    const ImageWriting& how = {});

} // namespace irsg
