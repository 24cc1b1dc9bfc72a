"""The one place that runs git. It reads objects and the index, and starts nothing that a repository names.

The configuration of a repository may come from somebody else, and git would start programs that it
names: a file-system monitor when it reads the index, helpers and a remote shell when an object is missing. All of it is
switched off, in the environment and on the command line, which override the repository's configuration.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

_SECONDS_MAX = 120
"""A repository whose files are pipes would keep git waiting for ever."""
_OFF = {
    "core.fsmonitor": "",
    "core.hooksPath": os.devnull,
    "core.sshCommand": "false",
    "core.gitProxy": "",
    "core.askPass": "",
    "core.alternateRefsCommand": "",
    "credential.helper": "",
    "protocol.allow": "never",
    "fetch.recurseSubmodules": "false",
    "maintenance.auto": "false",
    "gc.auto": "0",
}
_ENVIRONMENT = {
    "LC_ALL": "C",
    "GIT_OPTIONAL_LOCKS": "0",
    "GIT_LITERAL_PATHSPECS": "0",
    "GIT_NO_LAZY_FETCH": "1",
    # Only the protocols in this list, whatever the configuration allows: none has this name.
    "GIT_ALLOW_PROTOCOL": "none",
    "GIT_TERMINAL_PROMPT": "0",
    "GIT_SSH_COMMAND": "false",
    "GIT_PAGER": "cat",
}
_LEFT_OUT = ("GIT_ASKPASS", "SSH_ASKPASS", "GIT_EXTERNAL_DIFF", "GIT_PROXY_COMMAND", "GIT_SSH")


def run_git(*words: str, given: bytes | None = None) -> subprocess.CompletedProcess[bytes]:
    """Run a git command that only reads. Raises FileNotFoundError without git, and TimeoutExpired."""
    program = _program()
    if program is None:
        raise FileNotFoundError("git")
    settings = [word for name, value in _OFF.items() for word in ("-c", f"{name}={value}")]
    environment = {name: value for name, value in os.environ.items() if name not in _LEFT_OUT} | _ENVIRONMENT
    return subprocess.run(
        [program, "--no-pager", *settings, *words],
        # An empty pipe, so that nothing can ask the terminal.
        input=given or b"",
        capture_output=True,
        env=environment,
        check=False,
        timeout=_SECONDS_MAX,
    )


def _program() -> str | None:
    """git in a folder of PATH; never in the working folder, where Windows would look first."""
    names = ["git.exe", "git.cmd"] if sys.platform == "win32" else ["git"]
    for folder in os.environ.get("PATH", os.defpath).split(os.pathsep):
        for name in names if os.path.isabs(folder) else ():
            path = Path(folder, name)
            if path.is_file() and os.access(path, os.X_OK):
                return str(path)
    return None
