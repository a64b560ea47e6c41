// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The devices in whose storage bits are flipped. Signatures were computed outside this program.
#include "verification/conformance/flip_rig.hpp"

namespace counterpoint::conformance
{

namespace
{
constexpr std::uint32_t kBytesMap[] = {0x60100108U, 0x60110108U, 0x60100208U, 0x60110208U};
constexpr std::uint32_t kBytesSentMap[] = {0x62100108U, 0x62110108U, 0x62100208U, 0x62110208U};
constexpr std::uint32_t kBitsMap[] = {0x63020303U, 0x63030303U, 0x00010001U, 0x00010001U, 0x63020C0CU, 0x63030C0CU};
constexpr std::uint32_t kBitsSentMap[] = {0x64020404U, 0x64030404U, 0x64020C0CU, 0x64030C0CU};
} // namespace

const RigDevice kRigDevices[] = {
    {{{2U, 50U, 20U, 0x111U, 0x112U, 4U, kBytesMap, 0x4370U},
      {1U, 25U, 20U, 0x101U, 0x102U, 4U, kBytesSentMap, 0xF2B5U}},
     {{0x6010U, 0x6011U, 1U, 0U, 0xFFU}, {0x6010U, 0x6011U, 2U, 8U, 0xFFU}},
     {{0x6210U, 0x6211U, 1U, 0U, 0xFFU}, {0x6210U, 0x6211U, 2U, 8U, 0xFFU}},
     {{nullptr, 0U}, {nullptr, 0U}},
     SrvtDetection::kEarly},
    {{{2U, 50U, 20U, 0x111U, 0x112U, 0U, nullptr, 0x4370U}, {1U, 25U, 20U, 0x101U, 0x102U, 0U, nullptr, 0xF2B5U}},
     {{0x6010U, 0x6011U, 1U, 0U, 0xFFU}, {0x6010U, 0x6011U, 2U, 8U, 0xFFU}},
     {{0x6210U, 0x6211U, 1U, 0U, 0xFFU}, {0x6210U, 0x6211U, 2U, 8U, 0xFFU}},
     {{kBytesMap, 4U}, {kBytesSentMap, 4U}},
     SrvtDetection::kLate},
    {{{2U, 50U, 20U, 0x111U, 0x112U, 6U, kBitsMap, 0xB063U}, {1U, 25U, 20U, 0x101U, 0x102U, 4U, kBitsSentMap, 0x4F92U}},
     {{0x6302U, 0x6303U, 3U, 0U, 0x7U}, {0x6302U, 0x6303U, 12U, 4U, 0xFFFU}},
     {{0x6402U, 0x6403U, 4U, 0U, 0xFU}, {0x6402U, 0x6403U, 12U, 4U, 0xFFFU}},
     {{nullptr, 0U}, {nullptr, 0U}},
     SrvtDetection::kEarly},
};

/// Bits of the data that objects hold.
std::uint32_t MappedBits(const RigDevice& device)
{
    return (static_cast<std::uint32_t>(device.consumed[0].mask) << device.consumed[0].shift) |
           (static_cast<std::uint32_t>(device.consumed[1].mask) << device.consumed[1].shift);
}

} // namespace counterpoint::conformance
