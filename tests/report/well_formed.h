// Enough of an XML reader to tell a well-formed picture from a broken one.
#pragma once

#include <string>
#include <vector>

namespace beadmesh::test {

inline int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

/// Tags that do not match, "nan" or "inf" among the numbers, '<' or '&' left raw; empty where all is well.
inline std::string first_fault(const std::string& text) {
  std::vector<std::string> open;
  for (size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    const size_t end = text.find('>', at);
    if (end == std::string::npos) return "a tag without end";
    const std::string tag = text.substr(at + 1, end - at - 1);
    if (tag.find('<') != std::string::npos) return "raw < in " + tag.substr(0, 40);
    if (tag.find("nan") != std::string::npos || tag.find("inf") != std::string::npos)
      return "no number in " + tag.substr(0, 80);
    if (tag.back() == '/' || tag[0] == '!' || tag[0] == '?') continue;
    const std::string name = tag.substr(0, tag.find_first_of(" \n"));
    if (name[0] != '/') {
      open.push_back(name);
    } else {
      if (open.empty() || open.back() != name.substr(1)) return "unexpected " + name;
      open.pop_back();
    }
  }
  for (size_t at = text.find('&'); at != std::string::npos; at = text.find('&', at + 1))
    if (text.find(';', at) - at > 8) return "raw & near " + text.substr(at, 20);
  return open.empty() ? "" : "never closed: " + open.back();
}

}  // namespace beadmesh::test
