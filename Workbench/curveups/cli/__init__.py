# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: arguments, exit statuses, one-line errors. commands.py runs the commands."""

from __future__ import annotations

import argparse
import os
import sys
import traceback
from pathlib import Path
from typing import Any, Callable, NoReturn, Optional, Sequence

from .. import __version__
from ..base.errors import BAD_INPUT, NOT_WRITTEN, STOPPED, CurveUpsError, Stopped, without_package
from ..base.output import require_folder_name
from ..base.profiles import profile_names
from ..base.progress import Interrupt, Reporter

_EPILOG = """exit status: 0 valid, or verification was off; 1 finished, but not valid; 2 bad input or usage,
nothing written; 3 stopped, the best so far was written; 4 a file could not be written"""
_Argument = tuple[tuple[str, ...], dict[str, Any]]  # of add_argument


class _Parser(argparse.ArgumentParser):
    """Raises argument errors as CurveUpsError."""

    def error(self, message: str) -> NoReturn:
        raise CurveUpsError(message, "command line", f"see '{self.prog} --help'")


def make_parser() -> argparse.ArgumentParser:
    """Parser of all commands."""
    parser = _Parser(prog="curveups", epilog=_EPILOG, allow_abbrev=False,
                     description="Design a CurveUp, from the target surface to the print files.")
    parser.add_argument("--version", action="version", version=f"curveups {__version__}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND", parser_class=_Parser)

    def add(name: str, text: str, *arguments: _Argument) -> None:
        command = commands.add_parser(name, help=text, description=text[0].upper() + text[1:] + ".",
                                      allow_abbrev=False, epilog=_EPILOG)
        for names, options in arguments:
            command.add_argument(*names, **options)

    quiet = _argument("--quiet", action="store_true", help="show no progress")
    output, may_output = (_argument("-o", dest="output", type=_folder, required=required, metavar="DIR",
                                    help="write the files to this folder") for required in (True, False))
    settings = _argument(
        "--set", dest="settings", action="append", default=[], metavar="name=value",
        help="a parameter, or several; see 'curveups parameters'. L=auto and H_body=auto choose the largest "
             "that work; material_membrane, material_glue and material_tile choose from the library")
    target = (
        _argument("target", metavar="TARGET",
                  help="a built-in name, or an OBJ, STL, PLY, OFF, 3MF, STEP, IGES or BREP file"),
        settings, _argument("--config", type=Path, action="append", default=[], metavar="FILE.json",
                            help='parameters as { "name": value, ... }, with a note as "about"; may be given '
                                 "several times: the last wins, and --set wins over all"),
        _argument("--profile", choices=profile_names(), metavar="NAME",
                  help="parameters that print well on one kind of printer "
                       f"({', '.join(profile_names())}); --config and --set win over them"), quiet)
    mesh = (_argument("--cuts", type=Path, metavar="FILE.json", help="cuts, as vertex pairs or polylines"),
            _argument("--no-remesh", action="store_true", help="take the mesh as it is"))
    design = (_argument("design", type=Path, metavar="DESIGN.json"), quiet)
    check_all = _argument("--check-all", action="store_true",
                          help="let OpenCASCADE check the solids of all bodies, slabs too, instead of 16 of "
                               "each kind")
    add("design", "design a target, from its surface to print files", *target, output, *mesh,
        _argument("--follow", type=Path, metavar="DESIGN.json",
                  help="carry the tiles, cuts and parameters of this design along, where the target's shape "
                       "has changed"),
        _argument("--auto-cuts", type=_number_of("cuts", 0, 100), default=0, metavar="N",
                  help="make up to N suggested cuts; the first opens a closed target"),
        _argument("--self-shaping", action="store_true",
                  help="move pins and tiles until the design needs as little friction as it can, so that the "
                       "piece comes to rest near the target"),
        _argument("--no-solids", action="store_true", help="write only design.json and the reports"),
        check_all)
    add("check", "find out which parts of a target can become tiles", *target, may_output, *mesh)
    add("remesh", "write the remeshed target as NAME-remeshed.obj", *target, output)
    add("targets", "list the built-in targets")
    add("parameters", "list the parameters: name, unit, default, range, meaning",
        _argument("--all", action="store_true", help="list the advanced ones and switches, too"))
    add("verify", "verify a design file by the exact physical model", *design, may_output)
    add("export", "write print files of a design file", *design, output, settings,
        _argument("--tiles", metavar="T00012,...", help="write these tiles alone, as spares"), check_all)
    add("kit", "write all that is needed from the order to the finished shell", *design, output, settings,
        _argument("--quantity", type=_number_of("pieces", 1, 1000), default=1, metavar="N",
                  help="how many to order"),
        _argument("--names", default="{name}-{body}", metavar="MASK",
                  help="names of print files, of {name}, {body}, {material}, {thickness} and {quantity}"),
        _argument("--language", default="en", metavar="de", help="language of the sheets (default: en)"))
    add("compare", "compare a scan of a built piece with its design", *design, output,
        _argument("scan", type=Path, metavar="SCAN",
                  help="a mesh, or points as text: x y z a line, of markers T00012 x y z"))
    add("actuate", "compute the shape of the built piece: released from flat, shaken, pressed over its "
        "former", *design, output, settings)
    return parser


def _argument(*names: str, **options: Any) -> _Argument:
    return names, options


def _number_of(what: str, least: int, most: int) -> Callable[[str], int]:
    """Type of an argument: a whole number in this range."""
    def number(text: str) -> int:
        if not text.isdecimal() or not text.isascii() or not least <= int(text) <= most:
            raise argparse.ArgumentTypeError(f"'{text}' is no number of {what} from {least} to {most}")
        return int(text)

    return number


def _folder(text: str) -> Path:
    if not text:
        raise argparse.ArgumentTypeError("the folder has no name")
    return Path(text)


def _one_setting_each(arguments: Sequence[str]) -> list[str]:
    """Arguments with `--set a=1 b=2`, or `--set=a=1 b=2`, as `--set a=1 --set b=2`. Arguments that look like
    name=value are settings, so that TARGET may follow settings."""
    separate: list[str] = []
    setting = False
    for argument in arguments:
        if setting and argument.partition("=")[0].isidentifier() and "=" in argument:
            if separate[-1] != "--set":
                separate.append("--set")
        elif not (setting and separate[-1] == "--set"):
            setting = argument == "--set" or argument.startswith("--set=")
        separate.append(argument)
    return separate


def run(arguments: Optional[list[str]]) -> int:
    """Runs one command and returns its exit status. Raises CurveUpsError."""
    options = make_parser().parse_args(_one_setting_each(sys.argv[1:] if arguments is None else arguments))
    if getattr(options, "output", None):
        require_folder_name(options.output)
    with Interrupt() as interrupt:
        reporter = Reporter(interrupt, getattr(options, "quiet", False))
        try:
            # Imported here so that --help works with a broken native module.
            from . import commands

            return commands.COMMANDS[options.command](options, reporter)
        finally:
            reporter.close()


def main(arguments: Optional[list[str]] = None) -> int:
    """Runs the program and returns its exit status."""
    try:
        return run(arguments)
    except CurveUpsError as error:
        _tell(str(error))
        return error.status
    except (Stopped, KeyboardInterrupt):
        print("curveups: stopped", file=sys.stderr)
        return STOPPED
    except BrokenPipeError:
        return NOT_WRITTEN
    except MemoryError:
        _tell("there is not enough memory (this machine): use larger tiles or a smaller target")
    except Exception as error:  # otherwise Python would end with status 1, which means "not valid"
        if isinstance(known := without_package(error), CurveUpsError):
            _tell(str(known))
            return known.status
        text = " ".join(str(error).split())
        _tell(f"unexpected {type(error).__name__}{f' ({text})' if text else ''}: please report it, with "
              "what CURVEUPS_DEBUG=1 shows")
    return BAD_INPUT


def _tell(text: str) -> None:
    """Prints an error in one line, after its traceback with CURVEUPS_DEBUG=1."""
    if os.environ.get("CURVEUPS_DEBUG") == "1":
        traceback.print_exc()
    print(f"curveups: error: {text}", file=sys.stderr)
