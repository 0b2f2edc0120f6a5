#include "irsg/signature/MaterialCsv.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "irsg/core/BoundedValues.h"
#include "irsg/core/ColumnWords.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/Remarks.h"
#include "irsg/core/Utf8.h"
#include "irsg/core/Wording.h"
#include "irsg/signature/CsvAxis.h"
#include "irsg/signature/EntryFields.h"
#include "irsg/signature/Fresnel.h"
#include "irsg/signature/LibraryMaterial.h"
#include "irsg/signature/ReflectanceCsv.h"
#include "irsg/signature/SurfaceModels.h"

namespace irsg {

namespace {

constexpr std::array<const char*, 3> properties = {"emissivity", "transmissivity", "reflectivity"};
constexpr SpectralRange greyAxis{0.3, 30.0};

/// What stands beside them, each by itself: every other spectrum that a material has.
struct Optical {
    std::string name;
    Spectrum Material::*member;
    bool isFraction;
};

const std::vector<Optical>& opticals() {
    static const std::vector<Optical> all = [] {
        std::vector<Optical> made;
        forEachField<Spectrum>(materialFields(), [&](const auto& field, auto member) {
            const std::string column = field.column, own = field.csv;
            if (std::ranges::find(properties, column) == properties.end())
                made.push_back({own.empty() ? column : own, member, field.number.isFraction});
        });
        return made;
    }();
    return all;
}

const Optical* opticalNamed(const std::string& name) {
    const auto found = std::ranges::find(opticals(), name, &Optical::name);
    return found == opticals().end() ? nullptr : &*found;
}

std::string quoted(const std::string& name) {
    return "'" + name + "'";
}

/// Names that a column may have.
std::string columnsExpected() {
    std::vector<std::string> names;
    names.reserve(std::size(properties) + opticals().size());
    for (const char* const property : properties)
        names.push_back(quoted(property));
    for (const Optical& optical : opticals())
        names.push_back(quoted(optical.name));
    return alternatives(names);
}

/// "'n' or 'k'".
std::string indexExpected() {
    std::vector<std::string> names;
    for (const Optical& optical : opticals())
        if (!optical.isFraction)
            names.push_back(quoted(optical.name));
    return alternatives(names);
}

/// What a head of a column means: the name of a property or of another spectrum, and whether it is
/// in percent. Its own text where it means neither, or has a unit.
struct ColumnName {
    std::string name;
    bool isPercent = false;
};
ColumnName columnName(const std::string& head) {
    const ColumnHead meant = columnHead(head);
    const auto means = [&](const std::string& name) { return columnHead(name).name == meant.name; };
    const bool isPercent = meant.unit == "%";
    if (!meant.unit.empty() && !isPercent)
        return {head};
    for (const char* const property : properties)
        if (means(property))
            return {property, isPercent};
    for (const Optical& optical : opticals())
        if (means(optical.name))
            return {optical.name, isPercent};
    return {head, isPercent};
}

/// The column of each property, or none.
using Columns = std::array<std::optional<std::size_t>, 3>;

/// Their heads become the names that we give them, and percent fractions.
Columns columnsOf(const CsvTable& table, CsvColumns& columns,
                  std::vector<Diagnostic>& diagnostics) {
    Columns found;
    for (std::size_t i = 0; i < columns.names.size(); ++i) {
        const ColumnName meant = columnName(columns.names[i].text);
        if (meant.isPercent) {
            remarkOn(table.file(), columns.names[i].text + " is in percent");
            for (double& value : columns.values[i])
                value /= 100.0;
        }
        columns.names[i].text = meant.name;
        const auto property = std::ranges::find(properties, columns.names[i].text);
        if (property != properties.end()) {
            auto& place = found[static_cast<std::size_t>(property - properties.begin())];
            if (place)
                diagnostics.push_back(table.diagnostic(columns.names[i], "each name once"));
            place = i;
        } else if (opticalNamed(columns.names[i].text) == nullptr) {
            diagnostics.push_back(table.diagnostic(columns.names[i], columnsExpected()));
        }
    }
    return found;
}

std::string placeOf(const CsvCell& cell) {
    return "line " + std::to_string(cell.line) + ", column " + std::to_string(cell.column);
}

/// What a value of n or k is not: n is above 0, k at least 0, both at most what any matter has.
std::string indexValueExpected(const std::string& name, double value) {
    constexpr double greatest = 1e4;
    const bool isIndex = name == "n";
    if (value <= greatest && (isIndex ? value > 0.0 : value >= 0.0))
        return "";
    return (isIndex ? "a value above 0, at most " : "a value from 0 to ") + numberText(greatest);
}

/// Fractions a little outside of 0 to 1 become the bound, with a remark.
void checkValues(const CsvTable& table, CsvColumns& columns, std::vector<Diagnostic>& diagnostics) {
    BoundedValues bounds(0.0, 1.0);
    for (std::size_t i = 0; i < columns.names.size(); ++i) {
        const Optical* const optical = opticalNamed(columns.names[i].text);
        const bool isFraction = optical == nullptr || optical->isFraction;
        for (std::size_t k = 0; k < columns.values[i].size(); ++k) {
            const CsvCell& cell = columns.cells[i][k];
            double& value = columns.values[i][k];
            const auto taken = isFraction ? bounds.take(value, placeOf(cell)) : value;
            const std::string expected = isFraction ? "" : indexValueExpected(optical->name, value);
            if (!expected.empty())
                diagnostics.push_back(table.diagnostic(cell, expected));
            else if (!taken)
                diagnostics.push_back(table.diagnostic(
                    cell, value > 1.5 && value <= 100.0 ? "a fraction from 0 to 1, not percent"
                                                        : "a value from 0 to 1"));
            value = taken.value_or(value);
        }
    }
    if (diagnostics.empty())
        bounds.remark(table.file());
}

/// n and k as refractiveindex.info hands them on: a block of rows under `wl,n` and one under
/// `wl,k`, or one under `wl,n,k`, over um.
void readIndexBlocks(const CsvTable& table, Material& material) {
    std::vector<Diagnostic> diagnostics;
    Material read = material;
    std::vector<const Optical*> met;
    const std::vector<CsvRow>& rows = table.rows();
    for (std::size_t first = 0; first < rows.size();) {
        const std::vector<CsvCell>& names = rows[first].cells;
        std::size_t end = first + 1;
        while (end < rows.size() && rows[end].cells.front().text != "wl")
            ++end;
        std::vector<std::vector<double>> columns(names.size());
        for (std::size_t r = first + 1; r < end; ++r) {
            if (rows[r].cells.size() != names.size()) {
                diagnostics.push_back(
                    table.diagnostic(rows[r].line, std::to_string(rows[r].cells.size()) + " cells",
                                     std::to_string(names.size())));
                continue;
            }
            for (std::size_t i = 0; i < names.size(); ++i) {
                const double value = table.number(rows[r].cells[i], diagnostics).value_or(0.0);
                const bool ascends = i > 0 || columns[0].empty() || value > columns[0].back();
                const std::string expected =
                    i > 0 ? indexValueExpected(columnName(names[i].text).name, value)
                    : value > 0.0 && ascends ? ""
                                             : "wavelengths in um that ascend";
                if (!expected.empty())
                    diagnostics.push_back(table.diagnostic(rows[r].cells[i], expected));
                columns[i].push_back(value);
            }
        }
        for (std::size_t i = 1; i < names.size(); ++i) {
            const Optical* const optical = opticalNamed(columnName(names[i].text).name);
            if (optical == nullptr || optical->isFraction)
                diagnostics.push_back(table.diagnostic(names[i], indexExpected()));
            else if (std::ranges::find(met, optical) != met.end())
                diagnostics.push_back(table.diagnostic(names[i], "each of n and k once"));
            else if (columns[0].empty())
                diagnostics.push_back(table.diagnostic(names[i], "rows of numbers under it"));
            else if (diagnostics.empty())
                read.*optical->member =
                    columns[0].size() == 1
                        ? Spectrum::constant(columns[i].front())
                        : Spectrum(columns[0], columns[i], Spectrum::Outside::hold, table.file());
            met.push_back(optical);
        }
        first = end;
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    material = std::move(read);
}

struct Fractions {
    double emissivity = 1.0;
    double transmissivity = 0.0;
};

/// The two that are kept, from those that are given.
Fractions close(const std::array<std::optional<double>, 3>& given) {
    const auto& [emissivity, transmissivity, reflectivity] = given;
    if (emissivity && transmissivity)
        return {*emissivity, *transmissivity};
    if (emissivity)
        return {*emissivity, reflectivity ? 1.0 - *emissivity - *reflectivity : 0.0};
    const double passed = transmissivity.value_or(0.0);
    return {1.0 - passed - reflectivity.value_or(0.0), passed};
}

std::string sumText(const std::array<std::optional<double>, 3>& given) {
    double sum = 0.0;
    std::string names;
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (given[i]) {
            sum += *given[i];
            names += (names.empty() ? "" : " + ") + std::string(properties[i]);
        }
    }
    return names + " = " + numberText(std::round(sum * 1e9) / 1e9);
}

} // namespace

void readMaterialCsv(const std::filesystem::path& file, Material& material) {
    const std::string bytes = readFile(file);
    std::string decoded;
    const std::string_view text = utf8Of(bytes, decoded);
    if (const auto library = readSpectralLibrary(text, file.string())) {
        takeLibrarySpectrum(*library, file.string(), material);
        return;
    }
    const CsvTable table = CsvTable::parse(bytes, file.string());
    table.remark();
    if (!table.rows().empty() && table.rows().front().cells.front().text == "wl") {
        readIndexBlocks(table, material);
        return;
    }
    std::vector<Diagnostic> diagnostics;
    CsvColumns columns = readColumns(table, 2, diagnostics);
    const SpectralAxis axis = readSpectralAxis(table, columns, diagnostics);
    const Columns where = columnsOf(table, columns, diagnostics);
    if (diagnostics.empty()) {
        checkSpectralAxis(table, columns, diagnostics);
        checkValues(table, columns, diagnostics);
    }

    // Row by row, what is given and what follows from it.
    const bool hasFractions =
        std::ranges::any_of(where, [](const auto& one) { return one.has_value(); });
    std::vector<double> emissivity;
    std::vector<double> transmissivity;
    BoundedValues sums(0.0, 1.0 + 1e-9);
    for (std::size_t i = 0; diagnostics.empty() && hasFractions && i < columns.axis.size(); ++i) {
        std::array<std::optional<double>, 3> given;
        for (std::size_t property = 0; property < given.size(); ++property)
            if (where[property])
                given[property] = columns.values[*where[property]][i];
        Fractions closed = close(given);
        double left = 1.0 - closed.emissivity - closed.transmissivity;
        if (const auto sum =
                sums.take(1.0 - left, "line " + std::to_string(columns.axisCells[i].line));
            sum && left < -1e-9 && closed.transmissivity <= 1.0) {
            closed.emissivity = 1.0 - closed.transmissivity;
            left = 0.0;
        }
        const bool impossible =
            left < -1e-9 || closed.emissivity < -1e-9 || closed.transmissivity < -1e-9;
        const bool open =
            given[0] && given[1] && given[2] && std::abs(left - *given[2]) > closureTolerance;
        if (impossible || open) {
            diagnostics.push_back(table.diagnostic(columns.axisCells[i].line, sumText(given),
                                                   open ? "a sum of 1" : "a sum of at most 1"));
        }
        emissivity.push_back(std::max(closed.emissivity, 0.0));
        transmissivity.push_back(std::max(closed.transmissivity, 0.0));
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    sums.remark(table.file());

    std::vector<double> wavelengths_um = wavelengthsOf(columns, axis);
    const bool descends = wavelengths_um.back() < wavelengths_um.front();
    if (descends)
        std::ranges::reverse(wavelengths_um);
    const auto spectrumOf = [&](std::vector<double> values) {
        if (descends)
            std::ranges::reverse(values);
        return Spectrum(wavelengths_um, std::move(values), Spectrum::Outside::hold, table.file());
    };
    for (std::size_t i = 0; i < columns.names.size(); ++i)
        if (const Optical* const optical = opticalNamed(columns.names[i].text))
            material.*optical->member = spectrumOf(columns.values[i]);
    if (!hasFractions)
        return;
    const bool opaque = std::ranges::all_of(transmissivity, [](double t) { return t == 0.0; });
    material.transmissivity = opaque ? Spectrum() : spectrumOf(std::move(transmissivity));
    material.emissivity = spectrumOf(std::move(emissivity));
}

Material importedReflectance(const std::filesystem::path& file, const SignatureDatabase& database,
                             int index, const std::string& name) {
    Material material;
    material.name = file.stem().string();
    if (const auto there = database.materials.find(index); there != database.materials.end())
        material = there->second;
    material.reflectanceTable = readReflectanceTable(file);
    material.surfaceModel = "tabulated";
    if (!name.empty())
        material.name = name;
    // What the table leaves along the normal: it is what is emitted.
    const std::vector<double>& axis_um = material.reflectanceTable.wavelengths_um();
    std::vector<double> values;
    for (const double wavelength_um : axis_um)
        values.push_back(std::clamp(1.0 - material.transmissivity.at(wavelength_um) -
                                        reflectanceOverAngle(material, 1.0, wavelength_um),
                                    0.0, 1.0));
    material.emissivity = values.size() == 1 ? Spectrum::constant(values.front())
                                             : Spectrum(axis_um, std::move(values));
    return material;
}

Material importedMaterial(const std::filesystem::path& file, const SignatureDatabase& database,
                          int index, const std::string& name) {
    Material material;
    material.name = file.stem().string();
    if (const auto there = database.materials.find(index); there != database.materials.end())
        material = there->second;
    const Spectrum before = material.emissivity;
    readMaterialCsv(file, material);
    // Of a black body of whose bulk alone is told: what its flat face does not reflect.
    const std::vector<double>& axis_um = material.refractiveIndex.wavelengths_um();
    if (before == Spectrum::constant(1.0) && material.emissivity == before &&
        material.surfaceModel.empty() && !axis_um.empty()) {
        std::vector<double> values;
        for (const double wavelength_um : axis_um)
            values.push_back(
                std::clamp(1.0 - normalReflectivity(material.refractiveIndex.at(wavelength_um),
                                                    material.extinction.at(wavelength_um)),
                           0.0, 1.0));
        material.emissivity = Spectrum(axis_um, std::move(values));
        remarkOn(file.string(), "the emissivity is that of a flat opaque face along its normal "
                                "(Fresnel), from n and k");
    }
    if (!name.empty())
        material.name = name;
    return material;
}

void writeMaterialCsv(const Material& material, const std::filesystem::path& file) {
    std::vector<const Spectrum*> spectra = {&material.emissivity, &material.transmissivity};
    std::string text = "um,emissivity,transmissivity,reflectivity";
    std::vector<const Spectrum*> beside;
    for (const Optical& optical : opticals())
        if (material.*optical.member != Spectrum()) {
            beside.push_back(&(material.*optical.member));
            text += "," + optical.name;
        }
    text += "\n";
    spectra.insert(spectra.end(), beside.begin(), beside.end());
    std::vector<double> axis_um;
    for (const Spectrum* const spectrum : spectra) {
        axis_um.insert(axis_um.end(), spectrum->wavelengths_um().begin(),
                       spectrum->wavelengths_um().end());
    }
    if (axis_um.empty())
        axis_um = {greyAxis.min_um, greyAxis.max_um};
    std::ranges::sort(axis_um);
    axis_um.erase(std::ranges::unique(axis_um).begin(), axis_um.end());

    for (const double wavelength_um : axis_um) {
        text += numberText(wavelength_um);
        for (const double value :
             {material.emissivity.at(wavelength_um), material.transmissivity.at(wavelength_um),
              std::max(material.reflectivityAt(wavelength_um), 0.0)}) {
            text += "," + numberText(value);
        }
        for (const Spectrum* const spectrum : beside)
            text += "," + numberText(spectrum->at(wavelength_um));
        text += "\n";
    }
    writeFileDurably(file, text);
}

} // namespace irsg
