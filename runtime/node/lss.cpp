// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/lss.hpp"

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

cia305::LssSettings SettingsOf(const NodeSettings& settings, const cia306::Device& file, NodeStore* const store)
{
    const std::optional<std::uint8_t> wanted = settings.node_id ? settings.node_id : file.node_id;
    cia305::LssSettings known{wanted.value_or(cia305::kNoNodeId), {0U}};
    if (store != nullptr)
    {
        known = store->LoadLss(known);
    }
    known.node_id = settings.lss_node_id.value_or(known.node_id);
    return known;
}
} // namespace

NodeLss::NodeLss(cia301::FrameSink& sink, const NodeSettings& settings, const cia306::Device& file,
                 const std::uint8_t node_id, NodeStore* const store)
    : store_(store), slave_({sink, *this, IdentityOf(file, node_id), SettingsOf(settings, file, store)})
{
}

std::uint8_t NodeLss::NodeId() const noexcept
{
    const std::uint8_t active = slave_.ActiveNodeId();
    const std::uint8_t coming = slave_.Settings().node_id; // Before power-on.
    const std::uint8_t node_id = (active == cia305::kNoNodeId) ? coming : active;
    return (node_id == cia305::kNoNodeId) ? std::uint8_t{0U} : node_id;
}

bool NodeLss::IsSupported(const cia305::BitTiming timing) noexcept
{
    static_cast<void>(timing);
    return false;
}

cia305::LssStored NodeLss::Store(const cia305::LssSettings& settings) noexcept
{
    return (store_ == nullptr) ? cia305::LssStored::kUnsupported : store_->Keep(settings);
}

void NodeLss::SwitchTo(const cia305::BitTiming timing) noexcept
{
    static_cast<void>(timing);
}
} // namespace counterpoint::runtime
