#include "irsg/signature/ClampedTables.h"

#include "irsg/signature/EntryFields.h"
#include "irsg/signature/EntryPath.h"

namespace irsg {

std::vector<std::string> clampedTables(const SignatureDatabase& database,
                                       const EntityState& state) {
    std::vector<std::string> clamped;
    const auto check = [&](const std::string& path, const auto& part, auto fields) {
        forEachField<LookupTable>(fields, [&](const auto& field, auto member) {
            if ((part.*member).isOutside(field.table.position(state)))
                clamped.push_back(path + "." + field.key);
        });
    };
    for (const auto& [index, entry] : database.temperatures) {
        const std::string path = temperaturePath(index);
        if (entry.mode == EmissionMode::temperature) {
            check(path + ".terms", entry.terms, termFields());
            continue;
        }
        for (std::size_t i = 0; i < entry.factors.size(); ++i)
            if (entry.factors[i].selection == FactorSelection::table)
                check(path + ".factors[" + std::to_string(i) + "]", entry.factors[i],
                      geometryBuffers());
    }
    return clamped;
}

} // namespace irsg
