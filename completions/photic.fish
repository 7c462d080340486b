# fish completion of photic. The program itself lists what may come next: words, or "*.toml" for files of that name.
function __photic_candidates
    set -l words (commandline -opc) (commandline -ct)
    for line in ($words[1] complete -- $words[2..-1] 2>/dev/null)
        if string match -q '\**' -- $line
            __fish_complete_suffix (commandline -ct) (string sub -s 2 -- $line)
        else
            echo $line
        end
    end
end
complete -c photic -f -a '(__photic_candidates)'
