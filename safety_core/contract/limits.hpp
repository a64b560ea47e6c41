// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CONTRACT_LIMITS_HPP
#define SAFETY_CORE_CONTRACT_LIMITS_HPP

#include <cstdint>

namespace counterpoint
{

/// EN 50325-5 knows SRDO 1 to 64 (objects 1301h to 1340h).
constexpr std::uint8_t kMaxSrdoCount = 64U;
/// Entries of one mapping at most: 64 normal and 64 inverse objects of one bit.
constexpr std::uint8_t kMaxMapEntries = 128U;
/// Entries of one mapping where no object is shorter than a byte: 8 normal and 8 inverse ones.
constexpr std::uint8_t kUsualMapEntries = 16U;
constexpr std::uint8_t kMaxPayloadBytes = 8U;
constexpr std::uint8_t kMaxPayloadBits = 64U;
/// Communication parameter objects of an SRDO have sub-index 1 to 6.
constexpr std::uint8_t kCommunicationSubs = 6U;

constexpr std::uint16_t kFirstSrdoIdentifier = 0x101U;
constexpr std::uint16_t kLastSrdoIdentifier = 0x180U;
constexpr std::uint16_t kSrdoIdentifierCount = 128U;
constexpr std::uint16_t kGfcIdentifier = 0x001U;
/// Indices of the data types of CiA 301 that may stand for an object nobody wants (dummy entries): 0001h BOOLEAN to
/// 0007h UNSIGNED32.
constexpr std::uint16_t kLastDummyIndex = 0x0007U;

constexpr std::uint8_t kTransmissionTypeAsynchronous = 254U;
/// Value of 13FEh that declares the configuration valid.
constexpr std::uint8_t kConfigurationValidValue = 0xA5U;
/// An SRDO producer waits 0.5 ms for each unit of its node-ID before its first transmission.
constexpr std::uint32_t kFirstTransmissionStepUs = 500U;
constexpr std::uint32_t kMicrosecondsPerMillisecond = 1000U;
/// Cycles in which the comparator's own test has provoked every member that is compared. [SRS_CMP_009]
constexpr std::uint32_t kComparatorTests = 15U;

static_assert(kSrdoIdentifierCount == (kLastSrdoIdentifier - kFirstSrdoIdentifier) + 1U, "one identifier pair an SRDO");
static_assert(kSrdoIdentifierCount == 2U * kMaxSrdoCount, "one identifier pair an SRDO");
static_assert(kMaxMapEntries == 2U * kMaxPayloadBits, "one normal and one inverse object a bit");
static_assert(kUsualMapEntries == 2U * kMaxPayloadBytes, "one normal and one inverse object a byte");

} // namespace counterpoint

#endif
