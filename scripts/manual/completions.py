"""Completions of commands, options and values, for bash, zsh and fish."""

MADE = "made by scripts/manual out of the program's own help"


def write_completions(folder, commands):
    for name, text in (("bash/vvr", bash(commands)), ("zsh/_vvr", zsh(commands)), ("fish/vvr.fish", fish(commands))):
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")


def names_of(option):
    return ([f"-{option.letter}"] if option.letter else []) + [f"--{option.name}"]


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
        names = " ".join(name for option in command.options() for name in names_of(option))
        options.append(f"    {command.name}) options='{names}' ;;")
        for option in command.options():
            if not option.unit:
                continue
            takes = ("list" if option.takes_list else "file" if option.takes_file else "folder" if option.takes_folder
                     else "value")
            known = " ".join(name for name, _ in option.values)
            patterns = "|".join(f"{command.name}:{name}" for name in names_of(option))
            values.append(f"    {patterns}) takes={takes}" + (f" values='{known}'" if known else "") + " ;;")
    return BASH.format(made=MADE, commands=" ".join(command.name for command in commands), options="\n".join(options),
                       values="\n".join(values))


def zsh(commands):
    text = f"#compdef vvr\n# zsh completion for vvr, {MADE}\n"
    for command in commands:
        text += f"\n_vvr_{command.name}() {{\n    _arguments -s -S \\\n"
        for option in command.options():
            text += "".join(f"        {zsh_option(option, name)} \\\n" for name in names_of(option))
        text += "        '*:file:_files'\n}\n"
    text += "\n_vvr() {\n    local -a commands=(\n"
    text += "".join(f"        {quoted(command.name + ':' + command.help.replace(':', chr(92) + ':'))}\n"
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
    explained = option.help
    for special in "\\[]:":
        explained = explained.replace(special, "\\" + special)
    # As `--filter edges` and `--filter=edges`.
    text = "*" + name + ("=" if option.unit and name.startswith("--") else "") + f"[{explained}]"
    if option.unit:
        known = " ".join(value for value, _ in option.values)
        unit = option.unit.replace(":", "\\:")
        text += f":{unit}:"
        if option.takes_list:
            text += f"_sequence compadd - {known}"
        elif known and option.takes_file:
            text += f'_alternative "values:value:({known})" "files:file:_files"'
        elif known:
            text += f"({known})"
        elif option.takes_file:
            text += "_files"
        elif option.takes_folder:
            text += "_files -/"
        else:
            text += " "
    return quoted(text)


def fish(commands):
    text = f"# fish completion for vvr, {MADE}\ncomplete -c vvr -f\n"
    for command in commands:
        text += f"complete -c vvr -n __fish_use_subcommand -a {command.name} -d {fish_quoted(command.help)}\n"
    for command in commands:
        when = f"complete -c vvr -n '__fish_seen_subcommand_from {command.name}'"
        if command.argument:
            text += f"{when} -F\n"
        for option in command.options():
            text += f"{when} " + f"-l {option.name}"
            text += f" -s {option.letter}" if option.letter else ""
            known = " ".join(value for value, _ in option.values)
            if option.takes_list:
                text += f" -x -a '(__fish_append , {known})'"
            elif known and not option.takes_file:
                rows = "\n".join(f"{value}\t{explained}" for value, explained in option.values)
                text += f" -x -a {fish_quoted(fish_words(rows))}"
            elif option.takes_file:
                text += " -r -F" + (f" -a '{known}'" if known else "")
            elif option.takes_folder:
                text += " -x -a '(__fish_complete_directories)'"
            elif option.unit:
                text += " -x"
            text += f" -d {fish_quoted(option.help)}\n"
    return text


def fish_words(rows):
    """Lines of words and what they mean, of which nothing is expanded."""
    return " ".join(fish_quoted(line.split("\t")[0]) + ("\\t" + fish_quoted(line.split("\t")[1]) if line.split("\t")[1]
                                                         else "") for line in rows.split("\n"))


def fish_quoted(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def quoted(text):
    return "'" + text.replace("'", "'\\''") + "'"
