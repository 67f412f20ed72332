/** Fetches what is otherwise fetched when a scene is first built. The temple, which both apps begin with, is there already. */
export async function preloadSceneCode(): Promise<void> {
  await Promise.all([
    import('./benchmark/benchmarkLights'),
    import('./benchmark/benchmarkLightsObjects'),
    import('./dragon/dragons'),
    import('./dragon/niceScene'),
    import('./sponza/sponza'),
  ]);
}
