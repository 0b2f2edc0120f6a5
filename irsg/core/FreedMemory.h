#pragma once

namespace irsg {

/// Has the process keep memory that was freed (up to 512 MiB) for the next allocation. Every case
/// of an analysis takes and frees some hundred spectra of 100 kB and more; handed back to the
/// system each time, their pages are cleared anew, which is a third of the radiometry's time.
/// Called once by a program's main; does nothing where the C library has no such choice.
void keepFreedMemory();

/// Hands back what was kept, as the end of the process would.
void giveBackFreedMemory();

} // namespace irsg
