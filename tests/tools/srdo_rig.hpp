// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_TOOLS_SRDO_RIG_HPP
#define TESTS_TOOLS_SRDO_RIG_HPP

#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/text/text_file.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/tools/command_run.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::tools::test
{
/// `counterpoint srdo` on a file d.dcf.
class SrdoRig : public CommandTest
{
  protected:
    /// counterpoint srdo add on a file with this text.
    [[nodiscard]] Answer Add(const std::string& text, std::vector<std::string> options) const
    {
        options.insert(options.begin(), {"srdo", "add", File("d.dcf", text)});
        return RunCommand(options);
    }
    [[nodiscard]] std::string Written() const
    {
        return cia306::ReadTextFile(Path("d.dcf"));
    }
    [[nodiscard]] cia306::Device Device() const
    {
        return cia306::ReadDeviceFile(Path("d.dcf"));
    }
    [[nodiscard]] std::string Value(const std::uint16_t index, const std::uint8_t sub) const
    {
        const cia306::Device device = Device();
        const cia306::Entry* const entry = device.Find(index, sub);
        return entry == nullptr ? "no entry" : entry->Configured().text;
    }
};

inline std::string Var(const std::string& section, const std::string& name, const std::string& type,
                       const std::string& access, const std::string& values)
{
    return "[" + section + "]\nParameterName=" + name + "\nObjectType=0x7\nDataType=" + type +
           "\nAccessType=" + access + "\n" + values + "\n";
}

inline std::string Head(const std::string& section, const std::string& name, const std::string& type,
                        const std::string& subs)
{
    return "[" + section + "]\nParameterName=" + name + "\nObjectType=" + type + "\nSubNumber=" + subs + "\n\n";
}

inline std::string Count(const std::string& section, const std::string& highest)
{
    return Var(section, "Highest sub-index supported", "0x0005", "const",
               "DefaultValue=" + highest + "\nPDOMapping=0\n");
}

/// What SRDO 2, which receives 8 bits by 111h and 112h, is in the file of the sensor.
inline std::string CommunicationText()
{
    return Head("1302", "SRDO 2 communication parameter", "0x9", "7") + Count("1302sub0", "6") +
           Var("1302sub1", "Information direction", "0x0005", "rw",
               "DefaultValue=0\nParameterValue=2\nPDOMapping=0\nLowLimit=0\nHighLimit=2\n") +
           Var("1302sub2", "Refresh time or SCT", "0x0006", "rw",
               "DefaultValue=50\nParameterValue=50\nPDOMapping=0\n") +
           Var("1302sub3", "SRVT", "0x0005", "rw", "DefaultValue=20\nParameterValue=20\nPDOMapping=0\n") +
           Var("1302sub4", "Transmission type", "0x0005", "const", "DefaultValue=254\nPDOMapping=0\n") +
           Var("1302sub5", "COB-ID 1 (normal data)", "0x0007", "rw",
               "DefaultValue=0x00000000\nParameterValue=0x00000111\nPDOMapping=0\n") +
           Var("1302sub6", "COB-ID 2 (inverse data)", "0x0007", "rw",
               "DefaultValue=0x00000000\nParameterValue=0x00000112\nPDOMapping=0\n");
}

inline std::string MappingText()
{
    return Head("1382", "SRDO 2 mapping parameter", "0x8", "3") +
           Var("1382sub0", "Number of mapped objects", "0x0005", "rw",
               "DefaultValue=0\nParameterValue=2\nPDOMapping=0\n") +
           Var("1382sub1", "Normal data 1", "0x0007", "rw",
               "DefaultValue=0x00000000\nParameterValue=0x22000108\nPDOMapping=0\n") +
           Var("1382sub2", "Inverse data 1", "0x0007", "rw",
               "DefaultValue=0x00000000\nParameterValue=0x23000108\nPDOMapping=0\n");
}

inline std::string ObjectsText()
{
    return Head("2200", "Received data of SRDO 2", "0x9", "2") + Count("2200sub0", "1") +
           Var("2200sub1", "Received data 2.1", "0x0005", "rww",
               "DefaultValue=0\nPDOMapping=0\nSRDOMapping=1\nInvertedSRAD=0x230001\n") +
           Head("2300", "Received data of SRDO 2, inverse", "0x9", "2") + Count("2300sub0", "1") +
           Var("2300sub1", "Received data 2.1, inverse", "0x0005", "rww",
               "DefaultValue=0xFF\nPDOMapping=0\nSRDOMapping=1\n");
}

/// A place of an array, with its default and its value.
inline std::string PlaceText(const std::string& section, const std::string& name, const std::string& type,
                             const std::string& value, const std::string& parameter)
{
    return Var(section, name, type, "rw",
               "DefaultValue=" + value + "\nParameterValue=" + parameter + "\nPDOMapping=0\n");
}

/// What stands at the end of the file.
inline std::string LastText()
{
    return PlaceText("5F05sub2", "SRVT detection of SRDO 2 (0x3C: late)", "0x0005", "0x00", "0x00");
}

/// The array counts one sub-index more.
inline cia306::test::Change Counted(const std::string& section, const std::string& name)
{
    const std::string head = "[" + section + "]\nParameterName=" + name + "\nObjectType=0x8\nSubNumber=";
    const std::string count = "\n\n[" + section +
                              "sub0]\nParameterName=Highest sub-index supported\nObjectType=0x7\nDataType=0x0005\n"
                              "AccessType=const\nDefaultValue=";
    return {head + "2" + count + "1\n", head + "3" + count + "2\n"};
}
} // namespace counterpoint::tools::test

#endif // TESTS_TOOLS_SRDO_RIG_HPP
