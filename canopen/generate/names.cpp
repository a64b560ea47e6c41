// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/generate/names.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/generate/generate.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <set>

namespace counterpoint::generate
{
namespace
{
/// Words of the language, and names that are not free (std), or that compilers take for numbers (linux, unix).
constexpr std::array<std::string_view, 104U> kTaken{
    "alignas",      "alignof",  "and",       "and_eq",    "asm",          "auto",          "bitand",
    "bitor",        "bool",     "break",     "case",      "catch",        "char",          "char16_t",
    "char32_t",     "class",    "compl",     "const",     "constexpr",    "const_cast",    "continue",
    "decltype",     "default",  "delete",    "do",        "double",       "dynamic_cast",  "else",
    "enum",         "explicit", "export",    "extern",    "false",        "float",         "for",
    "friend",       "goto",     "if",        "inline",    "int",          "long",          "mutable",
    "namespace",    "new",      "noexcept",  "not",       "not_eq",       "nullptr",       "operator",
    "or",           "or_eq",    "private",   "protected", "public",       "register",      "reinterpret_cast",
    "return",       "short",    "signed",    "sizeof",    "static",       "static_assert", "static_cast",
    "struct",       "switch",   "template",  "this",      "thread_local", "throw",         "true",
    "try",          "typedef",  "typeid",    "typename",  "union",        "unsigned",      "using",
    "virtual",      "void",     "volatile",  "wchar_t",   "while",        "xor",           "xor_eq",
    "char8_t",      "concept",  "consteval", "constinit", "co_await",     "co_return",     "co_yield",
    "requires",     "std",      "linux",     "unix",      "i386",         "main",          "arm",
    "counterpoint", "size_t",   "ptrdiff_t", "nullptr_t", "max_align_t",  "wint_t"};

/// What the generated files have besides the elements.
constexpr std::array<std::string_view, 25U> kOwnNames{
    "ConstantBytes", "Limits",         "PowerOn",      "Variables", "Setups",    "Settings",      "Fields",
    "AnyLength",     "ConstantValues", "NodeSettings", "NodeId",    "SrdoCount", "MapEntries",    "LongestObjectBytes",
    "EntryTable",    "Entries",        "EntryCount",   "Device",    "Objects",   "Configuration", "NodeValues",
    "InBoth",        "InRpdo",         "InTpdo",       "Stored"};

/// Namespaces that have names of their own in what the generated code includes.
constexpr std::array<std::string_view, 3U> kOurWholes{"counterpoint", "counterpoint::cia301",
                                                      "counterpoint::generated"};

bool IsLetter(const char character)
{
    return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z');
}

bool IsDigit(const char character)
{
    return character >= '0' && character <= '9';
}

/// Types and macros of <cstdint>, and what keeps a header of the generated code from being read twice. [SRS_GEN_490]
bool IsOfHeaders(const std::string& word)
{
    const std::regex names("u?int((_least|_fast)?(8|16|32|64)|max|ptr)_t|"
                           "U?INT((_LEAST|_FAST)?(8|16|32|64)|MAX|PTR)_(MAX|MIN|WIDTH|C)|"
                           "(PTRDIFF|SIG_ATOMIC|SIZE|WCHAR|WINT)_(MAX|MIN|WIDTH)|"
                           "(CANOPEN|HAL|SAFETY_CORE)_[A-Z0-9_]+_HPP");
    return std::regex_match(word, names);
}

bool IsTaken(const std::string& word)
{
    return std::find(kTaken.begin(), kTaken.end(), word) != kTaken.end() || IsOfHeaders(word);
}

bool IsNumbered(const std::string& name, const std::string& word)
{
    return name.rfind(word, 0U) == 0U && name.size() > word.size() && IsDigit(name[word.size()]);
}

bool IsOwnName(const std::string& name)
{
    const bool is_numbered = IsNumbered(name, "Srdo") || IsNumbered(name, "Map") || IsNumbered(name, "Signatures");
    return is_numbered || std::find(kOwnNames.begin(), kOwnNames.end(), name) != kOwnNames.end();
}

std::string AddressText(const cia306::Entry& entry)
{
    std::string text = cia306::Hex(entry.index, 4).substr(2U);
    return text + "Sub" + cia306::Hex(entry.sub, 2).substr(2U);
}

/// Of its object, and of itself where that says more.
std::string NameOf(const Element& element)
{
    const std::string own = PascalCase(element.entry->name);
    const std::string object = PascalCase(element.object_name);
    const bool is_whole = own.rfind(object, 0U) == 0U;
    std::string name = is_whole ? own : object + own;
    const bool is_name = !name.empty() && IsLetter(name.front());
    return is_name ? name : "Object" + AddressText(*element.entry) + name;
}

/// What is wrong with one part of a namespace.
std::string ProblemOfPart(const std::string& part, const bool is_first)
{
    const bool has_start = !part.empty() && IsLetter(part.front());
    const bool is_plain = std::all_of(part.begin(), part.end(), [](const char character)
                                      { return IsLetter(character) || IsDigit(character) || character == '_'; });
    if (!has_start || !is_plain || part.find("__") != std::string::npos)
    {
        return cia306::Quoted(part) +
               " is no name of a namespace, expected a letter, then letters, digits and single _";
    }
    const bool is_root = is_first && part == "counterpoint";
    return IsTaken(part) && !is_root ? cia306::Quoted(part) + " is taken, expected another name of a namespace" : "";
}

/// Classes, constants and functions of counterpoint begin with a capital letter, or with k and one; its namespaces have
/// none.
std::string ProblemOfOurs(const std::string& part)
{
    const bool has_capital =
        std::any_of(part.begin(), part.end(), [](const char letter) { return letter >= 'A' && letter <= 'Z'; });
    return has_capital ? cia306::Quoted(part) + " may be a name of counterpoint, expected small letters, digits and _"
                       : "";
}
} // namespace

std::string PascalCase(const std::string_view text)
{
    std::string name;
    bool begins = true;
    bool was_upper = false;
    for (const char character : text)
    {
        const bool is_upper = character >= 'A' && character <= 'Z';
        const bool is_part = IsLetter(character) || IsDigit(character);
        if (is_part)
        {
            // An acronym is a word: SRDO becomes Srdo. A capital letter after a small one begins a word.
            const bool is_inside = is_upper && was_upper;
            const bool is_small = character >= 'a'; // Behind the capital letters and the digits.
            const char upper = is_small && begins ? static_cast<char>(character - 'a' + 'A') : character;
            name += is_inside ? static_cast<char>(character - 'A' + 'a') : upper;
        }
        begins = !is_part;
        was_upper = is_upper;
    }
    return name;
}

std::string CommentText(const std::string_view text)
{
    std::string comment;
    for (const char character : text)
    {
        const bool is_plain = character >= ' ' && character <= '~' && character != '\\';
        const bool is_trigraph = character == '?' && !comment.empty() && comment.back() == '?';
        comment += is_plain && !is_trigraph ? character : '_';
    }
    return comment;
}

void NameElements(std::vector<Element>& elements)
{
    std::map<std::string, std::size_t> uses;
    for (Element& element : elements)
    {
        element.name = NameOf(element);
        ++uses[element.name];
    }
    std::set<std::string> names;
    for (Element& element : elements)
    {
        const bool is_own = uses[element.name] == 1U && !IsOwnName(element.name);
        element.name = is_own ? element.name : element.name + "At" + AddressText(*element.entry);
        while (!names.insert(element.name).second)
        {
            element.name += "X"; // A name of the file that looks like one that was made here.
        }
    }
}

std::string ProblemOfNamespace(const std::string& name)
{
    std::size_t end = name.find("::");
    std::string problem = ProblemOfPart(name.substr(0U, end), true);
    const bool is_ours = name.rfind("counterpoint::", 0U) == 0U;
    while (problem.empty() && end != std::string::npos)
    {
        const std::size_t begin = end + 2U;
        end = name.find("::", begin);
        const std::string part = name.substr(begin, end - begin);
        problem = ProblemOfPart(part, false);
        problem = problem.empty() && is_ours ? ProblemOfOurs(part) : problem;
    }
    const bool is_whole = std::find(kOurWholes.begin(), kOurWholes.end(), name) != kOurWholes.end();
    return problem.empty() && is_whole ? cia306::Quoted(name) + " alone is taken, expected " + name + "::name"
                                       : problem;
}

std::string NamespaceOf(const std::string& file)
{
    const std::size_t folder = file.find_last_of('/');
    std::string stem = folder == std::string::npos ? file : file.substr(folder + 1U);
    const std::size_t dot = stem.find_last_of('.');
    stem = dot == std::string::npos || dot == 0U ? stem : stem.substr(0U, dot);
    std::string name;
    for (const char character : stem)
    {
        const bool is_upper = character >= 'A' && character <= 'Z';
        const bool is_part = IsLetter(character) || IsDigit(character);
        const bool is_gap = !is_part && !name.empty() && name.back() != '_';
        name += is_part ? std::string(1U, is_upper ? static_cast<char>(character - 'A' + 'a') : character) : "";
        name += is_gap ? "_" : "";
    }
    while (!name.empty() && name.back() == '_')
    {
        name.pop_back();
    }
    const bool is_name = !name.empty() && IsLetter(name.front()) && !IsTaken(name);
    return is_name ? name : "device" + (name.empty() ? "" : "_" + name);
}
} // namespace counterpoint::generate
