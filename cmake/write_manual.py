#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Manual pages and bash completion of an installed barreno, made of what it says of itself with --help.

    write_manual.py BARRENO MAN1_FOLDER COMPLETION_FOLDER
"""
import os
import pathlib
import re
import subprocess
import sys

COMPLETION = """\
# Of bash, for barreno: made by cmake/write_manual.py of the source tree from `barreno COMMAND --help`.
_barreno() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} command=${{COMP_WORDS[1]-}} offered=""
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "{commands}" -- "$word")
    return
  fi
  case $command in
{cases}
  esac
  [[ $word == -* ]] && mapfile -t COMPREPLY < <(compgen -W "$offered" -- "$word")
  return 0
}}
complete -o default -F _barreno barreno
"""
# roff reads these at the beginning of a line as requests, and a backslash everywhere as an escape.
LINE_STARTS = (".", "'")


def said(barreno, *words):
    """What the command prints, or nothing if it cannot."""
    wide = {**os.environ, "COLUMNS": "100", "PYTHONDONTWRITEBYTECODE": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
        "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    result = subprocess.run([barreno, *words], capture_output=True, text=True, env=wide, check=False)
    return result.stdout if result.returncode == 0 else ""


def entry_of(command, usage):
    """The lines of the list of all commands about one of them."""
    found = re.search(rf"^barreno {command}\b.*\n(?:[ ].*\n)*", usage, re.MULTILINE)
    return found.group(0) if found else ""


def summary_of(command, text, usage):
    """One line for the name of a page: the first sentence of its help, or else of the list of all commands."""
    paragraphs = [part for part in text.split("\n\n") if not re.match(r"usage:", part, re.IGNORECASE)]
    sentence = " ".join(paragraphs[0].split()) if paragraphs else ""
    if not sentence or text == usage:
        sentence = re.split(r"\s{3,}|\]\s{2,}", entry_of(command, usage).strip())[-1]
    return re.split(r"[.:;]\s|[.:;]$| \(docs", " ".join(sentence.split()))[0]


def roff(text):
    lines = []
    for line in text.rstrip("\n").splitlines():
        line = line.replace("\\", "\\e").replace("-", "\\-")
        lines.append(("\\&" if line.startswith(LINE_STARTS) else "") + line)
    return "\n".join(lines)


def page(name, version, summary, text, others):
    title = name.upper()
    also = ", ".join(f"\\fB{roff(other)}\\fR(1)" for other in others)
    return (f'.TH {title} 1 "" "Barreno {version}" "Barreno"\n.SH NAME\n{roff(name)} \\- {roff(summary)}\n'
            f".SH DESCRIPTION\n.nf\n{roff(text)}\n.fi\n.SH SEE ALSO\n{also}\n")  # fmt: skip


def options_of(text):
    """--words at the head of lines, in their order."""
    return list(dict.fromkeys(re.findall(r"^ +(?:-\w, ?)?(--[a-z][a-z-]*)", text, re.MULTILINE)))


def main():
    barreno, manual, completion = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    usage = said(barreno, "help")
    version = re.search(r"\d+\.\d+\.\d+", said(barreno, "--version"))
    if not usage or not version:
        sys.exit(f"{barreno} does not start: its manual pages cannot be made.")
    commands = list(dict.fromkeys(re.findall(r"^barreno ([a-z][a-z-]*)", usage, re.MULTILINE)))
    for folder in (manual, completion):
        folder.mkdir(parents=True, exist_ok=True)
    names, cases = [f"barreno-{command}" for command in commands], []
    for command, name in zip(commands, names):
        text = said(barreno, command, "--help") if command != "decks" else usage
        shown = entry_of(command, usage) if text in ("", usage) else text
        others = ["barreno", *(other for other in names if other != name)]
        (manual / f"{name}.1").write_text(page(name, version[0], summary_of(command, text, usage), shown, others))
        cases.append(f'    {command}) offered="{" ".join(options_of(text)) if text != usage else ""}" ;;')
    summary = "shaped-charge jets into rock by the material point method"
    (manual / "barreno.1").write_text(page("barreno", version[0], summary, usage, names))
    (completion / "barreno").write_text(COMPLETION.format(commands=" ".join([*commands, "help", "--version"]), cases="\n".join(cases)))


if __name__ == "__main__":
    main()
