import { t } from '@farol/editing';
import { type AssetLibrary, Camera, GameObject, Light, Scene, sunShadows } from '@farol/engine';

/**
 * The scene of a new document: a camera, a sun and a sky, with tone mapping so that surfaces near lamps do not clip.
 */
export function makeEmptyScene(assets: AssetLibrary): Scene {
  const scene = new Scene({ name: t('Untitled'), assets });
  scene.settings.toneMapping = 'neutral';
  scene.settings.shadowCascades = 3;
  // brighter than the wanted [0.02, 0.025, 0.036], since tone mapping darkens dark colours
  scene.settings.backgroundColour = [0.057, 0.062, 0.072];
  const camera = new GameObject(t('Camera'));
  camera.addComponent(Camera);
  camera.transform.lookAt([4, 3, 6], [0, 0.5, 0]);
  const sun = new GameObject(t('Sun'));
  sun.addComponent(Light, { type: 'directional', intensity: 2, ...sunShadows(100) });
  sun.transform.lookAt([6, 8, 4], [0, 0, 0]);
  const sky = new GameObject(t('Sky'));
  sky.addComponent(Light, { type: 'hemisphere', intensity: 0.4 });
  sky.transform.position = [0, 4, 0];
  for (const object of [camera, sun, sky]) scene.add(object);
  return scene;
}
