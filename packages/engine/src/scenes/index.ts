/** The scenes that the apps offer, and what another one is made with. */
import { benchmarkLightsScene } from './benchmark/benchmarkLightsScene';
import { benchmarkLightsObjectsScene } from './benchmark/benchmarkLightsObjectsScene';
import { dragonsScene } from './dragon/dragonsScene';
import { niceSceneScene } from './dragon/niceSceneScene';
import type { SceneDefinition } from './SceneDefinition';
import { sponzaScene } from './sponza/sponzaScene';
import { templeScene } from './temple/temple';

/** The scenes that the apps offer, by name. */
export const scenes: Readonly<Record<string, SceneDefinition>> = Object.fromEntries(
  [templeScene, sponzaScene, niceSceneScene, dragonsScene, benchmarkLightsScene, benchmarkLightsObjectsScene].map(
    (scene) => [scene.name, scene],
  ),
);

export { benchmarkLights } from './benchmark/benchmarkLights';
export { benchmarkLightsObjects } from './benchmark/benchmarkLightsObjects';
export { dragons, type DragonsOptions } from './dragon/dragons';
export { niceScene, type NiceSceneOptions } from './dragon/niceScene';
export { sponza, type SponzaOptions } from './sponza/sponza';
export { temple } from './temple/temple';

export { preloadSceneCode } from './preloadSceneCode';
export { registerSceneAssets } from './registerSceneAssets';
export { defineScene, type SceneBuildOptions, type SceneDefinition, type SceneParameters } from './SceneDefinition';
