#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace smat::test {

/// Kinds of faults in the order of docs/formats-walked.md.
std::vector<std::string> walkedKinds();

/// Fails the test where docs/formats-walked.md has no row of this kind, or another number in it;
/// with SMAT_WRITE_TABLES=1 writes the number there.
void expectWalked(const std::string& kind, std::size_t number);

} // namespace smat::test
