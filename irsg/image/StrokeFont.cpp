#include "irsg/image/StrokeFont.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "irsg/image/StrokeGlyphs.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr double spacing = 3.0; // between the last stem of a letter and the first of the next
constexpr double superscriptSize = 0.6;
constexpr double superscriptRise = 5.0;

struct Point {
    double x, y;
};

/// A letter of a line: which strokes, how large and how far above the base line.
struct PlacedGlyph {
    const StrokeGlyph* glyph;
    double size = 1.0;
    double rise = 0.0;
    int x_px = 0;
    int width_px = 0;
};

/// The code points of UTF-8 text; a byte that breaks its rules is a character without glyph.
std::vector<char32_t> decoded(std::string_view text) {
    std::vector<char32_t> codes;
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t length = lead < 0x80             ? 1
                                   : (lead & 0xE0) == 0xC0 ? 2
                                   : (lead & 0xF0) == 0xE0 ? 3
                                   : (lead & 0xF8) == 0xF0 ? 4
                                                           : 0;
        if (length == 0 || i + length > text.size()) {
            codes.push_back(0xFFFD);
            ++i;
            continue;
        }
        char32_t code = length == 1 ? lead : lead & (0xFFU >> (length + 1));
        for (std::size_t k = 1; k < length; ++k)
            code = (code << 6) | (static_cast<unsigned char>(text[i + k]) & 0x3FU);
        codes.push_back(code);
        i += length;
    }
    return codes;
}

/// The plain character of a superscript one, or 0.
char32_t superscripted(char32_t code) {
    switch (code) {
    case U'\u00B9':
        return U'1';
    case U'\u00B2':
        return U'2';
    case U'\u00B3':
        return U'3';
    case U'\u207A':
        return U'+';
    case U'\u207B':
        return U'\u2212';
    default:
        break;
    }
    return code == U'\u2070' || (code >= U'\u2074' && code <= U'\u2079') ? U'0' + (code - U'\u2070')
                                                                         : 0;
}

std::vector<PlacedGlyph> placed(std::string_view text, int scale) {
    std::vector<PlacedGlyph> line;
    int x_px = 0;
    for (const char32_t code : decoded(text)) {
        const char32_t plain = superscripted(code);
        PlacedGlyph letter{&strokeGlyph(plain != 0 ? plain : code)};
        if (plain != 0) {
            letter.size = superscriptSize;
            letter.rise = superscriptRise;
        }
        // Letters stand on whole pixels, so that all stems of a kind look alike.
        letter.x_px = x_px;
        letter.width_px = static_cast<int>(std::lround(letter.glyph->width * letter.size * scale));
        x_px += letter.width_px + static_cast<int>(std::lround(spacing * scale));
        line.push_back(letter);
    }
    return line;
}

/// The strokes of a glyph as polylines.
std::vector<std::vector<Point>> strokesOf(const StrokeGlyph& glyph) {
    std::vector<std::vector<Point>> strokes;
    std::istringstream path{std::string(glyph.path)};
    for (char command = 0; path >> command;) {
        double a = 0.0, b = 0.0;
        path >> a >> b;
        if (command == 'M') {
            strokes.push_back({{a, b}});
        } else if (command == 'L') {
            strokes.back().push_back({a, b});
        } else {
            double rx = 0.0, ry = 0.0, from = 0.0, to = 0.0;
            path >> rx >> ry >> from >> to;
            constexpr int pieces = 24;
            strokes.emplace_back();
            for (int i = 0; i <= pieces; ++i) {
                const double angle = radians(from + (to - from) * i / pieces);
                strokes.back().push_back({a + rx * std::cos(angle), b + ry * std::sin(angle)});
            }
        }
    }
    return strokes;
}

double distance(Point p, Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double square = dx * dx + dy * dy;
    const double t =
        square > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

} // namespace

int textWidth(std::string_view text, int scale) {
    const std::vector<PlacedGlyph> line = placed(text, scale);
    return line.empty() ? 0 : line.back().x_px + line.back().width_px + scale;
}

void drawText(Canvas& canvas, int x, int y, std::string_view text, int scale, Rgb color) {
    // A stroke is one pixel wide at scale 1. Wide strokes of an even number of pixels have their
    // middle between two pixels.
    const double middle = 0.5 * (scale - 1);

    for (const PlacedGlyph& letter : placed(text, scale)) {
        // The strokes in pixels, pixel centres at whole numbers.
        std::vector<std::vector<Point>> strokes = strokesOf(*letter.glyph);
        for (std::vector<Point>& stroke : strokes)
            for (Point& point : stroke)
                point = {x + letter.x_px + middle + point.x * letter.size * scale,
                         y - middle - (point.y * letter.size + letter.rise) * scale};

        // Each pixel near the letter is covered by its nearest stroke; small letters are thinner.
        const double weight = letter.size < 1.0 ? 0.8 * scale : scale;
        const double halfWidth = 0.5 * std::max(weight, 1.0) + 0.05;
        const int margin = 2 * scale + 1;
        for (int row = y - 12 * scale - margin; row <= y + descent_px * scale + margin; ++row)
            for (int column = x + letter.x_px - margin;
                 column <= x + letter.x_px + letter.width_px + margin; ++column) {
                double nearest = 2.0 * margin;
                const Point pixel{static_cast<double>(column), static_cast<double>(row)};
                for (const std::vector<Point>& stroke : strokes)
                    for (std::size_t i = 0; i + 1 < stroke.size(); ++i)
                        nearest = std::min(nearest, distance(pixel, stroke[i], stroke[i + 1]));
                const double coverage = std::clamp(halfWidth + 0.5 - nearest, 0.0, 1.0);
                if (coverage > 0.0)
                    canvas.blend(column, row, color, coverage);
            }
    }
}

} // namespace irsg
