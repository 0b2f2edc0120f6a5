#include "irsg/geometry/reading/sandbox/GeometryCoding.h"

#include <algorithm>

#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/sandbox/AttributeCoding.h"

namespace irsg {

namespace {

// An array is its type (0 for none), binding, normalization, number of elements and elements.

struct Element {
    osg::Array::Type type;
    std::size_t size;
    osg::Array* (*make)();
};

template <typename Kind>
osg::Array* make() {
    return new Kind;
}

constexpr Element elements[] = {
    {osg::Array::Vec2ArrayType, sizeof(osg::Vec2), make<osg::Vec2Array>},
    {osg::Array::Vec3ArrayType, sizeof(osg::Vec3), make<osg::Vec3Array>},
    {osg::Array::Vec4ArrayType, sizeof(osg::Vec4), make<osg::Vec4Array>},
    {osg::Array::Vec2dArrayType, sizeof(osg::Vec2d), make<osg::Vec2dArray>},
    {osg::Array::Vec3dArrayType, sizeof(osg::Vec3d), make<osg::Vec3dArray>},
    {osg::Array::Vec4dArrayType, sizeof(osg::Vec4d), make<osg::Vec4dArray>},
    {osg::Array::Vec4ubArrayType, sizeof(osg::Vec4ub), make<osg::Vec4ubArray>},
    {osg::Array::Vec3bArrayType, sizeof(osg::Vec3b), make<osg::Vec3bArray>},
    {osg::Array::Vec3sArrayType, sizeof(osg::Vec3s), make<osg::Vec3sArray>},
};

/// The number may be that of no type at all.
const Element* elementOf(int type) {
    const auto* found = std::ranges::find_if(
        elements, [type](const Element& element) { return int{element.type} == type; });
    return found == std::end(elements) ? nullptr : found;
}

bool putArray(ByteSink& sink, const osg::Array* array) {
    const Element* element = array ? elementOf(array->getType()) : nullptr;
    if (!element) {
        sink.put<std::uint8_t>(0);
        return array == nullptr;
    }
    sink.put(static_cast<std::uint8_t>(element->type));
    sink.put(static_cast<std::int8_t>(array->getBinding()));
    sink.put(static_cast<std::uint8_t>(array->getNormalize()));
    sink.putCount(array->getNumElements());
    sink.putBytes(array->getDataPointer(), array->getNumElements() * element->size);
    return true;
}

osg::ref_ptr<osg::Array> getArray(ByteSource& source) {
    const auto type = source.get<std::uint8_t>();
    if (type == 0)
        return nullptr;
    const Element* element = elementOf(type);
    if (!element)
        throw DamagedBytes("an array of another type");
    const auto binding = source.get<std::int8_t>();
    if (binding < osg::Array::BIND_UNDEFINED || binding > osg::Array::BIND_PER_VERTEX)
        throw DamagedBytes("an array that is bound to nothing");
    const bool normalize = source.getFlag();
    const std::size_t count = source.getCount(element->size);
    const std::string_view bytes = source.getBytes(count * element->size);
    osg::ref_ptr<osg::Array> array = element->make();
    array->resizeArray(static_cast<unsigned int>(count));
    if (count > 0)
        std::memcpy(const_cast<void*>(array->getDataPointer()), bytes.data(), bytes.size());
    array->setBinding(static_cast<osg::Array::Binding>(binding));
    array->setNormalize(normalize);
    return array;
}

/// A set of primitives is its mode and a form: a stretch of the vertices, stretches behind each
/// other, or indices.
enum class Form : std::uint8_t { stretch, lengths, indices };

void putPrimitives(ByteSink& sink, const osg::PrimitiveSet& set) {
    sink.put(static_cast<std::uint32_t>(set.getMode()));
    if (const auto* arrays = dynamic_cast<const osg::DrawArrays*>(&set)) {
        sink.put(Form::stretch);
        sink.put(static_cast<std::int32_t>(arrays->getFirst()));
        sink.put(static_cast<std::int32_t>(arrays->getCount()));
    } else if (const auto* lengths = dynamic_cast<const osg::DrawArrayLengths*>(&set)) {
        sink.put(Form::lengths);
        sink.put(static_cast<std::int32_t>(lengths->getFirst()));
        sink.putCount(lengths->size());
        sink.putEach<std::int32_t>(lengths->size(), [&](std::size_t i) { return (*lengths)[i]; });
    } else {
        sink.put(Form::indices);
        const unsigned int count = set.getNumIndices();
        sink.putCount(count);
        if (const auto* wide = dynamic_cast<const osg::DrawElementsUInt*>(&set))
            sink.putBytes(wide->getDataPointer(), 4 * std::size_t{count});
        else
            sink.putEach<std::uint32_t>(
                count, [&](std::size_t i) { return set.index(static_cast<unsigned int>(i)); });
    }
}

class Primitives {
  public:
    Primitives(std::size_t vertices, const std::string& name) : vertices_(vertices), name_(name) {}

    osg::ref_ptr<osg::PrimitiveSet> get(ByteSource& source) const {
        const auto mode = source.get<std::uint32_t>();
        if (mode > GL_POLYGON && mode != GL_PATCHES)
            throw DamagedBytes("primitives of no kind");
        switch (source.get<Form>()) {
        case Form::stretch: {
            const auto first = source.get<std::int32_t>(), count = source.get<std::int32_t>();
            check(first, count);
            return new osg::DrawArrays(mode, first, count);
        }
        case Form::lengths: {
            const auto first = source.get<std::int32_t>();
            osg::ref_ptr<osg::DrawArrayLengths> lengths = new osg::DrawArrayLengths(mode, first);
            std::int64_t sum = 0;
            for (std::size_t count = source.getCount(4); count > 0; --count) {
                lengths->push_back(source.get<std::int32_t>());
                sum += lengths->back();
                check(first, lengths->back() < 0 ? -1 : sum);
            }
            return lengths;
        }
        case Form::indices: {
            const std::size_t count = source.getCount(4);
            const std::string_view bytes = source.getBytes(4 * count);
            osg::ref_ptr<osg::DrawElementsUInt> indices =
                new osg::DrawElementsUInt(mode, static_cast<unsigned int>(count));
            if (count > 0)
                std::memcpy(&indices->front(), bytes.data(), bytes.size());
            const auto last = std::ranges::max_element(*indices);
            if (last != indices->end() && *last >= vertices_)
                refuse("a face with vertex " + std::to_string(*last));
            return indices;
        }
        }
        throw DamagedBytes("primitives in no form");
    }

  private:
    void check(std::int64_t first, std::int64_t count) const {
        if (first < 0 || count < 0 || first + count > static_cast<std::int64_t>(vertices_))
            refuse("faces of the vertices from " + std::to_string(first) + " to " +
                   std::to_string(first + count));
    }
    [[noreturn]] void refuse(std::string value) const {
        throw InputError({name_, "", std::move(value),
                          "indices below the number of vertices, " + std::to_string(vertices_)});
    }

    std::size_t vertices_;
    const std::string& name_;
};

/// Whether an array has an element for everything that asks it.
bool fits(const osg::Array& array, std::size_t vertices, std::size_t sets) {
    switch (array.getBinding()) {
    case osg::Array::BIND_PER_VERTEX:
        return array.getNumElements() == vertices;
    case osg::Array::BIND_PER_PRIMITIVE_SET:
        return array.getNumElements() >= sets;
    case osg::Array::BIND_OVERALL:
        return array.getNumElements() > 0;
    default:
        return true;
    }
}

} // namespace

void putGeometry(ByteSink& sink, const osg::Geometry& geometry, const std::string& name) {
    if (!putArray(sink, geometry.getVertexArray()))
        throw InputError({name, "geometry '" + geometry.getName() + "'",
                          "vertices of a type that is no position", "numbers of 32 or 64 bits"});
    putArray(sink, geometry.getNormalArray());
    putArray(sink, geometry.getColorArray());
    const unsigned int units =
        std::min<unsigned int>(mostTextureUnits, geometry.getNumTexCoordArrays());
    sink.put(units);
    for (unsigned int unit = 0; unit < units; ++unit)
        putArray(sink, geometry.getTexCoordArray(unit));
    sink.putCount(geometry.getNumPrimitiveSets());
    for (unsigned int i = 0; i < geometry.getNumPrimitiveSets(); ++i)
        putPrimitives(sink, *geometry.getPrimitiveSet(i));
}

osg::ref_ptr<osg::Geometry> getGeometry(ByteSource& source, const std::string& name, int& misfits) {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(getArray(source));
    const std::size_t vertices =
        geometry->getVertexArray() ? geometry->getVertexArray()->getNumElements() : 0;
    const osg::ref_ptr<osg::Array> normals = getArray(source), colours = getArray(source);
    const auto units = source.get<unsigned int>();
    if (units > mostTextureUnits)
        throw DamagedBytes("too many units of textures");
    osg::ref_ptr<osg::Array> places[mostTextureUnits];
    for (unsigned int unit = 0; unit < units; ++unit)
        places[unit] = getArray(source);
    const Primitives primitives(vertices, name);
    for (std::size_t count = source.getCount(13); count > 0; --count)
        geometry->addPrimitiveSet(primitives.get(source));

    bool misfit = false;
    const auto fitting = [&](osg::Array* array) {
        if (!array || fits(*array, vertices, geometry->getNumPrimitiveSets()))
            return array;
        misfit = true;
        return static_cast<osg::Array*>(nullptr);
    };
    geometry->setNormalArray(fitting(normals));
    geometry->setColorArray(fitting(colours));
    for (unsigned int unit = 0; unit < units; ++unit)
        if (osg::Array* array = fitting(places[unit]))
            geometry->setTexCoordArray(unit, array);
    misfits += misfit;
    geometry->setUseVertexBufferObjects(true);
    return geometry;
}

} // namespace irsg
