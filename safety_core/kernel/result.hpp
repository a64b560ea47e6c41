// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_RESULT_HPP
#define SAFETY_CORE_KERNEL_RESULT_HPP

#include <cstdint>

namespace counterpoint
{

/// Return codes of the calls, named after the reference's. [SRS_KRN_011, SRS_KRN_012, SRS_KRN_013, SRS_KRN_014,
/// SRS_KRN_015, SRS_KRN_028, SRS_KRN_348]
enum class Result : std::uint8_t
{
    kInvalidResult = 0U,
    kSuccessful = 0x69U,
    kNotExist = 1U,
    kNmtError = 2U,
    kInvalidConfiguration = 3U,
    kInvalid = 4U, ///< SRDO is off (direction 0).
    kRxTxConflict = 5U,
    kDeviceFault = 6U,    ///< Device safe state, not started, or the channels differ.
    kGfcUnsupported = 7U, ///< 1300h is 0.
    kTransmitFailed = 8U,
    kTimingError = 9U,
    kIdError = 10U,
    kIdInUse = 11U,
    kSignatureError = 12U,
    kMappingError = 13U,
    kLengthExceeded = 14U,
    kForeignImage = 15U, ///< A stored configuration with another number of items.
    kDamagedImage = 16U, ///< A stored configuration that is not as it was saved.
};

} // namespace counterpoint

#endif
