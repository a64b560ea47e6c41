// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/integration/scenario_run.hpp"
#include "verification/simulator/channel_host.hpp"
#include "verification/simulator/device_model.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::simulator
{
namespace
{
TEST(DeviceModel, TakesTheControllerFromItsDcf)
{
    Verifies(req::SRS_SIM_002);
    const DeviceModel model(Examples() + "controller.dcf", std::nullopt);
    // SRDOs
    EXPECT_EQ(model.Config().node_id, 2U);
    EXPECT_EQ(model.Config().srdo_count, 2U);
    ASSERT_EQ(model.Srdos().size(), 2U);
    EXPECT_EQ(model.Srdos()[0].direction, 2U);
    EXPECT_EQ(model.Srdos()[0].times.sct_ms, 50U);
    EXPECT_EQ(model.Srdos()[0].times.srvt_ms, 20U);
    EXPECT_EQ(model.Srdos()[0].cob_id_1, 0x101U);
    EXPECT_EQ(model.Srdos()[1].direction, 1U);
    EXPECT_EQ(model.Srdos()[1].times.sct_ms, 25U);
    // Times of 5F00h: 1 ms, 0.5 ms, 5 ms, 1 s, 1 s, 0.5 ms in 100 ms
    EXPECT_EQ(model.Config().cycle_us, 1000U);
    EXPECT_EQ(model.Config().cycle_tolerance_us, 500U);
    EXPECT_EQ(model.Config().discrepancy_us, 5000U);
    EXPECT_EQ(model.Config().diagnostic_interval_us, 1000000U);
    EXPECT_EQ(model.Config().test_interval_us, 1000000U);
    EXPECT_EQ(model.Config().clock_tolerance_us, 500U);
    EXPECT_EQ(model.Config().clock_interval_us, 100000U);
    // Objects in ascending order with the access of their direction
    ASSERT_EQ(model.Objects().size(), 8U);
    EXPECT_EQ(model.Objects()[0].index, 0x2000U);
    EXPECT_EQ(model.Objects()[0].access, MapAccess::kProducer);
    EXPECT_EQ(model.Objects()[7].index, 0x2300U);
    EXPECT_EQ(model.Objects()[7].access, MapAccess::kConsumer);
    // Power-on values of the DCF: 2000h 0, 2100h FFh
    EXPECT_EQ(*model.Objects()[0].place, 0x00U);
    EXPECT_EQ(*model.Objects()[2].place, 0xFFU);
    // The order of a configuring master: first direction 0, last 13FEh
    EXPECT_EQ(model.Writes().front().object.index, 0x1301U);
    EXPECT_EQ(model.Writes().front().value, 0U);
    EXPECT_EQ(model.Writes().back().object.index, 0x13FEU);
    EXPECT_EQ(model.Writes().back().value, 0xA5U);
}

TEST(FindConfigBit, NamesTheBitThatHoldsAValueInEitherChannel)
{
    Verifies(req::SRS_SIM_021);
    const DeviceModel model(Examples() + "actuator.dcf", std::nullopt);
    for (const Letter letter : {Letter::kA, Letter::kB})
    {
        // Given a channel that keeps SCT 50 (32h)
        const auto host = MakeChannel(letter, model.Config().srdo_count);
        host->Voice().Restart(model.Config());
        const ConfigAddress sct{0U, ConfigField::kSct, 0U};
        host->Voice().Store({sct, 50U});
        const auto place = FindConfigBit(letter, model.Config(), sct, 3U);
        ASSERT_TRUE(place);
        // When the bit at that place flips
        host->Bytes()[place->offset] = static_cast<std::uint8_t>(host->Bytes()[place->offset] ^ (1U << place->bit));
        // Then SCT is 3Ah
        EXPECT_EQ(host->Voice().Load(sct).value, 0x3AU);
    }
    EXPECT_FALSE(FindConfigBit(Letter::kA, model.Config(), {0U, ConfigField::kSct, 0U}, 20U));
}
} // namespace
} // namespace counterpoint::simulator
