"""clickgen: ladder logic as text for AutomationDirect CLICK PLCs.

``build`` does what the command ``clickgen build`` does, in memory, and ``check`` judges a program as ``clickgen check``
does, before anything is silenced::

    import clickgen

    result = clickgen.build("prog.py")
    for problem in result.diagnostics:
        print(problem.code, problem.span, problem.message)
    if result.ok:
        result.write(Path("out"))
"""

TYPE_CHECKING = False
"""As in typing, whose import would be a good part of the time that ``clickgen --version`` takes."""

if TYPE_CHECKING:
    from clickgen.api import build, check
    from clickgen.config import Settings
    from clickgen.results import BuildResult, CheckResult
    from clickgen.workspace import CouldNotRun

__version__ = "0.1.0"
__all__ = ["BuildResult", "CheckResult", "CouldNotRun", "Settings", "__version__", "build", "check"]


def __getattr__(name: str) -> object:
    """Load the pipeline at first use: ``clickgen --version`` needs none of it."""
    if name in __all__:
        import clickgen.api

        # All of them at once: the import leaves the folder of the rules behind under the name of the function check.
        globals().update({name: getattr(clickgen.api, name) for name in __all__ if not name.startswith("_")})
        return globals()[name]
    raise AttributeError(f"module 'clickgen' has no attribute {name!r}")
