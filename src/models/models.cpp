#include "models/models.h"

#include <array>

namespace dimline {

namespace {

constexpr std::array kModels = {
    BuiltInModel{"house", defineHouse},
    BuiltInModel{"single-tree", defineSingleTree},
    BuiltInModel{"helix-house", defineHelixHouse},
    BuiltInModel{"lever", defineLever},
    BuiltInModel{"omni-tree", defineOmniTree},
    BuiltInModel{"boat", defineBoat},
    BuiltInModel{"parthenon", defineParthenon},
    BuiltInModel{"candler", defineCandler},
    BuiltInModel{"facade", defineFacade},
    BuiltInModel{"floor-area-linear", defineLinearTower},
    BuiltInModel{"floor-area-tapered", defineTaperedTower},
    BuiltInModel{"floor-area-stepped", defineSteppedTower},
};

}  // namespace

std::span<const BuiltInModel> builtInModels() { return kModels; }

Result<Model> findBuiltInModel(std::string_view name) {
  std::string known;
  for (const BuiltInModel& m : kModels) {
    if (m.name == name) return makeModel(m.define());
    known += known.empty() ? "" : ", ";
    known += m.name;
  }
  return Error{"There is no built-in model \"" + std::string(name) + "\"; there is " + known + "."};
}

}  // namespace dimline
