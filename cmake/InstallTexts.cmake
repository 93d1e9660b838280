# Run by cmake --install: the texts of --help as man pages and as a page for browsers, and completion for shells.
# cmake/Install.cmake sets `program`, `version`, `contact` and `doc_folder`.
set(root "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}")

# Writes what `steradian WORDS` prints to a file below the prefix.
function(install_text file)
  message(STATUS "Installing: ${root}/${file}")
  get_filename_component(folder "${root}/${file}" DIRECTORY)
  file(MAKE_DIRECTORY "${folder}")
  execute_process(COMMAND "${program}" ${ARGN} OUTPUT_FILE "${root}/${file}" COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(zsh_folder share/zsh/site-functions)
if(CMAKE_INSTALL_PREFIX MATCHES "/usr$" AND EXISTS /etc/debian_version)
  set(zsh_folder share/zsh/vendor-completions) # Debian's packages; its site-functions are the administrator's
endif()
install_text(${doc_folder}/manual.html manual html)
install_text(share/bash-completion/completions/steradian completion bash)
install_text(${zsh_folder}/_steradian completion zsh)
install_text(share/fish/vendor_completions.d/steradian.fish completion fish)

message(STATUS "Installing: ${root}/share/man/man1")
execute_process(COMMAND "${program}" manual man "${root}/share/man/man1" COMMAND_ERROR_IS_FATAL ANY)
find_program(gzip_program gzip)
file(GLOB pages "${root}/share/man/man1/steradian*.1")
if(gzip_program)
  execute_process(COMMAND "${gzip_program}" -9nf ${pages} COMMAND_ERROR_IS_FATAL ANY)
endif()

# A package of Debian's has a changelog in Debian's form.
if(CMAKE_INSTALL_PREFIX MATCHES "/usr$" AND gzip_program)
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
  set(changelog "${root}/${doc_folder}/changelog")
  file(WRITE "${changelog}" "steradian (${version}) unstable; urgency=low\n\n  * CHANGELOG.md lists the changes.\n\n"
                            " -- ${contact}  ${date}\n")
  execute_process(COMMAND "${gzip_program}" -9nf "${changelog}" COMMAND_ERROR_IS_FATAL ANY)
endif()
