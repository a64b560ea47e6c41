// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/conformance/runner.hpp"

namespace counterpoint::conformance
{

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
        Expect("digest", step.y, digest.value);
    }
    else if (step.op == Op::kAlter)
    {
        Alter(step);
    }
    else
    {
        return false;
    }
    return true;
}

/// No channel keeps a reference to the setup of a slot, but to the configuration: nothing runs while they change.
void Runner::Alter(const Step& step) noexcept
{
    const Parameter parameter = static_cast<Parameter>(step.field);
    if (step.slot < kAlterable)
    {
        AlterSetup(parameter, setups_[step.slot], step.x);
    }
    AlterDevice(parameter, step.x);
    AlterTimes(parameter, step.x);
    PowerOn();
}

void Runner::AlterDevice(Parameter parameter, std::uint32_t value) noexcept
{
    const std::uint8_t byte = static_cast<std::uint8_t>(value & 0xFFU);
    std::uint8_t* const bytes[] = {&config_.node_id, &config_.granularity_bits, &config_.map_entries};
    if (parameter <= Parameter::kMapEntries)
    {
        *bytes[static_cast<std::uint8_t>(parameter)] = byte;
    }
    config_.dummies = (parameter == Parameter::kDummyMapping) ? static_cast<DummyMapping>(byte) : config_.dummies;
    config_.gaps = (parameter == Parameter::kNumberGaps) ? static_cast<NumberGaps>(byte) : config_.gaps;
    config_.gfc = (parameter == Parameter::kGfc) ? static_cast<GfcUse>(byte) : config_.gfc;
    config_.normal_port = (parameter == Parameter::kNormalPort) ? static_cast<CanPortId>(byte) : config_.normal_port;
    config_.inverse_port = (parameter == Parameter::kInversePort) ? static_cast<CanPortId>(byte) : config_.inverse_port;
}

void Runner::AlterTimes(Parameter parameter, std::uint32_t value) noexcept
{
    std::uint32_t* const words[] = {&config_.cycle_us,
                                    &config_.cycle_tolerance_us,
                                    &config_.discrepancy_us,
                                    &config_.acknowledge_window_us,
                                    &config_.diagnostic_interval_us,
                                    &config_.test_interval_us,
                                    &config_.clock_tolerance_us,
                                    &config_.clock_interval_us,
                                    &config_.output_time_us,
                                    &config_.digest};
    if ((parameter >= Parameter::kCycle) && (parameter <= Parameter::kDigest))
    {
        *words[static_cast<std::uint8_t>(parameter) - static_cast<std::uint8_t>(Parameter::kCycle)] = value;
    }
}

void Runner::AlterSetup(Parameter parameter, SrdoSetup& setup, std::uint32_t value) noexcept
{
    const std::uint8_t byte = static_cast<std::uint8_t>(value & 0xFFU);
    setup.number = (parameter == Parameter::kNumber) ? byte : setup.number;
    setup.policy = (parameter == Parameter::kPolicy) ? static_cast<ReleasePolicy>(byte) : setup.policy;
    setup.form = (parameter == Parameter::kForm) ? static_cast<ProducerForm>(byte) : setup.form;
    setup.detection = (parameter == Parameter::kDetection) ? static_cast<SrvtDetection>(byte) : setup.detection;
    setup.safe_value.low = (parameter == Parameter::kSafeLow) ? value : setup.safe_value.low;
    setup.safe_value.high = (parameter == Parameter::kSafeHigh) ? value : setup.safe_value.high;
}

// ---- details of a slot, objects

void Runner::CheckView(const Step& step) noexcept
{
    const SrdoView view = channel_.View(step.slot);
    Expect("state", step.field, static_cast<std::uint64_t>(view.state));
    Expect("first_cause", step.sub, static_cast<std::uint64_t>(view.first_cause));
    Expect("ordinal", step.x, view.ordinal);
    Expect("error_count", step.y, view.error_count);
    Expect("holds_pair", step.z, view.holds_pair);
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
    Expect("object, bytes 0 to 3", low, value.low);
    Expect("object, bytes 4 to 7", high, value.high);
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
        Expect("data, bytes 0 to 3", (party_ == Party::kA) ? step.x : step.z, data.low);
        Expect("data, bytes 4 to 7", (party_ == Party::kA) ? step.y : step.v, data.high);
    }
    else if (step.op == Op::kSignals)
    {
        Expect("signals", step.x, channel_.View(step.slot).signals);
    }
    else if (step.op == Op::kPut)
    {
        dictionary_.Put(static_cast<std::uint16_t>(step.x), step.sub, ObjectValue{step.y, step.z});
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

} // namespace counterpoint::conformance
