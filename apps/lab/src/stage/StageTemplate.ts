import { Light as LightComponent, ObjectRenderer, RandomMovement, type Scene } from '@farol/engine';
import { type Camera, Light, type Object3D, PointLight } from 'three';
import type { LightPath } from './LightPaths';

/** Parts of a scene of the engine, from which the scenes of all competitors are copied. */
export interface StageTemplate {
  readonly scene: Scene;
  /** Visible meshes, lines, points and sprites. */
  readonly drawn: readonly Object3D[];
  readonly camera: Camera;
  /** Lights that the Lab moves: the light at time 0, and its path. */
  readonly moving: readonly { readonly light: PointLight; readonly path: LightPath }[];
  /** Lights that do not move. */
  readonly others: readonly Light[];
}

/**
 * Splits a scene into parts. Removes the balls that mark the lights, which are not measured.
 *
 * @param scene - must not be disposed while the template is used
 * @param size - size of the picture (pixels)
 * @param moves - whether the Lab moves the lights that have the engine's RandomMovement
 * @throws Error when the scene has no camera
 */
export function takeApart(
  scene: Scene,
  size: { readonly width: number; readonly height: number },
  moves: boolean,
): StageTemplate {
  for (const renderer of [...scene.componentsOf(ObjectRenderer)]) {
    if (renderer.mesh === 'bulb' && renderer.instanced) renderer.mesh = null;
  }
  const { activeCamera } = scene;
  if (!activeCamera) throw new Error(`The scene ‘${scene.name}’ has no camera: add one, then measure it again.`);
  activeCamera.setViewport(size.width, size.height);
  scene.setTime(0);
  scene.three.updateMatrixWorld(true);
  const paths = moves ? pathsOf(scene) : new Map<Light, LightPath>();
  const drawn: Object3D[] = [];
  const moving: { light: PointLight; path: LightPath }[] = [];
  const others: Light[] = [];
  scene.three.traverseVisible((object) => {
    if (object instanceof Light) {
      const path = paths.get(object);
      if (path && object instanceof PointLight) moving.push({ light: object, path });
      else others.push(object);
    } else if (isDrawn(object)) drawn.push(object);
  });
  return { scene, drawn, camera: activeCamera.three, moving, others };
}

function pathsOf(scene: Scene): Map<Light, LightPath> {
  const paths = new Map<Light, LightPath>();
  for (const { gameObject, extent, speed, seed } of scene.componentsOf(RandomMovement)) {
    const light = gameObject.getComponent(LightComponent);
    if (light?.type !== 'point') continue;
    const { x, y, z } = light.position;
    paths.set(light.three, { place: [x, y, z], extent: [...extent], speed, seed });
  }
  return paths;
}

const isDrawn = (object: Object3D): boolean =>
  ['isMesh', 'isLine', 'isPoints', 'isSprite'].some((kind) => (object as unknown as Record<string, unknown>)[kind]);
