#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "model/model.h"

namespace dimline {

/// The built-in models, in the order in which menus show them.
struct BuiltInModel {
  std::string_view name;          ///< "house"
  ModelDefinition (*define)();
};
std::span<const BuiltInModel> builtInModels();

/// The built-in model of that name, annotations read; an error that lists the names there are.
Result<Model> findBuiltInModel(std::string_view name);

// One file each.
ModelDefinition defineHouse();
ModelDefinition defineSingleTree();
ModelDefinition defineHelixHouse();
ModelDefinition defineLever();
ModelDefinition defineOmniTree();
ModelDefinition defineBoat();
ModelDefinition defineParthenon();
ModelDefinition defineCandler();
ModelDefinition defineFacade();
ModelDefinition defineLinearTower();
ModelDefinition defineTaperedTower();
ModelDefinition defineSteppedTower();

}  // namespace dimline
