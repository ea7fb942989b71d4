"""Writes an arm's functions as a folder that stands alone: C, NumPy, a README and test programs."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from chainrule.errors import GenerationError, InputError, shown

if TYPE_CHECKING:
    from chainrule.arm import Arm

TARGETS = ("c", "python")


def generate(
    arm: Arm,
    directory: str | os.PathLike[str],
    targets: Sequence[str] = TARGETS,
    progress: Callable[[str], None] = lambda line: None,
    *,
    task: str | None = None,
) -> tuple[Path, ...]:
    """Write everything generated for an arm into ``directory``, which is made if needed.

    C99 for double and float (``-Wall -Wextra -Werror -pedantic`` clean, no allocation), a NumPy module, a README with
    the compile line, and test programs that compare with reference values of 40 digits. The C has the step of a
    controller along a task, ``<arm>_step``, with its law in a struct, and with joints to spare ``<arm>_priority_step``,
    which takes a secondary task as well. Files of the same names are replaced; nothing else is touched; each file is
    written whole or not at all.

    Args:
        arm: the arm.
        directory: where to write.
        targets: ``"c"``, ``"python"`` or both.
        progress: called with one line for each step.
        task: what the step follows; when absent the arm's default task, if that has no more rows than joints.

    Returns:
        The paths written.

    Raises:
        InputError: an unknown target; a task of more rows than joints.
        GenerationError: the folder cannot be written.

    Example:
        >>> import tempfile, chainrule as cr
        >>> folder = tempfile.mkdtemp()
        >>> [p.name for p in generate(cr.planar("RP", [0.5, 0.0]), folder, targets=["python"])]
        ['README.md', 'planar_rp.py', 'test_planar_rp.py']
    """
    targets = (targets,) if isinstance(targets, str) else tuple(targets)
    if not isinstance(directory, str | os.PathLike):
        raise InputError(f"directory: {shown(directory)}; the path of a folder is accepted")
    unknown = [target for target in targets if target not in TARGETS]
    if unknown or not targets:
        raise InputError(f"targets: {unknown or 'none'}; one or more of {', '.join(TARGETS)} are accepted")
    from chainrule.arm import checked_arm
    from chainrule.derive import manifest, standalone

    followed = checked_arm(arm).default_task if task is None else checked_arm(arm).task_of_full_rank(task)
    files = standalone.folder(arm.description, targets, followed, progress)
    target = Path(directory)
    try:
        for name, text in sorted(files.items()):
            manifest.write_whole(target / name, text)
    except OSError as error:
        raise GenerationError(f"{target} cannot be written: {error.strerror}") from None
    return tuple(target / name for name in sorted(files))
