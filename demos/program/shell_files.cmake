# cmake -DPROGRAM=impulse -DOUT=folder -P shell_files.cmake
# The manual page and the completions, as the program itself writes them.
function(written file)  # then the arguments of the program
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${OUT}/${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
file(MAKE_DIRECTORY ${OUT})
written(impulse.bash completion bash)
written(_impulse completion zsh)
written(impulse.fish completion fish)
written(impulse.1 man)
execute_process(COMMAND gzip --best --no-name --force ${OUT}/impulse.1 COMMAND_ERROR_IS_FATAL ANY)
