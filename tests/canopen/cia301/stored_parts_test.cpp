// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/sdo/server_port.hpp"
#include "canopen/cia301/store/stored_parts.hpp"
#include "tests/canopen/cia301/cut_memory.hpp"
#include "tests/canopen/cia301/service_rig.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/pdo.hpp"
#include "verification/trace/ids/store.hpp"

namespace counterpoint::cia301
{
namespace
{

/// The device of ServiceRig with its PDO objects and 1010h, 1011h in a dictionary of their own, behind an SDO server.
class StoredPartsTest : public ServiceRig
{
  public:
    StoredPartsTest()
    {
        Add(0x1010U, 1U, 4U, store_objects, 0U);
        Add(0x1010U, 3U, 4U, store_objects, 0U);
        Add(0x1011U, 1U, 4U, store_objects, 0U);
        Add(0x1011U, 4U, 4U, store_objects, 0U);
        Add(0x1800U, 1U, 4U, objects, kStored);
        Add(0x1800U, 2U, 1U, objects, kStored);
        Add(0x1A00U, 0U, 1U, objects, kStored);
        Add(0x1A00U, 1U, 4U, objects, kStored);
        table[count++] = {0x2200U,
                          0U,
                          DataType::kUnsigned16,
                          Access::kReadWrite,
                          kInBoth,
                          kInBoth,
                          2U,
                          manufacturer.data(),
                          nullptr,
                          nullptr,
                          nullptr,
                          nullptr,
                          kStored};
        table[count++] = {0x6000U,
                          0U,
                          DataType::kUnsigned8,
                          Access::kReadWrite,
                          kInBoth,
                          kInBoth,
                          1U,
                          application.data(),
                          nullptr,
                          nullptr,
                          nullptr,
                          nullptr,
                          kStored};
        stored_dictionary.SetNmtState(NmtState::kPreOperational);
        Command(128U);
    }
    void Add(std::uint16_t index, std::uint8_t sub, std::uint32_t size, NumberHook& hook, std::uint8_t uses)
    {
        table[count++] = {index,
                          sub,
                          DataType::kUnsigned32,
                          Access::kReadWrite,
                          kInBoth,
                          kInPreOperational,
                          size,
                          nullptr,
                          nullptr,
                          nullptr,
                          &hook,
                          &hook,
                          uses};
    }
    /// Expedited download by SDO; the code of the answer after so many cycles, FFFFFFFFh: there is none.
    std::uint32_t Download(const Octets& request, int cycles = 300)
    {
        CanFrame frame{0x605U, FrameKind::kData, CanPortId::kFirst, 8U, {}};
        std::copy(request.begin(), request.end(), frame.data);
        port.OnFrame(frame, Now());
        for (int i = 0; i < cycles; ++i)
        {
            now_us += 1000U;
            store.OnCycle();
            port.OnCycle(Now());
        }
        const Octets answer = sink.Next();
        std::uint32_t code = 0xFFFFFFFFU;
        if (!answer.empty())
        {
            code = (answer[0] == 0x60U) ? 0U : static_cast<std::uint32_t>(FromLittleEndian(&answer[4], 4U));
        }
        return code;
    }
    void Restart()
    {
        manufacturer = {0U, 0U};
        application = {0U};
        tpdos.Reset();
        EXPECT_TRUE(store.Mount());
        report = store.Load(kAllGroups);
    }

    std::array<std::uint8_t, 2> manufacturer{0x34U, 0x12U};
    std::array<std::uint8_t, 1> application{0x77U};
    std::array<Entry, 12> table{};
    std::uint32_t count{0U};
    std::array<std::uint8_t, 64> scratch{};
    std::array<std::uint8_t, 16> buffer{};
    LoadReport report{StoreFinding::kInvalid, false, 0U, 0U};
    CutMemory memory{512U};
    Dictionary stored_dictionary{EntryTable{table.data(), 10U}, foreign};
    StoredEntries stored_entries{EntryTable{table.data(), 10U}, stored_dictionary, tpdos, rpdos};
    std::array<StoredPart*, 1> parts{&stored_entries};
    ParameterStore store{StoreParts{memory, parts.data(), 1U, Room{scratch.data(), 64U}}};
    StoreObjects store_objects{store};
    SdoServer server{SdoServerParts{stored_dictionary, Room{buffer.data(), 16U}, 5000U, 127U}};
    SdoServerPort port{server, sink, NodeId{5U}};
};

const Octets kSaveAllRequest{0x23U, 0x10U, 0x10U, 1U, 's', 'a', 'v', 'e'};

TEST_F(StoredPartsTest, SaveIsAnsweredWhenItIsDoneAndDoesNotTimeOut)
{
    Verifies(req::SRS_STO_003);
    Verifies(req::SRS_STO_005);
    Verifies(req::SRS_STO_006);
    Verifies(req::SRS_SDO_017);
    Verifies(req::SRS_OBD_015);
    memory.busy_for = 8; // longer than the server's time-out of 5 cycles
    EXPECT_EQ(Download(kSaveAllRequest, 12), 0xFFFFFFFFU);
    EXPECT_TRUE(server.IsBusy());
    Octets answer{};
    for (int i = 0; (i < 300) && answer.empty(); ++i)
    {
        now_us += 1000U;
        store.OnCycle();
        port.OnCycle(Now());
        answer = sink.Next();
    }
    EXPECT_EQ(answer, (Octets{0x60U, 0x10U, 0x10U, 1U, 0U, 0U, 0U, 0U}));
    EXPECT_FALSE(server.IsBusy());
    // An abort of the client ends the waiting; the store goes on
    EXPECT_EQ(Download(kSaveAllRequest, 3), 0xFFFFFFFFU);
    EXPECT_EQ(Download({0x80U, 0x10U, 0x10U, 1U}, 3), 0xFFFFFFFFU);
    EXPECT_FALSE(server.IsBusy());
    EXPECT_TRUE(store.IsBusy());
}

// t [cycles]   0 save of 1      moment: its client gives up or not, at once or now; write of 2, save      end
TEST_F(StoredPartsTest, ASaveThatMeetsOneUnderWayIsNotAnsweredByIt)
{
    Verifies(req::SRS_STO_020);
    const Octets give_up{0x80U, 0x10U, 0x10U, 1U, 0U, 0U, 4U, 5U};
    for (const bool is_early : {false, true})
    {
        int refused = 0;
        int moment = 0;
        for (std::uint32_t first = 0xFFFFFFFFU; first != 0U; ++moment)
        {
            SCOPED_TRACE(moment);
            manufacturer = {1U, 1U};
            if (is_early)
            {
                EXPECT_EQ(Download(kSaveAllRequest, 0), 0xFFFFFFFFU);
                EXPECT_EQ(Download(give_up, moment), 0xFFFFFFFFU);
                first = (moment > 200) ? 0U : first; // Long behind the end.
            }
            else
            {
                first = Download(kSaveAllRequest, moment);
                EXPECT_EQ(Download(give_up, 0), 0xFFFFFFFFU);
            }
            manufacturer = {2U, 2U};
            // Then it is refused, or a save of its own
            const std::uint32_t second = Download(kSaveAllRequest);
            EXPECT_TRUE((second == 0U) || (second == 0x08000021U));
            Restart();
            EXPECT_TRUE((second != 0U) || (manufacturer[0] == 2U));
            refused += (second == 0U) ? 0 : 1;
            manufacturer = {3U, 3U};
            EXPECT_EQ(Download(kSaveAllRequest), 0U);
            Restart();
            EXPECT_EQ(manufacturer[0], 3U);
        }
        EXPECT_GT(refused, 10);
        EXPECT_GT(moment, refused);
    }
}

TEST_F(StoredPartsTest, ASaveOfASecondClientIsNotAnsweredByThatOfTheFirst)
{
    Verifies(req::SRS_STO_020);
    Verifies(req::SRS_OBD_015);
    std::array<std::uint8_t, 16> second_buffer{};
    SdoServer second{SdoServerParts{stored_dictionary, Room{second_buffer.data(), 16U}, 5000U, 127U}};
    SdoFrame request{};
    std::copy(kSaveAllRequest.begin(), kSaveAllRequest.end(), request.bytes);
    manufacturer = {1U, 1U};
    EXPECT_EQ(Download(kSaveAllRequest, 10), 0xFFFFFFFFU);
    manufacturer = {2U, 2U};
    const SdoAnswer answer = second.OnFrame(request, 8U, Instant{now_us});
    EXPECT_EQ(answer.presence, SdoPresence::kFrame);
    EXPECT_EQ(answer.frame.bytes[0], 0x80U);
    EXPECT_EQ(FromLittleEndian(&answer.frame.bytes[4], 4U), 0x08000021U);
    EXPECT_FALSE(second.IsBusy());
    // And the first client has its answer
    Octets first{};
    for (int i = 0; (i < 300) && first.empty(); ++i)
    {
        now_us += 1000U;
        store.OnCycle();
        port.OnCycle(Now());
        first = sink.Next();
    }
    EXPECT_EQ(first, (Octets{0x60U, 0x10U, 0x10U, 1U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(second.OnFrame(request, 8U, Instant{now_us}).presence, SdoPresence::kNothing);
    for (int i = 0; (i < 300) && second.IsBusy(); ++i)
    {
        store.OnCycle();
        static_cast<void>(second.Poll(Instant{now_us}));
    }
    Restart();
    EXPECT_EQ(manufacturer[0], 2U);
}

TEST_F(StoredPartsTest, SignaturesAndSubIndices)
{
    Verifies(req::SRS_STO_003);
    Verifies(req::SRS_STO_004);
    EXPECT_EQ(Read(store_objects, 0x1010U, 0U), 0x100000004U);
    EXPECT_EQ(Read(store_objects, 0x1011U, 0U), 0x100000004U);
    EXPECT_EQ(Read(store_objects, 0x1010U, 4U), 0x400000001U);
    EXPECT_EQ(Read(store_objects, 0x1011U, 1U), 0x400000001U);
    EXPECT_EQ(Write(store_objects, 0x1010U, 5U, 0x65766173U), SdoAbort::kSubUnknown);
    EXPECT_EQ(Write(store_objects, 0x1010U, 0U, 4U), SdoAbort::kReadOnly);
    EXPECT_EQ(Write(store_objects, 0x1012U, 1U, 4U), SdoAbort::kObjectUnknown);
    EXPECT_EQ(Download({0x23U, 0x10U, 0x10U, 1U, 'l', 'o', 'a', 'd'}), 0x08000020U);
    EXPECT_EQ(Download({0x23U, 0x11U, 0x10U, 1U, 's', 'a', 'v', 'e'}), 0x08000020U);
    EXPECT_EQ(Download({0x23U, 0x10U, 0x10U, 1U, 'S', 'A', 'V', 'E'}), 0x08000020U);
    EXPECT_FALSE(memory.is_misused);
    EXPECT_EQ(memory.bytes_left, CutMemory::kEndless);
}

TEST_F(StoredPartsTest, InOperationalNothingIsStored)
{
    Verifies(req::SRS_STO_008);
    Command(1U);
    stored_dictionary.SetNmtState(NmtState::kOperational);
    EXPECT_EQ(Download(kSaveAllRequest), 0x08000022U);
    EXPECT_EQ(Download({0x23U, 0x11U, 0x10U, 1U, 'l', 'o', 'a', 'd'}), 0x08000022U);
}

TEST_F(StoredPartsTest, EntriesComeBackAndPdosWork)
{
    Verifies(req::SRS_STO_011);
    Verifies(req::SRS_PDO_007);
    Verifies(req::SRS_STO_004);
    EXPECT_EQ(WritePdo(0x1A00U, 1U, 0x21000008U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1A00U, 0U, 1U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1800U, 2U, 1U), SdoAbort::kNone);
    EXPECT_EQ(WritePdo(0x1800U, 1U, 0x185U), SdoAbort::kNone);
    EXPECT_EQ(Download(kSaveAllRequest), 0U);
    Restart();
    EXPECT_EQ(report.loaded, 6U);
    EXPECT_EQ(report.refused, 0U);
    EXPECT_EQ(manufacturer[1], 0x12U);
    EXPECT_EQ(application[0], 0x77U);
    EXPECT_EQ(Read(objects, 0x1800U, 1U), 0x400000185U);
    Command(1U);
    Sync0();
    EXPECT_EQ(sink.Next(), (Octets{0x11U}));
    // The application's group alone, then the manufacturer's defaults
    Command(128U);
    manufacturer = {9U, 9U};
    application = {9U};
    EXPECT_EQ(Download({0x23U, 0x10U, 0x10U, 3U, 's', 'a', 'v', 'e'}), 0U);
    Restart();
    EXPECT_EQ(manufacturer[1], 0x12U);
    EXPECT_EQ(application[0], 9U);
    EXPECT_EQ(Download({0x23U, 0x11U, 0x10U, 4U, 'l', 'o', 'a', 'd'}), 0U);
    EXPECT_EQ(manufacturer[1], 0x12U); // until the reset
    Restart();
    EXPECT_EQ(manufacturer[1], 0U);
    EXPECT_EQ(application[0], 9U);
    EXPECT_EQ(Download({0x23U, 0x11U, 0x10U, 1U, 'l', 'o', 'a', 'd'}), 0U);
    Restart();
    EXPECT_EQ(report.loaded, 0U);
    EXPECT_EQ(Read(objects, 0x1800U, 1U), 0x4C0000000U);
}

TEST_F(StoredPartsTest, EachSubIndexStoresItsGroupAndKeepsTheOthers)
{
    Verifies(req::SRS_STO_003);
    struct Row
    {
        std::uint8_t sub;
        std::uint64_t communication; ///< Of 1800h:02, of 1 byte.
        std::uint8_t application;
        std::uint8_t manufacturer;
    };
    for (const Row& row : {Row{1U, 0x100000002U, 2U, 2U}, Row{2U, 0x100000002U, 1U, 1U}, Row{3U, 0x100000001U, 2U, 1U},
                           Row{4U, 0x100000001U, 1U, 2U}})
    {
        // Given all groups stored with 1, then with 2 in the device
        EXPECT_EQ(WritePdo(0x1800U, 2U, 1U), SdoAbort::kNone);
        application = {1U};
        manufacturer = {1U, 0U};
        table[1].sub = 3U;
        EXPECT_EQ(Download(kSaveAllRequest), 0U);
        EXPECT_EQ(WritePdo(0x1800U, 2U, 2U), SdoAbort::kNone);
        application = {2U};
        manufacturer = {2U, 0U};
        // When save is written to one sub-index
        table[1].sub = (row.sub == 1U) ? std::uint8_t{3U} : row.sub;
        EXPECT_EQ(Download({0x23U, 0x10U, 0x10U, row.sub, 's', 'a', 'v', 'e'}), 0U);
        Restart();
        // Then its group alone is the new one
        EXPECT_EQ(Read(objects, 0x1800U, 2U), row.communication) << static_cast<int>(row.sub);
        EXPECT_EQ(application[0], row.application) << static_cast<int>(row.sub);
        EXPECT_EQ(manufacturer[0], row.manufacturer) << static_cast<int>(row.sub);
    }
}

TEST_F(StoredPartsTest, AnEntryThatIsGoneOrRefusesIsCounted)
{
    Verifies(req::SRS_STO_007);
    EXPECT_EQ(Download(kSaveAllRequest), 0U);
    table[8].index = 0x2201U; // 2200h is gone
    table[9].size_bytes = 2U; // 6000h has another length
    Restart();
    EXPECT_EQ(report.loaded, 4U);
    EXPECT_EQ(report.refused, 2U);
}

TEST_F(StoredPartsTest, AnEntryThatIsNoLongerStoredIsNotLoaded)
{
    Verifies(req::SRS_STO_011);
    EXPECT_EQ(Download(kSaveAllRequest), 0U);
    table[9].uses = 0U;
    Restart();
    EXPECT_EQ(report.refused, 1U);
    EXPECT_EQ(application[0], 0U);
}

// 9FFFh is the last one of the application's group
TEST_F(StoredPartsTest, AnEntryFromA000hOnIsInNoGroup)
{
    Verifies(req::SRS_STO_011);
    application = {7U};
    table[9].index = 0x9FFFU;
    EXPECT_EQ(Download(kSaveAllRequest), 0U);
    Restart();
    EXPECT_EQ(report.loaded, 6U);
    EXPECT_EQ(application[0], 7U);
    table[9].index = 0xA000U;
    EXPECT_EQ(Download(kSaveAllRequest), 0U);
    Restart();
    EXPECT_EQ(report.loaded, 5U);
    EXPECT_EQ(report.refused, 0U);
    EXPECT_EQ(application[0], 0U);
}

TEST_F(StoredPartsTest, APartThatIsGoneIsCounted)
{
    Verifies(req::SRS_STO_007);
    EXPECT_EQ(Download(kSaveAllRequest), 0U);
    ParameterStore empty{StoreParts{memory, parts.data(), 0U, Room{scratch.data(), 64U}}};
    EXPECT_TRUE(empty.Mount());
    EXPECT_EQ(empty.Load(kAllGroups).refused, 6U);
}

using StoredSafetyTest = Rig;

TEST_F(StoredSafetyTest, TheKernelsConfigurationComesBackValid)
{
    Verifies(req::SRS_STO_012);
    // Given a kernel with a valid configuration that is stored
    Configure();
    std::array<std::uint8_t, 64> scratch{};
    CutMemory memory{8192U};
    StoredSafety safety{kernel};
    std::array<StoredPart*, 1> parts{&safety};
    ParameterStore store{StoreParts{memory, parts.data(), 1U, Room{scratch.data(), 64U}}};
    EXPECT_EQ(store.Begin({StoreAction::kSave, kAllGroups}), SdoAbort::kPending);
    for (int i = 0; (i < 3000) && store.IsBusy(); ++i)
    {
        store.OnCycle();
    }
    EXPECT_EQ(store.Continue({StoreAction::kSave, kAllGroups}), SdoAbort::kNone);
    // When it is changed, and loaded again
    EXPECT_EQ(kernel.Image().RestoreDefaults(), Result::kSuccessful);
    EXPECT_NE(Read(0x13FEU, 0U), 0xA5U);
    const LoadReport report = store.Load(kCommunicationGroup);
    // Then the kernel declares it valid
    EXPECT_EQ(report.refused, 0U);
    EXPECT_GT(report.loaded, 3U);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    // A set of another device leaves the power-on configuration
    const std::uint8_t foreign[10] = {0U, 1U, 0U, 0U, 0U, 9U, 9U, 9U, 9U, 0xA5U};
    safety.BeginLoad(kAllGroups);
    EXPECT_TRUE(safety.LoadItem({foreign, 10U}));
    EXPECT_FALSE(safety.LoadItem({foreign, 4U}));
    EXPECT_FALSE(safety.EndLoad(kAllGroups));
    EXPECT_NE(Read(0x13FEU, 0U), 0xA5U);
}

// t [cycles]   0 save of SCT 50 ms     moment: 60 ms, signed, A5h     end
TEST_F(StoredSafetyTest, ASaveWithinWhichTheConfigurationChangesIsRefused)
{
    Verifies(req::SRS_STO_019);
    Verifies(req::SRS_STO_005);
    Configure();
    std::array<std::uint8_t, 64> scratch{};
    CutMemory memory{8192U};
    StoredSafety safety{kernel};
    std::array<StoredPart*, 1> parts{&safety};
    ParameterStore store{StoreParts{memory, parts.data(), 1U, Room{scratch.data(), 64U}}};
    const auto write = [this](const std::uint32_t sct_ms)
    {
        EXPECT_EQ(Write(0x1301U, 2U, sct_ms, 2U), AbortCode::kNone);
        const SignReply reply = kernel.Sign(CommunicationIndex{0x1301U});
        EXPECT_EQ(Write(0x13FFU, 1U, reply.signature, 2U), AbortCode::kNone);
        EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    };
    std::uint32_t saved_ms = 0U;
    int refused = 0;
    int changes = 0;
    for (int moment = 0; moment < 3000; ++moment)
    {
        SCOPED_TRACE(moment);
        const std::uint32_t before_ms = 50U + static_cast<std::uint32_t>(moment % 2);
        write(before_ms);
        EXPECT_EQ(store.Begin({StoreAction::kSave, kAllGroups}), SdoAbort::kPending);
        bool is_changed = false;
        for (int i = 0; (i < 3000) && store.IsBusy(); ++i)
        {
            if (i == moment)
            {
                write(60U);
                is_changed = true;
            }
            store.OnCycle();
        }
        const SdoAbort answer = store.Continue({StoreAction::kSave, kAllGroups});
        const std::uint32_t last_ms = saved_ms;
        // Then an answer of success means a set that loads, and a refusal leaves the one before
        EXPECT_TRUE((answer == SdoAbort::kNone) || (answer == SdoAbort::kDeviceState));
        EXPECT_EQ(kernel.Image().RestoreDefaults(), Result::kSuccessful);
        const LoadReport report = store.Load(kCommunicationGroup);
        EXPECT_NE(report.finding, StoreFinding::kRefused);
        EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
        saved_ms = Read(0x1301U, 2U);
        EXPECT_TRUE((answer == SdoAbort::kNone) ? ((saved_ms == before_ms) || (is_changed && (saved_ms == 60U)))
                                                : (saved_ms == last_ms));
        refused += (answer == SdoAbort::kNone) ? 0 : 1;
        if (!is_changed)
        {
            break; // Every moment of a save was tried.
        }
        ++changes;
    }
    EXPECT_GT(refused, 3);
    EXPECT_GT(changes, refused);
}

// 50 ms, 60 ms while the values are read, and 50 ms again: neither the first nor the last look sees it.
TEST_F(StoredSafetyTest, AChangeThatIsTakenBackBeforeTheEndIsFound)
{
    Verifies(req::SRS_STO_019);
    Configure();
    std::array<std::uint8_t, 64> scratch{};
    const Room room{scratch.data(), 64U};
    StoredSafety safety{kernel};
    const std::uint32_t items = safety.ItemCount();
    for (std::uint32_t i = 0U; i < items; ++i)
    {
        const std::uint32_t sct_ms = (i == 1U) ? 60U : 50U;
        EXPECT_EQ(Write(0x1301U, 2U, sct_ms, 2U), AbortCode::kNone);
        EXPECT_EQ(safety.Item(i, room).abort, SdoAbort::kNone);
    }
    EXPECT_EQ(Write(0x1301U, 2U, 50U, 2U), AbortCode::kNone);
    const SignReply reply = kernel.Sign(CommunicationIndex{0x1301U});
    EXPECT_EQ(Write(0x13FFU, 1U, reply.signature, 2U), AbortCode::kNone);
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    EXPECT_EQ(safety.EndSave(kAllGroups), SdoAbort::kDeviceState);
    // A save of other groups does not mind
    EXPECT_EQ(safety.EndSave(kApplicationGroup), SdoAbort::kNone);
}

// 1300h may be written while 13FEh is A5h, and stays in force; with 5F04h the next start would refuse it.
TEST_F(StoredSafetyTest, AConfigurationThatTheNextStartWouldRefuseIsNotSaved)
{
    Verifies(req::SRS_STO_021);
    Configure();
    config.digest = kernel.Digest().digest;
    std::array<std::uint8_t, 64> scratch{};
    CutMemory memory{8192U};
    StoredSafety safety{kernel};
    std::array<StoredPart*, 1> parts{&safety};
    ParameterStore store{StoreParts{memory, parts.data(), 1U, Room{scratch.data(), 64U}}};
    const auto save = [&store]
    {
        EXPECT_EQ(store.Begin({StoreAction::kSave, kAllGroups}), SdoAbort::kPending);
        for (int i = 0; (i < 3000) && store.IsBusy(); ++i)
        {
            store.OnCycle();
        }
        return store.Continue({StoreAction::kSave, kAllGroups});
    };
    EXPECT_EQ(save(), SdoAbort::kNone);
    const std::uint32_t gfc = Read(0x1300U, 0U);
    EXPECT_EQ(Write(0x1300U, 0U, 1U - gfc, 1U), AbortCode::kNone);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    // Then it is refused, and the set before is still there
    EXPECT_EQ(save(), SdoAbort::kDeviceState);
    EXPECT_EQ(kernel.Image().RestoreDefaults(), Result::kSuccessful);
    EXPECT_NE(store.Load(kCommunicationGroup).finding, StoreFinding::kRefused);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    EXPECT_EQ(Read(0x1300U, 0U), gfc);
    // One that is not valid is nothing that a start could refuse, and without an expected digest there is nothing to be
    EXPECT_EQ(Write(0x1300U, 0U, 1U - gfc, 1U), AbortCode::kNone);
    EXPECT_EQ(Write(0x13FEU, 0U, 0U, 1U), AbortCode::kNone);
    EXPECT_EQ(save(), SdoAbort::kNone);
    config.digest = 0U;
    EXPECT_EQ(Write(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    EXPECT_EQ(save(), SdoAbort::kNone);
    EXPECT_NE(store.Load(kCommunicationGroup).finding, StoreFinding::kRefused);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    EXPECT_EQ(Read(0x1300U, 0U), 1U - gfc);
}

TEST_F(StoredSafetyTest, AfterALostSetTheDeviceDoesNotComeUpWithA5)
{
    Verifies(req::SRS_STO_014);
    // Given a valid configuration that was saved twice
    Configure();
    std::array<std::uint8_t, 64> scratch{};
    CutMemory memory{8192U};
    StoredSafety safety{kernel};
    std::array<StoredPart*, 1> parts{&safety};
    ParameterStore store{StoreParts{memory, parts.data(), 1U, Room{scratch.data(), 64U}}};
    for (int save = 0; save < 2; ++save)
    {
        EXPECT_EQ(store.Begin({StoreAction::kSave, kAllGroups}), SdoAbort::kPending);
        for (int i = 0; (i < 3000) && store.IsBusy(); ++i)
        {
            store.OnCycle();
        }
        EXPECT_EQ(store.Continue({StoreAction::kSave, kAllGroups}), SdoAbort::kNone);
    }
    // When a bit of the newer set changes, and the defaults of the device are valid
    memory.banks[1][77] ^= 0x20U;
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    // Then another group is loaded as ever, and with the communication group 13FEh is withdrawn
    EXPECT_EQ(store.Load(kApplicationGroup).finding, StoreFinding::kLost);
    EXPECT_EQ(Read(0x13FEU, 0U), 0xA5U);
    EXPECT_EQ(store.Load(kCommunicationGroup).finding, StoreFinding::kLost);
    EXPECT_EQ(Read(0x13FEU, 0U), 0U);
}

TEST_F(StoredSafetyTest, AConfigurationThatTheKernelDoesNotGiveIsNotLeftOutOfASet)
{
    Verifies(req::SRS_STO_210);
    Configure();
    kernel.Stop();
    std::array<std::uint8_t, 64> scratch{};
    StoredSafety safety{kernel};
    EXPECT_EQ(safety.ItemCount(), 1U);
    EXPECT_EQ(safety.Item(0U, {scratch.data(), 64U}).abort, SdoAbort::kDeviceState);
    EXPECT_EQ(safety.Item(0U, {scratch.data(), 64U}).group, kCommunicationGroup);
    // When that group is saved, then it is refused; another one is not
    std::array<std::uint8_t, 64> room{};
    CutMemory memory{8192U};
    std::array<StoredPart*, 1> parts{&safety};
    ParameterStore store{StoreParts{memory, parts.data(), 1U, Room{room.data(), 64U}}};
    for (const auto& [group, told] :
         {std::pair(kCommunicationGroup, SdoAbort::kDeviceState), std::pair(kApplicationGroup, SdoAbort::kNone)})
    {
        const StoreRequest save{StoreAction::kSave, group};
        SdoAbort answer = store.Begin(save);
        for (int i = 0; (i < 3000) && (answer == SdoAbort::kPending); ++i)
        {
            store.OnCycle();
            answer = store.Continue(save);
        }
        EXPECT_EQ(answer, told);
    }
    EXPECT_EQ(static_cast<std::uint32_t>(SdoAbort::kDeviceState), 0x08000022U);
}

} // namespace
} // namespace counterpoint::cia301
