#include "irsg/image/TiffFile.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>

#include <tiffio.h>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/image/AttributeText.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/ImageFormat.h"

namespace irsg {

namespace {

constexpr tmsize_t mostMemory = tmsize_t{1} << 30;
constexpr int mostPages = 1000;

/// A file in memory, in the way libtiff asks for it, with the first thing it had to say.
struct Memory {
    std::string bytes;
    std::size_t position = 0;
    std::string complaint = {};
};

tmsize_t readBytes(thandle_t handle, void* into, tmsize_t count) {
    auto& memory = *static_cast<Memory*>(handle);
    const std::size_t left = memory.bytes.size() - std::min(memory.position, memory.bytes.size());
    const std::size_t taken =
        std::min(left, static_cast<std::size_t>(std::max<tmsize_t>(count, 0)));
    std::memcpy(into, memory.bytes.data() + std::min(memory.position, memory.bytes.size()), taken);
    memory.position += taken;
    return static_cast<tmsize_t>(taken);
}

tmsize_t writeBytes(thandle_t handle, void* from, tmsize_t count) {
    auto& memory = *static_cast<Memory*>(handle);
    const auto size = static_cast<std::size_t>(count);
    if (memory.bytes.size() < memory.position + size)
        memory.bytes.resize(memory.position + size);
    std::memcpy(memory.bytes.data() + memory.position, from, size);
    memory.position += size;
    return count;
}

toff_t seekTo(thandle_t handle, toff_t offset, int whence) {
    auto& memory = *static_cast<Memory*>(handle);
    const std::size_t base = whence == SEEK_SET   ? 0
                             : whence == SEEK_CUR ? memory.position
                                                  : memory.bytes.size();
    memory.position = base + static_cast<std::size_t>(offset);
    return memory.position;
}

toff_t sizeOf(thandle_t handle) {
    return static_cast<Memory*>(handle)->bytes.size();
}

int keepComplaint(TIFF*, void* user, const char*, const char* format, va_list arguments) {
    auto& memory = *static_cast<Memory*>(user);
    if (memory.complaint.empty()) {
        char text[256];
        std::vsnprintf(text, sizeof text, format, arguments);
        memory.complaint = text;
    }
    return 1;
}

int sayNothing(TIFF*, void*, const char*, const char*, va_list) {
    return 1;
}

struct CloseTiff {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using Tiff = std::unique_ptr<TIFF, CloseTiff>;

Tiff opened(Memory& memory, const char* mode) {
    TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
    TIFFOpenOptionsSetMaxSingleMemAlloc(options, mostMemory);
    TIFFOpenOptionsSetErrorHandlerExtR(options, keepComplaint, &memory);
    TIFFOpenOptionsSetWarningHandlerExtR(options, sayNothing, &memory);
    Tiff tiff(TIFFClientOpenExt(
        "image", mode, &memory, readBytes, writeBytes, seekTo, [](thandle_t) { return 0; }, sizeOf,
        [](thandle_t, void**, toff_t*) { return 0; }, [](thandle_t, void*, toff_t) {}, options));
    TIFFOpenOptionsFree(options);
    return tiff;
}

/// How the values of a page are stored.
struct Layout {
    std::uint32_t width = 0, height = 0;
    std::uint16_t bits = 1, format = SAMPLEFORMAT_UINT, samples = 1, planar = PLANARCONFIG_CONTIG;
    bool isTiled = false;

    std::size_t bytesPerValue() const { return bits / 8U; }
};

/// One value of a page as a number.
float valueOf(const unsigned char* at, const Layout& layout) {
    const auto as = [at]<typename Number>(Number number) {
        std::memcpy(&number, at, sizeof number);
        return static_cast<float>(number);
    };
    if (layout.format == SAMPLEFORMAT_IEEEFP)
        return layout.bits == 32 ? as(0.0F) : as(0.0);
    if (layout.format == SAMPLEFORMAT_INT)
        return layout.bits == 8    ? as(std::int8_t{})
               : layout.bits == 16 ? as(std::int16_t{})
                                   : as(std::int32_t{});
    return layout.bits == 8    ? as(std::uint8_t{})
           : layout.bits == 16 ? as(std::uint16_t{})
                               : as(std::uint32_t{});
}

class Reader {
  public:
    explicit Reader(const std::filesystem::path& file) : name_(file.string()) {
        memory_.bytes = readFile(file);
        tiff_ = opened(memory_, "rm");
        if (!tiff_)
            refuse("", "a TIFF file");
    }

    RadianceImage image() {
        RadianceImage image;
        int page = 0;
        do {
            if (++page > mostPages)
                throw InputError({name_, "page " + std::to_string(page), "more pages",
                                  "at most " + std::to_string(mostPages) + " planes"});
            readPage(image, page);
        } while (TIFFReadDirectory(tiff_.get()) == 1);
        // A chain of pages that breaks off is told from one that ends.
        if (!memory_.complaint.empty())
            refuse("page " + std::to_string(page + 1), "an undamaged page or none");
        return image;
    }

  private:
    [[noreturn]] void refuse(const std::string& position, const std::string& expected) const {
        throw InputError(
            {name_, position, memory_.complaint.empty() ? "damaged" : memory_.complaint, expected});
    }

    Layout layoutOf(const std::string& page) const {
        Layout layout;
        TIFF* tiff = tiff_.get();
        if (TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &layout.width) != 1 ||
            TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &layout.height) != 1)
            throw InputError({name_, page, "no size", "a width and a height"});
        TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &layout.bits);
        TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &layout.format);
        TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &layout.samples);
        TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &layout.planar);
        layout.isTiled = TIFFIsTiled(tiff) != 0;

        std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
        TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &photometric);
        const bool isNumber =
            layout.format == SAMPLEFORMAT_IEEEFP
                ? layout.bits == 32 || layout.bits == 64
                : (layout.format == SAMPLEFORMAT_UINT || layout.format == SAMPLEFORMAT_INT) &&
                      (layout.bits == 8 || layout.bits == 16 || layout.bits == 32);
        if (!isNumber || photometric != PHOTOMETRIC_MINISBLACK)
            throw InputError({name_, page,
                              !isNumber ? std::to_string(layout.bits) + "-bit samples of format " +
                                              std::to_string(layout.format)
                                        : "colours (photometric interpretation " +
                                              std::to_string(photometric) + ")",
                              "values: floats of 32 or 64 bits or integers of 8, 16 or 32"});
        const auto limit = static_cast<std::uint32_t>(largestImageSide_px);
        if (layout.width < 1 || layout.height < 1 || layout.width > limit ||
            layout.height > limit || layout.samples < 1 || layout.samples > 64)
            throw InputError(
                {name_, page,
                 std::to_string(layout.width) + " x " + std::to_string(layout.height) +
                     " pixels of " + std::to_string(layout.samples) + " samples",
                 "1 to " + std::to_string(limit) + " pixels a side and at most 64 samples"});
        // What is claimed is believed only as far as the file could hold it: deflate packs a
        // thousand bytes into one.
        const double claimed = static_cast<double>(layout.width) * layout.height * layout.samples *
                               static_cast<double>(layout.bytesPerValue());
        if (claimed > 2000.0 * static_cast<double>(memory_.bytes.size()))
            throw InputError({name_, page,
                              std::to_string(layout.width) + " x " + std::to_string(layout.height) +
                                  " pixels in " + std::to_string(memory_.bytes.size()) + " bytes",
                              "a file that holds what it claims"});
        return layout;
    }

    void readPage(RadianceImage& image, int number) {
        const std::string page = "page " + std::to_string(number);
        const Layout layout = layoutOf(page);
        const auto width = static_cast<int>(layout.width), height = static_cast<int>(layout.height);
        AttributeText text = descriptionOf();
        if (image.empty()) {
            image = RadianceImage(width, height);
            image.channels.clear();
        } else if (image.width() != width || image.height() != height) {
            throw InputError({name_, page,
                              std::to_string(width) + " x " + std::to_string(height) + " pixels",
                              std::to_string(image.width()) + " x " +
                                  std::to_string(image.height()) + ", as the first page"});
        }
        image.attributes.merge(text.attributes);

        // The planes of the page: one by name, or as many as a pixel has samples.
        const std::string name = text.plane.contains("channel") ? text.plane["channel"]
                                 : number == 1 && layout.samples == 1
                                     ? "L"
                                     : "page" + std::to_string(number);
        const std::size_t first = image.channels.size();
        for (std::uint16_t s = 0; s < layout.samples; ++s) {
            const std::string plane =
                layout.samples == 1 ? name : name + "." + std::to_string(s + 1);
            if (image.find(plane) != nullptr)
                throw InputError({name_, page, "a second plane " + plane, "another name"});
            image.channel(plane, text.plane["unit"]);
        }
        readValues(image, first, layout, page);
    }

    AttributeText descriptionOf() const {
        AttributeText text;
        const char* description = nullptr;
        if (TIFFGetField(tiff_.get(), TIFFTAG_IMAGEDESCRIPTION, &description) != 1)
            return text;
        std::string_view rest = description;
        // Of other programs a description is one attribute.
        if (!rest.starts_with("channel: ")) {
            text.attributes["description"] = std::string(rest);
            return text;
        }
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            text.read(rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        return text;
    }

    void readValues(RadianceImage& image, std::size_t firstPlane, const Layout& layout,
                    const std::string& page) {
        TIFF* tiff = tiff_.get();
        std::uint32_t blockWidth = layout.width, blockHeight = layout.height;
        if (layout.isTiled) {
            TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &blockWidth);
            TIFFGetField(tiff, TIFFTAG_TILELENGTH, &blockHeight);
        } else {
            TIFFGetFieldDefaulted(tiff, TIFFTAG_ROWSPERSTRIP, &blockHeight);
            blockHeight = std::min(blockHeight, layout.height);
        }
        const tmsize_t size = layout.isTiled ? TIFFTileSize(tiff) : TIFFStripSize(tiff);
        if (blockWidth == 0 || blockHeight == 0 || size <= 0 || size > mostMemory)
            throw InputError(
                {name_, page, "blocks of " + std::to_string(size) + " bytes", "blocks of values"});
        std::vector<unsigned char> block(static_cast<std::size_t>(size));
        const bool isApart = layout.planar == PLANARCONFIG_SEPARATE;
        const std::uint16_t samplesTogether = isApart ? 1 : layout.samples;
        const std::size_t stride = layout.bytesPerValue() * samplesTogether;

        for (std::uint16_t s = 0; s < layout.samples;
             s = static_cast<std::uint16_t>(s + samplesTogether))
            for (std::uint32_t y = 0; y < layout.height; y += blockHeight)
                for (std::uint32_t x = 0; x < layout.width; x += blockWidth) {
                    readBlock(block, layout, x, y, s, page);
                    const std::uint32_t rows = std::min(blockHeight, layout.height - y);
                    const std::uint32_t columns = std::min(blockWidth, layout.width - x);
                    if (stride * blockWidth * rows > block.size())
                        throw InputError(
                            {name_, page, "blocks that are too small", "blocks of whole rows"});
                    for (std::uint32_t row = 0; row < rows; ++row)
                        for (std::uint32_t column = 0; column < columns; ++column)
                            for (std::uint16_t k = 0; k < samplesTogether; ++k)
                                image.channels[firstPlane + s + k].values[image.offset(
                                    static_cast<int>(x + column), static_cast<int>(y + row))] =
                                    valueOf(block.data() +
                                                stride *
                                                    (static_cast<std::size_t>(row) * blockWidth +
                                                     column) +
                                                layout.bytesPerValue() * k,
                                            layout);
                }
    }

    void readBlock(std::vector<unsigned char>& block, const Layout& layout, std::uint32_t x,
                   std::uint32_t y, std::uint16_t sample, const std::string& page) {
        TIFF* tiff = tiff_.get();
        std::ranges::fill(block, static_cast<unsigned char>(0));
        const auto size = static_cast<tmsize_t>(block.size());
        const tmsize_t read =
            layout.isTiled
                ? TIFFReadEncodedTile(tiff, TIFFComputeTile(tiff, x, y, 0, sample), block.data(),
                                      size)
                : TIFFReadEncodedStrip(tiff, TIFFComputeStrip(tiff, y, sample), block.data(), size);
        if (read < 0 || !memory_.complaint.empty())
            refuse(page + ", row " + std::to_string(y), "an undamaged TIFF file");
    }

    std::string name_;
    Memory memory_;
    Tiff tiff_;
};

/// What a page says of its plane, and the first one of the image.
std::string descriptionOf(const RadianceImage& image, const ImageChannel& plane, bool isFirst) {
    std::string text =
        attributeLine("channel", plane.name) + "\n" + attributeLine("unit", plane.unit) + "\n";
    if (isFirst)
        for (const auto& [key, value] : image.attributes)
            text += imageAttributeLine(key, value) + "\n";
    return text;
}

void writePage(TIFF* tiff, const RadianceImage& image, std::size_t index) {
    constexpr std::uint32_t rowsTogether = 64;
    const ImageChannel& plane = image.channels[index];
    const auto width = static_cast<std::uint32_t>(image.width());
    const auto height = static_cast<std::uint32_t>(image.height());
    TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, FILETYPE_PAGE);
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 32);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
    TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_FLOATINGPOINT);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, rowsTogether);
    TIFFSetField(tiff, TIFFTAG_PAGENAME, plane.name.c_str());
    TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, descriptionOf(image, plane, index == 0).c_str());
    for (std::uint32_t y = 0, strip = 0; y < height; y += rowsTogether, ++strip) {
        const std::size_t rows = std::min(rowsTogether, height - y);
        // The predictor works in place.
        const auto begin = plane.values.begin() + static_cast<std::ptrdiff_t>(y) * width;
        std::vector<float> values(begin, begin + static_cast<std::ptrdiff_t>(rows * width));
        if (TIFFWriteEncodedStrip(tiff, strip, values.data(),
                                  static_cast<tmsize_t>(values.size() * sizeof(float))) < 0)
            throw LogicError("a plane cannot be made into a TIFF page");
    }
    if (TIFFWriteDirectory(tiff) != 1)
        throw LogicError("a TIFF page cannot be finished");
}

} // namespace

void writeTiff(const RadianceImage& image, const std::filesystem::path& file) {
    checkPlanes(image);
    Memory memory;
    {
        const Tiff tiff = opened(memory, "wm");
        if (!tiff)
            throw LogicError("a TIFF file cannot be begun: " + memory.complaint);
        for (std::size_t i = 0; i < image.channels.size(); ++i)
            writePage(tiff.get(), image, i);
    }
    if (!memory.complaint.empty())
        throw LogicError("a TIFF file cannot be written: " + memory.complaint);
    writeFileDurably(file, memory.bytes);
}

RadianceImage readTiff(const std::filesystem::path& file) {
    return Reader(file).image();
}

extern constinit const ImageFormat tiffFormat{
    .name = "TIFF image of 32-bit floats",
    .shortName = "TIFF",
    .extensions = ".tif .tiff",
    .recognises =
        [](std::string_view beginning) {
            using namespace std::string_view_literals;
            return beginning.starts_with("II*\0"sv) || beginning.starts_with("MM\0*"sv) ||
                   beginning.starts_with("II+\0"sv) || beginning.starts_with("MM\0+"sv);
        },
    .read = readTiff,
    .write = [](const RadianceImage& image, const std::filesystem::path& file,
                const ImageWriting&) { writeTiff(image, file); }};

} // namespace irsg
