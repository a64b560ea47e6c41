// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The configuration as a whole: read, loaded, and set to its power-on values.
#include "tests/safety_core/kernel/image.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <algorithm>

namespace counterpoint
{
namespace
{

// Three SRDOs with 16 map entries each: 3 * (8 + 16) items and 1300h.
constexpr std::uint32_t kItems = 73U;
constexpr std::uint32_t kDirectionOfFirst = 1U; // 1301h sub 1
constexpr std::uint32_t kSctOfFirst = 2U;       // 1301h sub 2
constexpr std::uint32_t kGfcItem = 72U;

struct Image
{
    ImageHeader header;
    std::vector<std::uint32_t> items;
};

class StoredConfiguration : public Rig
{
  public:
    Image Save()
    {
        const HeaderReply reply = kernel.Image().Header();
        EXPECT_EQ(reply.result, Result::kSuccessful);
        Image image{reply.header, {}};
        for (std::uint32_t number = 0U; number < reply.header.count; ++number)
        {
            const ItemReply item = kernel.Image().ReadItem(number);
            EXPECT_EQ(item.result, Result::kSuccessful);
            image.items.push_back(item.value);
        }
        return image;
    }
    Result Load(const Image& image)
    {
        for (std::uint32_t number = 0U; number < image.items.size(); ++number)
        {
            (void)kernel.Image().LoadItem(number, image.items[number]);
        }
        return kernel.Image().Load(image.header);
    }
    void HasDefaults()
    {
        EXPECT_EQ(Read(0x1300U, 0U), 0U);
        EXPECT_EQ(Read(0x1301U, 1U), 0U);
        EXPECT_EQ(Read(0x1301U, 2U), 25U);
        EXPECT_EQ(Read(0x1301U, 3U), 20U);
        EXPECT_EQ(Read(0x1301U, 4U), 254U);
        EXPECT_EQ(Read(0x1301U, 5U), 0x103U);
        EXPECT_EQ(Read(0x1301U, 6U), 0x104U);
        EXPECT_EQ(Read(0x1303U, 1U), 0U);
        EXPECT_EQ(Read(0x1303U, 2U), 25U);
        EXPECT_EQ(Read(0x1303U, 3U), 20U);
        EXPECT_EQ(Read(0x1303U, 4U), 254U);
        EXPECT_EQ(Read(0x1303U, 5U), 0U);
        EXPECT_EQ(Read(0x1303U, 6U), 0U);
        EXPECT_EQ(Read(0x1381U, 0U), 0U);
        EXPECT_EQ(Read(0x1381U, 1U), 0U);
        EXPECT_EQ(Read(0x1381U, 2U), 0U);
        EXPECT_EQ(Read(0x1383U, 0U), 0U);
        EXPECT_EQ(Read(0x1383U, 1U), 0U);
        EXPECT_EQ(Read(0x1383U, 2U), 0U);
        EXPECT_EQ(Read(0x13FFU, 3U), 0U);
        EXPECT_EQ(Read(0x13FEU, 0U), 0U);
        EXPECT_EQ(Read(0x13FFU, 1U), 0U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    }
    void Restart()
    {
        ASSERT_EQ(kernel.Start(config, FlowCallback::kOff), StartResult::kStarted);
    }
};

TEST_F(StoredConfiguration, ItemsAreInTheOrderOfTheRequirement)
{
    Verifies(req::SRS_CFG_051);
    Verifies(req::SRS_CFG_216);
    Configure();
    const Image image = Save();
    EXPECT_EQ(image.header.count, kItems);
    EXPECT_EQ(image.header.valid, 0xA5U);
    ASSERT_EQ(image.items.size(), kItems);
    EXPECT_EQ(image.items[0], Read(0x13FFU, 1U));
    EXPECT_EQ(image.items[1], 2U);
    EXPECT_EQ(image.items[2], 50U);
    EXPECT_EQ(image.items[3], 20U);
    EXPECT_EQ(image.items[4], 254U);
    EXPECT_EQ(image.items[5], 0x101U);
    EXPECT_EQ(image.items[6], 0x102U);
    EXPECT_EQ(image.items[7], 2U);
    EXPECT_EQ(image.items[8], 0x22000110U);
    EXPECT_EQ(image.items[9], 0x23000110U);
    EXPECT_EQ(image.items[23], 0U);
    EXPECT_EQ(image.items[24], Read(0x13FFU, 3U));
    EXPECT_EQ(image.items[25], 1U);
    EXPECT_EQ(image.items[72], 1U);
    EXPECT_EQ(kernel.Image().ReadItem(kItems).result, Result::kNotExist);
    EXPECT_EQ(kernel.Image().ReadItem(kItems).value, 0U);
}

TEST_F(StoredConfiguration, CrcCoversAddressesValuesAndValidity)
{
    Verifies(req::SRS_CFG_215);
    Configure();
    const Image image = Save();
    EXPECT_EQ(image.header.crc, image::CrcOf(image::WordsOf(image.items, 0xA5U)));
    // Given the power-on values of node-ID 2, then it is that of any other CRC-32 (computed with Python's zlib)
    Restart();
    EXPECT_EQ(Save().header.crc, 0x54B2E91FU);
}

TEST_F(StoredConfiguration, SavedConfigurationComesBackAfterPowerOnAndIsValid)
{
    Verifies(req::SRS_CFG_052);
    Verifies(req::SRS_CFG_212);
    Configure();
    const Image image = Save();
    Restart();
    HasDefaults();
    EXPECT_EQ(Load(image), Result::kSuccessful);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    EXPECT_EQ(Read(0x1381U, 1U), 0x22000110U);
    EXPECT_EQ(kernel.CheckConfiguration().result, Result::kSuccessful);
    // and works
    kernel.SetNmtState(NmtState::kOperational);
    Cycle();
    ReceivePair();
    Cycle();
    EXPECT_EQ(Open(), 1U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(StoredConfiguration, ConfigurationThatWasNotValidComesBackNotValid)
{
    Verifies(req::SRS_CFG_052);
    Verifies(req::SRS_CFG_212);
    Configure();
    ASSERT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
    const Image image = Save();
    EXPECT_EQ(image.header.valid, 0U);
    Restart();
    EXPECT_EQ(Load(image), Result::kSuccessful);
    EXPECT_EQ(Read(0x1301U, 1U), 2U);
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
}

TEST_F(StoredConfiguration, EveryChangedItemOrHeaderIsDamaged)
{
    Verifies(req::SRS_CFG_211);
    Verifies(req::SRS_CFG_213);
    Configure();
    const Image good = Save();
    for (std::uint32_t number = 0U; number < kItems; ++number)
    {
        Image image = good;
        image.items[number] ^= 1U;
        EXPECT_EQ(Load(image), Result::kDamagedImage) << number;
        HasDefaults();
    }
    Image image = good;
    image.header.crc ^= 0x80000000U;
    EXPECT_EQ(Load(image), Result::kDamagedImage);
    image = good;
    image.header.valid = 0U;
    EXPECT_EQ(Load(image), Result::kDamagedImage);
    HasDefaults();
    EXPECT_EQ(Load(good), Result::kSuccessful);
}

TEST_F(StoredConfiguration, ValuesWiderThanTheirItemAreRefusedAtOnce)
{
    Verifies(req::SRS_CFG_052);
    Verifies(req::SRS_CFG_210);
    Verifies(req::SRS_CFG_213);
    Configure();
    const Image good = Save();
    EXPECT_EQ(kernel.Image().LoadItem(kDirectionOfFirst, 0x102U), Result::kDamagedImage);
    EXPECT_EQ(kernel.Image().LoadItem(kSctOfFirst, 0x10000U), Result::kDamagedImage);
    EXPECT_EQ(kernel.Image().LoadItem(kGfcItem, 2U), Result::kDamagedImage);
    EXPECT_EQ(kernel.Image().LoadItem(5U, 0xFFFFFFFFU), Result::kSuccessful);
    EXPECT_EQ(kernel.Image().LoadItem(kItems, 0U), Result::kNotExist);
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
    EXPECT_EQ(kernel.Image().Load(good.header), Result::kDamagedImage);
    HasDefaults();
}

TEST_F(StoredConfiguration, AnotherNumberOfItemsIsForeign)
{
    Verifies(req::SRS_CFG_211);
    Verifies(req::SRS_CFG_213);
    Configure();
    Image image = Save();
    for (const std::uint32_t count : {0U, 72U, 74U, 0xFFFFFFFFU})
    {
        image.header.count = count;
        EXPECT_EQ(Load(image), Result::kForeignImage) << count;
        HasDefaults();
    }
}

TEST_F(StoredConfiguration, DeviceWithAnotherNumberOfAnSrdoDoesNotTakeIt)
{
    Verifies(req::SRS_CFG_211);
    Verifies(req::SRS_CFG_213);
    Configure();
    const Image image = Save();
    setups[2].number = 5U;
    Restart();
    EXPECT_EQ(Load(image), Result::kDamagedImage);
    HasDefaults();
}

// Given a header that fits, the rules decide.
TEST_F(StoredConfiguration, ConfigurationThatBreaksARuleIsRefusedWithItsResult)
{
    Verifies(req::SRS_CFG_212);
    Verifies(req::SRS_CFG_213);
    Configure();
    Image image = Save();
    ASSERT_EQ(Write(0x1301U, 2U, 60U, 2U), AbortCode::kNone); // no longer the signature
    const Image changed = Save();
    // and a header for it that claims A5h
    image.items = changed.items;
    image.header = ImageHeader{kItems, image::CrcOf(image::WordsOf(changed.items, 0xA5U)), 0xA5U};
    EXPECT_EQ(Load(image), Result::kSignatureError);
    HasDefaults();
}

TEST_F(StoredConfiguration, ConfigurationThatBreaksSeveralRulesIsRefusedWithTheResultOfTheFirst)
{
    Verifies(req::SRS_CFG_212);
    Configure();
    // Given an image whose SRVT is SCT, so that its signature is wrong, too, and another digest than expected
    ASSERT_EQ(Write(0x1301U, 3U, 50U, 1U), AbortCode::kNone);
    Image image = Save();
    image.header = ImageHeader{kItems, image::CrcOf(image::WordsOf(image.items, 0xA5U)), 0xA5U};
    config.digest = 0x12345678U;
    Restart();
    // When it is loaded, then the timing error comes before both
    EXPECT_EQ(Load(image), Result::kTimingError);
    HasDefaults();
}

TEST_F(StoredConfiguration, AnotherDigestThanExpectedIsRefused)
{
    Verifies(req::SRS_CFG_212);
    Verifies(req::SRS_CFG_213);
    Verifies(req::SRS_CFG_151);
    Configure();
    const Image image = Save();
    config.digest = 0x12345678U;
    Restart();
    EXPECT_EQ(Load(image), Result::kInvalidConfiguration);
    HasDefaults();
}

TEST_F(StoredConfiguration, CopiesThatDifferAreADeviceFault)
{
    Verifies(req::SRS_CFG_051);
    Configure();
    b.load_flip = 1U;
    EXPECT_EQ(kernel.Image().ReadItem(0U).result, Result::kDeviceFault);
    EXPECT_EQ(kernel.Image().Header().result, Result::kDeviceFault);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kConfiguration);
}

// Slot 1 of three: neither the first item nor the last one.
TEST_F(StoredConfiguration, OneItemThatDiffersIsEnough)
{
    Verifies(req::SRS_CFG_051);
    Configure();
    b.load_slot = 1U;
    b.load_flip = 1U;
    EXPECT_EQ(kernel.Image().ReadItem(0U).result, Result::kSuccessful);
    EXPECT_EQ(kernel.Image().ReadItem(kGfcItem).result, Result::kSuccessful);
    EXPECT_EQ(kernel.Image().Header().result, Result::kDeviceFault);
}

// Given a header that fits what is left when items that differ read 0.
TEST_F(StoredConfiguration, ImageIsNotLoadedIntoCopiesThatDiffer)
{
    Verifies(req::SRS_CFG_051);
    Verifies(req::SRS_CFG_211);
    Verifies(req::SRS_CFG_213);
    Configure();
    std::vector<std::uint32_t> items = Save().items;
    std::fill(items.begin() + 48, items.begin() + 72, 0U);
    b.load_slot = 2U;
    b.load_flip = 1U;
    const ImageHeader header{kItems, image::CrcOf(image::WordsOf(items, 0U)), 0U};
    EXPECT_EQ(kernel.Image().Load(header), Result::kDeviceFault);
    // and the power-on configuration is there
    b.load_flip = 0U;
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
    EXPECT_EQ(Read(0x1301U, 1U), 0U);
    EXPECT_EQ(Read(0x1301U, 2U), 25U);
    EXPECT_EQ(Read(0x1381U, 0U), 0U);
}

TEST_F(StoredConfiguration, HeaderAloneTakesTheValidityBack)
{
    Verifies(req::SRS_CFG_211);
    Verifies(req::SRS_CFG_212);
    Configure();
    ASSERT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
    const Image image = Save();
    ASSERT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    EXPECT_EQ(kernel.Image().Load(image.header), Result::kSuccessful);
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
}

// Items of SRDO 4 begin at 48: the map count is 55, the entries behind it.
TEST_F(StoredConfiguration, EntriesBehindAStaticMappingReadZero)
{
    Verifies(req::SRS_CFG_217);
    static constexpr std::uint32_t kEntries[] = {0x22000110U, 0x23000110U};
    setups[2].map = StaticMap{kEntries, 2U};
    Configure();
    const Image image = Save();
    ASSERT_EQ(image.items.size(), kItems);
    EXPECT_EQ(image.items[55], 2U);
    EXPECT_EQ(image.items[56], 0x22000110U);
    EXPECT_EQ(image.items[57], 0x23000110U);
    for (std::uint32_t number = 58U; number < kGfcItem; ++number)
    {
        EXPECT_EQ(image.items[number], 0U) << number;
    }
}

TEST_F(StoredConfiguration, StaticMappingIsNeitherLoadedNorRestored)
{
    Verifies(req::SRS_CFG_052);
    Verifies(req::SRS_CFG_053);
    static constexpr std::uint32_t kEntries[] = {0x22000110U, 0x23000110U};
    setups[2].map = StaticMap{kEntries, 2U};
    Configure();
    // Given the map count of SRDO 4, item 55
    EXPECT_EQ(kernel.Image().LoadItem(55U, 0x102U), Result::kSuccessful);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    EXPECT_EQ(kernel.Image().RestoreDefaults(), Result::kSuccessful);
    EXPECT_EQ(Read(0x1384U, 0U), 2U);
    EXPECT_EQ(Read(0x1384U, 1U), 0x22000110U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
}

TEST_F(StoredConfiguration, NothingIsLoadedOrRestoredInOperational)
{
    Verifies(req::SRS_CFG_214);
    Verifies(req::SRS_CFG_053);
    Operate();
    const Image image = Save();
    EXPECT_EQ(kernel.Image().LoadItem(0U, 0U), Result::kNmtError);
    EXPECT_EQ(kernel.Image().Load(image.header), Result::kNmtError);
    EXPECT_EQ(kernel.Image().RestoreDefaults(), Result::kNmtError);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    EXPECT_EQ(Read(0x1301U, 1U), 2U);
    EXPECT_EQ(Save().items, image.items);
}

TEST_F(StoredConfiguration, RestoredDefaultsAreThePowerOnConfiguration)
{
    Verifies(req::SRS_CFG_053);
    Configure();
    EXPECT_EQ(kernel.Image().RestoreDefaults(), Result::kSuccessful);
    HasDefaults();
}

TEST_F(StoredConfiguration, DefaultsFollowTheNodeId)
{
    Verifies(req::SRS_CFG_053);
    Verifies(req::SRS_CFG_002);
    for (const std::uint8_t node : std::initializer_list<std::uint8_t>{1, 32, 33, 64, 65, 127})
    {
        config.node_id = node;
        Restart();
        const Image power_on = Save();
        ASSERT_EQ(Write(0x1301U, 2U, 99U, 2U), AbortCode::kNone);
        ASSERT_EQ(Write(0x1301U, 3U, 9U, 1U), AbortCode::kNone);
        ASSERT_EQ(Write(0x1301U, 5U, 0x151U, 4U), AbortCode::kNone);
        ASSERT_EQ(Write(0x1301U, 6U, 0x152U, 4U), AbortCode::kNone);
        EXPECT_EQ(kernel.Image().RestoreDefaults(), Result::kSuccessful);
        EXPECT_EQ(Save().items, power_on.items) << static_cast<int>(node);
    }
}

TEST_F(StoredConfiguration, RemovedGfcParameterReadsZeroAndIsNotLoaded)
{
    Verifies(req::SRS_CFG_217);
    Verifies(req::SRS_CFG_052);
    Verifies(req::SRS_CFG_211);
    Configure();
    const Image with_gfc = Save();
    config.gfc = GfcUse::kRemoved;
    has_gfc = false;
    Configure();
    const Image image = Save();
    EXPECT_EQ(image.items[kGfcItem], 0U);
    EXPECT_EQ(Load(image), Result::kSuccessful);
    EXPECT_EQ(kernel.Image().LoadItem(kGfcItem, 1U), Result::kSuccessful);
    EXPECT_EQ(kernel.Image().ReadItem(kGfcItem).value, 0U);
    EXPECT_EQ(Load(with_gfc), Result::kDamagedImage);
}

TEST_F(StoredConfiguration, EachItemTakesTheWidestValueThatItHasRoomForAndNoMore)
{
    Verifies(req::SRS_CFG_210);
    Configure();
    // Signature, direction, SCT, SRVT, transmission type, and behind the COB-IDs the map count
    constexpr std::uint32_t kPlaces[] = {0U, 1U, 2U, 3U, 4U, 7U};
    constexpr std::uint32_t kWidest[] = {0xFFFFU, 0xFFU, 0xFFFFU, 0xFFU, 0xFFU, 0xFFU};
    for (const std::uint32_t first : {0U, 24U, 48U})
    {
        for (std::uint32_t place = 0U; place < 6U; ++place)
        {
            const std::uint32_t number = first + kPlaces[place];
            EXPECT_EQ(kernel.Image().LoadItem(number, kWidest[place]), Result::kSuccessful) << number;
            EXPECT_EQ(kernel.Image().LoadItem(number, kWidest[place] + 1U), Result::kDamagedImage) << number;
            EXPECT_EQ(kernel.Image().LoadItem(number, 0x80000000U), Result::kDamagedImage) << number;
            EXPECT_EQ(kernel.Image().ReadItem(number).value, kWidest[place]) << number;
        }
    }
    EXPECT_EQ(kernel.Image().LoadItem(kGfcItem, 1U), Result::kSuccessful);
    EXPECT_EQ(kernel.Image().LoadItem(kGfcItem, 2U), Result::kDamagedImage);
    EXPECT_EQ(kernel.Image().ReadItem(kGfcItem).value, 1U);
    for (const std::uint32_t behind : {kItems, kItems + 1U, 0xFFFFFFFFU})
    {
        EXPECT_EQ(kernel.Image().LoadItem(behind, 0U), Result::kNotExist) << behind;
        EXPECT_EQ(kernel.Image().ReadItem(behind).result, Result::kNotExist) << behind;
    }
}

TEST_F(StoredConfiguration, EveryItemIsThatOfItsObjectAndIsRestored)
{
    Verifies(req::SRS_CFG_052);
    Verifies(req::SRS_CFG_053);
    Verifies(req::SRS_CFG_216);
    Restart();
    const Image power_on = Save();
    // Given another value in each item
    for (std::uint32_t number = 0U; number < kGfcItem; ++number)
    {
        ASSERT_EQ(kernel.Image().LoadItem(number, number + 100U), Result::kSuccessful);
    }
    ASSERT_EQ(kernel.Image().LoadItem(kGfcItem, 1U), Result::kSuccessful);
    std::uint32_t number = 0U;
    for (const std::uint16_t srdo : std::initializer_list<std::uint16_t>{1U, 3U, 4U})
    {
        EXPECT_EQ(Read(0x13FFU, static_cast<std::uint8_t>(srdo)), number + 100U);
        for (std::uint8_t sub = 1U; sub <= 6U; ++sub)
        {
            EXPECT_EQ(Read(static_cast<std::uint16_t>(0x1300U + srdo), sub), number + sub + 100U);
        }
        for (std::uint8_t sub = 0U; sub <= 16U; ++sub)
        {
            EXPECT_EQ(Read(static_cast<std::uint16_t>(0x1380U + srdo), sub), number + sub + 107U);
        }
        number += 24U;
    }
    EXPECT_EQ(Read(0x1300U, 0U), 1U);
    // When the defaults are restored, then each is as it was
    EXPECT_EQ(kernel.Image().RestoreDefaults(), Result::kSuccessful);
    EXPECT_EQ(Save().items, power_on.items);
}

TEST_F(StoredConfiguration, ItemThatOneChannelDoesNotKeepIsADeviceFault)
{
    Verifies(req::SRS_CFG_047);
    for (Tap* const tap : {&a, &b})
    {
        Configure();
        ASSERT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
        tap->drop_store = true;
        (void)kernel.Image().LoadItem(26U, 99U);
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kConfiguration);
        EXPECT_EQ(kernel.DeviceState().slot, 1U);
        tap->drop_store = false;
        // SRDO 1 alone has other values than the defaults in its first items
        Configure();
        ASSERT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
        tap->drop_store = true;
        (void)kernel.Image().RestoreDefaults();
        EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kConfiguration);
        EXPECT_EQ(kernel.DeviceState().slot, 0U);
        tap->drop_store = false;
    }
}

} // namespace
} // namespace counterpoint
