// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Devices whose DCFs use what few devices need, from end to end: 64 objects of one bit, static mappings, dummies, every
// device parameter other than its default. The other side of each is its mirror: what the device sends, the mirror
// receives, and the other way round.
#include "tests/integration/scenario_run.hpp"
#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/safety/signing.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <cstddef>
#include <sstream>
#include <vector>

namespace counterpoint::simulator
{
namespace
{
std::string Data(const std::string& name)
{
    return std::string(COUNTERPOINT_SOURCE_FOLDER) + "/tests/canopen/cia306/data/" + name + ".dcf";
}

std::string TextOf(const std::string& file)
{
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// The value of a key in a section of the file.
std::string ValueOf(const std::string& text, const std::string& section, const std::string& key)
{
    const std::size_t begin = text.find("[" + section + "]");
    const std::size_t end = text.find("\n[", begin);
    const std::string part = text.substr(begin, end - begin);
    const std::size_t place = part.find("\n" + key + "=") + key.size() + 2U;
    return part.substr(place, part.find_first_of("\r\n", place) - place);
}

void Set(std::string& text, const std::string& section, const std::string& key, const std::string& value)
{
    const std::string old = "\n" + key + "=" + ValueOf(text, section, key);
    const std::size_t place = text.find(old, text.find("[" + section + "]"));
    text.replace(place, old.size(), "\n" + key + "=" + value);
}

std::string Written(const std::string& name, const std::string& text)
{
    std::string file = TextFile("") + "." + name + ".dcf";
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

/// Signed, with its digest where it has a place for one.
std::string Signed(const std::string& name, const std::string& text)
{
    const cia306::IniDocument document = cia306::IniDocument::Parse(name, text);
    const cia306::Device device = cia306::ReadDevice(document);
    return Written(name, cia306::WithSignatures(document, device, device.node_id).Text());
}

/// Directions exchanged; who sends refreshes three times within the SCT of who receives.
std::string Mirrored(std::string text, const std::string& node_id, const std::vector<std::string>& srdos)
{
    std::istringstream in(text);
    std::string turned;
    bool is_of_application = false;
    for (std::string line; std::getline(in, line);)
    {
        if (!line.empty() && line[0] == '[')
        {
            is_of_application = line[1] == '2' || line[1] == '6';
        }
        if (is_of_application && line.rfind("AccessType=rww", 0U) == 0U)
        {
            line = "AccessType=ro";
        }
        else if (is_of_application && line.rfind("AccessType=ro", 0U) == 0U)
        {
            line = "AccessType=rww";
        }
        turned += line + "\n";
    }
    for (const std::string& srdo : srdos)
    {
        const bool is_producer = ValueOf(turned, srdo + "sub1", "ParameterValue") == "1";
        const int time_ms = std::stoi(ValueOf(turned, srdo + "sub2", "ParameterValue"));
        Set(turned, srdo + "sub1", "ParameterValue", is_producer ? "2" : "1");
        Set(turned, srdo + "sub2", "ParameterValue", std::to_string(is_producer ? time_ms * 3 : time_ms / 3));
    }
    Set(turned, "DeviceComissioning", "NodeID", node_id);
    return turned;
}

/// All objects of a producer have a value from the start: a pair that nobody wrote is not inverse.
std::string Zeros(const std::string& node, const std::string& index, const int count)
{
    std::ostringstream text;
    for (int sub = 1; sub <= count; ++sub)
    {
        text << "  - {at: 0 ms, node: " << node << ", object: 0x" << index << ":" << std::hex << sub << std::dec
             << ", value: 0}\n";
    }
    return text.str();
}

/// What goes wrong in a scenario of this text; the devices are `device` and `peer`, acknowledged at 300 ms.
std::string FailuresOf(const std::string& text)
{
    Run run(TextFile("title: Look-alikes\nbitrate: 500000\nseed: 1\n" + text +
                     (text.find("duration:") == std::string::npos ? "duration: 1000 ms\n" : "")),
            std::nullopt, std::nullopt, false);
    run.Simulate(nullptr);
    return Failures(run);
}

TEST(LookAlike, BitsAreSentAndReceivedOneByOne)
{
    Verifies(req::SRS_SIM_002);
    // Given a consumer of 64 and a producer of 3 objects below a byte, and their mirror
    const std::string peer = Signed("peer", Mirrored(TextOf(Data("bits")), "41", {"1301", "1302"}));
    // When bits 1, 10 and 64 are set on one side, 1, 3 and 8 bits on the other; then they arrive, and no others
    EXPECT_EQ(FailuresOf("nodes:\n  device: {dcf: " + Data("bits") + "}\n  peer: {dcf: " + peer + R"(, phase: 270 us}
inputs:
)" + Zeros("peer", "6020", 64) +
                         R"(  - {at: 1 ms, node: peer, object: 0x6020:01, value: 1}
  - {at: 1 ms, node: peer, object: 0x6020:0A, value: 1}
  - {at: 1 ms, node: peer, object: 0x6020:40, value: 1}
  - {at: 1 ms, node: device, object: 0x2100:01, value: 1}
  - {at: 1 ms, node: device, object: 0x2100:02, value: 5}
  - {at: 1 ms, node: device, object: 0x2100:03, value: 0xC3}
acknowledge:
  - {at: 300 ms, node: device, srdo: 1, pulse: 50 ms}
  - {at: 300 ms, node: peer, srdo: 2, pulse: 50 ms}
expect:
  - {that: safe, node: device, srdo: 1, at: 290 ms}
  - {that: released, node: device, srdo: 1, at: 990 ms}
  - {that: value, node: device, object: 0x6020:01, is: 1, at: 990 ms}
  - {that: value, node: device, object: 0x6020:02, is: 0, at: 990 ms}
  - {that: value, node: device, object: 0x6020:0A, is: 1, at: 990 ms}
  - {that: value, node: device, object: 0x6020:3F, is: 0, at: 990 ms}
  - {that: value, node: device, object: 0x6020:40, is: 1, at: 990 ms}
  - {that: released, node: peer, srdo: 2, at: 990 ms}
  - {that: value, node: peer, object: 0x2100:01, is: 1, at: 990 ms}
  - {that: value, node: peer, object: 0x2100:02, is: 5, at: 990 ms}
  - {that: value, node: peer, object: 0x2100:03, is: 0xC3, at: 990 ms}
  - {that: no_fault}
)"),
              "");
}

TEST(LookAlike, StaticMappingsSendAndReceiveByTheirFields)
{
    Verifies(req::SRS_SIM_009);
    // Given two devices with static mappings for both directions: 8 objects of a byte, and 16, 24 and 8 bits
    const std::string peer = Signed("peer", Mirrored(TextOf(Data("static")), "8", {"1301", "1303"}));
    EXPECT_EQ(FailuresOf("nodes:\n  device: {dcf: " + Data("static") + "}\n  peer: {dcf: " + peer + R"(, phase: 270 us}
inputs:
)" + Zeros("peer", "2200", 8) +
                         R"(  - {at: 1 ms, node: peer, object: 0x2200:01, value: 0x11}
  - {at: 1 ms, node: peer, object: 0x2200:08, value: 0x88}
  - {at: 1 ms, node: device, object: 0x2400:01, value: 0x1234}
  - {at: 1 ms, node: device, object: 0x2400:02, value: 0x56789A}
  - {at: 1 ms, node: device, object: 0x2400:03, value: 0xBC}
acknowledge:
  - {at: 300 ms, node: device, srdo: 1, pulse: 50 ms}
  - {at: 300 ms, node: peer, srdo: 3, pulse: 50 ms}
expect:
  - {that: released, node: device, srdo: 1, at: 990 ms}
  - {that: value, node: device, object: 0x2200:01, is: 0x11, at: 990 ms}
  - {that: value, node: device, object: 0x2200:02, is: 0, at: 990 ms}
  - {that: value, node: device, object: 0x2200:08, is: 0x88, at: 990 ms}
  - {that: released, node: peer, srdo: 3, at: 990 ms}
  - {that: value, node: peer, object: 0x2400:01, is: 0x1234, at: 990 ms}
  - {that: value, node: peer, object: 0x2400:02, is: 0x56789A, at: 990 ms}
  - {that: value, node: peer, object: 0x2400:03, is: 0xBC, at: 990 ms}
  - {that: no_fault}
)"),
              "");
}

TEST(LookAlike, StaticMappingIsInTheSetupAndNotWritten)
{
    Verifies(req::SRS_SIM_009);
    runtime::DeviceModel model(Data("static"), std::nullopt);
    ASSERT_EQ(model.Config().srdo_count, 2U);
    const SrdoSetup& setup = model.Config().srdos[1];
    EXPECT_EQ(setup.number, 3U);
    EXPECT_EQ(setup.map.count, 6U);
    ASSERT_NE(setup.map.entries, nullptr);
    EXPECT_EQ(setup.map.entries[0], 0x24000110U);
    EXPECT_EQ(setup.map.entries[5], 0x24100308U);
    for (const runtime::ConfigurationWrite& write : model.Writes())
    {
        EXPECT_FALSE(write.object.index >= 0x1381U && write.object.index <= 0x13C0U) << write.object.index;
    }
    // The fields: 2400h sub 1 to 3 with 2, 3 and 1 byte, then their inverse
    ASSERT_EQ(model.StaticTables().size(), 2U);
    const StaticFields fields = model.FieldsOf(model.StaticTables()[1]);
    for (const MappableObject& object : model.Objects())
    {
        const std::uint8_t* const field = (object.index == 0x2400U) ? fields.normal : fields.inverse;
        const std::ptrdiff_t offset = (object.sub == 1U) ? 0 : ((object.sub == 2U) ? 2 : 5);
        if (object.index == 0x2400U || object.index == 0x2410U)
        {
            EXPECT_EQ(object.place, field + offset) << object.index << " " << int{object.sub};
        }
    }
    EXPECT_EQ(fields.inverse, fields.normal + 6);
}

TEST(LookAlike, DummiesAreReceivedAndLeftOut)
{
    Verifies(req::SRS_SIM_002);
    // Given senders of 64 single bits for SRDO 1 and of 8 bytes for SRDO 64
    std::string bits = Mirrored(TextOf(Data("bits")), "41", {"1301", "1302"});
    Set(bits, "1301sub5", "ParameterValue", "0x17F");
    Set(bits, "1301sub6", "ParameterValue", "0x180");
    Set(bits, "1301sub2", "ParameterValue", "20");
    std::string bytes = Mirrored(TextOf(Data("static")), "8", {"1301", "1303"});
    Set(bytes, "1301sub5", "ParameterValue", "0x101");
    Set(bytes, "1301sub6", "ParameterValue", "0x102");
    // When bits 1 and 2, and 27 and 32 are set, and the last byte
    EXPECT_EQ(FailuresOf("nodes:\n  device: {dcf: " + Data("dummies") + "}\n  bits: {dcf: " + Signed("bits", bits) +
                         ", phase: 270 us}\n  bytes: {dcf: " + Signed("bytes", bytes) + R"(, phase: 770 us}
inputs:
)" + Zeros("bits", "6020", 64) +
                         Zeros("bytes", "2200", 8) + R"(  - {at: 1 ms, node: bits, object: 0x6020:01, value: 1}
  - {at: 1 ms, node: bits, object: 0x6020:02, value: 1}
  - {at: 1 ms, node: bits, object: 0x6020:1B, value: 1}
  - {at: 1 ms, node: bits, object: 0x6020:20, value: 1}
  - {at: 1 ms, node: bits, object: 0x6020:21, value: 1}
  - {at: 1 ms, node: bytes, object: 0x2200:01, value: 0xFF}
  - {at: 1 ms, node: bytes, object: 0x2200:08, value: 0x9A}
acknowledge:
  - {at: 300 ms, node: device, srdo: 1, pulse: 50 ms}
  - {at: 400 ms, node: device, srdo: 64, pulse: 50 ms}
expect:
  - {that: released, node: device, srdo: 1, at: 990 ms}
  - {that: released, node: device, srdo: 64, at: 990 ms}
  - {that: value, node: device, object: 0x2200:01, is: 1, at: 990 ms}
  - {that: value, node: device, object: 0x2200:02, is: 0x21, at: 990 ms}
  - {that: value, node: device, object: 0x2200:03, is: 0x9A, at: 990 ms}
  - {that: no_fault}
)"),
              "");
}

TEST(LookAlike, EveryDeviceParameterAndItsDigest)
{
    Verifies(req::SRS_SIM_009);
    // Given two devices that accept their configuration by its digest only
    const std::string peer = Signed("peer", Mirrored(TextOf(Data("digest")), "126", {"1302", "1305"}));
    EXPECT_EQ(runtime::DeviceModel(Data("digest"), std::nullopt).Config().digest, 0x5F9AFA3DU);
    EXPECT_NE(runtime::DeviceModel(peer, std::nullopt).Config().digest, 0U);
    EXPECT_NE(runtime::DeviceModel(peer, std::nullopt).Config().digest, 0x5F9AFA3DU);
    // Then SRDO 2 is released by itself, SRDO 5 after its acknowledge; until then they have their safe values
    EXPECT_EQ(FailuresOf("nodes:\n  device: {dcf: " + Data("digest") + "}\n  peer: {dcf: " + peer + R"(, phase: 270 us}
inputs:
  - {at: 1 ms, node: peer, object: 0x2200:01, value: 0xCAFE1234}
  - {at: 1 ms, node: device, object: 0x2400:01, value: 0x0123456789ABCDEF}
acknowledge:
  - {at: 300 ms, node: peer, srdo: 5, pulse: 50 ms}
expect:
  - {that: value, node: device, object: 0x2200:01, is: 0xA1B2C3D4, at: 10 ms}
  - {that: released, node: device, srdo: 2, at: 290 ms}
  - {that: value, node: device, object: 0x2200:01, is: 0xCAFE1234, at: 990 ms}
  - {that: value, node: peer, object: 0x2400:01, is: 0x1122334455667788, at: 290 ms}
  - {that: released, node: peer, srdo: 5, at: 990 ms}
  - {that: value, node: peer, object: 0x2400:01, is: 0x0123456789ABCDEF, at: 990 ms}
  - {that: no_fault}
)"),
              "");
}

TEST(LookAlike, AnotherDigestIsRefused)
{
    Verifies(req::SRS_SIM_009);
    std::string text = TextOf(Data("digest"));
    Set(text, "5F04", "ParameterValue", "0x5F9AFA3C");
    const std::string file = Written("wrong", text);
    // Given a DCF with another digest; then 13FEh is refused
    try
    {
        static_cast<void>(FailuresOf("nodes:\n  device: {dcf: " + file + "}\n"));
        FAIL() << "accepted";
    }
    catch (const cia306::InputError& error)
    {
        EXPECT_NE(std::string(error.what()).find("0x13FE"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("0604 0043h"), std::string::npos) << error.what();
    }
    // And another node-ID is another device, of which no digest is known; so is one with a second controller
    EXPECT_EQ(runtime::DeviceModel(file, std::uint8_t{5}).Config().digest, 0U);
    EXPECT_EQ(runtime::DeviceModel(Data("digest"), std::uint8_t{127}).Config().digest, 0x5F9AFA3DU);
    Set(text, "5F00sub10", "ParameterValue", "1");
    runtime::DeviceModel one(Written("one", text), std::nullopt);
    EXPECT_EQ(one.Config().digest, 0x5F9AFA3CU);
    one.UseTwoControllers();
    EXPECT_EQ(one.Config().digest, 0U);
}

struct PlaceOfSetups
{
    const char* part;
    unsigned first; ///< Byte.
    unsigned bytes;
};

void PrintTo(const PlaceOfSetups& place, std::ostream* const out)
{
    *out << place.part;
}

using FlippedSetup = ::testing::TestWithParam<PlaceOfSetups>;

constexpr unsigned kByteOfForm = 2U; ///< Of part setup.

TEST_P(FlippedSetup, IsFoundWithinTheDiagnosticInterval)
{
    Verifies(req::SRS_SIM_035);
    Verifies(req::SRS_CFG_050);
    // Given the released chain; when any bit of the setup or of the safe value flips
    const unsigned first = GetParam().first * 8U;
    for (unsigned bit = first; bit < first + GetParam().bytes * 8U; ++bit)
    {
        const auto run =
            RunChain("duration: 2600 ms\nfaults:\n  - {fault: bit_flip, node: actuator, at: 500.2 ms, part: " +
                     std::string(GetParam().part) + ", offset: " + std::to_string(bit / 8U) +
                     ", bit: " + std::to_string(bit % 8U) + R"(}
expect:
  - {that: safe_within, node: actuator, srdo: 1, limit: configuration}
  - {that: safe, node: actuator, srdo: 1, at: 2599 ms}
)");
        // Then the output is safe within the limit of a changed configuration
        EXPECT_EQ(Failures(*run), "") << "bit " << bit;
    }
}

// Number, and 8 bytes of safe value.
INSTANTIATE_TEST_SUITE_P(EachBit, FlippedSetup,
                         ::testing::Values(PlaceOfSetups{"setup", 0U, 1U}, PlaceOfSetups{"setup", 4U, 8U},
                                           PlaceOfSetups{"safe_value", 0U, 8U}));

TEST(FlippedSetupOfWhichChannelsHaveACopy, ChangesNothing)
{
    Verifies(req::SRS_SIM_035);
    // Given a device without self tests; when a bit of policy or detection flips in the table, and then three pairs are
    // lost
    for (unsigned bit = 8U; bit < 32U; ++bit)
    {
        if (bit / 8U == kByteOfForm)
        {
            continue;
        }
        const auto run = RunChainWithoutSelfTests(
            "duration: 2600 ms\nfaults:\n  - {fault: bit_flip, name: flip, node: actuator, at: 500.2 ms, "
            "part: setup, offset: " +
            std::to_string(bit / 8U) + ", bit: " + std::to_string(bit % 8U) + R"(}
  - {fault: loss, name: lost, frames: {sender: controller, receiver: actuator, from: 2000 ms, count: 6}}
expect:
  - {that: released, node: actuator, srdo: 1, at: 1990 ms}
  - {that: safe_within, node: actuator, srdo: 1, fault: lost}
  - {that: safe, node: actuator, srdo: 1, at: 2599 ms}
)");
        // Then the interlock is still there
        EXPECT_EQ(Failures(*run), "") << "bit " << bit;
    }
}

// The kernel asks the provider of a producer by it.
TEST(FlippedFormOfWhichChannelsHaveACopy, IsFoundWithinTwoDiagnosticIntervals)
{
    Verifies(req::SRS_CFG_800);
    Verifies(req::SRS_SIM_035);
    // Given a device without self tests; when a bit of form flips in the table
    for (unsigned bit = 0U; bit < 8U; ++bit)
    {
        const auto run = RunChainWithoutSelfTests(
            "duration: 2600 ms\nfaults:\n  - {fault: bit_flip, node: actuator, at: 500.2 ms, part: setup, offset: " +
            std::to_string(kByteOfForm) + ", bit: " + std::to_string(bit) + R"(}
expect:
  - {that: safe_within, node: actuator, srdo: 1, limit: shared_source}
  - {that: safe, node: actuator, srdo: 1, at: 2599 ms}
)");
        EXPECT_EQ(Failures(*run), "") << "bit " << bit;
    }
}

TEST(FlippedStaticTable, IsFoundWithinTheDiagnosticInterval)
{
    Verifies(req::SRS_SIM_035);
    Verifies(req::SRS_SIM_009);
    const std::string peer = Signed("peer", Mirrored(TextOf(Data("static")), "8", {"1301", "1303"}));
    // When a bit flips in the count (byte 12) or in one of the entries (from byte 13 on)
    for (const unsigned byte : {12U, 13U, 16U, 20U, 76U})
    {
        for (unsigned bit = 0U; bit < 8U; ++bit)
        {
            EXPECT_EQ(
                FailuresOf("nodes:\n  device: {dcf: " + Data("static") + "}\n  peer: {dcf: " + peer +
                           ", phase: 270 us}\nduration: 2600 ms\ninputs:\n" + Zeros("peer", "2200", 8) +
                           Zeros("device", "2400", 3) + "acknowledge:\n" +
                           "  - {at: 300 ms, node: device, srdo: 1, pulse: 50 ms}\n" +
                           "faults:\n  - {fault: bit_flip, node: device, at: 500.2 ms, part: setup, srdo: 1, offset: " +
                           std::to_string(byte) + ", bit: " + std::to_string(bit) + R"(}
expect:
  - {that: safe_within, node: device, srdo: 1, limit: configuration}
  - {that: safe, node: device, srdo: 1, at: 2599 ms}
)"),
                "")
                << "byte " << byte << " bit " << bit;
        }
    }
}
} // namespace
} // namespace counterpoint::simulator
