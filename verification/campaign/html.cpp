// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/html.hpp"

namespace counterpoint::campaign::html
{
namespace
{
constexpr const char* kHead =
    "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<style>"
    ":root{--ink:#111;--ground:#fff;--line:#ccc;--bad:#fdd;--good:#dfd;--bar:#47a;--soft:#666}"
    "@media(prefers-color-scheme:dark){:root{--ink:#eee;--ground:#111;--line:#444;--bad:#622;--good:#252;--bar:#69c;"
    "--soft:#aaa}}"
    "body{font:16px/1.4 sans-serif;margin:1em auto;max-width:70em;padding:0 .6em;color:var(--ink);"
    "background:var(--ground);overflow-wrap:anywhere}h1{font-size:1.5em}h2{font-size:1.2em;margin-top:1.6em}"
    ".wide{overflow-x:auto}table{border-collapse:collapse;font-size:.9em}"
    "td,th{border-bottom:1px solid var(--line);padding:.2em "
    ".6em;text-align:right;white-space:nowrap;vertical-align:top}"
    "td:first-child,th:first-child{text-align:left;position:sticky;left:0;background:var(--ground)}"
    ".text td,.text th{text-align:left}.text td:last-child{white-space:normal;min-width:10em}"
    ".bad,.bad td{background:var(--bad)!important}.good{background:var(--good)}p.bad,p.good{padding:.4em .6em}"
    ".map td{padding:.2em .35em;font-size:.85em}.map th{font-weight:normal;font-size:.85em}"
    ".bar{display:inline-block;height:.8em;background:var(--bar)}svg{width:100%;height:auto}"
    "</style>\n";
} // namespace

std::string Escaped(const std::string& text)
{
    std::string escaped;
    for (const char character : text)
    {
        switch (character)
        {
        case '&':
            escaped += "&amp;";
            break;
        case '<':
            escaped += "&lt;";
            break;
        case '>':
            escaped += "&gt;";
            break;
        default:
            escaped += character;
            break;
        }
    }
    return escaped;
}

std::string Head(const std::string& title)
{
    return std::string(kHead) + "<title>" + Escaped(title) + "</title></head><body>\n<h1>" + Escaped(title) + "</h1>\n";
}

std::string Row(const std::vector<std::string>& cells, const char* const css_class)
{
    std::string row = *css_class == '\0' ? "<tr>" : "<tr class=\"" + std::string(css_class) + "\">";
    for (const std::string& cell : cells)
    {
        row += "<td>" + cell + "</td>";
    }
    return row + "</tr>\n";
}

std::string Table(const std::vector<std::string>& heads, const char* const css_class)
{
    std::string text = "<div class=\"wide\"><table class=\"" + std::string(css_class) + "\"><tr>";
    for (const std::string& head : heads)
    {
        text += "<th>" + head + "</th>";
    }
    return text + "</tr>\n";
}
} // namespace counterpoint::campaign::html
