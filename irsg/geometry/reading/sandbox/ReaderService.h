#pragma once

namespace irsg {

/// Answers questions through a socket until nobody asks any more, with all that shutIn() takes.
void serveReadings(int socket);

} // namespace irsg
