# Doxygen reads our plain comments: one before a declaration describes it, one behind a member describes that, and the
# first of a file describes the file.
s/namespace graze::inline GRAZE_LINKAGE/namespace graze/
s#^( *)//( |$)#\1///\2#
s#([^ ].*) // #\1 ///< #
1s#^///#/// @file\n///#
