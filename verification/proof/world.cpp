// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/world.hpp"

#include "verification/proof/checksum.hpp"

#include <cstring>
#include <type_traits>

namespace counterpoint::proof
{

namespace
{
constexpr SlotIndex kSlot = 0U;
constexpr SrdoMask kBit = 1U;
constexpr std::uint32_t kNormalIdentifier = 0x111U;
constexpr std::uint32_t kInverseIdentifier = 0x112U;
constexpr std::uint8_t kValid = 0xA5U;
constexpr std::uint32_t kEntries[] = {0x22000108U, 0x22010108U};

/// By the definition, over the bytes that SRS_CFG_010 lists.
std::uint16_t Signature()
{
    constexpr std::uint8_t kBytes[] = {2U, 2U, 0U, 1U, 0x11U, 1U, 0U, 0U, 0x12U, 1U,   0U, 0U, 2U, // fixed part
                                       1U, 8U, 1U, 0U, 0x22U, 2U, 8U, 1U, 1U,    0x22U};           // entries
    std::uint16_t crc = 0U;
    for (const std::uint8_t byte : kBytes)
    {
        crc = Divided16(crc, byte);
    }
    return crc;
}

std::uint32_t ResponseOf(const std::uint32_t challenge, const SrdoMask mask, const std::uint32_t constant)
{
    const std::uint32_t low = static_cast<std::uint32_t>(mask);
    const std::uint32_t high = static_cast<std::uint32_t>(mask >> 32U);
    return ((challenge + low) ^ ((high << 16U) | (high >> 16U))) * constant;
}

void AddTo(std::uint64_t& digest, const std::uint64_t value)
{
    digest = (digest ^ value) * 0x9E3779B97F4A7C15U;
    digest ^= digest >> 29U;
}
} // namespace

World::World(const ConsumerSetup& setup, Between* const around_a, Between* const around_b)
    : setup_{setup}, around_a_{around_a}, around_b_{around_b}
{
    srdo_.number = 1U;
    srdo_.policy = setup.policy;
    srdo_.safe_value = Payload{kSafe, 0U};
    srdo_.detection = setup.detection;
    objects_[0] = MappableObject{0x2200U, 1U, 8U, MapAccess::kConsumer, &variables_.normal};
    objects_[1] = MappableObject{0x2201U, 1U, 8U, MapAccess::kConsumer, &variables_.inverse};
    config_.srdos = &srdo_;
    config_.objects = &objects_[0];
    config_.object_count = 2U;
    config_.srdo_count = 1U;
    config_.node_id = 1U;
    config_.granularity_bits = 8U;
    config_.map_entries = 2U;
    config_.gfc = GfcUse::kPresent;
    config_.normal_port = CanPortId::kFirst;
    config_.inverse_port = CanPortId::kFirst;
    config_.cycle_us = kCycleUs;
    config_.cycle_tolerance_us = kToleranceUs;
    config_.acknowledge_window_us = kWindowUs;
    config_.diagnostic_interval_us = 1000000U;
    config_.test_interval_us = 1000000U;
    config_.clock_interval_us = 1000000U;
}

void World::Configure(Channel& channel)
{
    const auto store = [&channel](const ConfigField field, const std::uint32_t value, const std::uint8_t sub = 0U)
    { channel.Store(ConfigItem{ConfigAddress{kSlot, field, sub}, value}); };
    channel.Restart(config_);
    store(ConfigField::kDirection, kDirectionConsumer);
    store(ConfigField::kSct, kSctUs / 1000U);
    store(ConfigField::kSrvt, kSrvtUs / 1000U);
    store(ConfigField::kTransmissionType, kTransmissionTypeAsynchronous);
    store(ConfigField::kCobId1, kNormalIdentifier);
    store(ConfigField::kCobId2, kInverseIdentifier);
    store(ConfigField::kMapCount, 2U);
    store(ConfigField::kMapEntry, kEntries[0], 1U);
    store(ConfigField::kMapEntry, kEntries[1], 2U);
    store(ConfigField::kGfcParameter, 1U);
    store(ConfigField::kSignature, Signature());
    static_cast<void>(channel.Validate(kSlot)); // Where it is refused the model is on, and the channel is not.
    store(ConfigField::kConfigurationValid, kValid);
}

void World::Start(const std::uint32_t base_us)
{
    static_assert(std::is_trivially_copyable_v<decltype(storage_a_)>, "saved and put back byte by byte");
    static_assert(std::is_trivially_copyable_v<decltype(storage_b_)>, "saved and put back byte by byte");
    base_us_ = base_us;
    course_ = Course{};
    std::memset(&storage_a_, 0, sizeof(storage_a_));
    std::memset(&storage_b_, 0, sizeof(storage_b_));
    variables_ = Variables{};
    a_.emplace(storage_a_.Handle());
    b_.emplace(storage_b_.Handle());
    voice_a_ = (around_a_ != nullptr) ? &around_a_->Around(*a_) : &*a_;
    voice_b_ = (around_b_ != nullptr) ? &around_b_->Around(*b_) : &*b_;
    Configure(*voice_a_);
    Configure(*voice_b_);
    // The first call is never late, so that one comes before all letters.
    static_cast<void>(
        Apply(Letter{"power-on", Act::kCall, kCycleUs, 0U, 0U, FrameKind::kData, false, false, true, false}));
}

std::uint32_t World::NowUs() const
{
    return base_us_ + static_cast<std::uint32_t>(course_.called_us + course_.frame_us);
}

std::vector<Region> World::Regions() const
{
    World* const self = const_cast<World*>(this); // Restore writes through them.
    std::vector<Region> regions{{&*self->a_, sizeof(*a_)},
                                {&self->storage_a_, sizeof(storage_a_)},
                                {&*self->b_, sizeof(*b_)},
                                {&self->storage_b_, sizeof(storage_b_)},
                                {&self->variables_, sizeof(variables_)}};
    for (Between* const between : {around_a_, around_b_})
    {
        if (between != nullptr)
        {
            regions.push_back(between->Notes());
        }
    }
    return regions;
}

Snapshot World::Save() const
{
    Snapshot snapshot{{}, course_};
    for (const Region& region : Regions())
    {
        const std::uint8_t* const first = static_cast<const std::uint8_t*>(region.first);
        snapshot.bytes.insert(snapshot.bytes.end(), first, first + region.bytes);
    }
    return snapshot;
}

void World::Restore(const Snapshot& snapshot)
{
    const std::uint8_t* from = snapshot.bytes.data();
    for (const Region& region : Regions())
    {
        std::memcpy(region.first, from, region.bytes);
        from += region.bytes;
    }
    course_ = snapshot.course;
}

void World::Frame(const Letter& letter)
{
    const bool is_inverse = letter.act == Act::kInverse;
    const std::uint8_t data = static_cast<std::uint8_t>(is_inverse ? ~std::uint32_t{letter.value} : letter.value);
    const std::int64_t stamp = course_.called_us + letter.after_us;
    CanFrame frame{is_inverse ? kInverseIdentifier : kNormalIdentifier,
                   letter.kind,
                   CanPortId::kFirst,
                   letter.length,
                   {data, data}};
    frame.identifier = (letter.act == Act::kGfc) ? std::uint32_t{kGfcIdentifier} : frame.identifier;
    voice_a_->OnFrame(frame, Instant{base_us_ + static_cast<std::uint32_t>(stamp)});
    voice_b_->OnFrame(frame, Instant{base_us_ + static_cast<std::uint32_t>(stamp)});
    course_.frame_us = letter.after_us;
    if (letter.act == Act::kGfc)
    {
        course_.has_gfc = course_.has_gfc || !course_.is_left;
    }
    else if (letter.kind == FrameKind::kData)
    {
        const third_voice::Bytes bytes(letter.length, data);
        is_inverse ? course_.model.OnInverse(bytes, stamp) : course_.model.OnNormal(bytes, stamp);
        const bool is_length_right = letter.length == 1U;
        is_inverse ? course_.witness.OnInverse(letter.value, is_length_right, stamp, setup_)
                   : course_.witness.OnNormal(letter.value, is_length_right, stamp, setup_);
    }
}

/// The order of a cycle is that of the third voice's device; what a device has beyond one consumer is left out.
void World::CallModel(const Letter& letter, const bool is_late)
{
    third_voice::Consumer& model = course_.model;
    const std::int64_t now = course_.called_us;
    if (letter.is_operational && course_.is_left)
    {
        third_voice::ConsumerRules rules;
        rules.sct_us = kSctUs;
        rules.srvt_us = kSrvtUs;
        rules.length_bytes = 1U;
        rules.mask = 0xFFU;
        rules.is_late = setup_.detection == SrvtDetection::kLate;
        rules.is_automatic = setup_.policy == ReleasePolicy::kAutomatic;
        rules.acknowledge_window_us = kWindowUs;
        model.EnterOperational(rules, now);
        course_.entered_us = now;
    }
    if (!letter.is_operational && !course_.is_left)
    {
        model.LeaveOperational();
        course_.told |= 1U << static_cast<unsigned>(SrdoCause::kNotOperational);
    }
    model.LookAtAcknowledge(letter.is_acknowledged, now);
    if (model.IsActive())
    {
        model.LookAtLimits(now);
        std::set<SrdoCause> causes = model.TakeCauses();
        if (is_late && causes.empty())
        {
            model.Fail(SrdoCause::kLateCall);
        }
        if (!letter.is_intact)
        {
            model.Fail(SrdoCause::kQueueOverflow);
        }
        if (course_.has_gfc)
        {
            model.Fail(SrdoCause::kGfc);
        }
        model.LookAtWaiting(now);
        causes.merge(model.TakeCauses());
        for (const SrdoCause cause : causes)
        {
            course_.told |= 1U << static_cast<unsigned>(cause);
        }
        model.Judge(now);
        if (model.State() == SrdoState::kReleased)
        {
            model.Settle();
        }
        model.EndCycle();
    }
}

std::string World::Call(const Letter& letter)
{
    ++course_.cycles;
    course_.called_us += letter.after_us;
    course_.frame_us = 0U;
    CycleInput input{};
    input.now = Instant{base_us_ + static_cast<std::uint32_t>(course_.called_us)};
    input.challenge = (course_.cycles * 2654435761U) | 1U;
    input.guard_token = ((input.challenge << 8U) | (input.challenge >> 24U)) ^ 0xA5A5A5A5U;
    input.acknowledge = letter.is_acknowledged ? kBit : 0U;
    input.nmt = letter.is_operational ? NmtState::kOperational : NmtState::kPreOperational;
    input.queue = letter.is_intact ? QueueState::kIntact : QueueState::kOverflowed;
    const CycleOutcome a = voice_a_->OnCycle(input);
    const CycleOutcome b = voice_b_->OnCycle(input);
    const bool is_late = letter.after_us > (kCycleUs + kToleranceUs);
    CallModel(letter, is_late);
    course_.witness.OnCall({course_.called_us, letter.is_acknowledged, letter.is_operational, letter.is_intact, is_late,
                            course_.has_gfc, letter.is_demoted},
                           setup_);
    course_.has_gfc = false;
    course_.is_left = !letter.is_operational;
    std::string refused = CompareOutcomes(a, b);
    SrdoMask agreed = a.released & b.released;
    if (letter.is_demoted)
    {
        voice_a_->Demote(kSlot);
        voice_b_->Demote(kSlot);
        if (course_.model.IsActive())
        {
            course_.model.Demote();
        }
        agreed = 0U;
    }
    const HeldPair held_a = voice_a_->Held(kSlot);
    const HeldPair held_b = voice_b_->Held(kSlot);
    const bool is_matched = (held_a.ordinal == held_b.ordinal) && (held_a.data.low == held_b.data.low) &&
                            (held_a.data.high == held_b.data.high);
    const Agreement agreement{agreed, is_matched ? kBit : 0U};
    if ((voice_a_->Commit(agreement, kBit) | voice_b_->Commit(agreement, kBit)) != 0U)
    {
        refused = refused.empty() ? "object not as written" : refused;
    }
    const Permit permit_a = voice_a_->Answer(input.challenge);
    const Permit permit_b = voice_b_->Answer(input.challenge);
    const bool are_right = (permit_a.mask == agreed) && (permit_b.mask == agreed) &&
                           (permit_a.response == ResponseOf(input.challenge, agreed, kPermitConstantA)) &&
                           (permit_b.response == ResponseOf(input.challenge, agreed, kPermitConstantB));
    if (!are_right && refused.empty())
    {
        refused = "permit without what it permits";
    }
    return refused;
}

std::string World::CompareOutcomes(const CycleOutcome& a, const CycleOutcome& b) const
{
    const bool are_equal = (a.released == b.released) && (a.faulted == b.faulted) && (a.waiting == b.waiting) &&
                           (a.new_fault == b.new_fault) && (a.fresh == b.fresh) && (a.due == b.due) &&
                           (a.refresh == b.refresh) && (a.signalled == b.signalled) && (a.cycle == b.cycle) &&
                           (a.ordinal_sum == b.ordinal_sum) && (a.guard == b.guard) &&
                           (a.sct_checked == b.sct_checked) && (a.is_tx == b.is_tx) && (a.is_invalid == b.is_invalid) &&
                           (a.not_operational == b.not_operational);
    return are_equal ? std::string{} : "channels differ in the outcome of a call";
}

std::string World::CompareChannels() const
{
    const SrdoView a = voice_a_->View(kSlot);
    const SrdoView b = voice_b_->View(kSlot);
    const bool are_equal = (a.data.low == b.data.low) && (a.data.high == b.data.high) && (a.ordinal == b.ordinal) &&
                           (a.signals == b.signals) && (a.error_count == b.error_count) && (a.state == b.state) &&
                           (a.first_cause == b.first_cause) && (a.holds_pair == b.holds_pair);
    return are_equal ? std::string{} : "channels differ in what they show";
}

std::string World::CompareModel() const
{
    const SrdoView a = voice_a_->View(kSlot);
    if (a.state != course_.model.State())
    {
        return "state differs from the model's: " + std::to_string(static_cast<unsigned>(a.state)) + ", model " +
               std::to_string(static_cast<unsigned>(course_.model.State()));
    }
    // What a channel keeps of a pair behind a fault, until the cycle tells of the fault, is its own business.
    if ((a.data.low != course_.model.Data()) && (!course_.model.HasNewFault()))
    {
        return "held pair differs from the model's";
    }
    return {};
}

/// Behind a call: what was told, and what stands in the objects.
std::string World::Finish(const bool is_released) const
{
    const SrdoView a = voice_a_->View(kSlot);
    if (a.signals != course_.told)
    {
        return "causes told differ from the model's: " + std::to_string(a.signals) + ", model " +
               std::to_string(course_.told);
    }
    const std::uint8_t normal = is_released ? static_cast<std::uint8_t>(a.data.low) : kSafe;
    const bool are_right = (variables_.normal == normal) && ((variables_.normal ^ variables_.inverse) == 0xFFU);
    return are_right ? std::string{} : "object holds something else than it has to";
}

std::uint64_t World::Digest(const bool is_call) const
{
    const SrdoView a = voice_a_->View(kSlot);
    std::uint64_t digest = 0U;
    AddTo(digest, a.data.low);
    AddTo(digest, is_call ? a.signals : 0U);
    AddTo(digest, static_cast<std::uint64_t>(a.state));
    AddTo(digest, static_cast<std::uint64_t>(a.first_cause));
    AddTo(digest, a.holds_pair);
    AddTo(digest, variables_.normal);
    return digest;
}

Answer World::Apply(const Letter& letter)
{
    Answer answer;
    const bool is_call = letter.act == Act::kCall;
    if (!is_call && (letter.after_us < course_.frame_us))
    {
        answer.is_possible = false;
        return answer;
    }
    const Shows before{course_.state, course_.first_cause, 0U};
    if (is_call)
    {
        answer.refused = Call(letter);
    }
    else
    {
        Frame(letter);
        for (const SrdoCause cause : course_.model.TakeCauses())
        {
            course_.told |= 1U << static_cast<unsigned>(cause);
        }
    }
    const SrdoView a = voice_a_->View(kSlot);
    const Shows now{a.state, a.first_cause, static_cast<std::uint8_t>(a.data.low)};
    course_.state = now.state;
    course_.first_cause = now.first_cause;
    const std::string witnessed = course_.witness.Judge(before, now, is_call, setup_);
    answer.refused = witnessed.empty() ? answer.refused : witnessed;
    answer.refused = answer.refused.empty() ? CompareChannels() : answer.refused;
    answer.refused = answer.refused.empty() ? CompareModel() : answer.refused;
    if (is_call)
    {
        answer.refused = answer.refused.empty() ? Finish(now.state == SrdoState::kReleased) : answer.refused;
        course_.told = 0U;
        course_.witness.EndCall(now.state == SrdoState::kReleased);
    }
    answer.visible = Digest(is_call);
    return answer;
}

std::vector<std::size_t> World::Budgets() const
{
    const auto at = [this](const void* const place)
    {
        return sizeof(*a_) + sizeof(storage_a_) + sizeof(*b_) +
               static_cast<std::size_t>(static_cast<const std::uint8_t*>(place) -
                                        reinterpret_cast<const std::uint8_t*>(&storage_b_));
    };
    return {at(&storage_b_.left[0]), at(&storage_b_.srvt_left[0]), at(&storage_b_.phase_left[0])};
}

std::uint32_t World::Objects() const
{
    return (std::uint32_t{variables_.normal} << 8U) | variables_.inverse;
}

Counted World::Counts() const
{
    const SrdoView view = voice_a_->View(kSlot);
    return Counted{course_.cycles, view.ordinal, view.error_count,
                   static_cast<std::uint32_t>(course_.called_us - course_.entered_us)};
}

} // namespace counterpoint::proof
