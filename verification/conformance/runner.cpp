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
    : channel_{channel}, reporter_{reporter}, party_{party}
{
}

bool Runner::Run(const Case& test, std::uint32_t origin) noexcept
{
    case_ = &test;
    origin_ = origin;
    failed_ = false;
    step_ = 0U;
    dictionary_.Fill(kUntouched);
    Start(*test.device);
    for (std::uint32_t i = 0U; i < test.step_count; ++i)
    {
        step_ = i + 1U;
        RunStep(test.steps[i]);
        LookAtSlots();
    }
    hash_.Add(dictionary_.Digest());
    return !failed_;
}

void Runner::Start(const Device& device) noexcept
{
    config_ = device.config;
    config_.objects = dictionary_.Objects();
    if (config_.object_count == kAllObjects)
    {
        config_.object_count = Dictionary::kObjectCount;
    }
    if (config_.srdo_count <= kAlterable)
    {
        for (SlotIndex slot = 0U; slot < config_.srdo_count; ++slot)
        {
            setups_[slot] = device.config.srdos[slot];
        }
        config_.srdos = setups_;
    }
    PowerOn();
}

void Runner::PowerOn() noexcept
{
    outcome_ = CycleOutcome{};
    challenge_ = kFirstChallenge;
    token_flip_ = 0U;
    cycles_ = 0U;
    acknowledge_ = 0U;
    request_ = 0U;
    stand_ = 0U;
    nmt_ = NmtState::kOperational;
    queue_ = QueueState::kIntact;
    configuration_valid_ = 0U;
    channel_.Restart(config_);
}

void Runner::Expect(const char* field, std::uint64_t expected, std::uint64_t got) noexcept
{
    if (expected != got)
    {
        failed_ = true;
        reporter_.OnFailure(Failure{case_->name, field, expected, got, step_, origin_});
    }
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
    if (!(done || RunSlotStep(step) || RunReleaseStep(step)))
    {
        RunProducerStep(step);
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
    for (SlotIndex slot = 0U; slot < config_.srdo_count; ++slot)
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
    for (SlotIndex slot = 0U; slot < config_.srdo_count; ++slot)
    {
        const CheckResult result = channel_.Validate(slot);
        hash_.Add(static_cast<std::uint32_t>(result.fault));
        hash_.Add(result.signature);
        Expect("fault of Validate in Configure", static_cast<std::uint64_t>(ConfigFault::kNone),
               static_cast<std::uint64_t>(result.fault));
        Expect("signature in Configure", device.values[slot].signature, result.signature);
    }
    StoreItem(0U, ConfigField::kConfigurationValid, 0U, kConfigurationValidValue);
}

void Runner::Check(const CheckResult& result, const Step& step) noexcept
{
    hash_.Add(static_cast<std::uint32_t>(result.fault));
    hash_.Add(result.signature);
    Expect("fault", step.x, static_cast<std::uint64_t>(result.fault));
    Expect("signature", step.y, result.signature);
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
        Expect("value", step.x, item.value);
        Expect("slot of the address", step.slot, item.address.slot);
        Expect("field of the address", step.field, static_cast<std::uint64_t>(item.address.field));
        Expect("sub of the address", step.sub, item.address.sub);
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
    std::uint32_t sum = 0U;
    for (SlotIndex slot = 0U; slot < config_.srdo_count; ++slot)
    {
        const SrdoView view = channel_.View(slot);
        const SrdoMask bit = SrdoMask{1U} << slot;
        released |= (view.state == SrdoState::kReleased) ? bit : 0U;
        faulted |= (view.state == SrdoState::kFaulted) ? bit : 0U;
        waiting |= (view.state == SrdoState::kWaiting) ? bit : 0U;
        signalled |= (view.signals != 0U) ? bit : 0U;
        sum += (view.state == SrdoState::kProducer) ? 0U : view.ordinal;
        if (view.state == SrdoState::kReleased)
        {
            Expect("holds_pair of a released slot", 1U, view.holds_pair);
        }
    }
    Expect("released, by the views", released, outcome_.released);
    Expect("faulted, by the views", faulted, outcome_.faulted);
    Expect("waiting, by the views", waiting, outcome_.waiting);
    Expect("signalled, by the views", signalled, outcome_.signalled);
    Expect("ordinal_sum, by the views", sum, outcome_.ordinal_sum);
    Expect("released with a new fault", 0U, outcome_.released & outcome_.new_fault);
    Expect("cycle", cycles_, outcome_.cycle);
}

void Runner::CheckMasks(const Step& step) noexcept
{
    Expect("released", step.x, outcome_.released);
    Expect("faulted", step.y, outcome_.faulted);
    Expect("waiting", step.z, outcome_.waiting);
    Expect("new_fault", step.v, outcome_.new_fault);
    Expect("fresh", step.w, outcome_.fresh);
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
        const SrdoMask masks[] = {outcome_.released, outcome_.faulted, outcome_.waiting,  outcome_.new_fault,
                                  outcome_.fresh,    outcome_.due,     outcome_.signalled};
        const char* const names[] = {"released", "faulted", "waiting", "new_fault", "fresh", "due", "signalled"};
        Expect(names[step.slot], (SrdoMask{step.y} << 32U) | step.x, masks[step.slot]);
    }
    else if (step.op == Op::kCounts)
    {
        Expect("sct_checked", step.slot, outcome_.sct_checked);
        Expect("is_tx", step.field, outcome_.is_tx);
        Expect("is_invalid", step.sub, outcome_.is_invalid);
        Expect("not_operational", step.x, outcome_.not_operational);
    }
    else if (step.op == Op::kGuard)
    {
        Expect("guard", step.x, static_cast<std::uint64_t>(outcome_.guard));
    }
    else if (step.op == Op::kOrdinalSum)
    {
        Expect("ordinal_sum", step.x, outcome_.ordinal_sum);
    }
    else
    {
        return false;
    }
    return true;
}

} // namespace counterpoint::conformance
