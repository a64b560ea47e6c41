// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_FILE_OBJECT_READER_HPP
#define CANOPEN_CIA306_FILE_OBJECT_READER_HPP

#include "canopen/cia306/file/device.hpp"
#include "canopen/cia306/text/ini_document.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace counterpoint::cia306
{
constexpr std::size_t kMaxEntries = 200000U;

/// What a section describes, by its name.
enum class SectionKind : std::uint8_t
{
    kOther = 0U,
    kObject = 1U,     ///< [1018]
    kSub = 2U,        ///< [1018sub1], hexadecimal
    kNames = 3U,      ///< [1018Name]
    kValues = 4U,     ///< [1018Value]
    kObjectPart = 5U, ///< [1018Denotation], [1018ObjectLinks]
    kMisspelt = 6U,   ///< Begins like an object and is none.
};

/// The parts of the name of a section.
struct SectionName
{
    SectionKind kind{SectionKind::kOther};
    std::uint16_t index{0U};
    std::uint8_t sub{0U};
};

/// Reads the objects of a document into `device`, in passes, because a file may hold its sections in any order.
class ObjectReader
{
  public:
    ObjectReader(const IniDocument& document, Device& device) noexcept;

    /// Throws InputError.
    void Read();

  private:
    using Pass = void (ObjectReader::*)(const IniSection&, const SectionName&);

    void ForEach(SectionKind kind, Pass pass);
    void ReadObject(const IniSection& section, const SectionName& name);
    void ReadSub(const IniSection& section, const SectionName& name);
    void ReadNames(const IniSection& section, const SectionName& name);
    void ReadValues(const IniSection& section, const SectionName& name);
    void WarnOfName(const IniSection& section, const SectionName& name);
    void AddCompactEntries(const IniSection& section, Object& object, std::uint8_t count);
    void AddEntry(Object& object, Entry entry, Place place);
    void DropVariable(Object& object);
    [[nodiscard]] Entry* CompactEntry(const IniSection& section, const IniKey& key, std::uint16_t index);
    void Warn(Place place, const std::string& text);

    const IniDocument* document_;
    Device* device_;
    std::size_t entry_count_{0U};
};
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_FILE_OBJECT_READER_HPP
