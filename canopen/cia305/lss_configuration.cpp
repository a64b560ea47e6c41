// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Node-ID, bit timing, store and inquiry of the LSS slave.
#include "canopen/cia305/lss_slave.hpp"

namespace counterpoint::cia305
{
namespace
{

constexpr std::uint8_t kConfigureNodeId = 0x11U;
constexpr std::uint8_t kConfigureTiming = 0x13U;
constexpr std::uint8_t kActivateTiming = 0x15U;
constexpr std::uint8_t kStore = 0x17U;
constexpr std::uint8_t kInquireVendor = 0x5AU;
constexpr std::uint8_t kInquireNodeId = 0x5EU;
constexpr std::uint32_t kDone = 0U;
constexpr std::uint32_t kOutOfRange = 1U; ///< Of a node-ID or bit timing; of a store: not supported.
constexpr std::uint32_t kMediaError = 2U;
constexpr std::uint8_t kStandardTable = 0U;
constexpr std::uint8_t kLastNode = 127U;
constexpr std::uint32_t kUsPerMs = 1000U;

} // namespace

/// Commands that only a slave in configuration obeys.
void LssSlave::Configure(const CanFrame& frame, const Instant now) noexcept
{
    const std::uint8_t command = frame.data[0];
    if (command == kConfigureNodeId)
    {
        ConfigureNodeId(frame.data[1]);
    }
    else if (command == kConfigureTiming)
    {
        ConfigureTiming(frame.data[1], frame.data[2]);
    }
    else if (command == kActivateTiming)
    {
        ActivateTiming(static_cast<std::uint16_t>(frame.data[1] | (frame.data[2] << 8U)), now);
    }
    else if (command == kStore)
    {
        is_storing_ = true;
        FinishStore();
    }
    else if ((command >= kInquireVendor) && (command <= kInquireNodeId))
    {
        Inquire(command);
    }
}

void LssSlave::OnCycle(const Moment& moment) noexcept
{
    const std::uint32_t since_us = moment.now.us - switched_at_.us;
    if ((switching_ == Switching::kBefore) && (since_us >= delay_us_))
    {
        parts_.device.SwitchTo(pending_.timing);
        switching_ = Switching::kAfter;
        switched_at_ = moment.now;
    }
    else if ((switching_ == Switching::kAfter) && (since_us >= delay_us_))
    {
        switching_ = Switching::kNone;
    }
    if (is_storing_)
    {
        FinishStore();
    }
    Flush();
}

void LssSlave::ConfigureNodeId(const std::uint8_t node_id) noexcept
{
    const bool is_node = (node_id >= 1U) && (node_id <= kLastNode);
    const bool is_taken = is_node || (node_id == kNoNodeId);
    pending_.node_id = is_taken ? node_id : pending_.node_id;
    Answer(kConfigureNodeId, is_taken ? kDone : kOutOfRange);
}

void LssSlave::ConfigureTiming(const std::uint8_t table, const std::uint8_t index) noexcept
{
    const bool is_taken = (table == kStandardTable) && parts_.device.IsSupported(BitTiming{index});
    pending_.timing = is_taken ? BitTiming{index} : pending_.timing;
    Answer(kConfigureTiming, is_taken ? kDone : kOutOfRange);
}

/// Silence for the delay, the change, silence for the delay again: so all nodes have changed before one sends.
void LssSlave::ActivateTiming(const std::uint16_t delay_ms, const Instant now) noexcept
{
    delay_us_ = delay_ms * kUsPerMs;
    switched_at_ = now;
    switching_ = Switching::kBefore;
}

void LssSlave::FinishStore() noexcept
{
    const LssStored stored = parts_.device.Store(pending_);
    is_storing_ = (stored == LssStored::kPending);
    if (stored == LssStored::kDone)
    {
        Answer(kStore, kDone);
    }
    else if (stored == LssStored::kUnsupported)
    {
        Answer(kStore, kOutOfRange);
    }
    else if (!is_storing_)
    {
        Answer(kStore, kMediaError);
    }
}

void LssSlave::Inquire(const std::uint8_t command) noexcept
{
    const bool is_node = (command == kInquireNodeId);
    const std::uint32_t part = static_cast<std::uint32_t>(command) - kInquireVendor;
    Answer(command, is_node ? std::uint32_t{active_node_id_} : AddressPart(part));
}

} // namespace counterpoint::cia305
