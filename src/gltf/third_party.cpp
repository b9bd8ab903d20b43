// The one place where the header-only libraries of this folder are compiled.

// tiny_gltf.h uses streams without including them when it is told to leave files alone.
#include <fstream>
#include <ostream>
#include <string>

// Only to glue its messages together, tinygltf takes string streams, and with them come all of the standard library's
// locales: a page would have to fetch a fifteenth more. Inside its namespace, std is this one: the same, with a string
// stream that does no more than that.
namespace tinygltf::std {

using namespace ::std;

class stringstream {
public:
  stringstream& operator<<(const string& text) {
    text_ += text;
    return *this;
  }
  stringstream& operator<<(unsigned long long number) { return *this << to_string(number); }
  stringstream& operator<<(unsigned long number) { return *this << to_string(number); }
  stringstream& operator<<(unsigned number) { return *this << to_string(number); }
  stringstream& operator<<(int number) { return *this << to_string(number); }
  stringstream& operator<<(ostream& (*)(ostream&)) { return *this << "\n"; }  // std::endl
  [[nodiscard]] const string& str() const { return text_; }

private:
  string text_;
};

}  // namespace tinygltf::std

#define TINYGLTF_IMPLEMENTATION
#include "gltf/tinygltf_only.h"

// Only what glTF allows, and from memory only: the rest would be dead weight in the page.
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#include <stb/stb_image.h>
