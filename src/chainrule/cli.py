"""The command line: what runs a command, and the exit codes.

Every command takes ``--json``. Exit codes: 0 done, 1 the answer is no (a check fails, a paper's value is not met),
2 bad input (one line says why), 130 interrupted.
"""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Sequence
from typing import Annotated, Any

import typer

from chainrule.commands import (  # noqa: F401  each adds its commands to the application
    arms,
    classify,
    follow,
    four_joints,
    generate,
    manipulability,
    min_time,
    report,
    reproduce,
    self_motion,
    speed_ratios,
    track,
    workspace,
)
from chainrule.console import app, complain, say
from chainrule.errors import GenerationError, InputError


def _version(wanted: bool) -> None:
    if wanted:
        import chainrule

        say(f"chainrule {chainrule.__version__}")
        raise typer.Exit


@app.callback()
def _options(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    """Shared options."""


def _warn(message: Warning | str, category: type[Warning], *rest: Any, **more: Any) -> None:
    complain(f"note: {message}")


#: What Typer raises for a command line it cannot read (its own class where it carries its own parser).
_REFUSED: type[Exception] = typer.BadParameter.__mro__[2]


def run(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code."""
    warnings.showwarning = _warn
    command = typer.main.get_command(app)
    words = sys.argv[1:] if arguments is None else list(arguments)
    try:
        with command.make_context("chainrule", words) as context:
            command.invoke(context)
        sys.stdout.flush()
        return 0
    except typer.Exit as done:
        return done.exit_code
    except (InputError, GenerationError) as error:
        complain(str(error))
    except _REFUSED as error:
        if type(error).__name__ == "NoArgsIsHelpError":
            return 2  # the help was printed
        complain(error.format_message())  # type: ignore[attr-defined]
    except BrokenPipeError:  # the reader of our output has gone: nothing more to say
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except OSError as error:
        complain(f"{error.filename or 'a file'}: {error.strerror or error}")
    except (KeyboardInterrupt, typer.Abort):
        complain("interrupted")
        return 130
    return 2


def main() -> None:
    """The ``chainrule`` command."""
    sys.exit(run())


if __name__ == "__main__":
    main()
