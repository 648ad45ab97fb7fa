#pragma once
#include <string>

namespace laver {

/// Makes a new file in `folder` (empty: the working folder), open for writing and locked as long
/// as it is open; `name` becomes its path. Returns its descriptor, or -1 with errno set.
int openTemporary(const std::string& folder, std::string& name);

/// Removes from `folder` what openTemporary made and nobody has open any more: its process was
/// killed. The lock tells, not the process number in the name, which means nothing to another
/// machine or container that shares the folder. What cannot be locked stays.
void removeAbandoned(const std::string& folder);

}  // namespace laver
