#include "smatcore/tables/TableFormats.h"

#include <algorithm>
#include <cctype>
#include <memory>

#include <dlfcn.h>
#include <sys/mman.h>
#include <unistd.h>

#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReplacement.h"
#include "smatcore/data/ColumnName.h"

namespace smat {

const std::vector<const TableFormat*>& tableFormats() {
    static const TableFormat mat{".mat", "MATLAB irSignature", "matio", SMAT_HAS_MATIO,
                                 true,   "smatMatTable"};
    static const TableFormat netCdf{".nc",           "netCDF-4", "netCDF",
                                    SMAT_HAS_NETCDF, false,      "smatNetCdfTable"};
    static const std::vector<const TableFormat*> formats{&mat, &netCdf};
    return formats;
}

const TableFormat* tableFormatOf(const std::filesystem::path& file) {
    const auto found = std::ranges::find_if(tableFormats(), [&](const TableFormat* format) {
        return file.extension() == format->extension;
    });
    return found == tableFormats().end() ? nullptr : *found;
}

std::string TableFormat::bytes(const SignatureTable& table) const {
    if (!isBuilt)
        throw irsg::InputError(
            {"signature table", "", std::string(name) + ", " + extension,
             std::string("a build with ") + library + ", or a file that ends in .csv or .json"});
    if (gridsAlone && !table.isGrid())
        throw irsg::InputError({"signature table", "directions",
                                "directions that are no grid of azimuths and elevations",
                                std::string("table.sampling=grid: ") + extension +
                                    " is a matrix of both; .nc and .csv take an icosphere"});
    void* const loaded = dlopen("libsmat_tables.so", RTLD_NOW | RTLD_LOCAL);
    using Write = std::string* (*)(const SignatureTable&);
    const auto write = loaded == nullptr ? nullptr : reinterpret_cast<Write>(dlsym(loaded, writer));
    if (write == nullptr) {
        const char* why = dlerror();
        throw irsg::InputError(
            {"signature table", "", why == nullptr ? "no writer" : why,
             std::string("libsmat_tables.so beside the program's libraries, and ") + library});
    }
    const std::unique_ptr<std::string> written(write(table));
    return std::move(*written);
}

void saveTable(const ResultTable& table, const std::filesystem::path& file) {
    const TableFormat* format = tableFormatOf(file);
    if (format == nullptr)
        throw irsg::InputError({file.string(), "", file.extension().string(), ".mat or .nc"});
    irsg::editing([&] { irsg::writeFileDurably(file, format->bytes(SignatureTable(table))); },
                  [&](irsg::Diagnostic& one) {
                      if (one.file == "signature table")
                          one.file = file.string();
                  });
}

TableVariables variablesOf(const SignatureTable& table) {
    TableVariables variables;
    for (const ResultColumn* column : table.columns()) {
        const std::string band = ColumnName::of(column->key).band;
        if (std::ranges::find(variables.bands, band) == variables.bands.end())
            variables.bands.push_back(band);
    }
    for (const ResultColumn* column : table.columns()) {
        ColumnName parts = ColumnName::of(column->key);
        const auto band = static_cast<std::size_t>(std::ranges::find(variables.bands, parts.band) -
                                                   variables.bands.begin());
        parts.band.clear();
        std::string name = parts.key();
        for (char& letter : name)
            if (std::isalnum(static_cast<unsigned char>(letter)) == 0)
                letter = '_';
        if (std::isalpha(static_cast<unsigned char>(name.front())) == 0)
            name = "object_" + name;
        auto known = std::ranges::find(variables.list, name, &TableVariable::name);
        // Names that differ in signs alone stay apart.
        const std::string plain = name;
        for (int number = 2; known != variables.list.end() && known->ofBand[band] != nullptr;
             ++number) {
            name = plain + "_" + std::to_string(number);
            known = std::ranges::find(variables.list, name, &TableVariable::name);
        }
        if (known == variables.list.end()) {
            const auto quantity = irsg::quantityOfKey(parts.quantity);
            std::string title =
                quantity ? std::string(irsg::info(*quantity).label) : parts.quantity;
            variables.list.push_back(
                {name, parts.object.empty() ? title : parts.object + ": " + title, column->unit,
                 std::vector<const ResultColumn*>(variables.bands.size())});
            known = variables.list.end() - 1;
        }
        known->ofBand[band] = column;
    }
    return variables;
}

std::string bytesWritten(bool (*write)(const std::string& file, const void* of), const void* of) {
    const int descriptor = memfd_create("table", MFD_CLOEXEC);
    const std::unique_ptr<const int, void (*)(const int*)> closing(
        &descriptor, [](const int* number) { close(*number); });
    if (descriptor < 0 || !write("/proc/self/fd/" + std::to_string(descriptor), of))
        throw irsg::InputError({"", "", "no room in memory for the file", "more memory"});
    std::string bytes(static_cast<std::size_t>(lseek(descriptor, 0, SEEK_END)), '\0');
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t count =
            pread(descriptor, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
        if (count <= 0)
            throw irsg::LogicError("what was written in memory cannot be read back");
        done += static_cast<std::size_t>(count);
    }
    return bytes;
}

} // namespace smat
