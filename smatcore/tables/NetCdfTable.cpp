#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <netcdf.h>
#include <netcdf_mem.h>

#include "irsg/core/Errors.h"
#include "smatcore/tables/TableFormats.h"
#include "smatcore/tables/TableWriters.h"

namespace smat {

namespace {

/// A file that is being written; after the first failure nothing more is.
class NetCdfFile {
  public:
    NetCdfFile() {
        constexpr std::size_t atFirst = 4096; // bytes; it grows
        take(nc_create_mem("table", NC_NETCDF4 | NC_CLOBBER, atFirst, &id_));
        isOpen_ = isWhole_;
        int before = 0;
        if (isOpen_)
            take(nc_set_fill(id_, NC_NOFILL, &before));
    }
    ~NetCdfFile() {
        if (isOpen_)
            nc_abort(id_);
    }
    NetCdfFile(const NetCdfFile&) = delete;
    NetCdfFile& operator=(const NetCdfFile&) = delete;

    int dimension(const std::string& name, std::size_t size) {
        int number = -1;
        take(nc_def_dim(id_, name.c_str(), size, &number));
        return number;
    }
    int variable(const std::string& name, const std::vector<int>& dimensions,
                 const std::string& unit, const std::string& title) {
        int number = -1;
        take(nc_def_var(id_, name.c_str(), NC_DOUBLE, static_cast<int>(dimensions.size()),
                        dimensions.data(), &number));
        text(number, "units", unit.empty() ? "1" : unit);
        text(number, "long_name", title);
        return number;
    }
    void put(int variable, const std::vector<double>& values) {
        take(nc_put_var_double(id_, variable, values.data()));
    }
    void putTexts(const std::string& name, int dimension, const std::vector<std::string>& texts) {
        int number = -1;
        take(nc_def_var(id_, name.c_str(), NC_STRING, 1, &dimension, &number));
        std::vector<const char*> pointers;
        for (const std::string& one : texts)
            pointers.push_back(one.c_str());
        take(nc_put_var_string(id_, number, pointers.data()));
    }
    void text(int variable, const std::string& name, const std::string& value) {
        take(nc_put_att_text(id_, variable, name.c_str(), value.size(), value.data()));
    }
    /// Ends it. Throws InputError where something of it failed.
    std::string bytes() {
        NC_memio memory{};
        if (isOpen_)
            take(nc_close_memio(id_, &memory));
        isOpen_ = false;
        const std::unique_ptr<void, void (*)(void*)> held(memory.memory, std::free);
        if (!isWhole_)
            throw irsg::InputError({"signature table", "",
                                    std::string("netCDF's answer: ") + nc_strerror(failure_),
                                    "a table that it can write, and memory for it"});
        return {static_cast<const char*>(memory.memory), memory.size};
    }

  private:
    void take(int error) {
        if (isWhole_ && error != NC_NOERR) {
            isWhole_ = false;
            failure_ = error;
        }
    }

    int id_ = -1, failure_ = NC_NOERR;
    bool isOpen_ = false, isWhole_ = true;
};

/// In the order of the file: band, the axes that vary, elevation, azimuth or direction.
std::vector<double> arranged(const SignatureTable& table, const TableVariable& variable) {
    std::vector<double> values;
    for (const ResultColumn* column : variable.ofBand)
        for (std::size_t i = 0; i < table.choices(); ++i) {
            const SignatureTable::Choice choice = table.choice(i);
            const auto add = [&](std::size_t direction) {
                values.push_back(column == nullptr ? std::nan("")
                                                   : column->values[table.row(direction, choice)]);
            };
            if (table.isGrid())
                for (std::size_t row = 0; row < table.elevations_deg().size(); ++row)
                    for (std::size_t azimuth = 0; azimuth < table.azimuths_deg().size(); ++azimuth)
                        add(table.direction(row, azimuth));
            else
                for (std::size_t direction = 0; direction < table.directions().size(); ++direction)
                    add(direction);
        }
    return values;
}

void writeInto(NetCdfFile& file, const SignatureTable& table) {
    const TableVariables variables = variablesOf(table);
    const bool hasBands = variables.bands.size() > 1 || !variables.bands.front().empty();
    std::vector<int> dimensions;
    const int band = hasBands ? file.dimension("band", variables.bands.size()) : -1;
    if (hasBands)
        dimensions.push_back(band);
    for (const SignatureTable::Axis& axis : table.axes())
        dimensions.push_back(file.dimension(axis.key, axis.values.size()));
    const std::size_t firstOfDirections = dimensions.size();
    if (table.isGrid()) {
        dimensions.push_back(file.dimension("elevation", table.elevations_deg().size()));
        dimensions.push_back(file.dimension("azimuth", table.azimuths_deg().size()));
    } else {
        dimensions.push_back(file.dimension("direction", table.directions().size()));
    }

    std::vector<double> azimuths = table.azimuths_deg(), elevations = table.elevations_deg();
    if (!table.isGrid()) {
        azimuths.clear();
        elevations.clear();
        for (const SignatureTable::Direction& direction : table.directions()) {
            azimuths.push_back(direction.azimuth_deg);
            elevations.push_back(direction.elevation_deg);
        }
    }
    if (hasBands)
        file.putTexts("band", band, variables.bands);
    for (std::size_t i = 0; i < table.axes().size(); ++i) {
        const SignatureTable::Axis& axis = table.axes()[i];
        const auto quantity = irsg::quantityOfKey(axis.key);
        file.put(file.variable(axis.key, {dimensions[i + (hasBands ? 1 : 0)]}, axis.unit,
                               quantity ? std::string(irsg::info(*quantity).label) : axis.key),
                 axis.values);
    }
    file.put(file.variable("elevation", {dimensions[firstOfDirections]}, "degree",
                           "Elevation of the camera from the target, up"),
             elevations);
    file.put(file.variable("azimuth", {dimensions.back()}, "degree",
                           "Azimuth of the camera from the target's nose, to starboard"),
             azimuths);
    for (const TableVariable& variable : variables.list)
        file.put(file.variable(variable.name, dimensions, variable.unit, variable.title),
                 arranged(table, variable));

    std::map<std::string, std::string> told{{"Conventions", "CF-1.8"},
                                            {"title", "Signature table"}};
    for (const auto& [key, value] : table.table().provenance.entries) {
        std::string& text = told[key];
        text += (text.empty() ? "" : "; ") + value;
    }
    for (const auto& [key, value] : told)
        file.text(NC_GLOBAL, key, value);
}

} // namespace

} // namespace smat

extern "C" std::string* smatNetCdfTable(const smat::SignatureTable& table) {
    smat::NetCdfFile file;
    smat::writeInto(file, table);
    return new std::string(file.bytes());
}
