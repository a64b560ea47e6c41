// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/proof/checksum.hpp"

#include "channel_a/channel.hpp"
#include "channel_a/crc.hpp"
#include "channel_b/channel.hpp"
#include "channel_b/checksum.hpp"
#include "verification/conformance/forwarding.hpp"
#include "verification/proof/signature.hpp"
#include "verification/trace/ids/verification.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::proof
{
namespace
{

/// Bit by bit, of a polynomial with one wrong coefficient: 1021h with that of x^11 beside.
class WrongSixteen
{
  public:
    void AddByte(const std::uint32_t byte)
    {
        crc_ ^= byte << 8U;
        for (std::uint32_t bit = 0U; bit < 8U; ++bit)
        {
            const bool takes = (crc_ & 0x8000U) != 0U;
            crc_ = ((crc_ << 1U) ^ (takes ? 0x1821U : 0U)) & 0xFFFFU;
        }
    }
    [[nodiscard]] std::uint16_t Value() const
    {
        return static_cast<std::uint16_t>(crc_);
    }

  private:
    std::uint32_t crc_{0U};
};

/// Right by what it tells, but keeps something beside: whoever looks at the value alone sees nothing after two bytes.
class HidesSixteen
{
  public:
    void AddByte(const std::uint32_t byte)
    {
        crc_ = Divided16(static_cast<std::uint16_t>(crc_ & 0xFFFFU), static_cast<std::uint8_t>(byte)) |
               ((crc_ & 0xFFFF0000U) + 0x10000U);
    }
    [[nodiscard]] std::uint16_t Value() const
    {
        return static_cast<std::uint16_t>(crc_ & 0xFFFFU);
    }

  private:
    std::uint32_t crc_{0U};
};

/// EDB88320h without its lowest coefficient but one that is there.
class WrongThirtyTwo
{
  public:
    explicit WrongThirtyTwo(const std::uint32_t before) : crc_{~before}
    {
    }
    void AddByte(const std::uint32_t byte)
    {
        crc_ ^= byte & 0xFFU;
        for (std::uint32_t bit = 0U; bit < 8U; ++bit)
        {
            const bool takes = (crc_ & 1U) != 0U;
            crc_ = (crc_ >> 1U) ^ (takes ? 0xEDB88220U : 0U);
        }
    }
    [[nodiscard]] std::uint32_t Value() const
    {
        return ~crc_;
    }

  private:
    std::uint32_t crc_;
};

/// Signs as the one that ships, with one bit more.
class SignsWrong final : public conformance::Forwarding
{
  public:
    using Forwarding::Forwarding;
    CheckResult Validate(const SlotIndex slot) noexcept override
    {
        CheckResult result = Forwarding::Validate(slot);
        result.signature = static_cast<std::uint16_t>(result.signature ^ 1U);
        return result;
    }
    DeviceDigest Digest(const SlotIndex slot, const DeviceDigest before) const noexcept override
    {
        return DeviceDigest{Forwarding::Digest(slot, DeviceDigest{before.value & 0x7FFFFFFFU}).value};
    }
};

TEST(ProofOfChecksums, DefinitionGivesTheCheckValuesOfTheCatalogues)
{
    Verifies(req::SRS_VER_117);
    std::uint16_t sixteen = 0U;
    std::uint32_t thirty_two = 0xFFFFFFFFU;
    for (std::uint8_t digit = 0x31U; digit <= 0x39U; ++digit)
    {
        sixteen = Divided16(sixteen, digit);
        thirty_two = Divided32(thirty_two, digit);
    }
    EXPECT_EQ(sixteen, 0x31C3U);
    EXPECT_EQ(~thirty_two, 0xCBF43926U);
}

TEST(ProofOfChecksums, EachStateAndByteOfCrc16)
{
    Verifies(req::SRS_VER_117);
    const Shown a = ProveSixteen<channel_a::Crc16>();
    const Shown b = ProveSixteen<channel_b::Crc16>();
    EXPECT_EQ(a.refused, "");
    EXPECT_EQ(b.refused, "");
    EXPECT_EQ(a.steps, 16777216U);
    EXPECT_EQ(b.steps, 16777216U);
}

TEST(ProofOfChecksums, EachByteOfCrc32)
{
    Verifies(req::SRS_VER_117);
    EXPECT_EQ(ProveThirtyTwo<channel_a::Crc32>(100000U).refused, "");
    EXPECT_EQ(ProveThirtyTwo<channel_b::Crc32>(100000U).refused, "");
}

TEST(ProofOfChecksums, RefusesOneWrongCoefficient)
{
    Verifies(req::SRS_VER_117);
    EXPECT_EQ(ProveSixteen<WrongSixteen>().refused, "CRC-16: state 0h, byte 1h gives 1821h, by definition 1021h");
    EXPECT_EQ(ProveThirtyTwo<WrongThirtyTwo>(0U).refused.substr(0U, 7U), "CRC-32:");
}

TEST(ProofOfChecksums, RefusesAStateThatIsNotTold)
{
    Verifies(req::SRS_VER_117);
    EXPECT_EQ(ProveSixteen<HidesSixteen>().refused,
              "CRC-16, start value: state 0h, byte 0h gives 0h, by definition 0h");
}

TEST(ProofOfChecksums, OfTheObjectsThatShip)
{
    Verifies(req::SRS_VER_117);
    channel_a::StorageFor<2U, 2U> storage_a{};
    channel_b::StorageFor<2U, 2U> storage_b{};
    channel_a::Channel a{storage_a.Handle()};
    channel_b::Channel b{storage_b.Handle()};
    EXPECT_EQ(SignatureRig{a}.ProveSignature(1U).refused, "");
    EXPECT_EQ(SignatureRig{b}.ProveSignature(1U).refused, "");
    EXPECT_EQ(SignatureRig{a}.ProveDigest(1000U).refused, "");
    EXPECT_EQ(SignatureRig{b}.ProveDigest(1000U).refused, "");
    SignsWrong wrong{a};
    EXPECT_EQ(SignatureRig{wrong}.ProveSignature(1U).refused.substr(0U, 10U), "signature,");
    EXPECT_EQ(SignatureRig{wrong}.ProveDigest(0U).refused.substr(0U, 7U), "digest:");
}

} // namespace
} // namespace counterpoint::proof
