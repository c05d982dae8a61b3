# cmake -DARCHIVE= -DLINKER= -DNM= -DOBJCOPY= -DAR= -P keep_own_copies.cmake: joins the objects of a static library into
# one and makes local what each object has a copy of: inline functions and variables, instances of templates.
cmake_minimum_required(VERSION 3.25)
set(joined ${ARCHIVE}.o)
set(weak ${ARCHIVE}.weak)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${LINKER} -r --force-group-allocation --whole-archive ${ARCHIVE} -o ${joined})
execute_process(COMMAND ${NM} --defined-only --format=posix ${joined} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n ]+ [WV] " symbols "${symbols}")
list(TRANSFORM symbols REPLACE " [WV] $" "")
list(JOIN symbols "\n" symbols)
file(WRITE ${weak} "${symbols}\n")
run(${OBJCOPY} --localize-symbols=${weak} ${joined})
file(REMOVE ${ARCHIVE})
run(${AR} qcs ${ARCHIVE} ${joined})
file(REMOVE ${joined} ${weak})
