"""The parts of the benchmark: each measures, and gives its section of the report and its numbers."""

import browser_page
import computing
import pictures
import whole_runs

PARTS = {
    "pipeline": whole_runs.pipeline,
    "cameras": whole_runs.cameras,
    "files": whole_runs.files,
    "page": whole_runs.page,
    "browser": browser_page.browser,
    "archive": whole_runs.archive,
    "many": whole_runs.many,
    "length": whole_runs.length,
    "options": whole_runs.options,
    "startup": whole_runs.startup,
    "context": whole_runs.context,
    "peers": computing.peers,
    "table1": pictures.table1,
}
