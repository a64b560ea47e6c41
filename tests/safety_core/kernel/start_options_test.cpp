// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What Start refuses of a description that is incomplete, or that says what no enumeration has.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

namespace counterpoint
{
namespace
{

class StartOptions : public Rig
{
  public:
    StartResult Start()
    {
        return kernel.Start(config, FlowCallback::kOff);
    }
    /// The option starts with these two values and with none of the others that a byte has.
    template <typename Option>
    void HasValues(Option& option, const std::uint8_t zero, const std::uint8_t other, const StartResult refusal)
    {
        const Option good = option;
        for (std::uint32_t value = 0U; value < 256U; ++value)
        {
            option = static_cast<Option>(value);
            const bool is_one = (value == zero) || (value == other);
            EXPECT_EQ(Start(), is_one ? StartResult::kStarted : refusal) << value;
        }
        option = good;
    }
};

TEST_F(StartOptions, DeviceWithoutSetupsIsRefused)
{
    Verifies(req::SRS_KRN_571);
    // Given three SRDOs and no table of them
    config.srdos = nullptr;
    // When it is started, then their number is wrong
    EXPECT_EQ(Start(), StartResult::kSrdoCount);
    config.srdo_count = 1U;
    EXPECT_EQ(Start(), StartResult::kSrdoCount);
    config.srdos = setups.data();
    EXPECT_EQ(Start(), StartResult::kStarted);
}

TEST_F(StartOptions, ObjectsWithoutATableAreRefused)
{
    Verifies(req::SRS_KRN_571);
    // Given a count of objects and no table of them
    config.objects = nullptr;
    EXPECT_EQ(Start(), StartResult::kObjects);
    config.object_count = 1U;
    EXPECT_EQ(Start(), StartResult::kObjects);
    // When there are none to be looked for, then none are missed
    config.object_count = 0U;
    EXPECT_EQ(Start(), StartResult::kStarted);
}

TEST_F(StartOptions, OptionOfTheDeviceIsOneOfItsValues)
{
    Verifies(req::SRS_KRN_572);
    setups[1].number = 2U;
    setups[2].number = 3U;
    HasValues(config.dummies, 0U, 0x66U, StartResult::kOptions);
    HasValues(config.gaps, 0U, 0x99U, StartResult::kOptions);
    HasValues(config.gfc, 0U, 0x5AU, StartResult::kOptions);
}

TEST_F(StartOptions, UndefinedValueIsNotTakenForAnAbsentGfc)
{
    Verifies(req::SRS_KRN_572);
    config.gfc = static_cast<GfcUse>(1U);
    ASSERT_EQ(Start(), StartResult::kOptions);
    EXPECT_EQ(kernel.SendGfc(), Result::kDeviceFault);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kInvalid);
}

// In the first setup and in the last one.
TEST_F(StartOptions, OptionOfEachSetupIsOneOfItsValues)
{
    Verifies(req::SRS_KRN_572);
    for (const std::size_t slot : {0U, 2U})
    {
        HasValues(setups[slot].policy, 0U, 0x5AU, StartResult::kOptions);
        HasValues(setups[slot].form, 0U, 1U, StartResult::kOptions);
        HasValues(setups[slot].detection, 0U, 0x3CU, StartResult::kOptions);
    }
}

TEST_F(StartOptions, AccessOfAnObjectIsOneOfItsValues)
{
    Verifies(req::SRS_KRN_572);
    for (const std::size_t number : {0U, 4U})
    {
        for (std::uint32_t value = 0U; value < 256U; ++value)
        {
            objects[number].access = static_cast<MapAccess>(value);
            const bool is_one = (value == 0U) || (value == 0x33U) || (value == 0xCCU);
            EXPECT_EQ(Start(), is_one ? StartResult::kStarted : StartResult::kObjects) << value;
        }
        objects[number].access = MapAccess::kNone;
    }
}

TEST_F(StartOptions, OptionOfStartIsOneOfItsValues)
{
    Verifies(req::SRS_KRN_572);
    const auto with = [this](const std::uint32_t flow, const std::uint32_t required)
    { return kernel.Start(config, static_cast<FlowCallback>(flow), static_cast<StatusHandshake>(required)); };
    EXPECT_EQ(with(0U, 0U), StartResult::kStarted);
    EXPECT_EQ(with(1U, 0U), StartResult::kStarted);
    EXPECT_EQ(with(0U, 0x69U), StartResult::kStarted);
    EXPECT_EQ(with(1U, 0x69U), StartResult::kStarted);
    for (const std::uint32_t value : {2U, 0x68U, 0x6AU, 0xFFU})
    {
        EXPECT_EQ(with(value, 0U), StartResult::kOptions) << value;
        EXPECT_EQ(with(0U, value), StartResult::kOptions) << value;
    }
    EXPECT_EQ(with(0x69U, 0U), StartResult::kOptions);
    EXPECT_EQ(with(0U, 1U), StartResult::kOptions);
    // Nothing runs then
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kInvalid);
    // And what else is wrong is named before
    config.node_id = 0U;
    EXPECT_EQ(with(2U, 1U), StartResult::kNodeId);
}

TEST_F(StartOptions, ObjectsOfTheKernelAreNotMappable)
{
    Verifies(req::SRS_KRN_573);
    const auto with = [this](const std::uint16_t index, const std::uint8_t sub)
    {
        objects[0].index = index;
        objects[0].sub = sub;
        return Start();
    };
    for (const std::uint16_t index : std::initializer_list<std::uint16_t>{0x1300, 0x1301, 0x1341, 0x13C1, 0x13FF})
    {
        EXPECT_EQ(with(index, 0U), StartResult::kObjects) << index;
        EXPECT_EQ(with(index, 255U), StartResult::kObjects) << index;
    }
    EXPECT_EQ(with(0x12FFU, 255U), StartResult::kStarted);
    EXPECT_EQ(with(0x1400U, 0U), StartResult::kStarted);
    EXPECT_EQ(with(0x0300U, 0U), StartResult::kStarted);
    // The last one as well
    objects[4].index = 0x13FFU;
    config.objects = &objects[4];
    config.object_count = 1U;
    EXPECT_EQ(Start(), StartResult::kObjects);
}

TEST_F(StartOptions, StaticMappingHasItsEntries)
{
    Verifies(req::SRS_KRN_574);
    static constexpr std::uint32_t kEntries[128] = {0x22000110U, 0x23000110U};
    const auto with = [this](const std::uint32_t* const entries, const std::uint8_t count)
    {
        setups[2].map = StaticMap{entries, count};
        return Start();
    };
    EXPECT_EQ(with(nullptr, 0U), StartResult::kStarted);
    EXPECT_EQ(with(nullptr, 1U), StartResult::kOptions);
    EXPECT_EQ(with(nullptr, 2U), StartResult::kOptions);
    EXPECT_EQ(with(nullptr, 255U), StartResult::kOptions);
    EXPECT_EQ(with(&kEntries[0], 0U), StartResult::kStarted);
    EXPECT_EQ(with(&kEntries[0], 2U), StartResult::kStarted);
    EXPECT_EQ(with(&kEntries[0], 128U), StartResult::kStarted);
    EXPECT_EQ(with(&kEntries[0], 129U), StartResult::kOptions);
    EXPECT_EQ(with(&kEntries[0], 255U), StartResult::kOptions);
}

} // namespace
} // namespace counterpoint
