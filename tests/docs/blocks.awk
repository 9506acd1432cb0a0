# Writes the lines between two marks into files, a file a block: awk -v begin=REGEX -v end=REGEX -v to=PREFIX -f blocks.awk.
# Comment marks before them are removed.
{ sub(/^ *\/\/\/ ?/, "") }
$0 ~ begin { file = sprintf("%s%03d", to, ++blocks); next }
$0 ~ end { file = "" }
file { print > file }
