# Turns viewer/dist into a C++ source: cmake -DSCRIPT=viewer.js -DSTYLE=viewer.css -DOUT=viewer_bundle.cpp -P embed_viewer.cmake
function(bytes_of file variable)
  file(READ ${file} hex HEX)
  string(REGEX REPLACE "(................................................................)" "\\1\n" hex "${hex}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," hex "${hex}")
  set(${variable} "${hex}" PARENT_SCOPE)
endfunction()

bytes_of(${SCRIPT} script)
bytes_of(${STYLE} style)
file(WRITE ${OUT} "#include \"beadmesh/report/viewer_bundle.h\"

namespace beadmesh {
namespace {
constexpr unsigned char script[] = {
${script}
};
constexpr unsigned char style[] = {
${style}
};
}  // namespace

std::string_view viewer_script() {
  return {reinterpret_cast<const char*>(script), sizeof script};
}

std::string_view viewer_style() {
  return {reinterpret_cast<const char*>(style), sizeof style};
}

}  // namespace beadmesh
")
