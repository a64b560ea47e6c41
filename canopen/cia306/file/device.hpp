// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_FILE_DEVICE_HPP
#define CANOPEN_CIA306_FILE_DEVICE_HPP

#include "canopen/cia306/file/data_type.hpp"
#include "canopen/cia306/file/value.hpp"
#include "canopen/cia306/text/finding.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
/// Text of a key and its place; no text and no place where the key is missing or empty.
struct Text
{
    std::string text;
    Place place;

    /// Whether there is a text.
    [[nodiscard]] bool IsSet() const noexcept
    {
        return !text.empty();
    }
};

/// Kinds of objects, by their codes in CiA 306.
enum class ObjectType : std::uint8_t
{
    kNull = 0U,
    kDomain = 2U,
    kDeftype = 5U,
    kDefstruct = 6U,
    kVar = 7U,
    kArray = 8U,
    kRecord = 9U,
};

/// Who may read or write an entry.
enum class Access : std::uint8_t
{
    kUnknown = 0U,
    kReadOnly = 1U,
    kWriteOnly = 2U,
    kReadWrite = 3U,
    kReadWriteInput = 4U,  ///< rwr: process data that the device sends.
    kReadWriteOutput = 5U, ///< rww: process data that the device receives.
    kConstant = 6U,
};

/// A data element: a variable (sub-index 0 of its object), or one sub-index of an array or record.
struct Entry
{
    std::uint16_t index{0U};
    std::uint8_t sub{0U};
    std::string name;
    std::uint16_t data_type{0U}; ///< 0: the file does not tell.
    DataType type{};             ///< What `data_type` stands for in this file. [SRS_EDS_027]
    Access access{Access::kUnknown};
    bool is_pdo_mappable{false};
    std::optional<bool> is_srdo_mappable;       ///< SRDOMapping, where the key is there.
    std::optional<std::uint32_t> inverted_srad; ///< Index * 256 + sub-index of the inverse object.
    Place inverted_srad_place;
    Text default_value;
    Text parameter_value;
    Text low_limit;
    Text high_limit;
    Place place;
    Place type_place;                ///< Of the value of DataType, else of the section.
    Place access_place;              ///< Of the value of AccessType, else of the section.
    std::string section;             ///< Where its values are written.
    bool is_download_refused{false}; ///< ObjFlags, bit 0: who downloads a configuration leaves it alone. [SRS_MGR_322]
    bool is_safety{false};           ///< A safety object of this device. [SRS_EDS_670]
    Text download_file;              ///< DownloadFile: a file that holds its value.
    bool is_compact{false}; ///< Made from CompactSubObj: its parameter value is key "sub" of section [indexValue].

    /// ParameterValue where the file has one, else DefaultValue. [SRS_EDS_010]
    [[nodiscard]] const Text& Configured() const noexcept;
    /// Whether nobody can write it over the bus (const or ro).
    [[nodiscard]] bool IsFixed() const noexcept;
    /// Whether a PDO may send it: PDOMapping=1, and it is no output.
    [[nodiscard]] bool IsInTpdo() const noexcept;
    /// Whether a PDO may receive it: PDOMapping=1, and it is no input and no safety object. [SRS_EDS_730]
    [[nodiscard]] bool IsInRpdo() const noexcept;
    /// Place of the configured value, else of the section.
    [[nodiscard]] Place ValuePlace() const noexcept;
};

/// An object of the dictionary with its entries by sub-index.
struct Object
{
    std::uint16_t index{0U};
    std::string name;
    ObjectType type{ObjectType::kVar};
    std::uint16_t data_type{0U};     ///< For a record: index of its DEFSTRUCT; 0 where the file does not tell.
    bool is_download_refused{false}; ///< All of its entries are.
    std::map<std::uint8_t, Entry> entries;
    Place place;
    std::string section;
};

/// What an EDS or DCF says about a device. All numbers are checked; values of entries are kept as text, because they
/// may need the node-ID.
struct Device
{
    std::string file;
    std::map<std::uint16_t, Object> objects;
    std::optional<std::uint8_t> node_id; ///< Node-ID of the commissioning section, 1 to 127.
    bool is_node_id_refused{false};      ///< NodeID is there and is none; the reader has warned.
    Place commissioning_place;
    std::optional<bool> is_safety_supported;
    bool is_lss_supported{false}; ///< LSS_Supported.
    Place device_info_place;
    Place mandatory_place; ///< Of [MandatoryObjects]; the file as a whole where there is none.
    /// Granularity of DeviceInfo, where it is one that a Counterpoint device can have.
    std::optional<std::uint8_t> granularity_bits;
    std::set<std::uint16_t> dummies;        ///< Data types that DummyUsage allows to be mapped.
    std::map<std::uint16_t, Place> missing; ///< Objects that a list names and no section describes; where it does.
    std::vector<Finding> warnings;          ///< In the order of the lines.

    /// Whether this is an object of CANopen Safety, whose values the check of the safety configuration judges and not
    /// the reader: 1300h to 13FFh, and of a safety device 5F00h to 5F05h (docs/device_objects.md). A device without any
    /// of the former, also without one that is only listed, and without CANopenSafetySupported is none: there the
    /// latter are objects of its maker. [SRS_EDS_670]
    [[nodiscard]] bool IsSafetyObject(std::uint16_t index) const;
    /// The object with this index; null: the file has none.
    [[nodiscard]] const Object* Find(std::uint16_t index) const;
    /// The entry at this index and sub-index; null: the file has none.
    [[nodiscard]] const Entry* Find(std::uint16_t index, std::uint8_t sub) const;
};

/// Whether a device can have this granularity: 1, 8, 16, 32 or 64 bits.
[[nodiscard]] bool IsGranularity(std::uint64_t bits) noexcept;

/// The configured value of an entry, read by its data type; for an entry without a value the result has a problem.
[[nodiscard]] ValueResult ConfiguredValue(const Entry& entry, std::optional<std::uint8_t> node_id);

/// The configured value as every command takes it: nothing where there is none, or one that does not fit its type, of
/// which the reader has warned. Throws an InputError for `file` where only the node-ID is missing. [SRS_EDS_032]
[[nodiscard]] std::optional<Value> UsableValue(const std::string& file, const Entry& entry,
                                               std::optional<std::uint8_t> node_id);

/// The configured value; throws an InputError for `file` where it has a problem.
[[nodiscard]] Value RequiredValue(const std::string& file, const Entry& entry, std::optional<std::uint8_t> node_id);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_FILE_DEVICE_HPP
