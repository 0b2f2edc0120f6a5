#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "smatcore/tables/SignatureTable.h"

namespace smat {

/// A form of signature tables for other programs, beside .csv and .json.
struct TableFormat {
    const char* extension; ///< ".mat"
    const char* name;      ///< "MATLAB irSignature"
    const char* library;   ///< "matio"
    bool isBuilt;          ///< with that library
    bool gridsAlone;       ///< it takes no other directions
    const char* writer;    ///< of TableWriters.h

    /// The file. Throws InputError for a table that does not fit the form, and where this build, or
    /// this copy of the program, lacks what it needs.
    std::string bytes(const SignatureTable& table) const;
};

const std::vector<const TableFormat*>& tableFormats();
/// Null for the extension of another file.
const TableFormat* tableFormatOf(const std::filesystem::path& file);
/// Throws InputError for another extension, and as TableFormat::bytes does.
void saveTable(const ResultTable& table, const std::filesystem::path& file);

/// Columns that differ in their band alone, as formats with an axis of bands have them.
struct TableVariable {
    std::string name;                          ///< "contrast_intensity", "near_irradiance"
    std::string title;                         ///< "Contrast intensity"
    std::string unit;                          ///< "W sr-1"
    std::vector<const ResultColumn*> ofBand{}; ///< null where a band has none
};
struct TableVariables {
    std::vector<std::string> bands; ///< "3-5um"; one empty text where the table names none
    std::vector<TableVariable> list;
};
TableVariables variablesOf(const SignatureTable& table);

/// What a library writes into a file, by its name, as bytes. Throws InputError where it fails.
std::string bytesWritten(bool (*write)(const std::string& file, const void* of), const void* of);

} // namespace smat
