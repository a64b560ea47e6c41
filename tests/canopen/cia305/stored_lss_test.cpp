// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia305/stored_lss.hpp"
#include "tests/canopen/cia301/cut_memory.hpp"
#include "verification/trace/ids/lss.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::cia305
{
namespace
{

using cia301::CutMemory;
using cia301::ParameterStore;
using cia301::Room;
using cia301::StoreAction;
using cia301::StoredPart;
using cia301::StoreParts;
using cia301::StoreRequest;

class StoredLssTest : public ::testing::Test
{
  public:
    /// Cycles until the settings are kept.
    LssStored Keep(const LssSettings& settings)
    {
        LssStored stored = lss.Keep(settings, store);
        for (int i = 0; (i < 100) && (stored == LssStored::kPending); ++i)
        {
            store.OnCycle();
            stored = lss.Keep(settings, store);
        }
        return stored;
    }
    LssSettings Restarted()
    {
        lss = StoredLss{LssSettings{kNoNodeId, {2U}}};
        EXPECT_TRUE(store.Mount());
        static_cast<void>(store.Load(cia301::kLssGroup));
        return lss.Settings();
    }

    CutMemory memory{128U};
    StoredLss lss{LssSettings{kNoNodeId, {2U}}};
    std::array<StoredPart*, 1> parts{&lss};
    std::array<std::uint8_t, 64> scratch{};
    ParameterStore store{StoreParts{memory, parts.data(), 1U, Room{scratch.data(), 64U}}};
};

TEST_F(StoredLssTest, SettingsOutliveTheirPowerAndTheDefaultsOfTheApplication)
{
    Verifies(req::SRS_LSS_012);
    EXPECT_EQ(Keep(LssSettings{42U, {4U}}), LssStored::kDone);
    EXPECT_EQ(Restarted().node_id, 42U);
    EXPECT_EQ(lss.Settings().timing.index, 4U);
    // When the defaults of the application are restored
    const StoreRequest forget{StoreAction::kForget, cia301::kAllGroups};
    EXPECT_EQ(store.Begin(forget), cia301::SdoAbort::kPending);
    EXPECT_EQ(lss.Keep(LssSettings{43U, {4U}}, store), LssStored::kPending); // it comes later
    while (store.IsBusy())
    {
        store.OnCycle();
    }
    EXPECT_EQ(store.Continue(forget), cia301::SdoAbort::kNone);
    // Then the node-ID is still there
    EXPECT_EQ(Restarted().node_id, 42U);
    // nor does a save of the application keep one that LSS did not save
    lss = StoredLss{LssSettings{77U, {3U}}};
    const StoreRequest save{StoreAction::kSave, cia301::kAllGroups};
    EXPECT_EQ(store.Begin(save), cia301::SdoAbort::kPending);
    while (store.IsBusy())
    {
        store.OnCycle();
    }
    EXPECT_EQ(store.Continue(save), cia301::SdoAbort::kNone);
    EXPECT_EQ(Restarted().node_id, 42U);
    EXPECT_EQ(lss.Settings().timing.index, 4U);
    EXPECT_EQ(Keep(LssSettings{43U, {4U}}), LssStored::kDone);
    EXPECT_EQ(Restarted().node_id, 43U);
    const std::uint8_t wrong[3] = {1U, 2U, 3U};
    EXPECT_FALSE(lss.LoadItem({wrong, 3U}));
}

// t [cycles]   0 save of 33      moment: save of 44      end
TEST_F(StoredLssTest, SettingsThatComeWithinASaveOfOthersAreSavedBehindIt)
{
    Verifies(req::SRS_LSS_013);
    int moment = 0;
    for (LssStored first = LssStored::kPending; first == LssStored::kPending; ++moment)
    {
        SCOPED_TRACE(moment);
        for (int i = 0; (i <= moment) && (first == LssStored::kPending); ++i)
        {
            first = lss.Keep(LssSettings{33U, {4U}}, store);
            store.OnCycle();
        }
        EXPECT_EQ(Keep(LssSettings{44U, {4U}}), LssStored::kDone);
        EXPECT_EQ(lss.Settings().node_id, 44U);
        EXPECT_EQ(Restarted().node_id, 44U);
        // Another bit timing is another setting, too
        EXPECT_EQ(lss.Keep(LssSettings{44U, {2U}}, store), LssStored::kPending);
        EXPECT_EQ(Keep(LssSettings{44U, {3U}}), LssStored::kDone);
        EXPECT_EQ(Restarted().timing.index, 3U);
    }
    EXPECT_GT(moment, 10);
}

TEST_F(StoredLssTest, AMemoryThatFailsIsTold)
{
    Verifies(req::SRS_LSS_006);
    memory.is_failed = true;
    EXPECT_EQ(Keep(LssSettings{42U, {4U}}), LssStored::kFailed);
}

} // namespace
} // namespace counterpoint::cia305
