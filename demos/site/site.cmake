# The pages of `impulse site`: their parts, and the texts that they show with their pictures.
embed_page(site site "" "" pages,search,start)
file(GLOB document_files CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
  ../README.md ../engine/README.md ../render/README.md *.md */*.md scenes/pictures/*.png)
list(TRANSFORM document_files PREPEND ${PROJECT_SOURCE_DIR}/ OUTPUT_VARIABLE document_paths)
string(REPLACE ";" "," document_list "${document_files}")
add_custom_command(
  OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/documents.cpp
  COMMAND ${CMAKE_COMMAND} -DOUT=${CMAKE_CURRENT_BINARY_DIR}/documents.cpp
          -DROOT=${PROJECT_SOURCE_DIR} -DFILES=${document_list}
          -P ${CMAKE_CURRENT_SOURCE_DIR}/site/embed_documents.cmake
  DEPENDS ${document_paths} site/embed_documents.cmake html/text_pieces.cmake
  VERBATIM)
impulse_made(site ${CMAKE_CURRENT_BINARY_DIR}/documents.cpp)
