import { Layers, type Object3D } from 'three';

const allLayers = new Layers();
allLayers.enableAll();

/**
 * An object that stands in for a caster in three's traversal: three brings the caster's buffers up to date by it, though
 * the camera may not see the caster. `isFarolStand` tells it apart, so that it is not drawn.
 */
export function casterStand(object: Object3D): Object3D {
  const stand = Object.create(object) as Object3D;
  const own = (name: string, value: unknown) =>
    Object.defineProperty(stand, name, { value, writable: true, configurable: true });
  own('children', []);
  own('layers', allLayers);
  own('visible', true);
  own('frustumCulled', false);
  // three watches for the disposal of instanced meshes: on the caster itself
  own('addEventListener', object.addEventListener.bind(object));
  own('hasEventListener', object.hasEventListener.bind(object));
  own('isFarolStand', true);
  return stand;
}
