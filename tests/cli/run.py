"""Runs one test of the command line, or lists their names: run.py --list | --list-slow | run.py VVR SOURCE CASE."""

import os
import sys

import cases_backend  # noqa: F401
import cases_annotations  # noqa: F401
import cases_archive  # noqa: F401
import cases_archive_index  # noqa: F401
import cases_cluster  # noqa: F401
import cases_compare  # noqa: F401
import cases_data  # noqa: F401
import cases_day  # noqa: F401
import cases_docs  # noqa: F401
import cases_examples  # noqa: F401
import cases_golden  # noqa: F401
import cases_input  # noqa: F401
import cases_length  # noqa: F401
import cases_look  # noqa: F401
import cases_options  # noqa: F401
import cases_output  # noqa: F401
import cases_page  # noqa: F401
import cases_process  # noqa: F401
import cases_report  # noqa: F401
import cases_series  # noqa: F401
import cases_watch  # noqa: F401
from harness import CASES, SLOW, Bench, Skip


SKIPPED = 77  # what ctest takes for a test that was skipped


def main():
    if sys.argv[1:] == ["--list"]:
        print("\n".join(CASES))
        return
    if sys.argv[1:] == ["--list-slow"]:
        print("\n".join(SLOW))
        return
    vvr, source, name = sys.argv[1:]
    bench = Bench(vvr, source)
    try:
        CASES[name](bench)
    except AssertionError as failure:
        sys.exit(f"{name}: {failure}")
    except Skip as reason:
        print(f"{name} was skipped: {reason}")
        sys.exit(1 if os.environ.get("VVR_ALL_REQUIRED") == "1" else SKIPPED)
    finally:
        bench.close()


if __name__ == "__main__":
    main()
