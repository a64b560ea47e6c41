// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_LSS_HPP
#define RUNTIME_NODE_LSS_HPP

#include "canopen/cia305/lss_slave.hpp"
#include "runtime/node/build.hpp"
#include "runtime/node/objects/store.hpp"

namespace counterpoint::runtime
{
/// The LSS slave of a live node. Its bit rate is that of the bus, which the system sets: LSS changes none.
/// [SRS_NODE_015]
class NodeLss final : private cia305::LssDevice
{
  public:
    /// Identity by the file, `node_id` stands for $NODEID in it. Node-ID: what LSS gave in this run, what it saved,
    /// then the command line and the file. `store` null: settings are not kept. Sink and store outlive it. Throws
    /// cia306::InputError.
    NodeLss(cia301::FrameSink& sink, const NodeSettings& settings, const cia306::Device& file, std::uint8_t node_id,
            NodeStore* store);
    NodeLss(const NodeLss&) = delete;
    NodeLss& operator=(const NodeLss&) = delete;

    /// @brief Of the device now, or what it will be at power-on; 0: LSS has given none.
    [[nodiscard]] std::uint8_t NodeId() const noexcept;
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
