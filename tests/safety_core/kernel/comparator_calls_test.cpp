// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/safety_core/kernel/comparator_test_hooks.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <numeric>
#include <string_view>
#include <vector>

namespace counterpoint
{

ComparatorCalls comparator_calls = ComparatorCalls::kReal;
std::size_t changed_bit = 0U;

namespace
{

Verdict last_verdict{};

/// Two voices as the comparator gets them, to be altered on the way.
struct SeenVoices
{
    CycleOutcome a;
    CycleOutcome b;
    HeldPair turned;
    std::uint32_t cycle;
};

/// A member in which two voices may differ, and a comparator that does not see that.
struct Member
{
    std::string_view name;
    bool (*differs)(const SeenVoices&);
    void (*hide)(SeenVoices&);
};

template <auto kMember> bool Differs(const SeenVoices& voices)
{
    return voices.a.*kMember != voices.b.*kMember;
}
template <auto kMember> void Hide(SeenVoices& voices)
{
    voices.b.*kMember = voices.a.*kMember;
}

constexpr Member kMembers[] = {
    {"sct_checked", Differs<&CycleOutcome::sct_checked>, Hide<&CycleOutcome::sct_checked>},
    {"is_tx", Differs<&CycleOutcome::is_tx>, Hide<&CycleOutcome::is_tx>},
    {"is_invalid", Differs<&CycleOutcome::is_invalid>, Hide<&CycleOutcome::is_invalid>},
    {"not_operational", Differs<&CycleOutcome::not_operational>, Hide<&CycleOutcome::not_operational>},
    {"guard", Differs<&CycleOutcome::guard>, Hide<&CycleOutcome::guard>},
    {"cycle_b", [](const SeenVoices& voices) { return voices.b.cycle != voices.cycle; },
     [](SeenVoices& voices) { voices.b.cycle = voices.cycle; }},
    {"cycle_a", [](const SeenVoices& voices) { return voices.a.cycle != voices.cycle; },
     [](SeenVoices& voices) { voices.a.cycle = voices.cycle; }},
    {"low", [](const SeenVoices& voices) { return voices.turned.data.low != 0U; },
     [](SeenVoices& voices) { voices.turned.data.low = 0U; }},
    {"high", [](const SeenVoices& voices) { return voices.turned.data.high != 0U; },
     [](SeenVoices& voices) { voices.turned.data.high = 0U; }},
    {"faulted", Differs<&CycleOutcome::faulted>, Hide<&CycleOutcome::faulted>},
    {"new_fault", Differs<&CycleOutcome::new_fault>, Hide<&CycleOutcome::new_fault>},
    {"released", Differs<&CycleOutcome::released>, Hide<&CycleOutcome::released>},
    {"due", Differs<&CycleOutcome::due>, Hide<&CycleOutcome::due>},
    {"holds_pair", [](const SeenVoices& voices) { return voices.turned.holds_pair != 0U; },
     [](SeenVoices& voices) { voices.turned.holds_pair = 0U; }},
    {"ordinal", [](const SeenVoices& voices) { return voices.turned.ordinal != 0U; },
     [](SeenVoices& voices) { voices.turned.ordinal = 0U; }},
    {"ordinal_sum", Differs<&CycleOutcome::ordinal_sum>, Hide<&CycleOutcome::ordinal_sum>}};

constexpr std::string_view kFrameMembers[] = {"data0", "data1",  "data2",      "data3", "data4", "data5", "data6",
                                              "data7", "status", "identifier", "kind",  "port",  "length"};

/// The first member in which the frames differ; empty: none.
std::string_view FrameMember(const PreparedPair& a, const PreparedPair& b)
{
    bool differs[std::size(kFrameMembers)]{};
    for (std::size_t byte = 0U; byte < 8U; ++byte)
    {
        differs[byte] = a.normal.data[byte] != b.normal.data[byte];
    }
    differs[8] = a.status != b.status;
    differs[9] = a.normal.identifier != b.normal.identifier;
    differs[10] = a.normal.kind != b.normal.kind;
    differs[11] = a.normal.port != b.normal.port;
    differs[12] = a.normal.length_bytes != b.normal.length_bytes;
    for (std::size_t member = 0U; member < std::size(kFrameMembers); ++member)
    {
        if (differs[member])
        {
            return kFrameMembers[member];
        }
    }
    return {};
}

/// Members that the comparator's own test turned round, in the order of its calls.
struct TurnedMembers
{
    std::vector<std::string_view> voices{};
    std::vector<std::string_view> frames{};
    std::vector<std::uint32_t> words{};       ///< Bits of `low`.
    std::vector<std::uint32_t> sums{};        ///< Bits of the ordinals and of their sum, those that both have.
    std::vector<std::uint32_t> bytes{};       ///< Bits of `sct_checked`.
    std::vector<std::uint32_t> frame_bytes{}; ///< Bits of the length, and of `status`.
    std::vector<std::uint32_t> identifiers{};
    std::vector<SrdoMask> slots{}; ///< Bits of `released`.
};

void Note(std::vector<std::uint32_t>& bits, const std::uint32_t turned)
{
    if (turned != 0U)
    {
        bits.push_back(turned);
    }
}

/// Where they are noted; null: nowhere. A test's own, for memory of one test is nothing for the next.
TurnedMembers* turned_members = nullptr;
/// A member for whose difference the comparator is blind, of voices or frames; empty: none.
std::string_view blind_member{};

/// What the comparison said, as the kernel gets it.
void Spoil(Verdict& verdict)
{
    constexpr SrdoMask kFirstSlot = 1U;
    const auto is_now = [](const ComparatorCalls calls) { return comparator_calls == calls; };
    verdict.fault = is_now(ComparatorCalls::kAlwaysGood) ? DeviceFault::kNone : verdict.fault;
    const bool is_unmatched = is_now(ComparatorCalls::kNeverMatched) || is_now(ComparatorCalls::kDemotesUnmatched);
    verdict.agreement.matched &= is_unmatched ? ~kFirstSlot : ~SrdoMask{0U};
    verdict.agreement.agreed &= is_now(ComparatorCalls::kNeverAgreed) ? ~kFirstSlot : ~SrdoMask{0U};
    verdict.agreement.agreed |= is_now(ComparatorCalls::kAgreedToo) ? kFirstSlot : SrdoMask{0U};
    const bool is_demoted = is_now(ComparatorCalls::kDemotesToo) || is_now(ComparatorCalls::kDemotesUnmatched);
    verdict.demote |= is_demoted ? kFirstSlot : SrdoMask{0U};
    verdict.echo ^= is_now(ComparatorCalls::kEchoChanged) ? 0x100U : 0U;
}

} // namespace

extern "C"
{
    Verdict __real__ZN12counterpoint10Comparator7CompareERKNS_10ComparisonE(Comparator* self,
                                                                            const Comparison& comparison);
    PreparedVerdict
    __real__ZN12counterpoint10Comparator15ComparePreparedERKNS_12PreparedPairES3_(const PreparedPair& a,
                                                                                  const PreparedPair& b);

    Verdict __wrap__ZN12counterpoint10Comparator7CompareERKNS_10ComparisonE(Comparator* self,
                                                                            const Comparison& comparison)
    {
        if (comparator_calls == ComparatorCalls::kNotCalled)
        {
            return Verdict{};
        }
        if (comparator_calls == ComparatorCalls::kFrozen)
        {
            return last_verdict;
        }
        SeenVoices voices{*comparison.outcome_a, *comparison.outcome_b, comparison.turned, comparison.cycle};
        const bool is_noted = (turned_members != nullptr) && (comparison.channel_a == comparison.channel_b);
        if (is_noted)
        {
            Note(turned_members->words, voices.turned.data.low);
            Note(turned_members->sums, voices.turned.ordinal & (voices.a.ordinal_sum ^ voices.b.ordinal_sum));
            Note(turned_members->bytes, std::uint32_t{voices.a.sct_checked} ^ voices.b.sct_checked);
            if (voices.a.released != voices.b.released)
            {
                turned_members->slots.push_back(voices.a.released ^ voices.b.released);
            }
        }
        for (const Member& member : kMembers)
        {
            if (is_noted && member.differs(voices))
            {
                turned_members->voices.push_back(member.name);
            }
            if (blind_member == member.name)
            {
                member.hide(voices);
            }
        }
        Comparison seen = comparison;
        seen.outcome_a = &voices.a;
        seen.outcome_b = &voices.b;
        seen.turned = voices.turned;
        last_verdict = __real__ZN12counterpoint10Comparator7CompareERKNS_10ComparisonE(self, seen);
        Spoil(last_verdict);
        return last_verdict;
    }

    PreparedVerdict __wrap__ZN12counterpoint10Comparator15ComparePreparedERKNS_12PreparedPairES3_(const PreparedPair& a,
                                                                                                  const PreparedPair& b)
    {
        if (comparator_calls == ComparatorCalls::kFrameChanged)
        {
            PreparedPair changed = a;
            auto* const bytes = reinterpret_cast<unsigned char*>(&changed);
            bytes[changed_bit / 8U] = static_cast<unsigned char>(bytes[changed_bit / 8U] ^ (1U << (changed_bit % 8U)));
            return __real__ZN12counterpoint10Comparator15ComparePreparedERKNS_12PreparedPairES3_(changed, b);
        }
        const PreparedVerdict verdict =
            __real__ZN12counterpoint10Comparator15ComparePreparedERKNS_12PreparedPairES3_(a, b);
        const std::string_view member = FrameMember(a, b);
        if ((turned_members != nullptr) && (a.status == PrepareStatus::kInvalid))
        {
            turned_members->frames.push_back(member);
            Note(turned_members->identifiers, b.normal.identifier);
            Note(turned_members->frame_bytes, static_cast<std::uint32_t>(b.status));
        }
        const bool is_blind = (!member.empty()) && (blind_member == member);
        const bool is_unseen = (comparator_calls == ComparatorCalls::kDataUnseen) || is_blind;
        return is_unseen ? PreparedVerdict::kEqual : verdict;
    }
}

namespace
{

/// Released; test interval 67.5 ms: a round of 15 cycles of 1.5 ms at most begins 45 ms after the one before; the
/// comparator's calls go back to the real ones at the end.
class ComparatorLost : public Rig
{
  public:
    ComparatorLost()
    {
        config.test_interval_us = 67500U;
    }
    ~ComparatorLost() override
    {
        comparator_calls = ComparatorCalls::kReal;
        turned_members = nullptr;
        blind_member = {};
    }

    /// A cycle as late as it may be, with a good pair before it.
    void LateCycle()
    {
        application.events.clear(); // Memory is given back behind a test alone.
        application.errors.clear();
        application.flow.clear();
        application.refreshed.clear();
        application.faults.clear();
        ports.sent.clear();
        now_us += 1300U;
        ReceivePair();
        kernel.Cycle(CycleCall{InstantPair{{now_us}, {now_us}}, 0U, 0U});
    }
    /// Operates anew with late cycles, blind for one member after so many of them: until this is found.
    std::uint32_t TimeToFindUs(const std::string_view member, const std::uint32_t phase)
    {
        blind_member = {};
        Operate();
        for (std::uint32_t cycle = 0U; cycle < phase; ++cycle)
        {
            LateCycle();
        }
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone) << member << phase;
        blind_member = member;
        const std::uint32_t from_us = now_us;
        while ((kernel.DeviceState().fault == DeviceFault::kNone) && ((now_us - from_us) < 100000U))
        {
            LateCycle();
        }
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kComparator) << member << phase;
        return now_us - from_us;
    }

    /// Cycles until the output is closed, with a good pair every 10 ms so that nothing else closes it.
    std::uint32_t CyclesToSafe(const ComparatorCalls calls)
    {
        Operate();
        ReceivePair();
        Cycle();
        EXPECT_EQ(Open(), 1U);
        EXPECT_TRUE(WatchdogAlive());
        comparator_calls = calls;
        std::uint32_t cycles = 0U;
        while ((Open() != 0U) && (cycles < 100U))
        {
            if ((cycles % 10U) == 0U)
            {
                ReceivePair();
            }
            Cycle();
            ++cycles;
        }
        return cycles;
    }
};

TEST_F(ComparatorLost, NotCalledIsSafeInTheSameCycle)
{
    Verifies(req::SRS_CMP_001);
    EXPECT_EQ(CyclesToSafe(ComparatorCalls::kNotCalled), 1U);
    EXPECT_NE(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(ComparatorLost, FrozenAtItsLastVerdictIsSafeInTheSameCycle)
{
    Verifies(req::SRS_CMP_001);
    EXPECT_EQ(CyclesToSafe(ComparatorCalls::kFrozen), 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kComparator);
    EXPECT_EQ(kernel.DeviceState().slot, kNoSlot);
    EXPECT_FALSE(WatchdogAlive()); // The flow signature has the echo in it.
}

// t ms  0                1
//       1234h released   1234h again, and a verdict on another challenge: nothing of it is written
TEST_F(ComparatorLost, VerdictOnAnotherChallengeReleasesNothing)
{
    Verifies(req::SRS_CMP_001);
    Operate();
    ReceivePair();
    Cycle();
    ASSERT_EQ(NormalOut(), 0x3412U);
    ReceivePair();
    comparator_calls = ComparatorCalls::kEchoChanged;
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(NormalOut(), 0x7F01U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kComparator);
    EXPECT_EQ(kernel.DeviceState().slot, kNoSlot);
}

// The outcome of a comparison that is not stored, or a bit of it that is stuck: pairs come, and none would be written.
TEST_F(ComparatorLost, VerdictThatIsNotWhatTheDifferencesSayIsSafeInTheSameCycle)
{
    Verifies(req::SRS_CMP_011);
    EXPECT_EQ(CyclesToSafe(ComparatorCalls::kNeverMatched), 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kComparator);
    EXPECT_EQ(kernel.DeviceState().slot, kNoSlot);
    EXPECT_EQ(kernel.DeviceState().count, 1U);
}

// A bit of the verdict that is wrong for this cycle: channels and kernel would close alike, and open again in the next.
TEST_F(ComparatorLost, AgreedReleaseThatTheVerdictLosesIsSafeInTheSameCycle)
{
    Verifies(req::SRS_CMP_360);
    EXPECT_EQ(CyclesToSafe(ComparatorCalls::kNeverAgreed), 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kComparator);
    EXPECT_EQ(kernel.DeviceState().slot, kNoSlot);
    EXPECT_EQ(kernel.DeviceState().count, 1U);
}

TEST_F(ComparatorLost, AgreedSlotThatTheVerdictDemotesIsSafeInTheSameCycle)
{
    Verifies(req::SRS_CMP_361);
    EXPECT_EQ(CyclesToSafe(ComparatorCalls::kDemotesToo), 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kComparator);
    EXPECT_EQ(kernel.DeviceState().slot, kNoSlot);
    EXPECT_EQ(kernel.DeviceState().count, 1U);
}

// Two bits that are wrong do not make a right one.
TEST_F(ComparatorLost, AgreedSlotThatTheVerdictDemotesAndCallsUnmatchedIsSafeInTheSameCycle)
{
    Verifies(req::SRS_CMP_361);
    EXPECT_EQ(CyclesToSafe(ComparatorCalls::kDemotesUnmatched), 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kComparator);
    EXPECT_EQ(kernel.DeviceState().slot, kNoSlot);
    EXPECT_EQ(kernel.DeviceState().count, 1U);
}

// The channels differ, the comparator demotes the slot, and a bit of the verdict calls it agreed all the same.
TEST_F(ComparatorLost, DemotedSlotThatTheVerdictCallsAgreedIsSafeInTheSameCycle)
{
    Verifies(req::SRS_CMP_360);
    Verifies(req::SRS_CMP_361);
    Operate();
    ReceivePair();
    Cycle();
    EXPECT_EQ(Open(), 1U);
    b.on_outcome = [](CycleOutcome& outcome) { outcome.released = 0U; };
    comparator_calls = ComparatorCalls::kAgreedToo;
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kComparator);
    EXPECT_EQ(kernel.DeviceState().slot, kNoSlot);
}

// What both voices must say in every cycle fails: that alone is told, and counted once.
TEST_F(ComparatorLost, GuardThatOneChannelCallsStaleOverAnOpenOutputIsOneFault)
{
    Verifies(req::SRS_CMP_360);
    Operate();
    ReceivePair();
    Cycle();
    EXPECT_EQ(Open(), 1U);
    b.on_outcome = [](CycleOutcome& outcome) { outcome.guard = GuardView::kStale; };
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kGuard);
    EXPECT_EQ(kernel.DeviceState().count, 1U);
}

// A wrong bit in each member of what is composed: identifier, kind, controller, length, data, status.
TEST_F(ComparatorLost, GfcThatIsNotComposedAsItHasToBeDoesNotLeave)
{
    Verifies(req::SRS_KRN_042);
    constexpr std::size_t kComposed[] = {
        offsetof(PreparedPair, normal.identifier), offsetof(PreparedPair, normal.kind),
        offsetof(PreparedPair, normal.port),       offsetof(PreparedPair, normal.length_bytes),
        offsetof(PreparedPair, normal.data),       offsetof(PreparedPair, status)};
    for (const CanPortId port : {CanPortId::kFirst, CanPortId::kSecond})
    {
        config.normal_port = port;
        for (const std::size_t member : kComposed)
        {
            comparator_calls = ComparatorCalls::kReal;
            Operate();
            comparator_calls = ComparatorCalls::kFrameChanged;
            changed_bit = member * 8U;
            ports.sent.clear();
            EXPECT_EQ(kernel.SendGfc(), Result::kDeviceFault) << member;
            EXPECT_TRUE(ports.sent.empty());
            EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kDisagreement);
            EXPECT_EQ(kernel.DeviceState().slot, kNoSlot);
        }
    }
}

TEST_F(ComparatorLost, EveryMemberIsTurnedRoundWithinOneTestIntervalAnotherEachTime)
{
    Verifies(req::SRS_CMP_009);
    Operate();
    // A round ends with the first interval; the next one 30 cycles later
    for (const int cycles : {45, 30})
    {
        TurnedMembers turned{};
        turned_members = &turned;
        for (int cycle = 0; cycle < cycles; ++cycle)
        {
            LateCycle();
        }
        turned_members = nullptr;
        // The ordinals differ together with their sum; length is done three times.
        constexpr std::string_view kVoices[] = {
            "sct_checked", "is_tx",   "is_invalid", "not_operational", "guard", "cycle_b",    "cycle_a", "low",
            "high",        "faulted", "new_fault",  "released",        "due",   "holds_pair", "ordinal", "ordinal_sum"};
        EXPECT_TRUE(std::equal(turned.voices.begin(), turned.voices.end(), std::begin(kVoices), std::end(kVoices)));
        constexpr std::string_view kFrames[] = {"data0", "data1", "data2",  "data3",  "data4",
                                                "data5", "data6", "data7",  "status", "identifier",
                                                "kind",  "port",  "length", "length", "length"};
        EXPECT_TRUE(std::equal(turned.frames.begin(), turned.frames.end(), std::begin(kFrames), std::end(kFrames)));
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    }
}

// Rounds behind each other: 15 cycles each; three SRDOs.
TEST_F(ComparatorLost, EveryBitIsTurnedRoundWithinThirtyTwoRoundsEveryByteWithinFourAndEverySlot)
{
    Verifies(req::SRS_CMP_012);
    config.test_interval_us = 22500U;
    TurnedMembers turned{};
    turned_members = &turned;
    Operate();
    turned = TurnedMembers{};
    for (int cycle = 0; cycle < (64 * 15); ++cycle)
    {
        LateCycle();
    }
    turned_members = nullptr;
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    for (const std::vector<std::uint32_t>* const words : {&turned.words, &turned.sums, &turned.identifiers})
    {
        ASSERT_EQ(words->size(), 64U);
        for (std::size_t round = 0U; round < 32U; ++round)
        {
            std::uint32_t bytes = 0U;
            std::uint32_t bits = 0U;
            for (std::size_t next = 0U; next < 32U; ++next)
            {
                const std::uint32_t word = (*words)[round + next];
                bits |= word;
                for (std::uint32_t byte = 0U; (next < 4U) && (byte < 4U); ++byte)
                {
                    bytes |= ((word & (0xFFU << (8U * byte))) != 0U) ? (1U << byte) : 0U;
                }
            }
            EXPECT_EQ(bytes, 0xFU) << round;
            EXPECT_EQ(bits, 0xFFFFFFFFU) << round;
        }
    }
    for (const std::vector<std::uint32_t>* const bytes : {&turned.bytes, &turned.frame_bytes})
    {
        ASSERT_EQ(bytes->size(), 64U);
        for (std::size_t round = 0U; round < 56U; ++round)
        {
            EXPECT_EQ(std::accumulate(bytes->begin() + static_cast<std::ptrdiff_t>(round),
                                      bytes->begin() + static_cast<std::ptrdiff_t>(round + 8U), 0U, std::bit_or<>{}),
                      0xFFU);
        }
    }
    ASSERT_EQ(turned.slots.size(), 64U);
    for (std::size_t round = 0U; round < 64U; ++round)
    {
        EXPECT_EQ(turned.slots[round], SrdoMask{1U} << (round % 3U)) << round;
    }
    // The first round has the number 1; its first member was turned round before
    constexpr std::uint32_t kWords[] = {0x00000100U, 0x00010000U, 0x01000000U, 0x00000002U, 0x00000200U};
    EXPECT_TRUE(std::equal(std::begin(kWords), std::end(kWords), turned.words.begin()));
    constexpr std::uint32_t kBytes[] = {0x04U, 0x08U, 0x10U, 0x20U, 0x40U, 0x80U, 0x01U, 0x02U, 0x04U};
    EXPECT_TRUE(std::equal(std::begin(kBytes), std::end(kBytes), turned.bytes.begin()));
}

// Blind from each fifth cycle of an interval on, with nothing else wrong.
TEST_F(ComparatorLost, BlindForOneMemberIsFoundWithinTheTestIntervalWheneverItBegins)
{
    Verifies(req::SRS_CMP_009);
    Verifies(req::SRS_CMP_210);
    Verifies(req::SRS_LIM_002);
    for (std::uint32_t phase = 0U; phase < 45U; phase += 5U)
    {
        for (const Member& member : kMembers)
        {
            EXPECT_LE(TimeToFindUs(member.name, phase), 67500U) << member.name << phase;
        }
        for (const std::string_view member : kFrameMembers)
        {
            EXPECT_LE(TimeToFindUs(member, phase), 67500U) << member << phase;
        }
    }
}

TEST_F(ComparatorLost, AlwaysGoodIsFoundByTheDeliberateDifferenceWithinTheTestInterval)
{
    Verifies(req::SRS_CMP_009);
    Verifies(req::SRS_CMP_210);
    EXPECT_LE(CyclesToSafe(ComparatorCalls::kAlwaysGood), 67U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kComparator);
    EXPECT_EQ(kernel.DeviceState().slot, kNoSlot);
}

TEST_F(ComparatorLost, BlindForDataIsFoundByTheDeliberateDifferenceWithinTheTestInterval)
{
    Verifies(req::SRS_CMP_009);
    Verifies(req::SRS_CMP_210);
    EXPECT_LE(CyclesToSafe(ComparatorCalls::kDataUnseen), 67U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kComparator);
}

// Data that the channels do not share, and that are called equal all the same.
TEST_F(ComparatorLost, NormalFrameIsThatOfChannelAAndInverseFrameThatOfChannelB)
{
    Verifies(req::SRS_KRN_213);
    Verifies(req::SRS_KRN_214);
    Operate();
    comparator_calls = ComparatorCalls::kDataUnseen;
    b.on_prepared = [](PreparedPair& pair) { pair.normal.data[1] = 0x55U; };
    a.on_inverse = [](CanFrame& frame) { frame.data[1] = 0xAAU; };
    Cycle();
    ASSERT_EQ(ports.sent.size(), 1U);
    EXPECT_EQ(ports.sent[0].identifier, 0x103U);
    EXPECT_EQ(ports.sent[0].data[1], 0x34U);
    ConfirmLast();
    ASSERT_EQ(ports.sent.size(), 2U);
    EXPECT_EQ(ports.sent[1].identifier, 0x104U);
    EXPECT_EQ(ports.sent[1].data[1], 0xCBU);
}

} // namespace
} // namespace counterpoint
