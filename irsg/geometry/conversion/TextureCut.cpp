#include "irsg/geometry/conversion/TextureCut.h"

#include <algorithm>
#include <cmath>

#include <osg/AlphaFunc>
#include <osg/Image>
#include <osg/StateSet>
#include <osg/TexMat>
#include <osg/Texture2D>

#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/Triangulation.h"

namespace irsg {

void TextureState::update(const osg::StateSet& state) {
    if (const auto* found = dynamic_cast<const osg::Texture2D*>(
            state.getTextureAttribute(0, osg::StateAttribute::TEXTURE)))
        texture = found;
    if (const auto* found = dynamic_cast<const osg::TexMat*>(
            state.getTextureAttribute(0, osg::StateAttribute::TEXMAT)))
        matrix = found;
    const auto mode = state.getTextureMode(0, GL_TEXTURE_2D);
    if ((mode & osg::StateAttribute::INHERIT) == 0)
        isEnabled = (mode & osg::StateAttribute::ON) != 0;
    const auto test = state.getMode(GL_ALPHA_TEST);
    if ((test & osg::StateAttribute::INHERIT) != 0)
        return;
    isTested = (test & osg::StateAttribute::ON) != 0;
    const auto* function =
        dynamic_cast<const osg::AlphaFunc*>(state.getAttribute(osg::StateAttribute::ALPHAFUNC));
    const bool isThreshold = function && (function->getFunction() == osg::AlphaFunc::GEQUAL ||
                                          function->getFunction() == osg::AlphaFunc::GREATER);
    // A test for anything above 0 leaves the rest to blending.
    if (isThreshold && function->getReferenceValue() > 0.0f)
        least = function->getReferenceValue();
}

bool TextureState::isUnreadable() const {
    const osg::Image* image = texture ? texture->getImage() : nullptr;
    return image && image->isCompressed();
}

namespace {

AlphaMask::Beyond beyondOf(osg::Texture::WrapMode mode) {
    switch (mode) {
    case osg::Texture::REPEAT:
        return AlphaMask::Beyond::repeats;
    case osg::Texture::MIRROR:
        return AlphaMask::Beyond::mirrors;
    case osg::Texture::CLAMP_TO_BORDER:
        return AlphaMask::Beyond::border;
    default:
        return AlphaMask::Beyond::stays;
    }
}

bool hasAlpha(const osg::Image& image) {
    switch (image.getPixelFormat()) {
    case GL_ALPHA:
    case GL_LUMINANCE_ALPHA:
    case GL_RGBA:
    case GL_BGRA:
        return !image.isCompressed() && image.data() && image.s() > 0 && image.t() > 0;
    default:
        return false;
    }
}

} // namespace

std::shared_ptr<const AlphaMask> AlphaMask::of(const TextureState& state) {
    const osg::Image* image = state.texture ? state.texture->getImage() : nullptr;
    if (!image || !hasAlpha(*image))
        return nullptr;
    auto mask = std::make_shared<AlphaMask>();
    mask->size_ = {image->s(), image->t()};
    mask->beyond_ = {beyondOf(state.texture->getWrap(osg::Texture::WRAP_S)),
                     beyondOf(state.texture->getWrap(osg::Texture::WRAP_T))};
    mask->above_.reserve(static_cast<std::size_t>(image->s()) *
                         static_cast<std::size_t>(image->t()));
    for (int row = 0; row < image->t(); ++row)
        for (int column = 0; column < image->s(); ++column)
            mask->above_.push_back(
                image->getColor(static_cast<unsigned int>(column), static_cast<unsigned int>(row))
                    .a() -
                state.least);
    const bool hasBorder = std::ranges::count(mask->beyond_, Beyond::border) > 0;
    mask->border_ = static_cast<float>(state.texture->getBorderColor().a()) - state.least;
    // Also for what is no number.
    const auto isThere = [](float above) { return !(above < 0.0f); };
    if (std::ranges::all_of(mask->above_, isThere) && (!hasBorder || isThere(mask->border_)))
        return nullptr;
    for (float& above : mask->above_)
        if (std::isnan(above))
            above = 1.0f;
    if (state.matrix) {
        const osg::Matrixd& m = state.matrix->getMatrix();
        mask->matrix_ = {m(0, 0), m(0, 1), m(1, 0), m(1, 1), m(3, 0), m(3, 1)};
    }
    return mask;
}

osg::Vec2d AlphaMask::texelOf(const osg::Vec2d& place) const {
    const auto& m = matrix_;
    return {(place.x() * m[0] + place.y() * m[2] + m[4]) * size_[0] - 0.5,
            (place.x() * m[1] + place.y() * m[3] + m[5]) * size_[1] - 0.5};
}

namespace {

constexpr double mostTexels = 1 << 26;

/// Middles of texels along an axis, as many as a stretch of it needs, and the texels there.
struct Axis {
    std::vector<double> at;
    std::vector<int> texel;

    Axis(const AlphaMask& mask, int axis, double from, double to, const std::string& name) {
        const int size = mask.texels(axis);
        const double first = std::floor(from), last = std::max(std::ceil(to), first + 1.0);
        const AlphaMask::Beyond beyond = mask.beyond(axis);
        if (!(std::abs(first) < 1e9 && std::abs(last) < 1e9))
            throw InputError({name, "", "a face far off its texture",
                              "places on textures within 1e9 texels of them"});
        double inner = first, end = last;
        if (beyond == AlphaMask::Beyond::stays || beyond == AlphaMask::Beyond::border) {
            // Nothing changes farther out.
            inner = std::clamp(first, -1.0, static_cast<double>(size));
            end = std::clamp(last, -1.0, static_cast<double>(size));
        }
        if (end - inner > mostTexels)
            throw InputError({name, "",
                              "a face over " + std::to_string((end - inner) / size) +
                                  " repetitions of its texture",
                              "at most 2^26 texels across a face"});
        if (first < inner)
            add(first, beyond, size);
        for (double i = inner; i <= end; ++i)
            add(i, beyond, size);
        if (last > end)
            add(last, beyond, size);
    }

  private:
    void add(double place, AlphaMask::Beyond beyond, int size) {
        at.push_back(place);
        const auto i = static_cast<long>(place);
        const auto wrapped = [i](long period) { return ((i % period) + period) % period; };
        long texel = std::clamp(i, 0L, static_cast<long>(size) - 1);
        if (beyond == AlphaMask::Beyond::repeats)
            texel = wrapped(size);
        else if (beyond == AlphaMask::Beyond::mirrors)
            texel =
                wrapped(2L * size) < size ? wrapped(2L * size) : 2L * size - 1 - wrapped(2L * size);
        else if (beyond == AlphaMask::Beyond::border && texel != i)
            texel = -1;
        this->texel.push_back(static_cast<int>(texel));
    }
};

using Outline = std::vector<osg::Vec2d>;

/// The part of a convex outline where a function of its corners, linear between them, is not
/// negative.
template <typename Height>
Outline where(const Outline& outline, const Height& height) {
    Outline kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const osg::Vec2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
        const double ha = height(a), hb = height(b);
        if (ha >= 0.0)
            kept.push_back(a);
        if ((ha < 0.0) != (hb < 0.0) && ha != 0.0 && hb != 0.0)
            kept.push_back(a + (b - a) * (ha / (ha - hb)));
    }
    return kept;
}

double across(const osg::Vec2d& a, const osg::Vec2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Cuts one triangle.
class Cutter {
  public:
    Cutter(const AlphaMask& mask, const std::array<osg::Vec2d, 3>& triangle,
           const std::string& name)
        : mask_(mask),
          triangle_(triangle.begin(), triangle.end()),
          columns_(mask, 0, least(0), most(0), name),
          rows_(mask, 1, least(1), most(1), name) {
        if (static_cast<double>(columns_.at.size()) * static_cast<double>(rows_.at.size()) >
            mostTexels)
            throw InputError({name, "",
                              "a face over " + std::to_string(columns_.at.size()) + " x " +
                                  std::to_string(rows_.at.size()) + " texels",
                              "at most 2^26 texels under a face"});
    }

    bool isWhole() const {
        for (std::size_t row = 0; row < rows_.at.size(); ++row)
            for (std::size_t column = 0; column < columns_.at.size(); ++column)
                if (above(column, row) < 0.0)
                    return false;
        return true;
    }

    std::vector<Outline> parts() {
        cut(0, columns_.at.size() - 1, 0, rows_.at.size() - 1);
        return std::move(parts_);
    }

  private:
    double least(int axis) const {
        return std::min({triangle_[0][axis], triangle_[1][axis], triangle_[2][axis]});
    }
    double most(int axis) const {
        return std::max({triangle_[0][axis], triangle_[1][axis], triangle_[2][axis]});
    }
    double above(std::size_t column, std::size_t row) const {
        return static_cast<double>(mask_.above(columns_.texel[column], rows_.texel[row]));
    }

    /// Cells between these middles: all there, none, or cut in two.
    void cut(std::size_t left, std::size_t right, std::size_t bottom, std::size_t top) {
        const Outline inside =
            within(columns_.at[left], columns_.at[right], rows_.at[bottom], rows_.at[top]);
        if (inside.size() < 3)
            return;
        bool some = false, others = false;
        for (std::size_t row = bottom; row <= top && !(some && others); ++row)
            for (std::size_t column = left; column <= right; ++column)
                (above(column, row) < 0.0 ? others : some) = true;
        if (!others)
            parts_.push_back(inside);
        if (!some || !others)
            return;
        if (right - left == 1 && top - bottom == 1)
            return cutCell(left, bottom);
        if (right - left >= top - bottom) {
            const std::size_t middle = (left + right) / 2;
            cut(left, middle, bottom, top);
            cut(middle, right, bottom, top);
        } else {
            const std::size_t middle = (bottom + top) / 2;
            cut(left, right, bottom, middle);
            cut(left, right, middle, top);
        }
    }

    void cutCell(std::size_t column, std::size_t row) {
        const std::array<osg::Vec2d, 4> corners{
            osg::Vec2d(columns_.at[column], rows_.at[row]),
            osg::Vec2d(columns_.at[column + 1], rows_.at[row]),
            osg::Vec2d(columns_.at[column + 1], rows_.at[row + 1]),
            osg::Vec2d(columns_.at[column], rows_.at[row + 1])};
        const std::array<double, 4> heights{above(column, row), above(column + 1, row),
                                            above(column + 1, row + 1), above(column, row + 1)};
        const osg::Vec2d middle = (corners[0] + corners[2]) * 0.5;
        const double mean = 0.25 * (heights[0] + heights[1] + heights[2] + heights[3]);
        for (std::size_t i = 0; i < 4; ++i) {
            const osg::Vec2d &a = corners[i], &b = corners[(i + 1) % 4];
            const osg::Vec2d ab = b - a, ac = middle - a;
            const double size = across(ab, ac);
            const double up = heights[(i + 1) % 4] - heights[i], in = mean - heights[i];
            Outline part = where({a, b, middle}, [&](const osg::Vec2d& p) {
                return heights[i] + (up * across(p - a, ac) + in * across(ab, p - a)) / size;
            });
            part = inTriangle(std::move(part));
            if (part.size() < 3)
                continue;
            // As the triangle runs, which may lie mirrored under its texture.
            if (turn() < 0.0)
                std::ranges::reverse(part);
            parts_.push_back(std::move(part));
        }
    }

    double turn() const {
        return across(triangle_[1] - triangle_[0], triangle_[2] - triangle_[0]) < 0.0 ? -1.0 : 1.0;
    }

    Outline within(double left, double right, double bottom, double top) const {
        Outline inside = where(triangle_, [&](const osg::Vec2d& p) { return p.x() - left; });
        inside = where(inside, [&](const osg::Vec2d& p) { return right - p.x(); });
        inside = where(inside, [&](const osg::Vec2d& p) { return p.y() - bottom; });
        return where(inside, [&](const osg::Vec2d& p) { return top - p.y(); });
    }

    Outline inTriangle(Outline part) const {
        const double side = turn();
        for (std::size_t i = 0; i < 3; ++i) {
            const osg::Vec2d &a = triangle_[i], &b = triangle_[(i + 1) % 3];
            part = where(part, [&](const osg::Vec2d& p) { return side * across(b - a, p - a); });
        }
        return part;
    }

    const AlphaMask& mask_;
    Outline triangle_;
    Axis columns_, rows_;
    std::vector<Outline> parts_;
};

PolygonCorner between(const std::array<const PolygonCorner*, 3>& corners,
                      const std::array<double, 3>& weights) {
    PolygonCorner corner = *corners[0];
    corner.position.set(0, 0, 0);
    corner.normal.set(0, 0, 0);
    corner.onTexture.set(0, 0);
    corner.colour.set(0, 0, 0, 0);
    for (std::size_t i = 0; i < 3; ++i) {
        corner.position += corners[i]->position * weights[i];
        corner.normal += corners[i]->normal * weights[i];
        corner.onTexture += corners[i]->onTexture * weights[i];
        corner.colour += corners[i]->colour * static_cast<float>(weights[i]);
    }
    return corner;
}

/// Alpha at a place, for what has no extent on the texture.
bool isThere(const AlphaMask& mask, const osg::Vec2d& texel, const std::string& name) {
    const Axis columns(mask, 0, texel.x(), texel.x(), name),
        rows(mask, 1, texel.y(), texel.y(), name);
    const double x = std::clamp(texel.x() - columns.at[0], 0.0, 1.0),
                 y = std::clamp(texel.y() - rows.at[0], 0.0, 1.0);
    const auto above = [&](std::size_t i, std::size_t j) {
        return static_cast<double>(mask.above(columns.texel[i], rows.texel[j]));
    };
    return (1 - y) * ((1 - x) * above(0, 0) + x * above(1, 0)) +
               y * ((1 - x) * above(0, 1) + x * above(1, 1)) >=
           0.0;
}

} // namespace

long cutOut(const AlphaMask& mask, std::vector<PolygonCorner>& corners, const std::string& name,
            const std::function<void(std::vector<PolygonCorner>&)>& each) {
    const Triangulation whole = triangulate(corners);
    std::vector<std::vector<PolygonCorner>> parts;
    bool isWhole = true;
    for (const auto& numbers : whole.triangles) {
        const std::array<const PolygonCorner*, 3> triangle{
            &corners[numbers[0]], &corners[numbers[1]], &corners[numbers[2]]};
        const std::array<osg::Vec2d, 3> texels{mask.texelOf(triangle[0]->onTexture),
                                               mask.texelOf(triangle[1]->onTexture),
                                               mask.texelOf(triangle[2]->onTexture)};
        const std::vector<PolygonCorner> asItIs{*triangle[0], *triangle[1], *triangle[2]};
        const osg::Vec2d ab = texels[1] - texels[0], ac = texels[2] - texels[0];
        const double size = across(ab, ac);
        if (!(std::abs(size) > 1e-9 * (ab.length2() + ac.length2()))) {
            if (isThere(mask, (texels[0] + texels[1] + texels[2]) / 3.0, name))
                parts.push_back(asItIs);
            else
                isWhole = false;
            continue;
        }
        Cutter cutter(mask, texels, name);
        if (cutter.isWhole()) {
            parts.push_back(asItIs);
            continue;
        }
        isWhole = false;
        for (const Outline& outline : cutter.parts()) {
            auto& part = parts.emplace_back();
            for (const osg::Vec2d& texel : outline) {
                const double b = across(texel - texels[0], ac) / size,
                             c = across(ab, texel - texels[0]) / size;
                part.push_back(between(triangle, {1.0 - b - c, b, c}));
            }
        }
    }
    if (isWhole && !whole.triangles.empty()) {
        each(corners);
        return 1;
    }
    for (auto& part : parts)
        each(part);
    return static_cast<long>(parts.size());
}

} // namespace irsg
