// All of core's definitions. Code compiled behind this header instantiates core by itself, as from the headers alone.
// It comes before the library where the two are linked, so a defect in the headers is in the program.
#pragma once

#include <graze/detail/casts/ladder.hpp>
#include <graze/detail/queries/distance_query.hpp>
#include <graze/detail/queries/exact_queries.hpp>
#include <graze/detail/queries/line_query.hpp>
#include <graze/detail/queries/overlap_query.hpp>
#include <graze/detail/queries/penetration_query.hpp>
#include <graze/detail/queries/swept_overlap_query.hpp>
#include <graze/detail/rotating/rotating_search.hpp>
#include <graze/detail/shapes/hull_data.hpp>
#include <graze/detail/shapes/hull_graph.hpp>
#include <graze/detail/shapes/validation.hpp>
