// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/edit/new_device.hpp"

#include "canopen/cia306/edit/dictionary_edits.hpp"
#include "canopen/cia306/edit/srdo_edit.hpp"
#include "canopen/cia306/safety/device_parameters.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>
#include <iomanip>
#include <locale>
#include <sstream>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint16_t kLastMandatoryIndex = 0x1001U;
constexpr std::uint16_t kIdentityIndex = 0x1018U;
constexpr std::uint16_t kFirstManufacturerIndex = 0x2000U;

/// The text that std::put_time makes of it.
std::string Utc(const std::time_t time, const char* const form)
{
    std::tm parts{};
    static_cast<void>(::gmtime_r(&time, &parts));
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::put_time(&parts, form);
    return text.str();
}

void AddSection(std::string& text, const std::string& name, const SectionKeys& keys)
{
    text += "\n[" + name + "]\n";
    for (const auto& [key, value] : keys)
    {
        text += key;
        text += "=" + value + "\n";
    }
}

void AddFileInfo(std::string& text, const DevicePlan& plan)
{
    const std::string time = Utc(plan.created, "%I:%M%p");
    const std::string date = Utc(plan.created, "%m-%d-%Y");
    text += "; " + plan.name + "\n; Made with: counterpoint new";
    text += "\n; Signatures (13FFh) and digest (5F04h) after a change: counterpoint sign --write\n";
    AddSection(text, "FileInfo",
               {{"FileName", plan.file_name},
                {"FileVersion", "1"},
                {"FileRevision", "1"},
                {"EDSVersion", "4.0"},
                {"Description", plan.name},
                {"CreationTime", time},
                {"CreationDate", date},
                {"CreatedBy", "Counterpoint"},
                {"ModificationTime", time},
                {"ModificationDate", date},
                {"ModifiedBy", "Counterpoint"}});
}

void AddDeviceInfo(std::string& text, const DevicePlan& plan)
{
    SectionKeys keys{{"VendorName", plan.vendor_name}, {"VendorNumber", Hex(plan.vendor_id, 8)},
                     {"ProductName", plan.name},       {"ProductNumber", Hex(plan.product_code, 8)},
                     {"RevisionNumber", "0x00010000"}, {"OrderCode", ""}};
    for (const std::uint16_t rate : kBitRates)
    {
        keys.emplace_back("BaudRate_" + std::to_string(rate), rate == plan.bit_rate_kbit ? "1" : "0");
    }
    for (const char* const absent : {"SimpleBootUpMaster", "DynamicChannelsSupported", "GroupMessaging", "NrOfRXPDO",
                                     "NrOfTXPDO", "LSS_Supported"})
    {
        keys.emplace_back(absent, "0");
    }
    keys.emplace_back("SimpleBootUpSlave", "1");
    keys.emplace_back("Granularity", "8");
    keys.emplace_back("CANopenSafetySupported", "1");
    AddSection(text, "DeviceInfo", keys);
    AddSection(text, "DeviceComissioning",
               {{"NodeID", std::to_string(plan.node_id)},
                {"NodeName", plan.name},
                {"Baudrate", std::to_string(plan.bit_rate_kbit)},
                {"NetNumber", "1"},
                {"NetworkName", ""},
                {"CANopenManager", "0"},
                {"LSS_SerialNumber", "0"}});
    SectionKeys dummies;
    for (std::uint16_t type = 1U; type <= kUnsigned32; ++type)
    {
        dummies.emplace_back("Dummy" + SectionOf(type), "0");
    }
    AddSection(text, "DummyUsage", dummies);
}

NewEntry Parameter(const std::uint8_t sub, const std::string& name, const std::uint16_t type, const std::string& value)
{
    return {sub, name, type, "rw", value, value};
}

NewObject Variable(const std::uint16_t index, const NewEntry& entry)
{
    return {index, "", ObjectType::kVar, {entry}};
}

/// What every device of CiA 301 has, and what this one has of its services.
std::vector<NewObject> CommunicationObjects(const DevicePlan& plan)
{
    const std::string gfc = plan.is_gfc_on ? "1" : "0";
    return {Variable(0x1000U, {0U, "Device type", kUnsigned32, "ro", "0x00000000"}),
            Variable(0x1001U, {0U, "Error register", kUnsigned8, "ro", "0x00"}),
            Variable(0x1014U, {0U, "COB-ID EMCY", kUnsigned32, "ro", "$NODEID+0x80"}),
            Variable(0x1015U, {0U, "Inhibit time EMCY", kUnsigned16, "rw", "0"}),
            Variable(0x1017U, {0U, "Producer heartbeat time [ms]", kUnsigned16, "rw", "0", "100"}),
            {kIdentityIndex,
             "Identity object",
             ObjectType::kRecord,
             {{1U, "Vendor-ID", kUnsigned32, "ro", Hex(plan.vendor_id, 8)},
              {2U, "Product code", kUnsigned32, "ro", Hex(plan.product_code, 8)},
              {3U, "Revision number", kUnsigned32, "ro", "0x00010000"},
              {4U, "Serial number", kUnsigned32, "ro", "0"}}},
            Variable(kGfcIndex, {0U,
                                 "Global fail-safe command parameter",
                                 kUnsigned8,
                                 "rw",
                                 "0",
                                 gfc,
                                 {{"LowLimit", "0"}, {"HighLimit", "1"}}}),
            Variable(kConfigurationValidIndex, {0U, "Configuration valid", kUnsigned8, "rw", "0x00", "0xA5"}),
            {kSignatureIndex, "Safety configuration signature", ObjectType::kArray, {}}};
}

/// 5F00h with the defaults that a device without it has, so that people see and change them.
NewObject DeviceParametersObject()
{
    const DeviceParameters own;
    const auto time = [](const std::uint8_t sub, const std::string& name, const std::uint32_t value)
    { return Parameter(sub, name, kUnsigned32, std::to_string(value)); };
    return {
        kDeviceParametersIndex,
        "Counterpoint device parameters",
        ObjectType::kRecord,
        {time(1U, "Cycle time [us]", own.cycle_us), time(2U, "Cycle tolerance [us]", own.cycle_tolerance_us),
         time(3U, "Discrepancy time [us]", own.discrepancy_us),
         time(4U, "Diagnostic interval [ms]", own.diagnostic_interval_ms),
         time(5U, "Test interval [ms]", own.test_interval_ms), time(6U, "Clock tolerance [us]", own.clock_tolerance_us),
         time(7U, "Clock tolerance interval [us]", own.clock_tolerance_interval_us),
         time(8U, "Output time [us]", own.output_us), time(9U, "Acknowledge window [us]", own.acknowledge_window_us),
         Parameter(kGranularitySub, "Granularity [bit]", kUnsigned8, "8"),
         Parameter(kMapEntriesSub, "Mapping entries of an SRDO", kUnsigned8, "16"),
         Parameter(kDummyMappingSub, "Dummy mapping (0x66: allowed)", kUnsigned8, "0x00"),
         Parameter(kNumberGapsSub, "Gaps between SRDO numbers (0x99: searched)", kUnsigned8, "0x99"),
         Parameter(kGfcUseSub, "Global fail-safe command (0x5A: present)", kUnsigned8, "0x5A"),
         Parameter(kNormalPortSub, "Controller of the normal frames", kUnsigned8, "1"),
         Parameter(kInversePortSub, "Controller of the inverse frames", kUnsigned8, "1")}};
}

/// The device digest (5F04h) comes with the first SRDO.
std::vector<NewObject> ManufacturerObjects()
{
    return {DeviceParametersObject(),
            {kReleasePolicyIndex, "Release policy (0x5A: automatic)", ObjectType::kArray, {}},
            {kSafeValueIndex, "Safe value", ObjectType::kArray, {}},
            {kProducerFormIndex, "Producer form", ObjectType::kArray, {}},
            {kDetectionIndex, "SRVT detection", ObjectType::kArray, {}}};
}

void AddList(std::string& text, const std::string& name, const std::vector<std::uint16_t>& indices)
{
    SectionKeys keys{{"SupportedObjects", std::to_string(indices.size())}};
    for (const std::uint16_t index : indices)
    {
        keys.emplace_back(std::to_string(keys.size()), Hex(index, 4));
    }
    AddSection(text, name, keys);
}

void AddLists(std::string& text, const std::vector<NewObject>& objects)
{
    std::vector<std::uint16_t> mandatory;
    std::vector<std::uint16_t> optional;
    std::vector<std::uint16_t> manufacturers;
    for (const NewObject& object : objects)
    {
        const bool is_mandatory = object.index <= kLastMandatoryIndex || object.index == kIdentityIndex;
        const bool is_manufacturers = object.index >= kFirstManufacturerIndex;
        (is_mandatory ? mandatory : (is_manufacturers ? manufacturers : optional)).push_back(object.index);
    }
    AddList(text, "MandatoryObjects", mandatory);
    AddList(text, "OptionalObjects", optional);
    AddList(text, "ManufacturerObjects", manufacturers);
}

/// Each list in the order of the indices, as people look for them.
IniDocument WithSortedLists(const IniDocument& document)
{
    std::vector<KeyEdit> edits;
    for (const std::string name : {"OptionalObjects", "ManufacturerObjects"})
    {
        std::vector<std::string> values;
        const IniSection& list = *document.Find(name);
        for (std::size_t place = 1U; place < list.keys.size(); ++place)
        {
            values.push_back(list.keys[place].value);
        }
        std::sort(values.begin(), values.end()); // All have four digits.
        for (std::size_t place = 1U; place < list.keys.size(); ++place)
        {
            edits.push_back({name, list.keys[place].name, values[place - 1U], ""});
        }
    }
    return document.With(edits, {});
}
} // namespace

IniDocument NewDevice(const std::string& file, const DevicePlan& plan)
{
    std::vector<NewObject> objects = CommunicationObjects(plan);
    const std::vector<NewObject> manufacturers = ManufacturerObjects();
    objects.insert(objects.end(), manufacturers.begin(), manufacturers.end());
    std::string text;
    AddFileInfo(text, plan);
    AddDeviceInfo(text, plan);
    AddLists(text, objects);
    for (const NewObject& object : objects)
    {
        for (const auto& [name, keys] : SectionsOf(object))
        {
            AddSection(text, name, keys);
        }
    }
    IniDocument document = IniDocument::Parse(file, text);
    for (const SrdoPlan& srdo : plan.srdos)
    {
        document = WithSrdo(document, srdo, plan.node_id);
    }
    return WithSortedLists(document);
}
} // namespace counterpoint::cia306
