// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_NETWORKS_BUS_HPP
#define SIMULATOR_NETWORKS_BUS_HPP

#include "hal/host/live/bus.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace counterpoint::simulator
{
class SimulatedBus;

/// A device's connection to a simulated bus, with the interface of a live one.
class SimulatedPort final : public host::LiveBus
{
  public:
    /// @brief `owner` is whose frames it sends.
    SimulatedPort(SimulatedBus& bus, std::size_t owner);
    ~SimulatedPort() override;

    [[nodiscard]] host::SendResult Send(const host::LiveFrame& frame) override;
    [[nodiscard]] bool Receive(host::LiveFrame& frame) override;
    [[nodiscard]] int Descriptor() const override;
    [[nodiscard]] host::BusHealth Health() const override;
    [[nodiscard]] std::string Name() const override;
    [[nodiscard]] bool Restart() override;
    [[nodiscard]] bool HasFrames() const noexcept
    {
        return !received_.empty();
    }

  private:
    friend class SimulatedBus;

    SimulatedBus& bus_;
    std::size_t owner_;
    std::deque<host::LiveFrame> waiting_;
    std::deque<host::LiveFrame> received_;
};

/// One bus in simulated time: one frame at a time, each as long as its bits, of those that wait the lowest identifier
/// first. What was on the bus comes to everybody at its end, to its sender as its own. [SRS_MGR_012]
class SimulatedBus
{
  public:
    explicit SimulatedBus(std::uint32_t bits_per_second);

    /// @brief End of the frame that is on the bus; the greatest number: none is.
    [[nodiscard]] std::uint64_t NextNs() const noexcept;
    /// @brief Time passes to `now_ns`, which is not beyond NextNs.
    void Advance(std::uint64_t now_ns);
    [[nodiscard]] std::uint64_t NowNs() const noexcept
    {
        return now_ns_;
    }
    /// @brief `tell` gets each frame at its end, with its begin and its owner.
    using TellFrame = std::function<void(const host::LiveFrame&, std::uint64_t, std::size_t)>;
    void Listen(TellFrame tell)
    {
        tell_ = std::move(tell);
    }

  private:
    friend class SimulatedPort;

    void Begin();

    std::uint64_t bit_ns_;
    std::uint64_t now_ns_{0U};
    std::uint64_t end_ns_{0U};
    std::uint64_t begin_ns_{0U};
    std::size_t owner_{0U};
    TellFrame tell_;
    bool is_busy_{false};
    host::LiveFrame current_;
    SimulatedPort* sender_{nullptr}; ///< Null: it has left the bus.
    std::vector<SimulatedPort*> ports_;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_NETWORKS_BUS_HPP
