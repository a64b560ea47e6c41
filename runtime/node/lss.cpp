// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/lss.hpp"

namespace counterpoint::runtime
{
NodeLss::NodeLss(cia301::FrameSink& sink, const cia305::Identity& identity, const cia305::LssSettings& settings,
                 NodeStore* const store)
    : store_(store), slave_({sink, *this, identity, settings})
{
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
