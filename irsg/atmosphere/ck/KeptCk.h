#pragma once

namespace irsg {

class AtmosphereSmart;
struct CkRequest;

/// True where `prepareCk` need not train, as the terms were kept by a program before, see CkStore.
bool isCkKept(const AtmosphereSmart& air, const CkRequest& request);

} // namespace irsg
