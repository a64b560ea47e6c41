// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/sdo/server_port.hpp"
#include "canopen/cia301/store/stored_parts.hpp"
#include "tests/canopen/cia301/cut_memory.hpp"
#include "tests/canopen/cia301/service_rig.hpp"
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

TEST_F(StoredPartsTest, FailuresAreAnsweredWithTheirCodes)
{
    Verifies(req::SRS_STO_005);
    const Octets load_all{0x23U, 0x11U, 0x10U, 1U, 'l', 'o', 'a', 'd'};
    ASSERT_EQ(Download(kSaveAllRequest), 0U);
    // Given a memory that fails, for a save and for a load of the defaults
    memory.is_failed = true;
    manufacturer = {0xEEU, 0xEEU};
    EXPECT_EQ(Download(kSaveAllRequest), 0x06060000U);
    EXPECT_EQ(Download(load_all), 0x06060000U);
    memory.is_failed = false;
    // or a request while another one is running, whose client has given up
    EXPECT_EQ(Download(kSaveAllRequest, 3), 0xFFFFFFFFU);
    EXPECT_EQ(Download({0x80U, 0x10U, 0x10U, 1U}, 0), 0xFFFFFFFFU);
    EXPECT_EQ(Download(load_all, 1), 0x08000021U);
    while (store.IsBusy())
    {
        store.OnCycle();
    }
    // or one that is too small for the set
    CutMemory small{64U};
    ParameterStore none{StoreParts{small, parts.data(), 1U, Room{scratch.data(), 64U}}};
    EXPECT_FALSE(none.Mount()); // There is no set yet.
    const StoreRequest save_all{StoreAction::kSave, kAllGroups};
    SdoAbort answer = none.Begin(save_all);
    for (int i = 0; (i < 300) && (answer == SdoAbort::kPending); ++i)
    {
        none.OnCycle();
        answer = none.Continue(save_all);
    }
    EXPECT_EQ(static_cast<std::uint32_t>(answer), 0x08000020U);
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

TEST_F(StoredPartsTest, EachSubIndexForgetsItsGroupAndKeepsTheOthers)
{
    Verifies(req::SRS_STO_004);
    struct Row
    {
        std::uint8_t sub;
        std::uint64_t communication; ///< Of 1800h:02, of 1 byte.
        std::uint8_t application;
        std::uint8_t manufacturer;
    };
    for (const Row& row : {Row{1U, 0x1000000FEU, 0U, 0U}, Row{2U, 0x1000000FEU, 1U, 1U}, Row{3U, 0x100000001U, 0U, 1U},
                           Row{4U, 0x100000001U, 1U, 0U}})
    {
        // Given all groups stored with 1
        EXPECT_EQ(WritePdo(0x1800U, 2U, 1U), SdoAbort::kNone);
        application = {1U};
        manufacturer = {1U, 0U};
        EXPECT_EQ(Download(kSaveAllRequest), 0U);
        // When load is written to one sub-index
        table[3].sub = (row.sub == 1U) ? std::uint8_t{4U} : row.sub;
        EXPECT_EQ(Download({0x23U, 0x11U, 0x10U, row.sub, 'l', 'o', 'a', 'd'}), 0U);
        EXPECT_EQ(application[0], 1U);
        Restart();
        // Then its group alone has its defaults
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

} // namespace
} // namespace counterpoint::cia301
