"""The command line: what runs a command, and the exit codes.

Every command takes ``--json``. Exit codes: 0 done, 1 the answer is no (a check fails, a paper's value is not met),
2 bad input (one line says why), 130 interrupted.
"""

from __future__ import annotations

import io
import os
import re
import sys
import warnings
from collections.abc import Sequence
from typing import Annotated, Any

try:
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
except KeyboardInterrupt:  # before there is anything to say it with
    raise SystemExit(130) from None


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


def _outlets() -> None:
    """Standard output and error, which a parent may have closed or made unfit for a sign such as ≥."""
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115  as long as the process
        elif isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")


def _usage(error: Any) -> str:
    """What is wrong with a command line, and where help is."""
    context = error.ctx
    where = "chainrule" if context is None else context.command_path
    said = error.format_message().rstrip(".")
    if re.search(r": -[0-9.]", said):
        said += " (write -- before an argument that begins with a minus sign)"
    return f"{said}; {where} --help tells what is accepted"


#: What Typer raises for a command line it cannot read (its own class where it carries its own parser).
_REFUSED: type[Exception] = typer.BadParameter.__mro__[2]


def run(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code."""
    warnings.showwarning = _warn
    _outlets()
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
        complain(_usage(error))
    except BrokenPipeError:  # the reader of our output has gone: nothing more to say
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except OSError as error:
        complain(f"{error.filename or 'the output'}: {error.strerror or error}")
    except ModuleNotFoundError as error:
        name = (error.name or str(error)).partition(".")[0]
        complain(f"the package {name}, which this needs, cannot be imported; installing chainrule with pip brings it")
    except OverflowError:
        complain("a number given is too large: what follows from it is beyond the range of double precision")
    except MemoryError:
        complain("there is not enough memory for so much at once")
    except (KeyboardInterrupt, typer.Abort):
        complain("interrupted")
        return 130
    return 2


def main() -> None:
    """The ``chainrule`` command."""
    sys.exit(run())


if __name__ == "__main__":
    main()
