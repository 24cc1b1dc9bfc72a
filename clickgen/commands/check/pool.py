"""Work on all cores: processes that run nothing of the working folder, and never outlive the one that started them."""

from __future__ import annotations

import contextlib
import os
import signal
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import connection, parent_process
from typing import TypeVar

from clickgen.workspace import CouldNotRun

T = TypeVar("T")
_SAFE_PATH = "PYTHONSAFEPATH"


def in_processes(work: Callable[..., T], tasks: Iterable[tuple[object, ...]], cores: int) -> Iterator[T]:
    """Return the results of the tasks in their order.

    Raises CouldNotRun if a process is killed, and whatever the work raises.
    """
    with _safe_path():
        pool = ProcessPoolExecutor(cores, initializer=_begin)
        try:
            futures = [pool.submit(work, *task) for task in tasks]
            for future in futures:
                yield future.result()
        except BrokenProcessPool:
            raise CouldNotRun(
                "a process of the check was killed, perhaps for want of memory; check fewer programs at once"
            ) from None
        except BaseException:
            # Nobody waits for the rest of it.
            pool.shutdown(wait=False, cancel_futures=True)
            raise
        pool.shutdown()


@contextlib.contextmanager
def _safe_path() -> Iterator[None]:
    """New interpreters look for no modules in the working folder, where they would look first (``python -c``)."""
    before = os.environ.get(_SAFE_PATH)
    os.environ[_SAFE_PATH] = "1"
    try:
        yield
    finally:
        if before is None:
            del os.environ[_SAFE_PATH]
        else:
            os.environ[_SAFE_PATH] = before


def _begin() -> None:
    """Set up a new process: Ctrl-C is for the one that started it, and when that one ends, so does this one."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = parent_process()
    if parent is not None:
        connection.wait([parent.sentinel])
        os._exit(1)
