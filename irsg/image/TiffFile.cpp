#include "irsg/image/TiffFile.h"

#include <algorithm>
#include <cstring>

#include <Imath/half.h>
#include <tiffio.h>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/Remarks.h"
#include "irsg/image/AttributeText.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/GdalTags.h"
#include "irsg/image/ImageFormat.h"
#include "irsg/image/TiffMemory.h"

namespace irsg {

namespace {

constexpr int mostPages = 1000;

/// How the values of a page are stored.
struct Layout {
    std::uint32_t width = 0, height = 0;
    std::uint16_t bits = 1, format = SAMPLEFORMAT_UINT, samples = 1, planar = PLANARCONFIG_CONTIG;
    std::uint16_t orientation = ORIENTATION_TOPLEFT, photometric = PHOTOMETRIC_MINISBLACK;
    bool isTiled = false, isColoured = false;

    std::size_t bytesPerValue() const { return bits / 8U; }
};

/// One value of a page as a number.
float valueOf(const unsigned char* at, const Layout& layout) {
    const auto as = [at]<typename Number>(Number number) {
        std::memcpy(&number, at, sizeof number);
        return static_cast<float>(number);
    };
    if (layout.format == SAMPLEFORMAT_IEEEFP && layout.bits == 16) {
        half number;
        number.setBits(static_cast<std::uint16_t>(as(std::uint16_t{})));
        return number;
    }
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

class TiffReader {
  public:
    explicit TiffReader(const std::filesystem::path& file) : name_(file.string()) {
        memory_.bytes = readFile(file);
        tiff_ = openTiff(memory_, "rm");
        if (!tiff_)
            refuse("", "a TIFF file");
    }

    RadianceImage image(const ImageReading& what) {
        if (what.page)
            return onePage(*what.page);
        RadianceImage image;
        std::string leftOut;
        bool isOurs = false;
        int page = firstPicture(leftOut) - 1;
        const int first = page + 1;
        do {
            if (++page > mostPages)
                throw InputError({name_, "page " + std::to_string(page), "more pages",
                                  "at most " + std::to_string(mostPages) + " planes"});
            const std::string why = page > first ? reasonAgainst(image) : "";
            if (!why.empty())
                addLeftOut(leftOut, page, why);
            else
                readPage(image, page);
            isOurs = isOurs || isOfOurs();
        } while (TIFFReadDirectory(tiff_.get()) == 1);
        // A chain of pages that breaks off is told from one that ends.
        if (!memory_.complaint.empty())
            refuse("page " + std::to_string(page + 1), "an undamaged page or none");
        if (!leftOut.empty())
            remarkOn(name_, "leaves out " + leftOut + "; a page is read alone by its number");
        if (image.channels.size() > 1 && page > first && !isOurs)
            remarkOn(name_,
                     "holds " + std::to_string(page) + " pages; page " + std::to_string(first) +
                         " is the plane " + image.channels.front().name +
                         ", others are chosen by their number or as the channels " + "page2, ...");
        return image;
    }

    std::vector<ImagePart> pages() {
        std::vector<ImagePart> all;
        int page = 0;
        do {
            std::uint32_t width = 0, height = 0;
            std::uint16_t samples = 1;
            TIFFGetField(tiff_.get(), TIFFTAG_IMAGEWIDTH, &width);
            TIFFGetField(tiff_.get(), TIFFTAG_IMAGELENGTH, &height);
            TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_SAMPLESPERPIXEL, &samples);
            // Planes of one image of ours are no choice of images.
            if (isOfOurs())
                return {};
            ++page;
            all.push_back({"page " + std::to_string(page) + ": " + std::to_string(width) + " x " +
                               std::to_string(height) + " pixels" +
                               (samples > 1 ? " of " + std::to_string(samples) + " samples" : ""),
                           {.part = "", .page = page}});
        } while (page < mostPages && TIFFReadDirectory(tiff_.get()) == 1);
        return all;
    }

  private:
    [[noreturn]] void refuse(const std::string& position, const std::string& expected) const {
        throw InputError(
            {name_, position, memory_.complaint.empty() ? "damaged" : memory_.complaint, expected});
    }

    RadianceImage onePage(int page) {
        for (int i = 1; i < page; ++i)
            if (TIFFReadDirectory(tiff_.get()) != 1) {
                if (!memory_.complaint.empty())
                    refuse("page " + std::to_string(i + 1), "an undamaged page or none");
                throw InputError({name_, "", "no page " + std::to_string(page),
                                  "a page from 1 to " + std::to_string(i)});
            }
        RadianceImage image;
        readPage(image, page);
        return image;
    }

    bool isOfOurs() const {
        const char* description = nullptr;
        return TIFFGetField(tiff_.get(), TIFFTAG_IMAGEDESCRIPTION, &description) == 1 &&
               std::string_view(description).starts_with("channel: ");
    }

    static void addLeftOut(std::string& leftOut, int page, const std::string& why) {
        leftOut += (leftOut.empty() ? "page " : ", page ") + std::to_string(page) + why;
    }

    /// Goes to the first page of values that is no reduced copy and no mask, where there is one,
    /// else to the first of all; its number. Those before it are added to `leftOut`.
    int firstPicture(std::string& leftOut) {
        int page = 1;
        for (std::string why; !(why = reasonAgainst()).empty() && page < mostPages; ++page) {
            addLeftOut(leftOut, page, why);
            if (TIFFReadDirectory(tiff_.get()) != 1) {
                if (!memory_.complaint.empty())
                    refuse("page " + std::to_string(page + 1), "an undamaged page or none");
                TIFFSetDirectory(tiff_.get(), 0);
                leftOut.clear();
                return 1;
            }
        }
        return page;
    }

    /// Why the present page is no picture of values, " (...)"; empty where it is one.
    std::string reasonAgainst() const {
        std::uint32_t kind = 0;
        TIFFGetField(tiff_.get(), TIFFTAG_SUBFILETYPE, &kind);
        if ((kind & FILETYPE_REDUCEDIMAGE) != 0)
            return " (a reduced copy)";
        if ((kind & FILETYPE_MASK) != 0)
            return " (a mask)";
        const std::string what = otherThanValues(storageOf());
        return what.empty() ? "" : " (" + what + ")";
    }

    /// The same, and why it is no plane of this image.
    std::string reasonAgainst(const RadianceImage& image) const {
        if (std::string why = reasonAgainst(); !why.empty())
            return why;
        std::uint32_t width = 0, height = 0;
        TIFFGetField(tiff_.get(), TIFFTAG_IMAGEWIDTH, &width);
        TIFFGetField(tiff_.get(), TIFFTAG_IMAGELENGTH, &height);
        const auto wide = static_cast<std::uint32_t>(image.width());
        const auto high = static_cast<std::uint32_t>(image.height());
        return width == wide && height == high
                   ? ""
                   : " (" + std::to_string(width) + " x " + std::to_string(height) + " pixels)";
    }

    /// How the present page stores what it has, without its size.
    Layout storageOf() const {
        Layout layout;
        TIFF* tiff = tiff_.get();
        TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &layout.bits);
        TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &layout.format);
        TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &layout.samples);
        TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &layout.planar);
        layout.isTiled = TIFFIsTiled(tiff) != 0;
        TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &layout.photometric);
        layout.isColoured = layout.photometric == PHOTOMETRIC_RGB &&
                            layout.format == SAMPLEFORMAT_IEEEFP && layout.samples >= 3;
        TIFFGetFieldDefaulted(tiff, TIFFTAG_ORIENTATION, &layout.orientation);
        return layout;
    }

    /// What a page stores in place of values; "" where it has values.
    static std::string otherThanValues(const Layout& layout) {
        const bool isNumber =
            layout.format == SAMPLEFORMAT_IEEEFP
                ? layout.bits == 16 || layout.bits == 32 || layout.bits == 64
                : (layout.format == SAMPLEFORMAT_UINT || layout.format == SAMPLEFORMAT_INT) &&
                      (layout.bits == 8 || layout.bits == 16 || layout.bits == 32);
        if (!isNumber)
            return std::to_string(layout.bits) + "-bit samples of format " +
                   std::to_string(layout.format);
        return layout.photometric == PHOTOMETRIC_MINISBLACK || layout.isColoured
                   ? ""
                   : "colours (photometric interpretation " + std::to_string(layout.photometric) +
                         ")";
    }

    Layout layoutOf(const std::string& page) const {
        TIFF* tiff = tiff_.get();
        Layout layout = storageOf();
        if (TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &layout.width) != 1 ||
            TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &layout.height) != 1)
            throw InputError({name_, page, "no size", "a width and a height"});
        std::uint16_t compression = COMPRESSION_NONE, subfiles = 0;
        TIFFGetField(tiff, TIFFTAG_COMPRESSION, &compression);
        if (compression == COMPRESSION_JPEG || compression == COMPRESSION_OJPEG)
            remarkOn(name_, page + " was compressed with loss (JPEG)");
        void* offsets = nullptr;
        if (TIFFGetField(tiff, TIFFTAG_SUBIFD, &subfiles, &offsets) == 1 && subfiles > 0)
            remarkOn(name_, page + ": " + std::to_string(subfiles) +
                                " further images within the page are left out (SubIFDs)");
        if (layout.orientation > ORIENTATION_BOTLEFT)
            throw InputError(
                {name_, page,
                 "rows that are columns (orientation " + std::to_string(layout.orientation) + ")",
                 "an orientation from 1 to 4"});
        if (const std::string what = otherThanValues(layout); !what.empty())
            throw InputError({name_, page, what,
                              "values: floats of 16, 32 or 64 bits or integers of 8, 16 or 32"});
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
        }
        image.attributes.merge(text.attributes);

        // The planes of the page: one by name, or as many as a pixel has samples.
        const std::string name = text.plane.contains("channel") ? text.plane["channel"]
                                 : image.channels.empty() && layout.samples == 1
                                     ? "L"
                                     : "page" + std::to_string(number);
        const std::size_t first = image.channels.size();
        for (std::uint16_t s = 0; s < layout.samples; ++s) {
            std::string plane = layout.samples == 1 ? name : name + "." + std::to_string(s + 1);
            if (layout.isColoured && first == 0 && s < 4)
                plane = std::string(1, "RGBA"[s]);
            if (image.find(plane) != nullptr)
                throw InputError({name_, page, "a second plane " + plane, "another name"});
            image.channel(plane, text.plane["unit"]);
        }
        readValues(image, first, layout, page);
        takeGdalTags(tiff_.get(), image, first, name_, page);
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
        if (blockWidth == 0 || blockHeight == 0 || size <= 0 || size > mostTiffMemory_B)
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
                                image.channels[firstPlane + s + k].values[placeOf(
                                    image, layout.orientation, x + column, y + row)] =
                                    valueOf(block.data() +
                                                stride *
                                                    (static_cast<std::size_t>(row) * blockWidth +
                                                     column) +
                                                layout.bytesPerValue() * k,
                                            layout);
                }
    }

    /// Where a value goes that is stored in a row and column: the orientation says which corner is
    /// the first.
    static std::size_t placeOf(const RadianceImage& image, std::uint16_t orientation,
                               std::uint32_t x, std::uint32_t y) {
        const bool fromRight =
            orientation == ORIENTATION_TOPRIGHT || orientation == ORIENTATION_BOTRIGHT;
        const bool fromBottom =
            orientation == ORIENTATION_BOTRIGHT || orientation == ORIENTATION_BOTLEFT;
        const auto column = static_cast<int>(x), row = static_cast<int>(y);
        return image.offset(fromRight ? image.width() - 1 - column : column,
                            fromBottom ? image.height() - 1 - row : row);
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
    TiffMemory memory_;
    OpenTiff tiff_;
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
    TiffMemory memory;
    {
        const OpenTiff tiff = openTiff(memory, "wm");
        if (!tiff)
            throw LogicError("a TIFF file cannot be begun: " + memory.complaint);
        for (std::size_t i = 0; i < image.channels.size(); ++i)
            writePage(tiff.get(), image, i);
    }
    if (!memory.complaint.empty())
        throw LogicError("a TIFF file cannot be written: " + memory.complaint);
    writeFileDurably(file, memory.bytes);
}

RadianceImage readTiff(const std::filesystem::path& file, const ImageReading& what) {
    return TiffReader(file).image(what);
}

std::vector<ImagePart> tiffPages(const std::filesystem::path& file) {
    return TiffReader(file).pages();
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
                const ImageWriting&) { writeTiff(image, file); },
    .parts = tiffPages,
    .hasPages = true};

} // namespace irsg
