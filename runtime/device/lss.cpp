// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/lss.hpp"

#include <utility>

namespace counterpoint::runtime
{
namespace
{
cia305::Identity IdentityOf(const cia306::Device& file, const std::uint8_t node_id)
{
    constexpr std::uint16_t kIdentity = 0x1018U;
    const auto part = [&file, node_id](const std::uint8_t sub)
    {
        const cia306::Entry* const entry = file.Find(kIdentity, sub);
        const cia306::ValueResult result =
            (entry == nullptr) ? cia306::ValueResult{} : cia306::ConfiguredValue(*entry, node_id);
        return result.value ? static_cast<std::uint32_t>(result.value->bits) : 0U;
    };
    return {part(1U), part(2U), part(3U), part(4U)};
}
} // namespace

DeviceLss::DeviceLss(cia301::FrameSink& sink, const cia306::Device& file, const cia305::LssSettings& settings,
                     const std::uint8_t node_id, KeepLss keep)
    : keep_(std::move(keep)), parts_{sink, *this, IdentityOf(file, node_id), settings}, slave_(std::in_place, parts_)
{
}

void DeviceLss::PowerOff() noexcept
{
    slave_.emplace(parts_);
}

std::uint8_t DeviceLss::NodeId() const noexcept
{
    const std::uint8_t active = slave_->ActiveNodeId();
    const std::uint8_t coming = slave_->Settings().node_id; // Before power-on.
    const std::uint8_t node_id = (active == cia305::kNoNodeId) ? coming : active;
    return (node_id == cia305::kNoNodeId) ? std::uint8_t{0U} : node_id;
}

bool DeviceLss::IsSupported(const cia305::BitTiming timing) noexcept
{
    static_cast<void>(timing);
    return false;
}

cia305::LssStored DeviceLss::Store(const cia305::LssSettings& settings) noexcept
{
    return keep_ ? keep_(settings) : cia305::LssStored::kUnsupported;
}

void DeviceLss::SwitchTo(const cia305::BitTiming timing) noexcept
{
    static_cast<void>(timing);
}
} // namespace counterpoint::runtime
