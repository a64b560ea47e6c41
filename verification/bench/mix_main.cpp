// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// bench_mix FILE: runs ServiceNode on the simulated bus for its second of SRS_BEN_012, writes what it lives through,
// and says as one JSON document what was on the bus. Exit status: 0, 1 the node was not well, 2 FILE cannot be written.
#include "verification/bench/mix_bus.hpp"

#include <cstdio>
#include <fstream>
#include <memory>
#include <string>

namespace
{
using namespace counterpoint::bench;

constexpr const char* kNames[] = {"SRDO", "TPDO", "SDO", "heartbeat", "SYNC", "other"};

bool WriteFile(const char* const name, const std::vector<std::uint32_t>& words)
{
    std::ofstream file(name, std::ios::binary);
    for (const std::uint32_t word : words)
    {
        const char bytes[] = {static_cast<char>(word >> 24U), static_cast<char>(word >> 16U),
                              static_cast<char>(word >> 8U), static_cast<char>(word)};
        file.write(bytes, 4);
    }
    return static_cast<bool>(file.flush());
}

void Tell(const MixBus& mix)
{
    std::uint64_t all = 0U;
    std::string text = "{\"frames\": {";
    for (std::size_t share = 0U; share < mix.Sums().frames.size(); ++share)
    {
        all += mix.Sums().bits.at(share);
        text += std::string(share == 0U ? "" : ", ") + "\"" + kNames[share] +
                "\": {\"count\": " + std::to_string(mix.Sums().frames.at(share)) +
                ", \"bits\": " + std::to_string(mix.Sums().bits.at(share)) + "}";
    }
    text += "}, \"bits\": " + std::to_string(all) + ", \"sdo_bytes\": " + std::to_string(mix.Transferred()) + "}\n";
    static_cast<void>(std::fputs(text.c_str(), stdout));
}
} // namespace

int main(const int count, const char* const* const arguments)
{
    if (count != 2)
    {
        static_cast<void>(std::fputs("usage: bench_mix FILE\n", stderr));
        return 2;
    }
    const auto mix = std::make_unique<MixBus>();
    const bool is_well = mix->Run();
    if (!WriteFile(arguments[1], mix->Words()))
    {
        static_cast<void>(
            std::fprintf(stderr, "%s: cannot be written, expected a folder that is there\n", arguments[1]));
        return 2;
    }
    Tell(*mix);
    return is_well ? 0 : 1;
}
