# CPack runs this between installing and packing, once for all components.

# What Debian wants of every package: the notices, and what has changed.
function(add_debian_files component package)
  set(root ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr)
  set(doc ${root}/share/doc/${package})
  file(MAKE_DIRECTORY ${doc})
  file(COPY_FILE ${IMPULSE_NOTICES} ${doc}/copyright)
  file(COPY_FILE ${IMPULSE_CHANGES} ${doc}/changelog)
  execute_process(COMMAND gzip --best --no-name ${doc}/changelog COMMAND_ERROR_IS_FATAL ANY)
  # Every component installs these two files; two Debian packages may not. The engine's has them.
  if(NOT component STREQUAL engine)
    file(GLOB_RECURSE shared ${root}/impulseConfig.cmake ${root}/impulseConfigVersion.cmake)
    file(REMOVE ${shared})
  endif()
endfunction()

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} name)
  add_debian_files(${component} ${CPACK_DEBIAN_${name}_PACKAGE_NAME})
endforeach()
