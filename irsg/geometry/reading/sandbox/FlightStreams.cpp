#include "irsg/geometry/reading/sandbox/FlightStreams.h"

namespace irsg {

void putFlightStreams(ByteSink& sink, const std::vector<FlightStream>& streams) {
    sink.putCount(streams.size());
    for (const FlightStream& stream : streams) {
        sink.putText(stream.path.native());
        sink.putText(stream.bytes);
        for (const double coordinate : stream.origin_m)
            sink.put(coordinate);
        sink.putCount(stream.externals.size());
        for (const auto& [written, number] : stream.externals) {
            sink.putText(written);
            sink.put(number);
        }
    }
}

std::vector<FlightStream> getFlightStreams(ByteSource& source) {
    std::vector<FlightStream> streams(source.getCount(48));
    for (FlightStream& stream : streams) {
        stream.path = source.getText();
        stream.bytes = source.getText();
        for (double& coordinate : stream.origin_m)
            coordinate = source.get<double>();
        stream.externals.resize(source.getCount(12));
        for (auto& [written, number] : stream.externals) {
            written = source.getText();
            number = source.getIndex(streams.size());
        }
    }
    if (streams.empty())
        throw DamagedBytes("a model of no files");
    return streams;
}

} // namespace irsg
