import type { Object3D } from 'three';
import type { Model } from '../assets/Model';
import type { Component, GameObject } from '../core/SceneGraph';

/** A component that draws a whole model, as ModelRenderer does. */
export interface ModelInScene extends Component {
  /** The tree that is drawn; null before the model is loaded. */
  readonly three: Object3D | null;
  /** The model that is drawn. */
  readonly drawnModel: Model | null;
  /** The node of `three` that stands for one of the model. */
  copyOf(node: Object3D): Object3D | null;
}

const drawsModel = (component: Component): component is ModelInScene => 'drawnModel' in component;

/** The first component on an object, or below it, that draws a model whole; any model when none is given. */
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
