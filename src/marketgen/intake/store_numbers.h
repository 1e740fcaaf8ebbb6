// Numbers of fixtures that are said of the store as a whole: "ten gondolas", "14 double-sided
// runs".
#pragma once
#include "intake/store_program.h"

namespace marketgen::intake {

// Shares runs and modules of kinds_of_many_zones among the zones that have such, by their floors;
// a zone for which none is left gets what keeps the same goods. Floors must be shared out before.
void share_numbers_of_store(StoreProgram& program,
                            const Understanding& found,
                            const catalog::Catalog& catalog);

}  // namespace marketgen::intake
