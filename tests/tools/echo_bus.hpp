// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_TOOLS_ECHO_BUS_HPP
#define TESTS_TOOLS_ECHO_BUS_HPP

#include "hal/host/live/bus.hpp"

#include <chrono>
#include <cstdint>
#include <deque>
#include <initializer_list>
#include <string>
#include <thread>
#include <vector>

namespace counterpoint::tools::test
{
inline host::LiveFrame FrameOf(const std::uint32_t identifier, const std::initializer_list<std::uint8_t> bytes,
                               const std::uint64_t time_ns)
{
    host::LiveFrame frame;
    frame.identifier = identifier;
    for (const std::uint8_t byte : bytes)
    {
        frame.data[frame.length_bytes] = byte;
        ++frame.length_bytes;
    }
    frame.time_ns = time_ns;
    return frame;
}

/// A bus on which nobody else is. A boot-up message takes `boot_up_ms` to be sent; what was sent comes back at once.
/// Each look at it brings a pair for the actuator if it is the connection of the safety frames.
class EchoBus final : public host::LiveBus
{
  public:
    EchoBus(const bool has_pairs, const std::uint32_t boot_up_ms) : has_pairs_(has_pairs), boot_up_ms_(boot_up_ms)
    {
    }
    host::SendResult Send(const host::LiveFrame& frame) override
    {
        const bool is_boot_up = (frame.identifier & 0x780U) == 0x700U && frame.data[0] == 0U;
        if (is_boot_up)
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(boot_up_ms_));
        }
        sent_.push_back(frame);
        own_.push_back(frame);
        own_.back().own = true;
        return host::SendResult::kSent;
    }
    bool Receive(host::LiveFrame& frame) override
    {
        if (!own_.empty())
        {
            frame = own_.front();
            own_.pop_front();
            return true;
        }
        const std::uint32_t place = place_;
        place_ = (place + 1U) % 3U; // Normal, inverse, none.
        frame = (place == 0U) ? FrameOf(0x103U, {1U, 2U}, host::LiveNow())
                              : FrameOf(0x104U, {0xFEU, 0xFDU}, host::LiveNow());
        return has_pairs_ && place < 2U;
    }
    int Descriptor() const override
    {
        return -1;
    }
    host::BusHealth Health() const override
    {
        host::BusHealth health;
        health.state = host::BusState::kActive;
        return health;
    }
    std::string Name() const override
    {
        return "echo";
    }
    bool Restart() override
    {
        return false;
    }

    /// All frames that were sent, in their order.
    [[nodiscard]] const std::vector<host::LiveFrame>& Sent() const
    {
        return sent_;
    }

  private:
    bool has_pairs_;
    std::uint32_t boot_up_ms_;
    std::uint32_t place_{0U};
    std::deque<host::LiveFrame> own_{};
    std::vector<host::LiveFrame> sent_{};
};

} // namespace counterpoint::tools::test

#endif // TESTS_TOOLS_ECHO_BUS_HPP
