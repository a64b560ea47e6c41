// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/protocols/comparator_rig.hpp"

#include "channel_a/channel.hpp"
#include "hal/absent/absent.hpp"
#include "verification/conformance/forwarding.hpp"

namespace counterpoint::protocols
{
namespace
{

constexpr std::uint32_t kCycleUs = 1000U;
constexpr SrdoMask kBit = 1U;
// Places of the input, by Tell of comparator.pml.
constexpr std::size_t kAct = 0U;
constexpr std::size_t kStateA = 1U;
constexpr std::size_t kStateB = 2U;
constexpr std::size_t kFaultA = 3U;
constexpr std::size_t kFaultB = 4U;
constexpr std::size_t kNews = 5U;
constexpr std::size_t kDue = 6U;
constexpr std::size_t kPairs = 7U;
constexpr std::size_t kOverall = 8U;
constexpr std::size_t kDemand = 9U;

constexpr std::int32_t kUnequal = 1; // Of kOverall.
constexpr std::int32_t kStale = 2;
constexpr std::int32_t kOtherOrdinal = 1; // Of kPairs.
constexpr std::int32_t kHoldsNone = 2;
constexpr std::int32_t kOtherData = 3;

constexpr HeldPair kPair{Payload{0x5AU, 0U}, 1U, 1U};

/// What channel B holds where channel A holds kPair.
HeldPair HeldOf(const std::int32_t pairs)
{
    HeldPair held = kPair;
    held.ordinal += (pairs == kOtherOrdinal) ? 1U : 0U;
    held.data.low ^= (pairs == kOtherData) ? 1U : 0U;
    return (pairs == kHoldsNone) ? HeldPair{Payload{}, 1U, 0U} : held;
}

/// A channel that says what it is told to. Nothing but what is overridden is ever called.
class Said final : public conformance::Forwarding
{
  public:
    Said(Channel& inner, const HeldPair& held, SrdoMask& written, const std::uint32_t constant)
        : Forwarding{inner}, held_(held), written_(written), constant_(constant)
    {
    }
    [[nodiscard]] HeldPair Held(SlotIndex) const noexcept override
    {
        return held_;
    }
    void Demote(SlotIndex) noexcept override
    {
        ++demotions;
    }
    [[nodiscard]] SrdoMask Commit(const Agreement& agreement, SrdoMask) noexcept override
    {
        written_ = agreement.agreed & (agreement.matched | written_);
        return 0U;
    }
    [[nodiscard]] Permit Answer(const std::uint32_t challenge) const noexcept override
    {
        return Permit{written_, (challenge + static_cast<std::uint32_t>(written_)) * constant_};
    }

    std::uint32_t demotions{0U};

  private:
    HeldPair held_;
    SrdoMask& written_;
    std::uint32_t constant_;
};

class Output final : public hal::SafetyOutput
{
  public:
    Output(hal::OutputGate& gate, const Instant now) : gate_(gate), now_(now)
    {
    }
    [[nodiscard]] std::uint32_t Challenge() noexcept override
    {
        return gate_.Challenge();
    }
    void Drive(const hal::PermitSet& permits) noexcept override
    {
        gate_.Drive(permits, now_);
    }

  private:
    hal::OutputGate& gate_;
    Instant now_;
};

class NoApplication final : public Application
{
  public:
    void OnSrdoEvent(CommunicationIndex) noexcept override
    {
    }
    void OnSrdoError(CommunicationIndex, SrdoCause) noexcept override
    {
    }
    void OnConfigurationInvalid(CommunicationIndex) noexcept override
    {
    }
    void OnDeviceFault(const DeviceFaultReport&) noexcept override
    {
    }
};

CycleOutcome OutcomeOf(const Numbers& input, const std::size_t state, const std::size_t fault,
                       const std::uint32_t cycle)
{
    constexpr std::int32_t kReleased = 1;
    constexpr std::int32_t kFaulted = 2;
    const auto mask = [](const bool is_set) { return is_set ? kBit : SrdoMask{0U}; };
    CycleOutcome outcome{};
    outcome.released = mask(input[state] == kReleased);
    outcome.faulted = mask(input[state] == kFaulted);
    outcome.new_fault = mask(input[fault] != 0);
    outcome.fresh = mask(input[kNews] != 0);
    outcome.due = mask(input[kDue] == 2);
    outcome.cycle = cycle;
    outcome.ordinal_sum = 1U;
    outcome.guard = GuardView::kConfigured;
    return outcome;
}

} // namespace

void ComparatorRig::Start()
{
    DeviceConfig config{};
    config.srdo_count = 1U;
    config.discrepancy_us = ((defect_ == ComparatorDefect::kLongerLimit) ? 3U : 2U) * kCycleUs;
    config.acknowledge_window_us = 3U * kCycleUs;
    config.cycle_us = kCycleUs;
    config.test_interval_us = 0x40000000U;
    latch_.Arm();
    decision_.Stop();
    decision_.Restart(config);
    written_a_ = 0U;
    written_b_ = 0U;
    gate_.Drive(hal::PermitSet{}, Instant{0U});
    gate_.Drive(hal::PermitSet{}, Instant{0U});
}

Numbers ComparatorRig::Apply(const Numbers& input)
{
    if (input.at(kAct) != 0)
    {
        Start();
        return {1, 0, 0, 0};
    }
    return Cycle(input);
}

Numbers ComparatorRig::Cycle(const Numbers& input)
{
    ++cycle_;
    const Instant now{cycle_ * kCycleUs};
    const bool was_running = latch_.IsRunning();
    CycleOutcome a = OutcomeOf(input, kStateA, kFaultA, cycle_);
    CycleOutcome b = OutcomeOf(input, kStateB, kFaultB, cycle_);
    a.due = (input[kDue] != 0) ? kBit : SrdoMask{0U};
    a.guard = (input[kOverall] == kStale) ? GuardView::kStale : a.guard;
    a.sct_checked = (input[kOverall] == kUnequal) ? 1U : 0U;
    b.ordinal_sum += (input[kPairs] == kOtherOrdinal) ? 1U : 0U;
    b.released |= (defect_ == ComparatorDefect::kOneIsEnough) ? (a.released & ~b.faulted) : SrdoMask{0U};

    channel_a::StorageFor<1U, 2U> storage{};
    channel_a::Channel inner{storage.Handle()};
    Said voice_a{inner, kPair, written_a_, kPermitConstantA};
    Said voice_b{inner, HeldOf(input[kPairs]), written_b_, kPermitConstantB};
    hal::AbsentCanPorts can{};
    hal::AbsentWatchdog watchdog{};
    NoApplication application{};
    Output output{gate_, now};
    KernelContext context{KernelParts{voice_a, voice_b, can, output, watchdog, application}};
    context.latch = latch_;
    if (input[kDemand] != 0)
    {
        context.latch.Demand(DeviceFault::kApplication);
    }
    const std::uint32_t challenge = output.Challenge();
    decision_.Compare(context, Comparison{&a, &b, &voice_a, &voice_b, now, cycle_, challenge, HeldPair{}});
    decision_.Demote(context);
    const SrdoMask received = decision_.Commit(context);
    decision_.GivePermits(context, challenge);
    if ((defect_ == ComparatorDefect::kWayOut) && (decision_.LastVerdict().fault == DeviceFault::kNone))
    {
        context.latch.Arm();
    }
    latch_ = context.latch;
    const bool is_demoted = was_running && (voice_a.demotions == 1U) && (voice_b.demotions == 1U);
    const bool is_open = gate_.Open(now, hal::GateLimit{kCycleUs}) == kBit;
    return {latch_.IsRunning() ? 1 : 0, is_open ? 1 : 0, is_demoted ? 1 : 0, (received != 0U) ? 1 : 0};
}

} // namespace counterpoint::protocols
