import { Camera } from './Camera';
import { ComponentRegistry } from './ComponentRegistry';
import { Decal } from './Decal';
import { KeyController } from './KeyController';
import { Light } from './Light';
import { ModelRenderer } from './ModelRenderer';
import { MouseController } from './MouseController';
import { ObjectRenderer } from './ObjectRenderer';
import { RandomMovement } from './RandomMovement';
import { Transform } from './Transform';

/** The types of components that every scene knows. For others make `new ComponentRegistry(builtinComponents.types.values())`. */
export const builtinComponents = new ComponentRegistry([
  Transform,
  ObjectRenderer,
  ModelRenderer,
  Light,
  Camera,
  Decal,
  KeyController,
  MouseController,
  RandomMovement,
]);

/** The built-in types by name. */
export const componentTypes = builtinComponents.types;

/** A new built-in component on no object. @throws Error for an unknown type, FieldError for a wrong value */
export const createComponent = builtinComponents.create.bind(builtinComponents);
