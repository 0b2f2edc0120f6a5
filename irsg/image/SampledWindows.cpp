#include "irsg/image/SampledWindows.h"

#include <sstream>

namespace irsg {

namespace {

constexpr const char* attribute = "windows";
constexpr int digits = 9; // of what is read back to a thousandth of a pixel in any frame

} // namespace

void describeWindows(const std::vector<SampledWindow>& windows, RadianceImage& image) {
    if (windows.empty()) {
        image.attributes.erase(attribute);
        return;
    }
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(digits);
    for (const SampledWindow& window : windows)
        text << window.left_px << ' ' << window.top_px << ' ' << window.right_px << ' '
             << window.bottom_px << ' ' << window.across << ' ' << window.down << ' '
             << window.objects << '\n';
    image.attributes[attribute] = text.str();
}

std::vector<SampledWindow> windowsOf(const RadianceImage& image) {
    const auto found = image.attributes.find(attribute);
    if (found == image.attributes.end())
        return {};
    std::vector<SampledWindow> windows;
    std::istringstream lines(found->second);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        fields.imbue(std::locale::classic());
        SampledWindow& window = windows.emplace_back();
        fields >> window.left_px >> window.top_px >> window.right_px >> window.bottom_px >>
            window.across >> window.down;
        if (!fields)
            return {};
        std::getline(fields >> std::ws, window.objects);
    }
    return windows;
}

} // namespace irsg
