#include "irsg/image/ExrFile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <optional>
#include <set>
#include <sstream>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStdIO.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <OpenEXR/ImfThreading.h>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/Remarks.h"
#include "irsg/image/AttributeText.h"
#include "irsg/image/ExrHeader.h"
#include "irsg/image/ImageFormat.h"

namespace irsg {

namespace {

constexpr std::string_view exrSignature = "\x76\x2f\x31\x01";
constexpr std::string_view unitPrefix = "unit.";
const std::string orderName = "channelOrder";
/// What we call the plane that is stored as Y.
const std::string shownName = "plane.Y";
constexpr std::uint64_t largestValueCount = std::uint64_t{1} << 30;

bool isReservedName(std::string_view name) {
    static const std::set<std::string, std::less<>> names = {"channels",
                                                             "chunkCount",
                                                             "compression",
                                                             "dataWindow",
                                                             "displayWindow",
                                                             "lineOrder",
                                                             "maxSamplesPerPixel",
                                                             "name",
                                                             "pixelAspectRatio",
                                                             "screenWindowCenter",
                                                             "screenWindowWidth",
                                                             "tiles",
                                                             "type",
                                                             "version",
                                                             "view",
                                                             orderName,
                                                             shownName};
    return names.contains(name) || name.starts_with(unitPrefix) ||
           name.starts_with(attributePrefix);
}

/// Bytes in memory as a stream that OpenEXR reads: the file was read once, with our own errors.
class MemoryStream : public Imf::IStream {
  public:
    MemoryStream(const std::string& bytes, const std::string& name)
        : Imf::IStream(name.c_str()), bytes_(bytes) {}

    bool read(char out[], int count) override {
        if (count < 0 || static_cast<std::uint64_t>(count) > bytes_.size() - position_)
            throw Iex::InputExc("the file ends after " + std::to_string(bytes_.size()) + " bytes");
        std::memcpy(out, bytes_.data() + position_, static_cast<std::size_t>(count));
        position_ += static_cast<std::size_t>(count);
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override {
        if (position > bytes_.size())
            throw Iex::InputExc("it points at byte " + std::to_string(position) + " of " +
                                std::to_string(bytes_.size()));
        position_ = static_cast<std::size_t>(position);
    }

  private:
    const std::string& bytes_;
    std::size_t position_ = 0;
};

template <typename Number>
std::string shortest(Number value) {
    std::array<char, 64> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

std::optional<std::string> textOf(const Imf::Attribute& attribute) {
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute))
        return text->value();
    if (const auto* number = dynamic_cast<const Imf::FloatAttribute*>(&attribute))
        return shortest(number->value());
    if (const auto* number = dynamic_cast<const Imf::DoubleAttribute*>(&attribute))
        return shortest(number->value());
    if (const auto* number = dynamic_cast<const Imf::IntAttribute*>(&attribute))
        return shortest(number->value());
    if (const auto* list = dynamic_cast<const Imf::StringVectorAttribute*>(&attribute)) {
        std::string joined;
        for (const std::string& item : list->value())
            joined += (joined.empty() ? "" : ", ") + item;
        return joined;
    }
    return std::nullopt;
}

void readAttributes(const Imf::Header& header, RadianceImage& image) {
    for (auto it = header.begin(); it != header.end(); ++it) {
        const std::string_view name = it.name();
        const std::optional<std::string> text = textOf(it.attribute());
        if (!text)
            continue;
        if (name.starts_with(attributePrefix)) {
            image.attributes[std::string(name.substr(attributePrefix.size()))] = *text;
        } else if (name.starts_with(unitPrefix)) {
            const std::string channelName(name.substr(unitPrefix.size()));
            const auto channel =
                std::ranges::find(image.channels, channelName, &ImageChannel::name);
            if (channel != image.channels.end())
                channel->unit = *text;
        } else if (!isReservedName(name)) {
            image.attributes[std::string(name)] = *text;
        }
    }
}

/// Names of the channels in the order in which the image is to hold them.
std::vector<std::string> orderedNames(const Imf::Header& header) {
    std::vector<std::string> names;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
        names.emplace_back(it.name());

    std::vector<std::string> preferred = {"L", "Y"};
    if (const auto* order = header.findTypedAttribute<Imf::StringVectorAttribute>(orderName))
        preferred = order->value();
    const auto rank = [&preferred](const std::string& name) {
        return std::ranges::find(preferred, name) - preferred.begin();
    };
    std::ranges::stable_sort(names, {}, rank);
    return names;
}

void checkHeader(const Imf::Header& header, const std::string& file) {
    // Nothing is allocated before the sizes that the header claims are found sane.
    const Imath::Box2i window = header.dataWindow();
    const auto width = static_cast<std::int64_t>(window.max.x) - window.min.x + 1;
    const auto height = static_cast<std::int64_t>(window.max.y) - window.min.y + 1;
    std::uint64_t channels = 0;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
        ++channels;
        const Imf::Channel& channel = it.channel();
        if (channel.xSampling != 1 || channel.ySampling != 1)
            throw InputError({file, std::string("channel ") + it.name(),
                              "a sample every " + std::to_string(channel.xSampling) + " x " +
                                  std::to_string(channel.ySampling) + " pixels",
                              "a value at every pixel"});
    }
    if (channels == 0)
        throw InputError({file, "header", "no channel", "at least one channel"});
    const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels, " +
                             std::to_string(channels) + " channels";
    if (width < 1 || height < 1 || width > largestImageSide_px || height > largestImageSide_px ||
        static_cast<std::uint64_t>(width * height) * channels > largestValueCount)
        throw InputError({file, "header", size,
                          "1 to " + std::to_string(largestImageSide_px) +
                              " pixels a side and at most 2^30 values"});
}

bool isDeep(const Imf::Header& header) {
    return header.hasType() &&
           (header.type() == Imf::DEEPSCANLINE || header.type() == Imf::DEEPTILE);
}

/// A plane of ours that is stored as Y gets its name back.
void renameShown(const Imf::Header& header, RadianceImage& image) {
    const auto* name = header.findTypedAttribute<Imf::StringAttribute>(shownName);
    if (name == nullptr || name->value().empty() || image.find(name->value()) != nullptr)
        return;
    const auto shown = std::ranges::find(image.channels, "Y", &ImageChannel::name);
    if (shown != image.channels.end())
        shown->name = name->value();
}

/// What a part holds, for a list of parts: "2 'radiance': Y, 48 x 32 pixels".
std::string wordsOf(const Imf::Header& header, int number) {
    std::string words = std::to_string(number);
    if (header.hasName() && !header.name().empty())
        words += " '" + header.name() + "'";
    words += ": ";
    if (isDeep(header))
        words += "deep data, ";
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
        words += std::string(it.name()) + ", ";
    const Imath::Box2i window = header.dataWindow();
    return words + std::to_string(std::int64_t{window.max.x} - window.min.x + 1) + " x " +
           std::to_string(std::int64_t{window.max.y} - window.min.y + 1) + " pixels";
}

/// How likely a part is the one that is meant.
int rankOf(const Imf::Header& header) {
    const auto has = [&](const char* name) {
        return header.channels().findChannel(name) != nullptr;
    };
    return isDeep(header) ? 0 : has("L") ? 4 : has("Y") ? 3 : has("R") && has("G") ? 2 : 1;
}

/// The number of the part that is meant, from 0.
int chosenPart(const Imf::MultiPartInputFile& input, const std::string& part,
               const std::string& file) {
    std::string all;
    for (int i = 0; i < input.parts(); ++i)
        all += (i > 0 ? "; " : "") + wordsOf(input.header(i), i + 1);
    if (!part.empty()) {
        for (int i = 0; i < input.parts(); ++i)
            if (input.header(i).hasName() && input.header(i).name() == part)
                return i;
        for (int i = 0; i < input.parts(); ++i)
            if (part == std::to_string(i + 1))
                return i;
        throw InputError({file, "", "no part '" + part + "'", "one of its parts: " + all});
    }
    int chosen = 0;
    for (int i = 1; i < input.parts(); ++i)
        if (rankOf(input.header(i)) > rankOf(input.header(chosen)))
            chosen = i;
    if (input.parts() > 1)
        remarkOn(file, "holds " + std::to_string(input.parts()) + " parts (" + all + "); part " +
                           std::to_string(chosen + 1) + " is read");
    return chosen;
}

RadianceImage readPixels(Imf::MultiPartInputFile& parts, int part, const std::string& file) {
    const Imf::Header& header = parts.header(part);
    if (isDeep(header))
        throw InputError({file, "part " + std::to_string(part + 1), "deep data",
                          "one value a pixel and channel"});
    checkHeader(header, file);
    if (!parts.partComplete(part))
        throw InputError({file, "", "a truncated file, some of its rows are missing",
                          "a complete OpenEXR file"});

    // The planes, in our order.
    const Imath::Box2i window = header.dataWindow();
    const std::vector<std::string> names = orderedNames(header);
    RadianceImage image(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1,
                        names.front(), "");
    for (const std::string& name : names)
        image.channel(name);
    readAttributes(header, image);
    if (header.pixelAspectRatio() != 1.0F)
        remarkOn(file, "its pixels are " + shortest(header.pixelAspectRatio()) +
                           " times as wide as high; they are taken as square");

    // OpenEXR addresses a pixel by its place in the data window, Slice::Make moves the origin.
    Imf::FrameBuffer target;
    for (ImageChannel& channel : image.channels)
        target.insert(channel.name, Imf::Slice::Make(Imf::FLOAT, channel.values.data(), window));
    Imf::InputPart input(parts, part);
    input.setFrameBuffer(target);

    // Row by row, so that damage has a place; blocks of rows are cached by the library.
    int y = window.min.y;
    try {
        for (; y <= window.max.y; ++y)
            input.readPixels(y, y);
    } catch (const std::exception& error) {
        throw InputError({file, "row " + std::to_string(y - window.min.y), error.what(),
                          "an undamaged OpenEXR file"});
    }
    renameShown(header, image);
    return image;
}

/// Opens a file of bytes that were read before, and gives it to `use`.
template <typename Use>
auto withParts(const std::string& bytes, const std::string& name, Use&& use) {
    if (!bytes.starts_with(exrSignature))
        throw InputError({name, "byte 0", bytes.empty() ? "an empty file" : "no OpenEXR signature",
                          "an OpenEXR file"});
    checkExrHeader(bytes, name);
    try {
        MemoryStream stream(bytes, name);
        // Without reconstruction a file cut short is told from a whole one.
        Imf::MultiPartInputFile input(stream, Imf::globalThreadCount(), false);
        return use(input);
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError({name, "", error.what(), "an OpenEXR image, undamaged and complete"});
    }
}

} // namespace

void writeExr(const RadianceImage& image, const std::filesystem::path& file) {
    checkPlanes(image);

    // The header: channels, their order and units, and what the image says of itself.
    Imf::Header header(image.width(), image.height());
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer source;
    std::vector<std::string> order;
    const bool hasColours = std::ranges::any_of(image.channels, [](const ImageChannel& channel) {
        return channel.name == "R" || channel.name == "G" || channel.name == "B" ||
               channel.name == "Y";
    });
    if (!hasColours)
        header.insert(shownName, Imf::StringAttribute(image.primary().name));
    for (const ImageChannel& channel : image.channels) {
        const bool isShown = !hasColours && &channel == &image.channels.front();
        const std::string name = isShown ? "Y" : channel.name;
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        header.insert(std::string(unitPrefix) + name, Imf::StringAttribute(channel.unit));
        order.push_back(name);
        // The library takes a pointer to what it reads from as one to non-const.
        auto* values = const_cast<float*>(channel.values.data());
        source.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values), sizeof(float),
                                       sizeof(float) * static_cast<std::size_t>(image.width())));
    }
    header.insert(orderName, Imf::StringVectorAttribute(order));
    for (const auto& [name, value] : image.attributes)
        header.insert(isReservedName(name) ? std::string(attributePrefix) + name : name,
                      Imf::StringAttribute(value));

    Imf::StdOSStream bytes;
    {
        Imf::OutputFile output(bytes, header);
        output.setFrameBuffer(source);
        output.writePixels(image.height());
    }
    writeFileDurably(file, bytes.str());
}

RadianceImage readExr(const std::filesystem::path& file, const ImageReading& what) {
    const std::string bytes = readFile(file);
    const std::string name = file.string();
    return withParts(bytes, name, [&](Imf::MultiPartInputFile& input) {
        return readPixels(input, chosenPart(input, what.part, name), name);
    });
}

std::vector<ImagePart> exrParts(const std::filesystem::path& file) {
    const std::string bytes = readFile(file);
    return withParts(bytes, file.string(), [](Imf::MultiPartInputFile& input) {
        std::vector<ImagePart> parts;
        for (int i = 0; i < input.parts(); ++i)
            parts.push_back({wordsOf(input.header(i), i + 1), {.part = std::to_string(i + 1)}});
        return parts;
    });
}

extern constinit const ImageFormat exrFormat{
    .name = "OpenEXR image",
    .shortName = "OpenEXR",
    .extensions = ".exr",
    .isUsual = true,
    .recognises = [](std::string_view beginning) { return beginning.starts_with(exrSignature); },
    .read = readExr,
    .write = [](const RadianceImage& image, const std::filesystem::path& file,
                const ImageWriting&) { writeExr(image, file); },
    .parts = exrParts};

} // namespace irsg
