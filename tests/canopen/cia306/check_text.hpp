// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_CIA306_CHECK_TEXT_HPP
#define TESTS_CANOPEN_CIA306_CHECK_TEXT_HPP

#include "canopen/cia306/check/check.hpp"
#include "canopen/cia306/safety/signing.hpp"
#include "tests/canopen/cia306/device_text.hpp"

#include <string>
#include <vector>

namespace counterpoint::cia306::test
{
/// A key with another value; the section exists.
struct Set
{
    std::string section;
    std::string key;
    std::string value;
};

/// A changed example and what the check finds in it, without FILE:LINE.
struct CheckRow
{
    std::vector<Set> values;
    std::vector<std::string> findings;
    std::vector<Change> changes{}; ///< Made first.
};

/// What follows for the device as a whole and is left out of what the tests of single rules expect: errors make 13FEh =
/// A5h an error too, and files from before 5F04h have no digest. Both have tests of their own.
inline bool IsFollower(const std::string& finding)
{
    return finding.find("0xA5 marks a configuration with errors as valid") != std::string::npos ||
           finding.find("warning: 0x5F04:00: is missing") != std::string::npos;
}

inline std::string WithValues(const std::string& text, const std::vector<Set>& values)
{
    std::vector<KeyEdit> edits;
    for (const Set& value : values)
    {
        edits.push_back({value.section, value.key, value.value, "DefaultValue"});
    }
    return IniDocument::Parse("test.dcf", text).With(edits, {}).Text();
}

/// The sensor of the emergency stop chain without 5F04h.
inline std::string WithoutDigest(const std::string& sensor)
{
    std::string text =
        Changed(sensor, {{"[ManufacturerObjects]\nSupportedObjects=8\n", "[ManufacturerObjects]\nSupportedObjects=7\n"},
                         {"7=0x5F04\n8=0x5F05\n", "7=0x5F05\n"}});
    const std::size_t place = text.find("[5F04]");
    return text.erase(place, text.find("[5F05]") - place);
}

inline std::vector<std::string> FindingsOf(const std::string& text, const CheckOptions& options)
{
    std::vector<std::string> lines;
    for (const Finding& finding : CheckDevice(DeviceOf(text), options))
    {
        const std::string line = FormatFinding("f", finding);
        lines.push_back(line.substr(line.find(": ") + 2U));
    }
    return lines;
}

/// The changed text with its signatures made right, so that only the change is found; as it is where it cannot be
/// signed.
inline std::string SignedAgain(const std::string& text, const std::optional<std::uint8_t> node_id)
{
    try
    {
        const IniDocument document = IniDocument::Parse("test.dcf", text);
        const Device device = ReadDevice(document);
        return WithSignatures(document, device, node_id ? node_id : device.node_id).Text();
    }
    catch (const InputError&)
    {
        return text;
    }
}

/// Followers are left out.
inline std::vector<std::string> FindingsOfChange(const std::string& example, const CheckRow& row,
                                                 const CheckOptions& options)
{
    const std::string changed = WithValues(Changed(ExampleText(example), row.changes), row.values);
    const std::string text = SignedAgain(changed, options.node_id);
    std::vector<std::string> findings;
    for (const std::string& finding : FindingsOf(text, options))
    {
        if (!IsFollower(finding))
        {
            findings.push_back(finding);
        }
    }
    return findings;
}

inline void ExpectRows(const std::string& example, const std::vector<CheckRow>& rows, const CheckOptions& options)
{
    for (const CheckRow& row : rows)
    {
        const std::string name = row.values.empty() ? row.changes.at(0U).to
                                                    : row.values.at(0U).section + " " + row.values.at(0U).key + "=" +
                                                          row.values.at(0U).value;
        EXPECT_EQ(FindingsOfChange(example, row, options), row.findings) << name;
    }
}
} // namespace counterpoint::cia306::test

#endif // TESTS_CANOPEN_CIA306_CHECK_TEXT_HPP
