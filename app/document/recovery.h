#pragma once

#include "app/document/document.h"
#include "app/document/journal.h"
#include "plugins/api/registry.h"

namespace stipple {

/// The document as it was when its program ended, with its history and its journal, which goes on. Steps of
/// operators that the registry lacks can be undone, but are no steps of its recipe. Throws InvalidInput, in
/// one sentence, where the file is missing or not the same any more, another program has the journal, or the
/// journal does not fit; as readPoints does; and Cancelled.
Document recoverDocument(const LostWork& work, const Registry& registry, Progress& progress,
                         HistoryOptions history = {});

}  // namespace stipple
