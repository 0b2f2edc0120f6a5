#include "gui/plot/Coverage.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "irsg/core/Errors.h"

namespace smat::gui {
namespace {

/// Zeros between two drawings, kept so that a plot of many curves does not ask for memory for each.
std::vector<std::uint8_t>& sharedCovers() {
    thread_local std::vector<std::uint8_t> covers;
    return covers;
}

/// Pixels that are blended at once.
constexpr int chunk = 16;

bool isUniform(const std::uint8_t* covers) {
    std::uint64_t first = 0, second = 0;
    std::memcpy(&first, covers, sizeof first);
    std::memcpy(&second, covers + sizeof first, sizeof second);
    return first == second && first == covers[0] * 0x0101010101010101U;
}

/// Each byte of two channels · share / 255, rounded.
constexpr std::uint32_t twoChannels = 0x00FF00FFU;
std::uint32_t part(std::uint32_t channels, std::uint32_t share) {
    const std::uint32_t product = channels * share + 0x00800080U;
    return ((product + ((product >> 8U) & twoChannels)) >> 8U) & twoChannels;
}

/// A colour that is laid over pixels which it covers in part.
class Ink {
  public:
    explicit Ink(const QColor& color) {
        const auto alpha = static_cast<std::uint32_t>(color.alpha());
        const QRgb opaque = color.rgb();
        for (std::uint32_t cover = 0; cover < shades_.size(); ++cover) {
            const std::uint32_t share = part(cover, alpha);
            shades_[cover] = {part((opaque >> 8U) & twoChannels, share) << 8U |
                                  part(opaque & twoChannels, share),
                              255U - share};
        }
    }
    QRgb over(QRgb below, std::uint8_t cover) const {
        const Shade& shade = shades_[cover];
        return shade.added + (part((below >> 8U) & twoChannels, shade.under) << 8U |
                              part(below & twoChannels, shade.under));
    }
    /// The same of many pixels, byte by byte: such a loop the compiler makes one of vectors.
    void blendChunk(QRgb* pixels, std::uint8_t cover) const {
        const Shade& shade = shades_[cover];
        constexpr int bytes = chunk * sizeof(QRgb);
        std::array<std::uint8_t, bytes> added, below;
        for (int i = 0; i < chunk; ++i)
            std::memcpy(added.data() + i * static_cast<int>(sizeof(QRgb)), &shade.added,
                        sizeof(QRgb));
        std::memcpy(below.data(), pixels, bytes);
        const auto under = static_cast<std::uint16_t>(shade.under);
        for (std::size_t i = 0; i < bytes; ++i) {
            const auto product = static_cast<std::uint16_t>(below[i] * under + 128);
            below[i] = static_cast<std::uint8_t>(added[i] + ((product + (product >> 8U)) >> 8U));
        }
        std::memcpy(pixels, below.data(), bytes);
    }

  private:
    struct Shade {
        QRgb added;
        std::uint32_t under; ///< how much of a pixel stays, of 255
    };
    std::array<Shade, 256> shades_; ///< of each cover
};

} // namespace

bool Coverage::canDrawInto(const QImage& picture) {
    return picture.format() == QImage::Format_RGB32 ||
           picture.format() == QImage::Format_ARGB32_Premultiplied;
}

Coverage::Coverage(QImage& picture, const QRect& clip)
    : picture_(picture), clip_(clip & picture.rect()), covers_(sharedCovers()) {
    if (!canDrawInto(picture))
        throw irsg::LogicError("a picture of this format cannot be drawn into");
    const int rows = clip_.height();
    const std::size_t pixels = rowOffset(rows);
    if (covers_.size() < pixels)
        covers_.resize(pixels);
    rows_.assign(static_cast<std::size_t>(rows), {std::numeric_limits<int>::max(), -1});
}

void Coverage::paint(const QColor& color, const QRegion& region) {
    const Ink ink(color);
    const auto blend = [&](int y, int from, int to) {
        const std::uint8_t* covers = covers_.data() + rowOffset(y);
        auto* pixels = reinterpret_cast<QRgb*>(picture_.scanLine(clip_.top() + y)) + clip_.left();
        for (int x = from; x <= to;) {
            // Neighbours are mostly covered alike, by nothing or by all.
            if (x + chunk <= to + 1 && isUniform(covers + x)) {
                if (covers[x] != 0)
                    ink.blendChunk(pixels + x, covers[x]);
                x += chunk;
                continue;
            }
            for (const int end = std::min(x + chunk, to + 1); x < end; ++x)
                if (covers[x] != 0)
                    pixels[x] = ink.over(pixels[x], covers[x]);
        }
    };
    for (const QRect& rectangle : region) {
        const QRect seen = (rectangle & clip_).translated(-clip_.topLeft());
        for (int y = seen.top(); y <= seen.bottom(); ++y) {
            const Columns touched = rows_[static_cast<std::size_t>(y)];
            blend(y, std::max(touched.first, seen.left()), std::min(touched.last, seen.right()));
        }
    }
    for (int y = 0; y < clip_.height(); ++y) {
        Columns& touched = rows_[static_cast<std::size_t>(y)];
        if (touched.first <= touched.last) {
            std::uint8_t* row = covers_.data() + rowOffset(y);
            std::fill(row + touched.first, row + touched.last + 1, std::uint8_t(0));
        }
        touched = {std::numeric_limits<int>::max(), -1};
    }
}

} // namespace smat::gui
