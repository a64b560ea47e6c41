// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_LSS_HPP
#define RUNTIME_NODE_LSS_HPP

#include "canopen/cia305/lss_slave.hpp"
#include "runtime/node/objects/store.hpp"

namespace counterpoint::runtime
{
/// The LSS slave of a live node. Its bit rate is that of the bus, which the system sets: LSS changes none.
/// [SRS_NODE_015]
class NodeLss final : private cia305::LssDevice
{
  public:
    /// `store` null: settings are not kept. All given outlive it.
    NodeLss(cia301::FrameSink& sink, const cia305::Identity& identity, const cia305::LssSettings& settings,
            NodeStore* store);
    NodeLss(const NodeLss&) = delete;
    NodeLss& operator=(const NodeLss&) = delete;

    [[nodiscard]] cia305::LssSlave& Slave() noexcept
    {
        return slave_;
    }

  private:
    [[nodiscard]] bool IsSupported(cia305::BitTiming timing) noexcept override;
    [[nodiscard]] cia305::LssStored Store(const cia305::LssSettings& settings) noexcept override;
    void SwitchTo(cia305::BitTiming timing) noexcept override;

    NodeStore* store_;
    cia305::LssSlave slave_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_LSS_HPP
