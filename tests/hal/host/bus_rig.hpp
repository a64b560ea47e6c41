// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_HAL_HOST_BUS_RIG_HPP
#define TESTS_HAL_HOST_BUS_RIG_HPP

#include "hal/host/virtual/bus.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace counterpoint::host
{

struct Heard
{
    CanFrame frame;
    BusTime at;
};

/// A node that writes down what it hears.
class Listener final : public BusListener
{
  public:
    void OnReceived(const CanFrame& frame, const BusTime at) override
    {
        received.push_back(Heard{frame, at});
    }
    void OnConfirmed(const CanFrame& frame, const BusTime at) override
    {
        confirmed.push_back(Heard{frame, at});
    }
    void OnBusOff(const BusTime at) override
    {
        bus_off.push_back(at);
    }

    std::vector<Heard> received{};
    std::vector<Heard> confirmed{};
    std::vector<BusTime> bus_off{};
};

class Recorder final : public BusObserver
{
  public:
    void OnBusRecord(const BusRecord& record) override
    {
        records.push_back(record);
    }

    std::vector<BusRecord> records{};
};

inline CanFrame MakeFrame(const std::uint32_t identifier, const std::initializer_list<std::uint8_t> bytes)
{
    CanFrame frame{identifier, FrameKind::kData, CanPortId::kFirst, static_cast<std::uint8_t>(bytes.size()), {}};
    std::copy(bytes.begin(), bytes.end(), frame.data);
    return frame;
}

/// Three nodes at 1 Mbit/s: a bit is 1000 ns. The frame of identifier 0 without data has 50 bits, the one of identifier
/// 0 with the byte 00h has 56 (worked out in frame_bits_test.cpp).
struct BusRig
{
    static constexpr BusTime kBit = 1'000;

    explicit BusRig(const std::size_t queue_capacity = 8U)
    {
        for (Listener& listener : listeners)
        {
            static_cast<void>(bus.Attach(listener, NodeSetup{CanPortId::kFirst, queue_capacity}));
        }
    }
    void RunTo(const BusTime until)
    {
        bus.Advance(until, &recorder);
    }

    VirtualBus bus{BitRate::k1M};
    Listener listeners[3]{};
    Recorder recorder{};
};

} // namespace counterpoint::host

#endif
