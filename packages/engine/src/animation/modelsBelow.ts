import type { Object3D } from 'three';
import type { Model } from '../assets/Model';
import type { Component } from '../core/Component';
import type { GameObject } from '../core/GameObject';

/** A component that draws a model whole, or parts of it, as ModelRenderer does. */
export interface ModelInScene extends Component {
  /** Root of the drawn tree; null until the model is loaded. */
  readonly three: Object3D | null;
  readonly drawnModel: Model | null;
  /** Node of the model that the object corresponds to when only parts are drawn; null when all of the model is. */
  readonly partsRoot: Object3D | null;
  /** Copy of a model's node in `three`; null for a node that is not drawn. */
  copyOf(node: Object3D): Object3D | null;
}

const drawsModel = (component: Component): component is ModelInScene => 'drawnModel' in component;

/** First component on an object, or below it, that draws a model or its parts; `model` null accepts any model. */
export function modelBelow(root: GameObject, model: Model | null): ModelInScene | null {
  for (const component of root.components) {
    if (!drawsModel(component) || !component.drawnModel) continue;
    if (model === null || component.drawnModel === model) return component;
  }
  for (const child of root.children) {
    const found = modelBelow(child, model);
    if (found) return found;
  }
  return null;
}

/**
 * Renderers of a model on an object or below it: the first component that draws it whole, else all that draw parts of
 * it, else the first that draws another model.
 */
export function modelsBelow(root: GameObject, model: Model): ModelInScene[] {
  const parts: ModelInScene[] = [];
  let whole: ModelInScene | null = null;
  root.traverse(({ components }) => {
    for (const each of components) {
      if (!drawsModel(each) || each.drawnModel !== model) continue;
      if (each.partsRoot) parts.push(each);
      else whole ??= each;
    }
  });
  if (whole) return [whole];
  if (parts.length > 0) return parts;
  const other = modelBelow(root, null);
  return other ? [other] : [];
}
