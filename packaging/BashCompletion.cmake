# Writes ${OUTPUT}, by which bash completes the options of ${PROGRAM}, their words, and files.
execute_process(COMMAND ${PROGRAM} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n +(-[A-Za-z],)?--[^ \n]+[^\n]*" lines "${help}")
set(options)
set(words)
foreach(line IN LISTS lines)
  # Names come first; those in the description are other options'.
  string(REGEX MATCH "^\n +[^ ]+" head "${line}")
  string(REGEX MATCHALL "--[A-Za-z][A-Za-z0-9]*" names "${head}")
  list(APPEND options ${names})
  if(line MATCHES "^\n +[^ ]+ [A-Z]*:?{([a-z0-9]+,[a-z0-9,]+)}")
    string(REPLACE "," " " choices "${CMAKE_MATCH_1}")
    string(REPLACE ";" "|" pattern "${names}")
    string(APPEND words "    ${pattern}) COMPREPLY=($(compgen -W '${choices}' -- \"$word\")); return ;;\n")
  endif()
endforeach()
list(REMOVE_DUPLICATES options)
list(JOIN options " " options)
string(REGEX REPLACE "[^A-Za-z0-9]" "_" function "_${NAME}")
file(WRITE ${OUTPUT} "# Completion of ${NAME} for bash.
${function}()
{
  local word=\${COMP_WORDS[COMP_CWORD]}
  case \${COMP_WORDS[COMP_CWORD - 1]} in
${words}    *) ;;
  esac
  case $word in
    -*) COMPREPLY=($(compgen -W '${options}' -- \"$word\")) ;;
    *) COMPREPLY=($(compgen -f -- \"$word\")) ;;
  esac
}
complete -o filenames -F ${function} ${NAME}
")
