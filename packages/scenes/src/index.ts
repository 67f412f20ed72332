/** Demo scenes, and `defineScene` for further ones, with its types. */
export { preloadSceneCode, scenes } from './scenes';

export { benchmarkLights, type BenchmarkOptions } from './benchmark/benchmarkLights';
export { benchmarkLightsObjects } from './benchmark/benchmarkLightsObjects';
export { dragons, type DragonsOptions } from './dragon/dragons';
export { niceScene, type NiceSceneOptions } from './dragon/niceScene';
export { sponza, type SponzaOptions } from './sponza/sponza';
export { temple } from './temple/temple';

export { registerSceneAssets } from './registerSceneAssets';
export { defineScene, type SceneBuildOptions, type SceneDefinition, type SceneParameters } from './SceneDefinition';
