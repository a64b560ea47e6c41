// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/device.hpp"

#include "runtime/node/srdo_line.hpp"

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
} // namespace

void NodeDevice::OnStart() noexcept
{
    if (self_test_)
    {
        has_told_test_ = false;
        self_test_->Start();
        TellSelfTest(now_ns_);
    }
}

void NodeDevice::OnNoStart(const StartResult result) noexcept
{
    const auto reason = static_cast<unsigned>(result);
    report_.Tell(now_ns_, "the kernel refuses this device, reason " + std::to_string(reason) + " of StartResult",
                 "no_start", {{"reason", reason}});
}

void NodeDevice::OnResetCommunication(const std::vector<std::string>& refusals) noexcept
{
    state_ = cia301::NodeState::kInvalid; // Told again, even if it is the same.
    for (const std::string& refusal : refusals)
    {
        report_.Tell(now_ns_, refusal, "refused", {{"text", refusal}});
    }
}

void NodeDevice::OnLoaded(const std::uint8_t groups) noexcept
{
    has_restarted_ = has_restarted_ || (groups & cia301::kApplicationGroup) != 0U;
    if (store_)
    {
        TellStore(store_->Load(groups));
    }
}

void NodeDevice::OnRefused(const ConfigurationWrite& write, const AbortCode code) noexcept
{
    const std::string text = model_.File() + ":" + std::to_string(write.line) +
                             ": warning: " + cia306::ObjectName(write.object.index, write.object.sub) +
                             ": the kernel refuses " + cia306::Hex(write.value, write.size_bytes * 2) +
                             " with abort code " + runtime::AbortText(code) +
                             ", expected what 'counterpoint check' finds right";
    report_.Tell(now_ns_, text, "refused", {{"text", text}});
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
    self_test_->AddKernel(assembly_.Core());
    self_test_->AddPart(static_cast<hal::CanPorts*>(&ports_));
    self_test_->AddPart(static_cast<hal::SafetyOutput*>(&output_));
    self_test_->AddPart(static_cast<hal::Watchdog*>(&watchdog_));
    self_test_->AddPart(&assembly_.Told());
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
    lss_ = std::make_unique<NodeLss>(assembly_.Services().outbox, identity, known, store_.get());
    assembly_.Services().lss = &lss_->Slave();
}

/// Directions, times, identifiers and mappings stay as they are until OPERATIONAL is left; the file, a store or a
/// commissioner may have given them. [SRS_NODE_019]
void NodeDevice::FollowConfiguration()
{
    cycles_per_send_ = assembly_.CyclesPerSend();
    cycles_to_send_ = 0U;
    FindInverseFrames();
    application_.Follow(assembly_.Core(), model_);
    for (const runtime::SrdoModel& of_file : model_.Srdos())
    {
        // What is as in the file was told at the start.
        const runtime::SrdoModel srdo = ConfiguredSrdo(assembly_.Core(), of_file);
        if (!IsSameSrdo(srdo, of_file))
        {
            TellSrdo(report_, now_ns_, config_, srdo);
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
        const std::uint32_t identifier = ToValue(assembly_.Core().ReadObject({index, kCobIdSub2}).data);
        const std::uint32_t number = identifier - kFirstSrdoIdentifier;
        if (assembly_.Core().GetParameters({index}).direction == kDirectionConsumer && number < kSrdoIdentifierCount)
        {
            slot_of_.at(number) = slot;
        }
    }
}

// At once after a change, and every refresh time after the last time.
void NodeDevice::SendByApplication()
{
    if (cycles_per_send_ == 0U || assembly_.Device().State() != cia301::NodeState::kOperational)
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
    assembly_.SendAll();
}
} // namespace counterpoint::runtime
