#include <limits>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/signature/EntryColumns.h"
#include "irsg/signature/EntryPath.h"
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
    Reader(SQLite::Database& file, int version, std::string name)
        : file_(file), version_(version), name_(std::move(name)) {}

    SignatureDatabase run() {
        readAbout();
        readMaterials();
        readSpectra();
        readTemperatures();
        readFactors();
        if (!diagnostics_.empty())
            throw InputError(std::move(diagnostics_));
        return std::move(database_);
    }

  private:
    Rows rows(const std::string& table, const std::string& columns, const std::string& order) {
        return {file_, table, columns, order, diagnostics_, name_};
    }

    /// The value a constructor gives, or its default and a diagnostic at `place`.
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

    /// The rows of entries, with the columns of their fields behind `keys`.
    template <typename Entry>
    Rows entryRows(const std::string& table, const std::string& keys,
                   std::span<const EntryField<Entry>> fields) {
        std::string columns = keys;
        const Entry any;
        forEachColumn(any, fields, version_, [&](const char* column, const auto& /*value*/) {
            columns += ", " + std::string(column);
        });
        return rows(table, columns, keys);
    }

    /// The fields of the entry of a row, from a column on.
    template <typename Entry>
    void readFields(Rows& row, int column, Entry& entry,
                    std::span<const EntryField<Entry>> fields) {
        forEachColumn(entry, fields, version_,
                      [&](const char* /*name*/, auto& value) { read(row, column++, value); });
    }
    void read(Rows& row, int column, std::string& text) { text = row.text(column); }
    void read(Rows& row, int column, double& number) { number = row.number(column); }
    template <typename Choice>
        requires std::is_enum_v<Choice>
    void read(Rows& row, int column, Choice& choice) {
        const std::string name = row.text(column);
        if (const auto known = choiceNamed<Choice>(name))
            choice = *known;
        else
            row.refuse("'" + name + "'", choicesExpected<Choice>());
    }
    /// A number, or NULL where nodes follow.
    void read(Rows& row, int column, Spectrum& spectrum) {
        if (!row.isNull(column))
            spectrum = Spectrum::constant(row.number(column));
    }

    void readAbout() {
        for (Rows row = rows("about", "key, value", "key"); row.next();) {
            const std::string key = row.text(0);
            if (key == "title")
                database_.title = row.text(1);
            else if (key == "notes")
                database_.notes = row.text(1);
            else
                row.refuse("the key '" + key + "'", "'title' or 'notes'");
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
        for (Rows row = entryRows("material", "id", materialFields()); row.next();) {
            const int index = row.integer(0);
            Material& material = database_.materials[index];
            readFields(row, 1, material, materialFields());
            int column = 1;
            forEachColumn(material, materialFields(), version_, [&](const char* name, auto& value) {
                if constexpr (std::is_same_v<decltype(value), Spectrum&>)
                    readNodes(row, column, index, name, nodes, value);
                ++column;
            });
        }
        if (!nodeNames<ReflectanceTable>(materialFields(), version_).empty())
            readReflectance();
    }

    void readReflectance() {
        struct Read {
            bool isBrdf = false;
            std::vector<double> wavelengths_um;
            std::vector<ReflectanceTable::Row> rows;
        };
        std::map<int, Read> tables;
        for (Rows row = rows("material_reflectance",
                             "material, wavelength_um, incidence_deg, reflection_deg, "
                             "azimuth_deg, value",
                             "material, node");
             row.next();) {
            Read& table = tables[row.integer(0)];
            table.isBrdf = table.isBrdf || !row.isNull(3);
            ReflectanceTable::Row one{row.number(2),
                                      table.isBrdf ? row.number(3) : 0.0,
                                      table.isBrdf ? row.number(4) : 0.0,
                                      {}};
            const ReflectanceTable::Row* const last =
                table.rows.empty() ? nullptr : &table.rows.back();
            const bool isNext = last == nullptr || last->incidence_deg != one.incidence_deg ||
                                last->reflection_deg != one.reflection_deg ||
                                last->azimuth_deg != one.azimuth_deg;
            if (table.rows.size() < 2 && !(isNext && last != nullptr))
                table.wavelengths_um.push_back(row.number(1));
            if (isNext)
                table.rows.push_back(std::move(one));
            table.rows.back().values.push_back(row.number(5));
        }
        for (auto& [index, table] : tables) {
            const auto material = database_.materials.find(index);
            if (material == database_.materials.end())
                continue;
            material->second.reflectanceTable =
                guarded<ReflectanceTable>(materialPath(index) + ".reflectanceTable", [&] {
                    return ReflectanceTable(table.isBrdf, std::move(table.wavelengths_um),
                                            std::move(table.rows));
                });
        }
    }

    /// The spectrum as its nodes say it, where it has any.
    void readNodes(Rows& row, int column, int index, const std::string& property,
                   std::map<std::pair<int, std::string>, Nodes>& nodes, Spectrum& spectrum) {
        const auto sampled = nodes.find({index, property});
        if (sampled == nodes.end()) {
            if (row.isNull(column))
                row.number(column);
            return;
        }
        if (!row.isNull(column))
            row.refuse(property + " as a number and as nodes", "one of the two");
        spectrum = guarded<Spectrum>(materialPath(index) + "." + property, [&] {
            return Spectrum(sampled->second.x, sampled->second.y);
        });
    }

    void readSpectra() {
        for (Rows row = entryRows("user_spectrum", "name", spectrumFields()); row.next();) {
            UserSpectrum& spectrum = database_.spectra[row.text(0)];
            spectrum.name = row.text(0);
            readFields(row, 1, spectrum, spectrumFields());
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
        for (Rows row = entryRows("temperature", "id", temperatureFields()); row.next();)
            readFields(row, 1, database_.temperatures[row.integer(0)], temperatureFields());
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
                           nodeNamesExpected(termFields()) + " of a temperature");
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
        if (entry == database_.temperatures.end())
            return nullptr;
        const auto member = memberOfNodes<LookupTable>(termFields(), term);
        return member == nullptr ? nullptr : &(entry->second.terms.*member);
    }

    /// "'time_s', 'power' or 'mach'".
    template <typename Entry>
    std::string nodeNamesExpected(std::span<const EntryField<Entry>> fields) const {
        const std::vector<std::string> names = nodeNames<LookupTable>(fields, version_);
        std::string text;
        for (std::size_t i = 0; i < names.size(); ++i)
            text += (i == 0 ? "'" : i + 1 < names.size() ? ", '" : " or '") + names[i] + "'";
        return text;
    }

    void readFactors() {
        std::map<std::pair<int, int>, std::size_t> places;
        for (Rows row = entryRows("factor", "temperature, position", geometryBuffers());
             row.next();) {
            const int index = row.integer(0);
            ComponentFactors& factors = database_.temperatures[index].factors;
            places[{index, row.integer(1)}] = factors.size();
            readFields(row, 2, factors.emplace_back(), geometryBuffers());
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
            const auto member = memberOfNodes<LookupTable>(geometryBuffers(), axis);
            if (place == places.end() || member == nullptr) {
                row.refuse("axis '" + axis + "'",
                           nodeNamesExpected(geometryBuffers()) + " of a factor");
                continue;
            }
            ComponentFactor& factor = database_.temperatures[key.first].factors[place->second];
            const Nodes& from = nodes[{key, axis}];
            const std::string path = temperaturePath(key.first) + ".factors[" +
                                     std::to_string(place->second) + "]." + axis;
            factor.*member =
                guarded<LookupTable>(path, [&] { return LookupTable(from.x, from.y, loop); });
        }
    }

    SQLite::Database& file_;
    int version_;
    std::string name_;
    std::vector<Diagnostic> diagnostics_;
    SignatureDatabase database_;
};

} // namespace

SignatureDatabase readRows(SQLite::Database& file, int version, const std::string& name) {
    return Reader(file, version, name).run();
}

std::map<std::string, std::string> readHashes(SQLite::Database& file) {
    std::map<std::string, std::string> hashes;
    SQLite::Statement rows(file, "SELECT entry, sha256 FROM content_hash");
    while (rows.executeStep())
        hashes[rows.getColumn(0).getString()] = rows.getColumn(1).getString();
    return hashes;
}

} // namespace irsg
