// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_SIMULATOR_FRAME_FAULTS_HPP
#define VERIFICATION_SIMULATOR_FRAME_FAULTS_HPP

#include "verification/simulator/journal.hpp"
#include "verification/simulator/random.hpp"
#include "verification/simulator/scenario.hpp"

#include "hal/host/bus_fault.hpp"
#include "hal/host/virtual_bus.hpp"

#include <cstddef>
#include <vector>

namespace counterpoint::simulator
{
/// The bus faults of a scenario that act on frames on their way to receivers: corruption, repetition, wrong sequence,
/// loss, delay, addressing. Nodes of the scenario are the nodes of the bus, in the same order. [SRS-SIM-020]
class FrameFaults final : public host::BusFault
{
  public:
    /// @brief Everything given outlives the object.
    FrameFaults(const Scenario& scenario, const host::VirtualBus& bus, Journal& journal);

    [[nodiscard]] bool IsEmpty() const noexcept;
    void OnReception(const host::FrameOnBus& sent, host::NodeIndex receiver, host::ReceptionList& receptions) override;

  private:
    struct State
    {
        std::size_t index{0U};  ///< In Scenario::faults.
        std::uint32_t seen{0U}; ///< Frames that fit so far.
        std::uint32_t done{0U}; ///< Frames that were hit so far.
        bool is_chosen{false};  ///< The present frame is hit.
    };
    /// A frame held back until the next one has come (wrong sequence).
    struct Held
    {
        host::NodeIndex receiver{0U};
        std::size_t fault{0U};
        CanFrame frame{};
    };

    void Choose(const host::FrameOnBus& sent);
    [[nodiscard]] bool Fits(const FaultSetup& fault, const host::FrameOnBus& sent) const;
    [[nodiscard]] bool Apply(const FaultSetup& fault, std::size_t index, host::NodeIndex receiver,
                             host::ReceptionList& receptions);
    void ReleaseHeld(host::NodeIndex receiver, host::ReceptionList& receptions);
    void Tell(std::size_t index, host::NodeIndex receiver, std::uint32_t identifier, Nanoseconds at);

    const Scenario& scenario_;
    const host::VirtualBus& bus_;
    Journal& journal_;
    Random random_;
    std::vector<State> states_;
    std::vector<std::size_t> masquerades_; ///< Their frames are sent by nodes; here they are only told of.
    std::vector<Held> held_;
    std::vector<std::size_t> told_; ///< Faults whose first effect is in the journal.
    host::BusTime frame_start_{-1};
};
} // namespace counterpoint::simulator

#endif // VERIFICATION_SIMULATOR_FRAME_FAULTS_HPP
