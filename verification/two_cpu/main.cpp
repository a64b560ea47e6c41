// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/two_cpu/device.hpp"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv)
{
    using namespace counterpoint;
    two_cpu::DeviceSetup setup{};
    setup.wire.loss_ppm = 1000U;
    setup.wire.shortest_us = 300U;
    setup.wire.longest_us = 3000U;
    two_cpu::Device device{setup};
    const double seconds = (argc > 1) ? std::atof(argv[1]) : 10.0;
    for (double t = 1.0; t <= seconds; t += seconds / 10.0)
    {
        device.RunUntil(t * 1e6);
        for (int i = 0; i < 2; ++i)
        {
            two_cpu::Cpu& c = *device.cpus[static_cast<std::size_t>(i)];
            const LinkCounts& n = c.peer.Link().Counts();
            std::printf("%9.1f cpu%d open %d fault %d slot %d finding %d taken %u lost %u rep %u old %u late %u "
                        "corrupt %u rx %llu tx %llu cerr %llu perr %llu demo %u\n",
                        t, i, c.IsOpen(device.Now()), (int)c.kernel.DeviceState().fault,
                        (int)c.kernel.DeviceState().slot, (int)c.peer.Link().Finding(), n.taken, n.lost, n.repeated,
                        n.old, n.late, n.corrupt, (unsigned long long)c.application.received,
                        (unsigned long long)c.application.sent, (unsigned long long)c.application.consumer_errors,
                        (unsigned long long)c.application.producer_errors, c.kernel.DemotionCount());
        }
    }
    std::printf("heard %llu bad %llu cycles %llu\n", (unsigned long long)device.pairs_heard,
                (unsigned long long)device.pairs_bad, (unsigned long long)device.cycles);
    return 0;
}
