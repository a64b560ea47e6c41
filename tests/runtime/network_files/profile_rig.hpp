// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A device whose DCF profiles look at, and network files with it.
#ifndef TESTS_RUNTIME_NETWORK_FILES_PROFILE_RIG_HPP
#define TESTS_RUNTIME_NETWORK_FILES_PROFILE_RIG_HPP

#include "canopen/cia302/network/concise_dcf.hpp"
#include "canopen/network_plan/loaded_network.hpp"
#include "runtime/network_files/file.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "verification/trace/verifies.hpp"

#include <string>
#include <vector>

namespace counterpoint::tools
{
using network_plan::LoadedNetwork;

/// A slave with two PDOs of each direction, of which one each is on, and a heartbeat.
constexpr const char* kDcf = R"([FileInfo]
FileName=io.dcf
[DeviceInfo]
VendorName=Example
[DeviceComissioning]
NodeID=5
[MandatoryObjects]
SupportedObjects=1
1=0x1000
[OptionalObjects]
SupportedObjects=11
11=0x1016
1=0x1006
2=0x1017
3=0x1400
4=0x1401
5=0x1600
6=0x1601
7=0x1800
8=0x1801
9=0x1A00
10=0x1A01
[ManufacturerObjects]
SupportedObjects=1
1=0x2000
[1000]
ParameterName=Device type
DataType=0x0007
AccessType=ro
DefaultValue=0x00000191
[1006]
ParameterName=Period
DataType=0x0007
AccessType=rw
ParameterValue=9999
[1016]
ParameterName=Consumer heartbeat time
ObjectType=0x8
SubNumber=2
[1016sub0]
ParameterName=Entries
DataType=0x0005
AccessType=const
DefaultValue=1
[1016sub1]
ParameterName=Entry
DataType=0x0007
AccessType=rw
DefaultValue=0
[1017]
ParameterName=Producer heartbeat time
DataType=0x0006
AccessType=rw
ParameterValue=100
[2000]
ParameterName=Filter
DataType=0x0005
AccessType=rw
ParameterValue=7
)";

inline std::string Pdo(const std::string& index, const std::string& mapping, const std::string& cob_id,
                       const std::string& event, const std::string& value_key)
{
    const auto number =
        [](const std::string& section, const std::string& type, const std::string& key, const std::string& value)
    {
        return "[" + section + "]\nParameterName=x\nObjectType=0x7\nDataType=" + type + "\nAccessType=rw\n" + key +
               "=" + value + "\n";
    };
    return "[" + index + "]\nParameterName=PDO\nObjectType=0x9\nSubNumber=4\n" +
           number(index + "sub0", "0x0005", "DefaultValue", "5") +
           number(index + "sub1", "0x0007", "ParameterValue", cob_id) +
           number(index + "sub2", "0x0005", "ParameterValue", "1") +
           number(index + "sub5", "0x0006", "ParameterValue", event) + "[" + mapping +
           "]\nParameterName=Mapping\nObjectType=0x9\nSubNumber=3\n" +
           number(mapping + "sub0", "0x0005", value_key, "2") +
           number(mapping + "sub1", "0x0007", value_key, "0x60000108") +
           number(mapping + "sub2", "0x0007", value_key, "0x64010110");
}

class NetworkProfileTest : public cia306::test::FolderTest
{
  protected:
    NetworkProfileTest()
    {
        Device("DefaultValue");
    }
    void Device(const std::string& mapping_key) const
    {
        static_cast<void>(File("io.dcf", kDcf + Pdo("1400", "1600", "$NODEID+0x200", "0", mapping_key) +
                                             Pdo("1401", "1601", "$NODEID+0x80000300", "0", mapping_key) +
                                             Pdo("1800", "1A00", "$NODEID+0x180", "20", mapping_key) +
                                             Pdo("1801", "1A01", "$NODEID+0x80000280", "0", mapping_key)));
    }
    [[nodiscard]] std::string Net(const std::string& manager, const std::string& slave) const
    {
        return File("net.yaml", "name: profiles\nmanager:\n  node: 127\n  sync: 10 ms\n" + manager +
                                    "slaves:\n  - node: 5\n    dcf: io.dcf\n" + slave);
    }
    /// Objects of a concise DCF in their order.
    static std::vector<std::uint32_t> Keys(const cia302::Bytes& concise)
    {
        std::vector<std::uint32_t> keys{};
        cia302::ConciseReading entry = cia302::ReadConcise(concise, {0U, 0U});
        for (; entry.state == cia302::ConciseState::kEntry; entry = cia302::ReadConcise(concise, entry.next))
        {
            keys.push_back((std::uint32_t{entry.object.index} << 8U) | entry.object.sub);
        }
        return keys;
    }
};

} // namespace counterpoint::tools

#endif
