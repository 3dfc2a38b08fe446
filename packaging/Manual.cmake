# Writes ${OUTPUT}, the manual of ${PROGRAM}, from its --help, by help2man.
execute_process(COMMAND ${PROGRAM} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCH "^[^\n]*" description "${help}")
get_filename_component(folder ${OUTPUT} DIRECTORY)
file(MAKE_DIRECTORY ${folder})
execute_process(
  COMMAND ${HELP2MAN} --no-info --no-discard-stderr "--name=${description}" --output=${OUTPUT} ${PROGRAM}
  COMMAND_ERROR_IS_FATAL ANY)
