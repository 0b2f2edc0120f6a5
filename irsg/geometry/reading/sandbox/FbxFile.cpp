#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/sandbox/DeclaredContents.h"
#include "irsg/geometry/reading/sandbox/FbxRecords.h"
#include "irsg/geometry/reading/text/ModelText.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic("Kaydara FBX Binary  \0\x1a\0", 23);
constexpr int mostRecordLevels = 64;

/// Numbers of GlobalSettings by their names.
using Settings = std::map<std::string, double, std::less<>>;

FileAxes axesOf(const Settings& settings) {
    FileAxes axes;
    const auto number = [&](std::string_view key) -> std::optional<double> {
        const auto found = settings.find(key);
        return found == settings.end() ? std::nullopt : std::optional(found->second);
    };
    std::string said;
    if (const auto unit_cm = number("UnitScaleFactor"); unit_cm && *unit_cm > 0.0) {
        axes.unit_m = *unit_cm / 100.0;
        said = "UnitScaleFactor " + numberText(*unit_cm) + " (a unit of " + numberText(*unit_cm) +
               " cm)";
    }
    if (const auto up = number("UpAxis"); up && (*up == 0.0 || *up == 1.0 || *up == 2.0)) {
        static constexpr ModelAxis known[3][2] = {{ModelAxis::plusX, ModelAxis::minusX},
                                                  {ModelAxis::plusY, ModelAxis::minusY},
                                                  {ModelAxis::plusZ, ModelAxis::minusZ}};
        const auto axis = static_cast<int>(*up);
        const bool down = number("UpAxisSign").value_or(1.0) < 0.0;
        axes.up = known[axis][down];
        said +=
            (said.empty() ? "" : ", ") + std::string("UpAxis ") + (down ? "-" : "") + "xyz"[axis];
    }
    if (!said.empty())
        axes.reason = "GlobalSettings of the file: " + said;
    return axes;
}

bool isAxisSetting(std::string_view name) {
    return name == "UpAxis" || name == "UpAxisSign" || name == "UnitScaleFactor";
}

class BinaryFbx {
  public:
    BinaryFbx(const std::string& bytes, const fs::path& file) : bytes_(bytes), file_(file) {}

    DeclaredContents read() {
        version_ = number<std::uint32_t>(23);
        if (version_ < 7100 || version_ > 7700)
            refuse(23, "version " + std::to_string(version_), "7100 to 7700");
        readList(27, bytes_.size(), 0, "");
        DeclaredContents stated;
        stated.axes = axesOf(settings_);
        stated.corners = corners_;
        stated.remarks = records_.remarks();
        return stated;
    }

  private:
    [[noreturn]] void refuse(std::size_t at, std::string value, std::string expected) const {
        throw InputError(
            {file_.string(), "byte " + std::to_string(at), std::move(value), std::move(expected)});
    }
    template <typename Number>
    Number number(std::size_t at) const {
        Number value;
        if (at > bytes_.size() || bytes_.size() - at < sizeof value)
            refuse(bytes_.size(), "the end of the file", "a whole file");
        std::memcpy(&value, bytes_.data() + at, sizeof value);
        return value;
    }
    std::uint64_t length(std::size_t at) const {
        return version_ < 7500 ? number<std::uint32_t>(at) : number<std::uint64_t>(at);
    }

    /// Records one behind the other, each with its end, properties and records in it. A record of
    /// zeros ends a list, the outermost one always.
    void readList(std::size_t begin, std::size_t end, int level, const std::string& above) {
        const std::size_t word = version_ < 7500 ? 4 : 8, head = 3 * word + 1;
        if (level > mostRecordLevels)
            refuse(begin, "records in " + std::to_string(mostRecordLevels) + " others",
                   "fewer levels");
        for (std::size_t at = begin; at < end || level == 0;) {
            const std::uint64_t next = length(at), sizeOfProperties = length(at + 2 * word);
            const auto sizeOfName = number<std::uint8_t>(at + 3 * word);
            if (next == 0)
                return;
            const std::size_t name = at + head;
            if (next > end || next < name + sizeOfName ||
                sizeOfProperties > next - name - sizeOfName)
                refuse(at, "a record to byte " + std::to_string(next),
                       "an end behind it and no later than byte " + std::to_string(end));
            const std::string called = bytes_.substr(name, sizeOfName);
            const std::size_t properties = name + sizeOfName;
            const std::string path = above + "/" + called;
            const std::size_t inner = properties + static_cast<std::size_t>(sizeOfProperties);
            look(path, std::string_view(bytes_).substr(properties, sizeOfProperties));
            if (inner < next)
                readList(inner, static_cast<std::size_t>(next), level + 1, path);
            at = static_cast<std::size_t>(next);
        }
    }

    void look(const std::string& path, std::string_view properties) {
        if (path == "/Objects/Geometry/PolygonVertexIndex" && properties.size() >= 13 &&
            properties[0] == 'i') {
            std::uint32_t count = 0;
            std::memcpy(&count, properties.data() + 1, 4);
            corners_ += count;
        } else if (path == "/GlobalSettings/Properties70/P") {
            lookAtSetting(properties);
        } else if (path == "/Objects/Model/Properties70/P") {
            lookAtModel(properties);
        } else if (path.starts_with("/Objects/Geometry/") && path.rfind('/') == 17) {
            records_.addOfGeometry(std::string_view(path).substr(18));
        } else if (path.starts_with("/Objects/") && path.rfind('/') == 8) {
            lookAtObject(std::string_view(path).substr(9), properties);
        }
    }

    /// Its number, its name and its class.
    void lookAtObject(std::string_view kind, std::string_view properties) {
        if (properties.size() < 9 || properties[0] != 'L')
            return;
        properties.remove_prefix(9);
        takeText(properties);
        if (const auto its = takeText(properties))
            records_.addObject(kind, *its);
    }

    /// Four texts and a number, which is 0 in all bytes where it is 0.
    void lookAtModel(std::string_view properties) {
        const auto name = takeText(properties);
        for (int i = 0; i < 3; ++i)
            takeText(properties);
        if (name && !properties.empty() && properties.find_first_not_of('\0', 1) == properties.npos)
            records_.addZero(*name);
    }

    /// The text that properties begin with, which is taken off them; nothing where none does.
    static std::optional<std::string_view> takeText(std::string_view& properties) {
        std::uint32_t size = 0;
        if (properties.size() < 5 || properties[0] != 'S')
            return std::nullopt;
        std::memcpy(&size, properties.data() + 1, 4);
        if (size > properties.size() - 5)
            return std::nullopt;
        const std::string_view text = properties.substr(5, size);
        properties.remove_prefix(5 + size);
        return text;
    }

    /// Four texts and a number.
    void lookAtSetting(std::string_view properties) {
        const auto first = takeText(properties);
        for (int i = 0; i < 3; ++i)
            takeText(properties);
        if (!first || !isAxisSetting(*first) || properties.empty())
            return;
        const std::string name(*first);
        std::int32_t whole = 0;
        double real = 0.0;
        if (properties[0] == 'I' && properties.size() >= 5) {
            std::memcpy(&whole, properties.data() + 1, sizeof whole);
            settings_[name] = whole;
        } else if (properties[0] == 'D' && properties.size() >= 9) {
            std::memcpy(&real, properties.data() + 1, sizeof real);
            if (std::isfinite(real))
                settings_[name] = real;
        }
    }

    const std::string& bytes_;
    const fs::path& file_;
    std::uint32_t version_ = 0;
    std::uint64_t corners_ = 0;
    Settings settings_;
    FbxRecords records_;
};

/// Records as text: "Name: values {" and so on. Texts in quotation marks have no escapes.
class TextFbx {
  public:
    TextFbx(const std::string& text, const fs::path& file) : text_(text), file_(file) {}

    DeclaredContents read() {
        std::size_t line = 1, lastOpen = 1;
        long open = 0;
        for (std::size_t at = 0; at < text_.size(); ++at) {
            const char c = text_[at];
            if (c == '\n') {
                ++line;
            } else if (c == ';') {
                at = std::min(text_.find('\n', at), text_.size()) - 1;
            } else if (c == '"') {
                const auto end = text_.find('"', at + 1);
                if (end == text_.npos)
                    refuse(line, "the end of the file in a text in quotation marks", "its end");
                line += static_cast<std::size_t>(
                    std::count(text_.begin() + static_cast<std::ptrdiff_t>(at),
                               text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
                at = end;
            } else if (c == '{') {
                ++open;
                lastOpen = line;
            } else if (c == '}' && --open < 0) {
                refuse(line, "a bracket \"}\" that nothing opened", "as many \"{\" before it");
            }
        }
        if (open > 0)
            refuse(lastOpen,
                   "the end of the file before " + std::to_string(open) +
                       " brackets \"{\" are closed",
                   "a whole file");
        // Brackets may be even in what is left of a file, but not without what joins its objects.
        if (text_.find("\nConnections:") == text_.npos)
            refuse(line, "the end of the file", "Connections, which end a model");
        DeclaredContents stated;
        stated.axes = axesOf(settings());
        stated.remarks = fbxRecordsOfText(text_).remarks();
        countCorners(stated);
        return stated;
    }

  private:
    [[noreturn]] void refuse(std::size_t line, std::string value, std::string expected) const {
        throw InputError({file_.string(), "line " + std::to_string(line), std::move(value),
                          std::move(expected)});
    }

    /// P: "UpAxis", "int", "Integer", "",1
    Settings settings() const {
        Settings found;
        const auto begin = text_.find("\nGlobalSettings:");
        for (const char* name : {"UpAxis", "UpAxisSign", "UnitScaleFactor"}) {
            const auto at = text_.find("\"" + std::string(name) + "\"", begin);
            if (begin == text_.npos || at == text_.npos)
                continue;
            const std::string_view rest =
                std::string_view(text_).substr(at, text_.find('\n', at) - at);
            const auto comma = rest.rfind(',');
            if (comma == rest.npos)
                continue;
            std::string_view value = rest.substr(comma + 1);
            while (!value.empty() && std::isspace(static_cast<unsigned char>(value.front())))
                value.remove_prefix(1);
            while (!value.empty() && std::isspace(static_cast<unsigned char>(value.back())))
                value.remove_suffix(1);
            if (const auto number = parseNumber(value))
                found[name] = *number;
        }
        return found;
    }

    /// PolygonVertexIndex: *24 {
    void countCorners(DeclaredContents& stated) const {
        constexpr std::string_view key = "PolygonVertexIndex: *";
        std::uint64_t corners = 0;
        bool any = false;
        for (auto at = text_.find(key); at != text_.npos; at = text_.find(key, at + 1)) {
            std::uint64_t count = 0;
            for (std::size_t i = at + key.size();
                 i < text_.size() && text_[i] >= '0' && text_[i] <= '9' && count < (1ull << 40);
                 ++i)
                count = 10 * count + static_cast<std::uint64_t>(text_[i] - '0');
            corners += count;
            any = true;
        }
        if (any)
            stated.corners = corners;
    }

    const std::string& text_;
    const fs::path& file_;
};

} // namespace

DeclaredContents readFbxFile(const fs::path& place, const fs::path& file) {
    const std::string bytes = readModelBytes(place, file);
    if (bytes.starts_with(magic.substr(0, 18)))
        return BinaryFbx(bytes, file).read();
    if (const auto zero = bytes.find('\0'); zero != bytes.npos)
        throw InputError({file.string(), "byte " + std::to_string(zero), "a zero byte",
                          "a text, or a file that begins with \"Kaydara FBX Binary\""});
    return TextFbx(bytes, file).read();
}

} // namespace irsg
