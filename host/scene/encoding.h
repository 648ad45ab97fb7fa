#pragma once
#include <string>

#include "scene/text_source.h"

namespace laver::xml {

/// An XML text as UTF-8. Its encoding is that of its first bytes (a byte order mark, or '<' in 16
/// or 32 bits) or else the declared one, and UTF-8 where there is neither. An encoding that is not
/// known, and bytes that are not of it, are problems.
FileText utf8Of(std::string bytes);

}  // namespace laver::xml
