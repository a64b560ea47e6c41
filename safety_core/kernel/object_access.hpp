// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_OBJECT_ACCESS_HPP
#define SAFETY_CORE_KERNEL_OBJECT_ACCESS_HPP

#include "safety_core/contract/configuration.hpp"

#include <cstdint>

namespace counterpoint
{

/// SDO abort codes that the kernel returns; kNone is success. [SRS_CFG_040, SRS_CFG_041, SRS_CFG_042, SRS_CFG_043,
/// SRS_CFG_044, SRS_CFG_045, SRS_CFG_046, SRS_CFG_047, SRS_CFG_340, SRS_CFG_341, SRS_CFG_342]
enum class AbortCode : std::uint32_t
{
    kNone = 0U,
    kUnsupportedAccess = 0x06010000U, ///< Mapping write while the SRDO is on or the map count is not 0.
    kReadOnly = 0x06010002U,
    kObjectUnknown = 0x06020000U,
    kNotMappable = 0x06040041U,
    kMapTooLong = 0x06040042U,   ///< Over 64 bits, odd count.
    kIncompatible = 0x06040043U, ///< A5h refused.
    kLengthMismatch = 0x06070010U,
    kSubUnknown = 0x06090011U,
    kValueRange = 0x06090030U,
    kGeneral = 0x08000000U,
    kDeviceState = 0x08000022U, ///< OPERATIONAL.
};

/// Number of an SRDO, 1 to 64; 0 is none.
struct SrdoNumber
{
    std::uint32_t value;
};

struct ObjectAddress
{
    std::uint16_t index;
    std::uint8_t sub;
};

/// An address as one number, whose order is that of the table of objects: index * 256 + sub-index. A mapping entry is a
/// key and a length below it.
struct ObjectKey
{
    std::uint32_t value;
};
[[nodiscard]] inline ObjectKey KeyOf(const ObjectAddress& address) noexcept
{
    return ObjectKey{(static_cast<std::uint32_t>(address.index) << 8U) | address.sub};
}

/// Bytes of an object in little-endian order.
struct ObjectData
{
    std::uint8_t bytes[kMaxPayloadBytes]; // MISRA D-001
    std::uint8_t size_bytes;
};

struct ObjectReading
{
    AbortCode abort;
    ObjectData data; ///< Only with kNone.
};

/// What an object of 1300h to 13FFh, or a mappable variable, is.
enum class ObjectKind : std::uint8_t
{
    kInvalid = 0U,       ///< No such object or sub-index, see `refusal`.
    kConstant = 2U,      ///< Sub-index 0 with a fixed value.
    kConfiguration = 3U, ///< A stored value, see `item`.
    kGapSignature = 4U,  ///< 13FFh entry of an SRDO that does not exist.
    kConfigurationValid = 5U,
    kVariable = 6U,
    kFixed = 7U, ///< As kConfiguration, but a part of the program: a static mapping.
};

/// Where an address leads. What is not stored has the field kInvalid, which reads 0. [SRS_CFG_040, SRS_CFG_041]
struct ObjectPlace
{
    AbortCode refusal; ///< Only with kInvalid.
    ConfigItem item;   ///< Its value is for the caller to fill in.
    ObjectKind kind;
    std::uint8_t size_bytes;
    std::uint8_t constant;
    const MappableObject* variable;
};

/// Bits of the object in a mapping entry; its index and sub-index stand above them.
constexpr std::uint32_t kEntryLengthMask = 0xFFU;

/// @brief Finds what an address of the safety part of the dictionary leads to. O(log objects); with gaps O(srdo_count)
/// more
[[nodiscard]] ObjectPlace Locate(const DeviceConfig& config, ObjectKey key) noexcept;
/// @brief Slot of an existing SRDO number, or kNoSlot. O(1); with gaps O(srdo_count) [SRS_KRN_018]
[[nodiscard]] SlotIndex SlotOf(const DeviceConfig& config, SrdoNumber number) noexcept;
/// @brief The mappable object at an address, or null. O(log objects)
[[nodiscard]] const MappableObject* FindObject(const DeviceConfig& config, ObjectKey key) noexcept;
/// @brief The mappable object that a mapping entry names, or null. O(log objects)
[[nodiscard]] inline const MappableObject* FindMapped(const DeviceConfig& config, const std::uint32_t entry) noexcept
{
    return FindObject(config, ObjectKey{entry >> 8U});
}
/// @brief Value of an object of up to 4 bytes; 0 for none.
[[nodiscard]] std::uint32_t ToValue(const ObjectData& data) noexcept;
/// @brief Whether a mapping entry is one of the dummies. [SRS_CFG_033]
[[nodiscard]] bool IsDummy(std::uint32_t entry) noexcept;

/// What a kernel works with before Start and after Stop: a device without SRDOs and objects.
extern const DeviceConfig kNoDevice;

} // namespace counterpoint

#endif
