// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MONITOR_NETWORK_HPP
#define CANOPEN_MONITOR_NETWORK_HPP

#include "canopen/monitor/srdo_watch.hpp"

#include "canopen/cia306/file/device.hpp"
#include "canopen/cia306/safety/device_parameters.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::monitor
{
/// One entry of a mapping.
struct MappedField
{
    std::uint16_t index{0U};
    std::uint8_t sub{0U};
    std::uint8_t bits{0U};
};

/// A PDO that a DCF switches on.
struct PdoModel
{
    std::uint32_t identifier{0U};
    std::size_t node{0U};
    std::uint16_t number{0U}; ///< From 1.
    bool is_transmit{false};
    std::vector<MappedField> fields;
};

/// A device of the bus.
struct NodeModel
{
    std::string name; ///< NodeName, else the name of the file.
    std::uint8_t id{0U};
    std::uint32_t emergency_id{0U}; ///< 80h + node-ID where the file has none that a device takes.
    cia306::Device device;
    cia306::SafetyConfiguration safety;
    std::vector<cia306::SrdoConfiguration> active; ///< Those of `safety` that are on; none while 13FEh is not A5h.
    cia306::DeviceParameters parameters;
};

/// An SRDO at one of its ends.
struct SrdoEnd
{
    std::size_t node{0U};
    std::uint8_t number{0U};
};

/// What is watched: a consumer, or a producer that none of the files consumes.
struct WatchModel
{
    WatchSetup setup;
    std::optional<SrdoEnd> producer;
    std::optional<SrdoEnd> consumer;
    std::vector<MappedField> fields; ///< Normal data.
};

/// A device file, with a node-ID where it has to have another one.
struct NodeFile
{
    std::string path;
    std::optional<std::uint8_t> node_id;
};

/// The devices of a bus, read from their DCFs, and the SRDOs to be watched. Throws InputError for files that cannot be
/// used. [SRS_MON_004, SRS_MON_021]
class Network
{
  public:
    /// @brief `sct` is that of SRDOs without a consumer; else twice the refresh time. [SRS_MON_007]
    Network(const std::vector<NodeFile>& files, std::optional<Time> sct);

    /// @brief The devices, in the order of the files.
    [[nodiscard]] const std::vector<NodeModel>& Nodes() const noexcept
    {
        return nodes_;
    }
    /// @brief The SRDOs to be watched.
    [[nodiscard]] const std::vector<WatchModel>& Watches() const noexcept
    {
        return watches_;
    }
    /// @brief The PDOs that the DCFs switch on.
    [[nodiscard]] const std::vector<PdoModel>& Pdos() const noexcept
    {
        return pdos_;
    }
    /// @brief The node with this ID, or null.
    [[nodiscard]] const NodeModel* Find(std::uint8_t id) const noexcept;
    /// @brief "sensor", or "node 5".
    [[nodiscard]] std::string NameOf(std::uint8_t id) const;
    /// @brief "sensor SRDO 1 -> controller SRDO 2"
    [[nodiscard]] std::string NameOf(const WatchModel& watch) const;

  private:
    void AddNode(const NodeFile& file);
    void AddPdos(std::size_t node);
    void AddPdo(std::size_t node, std::uint16_t communication, std::uint16_t mapping, PdoModel pdo);
    void AddWatches(std::optional<Time> sct);
    [[nodiscard]] std::optional<std::uint64_t> Number(const NodeModel& node, std::uint16_t index,
                                                      std::uint8_t sub) const;

    std::vector<NodeModel> nodes_;
    std::vector<WatchModel> watches_;
    std::vector<PdoModel> pdos_;
};
} // namespace counterpoint::monitor

#endif // CANOPEN_MONITOR_NETWORK_HPP
