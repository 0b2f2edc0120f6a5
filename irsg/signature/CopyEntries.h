#pragma once

#include <map>
#include <string>
#include <vector>

#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// What is copied from one database to another, and what becomes of an index or a name that is
/// taken there already by something else.
struct CopyRequest {
    std::vector<int> temperatures;
    std::vector<int> materials;
    std::vector<std::string> spectra;
    enum class OnConflict {
        refuse,  ///< InputError that lists each
        replace, ///< the entry of the target is lost
        renumber ///< the copy gets the next free index, a spectrum the next free name ("plume 2")
    } onConflict = OnConflict::refuse;
};

/// Where the copies went, by where they came from.
struct CopyResult {
    std::map<int, int> temperatures;
    std::map<int, int> materials;
    std::map<std::string, std::string> spectra;
};

/// Copies entries, with the user-defined spectra that copied temperatures name. What is equal in
/// both already stays where it is. Throws InputError, with `fromName` and `toName` for the files,
/// for entries that are not there and for places that are taken; then `to` is what it was.
CopyResult copyEntries(const SignatureDatabase& from, SignatureDatabase& to,
                       const CopyRequest& request, const std::string& fromName,
                       const std::string& toName);

} // namespace irsg
