#include "gpu/native_context.h"

// In WebAssembly: no one but a page can make a context.
namespace dimline {

Result<std::unique_ptr<NativeContext>> NativeContext::make() { return Error{"There is no OpenGL here outside a page."}; }

NativeContext::~NativeContext() = default;

}  // namespace dimline
