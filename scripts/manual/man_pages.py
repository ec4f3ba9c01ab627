"""Manual pages: vvr(1) for the program, vvr-COMMAND(1) for each command."""

import datetime
import re

from program_help import by_group, names_of, text_of, usage_of


def write_man_pages(folder, program, epoch, pages):
    """\param epoch the date of the pages, seconds since 1970
    \param pages scripts/cli-page.md, which describes config files"""
    date = datetime.datetime.fromtimestamp(epoch, datetime.timezone.utc).date().isoformat()
    folder.mkdir(parents=True, exist_ok=True)

    def write(name, body):
        title = f'.TH {name.upper()} 1 {date} "vvr {program["vvr"]}" "vvr"\n'
        (folder / f"{name}.1").write_text(title + body, encoding="utf-8")

    write("vvr", program_page(program, pages))
    for command in program["commands"]:
        write(f"vvr-{command['name']}", command_page(command, program["values"]))


def program_page(program, pages):
    text = f".SH NAME\nvvr \\- {escape(program['summary'])}\n"
    text += ".SH SYNOPSIS\n.B vvr\n.I COMMAND\n.RI [ OPTIONS ]\n"
    text += ".SH COMMANDS\n"
    for command in program["commands"]:
        text += f".TP\n.BR vvr\\-{escape(command['name'])} (1)\n{paragraph(command['help'])}"
    text += ".SH CONFIG FILES\n"
    prose, example = re.search(r"## Config files\n\n(.*?)\n```toml\n(.*?)```", pages, flags=re.DOTALL).groups()
    text += "".join(map(prose_block, prose.strip().split("\n\n"))).removeprefix(".PP\n")
    text += ".PP\n.nf\n" + "".join(paragraph(line) for line in example.splitlines()) + ".fi\n"
    text += ".SH ENVIRONMENT\n" + rows((row["name"], row["help"]) for row in program["environment"])
    text += ".SH EXIT STATUS\n" + rows((str(row["status"]), row["help"]) for row in program["exit_statuses"])
    return text + ".SH SEE ALSO\n" + see_also([f"vvr-{command['name']}" for command in program["commands"]])


def command_page(command, values):
    text = f".SH NAME\nvvr\\-{escape(command['name'])} \\- {escape(command['help'])}\n"
    text += f".SH SYNOPSIS\n.B vvr {escape(command['name'])}\n{paragraph(usage_of(command).split(' ', 2)[2])}"
    if command["arguments"]:
        text += ".SH ARGUMENTS\n" + rows([(command["arguments"]["name"], command["arguments"]["help"])], ".I")
    text += ".SH OPTIONS\n"
    for title, options in by_group(command["options"]).items():
        text += f".SS {escape(title)}\n" + "".join(map(option_entry, options))
    used = {option["value"] for option in command["options"]}
    units = [(value["name"], value["help"]) for value in values if value["name"] in used]
    if units:
        text += ".SS Units\n" + rows(units, ".I")
    text += ".SH EXAMPLES\n" + rows((example["command"], example["help"]) for example in command["examples"])
    return text + ".SH EXIT STATUS\n.BR vvr (1)\nlists them.\n.SH SEE ALSO\n" + see_also(["vvr"])


def option_entry(option):
    text = ".TP\n\\fB" + "\\fR, \\fB".join(map(escape, names_of(option))) + "\\fR"
    if option["value"]:
        text += f" \\fI{escape(option['value'])}\\fR"
    text += f"\n{paragraph(text_of(option))}"
    if option["choices"]:
        text += ".RS\n" + rows((choice["name"], choice["help"]) for choice in option["choices"]) + ".RE\n"
    return text


def rows(pairs, font=".B"):
    """Names and what they mean."""
    return "".join(f".TP\n{font} {escape(name)}\n{paragraph(meaning)}" for name, meaning in pairs)


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
