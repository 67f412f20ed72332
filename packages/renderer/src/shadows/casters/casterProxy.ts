import { Layers, Object3D } from 'three';
import { standInOf } from '../../three/standInOf';

const allLayers = new Layers();
allLayers.enableAll();

/**
 * Makes a proxy of a caster for three's traversal, so that three updates the caster's buffers even where the camera does not see
 * it. `isFarolProxy` marks proxies, which are not drawn.
 */
export function casterProxy(object: Object3D): Object3D {
  const proxy = standInOf(object, Object3D.prototype);
  const own = (name: string, value: unknown) =>
    Object.defineProperty(proxy, name, { value, writable: true, configurable: true });
  own('children', []);
  own('layers', allLayers);
  own('visible', true);
  own('frustumCulled', false);
  // three listens for `dispose` of instanced meshes, which the caster itself dispatches
  own('addEventListener', object.addEventListener.bind(object));
  own('hasEventListener', object.hasEventListener.bind(object));
  own('isFarolProxy', true);
  return proxy;
}
