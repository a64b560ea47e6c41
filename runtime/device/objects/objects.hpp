// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_OBJECTS_OBJECTS_HPP
#define RUNTIME_DEVICE_OBJECTS_OBJECTS_HPP

#include "canopen/cia301/dictionary/dictionary.hpp"
#include "canopen/cia301/store/stored_parts.hpp"
#include "canopen/cia306/file/device.hpp"
#include "canopen/device/services.hpp"
#include "runtime/device/objects/hooks.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// @brief Highest sub-index of a list of the file; 0: it has none.
[[nodiscard]] std::uint8_t LastSubOf(const cia306::Device& file, std::uint16_t index);

/// Room of a DOMAIN that can be written, in bytes, where nobody says otherwise, and the most that may be asked for.
constexpr std::uint32_t kDomainBytes = 8192U;
constexpr std::uint32_t kMostDomainBytes = 16U * 1024U * 1024U;

/// The objects of an EDS or DCF that are not the kernel's, as a table for a dictionary. It owns their values, so it
/// cannot be moved or copied. [SRS_NODE_001]
class DeviceObjects final : public cia301::NodeDefaults
{
  public:
    /// Whether an object is kept by the kernel.
    using IsKernels = std::function<bool(std::uint16_t index, std::uint8_t sub)>;
    /// Finds the hook of an object that belongs to an optional service; null: the object belongs to none.
    using FindHook = std::function<cia301::NumberHook*(std::uint16_t index)>;

    /// A DOMAIN that can be written has room for `domain_bytes`, and for its value in the file where that is longer.
    /// Throws cia306::InputError for a multiplexed PDO. [SRS_NODE_040]
    DeviceObjects(const cia306::Device& device, std::uint8_t node_id, const IsKernels& is_kernels,
                  std::uint32_t domain_bytes);
    DeviceObjects(const DeviceObjects&) = delete;
    DeviceObjects& operator=(const DeviceObjects&) = delete;

    /// @brief The table. It does not change, but for the hooks that Connect sets.
    [[nodiscard]] const cia301::EntryTable& Table() const noexcept;
    /// @brief The room that the services of this device need; owned here.
    [[nodiscard]] device::ServiceRooms Rooms() noexcept;
    /// @brief From now on the objects of services lead to the services, and 1010h and 1011h to `store`; null: there is
    /// no store. What no service has keeps its value here. [SRS_NODE_037, SRS_NODE_038]
    void Connect(device::Services& services, const FindHook& further, cia301::NumberHook* store) noexcept;
    /// @brief Sets all objects from 2000h on to the values of the file.
    void LoadApplication() noexcept;
    /// @brief Sets 1000h to 1FFFh to the values of the file; services get theirs by their hooks.
    void LoadCommunication() noexcept;
    /// @brief Whether this is the value of an entry that the file writes with $NODEID. [SRS_NODE_240]
    [[nodiscard]] bool IsNodeDefault(std::uint32_t number, const cia301::Bytes& value) const noexcept override;
    /// @brief Values of the file that a service refused at the last LoadCommunication, and values and limits that their
    /// data type cannot have, which are left out.
    [[nodiscard]] const std::vector<cia306::Finding>& Refusals() const noexcept;

    /// @brief Values of the file that the services have not: they go with other values of it, such as those of a PDO
    /// that the device has turned off because its mapping does not hold; but for those objects that got their value
    /// from elsewhere. Objects of services with one identifier are told, too. Call it after the configuration.
    /// [SRS_NODE_017, SRS_NODE_030, SRS_NODE_050]
    [[nodiscard]] std::vector<cia306::Finding>
    NotTaken(const std::function<bool(const ObjectAddress&)>& is_replaced) const;

  private:
    /// A value and where it goes.
    struct Stored
    {
        std::size_t entry{0U};
        std::vector<std::uint8_t> value;
        cia306::Place place;
        cia306::Place type_place; ///< Of its data type.
        std::uint32_t type_bytes{0U};
        bool is_configured{false}; ///< The file gives it.
        bool is_of_node{false};    ///< The file gives it with $NODEID.
    };

    /// The hooks of an object whose value is kept elsewhere.
    struct Keeper
    {
        cia301::ReadHook* read;
        cia301::WriteHook* write;
    };

    void Append(const cia306::Object& object, const cia306::Entry& source, std::uint8_t node_id);
    [[nodiscard]] Keeper KeeperOf(const cia301::Entry& entry, device::Services& services, const FindHook& further,
                                  cia301::NumberHook* store);
    void AppendPdos(const cia306::Device& device);
    [[nodiscard]] cia301::PdoMap MapOf(const cia306::Device& device, std::uint16_t index);
    void SetValue(const cia306::Entry& source, std::uint8_t node_id);
    void SetRoom(cia301::Entry& entry, const cia306::Entry& source);
    void SetLimits(cia301::Entry& entry, const cia306::Entry& source, std::uint8_t node_id);
    void Load(const Stored& stored) noexcept;
    [[nodiscard]] std::string ReasonOf(const cia301::Entry& entry, const std::vector<std::uint8_t>& value) const;
    void AddShared(std::vector<cia306::Finding>& findings,
                   const std::function<bool(const ObjectAddress&)>& is_replaced) const;
    void LeaveOut(const cia306::Entry& source, const cia306::Text& text, const cia306::Problem& problem);

    std::string file_;
    std::size_t domain_bytes_;
    std::vector<cia301::Entry> entries_;
    std::vector<Stored> stored_;
    std::deque<std::vector<std::uint8_t>> memory_;
    std::deque<std::uint32_t> lengths_;
    std::deque<cia301::ValueLimits> limits_;
    std::vector<cia301::SupervisedNode> supervised_;
    std::vector<cia301::Tpdo> tpdos_;
    std::vector<cia301::Rpdo> rpdos_;
    std::deque<std::vector<cia301::PdoField>> fields_;
    std::vector<std::uint8_t> sdo_buffer_;
    std::vector<cia306::Finding> left_out_; ///< What the file says and its data type cannot have.
    std::vector<cia306::Finding> refusals_;
    cia301::EntryTable table_{nullptr, 0U};
    const device::Services* services_{nullptr}; ///< Set by Connect.
    FixedHook fixed_{table_, cia301::SdoAbort::kLocalControl};
    FixedHook count_{table_, cia301::SdoAbort::kReadOnly};
    NoStoreHook no_store_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_OBJECTS_OBJECTS_HPP
