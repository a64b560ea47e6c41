// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_FAULTS_FRAME_FAULTS_HPP
#define SIMULATOR_FAULTS_FRAME_FAULTS_HPP

#include "simulator/faults/frame_selector.hpp"
#include "simulator/faults/random.hpp"
#include "simulator/journal/journal.hpp"
#include "simulator/scenario/scenario.hpp"

#include "hal/host/virtual/bus.hpp"
#include "hal/host/virtual/bus_fault.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace counterpoint::simulator
{
/// What all faults of frames work with; all outlive them.
struct FaultStage
{
    const Scenario& scenario;
    const host::VirtualBus& bus;
    const BusPlaces& places;
    Journal& journal;
};

/// The faults that act on frames on their way to receivers, and the effects of frames that faults have sent. The
/// selectors are in the order of the scenario. [SRS_SIM_020, SRS_SIM_027]
class FrameFaults final : public host::BusFault
{
  public:
    FrameFaults(const FaultStage& stage, std::vector<FrameSelector> selectors);

    void OnReception(const host::FrameOnBus& sent, host::NodeIndex receiver, host::ReceptionList& receptions) override;
    /// @brief By fault, how many copies of frames were dropped because a frame can have no more receptions.
    /// [SRS_SIM_017]
    [[nodiscard]] const std::map<std::size_t, std::uint32_t>& Dropped() const noexcept
    {
        return dropped_;
    }

  private:
    /// A frame held back until the next one has come (wrong sequence).
    struct Held
    {
        host::NodeIndex receiver{0U};
        CanFrame frame{};
    };

    void TellForeign(const host::FrameOnBus& sent, NodeIndex receiver);
    void ForForeign(const BusPlace& place, const host::FrameOnBus& sent, host::ReceptionList& receptions) const;
    [[nodiscard]] bool Apply(const FrameSelector& selector, host::NodeIndex receiver, host::ReceptionList& receptions);
    void Repeat(const FrameSelector& selector, host::NodeIndex receiver, host::ReceptionList& receptions);
    void Store(const FrameSelector& selector, host::NodeIndex receiver, host::ReceptionList& receptions);
    std::optional<CanFrame> TakeHeld(host::NodeIndex receiver);

    FaultStage stage_;
    EffectTeller teller_;
    Random random_;
    std::vector<FrameSelector> selectors_;
    std::vector<Held> held_;
    std::map<std::pair<std::size_t, host::NodeIndex>, Nanoseconds>
        let_go_; ///< Store and forward: the last frame's time.
    std::map<std::size_t, std::uint32_t> dropped_;
    host::BusTime frame_start_{-1};
};

/// The faults of controllers that act on single frames: frames that are refused, swallowed or destroyed on the wire,
/// and wrong confirmations. [SRS_SIM_027]
class ControllerFaults final : public host::BusFault
{
  public:
    ControllerFaults(const FaultStage& stage, std::vector<FrameSelector> selectors);

    host::SubmitFate OnSubmit(CanFrame& frame, host::NodeIndex sender, host::BusTime now) override;
    host::WireHit OnWire(const host::FrameOnBus& sent) override;
    void OnConfirmation(const host::FrameOnBus& sent, host::ReceptionList& receptions) override;

  private:
    /// When a fault takes hold.
    enum class Moment : std::uint8_t
    {
        kSubmit = 1U,
        kWire = 2U,
        kConfirmation = 3U,
    };
    /// What becomes of a frame that is submitted; of faults of later moments: nothing else.
    struct Hold
    {
        Moment moment;
        host::SubmitFate fate;
    };

    [[nodiscard]] static Hold HoldOf(const FrameSelector& selector);
    /// @brief The first fault of this moment that hits the frame; nullptr: none.
    [[nodiscard]] const FrameSelector* Hit(Moment moment, const CanFrame& frame, host::NodeIndex sender);

    FaultStage stage_;
    EffectTeller teller_;
    Random random_;
    std::vector<FrameSelector> selectors_;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_FAULTS_FRAME_FAULTS_HPP
