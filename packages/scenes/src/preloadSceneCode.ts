/** Fetches what is otherwise fetched when a scene is first built. */
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
