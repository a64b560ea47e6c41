// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/conformance/runner.hpp"

#include "verification/conformance/cases.hpp"

namespace counterpoint::conformance
{

namespace
{
constexpr std::uint32_t kFirstChallenge = 0x13579BDFU;
constexpr std::uint8_t kUntouched = 0x66U;

/// Any sequence without 0 does; this one has a period of 2^32.
std::uint32_t NextChallenge(std::uint32_t challenge) noexcept
{
    const std::uint32_t next = (challenge * 1664525U) + 1013904223U;
    return (next == 0U) ? 1U : next;
}

std::uint32_t RotatedLeft(std::uint32_t word, std::uint32_t bits) noexcept
{
    return (word << bits) | (word >> (32U - bits));
}

std::uint32_t TokenOf(std::uint32_t challenge, std::uint8_t configuration_valid) noexcept
{
    return RotatedLeft(challenge, 8U) ^ (configuration_valid * 0x01010101U);
}
} // namespace

Runner::Runner(Channel& channel, Party party, Reporter& reporter) noexcept
    : channel_{channel}, judge_{reporter}, producer_{channel, party, judge_, hash_}, party_{party}
{
}

bool Runner::Run(const Case& test, std::uint32_t origin) noexcept
{
    case_ = &test;
    origin_ = origin;
    judge_.Begin(test.name, origin);
    dictionary_.Fill(kUntouched);
    Start(*test.device);
    for (std::uint32_t i = 0U; i < test.step_count; ++i)
    {
        judge_.BeginStep();
        RunStep(test.steps[i]);
        LookAtSlots();
    }
    hash_.Add(dictionary_.Digest());
    return !judge_.HasFailed();
}

void Runner::Start(const Device& device) noexcept
{
    device_.Take(device, dictionary_);
    PowerOn();
}

void Runner::PowerOn() noexcept
{
    outcome_ = CycleOutcome{};
    challenge_ = kFirstChallenge;
    token_flip_ = 0U;
    cycles_ = 0U;
    examine_ = 0U;
    found_ = 0U;
    acknowledge_ = 0U;
    request_ = 0U;
    stand_ = 0U;
    nmt_ = NmtState::kOperational;
    queue_ = QueueState::kIntact;
    configuration_valid_ = 0U;
    channel_.Restart(device_.Config());
}

void Runner::RunRepeated(const Step& repeat) noexcept
{
    for (std::uint32_t i = 0U; i < repeat.x; ++i)
    {
        Step again = repeated_;
        again.time += repeat.y;
        RunStep(again);
    }
}

void Runner::RunStep(const Step& step) noexcept
{
    const bool done = RunConfigurationStep(step) || RunDeviceStep(step) || RunCycleStep(step);
    if (!(done || RunSlotStep(step) || RunReleaseStep(step) || producer_.Run(step, origin_)))
    {
        judge_.Expect("kind of step", 0U, static_cast<std::uint64_t>(step.op));
    }
}

// ---- configuration

void Runner::StoreItem(SlotIndex slot, ConfigField field, std::uint8_t sub, std::uint32_t value) noexcept
{
    if (field == ConfigField::kConfigurationValid)
    {
        configuration_valid_ = static_cast<std::uint8_t>(value & 0xFFU);
    }
    channel_.Store(ConfigItem{ConfigAddress{slot, field, sub}, value});
}

void Runner::StoreValues(const Device& device) noexcept
{
    for (SlotIndex slot = 0U; slot < device_.Config().srdo_count; ++slot)
    {
        const SrdoValues& values = device.values[slot];
        if (values.normal_field != 0U)
        {
            SetFields(slot, values.normal_field, values.inverse_field);
        }
        StoreItem(slot, ConfigField::kSct, 0U, values.sct_ms);
        StoreItem(slot, ConfigField::kSrvt, 0U, values.srvt_ms);
        StoreItem(slot, ConfigField::kCobId1, 0U, values.cob_id_1);
        StoreItem(slot, ConfigField::kCobId2, 0U, values.cob_id_2);
        for (std::uint8_t sub = 1U; sub <= values.map_count; ++sub)
        {
            StoreItem(slot, ConfigField::kMapEntry, sub, values.entries[sub - 1U]);
        }
        StoreItem(slot, ConfigField::kMapCount, 0U, values.map_count);
        StoreItem(slot, ConfigField::kDirection, 0U, values.direction);
        StoreItem(slot, ConfigField::kSignature, 0U, values.signature);
    }
}

void Runner::ValidateAll(const Device& device) noexcept
{
    for (SlotIndex slot = 0U; slot < device_.Config().srdo_count; ++slot)
    {
        const CheckResult result = channel_.Validate(slot);
        hash_.Add(static_cast<std::uint32_t>(result.fault));
        hash_.Add(result.signature);
        judge_.Expect("fault of Validate in Configure", static_cast<std::uint64_t>(ConfigFault::kNone),
                      static_cast<std::uint64_t>(result.fault));
        judge_.Expect("signature in Configure", device.values[slot].signature, result.signature);
    }
    StoreItem(0U, ConfigField::kConfigurationValid, 0U, kConfigurationValidValue);
}

void Runner::Check(const CheckResult& result, const Step& step) noexcept
{
    hash_.Add(static_cast<std::uint32_t>(result.fault));
    hash_.Add(result.signature);
    judge_.Expect("fault", step.x, static_cast<std::uint64_t>(result.fault));
    judge_.Expect("signature", step.y, result.signature);
}

bool Runner::RunConfigurationStep(const Step& step) noexcept
{
    const ConfigField field = static_cast<ConfigField>(step.field);
    if (step.op == Op::kConfigure)
    {
        StoreValues(*case_->device);
        ValidateAll(*case_->device);
    }
    else if (step.op == Op::kStoreAll)
    {
        StoreValues(*case_->device);
    }
    else if (step.op == Op::kStore)
    {
        StoreItem(step.slot, field, step.sub, step.x);
    }
    else if (step.op == Op::kLoad)
    {
        const ConfigItem item = channel_.Load(ConfigAddress{step.slot, field, step.sub});
        hash_.Add(item.value);
        judge_.Expect("value", step.x, item.value);
        judge_.Expect("slot of the address", step.slot, item.address.slot);
        judge_.Expect("field of the address", step.field, static_cast<std::uint64_t>(item.address.field));
        judge_.Expect("sub of the address", step.sub, item.address.sub);
    }
    else if (step.op == Op::kValidate)
    {
        Check(channel_.Validate(step.slot), step);
    }
    else if (step.op == Op::kRecheck)
    {
        Check(channel_.Recheck(step.slot), step);
    }
    else if (step.op == Op::kRestart)
    {
        Start(*case_->device);
    }
    else
    {
        return false;
    }
    return true;
}

// ---- the cycle

void Runner::DoCycle(const Step& step) noexcept
{
    const CycleInput input{Instant{step.time + origin_},
                           challenge_,
                           TokenOf(challenge_, configuration_valid_) ^ token_flip_,
                           acknowledge_,
                           request_,
                           stand_,
                           nmt_,
                           queue_};
    outcome_ = channel_.OnCycle(input);
    challenge_ = NextChallenge(challenge_);
    token_flip_ = 0U;
    request_ = 0U;
    stand_ = 0U;
    queue_ = QueueState::kIntact;
    ++cycles_;
    hash_.AddOutcome(outcome_);
    CheckConsistency();
}

/// What holds after every cycle, whatever the case: masks, ordinals and signals tell what the views tell.
void Runner::CheckConsistency() noexcept
{
    SrdoMask released = 0U;
    SrdoMask faulted = 0U;
    SrdoMask waiting = 0U;
    SrdoMask signalled = 0U;
    SrdoMask providers = 0U;
    std::uint32_t sum = 0U;
    for (SlotIndex slot = 0U; slot < device_.Config().srdo_count; ++slot)
    {
        const SrdoView view = channel_.View(slot);
        const SrdoMask bit = SrdoMask{1U} << slot;
        released |= (view.state == SrdoState::kReleased) ? bit : 0U;
        faulted |= (view.state == SrdoState::kFaulted) ? bit : 0U;
        waiting |= (view.state == SrdoState::kWaiting) ? bit : 0U;
        signalled |= (view.signals != 0U) ? bit : 0U;
        const bool is_called = device_.Config().srdos[slot].form == ProducerForm::kProviderCalled;
        providers |= (is_called && (view.state == SrdoState::kProducer)) ? bit : 0U;
        sum += (view.state == SrdoState::kProducer) ? 0U : view.ordinal;
        if (view.state == SrdoState::kReleased)
        {
            judge_.Expect("holds_pair of a released slot", 1U, view.holds_pair);
        }
    }
    judge_.Expect("released, by the views", released, outcome_.released);
    judge_.Expect("faulted, by the views", faulted, outcome_.faulted);
    judge_.Expect("waiting, by the views", waiting, outcome_.waiting);
    judge_.Expect("signalled, by the views", signalled, outcome_.signalled);
    judge_.Expect("refresh of no active producer whose provider is called", 0U, outcome_.refresh & ~providers);
    judge_.Expect("ordinal_sum, by the views", sum, outcome_.ordinal_sum);
    judge_.Expect("released with a new fault", 0U, outcome_.released & outcome_.new_fault);
    judge_.Expect("cycle", cycles_, outcome_.cycle);
}

void Runner::CheckMasks(const Step& step) noexcept
{
    judge_.Expect("released", step.x, outcome_.released);
    judge_.Expect("faulted", step.y, outcome_.faulted);
    judge_.Expect("waiting", step.z, outcome_.waiting);
    judge_.Expect("new_fault", step.v, outcome_.new_fault);
    judge_.Expect("fresh", step.w, outcome_.fresh);
}

bool Runner::RunCycleStep(const Step& step) noexcept
{
    if ((step.op == Op::kFrame) || (step.op == Op::kCycle))
    {
        repeated_ = step;
    }
    if (step.op == Op::kRepeat)
    {
        RunRepeated(step);
    }
    else if (step.op == Op::kNmt)
    {
        nmt_ = static_cast<NmtState>(step.x);
    }
    else if (step.op == Op::kAcknowledge)
    {
        acknowledge_ = (SrdoMask{step.y} << 32U) | step.x;
    }
    else if (step.op == Op::kQueue)
    {
        queue_ = static_cast<QueueState>(step.x);
    }
    else if (step.op == Op::kRequest)
    {
        request_ |= SrdoMask{1U} << step.slot;
    }
    else if (step.op == Op::kStand)
    {
        stand_ |= SrdoMask{1U} << step.slot;
    }
    else if (step.op == Op::kToken)
    {
        token_flip_ = step.x;
    }
    else if (step.op == Op::kFrame)
    {
        channel_.OnFrame(FrameOf(step), Instant{step.time + origin_});
    }
    else if (step.op == Op::kCycle)
    {
        DoCycle(step);
    }
    else
    {
        return RunOutcomeStep(step);
    }
    return true;
}

bool Runner::RunOutcomeStep(const Step& step) noexcept
{
    if (step.op == Op::kMasks)
    {
        CheckMasks(step);
    }
    else if (step.op == Op::kMask)
    {
        const SrdoMask masks[] = {outcome_.released, outcome_.faulted, outcome_.waiting,   outcome_.new_fault,
                                  outcome_.fresh,    outcome_.due,     outcome_.signalled, outcome_.refresh};
        const char* const names[] = {"released", "faulted", "waiting",   "new_fault",
                                     "fresh",    "due",     "signalled", "refresh"};
        judge_.Expect(names[step.slot], (SrdoMask{step.y} << 32U) | step.x, masks[step.slot]);
    }
    else if (step.op == Op::kCounts)
    {
        judge_.Expect("sct_checked", step.slot, outcome_.sct_checked);
        judge_.Expect("is_tx", step.field, outcome_.is_tx);
        judge_.Expect("is_invalid", step.sub, outcome_.is_invalid);
        judge_.Expect("not_operational", step.x, outcome_.not_operational);
    }
    else if (step.op == Op::kGuard)
    {
        judge_.Expect("guard", step.x, static_cast<std::uint64_t>(outcome_.guard));
    }
    else if (step.op == Op::kOrdinalSum)
    {
        judge_.Expect("ordinal_sum", step.x, outcome_.ordinal_sum);
    }
    else
    {
        return false;
    }
    return true;
}

// ---- the device, details of a slot, objects

void Runner::SetFields(SlotIndex slot, std::uint32_t normal, std::uint32_t inverse) noexcept
{
    const auto place = [this](std::uint32_t object)
    { return dictionary_.Place(static_cast<std::uint16_t>(object >> 8U), static_cast<std::uint8_t>(object & 0xFFU)); };
    channel_.SetFields(slot, StaticFields{place(normal), place(inverse)});
}

bool Runner::RunDeviceStep(const Step& step) noexcept
{
    if (step.op == Op::kFields)
    {
        SetFields(step.slot, step.x, step.y);
    }
    else if (step.op == Op::kDigest)
    {
        const DeviceDigest digest = channel_.Digest(step.slot, DeviceDigest{step.x});
        hash_.Add(digest.value);
        judge_.Expect("digest", step.y, digest.value);
    }
    else if (step.op == Op::kAlter)
    {
        device_.Alter(step);
        PowerOn();
    }
    else
    {
        return false;
    }
    return true;
}

void Runner::CheckView(const Step& step) noexcept
{
    const SrdoView view = channel_.View(step.slot);
    judge_.Expect("state", step.field, static_cast<std::uint64_t>(view.state));
    judge_.Expect("first_cause", step.sub, static_cast<std::uint64_t>(view.first_cause));
    judge_.Expect("ordinal", step.x, view.ordinal);
    judge_.Expect("error_count", step.y, view.error_count);
    judge_.Expect("holds_pair", step.z, view.holds_pair);
}

/// `writer` owns the object: the other channel must have left it as it was before the case.
void Runner::CheckObject(const Step& step, Party writer) noexcept
{
    const std::uint16_t index = static_cast<std::uint16_t>(step.x);
    const ObjectValue value = dictionary_.Get(index, step.sub);
    const std::uint8_t bytes = dictionary_.Bytes(index, step.sub);
    std::uint32_t low = step.y;
    std::uint32_t high = step.z;
    if (writer != party_)
    {
        low = (bytes >= 4U) ? 0x66666666U : (0x66666666U & ((1U << (8U * bytes)) - 1U));
        high = (bytes <= 4U) ? 0U : ((bytes == 8U) ? 0x66666666U : (0x66666666U & ((1U << (8U * (bytes - 4U))) - 1U)));
    }
    judge_.Expect("object, bytes 0 to 3", low, value.low);
    judge_.Expect("object, bytes 4 to 7", high, value.high);
}

bool Runner::RunSlotStep(const Step& step) noexcept
{
    if (step.op == Op::kSlot)
    {
        CheckView(step);
    }
    else if (step.op == Op::kData)
    {
        const Payload data = channel_.View(step.slot).data;
        judge_.Expect("data, bytes 0 to 3", (party_ == Party::kA) ? step.x : step.z, data.low);
        judge_.Expect("data, bytes 4 to 7", (party_ == Party::kA) ? step.y : step.v, data.high);
    }
    else if (step.op == Op::kSignals)
    {
        judge_.Expect("signals", step.x, channel_.View(step.slot).signals);
    }
    else if (step.op == Op::kPut)
    {
        dictionary_.Put(static_cast<std::uint16_t>(step.x), step.sub, ObjectValue{step.y, step.z});
    }
    else if (step.op == Op::kShare)
    {
        dictionary_.Share(static_cast<std::uint16_t>(step.x), step.sub, static_cast<std::uint16_t>(step.y), step.slot);
    }
    else if (step.op == Op::kNormalObject)
    {
        CheckObject(step, Party::kA);
    }
    else if (step.op == Op::kInverseObject)
    {
        CheckObject(step, Party::kB);
    }
    else
    {
        return false;
    }
    return true;
}

void Runner::LookAtSlots() noexcept
{
    for (SlotIndex slot = 0U; slot < device_.Config().srdo_count; ++slot)
    {
        const SrdoView view = channel_.View(slot);
        hash_.AddView(view);
        CheckHeld(slot, view);
    }
}

/// Held tells what View tells of an active consumer, and nothing of the others.
void Runner::CheckHeld(SlotIndex slot, const SrdoView& view) noexcept
{
    const bool is_consumer = (view.state == SrdoState::kWaiting) || (view.state == SrdoState::kFaulted) ||
                             (view.state == SrdoState::kReleased);
    const HeldPair held = channel_.Held(slot);
    hash_.AddHeld(held);
    judge_.Expect("held data, bytes 0 to 3", is_consumer ? view.data.low : 0U, held.data.low);
    judge_.Expect("held data, bytes 4 to 7", is_consumer ? view.data.high : 0U, held.data.high);
    judge_.Expect("held ordinal", is_consumer ? view.ordinal : 0U, held.ordinal);
    judge_.Expect("holds_pair of Held", is_consumer ? view.holds_pair : 0U, held.holds_pair);
}

bool Runner::RunReleaseStep(const Step& step) noexcept
{
    if (step.op == Op::kDemote)
    {
        channel_.Demote(step.slot);
    }
    else if (step.op == Op::kCommit)
    {
        const SrdoMask found = channel_.Commit(
            Agreement{(SrdoMask{step.y} << 32U) | step.x, (SrdoMask{step.v} << 32U) | step.z}, examine_);
        hash_.Add(dictionary_.Digest());
        hash_.AddMask(found);
        judge_.Expect("slots not as they were written", found_, found);
        examine_ = 0U;
        found_ = 0U;
    }
    else if (step.op == Op::kExamine)
    {
        examine_ = (SrdoMask{step.y} << 32U) | step.x;
        found_ = (SrdoMask{step.v} << 32U) | step.z;
    }
    else if (step.op == Op::kAnswer)
    {
        const Permit permit = channel_.Answer(step.z);
        hash_.AddMask(permit.mask);
        hash_.Add(permit.response);
        judge_.Expect("mask of the permit", (SrdoMask{step.y} << 32U) | step.x, permit.mask);
        judge_.Expect("response of the permit", (party_ == Party::kA) ? step.v : step.w, permit.response);
    }
    else
    {
        return false;
    }
    return true;
}

RunResult RunConformance(Runner& runner) noexcept
{
    RunResult result{0U, 0U, 0U};
    for (std::uint32_t table = 0U; table < kTableCount; ++table)
    {
        for (std::uint32_t i = 0U; i < kAllTables[table]->count; ++i)
        {
            for (const std::uint32_t origin : kOrigins)
            {
                const bool held = runner.Run(kAllTables[table]->cases[i], origin);
                result.cases += 1U;
                result.failures += held ? 0U : 1U;
            }
        }
    }
    result.hash = runner.HashValue();
    return result;
}

} // namespace counterpoint::conformance
