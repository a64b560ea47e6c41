// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CONTRACT_CONFIGURATION_HPP
#define SAFETY_CORE_CONTRACT_CONFIGURATION_HPP

#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/srdo.hpp"

#include <cstdint>

namespace counterpoint
{

/// Which SRDO may hold an object in its mapping. Zero-filled memory is not mappable.
enum class MapAccess : std::uint8_t
{
    kNone = 0U,
    kProducer = 0x33U, ///< Written by the application, sent by an SRDO of direction 1.
    kConsumer = 0xCCU, ///< Written by the channels, from an SRDO of direction 2.
};

/// One mappable variable of the application. `place` points to ceil(length_bits / 8) bytes that hold the value in
/// little-endian order on every processor (the order of the wire); bits of the last byte above the length are ignored
/// when it is read and 0 when a channel wrote it. The accessors of kernel/variable.hpp read and write it.
struct MappableObject
{
    std::uint16_t index;
    std::uint8_t sub;
    std::uint8_t length_bits; ///< 1 to 64.
    MapAccess access;
    std::uint8_t* place;
};

/// A mapping that is a part of the program: it takes no RAM and cannot be written. [SRS_CFG_032]
struct StaticMap
{
    const std::uint32_t* entries; ///< As 138xh sub 1 onward; null: the mapping of this SRDO is dynamic.
    std::uint8_t count;           ///< As 138xh sub 0: at most 128; 0 without entries.
};

/// The two fields of an SRDO with a static mapping: its normal and its inverse objects, each without a gap, in the
/// order of the entries. Null: not registered.
struct StaticFields
{
    std::uint8_t* normal;
    std::uint8_t* inverse;
};

/// What one SRDO needs beyond its objects in 1301h to 13FFh.
struct SrdoSetup
{
    std::uint8_t number; ///< 1 to 64; the setups are in ascending order of number.
    ReleasePolicy policy;
    ProducerForm form;
    Payload
        safe_value; ///< Consumer: what the normal objects read while the SRDO is safe; inverse objects its complement.
    SrvtDetection detection;
    StaticMap map;
};

/// Whether a consumer may map dummy entries. [SRS_CFG_033]
enum class DummyMapping : std::uint8_t
{
    kRefused = 0U,
    kAllowed = 0x66U,
};

/// Whether numbers of SRDOs may be missing. Without gaps an SRDO is found without a search. [SRS_KRN_018]
enum class NumberGaps : std::uint8_t
{
    kRefused = 0U,
    kSearched = 0x99U,
};

/// Whether the device has the global fail-safe command. [SRS_KRN_019]
enum class GfcUse : std::uint8_t
{
    kRemoved = 0U, ///< 1300h does not exist; no GFC is sent or accepted.
    kPresent = 0x5AU,
};

/// Fixed description of a device. Its owner keeps it unchanged while the kernel uses it. Kernel::Start checks the
/// ranges and refuses everything else, values that an enumeration does not have included. All times are in
/// microseconds.
struct DeviceConfig
{
    const SrdoSetup* srdos;        ///< Never null.
    const MappableObject* objects; ///< Ascending by (index, sub), no duplicates; not 1300h to 13FFh, nor 0001h to 0007h
                                   ///< beside dummies; null only where there are none.
    std::uint16_t object_count;    ///< 0 to 1024.
    std::uint8_t srdo_count;       ///< 1 to 64.
    std::uint8_t node_id;          ///< 1 to 127.
    std::uint8_t granularity_bits; ///< 1, 8, 16, 32 or 64.
    std::uint8_t map_entries; ///< Entries of each dynamic mapping: even, 0 to 128; what the channels have room for.
    DummyMapping dummies;
    NumberGaps gaps;
    GfcUse gfc;
    CanPortId normal_port;            ///< Controller of the normal frames.
    CanPortId inverse_port;           ///< Controller of the inverse frames; equal to normal_port with one controller.
    std::uint32_t cycle_us;           ///< 100 to 1 000 000: nominal distance of two calls of Kernel::Cycle.
    std::uint32_t cycle_tolerance_us; ///< 0 to cycle_us: a call this much later is still in time.
    std::uint32_t discrepancy_us;     ///< 0 to 2^30 - 1: greatest time for which the channels' ordinals may differ.
    std::uint32_t acknowledge_window_us; ///< 0 to 2^30 - 1: for how long an acknowledge edge waits for its pair, and a
                                         ///< release by one channel's edge for the other channel's.
    /// 2 srdo_count cycles as late as allowed to 2^30 - 1: every signature and digest is recomputed in it.
    std::uint32_t diagnostic_interval_us;
    /// 15 cycles as late as allowed to 2^30 - 1: the comparator is tested with every member that it compares in it.
    std::uint32_t test_interval_us;
    std::uint32_t clock_tolerance_us; ///< Greatest difference of the counters' progress within clock_interval_us.
    /// Above clock_tolerance_us, 4 cycles as late as allowed to 2^30 - 1.
    std::uint32_t clock_interval_us;
    /// 0 to 2^30 - 1: from the dropped permit to the safe output; used in computed limits only.
    std::uint32_t output_time_us;
    std::uint32_t digest; ///< Expected device digest (5F04h); 0: none is expected. [SRS_CFG_151]
};

/// What the storage of a channel has room for. [SRS_KRN_020]
struct ChannelRoom
{
    std::uint8_t slots;       ///< SRDOs.
    std::uint8_t map_entries; ///< Entries of each dynamic mapping.
};

/// Names one stored value of the configuration.
enum class ConfigField : std::uint8_t
{
    kInvalid = 0U,
    kDirection = 1U,           ///< 130xh sub 1, u8.
    kSct = 2U,                 ///< 130xh sub 2, u16, ms: refresh time or SCT.
    kSrvt = 3U,                ///< 130xh sub 3, u8, ms.
    kTransmissionType = 4U,    ///< 130xh sub 4, u8.
    kCobId1 = 5U,              ///< 130xh sub 5, u32.
    kCobId2 = 6U,              ///< 130xh sub 6, u32.
    kMapCount = 7U,            ///< 138xh sub 0, u8.
    kMapEntry = 8U,            ///< 138xh sub 1 to 128 (field `sub`), u32: index << 16 | sub << 8 | bits.
    kSignature = 9U,           ///< 13FFh sub n, u16.
    kGfcParameter = 10U,       ///< 1300h, u8; slot has no meaning.
    kConfigurationValid = 11U, ///< 13FEh, u8; slot has no meaning.
};

/// Where a value of the configuration is kept; `sub` is 1 to 128 with kMapEntry and 0 otherwise.
struct ConfigAddress
{
    SlotIndex slot;
    ConfigField field;
    std::uint8_t sub;
};

/// One value of the configuration; the low bytes of `value`, as many as the field has.
struct ConfigItem
{
    ConfigAddress address;
    std::uint32_t value;
};

/// First rule that the configuration of one SRDO breaks, in the order in which the rules are tried. [SRS_CFG_020]
enum class ConfigFault : std::uint8_t
{
    kInvalid = 0U,
    kDirection = 1U,        ///< Direction above 2.
    kTransmissionType = 2U, ///< Not 254.
    kIdentifier = 3U,       ///< Reserved bits, outside 101h to 180h, parity, or COB-ID 2 not COB-ID 1 + 1.
    kIdentifierInUse = 4U,  ///< Another SRDO that is not off has one of the identifiers.
    kTiming = 5U,           ///< Consumer: not 1 <= SRVT < SCT. Producer: refresh time shorter than the cycle.
    kMapping = 6U,          ///< Odd count, too many entries, unknown object, access, length, same object, unequal pair,
                            ///< granularity, dummy, static fields.
    kLengthExceeded = 7U,   ///< More than 64 bits of normal or inverse data.
    kSignature = 8U,        ///< 13FFh is not the computed signature.
    kTable = 9U,            ///< A resolved mapping no longer leads to the objects that the entries name.
    kNone = 0x5AU,
};

/// What a check of one SRDO came to.
struct CheckResult
{
    ConfigFault fault;
    std::uint16_t signature; ///< As computed by the channel, whatever the fault.
};

} // namespace counterpoint

#endif
