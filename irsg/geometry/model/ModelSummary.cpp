#include "irsg/geometry/model/ModelSummary.h"

#include <cstdio>
#include <sstream>

#include <osgDB/FileNameUtils>

#include "irsg/geometry/flight/FlightScanner.h"

namespace irsg {
namespace {

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string point(const Vec3& p) {
    return "(" + number(p.x) + ", " + number(p.y) + ", " + number(p.z) + ")";
}

std::string versionText(int version) {
    const std::string digits = std::to_string(version);
    return digits.size() == 4
               ? digits.substr(0, 2) + "." + digits.substr(2, digits[3] == '0' ? 1 : 2)
               : digits;
}

} // namespace

ModelSummary summarizeModel(const std::filesystem::path& file, const ModelOptions& options) {
    const auto model = Model::load(file, options);
    ModelSummary summary;
    summary.file = file;
    summary.format = osgDB::getLowerCaseFileExtension(file.string());
    if (summary.format == "flt") {
        const auto scan = scanFlight(file);
        summary.format = "OpenFlight " + versionText(scan.files.front().version);
        for (std::size_t i = 1; i < scan.files.size(); ++i)
            summary.references.push_back(scan.files[i].path);
    }
    summary.codes = model->codes();
    summary.bounds = model->bounds();
    summary.remarks = model->remarks();
    for (const auto& [codes, use] : summary.codes) {
        summary.faces += use.faces;
        summary.area_m2 += use.area_m2;
    }
    const Mesh& mesh = *model->mesh();
    summary.drawables = static_cast<int>(mesh.parts.size());
    summary.triangles = static_cast<long>(mesh.facets());
    for (const Mesh::Part& part : mesh.parts)
        summary.vertices += static_cast<long>(part.vertices.size());
    return summary;
}

std::string toText(const ModelSummary& summary) {
    std::ostringstream out;
    out << summary.file.string() << ": " << summary.format << "\n"
        << "faces: " << summary.faces << ", drawn as " << summary.triangles << " triangles of "
        << summary.vertices << " vertices in " << summary.drawables << " drawables\n"
        << "area: " << number(summary.area_m2) << " m2\n"
        << "bounds: " << point(summary.bounds.min) << " to " << point(summary.bounds.max)
        << " m (x starboard, y nose, z up)\n";
    for (const auto& path : summary.references)
        out << "refers to: " << path.string() << "\n";
    for (const auto& [codes, use] : summary.codes)
        out << "codes: temperature " << codes.temperature << ", material " << codes.material << ": "
            << use.faces << " faces, " << number(use.area_m2) << " m2\n";
    for (const auto& remark : summary.remarks)
        out << "remark: " << remark << "\n";
    return out.str();
}

} // namespace irsg
