#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "irsg/core/Collect.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Interpolation.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/Microfacets.h"
#include "irsg/signature/ReflectanceCsv.h"

namespace irsg {

namespace {

constexpr double gridStep_deg = 2.5;
/// With which the grid stays below what a table may hold.
constexpr std::size_t mostIncidences = 700;

/// Its words by line, comments and empty lines left out.
class Words {
  public:
    Words(std::string_view text, std::string name) : name_(std::move(name)) {
        int number = 1;
        while (!text.empty()) {
            const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
            add(text.substr(0, end), number);
            const bool isPair = text.substr(end).starts_with("\r\n");
            text.remove_prefix(std::min(end + (isPair ? 2 : 1), text.size()));
            ++number;
        }
    }
    struct Line {
        int number = 0;
        std::vector<std::string> words;
    };
    const Line& next(const std::string& expected) {
        if (at_ == lines_.size())
            throw InputError(Diagnostic{name_, "its end", "nothing", expected});
        return lines_[at_++];
    }
    [[noreturn]] void refuse(const Line& line, const std::string& value,
                             const std::string& expected) const {
        throw InputError(Diagnostic{name_, "line " + std::to_string(line.number), value, expected});
    }
    const std::string& name() const { return name_; }
    /// The next line has to be these words.
    void expect(const std::vector<std::string>& words) {
        const auto joined = [](const std::vector<std::string>& all) {
            std::string text;
            for (const std::string& word : all)
                text += (text.empty() ? "" : " ") + word;
            return "'" + text + "'";
        };
        const Line& line = next(joined(words));
        if (line.words != words)
            refuse(line, joined(line.words), joined(words));
    }
    /// The word behind `key` on the next line.
    std::string valueOf(const std::string& key) {
        const Line& line = next("'" + key + "'");
        if (line.words.size() != 2 || line.words[0] != key)
            refuse(line, "'" + line.words[0] + "'", "'" + key + "' and its value");
        return line.words[1];
    }
    /// `key COUNT` and the numbers of the next line, which ascend.
    std::vector<double> axisOf(const std::string& key, double least, double most) {
        const std::string count = valueOf(key);
        const Line& line = next("the angles of " + key);
        const std::vector<double> axis = numbersOf(line);
        if (parseNumber(count).value_or(-1.0) != static_cast<double>(axis.size()))
            refuse(line, std::to_string(axis.size()) + " angles", count + " of " + key);
        for (std::size_t i = 0; i < axis.size(); ++i)
            if (!(axis[i] >= least && axis[i] <= most) || (i > 0 && axis[i] <= axis[i - 1]))
                refuse(line, numberText(axis[i]),
                       "angles from " + numberText(least) + " to " + numberText(most) +
                           " that ascend");
        return axis;
    }
    std::vector<double> numbersOf(const Line& line) const {
        std::vector<double> numbers;
        for (const std::string& word : line.words) {
            const std::optional<double> number = parseNumber(word);
            if (!number)
                refuse(line, "'" + word + "'", "a number");
            numbers.push_back(*number);
        }
        return numbers;
    }

  private:
    void add(std::string_view line, int number) {
        Line words{number, {}};
        while (!line.empty() && line.front() != '#') {
            const std::size_t begin = line.find_first_not_of(" \t,");
            if (begin == std::string_view::npos)
                break;
            line.remove_prefix(begin);
            if (line.front() == '#')
                break;
            const std::size_t end = std::min(line.find_first_of(" \t,"), line.size());
            words.words.emplace_back(line.substr(0, end));
            line.remove_prefix(end);
        }
        if (!words.words.empty())
            lines_.push_back(std::move(words));
    }

    std::string name_;
    std::vector<Line> lines_;
    std::size_t at_ = 0;
};

/// What a file of the format holds: BRDF by incidence, azimuth and radial angle about the mirror
/// direction.
struct Measured {
    std::vector<double> incidences_deg, azimuths_deg, radials_deg;
    std::vector<double> values;

    double at(std::size_t incidence, double azimuth_deg, double radial_deg) const {
        const Bracket a = bracket(azimuths_deg, azimuth_deg);
        const Bracket r = bracket(radials_deg, radial_deg);
        const auto atAzimuth = [&](std::size_t azimuth) {
            const std::size_t row =
                (incidence * azimuths_deg.size() + azimuth) * radials_deg.size();
            return lerp(values[row + r.below], values[row + r.above], r.fraction);
        };
        return lerp(atAzimuth(a.below), atAzimuth(a.above), a.fraction);
    }
};

Measured measuredIn(Words& words) {
    words.expect({"Source", "Measured"});
    words.expect({"Symmetry", "PlaneSymmetrical"});
    words.expect({"SpectralContent", "Monochrome"});
    words.expect({"ScatterType", "BRDF"});
    words.axisOf("SampleRotation", -360.0, 360.0);
    Measured measured;
    measured.incidences_deg = words.axisOf("AngleOfIncidence", 0.0, 90.0);
    if (measured.incidences_deg.size() > mostIncidences)
        throw InputError(Diagnostic{words.name(), "AngleOfIncidence",
                                    std::to_string(measured.incidences_deg.size()),
                                    "at most " + std::to_string(mostIncidences)});
    measured.azimuths_deg = words.axisOf("ScatterAzimuth", 0.0, 180.0);
    measured.radials_deg = words.axisOf("ScatterRadial", 0.0, 180.0);
    words.expect({"Monochrome"});
    words.expect({"DataBegin"});
    for (std::size_t i = 0; i < measured.incidences_deg.size(); ++i) {
        words.valueOf("TIS"); // the integral of what follows, from which it is taken
        for (std::size_t a = 0; a < measured.azimuths_deg.size(); ++a) {
            const Words::Line& line = words.next("a row of BRDF");
            const std::vector<double> row = words.numbersOf(line);
            if (row.size() != measured.radials_deg.size())
                words.refuse(line, std::to_string(row.size()) + " values",
                             std::to_string(measured.radials_deg.size()) +
                                 ", one for each radial angle");
            measured.values.insert(measured.values.end(), row.begin(), row.end());
        }
    }
    words.expect({"DataEnd"});
    return measured;
}

/// Azimuth and radial angle of a direction about the mirror direction of an incidence, degrees;
/// azimuth 0 points from there to the normal.
std::pair<double, double> aboutMirror(double incidence_rad, double reflection_rad,
                                      double azimuth_rad) {
    // Light comes from -x: the mirror direction leans to +x, at an azimuth of 180 deg.
    const SurfaceDirection to{-std::sin(reflection_rad) * std::cos(azimuth_rad),
                              std::sin(reflection_rad) * std::sin(azimuth_rad),
                              std::cos(reflection_rad)};
    const SurfaceDirection mirror{std::sin(incidence_rad), 0.0, std::cos(incidence_rad)};
    const SurfaceDirection toNormal{-std::cos(incidence_rad), 0.0, std::sin(incidence_rad)};
    const double radial = std::acos(std::clamp(dot(to, mirror), -1.0, 1.0));
    return {degrees(std::atan2(std::abs(to.y), dot(to, toNormal))), degrees(radial)};
}

} // namespace

bool isZemaxBsdf(const std::string& text) {
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::string_view line = trimmed(rest.substr(0, rest.find_first_of("\r\n")));
        if (!line.empty() && line.front() != '#')
            return line.starts_with("Source ") || line.starts_with("Source\t");
        const std::size_t end = rest.find_first_of("\r\n");
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    return false;
}

ReflectanceTable parseZemaxBsdf(const std::string& text, const std::string& name) {
    Words words(text, name);
    const Measured measured = measuredIn(words);
    std::vector<ReflectanceTable::Row> rows;
    for (std::size_t i = 0; i < measured.incidences_deg.size(); ++i)
        for (double reflection_deg = 0.0; reflection_deg <= 90.0; reflection_deg += gridStep_deg)
            for (double azimuth_deg = 0.0; azimuth_deg <= 180.0; azimuth_deg += gridStep_deg) {
                const auto [about_deg, radial_deg] =
                    aboutMirror(radians(measured.incidences_deg[i]), radians(reflection_deg),
                                radians(azimuth_deg));
                rows.push_back({measured.incidences_deg[i],
                                reflection_deg,
                                azimuth_deg,
                                {measured.at(i, about_deg, radial_deg)}});
            }
    return editing(
        [&] {
            return ReflectanceTable{true, {1.0}, std::move(rows)};
        },
        [&](Diagnostic& one) { one.file = name; });
}

} // namespace irsg
