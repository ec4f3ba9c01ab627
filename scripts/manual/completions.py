"""Completions of commands, options and values, for bash, zsh and fish."""

from program_help import names_of, text_of

MADE = "made by scripts/manual from the program's own help"
FOLDERS = {"DIR"}
FILES = {"FILE", "PATH", "MODEL"}


def write_completions(folder, commands):
    for name, text in (("bash/vvr", bash(commands)), ("zsh/_vvr", zsh(commands)), ("fish/vvr.fish", fish(commands))):
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")


def takes(option):
    """What a shell completes the value with."""
    if option["value"] == "LIST":
        return "list"
    if option["value"] in FOLDERS:
        return "folder"
    return "file" if option["file"] or option["value"] in FILES else "value"


def choices_of(option):
    return " ".join(choice["name"] for choice in option["choices"])


BASH = """\
# bash completion for vvr, {made}
_vvr() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} command=${{COMP_WORDS[1]}}
    local options= values= takes=
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        mapfile -t COMPREPLY < <(compgen -W '{commands}' -- "$current")
        return
    fi
    # bash takes the = of --filter=edges for a word of its own.
    if [[ $current == = ]]; then
        current=
    elif [[ $before == = ]]; then
        before=${{COMP_WORDS[COMP_CWORD - 2]}}
    fi
    case $command in
{options}
    *) return ;;
    esac
    case $command:$before in
{values}
    esac
    if [[ -n $values ]]; then
        local prefix=
        if [[ $takes == list && $current == *,* ]]; then
            prefix=${{current%,*}},
        fi
        mapfile -t COMPREPLY < <(compgen -P "$prefix" -W "$values" -- "${{current#"$prefix"}}")
        if [[ $takes == list ]]; then
            compopt -o nospace 2>/dev/null
        fi
    fi
    case $takes in
    file) compopt -o default 2>/dev/null ;;
    folder) compopt -o dirnames 2>/dev/null ;;
    "")
        if [[ $current == -* ]]; then
            mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
        else
            compopt -o default 2>/dev/null
        fi
        ;;
    esac
}}
complete -F _vvr vvr
"""


def bash(commands):
    options, values = [], []
    for command in commands:
        names = " ".join(name for option in command["options"] for name in names_of(option))
        options.append(f"    {command['name']}) options='{names}' ;;")
        for option in command["options"]:
            if not option["value"]:
                continue
            known = choices_of(option)
            patterns = "|".join(f"{command['name']}:{name}" for name in names_of(option))
            values.append(f"    {patterns}) takes={takes(option)}" + (f" values='{known}'" if known else "") + " ;;")
    return BASH.format(made=MADE, commands=" ".join(command["name"] for command in commands), options="\n".join(options),
                       values="\n".join(values))


def zsh(commands):
    text = f"#compdef vvr\n# zsh completion for vvr, {MADE}\n"
    for command in commands:
        text += f"\n_vvr_{command['name']}() {{\n    _arguments -s -S \\\n"
        for option in command["options"]:
            text += "".join(f"        {zsh_option(option, name)} \\\n" for name in names_of(option))
        text += "        '*:file:_files'\n}\n"
    text += "\n_vvr() {\n    local -a commands=(\n"
    text += "".join(f"        {quoted(command['name'] + ':' + command['help'].replace(':', chr(92) + ':'))}\n"
                    for command in commands)
    text += """    )
    if ((CURRENT == 2)); then
        _describe -t commands command commands
    elif ((${+functions[_vvr_${words[2]}]})); then
        local command=${words[2]}
        shift words
        ((CURRENT--))
        _vvr_$command
    fi
}

_vvr "$@"
"""
    return text


def zsh_option(option, name):
    explained = text_of(option)
    for special in "\\[]:":
        explained = explained.replace(special, "\\" + special)
    # As `--filter edges` and `--filter=edges`.
    text = "*" + name + ("=" if option["value"] and name.startswith("--") else "") + f"[{explained}]"
    if option["value"]:
        known, kind = choices_of(option), takes(option)
        text += f":{option['value'].replace(':', chr(92) + ':')}:"
        if kind == "list":
            text += f"_sequence compadd - {known}"
        elif known and kind == "file":
            text += f'_alternative "values:value:({known})" "files:file:_files"'
        elif known:
            text += f"({known})"
        else:
            text += {"file": "_files", "folder": "_files -/", "value": " "}[kind]
    return quoted(text)


def fish(commands):
    text = f"# fish completion for vvr, {MADE}\ncomplete -c vvr -f\n"
    for command in commands:
        text += f"complete -c vvr -n __fish_use_subcommand -a {command['name']} -d {fish_quoted(command['help'])}\n"
    for command in commands:
        when = f"complete -c vvr -n '__fish_seen_subcommand_from {command['name']}'"
        if command["arguments"]:
            text += f"{when} -F\n"
        for option in command["options"]:
            text += f"{when} -l {option['name']}" + (f" -s {option['short']}" if option["short"] else "")
            text += f"{fish_values(option)} -d {fish_quoted(text_of(option))}\n"
    return text


def fish_values(option):
    known, kind = choices_of(option), takes(option)
    if not option["value"]:
        return ""
    if kind == "list":
        return f" -x -a '(__fish_append , {known})'"
    if kind == "file":
        return " -r -F" + (f" -a '{known}'" if known else "")
    if kind == "folder":
        return " -x -a '(__fish_complete_directories)'"
    if known:
        # Words with their explanations, of which fish expands nothing.
        words = " ".join(f"{fish_quoted(choice['name'])}\\t{fish_quoted(choice['help'])}" for choice in option["choices"])
        return f" -x -a {fish_quoted(words)}"
    return " -x"


def fish_quoted(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def quoted(text):
    return "'" + text.replace("'", "'\\''") + "'"
