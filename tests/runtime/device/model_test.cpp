// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/model.hpp"
#include "runtime/device/owned_channel.hpp"
#include "runtime/device/pair_logic.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::runtime
{
namespace
{
std::string Example(const std::string& name)
{
    return cia306::test::SourceFolder() + "/examples/emergency_stop/" + name;
}

std::string Data(const std::string& name)
{
    return cia306::test::SourceFolder() + "/tests/canopen/cia306/data/" + name;
}

TEST(DeviceModel, TakesTheControllerFromItsDcf)
{
    Verifies(req::SRS_SIM_002);
    const DeviceModel model(Example("controller.dcf"), std::nullopt);
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

TEST(DeviceModel, TakesEveryDeviceParameterFromItsDcf)
{
    Verifies(req::SRS_SIM_002);
    // Given a DCF in which each of 5F00h to 5F05h is another than its default
    const DeviceModel model(Data("digest.dcf"), std::nullopt);
    const DeviceConfig& config = model.Config();
    EXPECT_EQ(config.granularity_bits, 1U);
    EXPECT_EQ(config.map_entries, 128U);
    EXPECT_EQ(config.dummies, DummyMapping::kAllowed);
    EXPECT_EQ(config.gaps, NumberGaps::kSearched);
    EXPECT_EQ(config.gfc, GfcUse::kPresent);
    EXPECT_EQ(config.normal_port, CanPortId::kFirst);
    EXPECT_EQ(config.inverse_port, CanPortId::kSecond);
    EXPECT_EQ(config.diagnostic_interval_us, 1234000U);
    EXPECT_EQ(config.output_time_us, 4321U);
    ASSERT_EQ(config.srdo_count, 2U);
    EXPECT_EQ(config.srdos[0].policy, ReleasePolicy::kAutomatic);
    EXPECT_EQ(config.srdos[0].detection, SrvtDetection::kLate);
    EXPECT_EQ(config.srdos[0].safe_value.low, 0xA1B2C3D4U);
    EXPECT_EQ(config.srdos[1].form, ProducerForm::kProviderCalled);
    EXPECT_EQ(config.srdos[1].detection, SrvtDetection::kEarly);
    EXPECT_EQ(config.srdos[1].safe_value.high, 0x11223344U);
}

TEST(DeviceModel, LeavesDummiesOutOfItsPairs)
{
    Verifies(req::SRS_SIM_002);
    // Given SRDO 1 with dummies of 1, 8, 16 and 32 bits around objects of 1 and 6 bits
    const DeviceModel model(Data("dummies.dcf"), std::nullopt);
    // Then its pairs are the objects, at their place in the data
    ASSERT_EQ(model.Pairs().size(), 3U);
    EXPECT_EQ(model.Pairs()[0].first_bit, 1U);
    EXPECT_EQ(model.Pairs()[1].first_bit, 26U);
    EXPECT_EQ(model.Pairs()[2].first_bit, 56U);
    EXPECT_EQ(model.Objects()[1].length_bits, 6U);
}

TEST(PairLogic, AConsumerUsesWhatIsInverseAndOpenAndTheSafeValueElse)
{
    Verifies(req::SRS_SIM_006);
    // Given the controller, which receives 2200h:01 (safe value 0) by SRDO 1
    const DeviceModel model(Example("controller.dcf"), std::nullopt);
    PairLogic logic(model, Half::kBoth);
    const PairValue* const pair = logic.Find({0x2200U, 1U});
    ASSERT_NE(pair, nullptr);
    ASSERT_TRUE(pair->is_consumer);
    const auto taken = [&logic, pair](const std::uint64_t normal, const std::uint64_t inverse, const SrdoMask open)
    {
        WriteVariable(pair->normal_place, VariableValue{normal});
        WriteVariable(pair->inverse_place, VariableValue{inverse});
        logic.Take(open, [](const PairValue&) {});
        return pair->normal;
    };
    EXPECT_EQ(taken(0x5AU, 0xA5U, 1U), 0x5AU);
    // When its output is closed, or only another one is open, then it is not used
    EXPECT_EQ(taken(0x5AU, 0xA5U, 0U), 0U);
    EXPECT_EQ(taken(0x5AU, 0xA5U, 2U), 0U);
    // Nor when one bit of either object is not inverse
    EXPECT_EQ(taken(0x5AU, 0xA4U, 1U), 0U);
    EXPECT_EQ(taken(0x5BU, 0xA5U, 1U), 0U);
    EXPECT_EQ(taken(0x5BU, 0xA4U, 1U), 0x5BU);
}

TEST(PairLogic, AProducerComputesItsInverseObjectByAnotherPath)
{
    Verifies(req::SRS_SIM_006);
    const DeviceModel model(Example("sensor.dcf"), std::nullopt);
    PairLogic logic(model, Half::kBoth);
    logic.SetInput({0x2000U, 1U}, 0x15AU);
    const PairValue* const pair = logic.Find({0x2000U, 1U});
    ASSERT_NE(pair, nullptr);
    EXPECT_EQ(pair->normal, 0x5AU);
    EXPECT_EQ(pair->inverse, 0xA5U);
    // A fault of that path is one of the inverse object alone
    logic.Disturb({0x2000U, 1U}, 0x01U);
    logic.Write(*pair);
    EXPECT_EQ(ReadVariable(pair->normal_place).bits, 0x5AU);
    EXPECT_EQ(ReadVariable(pair->inverse_place).bits, 0xA4U);
}

// Faults of memory change what the kernel is given, in place.
TEST(DeviceModel, LetsFaultsReachWhatTheKernelIsGiven)
{
    Verifies(req::SRS_SIM_021);
    DeviceModel model(Example("controller.dcf"), std::nullopt);
    model.ObjectTable()[0].length_bits = 7U;
    EXPECT_EQ(model.Config().objects[0].length_bits, 7U);
    model.SetupTable()[1].safe_value.low = 0x55U;
    EXPECT_EQ(model.Config().srdos[1].safe_value.low, 0x55U);
}

TEST(FindConfigBit, NamesTheBitThatHoldsAValueInEitherChannel)
{
    Verifies(req::SRS_SIM_021);
    const DeviceModel model(Example("actuator.dcf"), std::nullopt);
    for (const Letter letter : {Letter::kA, Letter::kB})
    {
        // Given a channel that keeps SCT 50 (32h)
        const auto host = MakeChannel(letter, RoomOf(model.Config()));
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

// Each CPU of two runs the channel of its letter, one alone runs both.
TEST(OwnedChannel, IsOnItsCpuWithRoomForItsDevice)
{
    Verifies(req::SRS_SIM_021);
    EXPECT_TRUE(HasChannel(CpuRole::kWhole, Letter::kA));
    EXPECT_TRUE(HasChannel(CpuRole::kWhole, Letter::kB));
    EXPECT_TRUE(HasChannel(CpuRole::kA, Letter::kA));
    EXPECT_FALSE(HasChannel(CpuRole::kA, Letter::kB));
    EXPECT_FALSE(HasChannel(CpuRole::kB, Letter::kA));
    EXPECT_TRUE(HasChannel(CpuRole::kB, Letter::kB));
    for (const Letter letter : {Letter::kA, Letter::kB})
    {
        // Up to 16 entries have the same room, 17 and more the greatest
        const std::size_t usual = MakeChannel(letter, {2U, 16U})->Size();
        const std::size_t wide = MakeChannel(letter, {2U, 17U})->Size();
        EXPECT_EQ(MakeChannel(letter, {2U, 1U})->Size(), usual);
        EXPECT_EQ(MakeChannel(letter, {2U, 128U})->Size(), wide);
        EXPECT_GT(wide, usual);
        EXPECT_GT(MakeChannel(letter, {3U, 16U})->Size(), usual);
        EXPECT_GT(MakeChannel(letter, {2U, 16U})->VoiceSize(), 0U);
    }
}
} // namespace
} // namespace counterpoint::runtime
