#include "irsg/signature/SignatureRows.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "irsg/core/ProgramVersion.h"
#include "irsg/signature/EntryColumns.h"
#include "irsg/signature/EntryJson.h"
#include "irsg/signature/Sha256.h"

namespace irsg {

namespace {

struct Table {
    std::string name;
    std::string columns;
};

std::string declarationOf(const char* /*column*/, const std::string& /*text*/) {
    return " TEXT NOT NULL";
}
std::string declarationOf(const char* /*column*/, double /*number*/) {
    return " REAL NOT NULL";
}
/// NULL where it has nodes.
std::string declarationOf(const char* /*column*/, const Spectrum& /*spectrum*/) {
    return " REAL";
}
std::string oneOf(const std::string& column, const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names)
        list += (list.empty() ? "'" : ", '") + name + "'";
    return " TEXT NOT NULL CHECK (" + column + " IN (" + list + "))";
}
template <typename Choice>
    requires std::is_enum_v<Choice>
std::string declarationOf(const char* column, Choice choice) {
    std::vector<std::string> names;
    for (const NamedChoice<Choice>& one : choicesOf(choice))
        names.emplace_back(one.name);
    return oneOf(column, names);
}

/// ", name TEXT NOT NULL, ...": the columns of an entry, behind those of its key.
template <typename Entry>
std::string columnsOf(std::span<const EntryField<Entry>> fields, int version) {
    std::string text;
    Entry entry;
    forEachColumn(entry, fields, version, [&](const char* column, const auto& value) {
        text += ", " + std::string(column) + declarationOf(column, value);
    });
    return text;
}

/// Parents before their children.
std::vector<Table> schemaOf(int version) {
    const std::string term = "term" + oneOf("term", nodeNames<LookupTable>(termFields(), version));
    const std::string axis =
        "axis" + oneOf("axis", nodeNames<LookupTable>(geometryBuffers(), version));
    const std::string property =
        "property" + oneOf("property", nodeNames<Spectrum>(materialFields(), version));
    const std::string loop = "loop INTEGER NOT NULL CHECK (loop IN (0, 1))";
    std::vector<Table> tables = {
        {"about", "key TEXT PRIMARY KEY NOT NULL, value TEXT NOT NULL"},
        // No row of `about`: earlier programs refuse a key that they do not know there.
        {"written_by", "program TEXT NOT NULL"},
        {"temperature", "id INTEGER PRIMARY KEY" + columnsOf(temperatureFields(), version)},
        {"temperature_table",
         "temperature INTEGER NOT NULL REFERENCES temperature(id) ON DELETE CASCADE, " + term +
             ", " + loop + ", PRIMARY KEY (temperature, term)"},
        {"temperature_node",
         "temperature INTEGER NOT NULL, term TEXT NOT NULL, node INTEGER NOT NULL,"
         " x REAL NOT NULL, value_K REAL NOT NULL, PRIMARY KEY (temperature, term, node),"
         " FOREIGN KEY (temperature, term) REFERENCES temperature_table(temperature, term)"
         " ON DELETE CASCADE"},
        {"factor", "temperature INTEGER NOT NULL REFERENCES temperature(id) ON DELETE CASCADE,"
                   " position INTEGER NOT NULL" +
                       columnsOf(geometryBuffers(), version) +
                       ", PRIMARY KEY (temperature, position)"},
        {"factor_table", "temperature INTEGER NOT NULL, position INTEGER NOT NULL, " + axis + ", " +
                             loop +
                             ", PRIMARY KEY (temperature, position, axis),"
                             " FOREIGN KEY (temperature, position)"
                             " REFERENCES factor(temperature, position) ON DELETE CASCADE"},
        {"factor_node", "temperature INTEGER NOT NULL, position INTEGER NOT NULL, axis TEXT NOT "
                        "NULL, node INTEGER NOT NULL, x REAL NOT NULL, factor REAL NOT NULL,"
                        " PRIMARY KEY (temperature, position, axis, node),"
                        " FOREIGN KEY (temperature, position, axis)"
                        " REFERENCES factor_table(temperature, position, axis) ON DELETE CASCADE"},
        {"material", "id INTEGER PRIMARY KEY" + columnsOf(materialFields(), version)},
        {"material_node", "material INTEGER NOT NULL REFERENCES material(id) ON DELETE CASCADE, " +
                              property +
                              ", node INTEGER NOT NULL, wavelength_um REAL NOT NULL,"
                              " value REAL NOT NULL, PRIMARY KEY (material, property, node)"},
        {"user_spectrum", "name TEXT PRIMARY KEY NOT NULL" + columnsOf(spectrumFields(), version)},
        {"user_spectrum_component",
         "spectrum TEXT NOT NULL REFERENCES user_spectrum(name) ON DELETE CASCADE,"
         " position INTEGER NOT NULL, name TEXT NOT NULL, PRIMARY KEY (spectrum, position)"},
        {"user_spectrum_node",
         "spectrum TEXT NOT NULL, position INTEGER NOT NULL, node INTEGER NOT NULL,"
         " wavelength_um REAL NOT NULL, radiance_W_m2_sr_um REAL NOT NULL,"
         " PRIMARY KEY (spectrum, position, node),"
         " FOREIGN KEY (spectrum, position) REFERENCES user_spectrum_component(spectrum, position)"
         " ON DELETE CASCADE"},
        {"content_hash", "entry TEXT PRIMARY KEY NOT NULL, sha256 TEXT NOT NULL"}};
    if (!nodeNames<ReflectanceTable>(materialFields(), version).empty())
        tables.push_back(
            {"material_reflectance",
             "material INTEGER NOT NULL REFERENCES material(id) ON DELETE CASCADE, node INTEGER "
             "NOT NULL, wavelength_um REAL NOT NULL, incidence_deg REAL NOT NULL, reflection_deg "
             "REAL, azimuth_deg REAL, value REAL NOT NULL, PRIMARY KEY (material, node)"});
    return tables;
}

/// One statement, run again and again with other values.
class Insert {
  public:
    Insert(SQLite::Database& file, const std::string& table, const std::string& columns)
        : statement_(file, "INSERT INTO " + table + " (" + columns + ") VALUES (?" +
                               textOf(std::ranges::count(columns, ',')) + ")") {}

    template <typename... Values>
    void operator()(const Values&... values) {
        begin();
        (add(values), ...);
        finish();
    }

    /// The columns one by one.
    void begin() {
        statement_.reset();
        statement_.clearBindings();
        column_ = 0;
    }
    template <typename Value>
    void add(const Value& value) {
        if constexpr (std::is_enum_v<Value>)
            statement_.bind(++column_, nameOf(value));
        else
            statement_.bind(++column_, value);
    }
    /// NULL where it has nodes.
    void add(const Spectrum& spectrum) {
        ++column_;
        if (spectrum.isConstant())
            statement_.bind(column_, spectrum.values().front());
    }
    /// NULL.
    void skip() { ++column_; }
    void finish() { statement_.exec(); }

  private:
    static std::string textOf(std::ptrdiff_t more) {
        std::string text;
        for (std::ptrdiff_t i = 0; i < more; ++i)
            text += ", ?";
        return text;
    }

    SQLite::Statement statement_;
    int column_ = 0;
};

/// Rows of entries: their key, and the columns of their fields.
template <typename Entry>
class EntryInsert {
  public:
    EntryInsert(SQLite::Database& file, const std::string& table, const std::string& key,
                std::span<const EntryField<Entry>> fields, int version)
        : fields_(fields), version_(version), insert_(file, table, key + names()) {}

    template <typename... Keys>
    void operator()(const Entry& entry, const Keys&... keys) {
        insert_.begin();
        (insert_.add(keys), ...);
        forEachColumn(entry, fields_, version_,
                      [&](const char* /*column*/, const auto& value) { insert_.add(value); });
        insert_.finish();
    }

  private:
    std::string names() const {
        std::string text;
        const Entry any;
        forEachColumn(any, fields_, version_, [&](const char* column, const auto& /*value*/) {
            text += ", " + std::string(column);
        });
        return text;
    }

    std::span<const EntryField<Entry>> fields_;
    int version_;
    Insert insert_;
};

int nodeNumber(std::size_t i) {
    return static_cast<int>(i);
}

void writeTemperatures(const SignatureDatabase& database, SQLite::Database& file, int version) {
    EntryInsert row(file, "temperature", "id", temperatureFields(), version);
    Insert table(file, "temperature_table", "temperature, term, loop");
    Insert node(file, "temperature_node", "temperature, term, node, x, value_K");
    EntryInsert factorRow(file, "factor", "temperature, position", geometryBuffers(), version);
    Insert factorTable(file, "factor_table", "temperature, position, axis, loop");
    Insert factorNode(file, "factor_node", "temperature, position, axis, node, x, factor");
    for (const auto& [index, entry] : database.temperatures) {
        row(entry, index);
        forEachField<LookupTable>(
            termFields(), [&, &id = index, &terms = entry.terms](const auto& field, auto member) {
                const LookupTable& values = terms.*member;
                if (!values.empty())
                    table(id, field.column, values.loop() ? 1 : 0);
                for (std::size_t i = 0; i < values.x().size(); ++i)
                    node(id, field.column, nodeNumber(i), values.x()[i], values.y()[i]);
            });
        for (std::size_t position = 0; position < entry.factors.size(); ++position) {
            const ComponentFactor& factor = entry.factors[position];
            const int number = nodeNumber(position);
            factorRow(factor, index, number);
            forEachField<LookupTable>(
                geometryBuffers(), [&, &id = index](const auto& field, auto member) {
                    const LookupTable& values = factor.*member;
                    if (!values.empty())
                        factorTable(id, number, field.column, values.loop() ? 1 : 0);
                    for (std::size_t i = 0; i < values.x().size(); ++i) {
                        factorNode(id, number, field.column, nodeNumber(i), values.x()[i],
                                   values.y()[i]);
                    }
                });
        }
    }
}

/// A row for each value; angles of reflection are those of a BRDF alone.
void writeTable(int index, const ReflectanceTable& table, Insert& insert) {
    int node = 0;
    for (const ReflectanceTable::Row& row : table.rows())
        for (std::size_t w = 0; w < row.values.size(); ++w) {
            insert.begin();
            insert.add(index);
            insert.add(node++);
            insert.add(table.wavelengths_um()[w]);
            insert.add(row.incidence_deg);
            for (const double angle_deg : {row.reflection_deg, row.azimuth_deg})
                table.isBrdf() ? insert.add(angle_deg) : insert.skip();
            insert.add(row.values[w]);
            insert.finish();
        }
}

void writeMaterials(const SignatureDatabase& database, SQLite::Database& file, int version) {
    EntryInsert row(file, "material", "id", materialFields(), version);
    Insert node(file, "material_node", "material, property, node, wavelength_um, value");
    std::optional<Insert> reflectance;
    if (!nodeNames<ReflectanceTable>(materialFields(), version).empty())
        reflectance.emplace(file, "material_reflectance",
                            "material, node, wavelength_um, incidence_deg, reflection_deg, "
                            "azimuth_deg, value");
    for (const auto& [index, material] : database.materials) {
        row(material, index);
        if (reflectance)
            writeTable(index, material.reflectanceTable, *reflectance);
        forEachField<Spectrum>(
            materialFields(), [&, &id = index, &of = material](const auto& field, auto member) {
                const Spectrum& spectrum = of.*member;
                for (std::size_t i = 0; i < spectrum.wavelengths_um().size(); ++i) {
                    node(id, field.column, nodeNumber(i), spectrum.wavelengths_um()[i],
                         spectrum.values()[i]);
                }
            });
    }
}

void writeSpectra(const SignatureDatabase& database, SQLite::Database& file, int version) {
    EntryInsert row(file, "user_spectrum", "name", spectrumFields(), version);
    Insert componentRow(file, "user_spectrum_component", "spectrum, position, name");
    Insert node(file, "user_spectrum_node",
                "spectrum, position, node, wavelength_um, radiance_W_m2_sr_um");
    for (const auto& [name, spectrum] : database.spectra) {
        row(spectrum, name);
        for (std::size_t position = 0; position < spectrum.components.size(); ++position) {
            const SpectrumComponent& component = spectrum.components[position];
            componentRow(name, nodeNumber(position), component.name);
            for (std::size_t i = 0; i < component.radiance.size(); ++i) {
                node(name, nodeNumber(position), nodeNumber(i),
                     component.radiance.wavelengths_um()[i], component.radiance.values()[i]);
            }
        }
    }
}

} // namespace

void resetSchema(SQLite::Database& file, int version) {
    const std::vector<Table> schema = schemaOf(version);
    for (auto table = schema.rbegin(); table != schema.rend(); ++table)
        file.exec("DROP TABLE IF EXISTS " + table->name);
    for (const Table& table : schema)
        file.exec("CREATE TABLE " + table.name + " (" + table.columns + ")");
}

void writeRows(const SignatureDatabase& database, SQLite::Database& file, int version) {
    Insert about(file, "about", "key, value");
    about("title", database.title);
    about("notes", database.notes);
    Insert(file, "written_by", "program")(programWithVersion());
    writeTemperatures(database, file, version);
    writeMaterials(database, file, version);
    writeSpectra(database, file, version);
    Insert hash(file, "content_hash", "entry, sha256");
    for (const auto& [entry, text] : canonicalEntries(database))
        hash(entry, sha256(text));
}

} // namespace irsg
