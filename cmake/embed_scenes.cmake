# SPDX-License-Identifier: MIT
# Writes a C++ source with a function SceneFactory ID() for each equation file ID.toml of FOLDER. Where C++ adds to the
# scene, in FOLDER/*/ID.cpp, the function is ID_file(), and ID() is defined there.
file(GLOB files ${FOLDER}/*.toml)
set(text "#include \"fdebench/benchmarks/equation_files/equation_scene.hpp\"\n\nnamespace fde::bench {\n")
foreach(file ${files})
  get_filename_component(id ${file} NAME_WE)
  file(READ ${file} toml)
  file(GLOB source ${FOLDER}/*/${id}.cpp)
  set(function ${id})
  if(source)
    set(function ${id}_file)
  endif()
  string(APPEND text "\nSceneFactory ${function}();\nSceneFactory ${function}() {\n"
    "  return built_in_scene(\"${id}\", R\"toml(${toml})toml\");\n}\n")
endforeach()
string(APPEND text "\n}  // namespace fde::bench\n")
file(WRITE ${OUTPUT} "${text}")
