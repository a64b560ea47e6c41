// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// COB-IDs of an SRDO that is switched on, and of one that is on.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <array>
#include <cstdint>

namespace counterpoint
{
namespace
{

class Identifiers : public Rig
{
  public:
    /// Both channels keep it, whatever the rules say.
    void Corrupt(const ConfigAddress& address, const std::uint32_t value)
    {
        real_a.Store(ConfigItem{address, value});
        real_b.Store(ConfigItem{address, value});
    }
};

TEST_F(Identifiers, EachRuleThatTheyBreakKeepsAnSrdoOff)
{
    Verifies(req::SRS_CFG_344);
    Configure();
    // A COB-ID is 0 or one that was admitted
    const std::array<std::uint32_t, 2> pairs[] = {{0U, 0U},         {0U, 0x108U},     {0x107U, 0U},    {0x107U, 0x10AU},
                                                  {0x107U, 0x106U}, {0x101U, 0x102U}, {0x103U, 0x104U}};
    for (const auto& [first, second] : pairs)
    {
        // Given channels in which SRDO 4 has a pair that breaks a rule, then it is switched on in neither direction
        Corrupt(ConfigAddress{2U, ConfigField::kCobId1, 0U}, first);
        Corrupt(ConfigAddress{2U, ConfigField::kCobId2, 0U}, second);
        EXPECT_EQ(Write(0x1304U, 1U, 1U, 1U), AbortCode::kValueRange) << std::hex << first;
        EXPECT_EQ(Write(0x1304U, 1U, 2U, 1U), AbortCode::kValueRange) << std::hex << first;
        // but off, where the channels have it on
        Corrupt(ConfigAddress{2U, ConfigField::kDirection, 0U}, 1U);
        EXPECT_EQ(Write(0x1304U, 1U, 0U, 1U), AbortCode::kNone) << std::hex << first;
        EXPECT_EQ(Read(0x1304U, 1U), 0U) << std::hex << first;
    }
    // With one that breaks none it is
    Corrupt(ConfigAddress{2U, ConfigField::kCobId1, 0U}, 0x107U);
    Corrupt(ConfigAddress{2U, ConfigField::kCobId2, 0U}, 0x108U);
    EXPECT_EQ(Write(0x1304U, 1U, 2U, 1U), AbortCode::kNone);
}

TEST_F(Identifiers, OfAnSrdoThatIsOnMayBeWrittenAsTheyAre)
{
    Verifies(req::SRS_CFG_344);
    Configure();
    EXPECT_EQ(Write(0x1301U, 5U, 0x101U, 4U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1301U, 6U, 0x102U, 4U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1303U, 5U, 0x103U, 4U), AbortCode::kNone);
    EXPECT_EQ(Write(0x1303U, 6U, 0x104U, 4U), AbortCode::kNone);
    // Another one, which is free, of the consumer or the producer
    EXPECT_EQ(Write(0x1301U, 5U, 0x107U, 4U), AbortCode::kValueRange);
    EXPECT_EQ(Write(0x1301U, 6U, 0x108U, 4U), AbortCode::kValueRange);
    EXPECT_EQ(Write(0x1303U, 5U, 0x107U, 4U), AbortCode::kValueRange);
    EXPECT_EQ(Write(0x1303U, 6U, 0x108U, 4U), AbortCode::kValueRange);
}

} // namespace
} // namespace counterpoint
