#pragma once

#include <string>

#include "smatcore/tables/SignatureTable.h"

// What libsmat_tables has, which is loaded when one of them is asked for: the libraries behind it
// take longer to start than a command. Each gives the bytes of a file, to be deleted; throws
// irsg::InputError.

extern "C" {
std::string* smatMatTable(const smat::SignatureTable& table);
std::string* smatNetCdfTable(const smat::SignatureTable& table);
}
