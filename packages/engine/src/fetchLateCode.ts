/**
 * Fetches what is otherwise fetched when it is first needed: what reads files of assets and writes containers, and the
 * scenes but the temple.
 */
export async function fetchLateCode(): Promise<void> {
  await Promise.all([
    import('three/addons/libs/fflate.module.js'),
    import('./assets/readAsset'),
    import('./scenes/benchmark/benchmarkLights'),
    import('./scenes/benchmark/benchmarkLightsObjects'),
    import('./scenes/dragon/dragons'),
    import('./scenes/dragon/niceScene'),
    import('./scenes/sponza/sponza'),
  ]);
}
