// Global searches from NLopt, where knotfit is built with it (KNOTFIT_WITH_NLOPT).
#pragma once
#include "place/context.h"
namespace knotfit {

Placement place_evolutionary(PlacementContext& context, int interior_u, int interior_v);
Placement place_evolutionary_crs(PlacementContext& context, int interior_u, int interior_v);
Placement place_evolutionary_isres(PlacementContext& context, int interior_u, int interior_v);

}  // namespace knotfit
