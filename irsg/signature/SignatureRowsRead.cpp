#include <limits>
#include <utility>
#include <vector>

#include "irsg/radiometry/Errors.h"
#include "irsg/signature/EntryJson.h"
#include "irsg/signature/SignatureRows.h"

namespace irsg {

namespace {

/// The rows of a query, each value asked for with its type. SQLite lets any column hold any type,
/// so a file that others wrote is not to be believed.
class Rows {
  public:
    Rows(SQLite::Database& file, const std::string& table, const std::string& columns,
         const std::string& order, std::vector<Diagnostic>& diagnostics, std::string name)
        : statement_(file, "SELECT " + columns + " FROM " + table + " ORDER BY " + order),
          table_(table),
          diagnostics_(&diagnostics),
          name_(std::move(name)) {}

    bool next() {
        ++row_;
        return statement_.executeStep();
    }

    std::string text(int column) {
        const SQLite::Column value = statement_.getColumn(column);
        return value.isText() ? value.getString() : refuse(column, "text", std::string());
    }
    double number(int column) {
        const SQLite::Column value = statement_.getColumn(column);
        return value.isFloat() || value.isInteger() ? value.getDouble()
                                                    : refuse(column, "a number", 0.0);
    }
    int integer(int column) {
        const SQLite::Column value = statement_.getColumn(column);
        const long long number = value.isInteger() ? value.getInt64() : minimum - 1;
        return number >= minimum && number <= maximum
                   ? static_cast<int>(number)
                   : refuse(column, "a whole number of 32 bits", 0);
    }
    bool isNull(int column) { return statement_.getColumn(column).isNull(); }

    void refuse(const std::string& value, const std::string& expected) {
        diagnostics_->push_back(
            {name_, "table " + table_ + ", row " + std::to_string(row_), value, expected});
    }

  private:
    static constexpr long long minimum = std::numeric_limits<int>::min();
    static constexpr long long maximum = std::numeric_limits<int>::max();

    template <typename Value>
    Value refuse(int column, const std::string& expected, Value otherwise) {
        const SQLite::Column value = statement_.getColumn(column);
        refuse(value.isNull() ? "nothing in " + std::string(value.getName())
                              : std::string(value.getName()) + " = '" + value.getString() + "'",
               expected);
        return otherwise;
    }

    SQLite::Statement statement_;
    std::string table_;
    std::vector<Diagnostic>* diagnostics_;
    std::string name_;
    int row_ = 0;
};

struct Nodes {
    std::vector<double> x;
    std::vector<double> y;
};

class Reader {
  public:
    Reader(SQLite::Database& file, std::string name) : file_(file), name_(std::move(name)) {}

    SignatureDatabase run() {
        readAbout();
        readMaterials();
        readSpectra();
        readTemperatures();
        readFactors();
        if (!diagnostics_.empty()) {
            throw InputError(std::move(diagnostics_));
        }
        return std::move(database_);
    }

  private:
    Rows rows(const std::string& table, const std::string& columns, const std::string& order) {
        return {file_, table, columns, order, diagnostics_, name_};
    }

    /// The value a constructor gives, or its default and an diagnostic at `place`.
    template <typename Value, typename Make>
    Value guarded(const std::string& place, Make make) {
        try {
            return make();
        } catch (const InputError& error) {
            for (const Diagnostic& diagnostic : error.diagnostics()) {
                diagnostics_.push_back({name_, place + ", " + diagnostic.position, diagnostic.value,
                                        diagnostic.expected});
            }
            return {};
        }
    }

    void readAbout() {
        for (Rows row = rows("about", "key, value", "key"); row.next();) {
            const std::string key = row.text(0);
            if (key == "title") {
                database_.title = row.text(1);
            } else if (key == "notes") {
                database_.notes = row.text(1);
            } else {
                row.refuse("the key '" + key + "'", "'title' or 'notes'");
            }
        }
    }

    void readMaterials() {
        std::map<std::pair<int, std::string>, Nodes> nodes;
        for (Rows row = rows("material_node", "material, property, wavelength_um, value",
                             "material, property, node");
             row.next();) {
            Nodes& to = nodes[{row.integer(0), row.text(1)}];
            to.x.push_back(row.number(2));
            to.y.push_back(row.number(3));
        }
        for (Rows row = rows("material",
                             "id, name, emissivity, transmissivity, n_angle_factor, notes", "id");
             row.next();) {
            const int index = row.integer(0);
            Material& material = database_.materials[index];
            material.name = row.text(1);
            material.emissivity = surface(row, 2, index, "emissivity", nodes);
            material.transmissivity = surface(row, 3, index, "transmissivity", nodes);
            material.nAngleFactor = row.number(4);
            material.notes = row.text(5);
        }
    }

    Spectrum surface(Rows& row, int column, int index, const std::string& property,
                     std::map<std::pair<int, std::string>, Nodes>& nodes) {
        const auto sampled = nodes.find({index, property});
        if (sampled == nodes.end()) {
            return Spectrum::constant(row.number(column));
        }
        if (!row.isNull(column)) {
            row.refuse(property + " as a number and as nodes", "one of the two");
        }
        return guarded<Spectrum>(materialPath(index) + "." + property,
                                 [&] { return Spectrum(sampled->second.x, sampled->second.y); });
    }

    void readSpectra() {
        for (Rows row =
                 rows("user_spectrum", "name, reference_distance_m, imported_unit, notes", "name");
             row.next();) {
            UserSpectrum& spectrum = database_.spectra[row.text(0)];
            spectrum = {row.text(0), row.number(1), row.text(2), row.text(3), {}};
        }
        std::map<std::pair<std::string, int>, Nodes> nodes;
        for (Rows row = rows("user_spectrum_node",
                             "spectrum, position, wavelength_um, radiance_W_m2_sr_um",
                             "spectrum, position, node");
             row.next();) {
            Nodes& to = nodes[{row.text(0), row.integer(1)}];
            to.x.push_back(row.number(2));
            to.y.push_back(row.number(3));
        }
        for (Rows row =
                 rows("user_spectrum_component", "spectrum, position, name", "spectrum, position");
             row.next();) {
            const std::string spectrum = row.text(0);
            const Nodes& from = nodes[{spectrum, row.integer(1)}];
            const std::string component = row.text(2);
            database_.spectra[spectrum].components.push_back(
                {component, guarded<Spectrum>(spectrumPath(spectrum) + "." + component, [&] {
                     return Spectrum(from.x, from.y, Spectrum::Outside::zero);
                 })});
        }
    }

    void readTemperatures() {
        for (Rows row = rows("temperature",
                             "id, name, mode, base_K, ambient_factor, recovery_factor,"
                             " ambient_offset_K, user_spectrum, notes",
                             "id");
             row.next();) {
            TemperatureEntry& entry = database_.temperatures[row.integer(0)];
            entry.name = row.text(1);
            const std::string mode = row.text(2);
            if (mode != "temperature" && mode != "userSpectrum") {
                row.refuse("mode '" + mode + "'", "'temperature' or 'userSpectrum'");
            }
            entry.mode =
                mode == "userSpectrum" ? EmissionMode::userSpectrum : EmissionMode::temperature;
            entry.terms.base_K = row.number(3);
            entry.terms.ambientFactor = row.number(4);
            entry.terms.recoveryFactor = row.number(5);
            entry.terms.ambientOffset_K = row.number(6);
            entry.userSpectrum = row.text(7);
            entry.notes = row.text(8);
        }
        std::map<std::pair<int, std::string>, Nodes> nodes;
        for (Rows row = rows("temperature_node", "temperature, term, x, value_K",
                             "temperature, term, node");
             row.next();) {
            Nodes& to = nodes[{row.integer(0), row.text(1)}];
            to.x.push_back(row.number(2));
            to.y.push_back(row.number(3));
        }
        for (Rows row = rows("temperature_table", "temperature, term, loop", "temperature, term");
             row.next();) {
            const int index = row.integer(0);
            const std::string term = row.text(1);
            LookupTable* const to = termTable(index, term);
            if (to == nullptr) {
                row.refuse("term '" + term + "' of temperature " + std::to_string(index),
                           "'time_s', 'power', 'altitude_m' or 'mach' of a temperature");
                continue;
            }
            const bool loop = row.integer(2) != 0;
            const Nodes& from = nodes[{index, term}];
            *to = guarded<LookupTable>(temperaturePath(index) + ".terms." + term,
                                       [&] { return LookupTable(from.x, from.y, loop); });
        }
    }

    LookupTable* termTable(int index, const std::string& term) {
        const auto entry = database_.temperatures.find(index);
        if (entry == database_.temperatures.end()) {
            return nullptr;
        }
        TemperatureTerms& terms = entry->second.terms;
        return term == "time_s"       ? &terms.time
               : term == "power"      ? &terms.power
               : term == "altitude_m" ? &terms.altitude
               : term == "mach"       ? &terms.mach
                                      : nullptr;
    }

    void readFactors() {
        std::map<std::pair<int, int>, std::size_t> places;
        for (Rows row = rows("factor", "temperature, position, component, constant",
                             "temperature, position");
             row.next();) {
            const int index = row.integer(0);
            ComponentFactors& factors = database_.temperatures[index].factors;
            places[{index, row.integer(1)}] = factors.size();
            factors.push_back({row.text(2), row.number(3), {}, {}});
        }
        std::map<std::pair<std::pair<int, int>, std::string>, Nodes> nodes;
        for (Rows row = rows("factor_node", "temperature, position, axis, x, factor",
                             "temperature, position, axis, node");
             row.next();) {
            Nodes& to = nodes[{{row.integer(0), row.integer(1)}, row.text(2)}];
            to.x.push_back(row.number(3));
            to.y.push_back(row.number(4));
        }
        for (Rows row = rows("factor_table", "temperature, position, axis, loop",
                             "temperature, position, axis");
             row.next();) {
            const std::pair key(row.integer(0), row.integer(1));
            const std::string axis = row.text(2);
            const bool loop = row.integer(3) != 0;
            const auto place = places.find(key);
            if (place == places.end() || (axis != "time_s" && axis != "angle_deg")) {
                row.refuse("axis '" + axis + "'", "'time_s' or 'angle_deg' of a factor");
                continue;
            }
            ComponentFactor& factor = database_.temperatures[key.first].factors[place->second];
            const Nodes& from = nodes[{key, axis}];
            const std::string path = temperaturePath(key.first) + ".factors[" +
                                     std::to_string(place->second) + "]." + axis;
            (axis == "time_s" ? factor.time : factor.angle) =
                guarded<LookupTable>(path, [&] { return LookupTable(from.x, from.y, loop); });
        }
    }

    SQLite::Database& file_;
    std::string name_;
    std::vector<Diagnostic> diagnostics_;
    SignatureDatabase database_;
};

} // namespace

SignatureDatabase readRows(SQLite::Database& file, const std::string& name) {
    return Reader(file, name).run();
}

std::map<std::string, std::string> readHashes(SQLite::Database& file) {
    std::map<std::string, std::string> hashes;
    SQLite::Statement rows(file, "SELECT entry, sha256 FROM content_hash");
    while (rows.executeStep()) {
        hashes[rows.getColumn(0).getString()] = rows.getColumn(1).getString();
    }
    return hashes;
}

} // namespace irsg
