// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/device.hpp"

#include "runtime/node/srdo_line.hpp"

#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>

// What a live node loads at its resets, and what its application sends by itself. [SRS_NODE_001]
namespace counterpoint::runtime
{
namespace
{
constexpr std::uint16_t kCommunicationBase = 0x1300U;
constexpr std::uint16_t kIdentity = 0x1018U;
constexpr std::uint8_t kCobIdSub2 = 6U;

ObjectData DataOf(const runtime::ConfigurationWrite& write)
{
    ObjectData data{};
    data.size_bytes = write.size_bytes;
    cia301::ToLittleEndian(write.value, data.bytes, write.size_bytes);
    return data;
}
} // namespace

device::LoadResult NodeDevice::OnResetNode() noexcept
{
    model_.ResetVariables();
    objects_.LoadApplication();
    if (self_test_)
    {
        has_told_test_ = false;
        self_test_->Start();
        TellSelfTest(now_ns_);
    }
    const StartResult result = kernel_.Start(config_, FlowCallback::kOff);
    if (result != StartResult::kStarted)
    {
        const auto reason = static_cast<unsigned>(result);
        report_.Tell(now_ns_, "the kernel refuses this device, reason " + std::to_string(reason) + " of StartResult",
                     "no_start", {{"reason", reason}});
        return device::LoadResult::kFailed;
    }
    for (const runtime::StaticTable& table : model_.StaticTables())
    {
        // What the kernel says of a mapping before its SRDO is configured is not looked at: 13FEh has the last word.
        const auto index = static_cast<std::uint16_t>(kCommunicationBase + table.number);
        static_cast<void>(kernel_.DefineStaticFields({index}, model_.FieldsOf(table)));
    }
    if (store_)
    {
        TellStore(store_->Load(cia301::kApplicationGroup | cia301::kManufacturerGroup));
    }
    has_restarted_ = true;
    return device::LoadResult::kLoaded;
}

device::LoadResult NodeDevice::OnResetCommunication() noexcept
{
    state_ = cia301::NodeState::kInvalid; // Told again, even if it is the same.
    if (services_.node.value != config_.node_id)
    {
        new_node_id_ = services_.node.value;
        return device::LoadResult::kFailed; // Silent until another device has been made.
    }
    objects_.LoadCommunication();
    for (const std::string& refusal : objects_.Refusals())
    {
        report_.Tell(now_ns_, refusal, "refused", {{"text", refusal}});
    }
    if (!IsSafetyLoaded())
    {
        LoadSafety();
    }
    if (store_)
    {
        TellStore(store_->Load(cia301::kCommunicationGroup));
    }
    return device::LoadResult::kLoaded;
}

/// What is wrong with the file is told once, not at each reset.
void NodeDevice::TellStore(const std::string& warning)
{
    if (!warning.empty() && warning != store_warning_)
    {
        report_.Tell(now_ns_, warning, "store", {{"text", warning}});
        store_warning_ = warning;
    }
}

void NodeDevice::FurnishSelfTest()
{
    if (!self_test_)
    {
        return;
    }
    self_test_->AddChannel(*channel_a_);
    self_test_->AddChannel(*channel_b_);
    self_test_->AddKernel(kernel_);
    self_test_->AddPart(static_cast<hal::CanPorts*>(&ports_));
    self_test_->AddPart(static_cast<hal::SafetyOutput*>(&output_));
    self_test_->AddPart(static_cast<hal::Watchdog*>(&watchdog_));
    self_test_->AddPart(static_cast<Application*>(&watch_));
    self_test_->AddConstants(config_, model_);
    const std::uint32_t cycles = config_.diagnostic_interval_us / config_.cycle_us;
    if (!self_test_->Settle(cycles))
    {
        throw cia306::InputError(
            model_.File(), 0U,
            {"the self tests do not fit into the diagnostic interval of " + std::to_string(cycles) + " cycles",
             "a longer one (0x5F00:04), or --no-self-tests"});
    }
}

/// Node-ID: what LSS gave in this run, what it saved, then the command line and the file.
void NodeDevice::FurnishLss(const NodeSettings& settings)
{
    if (!has_lss_)
    {
        return;
    }
    const auto part = [this](const std::uint8_t sub)
    {
        const cia306::Entry* const entry = file_.Find(kIdentity, sub);
        const cia306::ValueResult result =
            (entry == nullptr) ? cia306::ValueResult{} : cia306::ConfiguredValue(*entry, config_.node_id);
        return result.value ? static_cast<std::uint32_t>(result.value->bits) : 0U;
    };
    const std::optional<std::uint8_t> wanted = settings.node_id ? settings.node_id : file_.node_id;
    cia305::LssSettings known{wanted.value_or(cia305::kNoNodeId), {0U}};
    if (store_)
    {
        known = store_->LoadLss(known);
    }
    known.node_id = settings.lss_node_id.value_or(known.node_id);
    const cia305::Identity identity{part(1U), part(2U), part(3U), part(4U)};
    lss_ = std::make_unique<NodeLss>(services_.outbox, identity, known, store_.get());
    services_.lss = &lss_->Slave();
}

/// Writing the same values again would withdraw 13FEh for a moment.
bool NodeDevice::IsSafetyLoaded()
{
    const auto& writes = model_.Writes();
    return std::all_of(writes.begin(), writes.end(),
                       [this, &writes](const runtime::ConfigurationWrite& write)
                       {
                           // Each object counts with the last value that it gets.
                           const auto same = [&write](const runtime::ConfigurationWrite& other)
                           { return other.object.index == write.object.index && other.object.sub == write.object.sub; };
                           const auto last = std::find_if(writes.rbegin(), writes.rend(), same);
                           const ObjectReading reading = kernel_.ReadObject(write.object);
                           return reading.abort == AbortCode::kNone && ToValue(reading.data) == last->value;
                       });
}

void NodeDevice::LoadSafety()
{
    for (const runtime::ConfigurationWrite& write : model_.Writes())
    {
        const AbortCode code = kernel_.WriteObject(write.object, DataOf(write));
        if (code != AbortCode::kNone)
        {
            const std::string text = model_.File() + ":" + std::to_string(write.line) +
                                     ": warning: " + cia306::ObjectName(write.object.index, write.object.sub) +
                                     ": the kernel refuses " + cia306::Hex(write.value, write.size_bytes * 2) +
                                     " with abort code " + runtime::AbortText(code) +
                                     ", expected what 'counterpoint check' finds right";
            report_.Tell(now_ns_, text, "refused", {{"text", text}});
        }
    }
}

/// Directions, times, identifiers and mappings stay as they are until OPERATIONAL is left; the file, a store or a
/// commissioner may have given them. [SRS_NODE_019]
void NodeDevice::FollowConfiguration()
{
    PrepareSending();
    FindInverseFrames();
    application_.Follow(kernel_, model_);
    for (const runtime::SrdoModel& of_file : model_.Srdos())
    {
        // What is as in the file was told at the start.
        const runtime::SrdoModel srdo = ConfiguredSrdo(kernel_, of_file);
        if (!IsSameSrdo(srdo, of_file))
        {
            TellSrdo(report_, now_ns_, config_, srdo);
        }
    }
}

// The shortest refresh time of the producers that the application sends by itself.
void NodeDevice::PrepareSending()
{
    cycles_per_send_ = 0U;
    cycles_to_send_ = 0U;
    for (SlotIndex slot = 0U; slot < model_.Srdos().size(); ++slot)
    {
        const auto index = static_cast<std::uint16_t>(kCommunicationBase + model_.NumberOf(slot));
        const ParametersReply parameters = kernel_.GetParameters({index});
        const bool sends =
            parameters.direction == kDirectionProducer && config_.srdos[slot].form == ProducerForm::kApplicationSends;
        const std::uint32_t cycles = (parameters.refresh_ms * kMicrosecondsPerMillisecond) / config_.cycle_us;
        if (sends && (cycles_per_send_ == 0U || cycles < cycles_per_send_))
        {
            cycles_per_send_ = std::max(cycles, std::uint32_t{1U});
        }
    }
}

// Whose pair an inverse frame completes.
void NodeDevice::FindInverseFrames()
{
    slot_of_.fill(kNoSlot);
    for (SlotIndex slot = 0U; slot < model_.Srdos().size(); ++slot)
    {
        const auto index = static_cast<std::uint16_t>(kCommunicationBase + model_.NumberOf(slot));
        const std::uint32_t identifier = ToValue(kernel_.ReadObject({index, kCobIdSub2}).data);
        const std::uint32_t number = identifier - kFirstSrdoIdentifier;
        if (kernel_.GetParameters({index}).direction == kDirectionConsumer && number < kSrdoIdentifierCount)
        {
            slot_of_.at(number) = slot;
        }
    }
}

// At once after a change, and every refresh time after the last time.
void NodeDevice::SendByApplication()
{
    if (cycles_per_send_ == 0U || device_.State() != cia301::NodeState::kOperational)
    {
        cycles_to_send_ = 0U;
        return;
    }
    const bool has_changed = application_.TakeChange();
    if (cycles_to_send_ != 0U && !has_changed)
    {
        --cycles_to_send_;
        return;
    }
    cycles_to_send_ = cycles_per_send_ - 1U;
    for (SlotIndex slot = 0U; slot < config_.srdo_count; ++slot)
    {
        if (config_.srdos[slot].form == ProducerForm::kApplicationSends)
        {
            const auto index = static_cast<std::uint16_t>(kCommunicationBase + model_.NumberOf(slot));
            static_cast<void>(kernel_.Send({index})); // Consumers among them refuse.
        }
    }
}
} // namespace counterpoint::runtime
