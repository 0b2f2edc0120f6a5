#include "irsg/image/SampledTiles.h"

#include <sstream>

namespace irsg {

namespace {

constexpr const char* attribute = "windows";
constexpr int digits = 9; // of what is read back to a thousandth of a pixel in any frame

} // namespace

void describeTiles(const std::vector<SampledTile>& tiles, RadianceImage& image) {
    if (tiles.empty()) {
        image.attributes.erase(attribute);
        return;
    }
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(digits);
    for (const SampledTile& tile : tiles)
        text << tile.left_px << ' ' << tile.top_px << ' ' << tile.right_px << ' ' << tile.bottom_px
             << ' ' << tile.across << ' ' << tile.down << ' ' << tile.objects << '\n';
    image.attributes[attribute] = text.str();
}

std::vector<SampledTile> tilesOf(const RadianceImage& image) {
    const auto found = image.attributes.find(attribute);
    if (found == image.attributes.end())
        return {};
    std::vector<SampledTile> tiles;
    std::istringstream lines(found->second);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        fields.imbue(std::locale::classic());
        SampledTile& tile = tiles.emplace_back();
        fields >> tile.left_px >> tile.top_px >> tile.right_px >> tile.bottom_px >> tile.across >>
            tile.down;
        if (!fields)
            return {};
        std::getline(fields >> std::ws, tile.objects);
    }
    return tiles;
}

} // namespace irsg
