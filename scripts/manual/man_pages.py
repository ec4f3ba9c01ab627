"""Manual pages: vvr(1) for the program, vvr-COMMAND(1) for each command."""

import datetime
import re


def write_man_pages(folder, commands, version, epoch, cli_page):
    """\param epoch the date of the pages, seconds since 1970
    \param cli_page the text of docs/cli.md, where config files, variables of the environment and exit statuses are described"""
    date = datetime.datetime.fromtimestamp(epoch, datetime.timezone.utc).date().isoformat()
    folder.mkdir(parents=True, exist_ok=True)

    def write(name, body):
        title = f'.TH {name.upper()} 1 {date} "vvr {version}" "vvr"\n'
        (folder / f"{name}.1").write_text(title + body, encoding="utf-8")

    write("vvr", program_page(commands, cli_page))
    for command in commands:
        write(f"vvr-{command.name}", command_page(command))


def program_page(commands, cli_page):
    text = ".SH NAME\nvvr \\- surveillance video as one still picture\n"
    text += ".SH SYNOPSIS\n.B vvr\n.I COMMAND\n.RI [ OPTIONS ]\n"
    text += ".SH COMMANDS\n"
    for command in commands:
        text += f".TP\n.BR vvr\\-{escape(command.name)} (1)\n{paragraph(command.help)}"
    text += ".SH CONFIG FILES\n"
    prose, example = re.search(r"## Config files\n\n(.*?)\n```toml\n(.*?)```", cli_page, flags=re.DOTALL).groups()
    text += "".join(map(prose_block, prose.strip().split("\n\n"))).removeprefix(".PP\n")
    text += ".PP\n.nf\n" + "".join(paragraph(line) for line in example.splitlines()) + ".fi\n"
    text += ".SH ENVIRONMENT\n"
    variables = re.findall(r"^\| (`[A-Z_`, ]+) \| (.*) \|$", cli_page.split("## Environment")[1].split("## ")[0], flags=re.MULTILINE)
    if not variables:
        raise ValueError("docs/cli.md lists no variables of the environment")
    for names, meaning in variables:
        text += f".TP\n.B {escape(names.replace('`', ''))}\n{paragraph(meaning)}"
    text += ".SH EXIT STATUS\n"
    statuses = re.findall(r"^\| ([\d, ]+) \| (.*) \|$", cli_page.split("## Exit status")[1], flags=re.MULTILINE)
    if not statuses:
        raise ValueError("docs/cli.md lists no exit status")
    for status, meaning in statuses:
        text += f".TP\n.B {status}\n{paragraph(meaning)}"
    text += ".SH SEE ALSO\n" + see_also([f"vvr-{command.name}" for command in commands])
    return text


def command_page(command):
    text = f".SH NAME\nvvr\\-{escape(command.name)} \\- {escape(command.help)}\n"
    text += f".SH SYNOPSIS\n.B vvr {escape(command.name)}\n{paragraph(command.usage.split(command.name, 1)[1].strip())}"
    if command.argument:
        name, explained = command.argument
        text += f".SH ARGUMENTS\n.TP\n.I {escape(name)}\n{paragraph(explained)}"
    text += ".SH OPTIONS\n"
    for title, options in command.groups.items():
        text += f".SS {escape(title)}\n" + "".join(map(option_entry, options))
    if command.units:
        text += ".SS Units\n" + "".join(f".TP\n.I {unit}\n{paragraph(meaning)}" for unit, meaning in command.units.items())
    if command.examples:
        text += ".SH EXAMPLES\n" + "".join(f".TP\n.B {escape(line)}\n{paragraph(what)}" for line, what in command.examples)
    return text + ".SH EXIT STATUS\n.BR vvr (1)\nlists them.\n.SH SEE ALSO\n" + see_also(["vvr"])


def option_entry(option):
    text = ".TP\n"
    names = ([f"-{option.letter}"] if option.letter else []) + [f"--{option.name}"]
    text += "\\fB" + "\\fR, \\fB".join(map(escape, names)) + "\\fR"
    if option.unit:
        text += f" \\fI{escape(option.unit)}\\fR"
    text += f"\n{paragraph(option.help)}"
    explained = [(name, help_) for name, help_ in option.values if help_]
    if explained:
        text += ".RS\n" + "".join(f".TP\n.B {escape(name)}\n{paragraph(help_)}" for name, help_ in explained) + ".RE\n"
    return text


def prose_block(block):
    """A paragraph or a list of Markdown."""
    if not block.startswith("- "):
        return f".PP\n{paragraph(block.replace(chr(10), ' '))}"
    return "".join(f".IP \\(bu 2\n{paragraph(item.replace(chr(10), ' '))}" for item in block[2:].split("\n- "))


def see_also(names):
    return ",\n".join(f".BR {escape(name)} (1)" for name in sorted(names)) + "\n"


def paragraph(text):
    return escape(text.replace("`", "'")) + "\n"


def escape(text):
    """Text as roff takes it: no escapes, no requests, and hyphens that can be copied."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return re.sub(r"^(?=[.'])", r"\\&", text, flags=re.MULTILINE)
