#include "irsg/geometry/reading/sandbox/StateCoding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "irsg/geometry/reading/sandbox/AttributeCoding.h"

namespace irsg {

namespace {

/// Of a picture; longer ones are not drawn by anybody.
constexpr std::int32_t longestSide_px = 1 << 16;

std::size_t layerBytes(const osg::Image& image) {
    return image.s() < 1 || image.t() < 1 ? 0 : image.getImageSizeInBytes();
}

} // namespace

void putImage(ByteSink& sink, const osg::Image& image) {
    sink.putText(image.getFileName());
    for (const auto value :
         {image.s(), image.t(), static_cast<int>(image.getInternalTextureFormat()),
          static_cast<int>(image.getPixelFormat()), static_cast<int>(image.getDataType()),
          static_cast<int>(image.getPacking()), static_cast<int>(image.getOrigin())})
        sink.put(static_cast<std::int32_t>(value));
    const std::size_t size = image.data() ? layerBytes(image) : 0;
    sink.putCount(size);
    // Rows may lie apart from each other.
    if (image.isDataContiguous())
        sink.putBytes(image.data(), size);
    else
        for (int row = 0; row < image.t(); ++row)
            sink.putBytes(image.data(0, static_cast<unsigned int>(row)),
                          size / static_cast<std::size_t>(image.t()));
}

osg::ref_ptr<osg::Image> getImage(ByteSource& source) {
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->setFileName(source.getText());
    std::int32_t values[7];
    for (auto& value : values)
        value = source.get<std::int32_t>();
    const auto [width, height, internalFormat, format, type, packing, origin] = values;
    const std::size_t size = source.getCount(1);
    const std::string_view bytes = source.getBytes(size);
    if (size == 0)
        return image;
    if (width < 1 || height < 1 || width > longestSide_px || height > longestSide_px ||
        (packing != 1 && packing != 2 && packing != 4 && packing != 8) ||
        (origin != osg::Image::BOTTOM_LEFT && origin != osg::Image::TOP_LEFT))
        throw DamagedBytes("a picture of impossible size");
    auto* data = new unsigned char[size];
    std::copy(bytes.begin(), bytes.end(), data);
    image->setImage(width, height, 1, internalFormat, static_cast<GLenum>(format),
                    static_cast<GLenum>(type), data, osg::Image::USE_NEW_DELETE, packing);
    image->setOrigin(static_cast<osg::Image::Origin>(origin));
    if (layerBytes(*image) != size)
        throw DamagedBytes("a picture whose bytes do not fit its size");
    return image;
}

std::int32_t StateEncoder::number(const osg::Image* image) {
    if (!image || !image->data())
        return -1;
    const auto [place, added] =
        images_.try_emplace(image, static_cast<std::int32_t>(images_.size()));
    if (added)
        putImage(imageBytes_, *image);
    return place->second;
}

std::int32_t StateEncoder::number(const osg::StateAttribute& attribute) {
    const auto [place, added] = attributes_.try_emplace(&attribute, -1);
    if (added) {
        const auto* texture = dynamic_cast<const osg::Texture2D*>(&attribute);
        const std::int32_t image = texture ? number(texture->getImage()) : -1;
        if (putAttribute(attributeBytes_, attribute, image))
            place->second = written_++;
        else
            leftOut_.insert(attribute.className());
    }
    return place->second;
}

void StateEncoder::putAttributes(ByteSink& sink, const osg::StateSet::AttributeList& attributes) {
    ByteSink known;
    std::size_t count = 0;
    for (const auto& [key, attribute] : attributes)
        if (const std::int32_t which = number(*attribute.first); which >= 0) {
            known.put(which);
            known.put(static_cast<std::uint32_t>(attribute.second));
            ++count;
        }
    sink.putCount(count);
    sink.append(std::move(known));
}

namespace {

void putModes(ByteSink& sink, const osg::StateSet::ModeList& modes) {
    sink.putCount(modes.size());
    for (const auto& [mode, value] : modes) {
        sink.put(static_cast<std::uint32_t>(mode));
        sink.put(static_cast<std::uint32_t>(value));
    }
}

} // namespace

std::int32_t StateEncoder::number(const osg::StateSet* state) {
    if (!state)
        return -1;
    const auto [place, added] =
        states_.try_emplace(state, static_cast<std::int32_t>(states_.size()));
    if (!added)
        return place->second;
    const std::int32_t mine = place->second;
    ByteSink& sink = stateBytes_;
    sink.putText(state->getName());
    putModes(sink, state->getModeList());
    putAttributes(sink, state->getAttributeList());
    const auto& unitModes = state->getTextureModeList();
    const auto& unitAttributes = state->getTextureAttributeList();
    const std::size_t units =
        std::min<std::size_t>(mostTextureUnits, std::max(unitModes.size(), unitAttributes.size()));
    sink.putCount(units);
    for (std::size_t unit = 0; unit < units; ++unit) {
        putModes(sink, unit < unitModes.size() ? unitModes[unit] : osg::StateSet::ModeList());
        putAttributes(sink, unit < unitAttributes.size() ? unitAttributes[unit]
                                                         : osg::StateSet::AttributeList());
    }
    sink.put(static_cast<std::int32_t>(state->getRenderingHint()));
    sink.put(static_cast<std::uint8_t>(state->useRenderBinDetails()));
    sink.put(static_cast<std::int32_t>(state->getBinNumber()));
    sink.putText(state->getBinName());
    if (!state->getUniformList().empty())
        leftOut_.insert("Uniform");
    return mine;
}

void StateEncoder::moveTo(ByteSink& sink) {
    const auto section = [&](std::size_t count, ByteSink& part) {
        sink.putCount(count);
        sink.append(std::exchange(part, {}));
    };
    section(images_.size(), imageBytes_);
    section(static_cast<std::size_t>(written_), attributeBytes_);
    section(states_.size(), stateBytes_);
}

namespace {

using Attributes = std::vector<osg::ref_ptr<osg::StateAttribute>>;

/// Calls `each` with every attribute of a list and how it is overridden.
template <typename Each>
void getAttributes(ByteSource& source, const Attributes& all, const Each& each) {
    for (std::size_t count = source.getCount(8); count > 0; --count) {
        auto& attribute = all[source.getIndex(all.size())];
        each(attribute.get(), source.get<std::uint32_t>());
    }
}

template <typename Each>
void getModes(ByteSource& source, const Each& each) {
    for (std::size_t count = source.getCount(8); count > 0; --count) {
        const auto mode = source.get<std::uint32_t>();
        each(static_cast<GLenum>(mode), source.get<std::uint32_t>());
    }
}

osg::ref_ptr<osg::StateSet> getState(ByteSource& source, const Attributes& all) {
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setName(source.getText());
    getModes(source, [&](GLenum mode, unsigned int value) { state->setMode(mode, value); });
    getAttributes(source, all, [&](osg::StateAttribute* attribute, unsigned int value) {
        if (attribute->isTextureAttribute())
            throw DamagedBytes("a texture outside the units of textures");
        state->setAttribute(attribute, value);
    });
    const std::size_t units = source.getCount(1);
    if (units > mostTextureUnits)
        throw DamagedBytes("too many units of textures");
    for (unsigned int unit = 0; unit < units; ++unit) {
        getModes(source, [&](GLenum mode, unsigned int value) {
            state->setTextureMode(unit, mode, value);
        });
        getAttributes(source, all, [&](osg::StateAttribute* attribute, unsigned int value) {
            if (!attribute->isTextureAttribute())
                throw DamagedBytes("no texture in a unit of textures");
            state->setTextureAttribute(unit, attribute, value);
        });
    }
    const auto hint = source.get<std::int32_t>();
    const bool ownBin = source.getFlag();
    const auto bin = source.get<std::int32_t>();
    const std::string name = source.getText();
    if (hint == osg::StateSet::OPAQUE_BIN || hint == osg::StateSet::TRANSPARENT_BIN)
        state->setRenderingHint(hint);
    // Other bins are made by name, and a name may be anything.
    if (ownBin && (name == "RenderBin" || name == "DepthSortedBin"))
        state->setRenderBinDetails(bin, name);
    return state;
}

} // namespace

std::vector<osg::ref_ptr<osg::StateSet>> getStates(ByteSource& source) {
    std::vector<osg::ref_ptr<osg::Image>> images(source.getCount(32));
    for (auto& image : images)
        image = getImage(source);
    Attributes attributes(source.getCount(32));
    for (auto& attribute : attributes)
        attribute = getAttribute(source, images);
    std::vector<osg::ref_ptr<osg::StateSet>> states(source.getCount(32));
    for (auto& state : states)
        state = getState(source, attributes);
    return states;
}

} // namespace irsg
