// All of core's definitions. What is compiled behind it instantiates core by itself, as from the headers
// alone, and comes before the library where the two are linked: so a defect in the headers is in the program.
#pragma once

#include <graze/exact/queries.hpp>
#include <graze/queries/distance.hpp>
#include <graze/queries/line.hpp>
#include <graze/queries/overlap.hpp>
#include <graze/queries/penetration.hpp>
#include <graze/queries/swept_overlap.hpp>
#include <graze/rotating/cast.hpp>
#include <graze/standard/cast.hpp>
#include <graze/support/hull_data.hpp>
#include <graze/support/hull_graph.hpp>
#include <graze/support/validate.hpp>
