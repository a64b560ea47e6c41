// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_MODEL_HPP
#define RUNTIME_DEVICE_MODEL_HPP

#include "canopen/cia306/file/device.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "safety_core/contract/configuration.hpp"
#include "safety_core/kernel/kernel.hpp"
#include "safety_core/kernel/limits.hpp"
#include "safety_core/kernel/object_access.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// One value that a configuring master writes, and the line of the DCF that it comes from.
struct ConfigurationWrite
{
    ObjectAddress object{0U, 0U};
    std::uint32_t value{0U};
    std::uint8_t size_bytes{0U};
    cia306::Place place;
};

/// @brief The communication parameters, 13xxh, of the SRDO with this number.
[[nodiscard]] constexpr CommunicationIndex CommunicationIndexOf(const std::uint8_t number) noexcept
{
    return {static_cast<std::uint16_t>(0x1300U + number)};
}

/// What a DCF says about one SRDO, as far as limits and messages need it.
struct SrdoModel
{
    std::uint8_t number{0U};
    std::uint8_t direction{0U};
    SrdoTimes times{0U, 0U};
    std::uint32_t cob_id_1{0U};
    std::uint32_t cob_id_2{0U};
    std::vector<ObjectAddress> normal_objects; ///< In the order of the mapping.
};

/// The table of a static mapping as the kernel gets it. It is as long as a mapping can be: where a bit of its count
/// flips, the count still names entries that exist.
struct StaticTable
{
    std::array<std::uint32_t, kMaxMapEntries> entries{};
    std::uint8_t number{0U}; ///< Number of the SRDO.
    std::uint8_t count{0U};  ///< Number of entries.
    std::size_t normal{0U};  ///< Where its fields begin in DeviceModel::Memory().
    std::size_t inverse{0U};
    cia306::Place place;
};

/// A pair of mappable variables as the mapping of an SRDO joins them.
struct VariablePair
{
    std::size_t normal{0U}; ///< Indices into DeviceModel::Objects().
    std::size_t inverse{0U};
    std::uint8_t srdo{0U};       ///< Number of the SRDO.
    std::uint32_t first_bit{0U}; ///< Place of the pair in the data of the SRDO; entries before it may be dummies.
    bool is_consumer{false};
};

/// Whether a file must describe an SRDO.
enum class SafetyNeed : std::uint8_t
{
    kInvalid = 0U,
    kRequired = 1U,
    /// A device with services: without any object of 1300h to 13FFh the kernel gets one SRDO that is off, and of the
    /// mappable objects it gets those that are for SRDOs; the others are the dictionary's. [SRS_NODE_016]
    kOptional = 2U,
};

struct SourceVariable;
struct StaticMapping;

/// A device built from its DCF. It owns the memory of the mappable variables and everything that DeviceConfig points
/// to, so it cannot be moved or copied. [SRS_SIM_002]
class DeviceModel
{
  public:
    /// @brief Reads the DCF. Throws cia306::InputError for a file that cannot be simulated.
    DeviceModel(const std::string& file, std::optional<std::uint8_t> node_id, SafetyNeed need = SafetyNeed::kRequired);

    DeviceModel(const DeviceModel&) = delete;
    DeviceModel& operator=(const DeviceModel&) = delete;

    /// @brief Path of the DCF.
    [[nodiscard]] const std::string& File() const noexcept;
    /// @brief The description for the kernel.
    [[nodiscard]] const DeviceConfig& Config() const noexcept;
    /// @brief The SRDOs of the DCF; none for a plain device.
    [[nodiscard]] const std::vector<SrdoModel>& Srdos() const noexcept;
    /// @brief The mapped pairs of variables.
    [[nodiscard]] const std::vector<VariablePair>& Pairs() const noexcept;
    /// @brief The mappable objects, ascending.
    [[nodiscard]] const std::vector<MappableObject>& Objects() const noexcept;
    /// @brief The static mappings.
    [[nodiscard]] const std::vector<StaticTable>& StaticTables() const noexcept;
    /// @brief Where the variables of this static mapping lie. [SRS_SIM_009]
    [[nodiscard]] StaticFields FieldsOf(const StaticTable& table) noexcept;
    /// @brief Where the file has its diagnostic interval (5F00h:04); line 0: it has none.
    [[nodiscard]] cia306::Place IntervalPlace() const noexcept
    {
        return interval_place_;
    }
    /// @brief The values that a configuring master writes, in its order.
    [[nodiscard]] const std::vector<ConfigurationWrite>& Writes() const noexcept;

    /// @brief Slot of an SRDO; nothing if the device does not have it.
    [[nodiscard]] std::optional<SlotIndex> SlotOf(std::uint8_t number) const noexcept;
    /// @brief Number of the SRDO in a slot that exists, as the DCF has it; 0 for the one SRDO of a plain device.
    [[nodiscard]] std::uint8_t NumberOf(SlotIndex slot) const noexcept;
    /// @brief The mapped pair whose normal object has this address; null: there is none.
    [[nodiscard]] const VariablePair* PairOf(const ObjectAddress& normal) const noexcept;

    /// @brief From now on inverse frames use a second controller, unless the DCF names the controllers. Then it is
    /// another device than that of the DCF, so no digest is expected. [SRS_SIM_036, SRS_SIM_009]
    void UseTwoControllers() noexcept;
    /// @brief 1 or 2.
    [[nodiscard]] std::uint32_t ControllerCount() const noexcept;
    /// @brief The memory of the variables, in which faults flip bits; so are the two tables below. [SRS_SIM_035]
    [[nodiscard]] std::vector<std::uint8_t>& Memory() noexcept;
    /// @brief The mappable objects.
    [[nodiscard]] std::vector<MappableObject>& ObjectTable() noexcept;
    /// @brief The setups of the SRDOs.
    [[nodiscard]] std::vector<SrdoSetup>& SetupTable() noexcept;
    /// @brief The table of an SRDO; null: its mapping is dynamic.
    [[nodiscard]] StaticTable* StaticTableOf(std::uint8_t number) noexcept;

    /// @brief Power-on: all variables get their values of the DCF.
    void ResetVariables() noexcept;

  private:
    void LayOut(const std::vector<SourceVariable>& variables, const std::vector<StaticMapping>& maps);
    void Place(const std::vector<std::size_t>& variables, const std::vector<SourceVariable>& source);
    void JoinTables() noexcept;
    /// @brief Mapped by an SRDO or made for one: an object that a file only marks as process data is not the kernel's.
    void KeepSafetyObjects(const cia306::Device& device);

    std::string file_;
    std::vector<std::uint8_t> memory_;
    std::vector<std::uint8_t> initial_;
    std::vector<MappableObject> objects_;
    std::vector<SrdoSetup> setups_;
    std::vector<StaticTable> tables_;
    std::vector<SrdoModel> srdos_;
    std::vector<VariablePair> pairs_;
    std::vector<ObjectAddress> addresses_; ///< Of the objects, and numbers of the setups: for people, whatever flips.
    std::vector<std::uint8_t> numbers_;
    std::vector<ConfigurationWrite> writes_;
    cia306::Place interval_place_{};
    DeviceConfig config_{};
};

/// @brief The value of a write as the bytes that are sent.
[[nodiscard]] ObjectData DataOf(const ConfigurationWrite& write);
/// @brief The error that says that the kernel refuses a value of the file.
[[nodiscard]] cia306::InputError RefusalOf(const DeviceModel& model, const ConfigurationWrite& write, AbortCode code);

/// @brief An abort code as text: "0609 0030h".
[[nodiscard]] std::string AbortText(AbortCode code);
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_MODEL_HPP
