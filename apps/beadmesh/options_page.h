// The reference of options as a page of the documentation, from the options themselves.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace beadmesh::app {

/// Every verb with its options, then every key of the configuration file. Markdown.
std::string page_of(const CLI::App& app);

}  // namespace beadmesh::app
