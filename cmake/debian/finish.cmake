# Run by cpack between installing and packing: what Debian wants in other places or forms than `cmake --install` has it.
set(usr ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr)

file(MAKE_DIRECTORY ${usr}/share/zsh/vendor-completions)
file(RENAME ${usr}/share/zsh/site-functions/_photic ${usr}/share/zsh/vendor-completions/_photic)
file(REMOVE_RECURSE ${usr}/share/zsh/site-functions)

# -n: no time in the file, so that the same source gives the same package.
execute_process(COMMAND gzip -9n ${usr}/share/man/man1/photic.1 COMMAND_ERROR_IS_FATAL ANY)

file(COPY ${CMAKE_CURRENT_LIST_DIR}/copyright DESTINATION ${usr}/share/doc/photic)
