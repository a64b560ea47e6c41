// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_BASE_ABORT_CODE_HPP
#define CANOPEN_CIA301_BASE_ABORT_CODE_HPP

#include <cstdint>

namespace counterpoint::cia301
{

/// The SDO abort codes of CiA 301. kNone is success, kPending says that a hook is not ready; neither is ever sent.
enum class SdoAbort : std::uint32_t
{
    kNone = 0U,
    kPending = 1U,
    kToggle = 0x05030000U,
    kTimeOut = 0x05040000U,
    kCommand = 0x05040001U,
    kBlockSize = 0x05040002U,
    kSequence = 0x05040003U,
    kCrc = 0x05040004U,
    kOutOfMemory = 0x05040005U,
    kUnsupportedAccess = 0x06010000U,
    kWriteOnly = 0x06010001U,
    kReadOnly = 0x06010002U,
    kObjectUnknown = 0x06020000U,
    kNotMappable = 0x06040041U,
    kMapTooLong = 0x06040042U,
    kIncompatible = 0x06040043U,
    kInternal = 0x06040047U,
    kHardware = 0x06060000U,
    kLengthMismatch = 0x06070010U,
    kTooLong = 0x06070012U,
    kTooShort = 0x06070013U,
    kSubUnknown = 0x06090011U,
    kValueRange = 0x06090030U,
    kValueHigh = 0x06090031U,
    kValueLow = 0x06090032U,
    kLimitsContradict = 0x06090036U,
    kNoConnection = 0x060A0023U,
    kGeneral = 0x08000000U,
    kNotStored = 0x08000020U,
    kLocalControl = 0x08000021U,
    kDeviceState = 0x08000022U,
    kNoDictionary = 0x08000023U,
    kNoData = 0x08000024U,
};

} // namespace counterpoint::cia301

#endif
