import { benchmarkLightsScene } from './benchmark/benchmarkLights';
import { benchmarkLightsObjectsScene } from './benchmark/benchmarkLightsObjects';
import { dragonsScene } from './dragon/dragons';
import { niceSceneScene } from './dragon/niceScene';
import type { SceneDefinition } from './SceneDefinition';
import { sponzaScene } from './sponza/sponza';
import { templeScene } from './temple/temple';

/** The scenes that the apps offer, by name. */
export const scenes: Readonly<Record<string, SceneDefinition>> = Object.fromEntries(
  [templeScene, sponzaScene, niceSceneScene, dragonsScene, benchmarkLightsScene, benchmarkLightsObjectsScene].map(
    (scene) => [scene.name, scene],
  ),
);
