// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_SAFETY_CORE_CROSSLINK_PEER_RIG_HPP
#define TESTS_SAFETY_CORE_CROSSLINK_PEER_RIG_HPP

#include "safety_core/crosslink/peer.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace counterpoint
{

/// A channel that says what the test tells it, and keeps what it was told.
class FakeChannel final : public Channel
{
  public:
    void Restart(const DeviceConfig& config) noexcept override
    {
        device = &config;
        ++restarts;
    }
    void Store(const ConfigItem& item) noexcept override
    {
        stored.push_back(item);
    }
    ConfigItem Load(const ConfigAddress& address) const noexcept override
    {
        std::uint32_t value = 0U;
        if ((address.slot < kMaxSrdoCount) && (address.sub == 0U))
        {
            value = (address.field == ConfigField::kCobId1) ? cob_id_1[address.slot] : value;
            value = (address.field == ConfigField::kDirection) ? direction[address.slot] : value;
            value = (address.field == ConfigField::kSrvt) ? srvt_ms[address.slot] : value;
        }
        return ConfigItem{address, value};
    }
    ChannelRoom Room() const noexcept override
    {
        return ChannelRoom{7U, 12U};
    }
    void SetFields(SlotIndex slot, const StaticFields& given) noexcept override
    {
        asked = slot;
        fields = given;
        ++fields_set;
    }
    DeviceDigest Digest(SlotIndex slot, DeviceDigest before) const noexcept override
    {
        return DeviceDigest{before.value + digest_of[slot]};
    }
    CheckResult Validate(SlotIndex slot) noexcept override
    {
        asked = slot;
        return check;
    }
    CheckResult Recheck(SlotIndex slot) noexcept override
    {
        asked = slot;
        return check;
    }
    void OnFrame(const CanFrame& frame, Instant stamp) noexcept override
    {
        heard = {frame, stamp};
        ++frames;
    }
    CycleOutcome OnCycle(const CycleInput& input) noexcept override
    {
        last_input = input;
        return outcome;
    }
    HeldPair Held(SlotIndex slot) const noexcept override
    {
        return held[slot];
    }
    SrdoView View(SlotIndex slot) const noexcept override
    {
        return view[slot];
    }
    void Demote(SlotIndex slot) noexcept override
    {
        demoted.push_back(slot);
    }
    [[nodiscard]] SrdoMask Commit(const Agreement& agreement, SrdoMask examine) noexcept override
    {
        committed = agreement;
        examined = examine;
        return found;
    }
    Permit Answer(std::uint32_t challenge) const noexcept override
    {
        return Permit{3U, challenge};
    }
    PreparedPair Prepare(SlotIndex slot) noexcept override
    {
        asked = slot;
        return prepared;
    }
    Confirmation OnConfirm(const CanFrame& frame, Instant stamp) noexcept override
    {
        heard = {frame, stamp};
        return confirmation;
    }
    /// With the slot in its first byte.
    CanFrame InverseFrame(SlotIndex slot) const noexcept override
    {
        CanFrame frame = prepared.normal;
        frame.data[0] = slot;
        return frame;
    }
    void OnTransmitFault(SlotIndex slot, const TransmitFault& fault) noexcept override
    {
        transmit_faults.emplace_back(slot, fault.cause);
    }

    std::array<std::uint32_t, kMaxSrdoCount> cob_id_1{0x101U, 0x103U, 0U};
    std::array<std::uint32_t, kMaxSrdoCount> direction{2U, 1U, 0U};
    std::array<std::uint32_t, kMaxSrdoCount> srvt_ms{20U, 20U, 20U};
    std::array<std::uint32_t, kMaxSrdoCount> digest_of{1U, 20U, 300U};
    std::array<HeldPair, kMaxSrdoCount> held{};
    std::array<SrdoView, kMaxSrdoCount> view{};
    CycleOutcome outcome{};
    CycleInput last_input{};
    CheckResult check{ConfigFault::kNone, 0x1234U};
    PreparedPair prepared{};
    Confirmation confirmation{kNoSlot, ConfirmStep::kNone};
    Agreement committed{};
    SrdoMask examined{0U};
    SrdoMask found{0U}; ///< What Commit returns.
    const DeviceConfig* device{nullptr};
    SlotIndex asked{kNoSlot}; ///< By the last call that names a slot and keeps nothing else.
    StaticFields fields{};
    std::pair<CanFrame, Instant> heard{};
    std::vector<ConfigItem> stored{};
    std::vector<SlotIndex> demoted{};
    std::vector<std::pair<SlotIndex, SrdoCause>> transmit_faults{};
    int restarts{0};
    int fields_set{0};
    int frames{0};
};

class FakeWatchdog final : public hal::Watchdog
{
  public:
    hal::WatchdogQuestion Question() noexcept override
    {
        return hal::WatchdogQuestion{0x11U};
    }
    void Answer(const hal::WatchdogAnswer& answer) noexcept override
    {
        answered = answer.value;
    }
    std::uint32_t answered{0U};
};

/// A message of a peer that is operational and tells nothing.
inline LinkMessage Silence()
{
    LinkMessage message{};
    message.check.slot = kNoSlot;
    for (SlotReport& report : message.reports)
    {
        report.slot = kNoSlot;
    }
    for (ArmedFrame& armed : message.armed)
    {
        armed.slot = kNoSlot;
    }
    return message;
}

/// One CPU with a fake channel, and the messages of a peer that the test makes up. Slot 0 is a consumer (101h/102h),
/// slot 1 a producer (103h/104h), slot 2 off. Cycle 10 ms, discrepancy 50 ms, diagnosis 100 ms, link time-out 40 ms,
/// clock tolerance 20 ms, interval 400 ms, stamps 0.1 ms. The peer's clock is 1 s ahead of the own one.
class PeerRig
{
  public:
    explicit PeerRig(const PeerRole role)
        : link{role, 40000U, 20000U, 400000U, 100U}, peer{channel, watchdog, link},
          other{(role == PeerRole::kA) ? PeerRole::kB : PeerRole::kA}
    {
        config.srdo_count = 3U;
        config.node_id = 5U;
        config.cycle_us = 10000U;
        config.discrepancy_us = 50000U;
        config.diagnostic_interval_us = 100000U;
        Own().Restart(config);
        Remote().Restart(config);
        channel.outcome.guard = GuardView::kConfigured;
        channel.outcome.sct_checked = 1U;
        channel.outcome.is_tx = 1U;
        channel.outcome.is_invalid = 1U;
        channel.outcome.waiting = 1U;
        for (SlotIndex slot = 0U; slot < 3U; ++slot)
        {
            static_cast<void>(Own().Validate(slot));
        }
        static_cast<void>(peer.Examine(Instant{0U}));
    }

    [[nodiscard]] bool IsA() const
    {
        return link.role == PeerRole::kA;
    }
    [[nodiscard]] Channel& Own()
    {
        return IsA() ? peer.VoiceA() : peer.VoiceB();
    }
    [[nodiscard]] Channel& Remote()
    {
        return IsA() ? peer.VoiceB() : peer.VoiceA();
    }
    /// Both OnCycle as the kernel calls them.
    void Cycle(const std::uint32_t at_us, const NmtState nmt = NmtState::kOperational)
    {
        CycleInput input{};
        input.now = Instant{at_us};
        input.nmt = nmt;
        if (IsA())
        {
            own = Own().OnCycle(input);
            remote = Remote().OnCycle(input);
        }
        else
        {
            remote = Remote().OnCycle(input);
            own = Own().OnCycle(input);
        }
    }
    /// What this CPU tells at `at_us`, after an undisturbed cycle.
    [[nodiscard]] LinkMessage Say(const std::uint32_t at_us)
    {
        const hal::WatchdogQuestion question = peer.Watchdog().Question();
        peer.Watchdog().Answer(hal::WatchdogAnswer{(hal::kFlowReference + question.value) * hal::kWatchdogConstant});
        peer.Compose(PeerMoment{Instant{at_us}, DeviceFault::kNone}, frame);
        EXPECT_EQ(Decode(frame, LinkSender{link.role, 5U}, said), DecodeResult::kIntact);
        return said;
    }
    /// An intact message of the peer, composed at `at_us` of the own clock; it had the last message for 1 ms.
    [[nodiscard]] LinkMessage Word(const std::uint32_t at_us)
    {
        LinkMessage message = Silence();
        message.sender = LinkSender{other, 5U};
        message.fault = DeviceFault::kNone;
        message.sequence = ++sequence;
        message.stamp = Instant{at_us + 1000000U};
        message.echo = LinkEcho{said.sequence, said.stamp, 1000U, kHeard};
        message.flow = hal::kFlowReference;
        message.statement = Statement{GuardView::kConfigured, 1U, 1U, 1U, 0U};
        return message;
    }
    /// Its word 1 ms after our message at `at_us`.
    [[nodiscard]] LinkMessage AnswerTo(const std::uint32_t at_us)
    {
        static_cast<void>(Say(at_us));
        return Word(at_us + 1000U);
    }
    void Hear(const LinkMessage& message, const std::uint32_t at_us)
    {
        Encode(message, frame);
        peer.OnMessage(frame, Instant{at_us});
    }
    /// Such a word, received 1 ms later.
    void Contact(const std::uint32_t at_us)
    {
        Hear(AnswerTo(at_us), at_us + 2000U);
    }
    [[nodiscard]] static CanFrame Frame(const std::uint32_t identifier)
    {
        CanFrame result{};
        result.identifier = identifier;
        result.kind = FrameKind::kData;
        result.port = CanPortId::kFirst;
        result.length_bytes = 1U;
        return result;
    }
    /// The channel completes a pair whose inverse frame is on the bus at `at_us`, and shows it at `cycle_us`.
    void Complete(const std::uint32_t at_us, const std::uint32_t cycle_us, const HeldPair& pair)
    {
        Own().OnFrame(Frame(0x101U), Instant{at_us - 300U});
        Own().OnFrame(Frame(0x102U), Instant{at_us});
        channel.held[0] = pair;
        channel.outcome.fresh = 1U;
        Cycle(cycle_us);
        channel.outcome.fresh = 0U;
    }

    FakeChannel channel{};
    FakeWatchdog watchdog{};
    DeviceConfig config{};
    LinkConfig link;
    Peer peer;
    PeerRole other;
    CycleOutcome own{};
    CycleOutcome remote{};
    LinkMessage said{};
    hal::LinkFrame frame{};
    std::uint32_t sequence{100U};
};

} // namespace counterpoint

#endif
