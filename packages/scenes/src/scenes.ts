import './meshPack';
import { benchmarkLightsScene } from './benchmark/benchmarkLightsScene';
import { benchmarkLightsObjectsScene } from './benchmark/benchmarkLightsObjectsScene';
import { dragonsScene } from './dragon/dragonsScene';
import { niceSceneScene } from './dragon/niceSceneScene';
import type { SceneDefinition } from './SceneDefinition';
import { sponzaScene } from './sponza/sponzaScene';
import { templeScene } from './temple/templeScene';

/** The scenes that the apps offer, by name. */
export const scenes: Readonly<Record<string, SceneDefinition>> = Object.fromEntries(
  [templeScene, sponzaScene, niceSceneScene, dragonsScene, benchmarkLightsScene, benchmarkLightsObjectsScene].map(
    (scene) => [scene.name, scene],
  ),
);

/** Fetches the late code of scene builders in advance. */
export async function preloadSceneCode(): Promise<void> {
  await Promise.all([
    import('./benchmark/benchmarkLights'),
    import('./benchmark/benchmarkLightsObjects'),
    import('./dragon/dragons'),
    import('./dragon/niceScene'),
    import('./sponza/sponza'),
    import('./temple/temple'),
  ]);
}
