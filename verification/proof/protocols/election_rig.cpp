// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/protocols/election_rig.hpp"

namespace counterpoint::protocols
{
namespace
{

using cia302::FlyingMaster;
using cia302::FlyingService;
using cia302::FlyingState;
using cia302::MasterClaim;
using cia302::NodeId;

// Places and values of the input, and the numbers of frames, by Tell of election.pml.
constexpr std::size_t kAct = 0U;
constexpr std::size_t kDevice = 1U;
constexpr std::size_t kValue = 2U;
constexpr std::size_t kLevel = 3U; ///< Of the first device; that of the second one follows.
constexpr std::int32_t kCycled = 1;
constexpr std::int32_t kHears = 2;
constexpr std::int32_t kPasses = 3;
constexpr std::int32_t kFails = 4;
constexpr std::int32_t kResetFrame = 1;
constexpr std::int32_t kClaimFrame = 2;
constexpr std::int32_t kForceFrame = 5;
constexpr std::int32_t kForeignClaim = 6;
constexpr MasterClaim kForeign{2U, NodeId{9U}};
constexpr std::int32_t kNever = 30000;

/// What is around one flying master; the same for each copy of it.
class Surroundings final : public cia301::FrameSink, public cia302::FlyingMasterListener
{
  public:
    explicit Surroundings(const std::uint8_t node)
        : times{32U, 5U, 0U, 509U, 4U, static_cast<std::uint16_t>(3000U + (100U * node))},
          options(cia302::DefaultFlyingMaster()), setup{NodeId{node}, 0x21U, 0U, 0U, 0U, slaves.data()}
    {
        options.watch_ms = 6000U;
    }
    bool Send(const CanFrame& frame) noexcept override
    {
        constexpr std::uint32_t kFirst = static_cast<std::uint32_t>(FlyingService::kActiveMaster);
        constexpr std::uint32_t kForce = static_cast<std::uint32_t>(FlyingService::kForceNegotiation);
        const bool is_force = frame.identifier == kForce;
        const std::uint32_t number = (frame.identifier == 0U) ? 1U : ((frame.identifier - kFirst) + 2U);
        sent = (sent * 10) + (is_force ? kForceFrame : static_cast<std::int32_t>(number));
        return true;
    }
    void OnFlyingMaster(cia302::FlyingEvent, const MasterClaim&, Instant) noexcept override
    {
    }
    void OnInitialising(const Instant now) noexcept override
    {
        static_cast<void>(acting->Start(now));
    }

    std::array<cia302::SlaveSetup, cia302::kNodeRoom> slaves{};
    cia302::FlyingMasterTimes times;
    cia302::FlyingMasterOptions options;
    cia302::NetworkSetup setup;
    FlyingMaster* acting{nullptr}; ///< The copy that is driven now.
    std::int32_t sent{0};
};

Surroundings& Around(const std::size_t device)
{
    static Surroundings first{1U};
    static Surroundings second{2U};
    return (device == 0U) ? first : second;
}

std::uint8_t NodeOf(const std::size_t device)
{
    return static_cast<std::uint8_t>(device + 1U);
}

CanFrame FrameOf(const std::int32_t number, const MasterClaim& other)
{
    if (number == kResetFrame)
    {
        return CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {130U, 0U}};
    }
    if ((number == kClaimFrame) || (number == kForeignClaim))
    {
        return cia302::ClaimFrame((number == kClaimFrame) ? other : kForeign);
    }
    const auto service = (number == kForceFrame)
                             ? FlyingService::kForceNegotiation
                             : static_cast<FlyingService>(0x6FU + static_cast<std::uint32_t>(number));
    return cia302::ServiceFrame(service);
}

} // namespace

void ElectionRig::Cycle(const std::size_t device)
{
    std::optional<FlyingMaster>& master = masters_[device];
    Surroundings& around = Around(device);
    if (master.has_value())
    {
        master->OnCycle(Now());
        return;
    }
    master.emplace(cia302::FlyingMasterParts{around.setup, around.times, around.options, around, around});
    static_cast<void>(master->Start(Now()));
}

void ElectionRig::Hear(const std::size_t device, const std::int32_t frame, const Numbers& input)
{
    const bool is_deaf = (defect_ == ElectionDefect::kDeafToForce) && (frame == kForceFrame);
    if ((frame == 0) || is_deaf)
    {
        return; // Lost on the way.
    }
    const std::size_t other = 1U - device;
    const MasterClaim claim{static_cast<std::uint8_t>(input[kLevel + other]), NodeId{NodeOf(other)}};
    masters_[device]->OnFrame(FrameOf(frame, claim), Now());
}

bool ElectionRig::IsHeartbeatDue(const std::size_t device) const
{
    const std::optional<FlyingMaster>& master = masters_[device];
    const std::optional<FlyingMaster>& other = masters_[1U - device];
    const bool is_slave = master.has_value() && (master->State() == FlyingState::kSlave);
    return is_slave && (master->Master().node.value == NodeOf(1U - device)) && other.has_value() &&
           other->IsActiveMaster();
}

void ElectionRig::Pass(const std::int32_t ms)
{
    now_ms_ += static_cast<std::uint32_t>(ms);
    for (std::size_t device = 0U; device < masters_.size(); ++device)
    {
        if (IsHeartbeatDue(device))
        {
            const std::uint32_t identifier = 0x700U + NodeOf(1U - device);
            masters_[device]->OnFrame(CanFrame{identifier, FrameKind::kData, CanPortId::kFirst, 1U, {5U}}, Now());
        }
    }
}

std::int32_t ElectionRig::StateOf(const std::size_t device) const
{
    constexpr std::array<FlyingState, 5U> kStates{FlyingState::kDelay, FlyingState::kDetect, FlyingState::kRace,
                                                  FlyingState::kSlave, FlyingState::kMaster};
    constexpr std::int32_t kOff = 0;
    constexpr std::int32_t kOther = 9;
    if (!masters_[device].has_value())
    {
        return kOff;
    }
    for (std::size_t place = 0U; place < kStates.size(); ++place)
    {
        if (kStates[place] == masters_[device]->State())
        {
            return static_cast<std::int32_t>(place + 1U);
        }
    }
    return kOther;
}

std::int32_t ElectionRig::NextOf(const std::size_t device) const
{
    if (!masters_[device].has_value())
    {
        return 0;
    }
    const cia302::FlyingDeadline next = masters_[device]->Next();
    return next.is_set ? (static_cast<std::int32_t>(next.at.us - Now().us) / 1000) : kNever;
}

Numbers ElectionRig::Apply(const Numbers& input)
{
    const auto device = static_cast<std::size_t>(input.at(kDevice));
    for (std::size_t place = 0U; place < masters_.size(); ++place)
    {
        Surroundings& around = Around(place);
        const bool is_wrong = defect_ == ElectionDefect::kWrongPriority;
        around.times.priority = static_cast<std::uint16_t>(is_wrong ? 1 : input.at(kLevel + place));
        around.options.max_restarts = (defect_ == ElectionDefect::kUnbounded) ? 0U : 3U;
        around.acting = masters_[place].has_value() ? &*masters_[place] : nullptr;
        around.sent = 0;
    }
    if (input[kAct] == kCycled)
    {
        Cycle(device);
    }
    else if (input[kAct] == kHears)
    {
        Hear(device, input[kValue], input);
    }
    else if (input[kAct] == kPasses)
    {
        Pass(input[kValue]);
    }
    else if (input[kAct] == kFails)
    {
        masters_[device].reset();
    }
    else
    {
        // Levels and the time to the second power-on are given.
    }
    const auto restarts = [this](const std::size_t place)
    { return masters_[place].has_value() ? std::int32_t{masters_[place]->Restarts()} : 0; };
    return {StateOf(0U), StateOf(1U), restarts(0U), restarts(1U), NextOf(0U), NextOf(1U), Around(device).sent};
}

} // namespace counterpoint::protocols
